"""The page for a browser."""

import shutil
import sys

from release.making import PROJECT, MissingTool, Release, run


def written(release: Release) -> None:
    """Builds the page, where Node is at hand."""
    if shutil.which("npm") is None:
        raise MissingTool("Node 20 or newer from https://nodejs.org")
    run(sys.executable, "-c", "import tasks; tasks.setup_page(); tasks.write_page()")
    release.add("page.html", PROJECT / "dist" / "page.html", "the page: laws, systems and fits in a browser, offline")
