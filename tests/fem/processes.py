"""What processes of `test_subprocess` do; they load nothing else, and so start fast."""

import logging
import os
import signal
import time
from dataclasses import dataclass

import numpy as np

from fem.parts.material import ImpossiblePart


@dataclass(frozen=True)
class Told:
    """An answer with what the process knows of itself."""

    process: int
    threads: str
    value: np.ndarray


def answering(value, report):
    print("a library talks")  # noqa: T201
    report("halfway", 0.5)
    return Told(os.getpid(), os.environ["OPENBLAS_NUM_THREADS"], 2 * value)


def logging_of_meshes(report):
    logging.getLogger("fem.mesh.expense").info("about %d unknowns", 12)


def aborting(report):
    os.write(2, b"double free or corruption (out)\n")
    os.abort()


def leaving(report):
    os._exit(7)


def killed(report):
    os.kill(os.getpid(), signal.SIGKILL)


def silent(report):
    report(str(os.getpid()), None)
    time.sleep(600)


def wrong(report):
    raise ImpossiblePart("bar_width = 1 is impossible")


def strange(report):
    raise KeyError("no such face")


def deaf(report):
    report(str(os.getpid()), None)
    time.sleep(0.2)
    return "done"


class Lost:
    """Travels well, and falls apart on arrival."""

    def __reduce__(self):
        return (_lost, ())

    def __call__(self, report):
        """Never called."""


def _lost():
    raise ImportError("nowhere to be found")
