"""The shipped optimisation files, their answers and times: `python -m benchmarks.optima [NAME ...]`."""

import os
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from benchmarks.machine import describe
from flexbearing.cache.store import VARIABLE
from flexbearing.optimise.answer import Optimum
from flexbearing.optimise.messages import page
from flexbearing.optimise.run import optimise

STUDIES = Path(__file__).parents[1] / "configs" / "studies"
NAMES = ("optimum_profile", "optimum_planet", "optimum_cage")


def main() -> None:
    print(describe())
    for name in sys.argv[1:] or NAMES:
        with TemporaryDirectory() as folder:
            os.environ[VARIABLE] = folder  # no ring is known
            before = processor_seconds()
            optimum = optimise(STUDIES / f"{name}.toml", folder)
        print(f"\n{page(optimum, Path('results'))}")
        print(f"{name}: {seconds(optimum)}, processor {processor_seconds() - before:.1f} s", flush=True)


def processor_seconds() -> float:
    """Of this process and those it has ended [s]."""
    return sum(os.times()[:4])


def seconds(optimum: Optimum) -> str:
    """Time of the search and of all starts together."""
    search, verification = optimum.seconds
    return f"{len(optimum.starts)} starts, search {search:.1f} s, verification {verification:.1f} s"


if __name__ == "__main__":
    main()
