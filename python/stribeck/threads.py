"""The number of threads of a call."""

from __future__ import annotations

import operator

from stribeck._stribeck import Refused

# More than that help nobody.
MOST = 10_000


def checked(threads: int | None) -> int | None:
    """The number that was asked for; none stands for all processors."""
    if threads is None:
        return None
    number = operator.index(threads)
    if not 1 <= number <= MOST:
        raise Refused(f"threads = {number}: must be >= 1 and <= {MOST}")
    return number
