"""Processor time of refusing hostile case files and settings, over that of checking a good case.

Every input is checked by a process of its own, the good case before it; the least of several runs counts.
"""

import resource
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from benchmarks.machine import describe
from tests.flexbearing.hostile_cases import CONFIGS, FILES, SETTINGS

CASE = str(CONFIGS / "mao2016.toml")
COMMAND = (sys.executable, "-m", "flexbearing", "check")
ROUNDS, LONGEST = 3, 10.0  # [s]
LARGEST = 100_000  # characters of an argument that the system takes
SIZE, SHOWN = 10**10, 80  # bytes of the largest file; characters of a message


def seconds(case: str, settings: Sequence[str]) -> tuple[float, int, str]:
    """Processor time of checking [s], the exit code and what was said."""
    arguments = [word for setting in settings for word in ("--set", setting)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        ended = subprocess.run(
            [*COMMAND, case, *arguments],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            timeout=LONGEST,
            check=False,
        )
        code, said = ended.returncode, ended.stderr.decode(errors="replace")
    except subprocess.TimeoutExpired:
        code, said = -1, f"not refused within {LONGEST:g} s"
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, code, said


def inputs(folder: Path) -> dict[str, tuple[str, Sequence[str]]]:
    """Case and settings of every hostile input that a command line can hold."""
    large = folder / "large.toml"
    with large.open("wb") as file:
        file.truncate(SIZE)
    hostile: dict[str, tuple[str, Sequence[str]]] = {
        "/dev/zero": ("/dev/zero", ()),
        "a folder": (str(folder), ()),
        "a file of 10 GB": (str(large), ()),
        "a drawing of 10 GB": (str(CONFIGS / "step_ring.toml"), (f"outer.file={large}",)),
    }
    for number, (name, content) in enumerate(FILES.items()):
        file = folder / f"{number}.toml"
        file.write_bytes(content)
        hostile[f"file: {name}"] = str(file), ()
    for name, settings in SETTINGS.items():
        if max(map(len, settings)) <= LARGEST and "\0" not in "".join(settings):
            hostile[f"setting: {name}"] = CASE, settings
    return hostile


def main() -> None:
    print(describe())
    print("processor time beyond the good case [s], exit code, lines and characters that are said:")
    wanted = sys.argv[1] if len(sys.argv) > 1 else ""  # part of a name
    with TemporaryDirectory() as folder:
        beyond = {
            name: _told(name, case, settings)
            for name, (case, settings) in inputs(Path(folder)).items()
            if wanted in name
        }
    longest = max(beyond, key=beyond.__getitem__)
    print(f"{len(beyond)} inputs; longest {beyond[longest]:.3f} s beyond the good case: {longest}")


def _told(name: str, case: str, settings: Sequence[str]) -> float:
    rounds = [(seconds(CASE, ()), seconds(case, settings)) for _ in range(ROUNDS)]
    good, refused = (min(run[0] for run in runs) for runs in zip(*rounds, strict=True))
    _, code, said = rounds[0][1]
    size = f"{len(said.splitlines()):3d} {len(said):5d}"
    print(f"{refused - good:6.3f} {code:3d} {size}  {name}: {said[:SHOWN]!a}", flush=True)
    return refused - good


if __name__ == "__main__":
    main()
