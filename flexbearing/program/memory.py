"""Memory that is freed and requested again, as arrays of one batch after the other are.

The C library of Linux gives freed memory back to the system at once when there is more than some hundred
kilobytes of it; taking it again costs a fault for every page, a fifth of the time of a batch of bearings.
"""

import ctypes
import sys
from functools import cache

KEPT, AS_ONE = 2**26, 2**24  # bytes that stay when they are freed, and of an array that is given back alone
_TRIM_THRESHOLD, _MMAP_THRESHOLD = -1, -3  # of malloc.h


@cache
def keep_freed() -> bool:
    """Let this process keep some freed memory from now on."""
    if not sys.platform.startswith("linux"):
        return False
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
    if mallopt is None:  # another C library
        return False
    return all([mallopt(_TRIM_THRESHOLD, KEPT), mallopt(_MMAP_THRESHOLD, AS_ONE)])
