"""Calls of worker processes that load little."""

import os
import time

from quasidynamic.errors import NotSolved


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


def process_of(number):
    time.sleep(0.01 * (number % 3))
    return number, os.getpid()


def unsolved(number):
    if number == 3:
        raise NotSolved("number 3", "stalled")
    return number


def dead(_):
    os._exit(1)


def dead_once(number, place):
    """The first worker that is given the number 3 dies."""
    if number == 3 and not place.exists():
        place.touch()
        os._exit(1)
    return number
