"""The shipped optimisation files, their answers and times: `python -m benchmarks.optima [NAME ...]`."""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from benchmarks.machine import describe
from flexbearing.optimise.answer import Optimum
from flexbearing.optimise.run import optimise
from flexbearing.optimise.told import page

STUDIES = Path(__file__).parents[1] / "configs" / "studies"
NAMES = ("optimum_profile", "optimum_planet")


def main() -> None:
    print(describe())
    for name in sys.argv[1:] or NAMES:
        with TemporaryDirectory() as folder:
            optimum = optimise(STUDIES / f"{name}.toml", folder)
        print(f"\n{page(optimum, Path('results'))}")
        print(f"{name}: {seconds(optimum)}", flush=True)


def seconds(optimum: Optimum) -> str:
    """Time of the search and of all starts together."""
    search, verification = optimum.seconds
    return f"{len(optimum.starts)} starts, search {search:.1f} s, verification {verification:.1f} s"


if __name__ == "__main__":
    main()
