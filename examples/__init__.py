"""Programs around the library; each runs as a module, from the folder above: `python -m examples.fmpy.four_post`."""
