"""Everything that a user takes away: `python3 tasks.py release` writes it to dist/release/ and tests it."""
