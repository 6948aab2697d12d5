"""Calls of worker processes that load nothing."""

import os
import time


def own_process(place):
    """The process, which stands in a file, too."""
    (place / str(os.getpid())).touch()
    return os.getpid()


def second(folder):
    """The process; after another one has begun a call, too."""
    number, gone_by = own_process(folder), time.monotonic() + 120
    while len(list(folder.iterdir())) < 2:
        assert time.monotonic() < gone_by
        time.sleep(0.02)
    return number
