"""Processor time of commands over that of importing numpy and pydantic: help, check, single runs.

Every round measures all commands one after the other in processes of their own; medians of the rounds.
"""

import os
import resource
import subprocess
import sys
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

from benchmarks.machine import describe
from flexbearing.cache.store import VARIABLE

CASE = "configs/mao2016.toml"
RIGID = ("--set", "outer.kind=rigid", "--set", "inner.kind=rigid")
COMMAND = ("-m", "flexbearing")
ROUNDS = 7


def seconds(cache: str, *arguments: str) -> float:
    """Processor time of a Python process with a folder of condensed rings, user and system [s]."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    environment[VARIABLE] = cache
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    quiet = subprocess.DEVNULL
    subprocess.run([sys.executable, *arguments], check=True, stdout=quiet, stderr=quiet, env=environment)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    print(describe())
    with TemporaryDirectory() as folder:
        out = "-o", str(Path(folder) / "out.h5")
        commands = {
            "import numpy, pydantic": (folder, "-c", "import numpy, pydantic"),
            "flexbearing --help": (folder, *COMMAND, "--help"),
            "flexbearing check": (folder, *COMMAND, "check", CASE),
            "flexbearing run, rigid rings": (folder, *COMMAND, "run", CASE, *RIGID, *out),
            "flexbearing run, known rings": (folder, *COMMAND, "run", CASE, *out),
            "flexbearing run, no ring known": ("off", *COMMAND, "run", CASE, *out),
        }
        for arguments in commands.values():
            seconds(*arguments)  # bytecode is written, and rings
        rounds = [{name: seconds(*arguments) for name, arguments in commands.items()} for _ in range(ROUNDS)]
    imports = "import numpy, pydantic"
    for name in commands:
        ratio = median(times[name] / times[imports] for times in rounds)
        print(f"{name:30s} {median(times[name] for times in rounds):6.3f} s, {ratio:5.2f} times the imports")


if __name__ == "__main__":
    main()
