"""What part of random and hard cases is solved: `python -m benchmarks.robustness [NAME ...] [--csv FILE]`.

Runs other benchmarks with fixed counts and seeds, takes from their output how many cases were solved and
what the others ended with, and fills the tables of `docs/howto/hard-cases.md`. With names only these are run
and the other rows of the file stay; `--page` computes nothing.
"""

import argparse
import csv
import re
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import asdict, astuple, dataclass, fields
from pathlib import Path

from benchmarks.machine import describe
from benchmarks.page import DOCS, fill

CSV, PAGE = DOCS / "images" / "hard_cases.csv", DOCS / "howto" / "hard-cases.md"
SEED = "6c76c6d"  # first digits of the commit before the page was made
DECIMAL_SEED = str(int(SEED, 16))
REFUSED = 2  # exit code of bad input

Found = tuple[int, int, list[str]]  # solved, of how many, what the others ended with


@dataclass(frozen=True)
class Row:
    """One line of the page."""

    name: str
    asked: str  # what counts as solved
    command: str
    solved: int
    of: int
    unsolved: str  # how the others ended, one after the other
    seconds: float


@dataclass(frozen=True)
class Job:
    """A benchmark with its counts, and how its output is read."""

    asked: str
    module: str
    arguments: tuple[str, ...]
    reads: Callable[[str], Found]

    @property
    def command(self) -> str:
        """As typed."""
        return " ".join(("python -m", f"benchmarks.{self.module}", *self.arguments))


def of_designs(text: str) -> Found:
    """`random_designs`: outcomes by name in its last line but one, other ends one a line."""
    total, outcomes = _one(r"^(\d+) [\w-]+ designs from \d+, seed \d+: (.*)$", text)
    converged = re.search(r"converged (\d+)", outcomes)
    return int(converged[1]) if converged else 0, int(total), _lines(r"^(design \d+: [^;]+);", text)


def of_coupled(text: str) -> Found:
    """`random_coupled`: designs that are not converged, and those with a fault."""
    solved, total = _one(r"^converged: (\d+) of (\d+)", text)
    ends = re.findall(r"^(design \d+): newton .*? s; (.*)$", text, re.MULTILINE)
    return (
        int(solved),
        int(total),
        [f"{name}: {end}" for name, end in ends if not end.startswith("converged")],
    )


def newton_of_coupled(text: str) -> Found:
    """The same, by Newton's method without a second one."""
    solved, total = _one(r"^newton alone: (\d+) of (\d+)", text)
    return int(solved), int(total), _lines(r"^(design \d+: newton (?!converged)[^,]*), iqn", text)


def of_as_expected(text: str) -> Found:
    """`hard_cases`."""
    solved, total = _one(r"^(\d+) of (\d+) as expected", text)
    return int(solved), int(total), _lines(r"^MISS (.*)$", text)


def of_thick_films(text: str) -> Found:
    """`several_equilibria`: designs that are solved."""
    total, solved = _one(r"^(\d+) designs, seed \d+: (\d+) solved", text)
    return int(solved), int(total), _lines(r"^(design \d+: (?!\d).*)$", text)


def of_told(text: str) -> Found:
    """The same: of those with several equilibria, how many a run tells."""
    solved, total = _one(r"^reported: (\d+) of (\d+)", text)
    return int(solved), int(total), _lines(r"^(design \d+: [1-9]\d* by random starts, 0 reported)", text)


def of_changed(command: str) -> Callable[[str], Found]:
    """`fuzz_cases`: inputs without a fault, of one command."""

    def reads(text: str) -> Found:
        total, faults = _one(rf"^{command}: (\d+) inputs,.*with a fault: (\d+)", text)
        told = [_in_short(line) for line in _lines(rf"^FAULT (\d+ \({command}\): .*)$", text)]
        return int(total) - int(faults), int(total), told

    return reads


def _in_short(fault: str) -> str:
    """Number of a case with the warning that it printed, or the beginning of its fault."""
    number, _, words = fault.partition(": ")
    warning = re.search(r"Warning: [^\\]+", words)
    return f"{number}: {warning[0] if warning else words[:120]}"


def of_rolling(text: str) -> Found:
    """`random_rolling --robustness`: ends by number of contacts."""
    (total,) = _one(r"^(\d+) cases from seed", text)
    solved = sum(map(int, re.findall(r"^ +\d contacts: .*'solved': (\d+)", text, re.MULTILINE)))
    return solved, int(total), _lines(r"^ +(seed \d+, .*)$", text)


