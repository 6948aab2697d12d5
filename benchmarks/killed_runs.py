"""Runs that are killed at random moments: `python -m benchmarks.killed_runs --n 200 --second 20 --seed S`.

Every run replaces an earlier result of another load. After each kill the output must hold the earlier or the
new result, complete and equal to the last digit; a run afterwards must end with the new one and leave nothing
else in the folder. In some rounds a second run to the same output begins while the first is at work.
"""

import argparse
import os
import random
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from benchmarks.machine import describe
from flexbearing import read
from flexbearing.cache.store import VARIABLE
from flexbearing.results import BadResult, Result

CASE = Path("configs/mao2016.toml").resolve()
SETTINGS = ("accuracy.structure=beam", "inner.kind=rigid", "outer.kind=ring", "coupling.method=relaxed")
LOADS = {"earlier": "12 kN", "new": "15 kN"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--n", type=int, default=200, help="kills")
    parser.add_argument(
        "--second", type=int, default=20, help="of these, with a second run to the same output"
    )
    parser.add_argument("--seed", default="0", help="any text")
    wanted = parser.parse_args()
    print(describe())
    print(f"{wanted.n} kills, {wanted.second} of them with a second run, seed {wanted.seed}")
    with TemporaryDirectory() as folder:
        os.environ[VARIABLE] = str(Path(folder) / "cache")
        counts = rounds(Path(folder), wanted.n, wanted.second, random.Random(wanted.seed))
    print(", ".join(f"{what}: {count}" for what, count in sorted(counts.items())))
    sys.exit(bool(counts["FAULT"]))


def rounds(folder: Path, kills: int, second: int, draw: random.Random) -> Counter[str]:
    """Kill runs and judge what is left; counts of what was seen."""
    known, seconds = references(folder)
    with_second = set(draw.sample(range(kills), second))
    counts: Counter[str] = Counter()
    for number in range(kills):
        out = folder / f"round{number}" / "out.h5"
        out.parent.mkdir()
        out.write_bytes((folder / "earlier.h5").read_bytes())
        moment = draw.uniform(0.0, 1.1) * seconds
        begin = draw.uniform(0.0, 0.7) * moment if number in with_second else None
        counts.update(killed(out, moment, begin))
        after = judged(out, known)
        counts[f"after the kill: {after}"] += 1
        counts["something beside it"] += len(list(out.parent.iterdir())) > 1
        began = time.perf_counter()
        again = started(out)
        problem = again.communicate()[1]
        seconds = time.perf_counter() - began  # others may use the machine, too
        at_end = judged(out, known)
        counts[f"run again: exit {again.returncode}, {at_end}"] += 1
        alone = [out] == list(out.parent.iterdir())
        if "neither" in (after, at_end) or again.returncode or at_end != "new" or not alone:
            counts["FAULT"] += 1
            print(f"round {number}, {moment:.3f} s: {after}, then {at_end}, alone {alone}: {problem}")
    return counts


def killed(out: Path, moment: float, begin: float | None) -> Iterator[str]:
    """Kill a run after some seconds; a second one to the same output may begin before."""
    first, later = started(out), None
    if begin is not None:
        time.sleep(begin)
        later, moment = started(out), moment - begin
    time.sleep(moment)
    first.send_signal(signal.SIGKILL)
    first.communicate()
    yield "killed" if first.returncode < 0 else "ended before"
    if later is not None:
        errors = later.communicate()[1]
        refused = later.returncode == 2 and f"process {first.pid} on" in errors
        yield f"second run: {'refused' if refused else f'exit {later.returncode}'}"
        if later.returncode and not refused:
            yield "FAULT"


def references(folder: Path) -> tuple[dict[str, Result], float]:
    """Both results, undisturbed, and the seconds of a whole run."""
    known = {}
    seconds = []
    for name in (*LOADS, "new"):  # the last with everything known that a run keeps
        began = time.perf_counter()
        run = started(folder / f"{name}.h5", name)
        errors = run.communicate()[1]
        assert run.returncode == 0, errors
        seconds.append(time.perf_counter() - began)
        known[name] = read(folder / f"{name}.h5")
    print(f"a whole run: {seconds[-1]:.2f} s, {len(known['new'].iterations)} iterations")
    return known, seconds[-1]


def started(out: Path, load: str = "new") -> subprocess.Popen:
    """A run in a process of its own."""
    settings = [f"--set={setting}" for setting in (*SETTINGS, f"operation.radial_load={LOADS[load]}")]
    command = [sys.executable, "-m", "flexbearing", "run", str(CASE), "-o", str(out), "--quiet", *settings]
    return subprocess.Popen(command, stderr=subprocess.PIPE, text=True)


def judged(out: Path, known: dict[str, Result]) -> str:
    """Which of the known results a file holds, to the last digit."""
    try:
        result = read(out)
    except BadResult:
        return "neither"
    return next((name for name, other in known.items() if same(result, other)), "neither")


def same(one: Result, other: Result) -> bool:
    """Whether every number but times is equal."""
    pairs = [
        (one.rigid, other.rigid),
        (one.flexible, other.flexible),
        *zip(one.iterations, other.iterations, strict=False),
    ]
    return len(one.iterations) == len(other.iterations) and all(
        np.array_equal(a[name], b[name], equal_nan=True) for a, b in pairs for name in a if name != "seconds"
    )


if __name__ == "__main__":
    main()
