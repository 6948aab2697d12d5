"""Commands that are killed at random moments: `python -m benchmarks.killed_runs --n 60 --seed S --of map`.

Every command replaces what it made of another speed. After the kill each output must be the earlier or the
new one, complete, or a table that says which rows are not computed; the journal must hold every line that it
had. A second start must end with what an undisturbed one makes, numbers equal to 1e-12, all else to the last
byte, and leave no other file and no process. Two of three are killed (SIGKILL), the others ended by SIGTERM
or SIGINT, which leave time to remove what is unfinished. `--second`: in some rounds another start to the same
output begins while the first is at work.

Modules are loaded once and every start is a fork: moments are spread over what the command does.
"""

import argparse
import csv
import os
import random
import re
import signal
import sys
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from io import StringIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import xarray

from benchmarks.fuzzing import preload
from benchmarks.machine import describe
from flexbearing import read
from flexbearing.__main__ import main as program
from flexbearing.cache.store import VARIABLE
from flexbearing.report.html.table import NOT_COMPUTED, table_text
from flexbearing.studies.table.journal import SUFFIX as JOURNAL

CONFIGS = Path(__file__).parents[1] / "configs"
SPEEDS = {"earlier": "2500 rpm", "new": "3000 rpm"}
SIGNALS = (signal.SIGKILL, signal.SIGKILL, signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGINT)
SAME = 1e-12  # largest relative difference of numbers
TORN = (".tmp", ".lock")  # endings of what SIGTERM and SIGINT leave time to remove; a .part is a whole file
PATIENCE = 10.0  # [s] until worker processes of a killed one are gone
SEEN = "kills", "ended before", "lost", "left over", "differing"  # what is counted, beside faults
MARK = "KILLED_ROUND"  # variable of all processes of a round


@dataclass(frozen=True)
class Killed:
    """A command, and what it reads."""

    words: tuple[str, ...]
    files: Mapping[str, str] = field(default_factory=dict)
    case: str = "nu209"
    before: tuple[str, ...] = ()  # a command that makes a file for it


CLEARANCES = (
    '[over]\n"operation.radial_load" = "1 kN .. 9 kN, 20"\n"bearing.clearance" = "10 um .. 50 um, 20"\n'
)
STUDY = f'case = "case.toml"\n{CLEARANCES}[collect]\nlife = "life_L10 [h]"\nslip = "cage_slip [%]"\n'
BEST = """case = "case.toml"
[vary]
"bearing.clearance" = "0 um .. 60 um"
"bearing.roller.drop" = "log 1 um .. 20 um"
[minimise]
output = "peak_pressure.inner [MPa]"
over = "worst"
[over]
"operation.misalignment" = ["0 arcmin", "3 arcmin"]
[search]
starts = 2
"""
COMMANDS = {
    "run": Killed(
        ("run", "case.toml", "-o", "out/out.h5", "--quiet", "--set", "accuracy.structure=beam", "--set",
         "inner.kind=rigid", "--set", "outer.kind=ring", "--set", "coupling.method=relaxed"), case="mao2016",
    ),
    "study, one job": Killed(("study", "study.toml", "-o", "out", "--jobs", "1"), {"study.toml": STUDY}),
    "study, two jobs": Killed(("study", "study.toml", "-o", "out", "--jobs", "2"), {"study.toml": STUDY}),
    "optimise": Killed(("optimise", "best.toml", "-o", "out", "--jobs", "1"), {"best.toml": BEST}),
    "map": Killed(
        ("map", "case.toml", "--over", "operation.radial_load=1 kN..9 kN,4", "--over",
         "bearing.clearance=10 um..50 um,3", "-o", "out/map.csv")
    ),
    "report": Killed(
        ("report", "run.h5", "-o", "out/report.html"), before=("run", "case.toml", "-o", "run.h5", "--quiet")
    ),
}  # fmt: skip
Rows = list[list[Any]]


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--n", type=int, default=60, help="kills of each command")
    parser.add_argument("--second", type=int, default=0, help="of these, with a second start meanwhile")
    parser.add_argument("--seed", default="0", help="any text")
    parser.add_argument("--of", nargs="+", choices=COMMANDS, default=[*COMMANDS], help="commands")
    asked = parser.parse_args()
    print(f"{describe()}\n{asked.n} kills of each, {asked.second} with a second start, seed {asked.seed}")
    preload()
    faults = 0
    with TemporaryDirectory() as folder:
        os.environ[VARIABLE] = str(Path(folder) / "cache")
        for name in asked.of:
            rounds = Rounds(COMMANDS[name], Path(folder) / name.replace(", ", "_").replace(" ", "_"))
            counts, largest = rounds.killed(asked.n, asked.second, random.Random(f"{asked.seed} {name}"))
            words = ", ".join(f"{what} {count}" for what, count in counts.items())
            print(f"{name}: {words}; largest difference {largest:.1e}", flush=True)
            faults += counts["FAULT"]
    sys.exit(bool(faults))