def of_told_errors(text: str) -> Found:
    """`random_rolling --errors`: balls whose estimated error is above the true one."""
    solved, total = _one(r"^the estimated error holds for (\d+) of (\d+)", text)
    return int(solved), int(total), _lines(r"^ +(seed \d+: .*, not held)$", text)


def of_studies(text: str) -> Found:
    """`study_equality`: rows of both studies that equal their single runs, as numbers or as ends."""
    solved = total = 0
    unlike = []
    for name, same, _, ends in re.findall(
        r"^(.*?): (\d+) of (\d+) rows equal.*ends of row and run: (.*)$", text, re.MULTILINE
    ):
        pairs = re.findall(r"([\w ]+) / ([\w ]+) (\d+)", ends)
        total += sum(int(count) for *_, count in pairs)
        alike = sum(int(count) for row, run, count in pairs if row.strip() == run != "converged")
        solved += int(same) + alike
        unlike += [f"{name}: {ends}"] * (int(same) + alike != sum(int(count) for *_, count in pairs))
    if not total:
        raise SystemExit("study_equality printed no rows")
    return solved, total, unlike


def of_refused(text: str) -> Found:
    """`refusing`: hostile inputs that end as bad input."""
    ends = re.findall(r"^ *-?[\d.]+ +(-?\d+) +\d+ +\d+  (.*?): ", text, re.MULTILINE)
    return (
        sum(int(code) == REFUSED for code, _ in ends), len(ends),
        [f"{name}: exit {code}" for code, name in ends if int(code) != REFUSED],
    )  # fmt: skip


def newton_of_methods(text: str) -> Found:
    """`coupling_hard`, Newton's method."""
    solved, total = _one(r"^newton: (\d+) of (\d+) converge", text)
    return int(solved), int(total), [name for name, runs in _methods(text) if _failed(runs[:1])]


def others_of_methods(text: str) -> Found:
    """`coupling_hard`, the fixed-point methods together; how many fail by case."""
    solved, total = _one(r"^others: (\d+) of (\d+) converge", text)
    unsolved = [(name, runs[1:]) for name, runs in _methods(text) if _failed(runs[1:])]
    ends = [f"{name}: {_failed(runs)} of {len(runs)} methods" for name, runs in unsolved]
    return int(solved), int(total), ends


def _methods(text: str) -> list[tuple[str, list[str]]]:
    """Names of the cases, with a text for each method."""
    table = [line.split(" | ") for line in text.partition("\nnewton: ")[0].splitlines()[2:]]
    return [(cells[0].rsplit(None, 1)[0], cells[1:]) for cells in table if len(cells) > 1]


def _failed(runs: list[str]) -> int:
    """How many begin with a status in place of a number of iterations."""
    return sum(not run.strip()[:1].isdigit() for run in runs)


def of_kills(text: str) -> Found:
    """`killed_runs`: rounds after which everything is as promised."""
    (total,) = _one(r"^(\d+) kills", text)
    faults = re.search(r"\bFAULT: (\d+)", text)
    return int(total) - (int(faults[1]) if faults else 0), int(total), _lines(r"^(round \d+, .*)$", text)


