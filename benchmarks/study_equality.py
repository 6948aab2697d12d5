"""Rows of studies against single runs: `python -m benchmarks.study_equality --n 1000 --several 100 --seed S`.

Random bearings between flexible rings (`benchmarks.random_coupled`), as studies whose variants stand in a
table; by one job, by two that are killed in the middle and started again, and each variant as a run of its
own. Every scalar that both have is compared. `--several`: as many bearings with cold oil between rigid rings
of which a single run tells several equilibria, picked from random ones, in studies that search for them.
"""

import argparse
import csv
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from flexbearing import run
from flexbearing.case import BadCase
from flexbearing.runs.several import CODE as SEVERAL
from tests.random_coupled import BASES, TEXTBOOK, Design, design

ROOT = Path(__file__).parents[1]
OUTPUTS = {
    "load": "max_roller_load [N]",
    "slip": "cage_slip [1]",
    "life": "life_L10 [Mrev]",
    "stiffness": "stiffness_zz [N/m]",
    "torque": "driving_torque [N m]",
    "rigid_load": "rigid.max_roller_load [N]",
}
SAME = 1e-9


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--n", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--several", type=int, default=100)
    asked = parser.parse_args()
    print(describe())
    designs = [design(asked.seed, number) for number in range(asked.n)]
    with tempfile.TemporaryDirectory() as name:
        for base in BASES:
            chosen = [one for one in designs if one.case == base.case]
            if chosen:
                compare(chosen, Path(name))
        if asked.several:
            compare(
                with_several(asked.seed, asked.several), Path(name), "several", "search_equilibria = true\n"
            )


def with_several(seed: int, wanted: int) -> list[Design]:
    """Textbook bearings with cold oil of which a run tells several equilibria."""
    found: list[Design] = []
    for number in range(20 * wanted):
        one = cold(seed, number)
        notes = run(ROOT / one.case, one.settings).attributes["notes"]
        if any(note["code"] == SEVERAL for note in notes):
            found.append(one)
        if len(found) == wanted:
            print(f"{wanted} of {number + 1} random bearings with cold oil have several equilibria")
            return found
    raise SystemExit(f"only {len(found)} of {20 * wanted} bearings have several equilibria")


def cold(seed: int, number: int) -> Design:
    """A bearing whose cage finds several speeds: half of these have several equilibria."""
    rng = np.random.default_rng([seed, number, 2])
    settings = (
        f"lubricant.viscosity={_log_uniform(rng, 1.2, 2.5):.6g} Pa s",
        f"lubricant.oil_fraction={_log_uniform(rng, 2e-3, 1e-2):.6g}",
        f"operation.radial_load={_log_uniform(rng, 80, 600):.6g} N",
        f"operation.inner_speed={_log_uniform(rng, 200, 1600):.6g} rpm",
        f"bearing.clearance={rng.uniform(0, 25):.6g} um",
        f"bearing.first_roller_azimuth={rng.uniform(0, 25.7):.6g} deg",
    )
    return Design(TEXTBOOK, settings)


def _log_uniform(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def compare(designs: list[Design], folder: Path, stem: str = "", head: str = "") -> None:
    stem = stem or Path(designs[0].case).stem
    file = written(designs, folder / f"{stem}_study.toml", head)
    tables = {}
    for name, jobs in (("one job", 1), ("two jobs, killed once", 2)):
        out, began = folder / f"{stem}_{jobs}", time.perf_counter()
        if jobs == 2:
            killed(file, out)
        command(file, out, jobs).wait()
        tables[name] = rows(out / f"{stem}_study.csv")
        print(f"{stem}: {len(designs)} variants, {name}: {time.perf_counter() - began:.0f} s")
    began, singles = time.perf_counter(), [single(one) for one in designs]
    print(f"{stem}: single runs: {time.perf_counter() - began:.0f} s")
    for name, table in tables.items():
        report(f"{stem}, {name}", table, singles)


def written(designs: list[Design], file: Path, head: str) -> Path:
    """A study of designs with the same case, and its table of variants."""
    settings = [dict(setting.split("=", 1) for setting in one.settings) for one in designs]
    keys = list(dict.fromkeys(key for each in settings for key in each))
    with file.with_suffix(".csv").open("w", newline="") as opened:
        table = csv.writer(opened)
        table.writerow(keys)
        table.writerows([each.get(key, "") for key in keys] for each in settings)
    collect = "\n".join(f'{name} = "{text}"' for name, text in OUTPUTS.items())
    file.write_text(
        f'case = "{ROOT / designs[0].case}"\n{head}[over]\nfile = "{file.stem}.csv"\n[collect]\n{collect}\n'
    )
    return file


def command(file: Path, out: Path, jobs: int) -> subprocess.Popen:
    return subprocess.Popen(
        [sys.executable, "-m", "flexbearing", "study", str(file), "--jobs", str(jobs), "-o", str(out)],
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip


def killed(file: Path, out: Path) -> None:
    """Start a study and kill it when a part of its rows is there."""
    process, journal = command(file, out, 2), out / f"{file.stem}.journal.jsonl"
    while process.poll() is None:
        if journal.exists() and len(journal.read_text().splitlines()) > 20:
            os.kill(process.pid, signal.SIGKILL)
        time.sleep(0.1)
    process.wait()


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="") as opened:
        return list(csv.DictReader(opened))


def single(one: Design) -> dict[str, float | str]:
    try:
        with threadpool_limits(limits=1, user_api="blas"):
            result = run(ROOT / one.case, one.settings)
    except BadCase as problem:
        return {"status": "bad input", "message": str(problem)}
    converged = result.attributes["status"] == "converged"
    numbers = {name: number(result, text) for name, text in OUTPUTS.items()} if converged else {}
    return {"status": str(result.attributes["status"]), **numbers}


def number(result, text: str) -> float:
    name, unit = text.rstrip("]").split(" [")
    try:
        return float(result[name].to(unit))
    except KeyError:
        return float("nan")


def report(name: str, table: list[dict[str, str]], singles: list[dict[str, float | str]]) -> None:
    apart, ends = [], Counter()
    for place, (row, alone) in enumerate(zip(table, singles, strict=True)):
        ends[row["status"], alone["status"]] += 1
        if row["status"] == alone["status"] == "converged":
            apart.append((max(_differences(row, alone)), place))
    worst = sorted(apart, reverse=True)[:5]
    print(
        f"{name}: {sum(one <= SAME for one, _ in apart)} of {len(apart)} rows equal to {SAME:g}; largest "
        f"differences {', '.join(f'{one:.1e} (variant {place + 1})' for one, place in worst)}; ends of row "
        f"and run: {', '.join(f'{pair[0]} / {pair[1]} {count}' for pair, count in ends.most_common())}"
    )


def _differences(row: dict[str, str], alone: dict[str, float | str]):
    for heading, text in row.items():
        if (name := heading.partition(" ")[0]) in OUTPUTS and name in alone:
            value, other = float(text or "nan"), float(alone[name])
            same = value == other or (np.isnan(value) and np.isnan(other))
            yield 0.0 if same else abs(value - other) / max(abs(value), abs(other))


if __name__ == "__main__":
    main()