class Rounds:
    """A command that is killed again and again."""

    def __init__(self, command: Killed, folder: Path):
        self.command, self.folder = command, folder
        self.seconds = 0.0  # of an undisturbed one
        self.known = {state: self._undisturbed(state) for state in SPEEDS}
        self.outputs = {path.name for path in (folder / "new" / "out").iterdir()}

    def killed(self, kills: int, second: int, draw: random.Random) -> tuple[Counter[str], float]:
        """Counts of what was seen, and the largest difference of a number of the second start."""
        counts = Counter[str](dict.fromkeys((*SEEN, "FAULT"), 0))
        with_second, largest = set(draw.sample(range(kills), second)), 0.0
        for number in range(kills):
            moment, kind = draw.uniform(0.0, 1.05) * self.seconds, draw.choice(SIGNALS)
            begin = draw.uniform(0.0, 0.7) * moment if number in with_second else None
            seen, words, difference = self._round(place := f"round{number}", moment, kind, begin)
            counts.update(what for what in SEEN if seen[what])
            largest = max(largest, difference)
            if words:
                counts["FAULT"] += 1
                print(f"  {place}: {signal.Signals(kind).name} after {moment:.3f} s: {words}", flush=True)
        return counts, largest

    def _round(
        self, name: str, moment: float, kind: int, begin: float | None
    ) -> tuple[dict[str, Any], str, float]:
        """What was seen of a kill and of the start after it, faults in words, the largest difference."""
        place = self._prepared(name, "new")
        out = place / "out"
        for path in (self.folder / "earlier" / "out").iterdir():
            (out / path.name).write_bytes(path.read_bytes())
        ended = self._killed(place, moment, kind, begin)
        left = [path.name for path in out.iterdir() if kind != signal.SIGKILL and path.suffix in TORN]
        left += _processes_left(place)
        lost, lines = [name for name in self.known["new"] if not self._is_whole(out / name)], _lines(out)
        seconds, code = _waited(_started(place, self.command.words), time.perf_counter())
        self.seconds = (
            self.seconds if lines else max(self.seconds / 2, seconds)
        )  # others use the machine, too
        lost += [f"lines of {name}" for name, text in lines.items() if not _lines(out)[name].startswith(text)]
        left += [*({path.name for path in out.iterdir()} ^ self.outputs), *_processes_left(place)]
        far = {name: self._distance(out / name, "new") for name in self.known["new"]}
        differing = [f"{name} by {each:.1e}" for name, each in far.items() if not each <= SAME]
        differing += [f"exit code {code}"] if code else []
        faults = {"lost": lost, "left over": left, "differing": differing}
        words = "; ".join(f"{what}: {', '.join(names)}" for what, names in faults.items() if names)
        before = ended >= 0 and ended != 128 + kind
        return {"kills": True, "ended before": before, **faults}, words, max(far.values())

    def _killed(self, place: Path, moment: float, kind: int, begin: float | None) -> int:
        """Exit code of a start that is ended after some seconds; a second one may begin before."""
        first, later, began = _started(place, self.command.words), None, time.perf_counter()
        if begin is not None:
            time.sleep(begin)
            later = _started(place, self.command.words)
        time.sleep(max(0.0, began + moment - time.perf_counter()))
        with suppress(ProcessLookupError):
            os.kill(first, kind)
        _, code = _waited(first, began)
        if later is not None:
            _waited(later, began)
        return code

    def _undisturbed(self, state: str) -> dict[str, Rows]:
        place = self._prepared(state, state)
        self.seconds, code = _waited(_started(place, self.command.words), time.perf_counter())
        assert code == 0, (place / "printed").read_text()
        return {
            path.name: rows(path) for path in (place / "out").iterdir() if not path.name.endswith(JOURNAL)
        }

    def _prepared(self, name: str, state: str) -> Path:
        """A folder with the inputs of a command."""
        place = self.folder / name
        (place / "out").mkdir(parents=True)
        case = (CONFIGS / f"{self.command.case}.toml").read_text()
        speed = f'inner_speed = "{SPEEDS[state]}"'
        (place / "case.toml").write_text(re.sub(r'^inner_speed = "[^"]*"', speed, case, flags=re.M))
        for file, text in self.command.files.items():
            (place / file).write_text(text)
        if self.command.before:
            made = self.folder / state / "run.h5"
            if made.exists():
                (place / made.name).write_bytes(made.read_bytes())
            else:
                _waited(_started(place, self.command.before), 0.0)
        return place

    def _is_whole(self, path: Path) -> bool:
        """Whether an output is as a whole command leaves it."""
        return any(self._distance(path, state) <= SAME for state in SPEEDS)

    def _distance(self, path: Path, state: str) -> float:
        try:
            return distance(rows(path), self.known[state][path.name])
        except (OSError, ValueError) as problem:
            print(f"  {path.name}: {problem}")
            return float("inf")