CONVERGED = "converged, balances summed again from the stored forces"
COUPLED = "random_coupled", ("--n", "100", "--solids", "2", "--seed", SEED, "--workers", "1")
THICK = "several_equilibria", ("--n", "60", "--seed", DECIMAL_SEED, "--jobs", "1")
CHANGED = "fuzz_cases", ("--n", "3000", "--runs", "100", "--seed", SEED)
JOBS = {
    "hard cases of the bearing": Job("ends as expected", "hard_cases", (), of_as_expected),
    "usual designs": Job(
        CONVERGED, "random_designs",
        ("--envelope", "usual", "--n", "300", "--seed", DECIMAL_SEED), of_designs,
    ),
    "slow designs": Job(
        CONVERGED, "random_designs",
        ("--envelope", "slow", "--n", "60", "--seed", DECIMAL_SEED), of_designs,
    ),
    "designs far beyond what is built": Job(
        CONVERGED, "random_designs", ("--n", "100", "--seed", DECIMAL_SEED), of_designs
    ),
    "thick films": Job("converged", *THICK, of_thick_films),
    "thick films, other equilibria": Job("reported, where an exhaustive search finds some", *THICK, of_told),
    "hard cases of the coupling, newton": Job(
        "converged", "coupling_hard", (), newton_of_methods
    ),
    "the same, other methods": Job("converged without fallback", "coupling_hard", (), others_of_methods),
    "random flexible rings": Job("converged", *COUPLED, of_coupled),
    "the same, newton alone": Job("converged without fallback", *COUPLED, newton_of_coupled),
    "balls that stick and slip": Job(
        "solved, balance and friction law checked", "random_rolling",
        ("--robustness", "200", "--cells", "20", "40", "--first", "1000"), of_rolling,
    ),
    "their estimated error": Job(
        "at least the true one", "random_rolling",
        ("--errors", "10", "--cells", "12", "24", "--first", "1000"), of_told_errors,
    ),
    "studies against single runs": Job(
        "same numbers, or the same end", "study_equality",
        ("--n", "20", "--several", "3", "--seed", "31"), of_studies,
    ),
    "changed cases, check": Job("no fault", *CHANGED, of_changed("check")),
    "changed cases, run": Job("no fault", *CHANGED, of_changed("run")),
    "damaged or malicious cases": Job("refused by name", "refusing", (), of_refused),
    "killed runs": Job(
        "result complete, the same run again succeeds", "killed_runs",
        ("--of", "run", "--n", "20", "--second", "4", "--seed", SEED), of_kills,
    ),
}  # fmt: skip


def _one(pattern: str, text: str) -> tuple[str, ...]:
    match = re.search(pattern, text, re.MULTILINE)
    if not match:
        raise SystemExit(f"nothing fits {pattern!r} in\n{text[-2000:]}")
    return match.groups()


def _lines(pattern: str, text: str) -> list[str]:
    return re.findall(pattern, text, re.MULTILINE)


def computed(wanted: list[str]) -> Iterator[Row]:
    """Run each command once, also where several lines are read from its output."""
    kept: dict[str, tuple[str, float]] = {}
    for name in wanted:
        job = JOBS[name]
        if job.command not in kept:
            began = time.perf_counter()
            command = (sys.executable, "-m", f"benchmarks.{job.module}", *job.arguments)
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if not done.stdout.strip():
                raise SystemExit(f"{job.command}: {done.stderr[-2000:]}")
            kept[job.command] = done.stdout, time.perf_counter() - began
        text, seconds = kept[job.command]
        solved, total, ends = job.reads(text)
        yield Row(name, job.asked, job.command, solved, total, " | ".join(ends), round(seconds))


def stored(path: Path) -> dict[str, Row]:
    """Rows of an earlier run by name."""
    if not path.exists():
        return {}
    with path.open(newline="", encoding="utf-8") as file:
        return {
            row["name"]: Row(
                row["name"], row["asked"], row["command"], int(row["solved"]), int(row["of"]),
                row["unsolved"], float(row["seconds"]),
            )
            for row in csv.DictReader(file)
        }  # fmt: skip


def store(rows: dict[str, Row], path: Path) -> None:
    """Write the rows in the order of the jobs."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(field.name for field in fields(Row))
        writer.writerows(astuple(rows[name]) for name in JOBS if name in rows)


def tables(rows: dict[str, Row]) -> dict[str, str]:
    """As Markdown: what was solved, and how the others ended."""
    solved = ["| cases | counted as solved | solved | command |", "|---|---|---|---|"]
    others = ["| cases | what ended otherwise |", "|---|---|"]
    for row in rows.values():
        solved.append(
            f"| {row.name} | {row.asked} | {row.solved} of {row.of} ({100 * row.solved / row.of:.1f} %) "
            f"| `{row.command}` |"
        )
        if row.unsolved:
            others.append(f"| {row.name} | {row.unsolved.replace(' | ', '; ')} |")
    return {"solved": "\n".join(solved), "unsolved": "\n".join(others)}


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(JOBS)}")
    parser.add_argument("--csv", type=Path, default=CSV)
    parser.add_argument("--page", action="store_true", help="from the stored table")
    asked = parser.parse_args()
    if unknown := set(asked.names) - set(JOBS):
        parser.error(f"no such name: {', '.join(sorted(unknown))}")
    print(describe())
    rows = stored(asked.csv)
    for row in () if asked.page else computed(asked.names or list(JOBS)):
        rows[row.name] = row
        store(rows, asked.csv)
        print(*(f"{key}: {value}" for key, value in asdict(row).items()), sep="; ", flush=True)
    if asked.csv == CSV:
        fill(PAGE, tables(stored(CSV)))


if __name__ == "__main__":
    main()
