"""Changed files and options through the command line: `python -m benchmarks.fuzz_files --n 4000 --seed HEX`.

Studies, duty cycles, variants, optimisations, maps, profiles, journals, REXS models, matrices, drawings,
tables, results, options of `new` and names of files, each changed at random in one to five places. A fault is
an exit code other than 0, 1 or 2, more than 10 s of processor time or 1 GB, a traceback or a warning of a
library, a message of more than 20 000 characters, an input that was changed, an unfinished file or a process
that is left. Faults of a kind are printed together, the first of them reduced to the changes that it needs;
`--only NUMBER --keep FOLDER` runs an input alone and writes its files.
"""

import argparse
import random
import shlex
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path

from benchmarks.changed.bases import Bases, made
from benchmarks.changed.drawings import drawing
from benchmarks.changed.files import ChangedFiles
from benchmarks.changed.journals import journal
from benchmarks.changed.matrices import matrix
from benchmarks.changed.models import model
from benchmarks.changed.options import options
from benchmarks.changed.paths import path
from benchmarks.changed.results import result
from benchmarks.changed.studies import mapped, optimisation, profile, study, tables_of_variants
from benchmarks.changed.tables import table_of_study
from benchmarks.fuzzing import LONG, Answer, Limits, Pool, by_shape, commit
from benchmarks.machine import describe

SHARES: dict[Callable[[random.Random, Bases], ChangedFiles], int] = {
    study: 16, tables_of_variants: 6, optimisation: 11, mapped: 9, profile: 3, journal: 11, model: 11,
    matrix: 9, drawing: 6, table_of_study: 6, result: 3, options: 11, path: 9,
}  # fmt: skip
LIMITS = Limits(large_seconds=120.0, patience=300.0, memory=10**9, most_memory=6 << 30)
SHOWN = 3  # inputs of a fault


def main() -> None:
    asked = _arguments()
    seed, began = asked.seed or commit(), time.perf_counter()
    print(f"{describe()}\ncommit {commit()}, seed {seed}, {asked.n} inputs", flush=True)
    with tempfile.TemporaryDirectory(prefix="fuzz_files_") as folder:
        (Path(folder) / "bases").mkdir()
        bases = made(Path(folder) / "bases")
        pool = Pool(Path(folder), LIMITS)
        numbers = asked.only or range(asked.n)
        answers = list(pool.answers((number, changed(seed, number, bases)) for number in numbers))
        tell(answers)
        for shape, faulty in by_shape(answers).items():
            print(f"\nFAULT, {len(faulty)} times, {shape}", flush=True)
            for number, answer in enumerate(faulty[:SHOWN]):
                _tell_fault(pool.reduced(answer) if asked.minimise and not number else answer, seed)
        for answer in answers if asked.keep else ():
            if answer.faults or asked.only:
                _keep(answer, asked.keep / str(answer.number))
    faults = sum(bool(answer.faults) for answer in answers)
    print(f"\n{faults} of {len(answers)} inputs with a fault, {time.perf_counter() - began:.0f} s in all")
    sys.exit(bool(faults))


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    parser.add_argument("--n", type=int, default=4000, help="inputs")
    parser.add_argument("--seed", default="", help="any text; by default the first 8 digits of the commit")
    parser.add_argument("--only", type=int, nargs="+", help="numbers of inputs; others are left out")
    parser.add_argument(
        "--keep", type=Path, help="folder for the files of faulty inputs, or of those of --only"
    )
    parser.add_argument("--no-minimise", dest="minimise", action="store_false")
    return parser.parse_args()


def changed(seed: str, number: int, bases: Bases) -> ChangedFiles:
    """An input, which depends on seed and number alone."""
    rng = random.Random(f"{seed} {number}")
    return rng.choices([*SHARES], weights=[*SHARES.values()])[0](rng, bases)


def tell(answers: list[Answer]) -> None:
    """Print how all inputs ended, by kind, and what took most."""
    for kind in sorted({answer.input.kind for answer in answers}):
        of_kind = [answer for answer in answers if answer.input.kind == kind]
        codes = Counter(answer.code for answer in of_kind)
        seconds = sorted(answer.seconds for answer in of_kind)
        print(
            f"{kind}: {len(of_kind)} inputs; "
            + ", ".join(f"exit {code}: {number}" for code, number in sorted(codes.items()))
            + f"; processor time: median {seconds[len(seconds) // 2]:.2f} s, largest {seconds[-1]:.2f} s; "
            f"largest memory {max(answer.memory for answer in of_kind) / 1e6:.0f} MB; "
            f"with a fault: {sum(bool(answer.faults) for answer in of_kind)}",
            flush=True,
        )
    large = [answer.code for answer in answers if answer.seconds > LIMITS.seconds and not answer.faults]
    print(
        f"jobs of more than {LIMITS.seconds:g} s that had announced their size: {len(large)}, "
        f"of them ended after {LIMITS.large_seconds:g} s: {large.count(LONG)}"
    )
    for answer in sorted(answers, key=lambda answer: -answer.seconds)[:5]:
        print(f"  slowest: {answer.seconds:.2f} s, exit {answer.code}: {_short(answer, 160)}")
    for answer in sorted(answers, key=lambda answer: -answer.memory)[:3]:
        print(
            f"  largest: {answer.memory / 1e6:.0f} MB, exit {answer.code}: {_short(answer, 160)}", flush=True
        )


def _short(answer: Answer, most: int) -> str:
    """Which input, on one line."""
    return f"{answer.number}, {answer.input.kind}, {answer.input.story!r:.{most}}"


def _tell_fault(answer: Answer, seed: str) -> None:
    assert isinstance(answer.input, ChangedFiles)
    words = shlex.join(word[:80] for word in answer.input.changed.words)
    print(
        f"  {_short(answer, 500)}\n    flexbearing {words!r:.300}\n    {'; '.join(answer.faults)!r:.500}\n"
        f"    again: python -m benchmarks.fuzz_files --seed {seed} --only {answer.number} --keep FOLDER",
        flush=True,
    )


def _keep(answer: Answer, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    words = answer.input.put(folder)
    told = [f"flexbearing {shlex.join(words)}", answer.input.story, *answer.faults, answer.text]
    (folder / "fault.txt").write_text("\n\n".join(told), errors="replace")


if __name__ == "__main__":
    main()