def rows(path: Path) -> Rows:
    """What a file holds, without times."""
    if path.suffix in (".csv", ".parquet"):
        head, *table = csv.reader(StringIO(table_text(path)))
        return [[cell for name, cell in zip(head, row, strict=True) if name != "seconds"] for row in table]
    if path.suffix == ".nc":
        with xarray.open_dataset(path, engine="h5netcdf") as opened:
            table = opened.drop_vars("seconds", errors="ignore").to_dataframe().reset_index()
        return table.to_numpy(dtype=object).tolist()
    if path.suffix == ".h5":
        result = read(path)
        blocks = (result.rigid, result.flexible, *result.iterations)
        return [[each for name in block if name != "seconds" for each in np.ravel(block[name]).tolist()]
                for block in blocks]  # fmt: skip
    return [[path.read_bytes()]]


def distance(one: Rows, other: Rows) -> float:
    """Largest relative difference of numbers, infinite where texts differ; rows to come are left out."""
    if [*map(len, one)] != [*map(len, other)]:
        return float("inf")
    pairs = (zip(a, b, strict=True) for a, b in zip(one, other, strict=True) if NOT_COMPUTED not in a)
    return max((_apart(a, b) for row in pairs for a, b in row), default=0.0)


def _apart(one: Any, other: Any) -> float:
    if one == other or NOT_COMPUTED in (one, other):
        return 0.0
    try:
        a, b = float(one), float(other)
    except ValueError:
        return float("inf")
    return 0.0 if np.isnan(a) and np.isnan(b) else abs(a - b) / max(abs(a), abs(b))


def _started(place: Path, words: tuple[str, ...]) -> int:
    """The program in a process of its own."""
    sys.stdout.flush()
    process = os.fork()
    if process:
        return process
    try:
        os.chdir(place)
        os.environ[MARK] = str(place)
        printed = os.open("printed", os.O_WRONLY | os.O_CREAT | os.O_APPEND)
        os.dup2(printed, 1)
        os.dup2(printed, 2)
        sys.argv = ["flexbearing", *words]
        program()
    except SystemExit as end:
        sys.stdout.flush()
        os._exit(int(end.code or 0))
    finally:
        os._exit(3)


def _waited(process: int, began: float) -> tuple[float, int]:
    """Seconds since it began, and the exit code of a process."""
    _, status = os.waitpid(process, 0)
    return time.perf_counter() - began, os.waitstatus_to_exitcode(status)


def _processes_left(place: Path) -> list[str]:
    """Processes of a round that still run when there was time to end."""
    last = time.perf_counter() + PATIENCE
    while left := [*_processes(place)]:
        if time.perf_counter() > last:
            return [f"process {each}" for each in left]
        time.sleep(0.02)
    return []


def _processes(place: Path) -> Iterator[str]:
    mark = f"{MARK}={place}\0".encode()
    for each in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):  # it has just ended
            if mark in (each / "environ").read_bytes():
                yield each.name


def _lines(out: Path) -> dict[str, bytes]:
    """Whole lines of journals."""
    texts = {path.name: path.read_bytes() for path in out.glob(f"*{JOURNAL}")}
    return {name: text[: text.rfind(b"\n") + 1] for name, text in texts.items()}


if __name__ == "__main__":
    main()
