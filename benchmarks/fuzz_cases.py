"""Changed cases through the command line: `python -m benchmarks.fuzz_cases --n 12000 --runs 600 --seed HEX`.

Every input goes through `flexbearing check`. Some of those that pass are run, their results read back and
summarised. A fault is an exit code other than 0, 1 or 2, a traceback, a warning of a library, a
refusal without a word, one of endless words, one by `run` alone, a check or run that takes too long, a result
that is called converged and is not sound (tests/sound_results.py). Inputs with a fault are reduced to the
changes it needs.
"""

import argparse
import random
import shutil
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import redirect_stdout
from dataclasses import dataclass, replace
from io import StringIO
from pathlib import Path
from typing import Any

from benchmarks.fuzzing import WARNINGS, Answer, Input, Limits, Pool, commit, exit_code
from benchmarks.machine import describe
from tests.mutated_cases import CONFIGS, MutatedCase, bases, mutated

REFUSED = 2  # exit code


@dataclass(frozen=True)
class Changed:
    """A changed case and the command that it goes through."""

    case: MutatedCase
    kind: str  # "check" or "run"

    @property
    def story(self) -> str:
        return self.case.story

    @property
    def mutations(self) -> tuple[Any, ...]:
        return self.case.mutations

    def without(self, mutation: Any) -> "Changed":
        return replace(self, case=self.case.without(mutation))

    def put(self, folder: Path) -> list[str]:
        for drawing in CONFIGS.glob("*.step"):
            shutil.copy(drawing, folder)
        (folder / "case.toml").write_bytes(self.case.content)
        output = ["-o", "out.h5"] if self.kind == "run" else []
        given = [part for setting in self.case.settings for part in ("--set", setting)]
        return [self.kind, "case.toml", *output, *given]

    def may_change(self, name: str) -> bool:
        return False


def main() -> None:
    asked = _arguments()
    seed = asked.seed or commit()
    print(f"{describe()}\ncommit {commit()}, seed {seed}, {asked.n} checks, {asked.runs} runs", flush=True)
    known, rng = bases(), random.Random(seed)
    cases = [mutated(rng, known) for _ in range(asked.n)]
    began = time.perf_counter()
    with tempfile.TemporaryDirectory(prefix="fuzz_cases_") as folder:
        pool = Pool(Path(folder), Limits(), of_result)
        checks = list(pool.answers((number, Changed(case, "check")) for number, case in enumerate(cases)))
        tell("check", checks)
        passed = sorted(answer.number for answer in checks if answer.code == 0)
        chosen = rng.sample(passed, min(asked.runs, len(passed)))
        runs = list(pool.answers((number, Changed(cases[number], "run")) for number in chosen))
        tell("run", runs)
        faulty = sorted((item for item in checks + runs if item.faults), key=lambda item: item.number)
        for answer in faulty:
            _tell_fault(pool.reduced(answer) if asked.minimise else answer, asked.keep)
    print(f"{len(faulty)} faults, {time.perf_counter() - began:.0f} s in all")
    sys.exit(bool(faulty))


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    parser.add_argument("--n", type=int, default=12000, help="cases that are checked")
    parser.add_argument("--runs", type=int, default=600, help="of those that pass, how many are run")
    parser.add_argument("--seed", default="", help="any text; by default the first 8 digits of the commit")
    parser.add_argument("--keep", type=Path, help="folder for the files of faulty inputs")
    parser.add_argument("--no-minimise", dest="minimise", action="store_false")
    return parser.parse_args()


def tell(command: str, answers: list[Answer]) -> None:
    """Print how all inputs of a command ended."""
    codes = Counter(answer.code for answer in answers)
    seconds = sorted(answer.seconds for answer in answers) or [0.0]
    share = 100 * codes[0] / max(len(answers), 1)
    print(
        f"{command}: {len(answers)} inputs, {share:.0f} % with exit 0; "
        + ", ".join(f"exit {code}: {number}" for code, number in sorted(codes.items()))
        + f"; processor time: median {seconds[len(seconds) // 2]:.3f} s, "
        f"99 % {seconds[int(0.99 * len(seconds))]:.2f} s, largest {seconds[-1]:.2f} s; "
        f"with a fault: {sum(bool(answer.faults) for answer in answers)}",
        flush=True,
    )
    for answer in sorted(answers, key=lambda answer: -answer.seconds)[:5]:
        print(
            f"  slowest: {answer.seconds:.2f} s, exit {answer.code}: {answer.input.story[:160]}", flush=True
        )


def _tell_fault(answer: Answer, keep: Path | None) -> None:
    task = answer.input
    assert isinstance(task, Changed)
    print(
        f"\nFAULT {answer.number} ({task.kind}): {'; '.join(answer.faults)[:600]}\n  {task.story[:400]}",
        flush=True,
    )
    if keep:
        keep.mkdir(parents=True, exist_ok=True)
        (keep / f"{answer.number}.toml").write_bytes(task.case.content)
        (keep / f"{answer.number}.txt").write_text(
            "\n".join([*task.case.settings, "", task.story, *answer.faults, answer.text[-4000:]]),
            errors="replace",
        )


def of_result(task: Input, code: int) -> Iterator[str]:
    """Faults of a result that is read back, also as `summary --json`."""
    from flexbearing import api
    from tests.sound_results import faults

    if task.kind == "run" and code == REFUSED:
        yield "refused by run, passed by check"
    if task.kind != "run" or code:
        return
    yield from faults(api.read("out.h5"))
    with redirect_stdout(StringIO()) as printed:
        code = exit_code(["summary", "--json", "out.h5"])
    text = printed.getvalue()
    if code or any(word in text for word in WARNINGS):
        yield f"summary: exit {code}: {text.strip()[-300:]}"


if __name__ == "__main__":
    main()
