"""Changed cases through the command line: `python -m benchmarks.fuzz_cases --n 12000 --runs 600 --seed HEX`.

Every input goes through `flexbearing check` as a user would start it, in one of two worker processes: exit
code, time and what was printed are recorded. Some of those that pass are run, their results read back and
summarised. A fault is an exit code other than 0, 1 or 2, a traceback, a warning of a library, a
refusal without a word, one of endless words, a check or run that takes too long, a result that is called
converged and is not sound (tests/sound_results.py). Inputs with a fault are reduced to the changes it needs.
"""

import argparse
import logging
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field, replace
from multiprocessing import get_context
from multiprocessing.connection import wait
from pathlib import Path
from typing import Any

from benchmarks.machine import describe
from tests.mutated_cases import CONFIGS, MutatedCase, bases, mutated

WORKERS = 2
LIMIT = 10.0  # [s] of processor time of a check and of a run: other programs may keep the machine busy
LARGE_LIMIT = 60.0  # [s] of processor time of a job that announced itself as a large one
LONG = 124  # in place of an exit code: a large job, announced as such, that was ended
PATIENCE = 600.0  # [s] until a worker is ended that has not answered
MEMORY = 8 << 30  # [bytes] of a worker
LONGEST_MESSAGE = 20_000  # characters
# Unknowns of a job that may take its time, by where it says that they are.
LARGE = {"on the axial section": 1_000, "in the solid": 15_000, "in the fit": 2_000}
ANNOUNCED = re.compile(rf"about (\d+) unknowns ({'|'.join(LARGE)})")
WARNINGS = ("Warning:", "Traceback", "internal error", "MUMPS", "Segmentation")


@dataclass(frozen=True)
class Task:
    """An input and the command it goes through."""

    number: int
    case: MutatedCase
    command: str  # "check" or "run"


@dataclass(frozen=True)
class Answer:
    """What came of it."""

    task: Task
    code: int
    seconds: float
    text: str
    faults: tuple[str, ...] = ()


def main() -> None:
    asked = _arguments()
    seed = asked.seed or _commit()[:8]
    print(
        f"{describe()}\ncommit {_commit()[:8]}, seed {seed}, {asked.n} checks, {asked.runs} runs", flush=True
    )
    known, rng = bases(), random.Random(seed)
    cases = [mutated(rng, known) for _ in range(asked.n)]
    began = time.perf_counter()
    with tempfile.TemporaryDirectory(prefix="fuzz_cases_") as folder:
        pool = Pool(Path(folder))
        checks = list(pool.answers(Task(number, case, "check") for number, case in enumerate(cases)))
        tell("check", checks)
        passed = sorted(answer.task.number for answer in checks if answer.code == 0)
        chosen = rng.sample(passed, min(asked.runs, len(passed)))
        runs = list(pool.answers(Task(number, cases[number], "run") for number in chosen))
        tell("run", runs)
        faulty = sorted((item for item in checks + runs if item.faults), key=lambda item: item.task.number)
        for answer in faulty:
            _tell_fault(pool, answer, asked.keep, asked.minimise)
        pool.close()
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


def _commit() -> str:
    asked = subprocess.run(
        ["git", "rev-parse", "HEAD"], capture_output=True, text=True, cwd=CONFIGS, check=False
    )
    return asked.stdout.strip() or "00000000"


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
            f"  slowest: {answer.seconds:.2f} s, exit {answer.code}: {answer.task.case.story[:160]}",
            flush=True,
        )


def _tell_fault(pool: "Pool", answer: Answer, keep: Path | None, minimise: bool) -> None:
    task = replace(answer.task, case=pool.reduced(answer)) if minimise else answer.task
    print(
        f"\nFAULT {task.number} ({task.command}): {'; '.join(answer.faults)[:600]}\n"
        f"  {task.case.story[:400]}",
        flush=True,
    )
    if keep:
        keep.mkdir(parents=True, exist_ok=True)
        (keep / f"{task.number}.toml").write_bytes(task.case.content)
        (keep / f"{task.number}.txt").write_text(
            "\n".join([*task.case.settings, "", task.case.story, *answer.faults, answer.text]),
            errors="replace",
        )


def children(process: int) -> list[int]:
    """Processes that a process has started and that still run."""
    found = []
    for place in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):  # it has just ended
            if int((place / "stat").read_text().rpartition(")")[2].split()[1]) == process:
                found.append(int(place.name))
    return found


def processor_time(process: int) -> float:
    """Seconds of a process and of those that it started."""
    try:
        fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
        own = sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")
        return own + sum(map(processor_time, children(process)))
    except OSError:  # it has just ended
        return 0.0


@dataclass
class Worker:
    """A process that answers one task at a time."""

    folder: Path
    task: Task | None = None
    since: float = 0.0
    before: float = 0.0  # [s] processor time when the task was given
    process: Any = field(init=False)
    connection: Any = field(init=False)

    def __post_init__(self) -> None:
        self.folder.mkdir(parents=True, exist_ok=True)
        for drawing in CONFIGS.glob("*.step"):
            shutil.copy(drawing, self.folder)
        context = get_context("spawn")
        self.connection, other = context.Pipe()
        self.process = context.Process(target=work, args=(other, self.folder), daemon=True)
        self.process.start()
        other.close()

    def give(self, task: Task) -> None:
        """Send a task."""
        path = self.folder / "case.toml"
        path.write_bytes(task.case.content)
        self.task, self.since, self.before = task, time.perf_counter(), processor_time(self.process.pid)
        self.connection.send((task.command, str(path), task.case.settings))

    def used(self) -> float:
        """Processor time since the task was given, of the process and those that it started [s]."""
        return processor_time(self.process.pid) - self.before

    def end(self) -> None:
        """Kill the process and those that it started."""
        for child in children(self.process.pid):
            os.kill(child, signal.SIGKILL)
        self.process.kill()
        self.process.join()


class Pool:
    """Workers that are started anew where one died or was ended."""

    def __init__(self, folder: Path, workers: int = WORKERS):
        self.folder = folder
        self.workers = [Worker(folder / str(number)) for number in range(workers)]

    def answers(self, tasks: Iterable[Task]) -> Iterator[Answer]:
        """What came of each task, in the order in which they end."""
        left = iter(tasks)
        for worker in self.workers:
            self._give(worker, left)
        while busy := [worker for worker in self.workers if worker.task]:
            ready = wait([worker.connection for worker in busy], timeout=0.2)
            for worker in busy:
                answer = self._answer(worker, worker.connection in ready)
                if answer:
                    self._give(worker, left)
                    if answer.faults:
                        sys.stderr.write(f"fault: {answer.task.case.story[:200]}: {answer.faults[0][:300]}\n")
                    yield answer

    def _give(self, worker: Worker, left: Iterator[Task]) -> None:
        worker.task = next(left, None)
        if worker.task:
            worker.give(worker.task)

    def _answer(self, worker: Worker, ready: bool) -> Answer | None:
        seconds, task = time.perf_counter() - worker.since, worker.task
        assert task is not None
        if ready:
            try:
                code, seconds, text, faults = worker.connection.recv()
            except (EOFError, ConnectionError):
                self._renew(worker)
                return Answer(task, 139, seconds, "", (f"the process died, {worker.process.exitcode}",))
            return Answer(task, code, seconds, text, faults)
        used = worker.used()
        if max(used / LIMIT, seconds / PATIENCE) < 1:
            return None
        large = announced((worker.folder / "printed").read_text(errors="replace"))
        if large and max(used / LARGE_LIMIT, seconds / PATIENCE) < 1:
            return None
        self._renew(worker)
        told = () if large else (f"took more than {used:.0f} s of processor time, {seconds:.0f} s, ended",)
        return Answer(task, LONG if large else -9, used, "", told)

    def _renew(self, worker: Worker) -> None:
        worker.end()
        self.workers[self.workers.index(worker)] = fresh = Worker(worker.folder)
        worker.process, worker.connection = fresh.process, fresh.connection
        self.workers[self.workers.index(fresh)] = worker

    def reduced(self, answer: Answer) -> MutatedCase:
        """The case with no change that its fault does not need."""
        case = answer.task.case
        if answer.seconds > LIMIT:
            return case
        for change in case.mutations if len(case.mutations) > 1 else ():
            trial = Task(answer.task.number, case.without(change), answer.task.command)
            if any(again.faults and again.code == answer.code for again in self.answers([trial])):
                case = trial.case
        return case

    def close(self) -> None:
        """End all workers."""
        for worker in self.workers:
            worker.end()


def announced(text: str) -> bool:
    """Whether a run said that it is a large one before it took its time."""
    return any(int(unknowns) > LARGE[place] for unknowns, place in ANNOUNCED.findall(text))


def work(connection, folder: Path) -> None:
    """Answer tasks until the other end is closed."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    os.environ["FLEXBEARING_CACHE"] = str(folder / "cache")
    os.chdir(folder)
    import warnings

    warnings.simplefilter("always")
    with Path("printed").open("w+b", buffering=0) as printed:
        os.dup2(printed.fileno(), 1)
        os.dup2(printed.fileno(), 2)
        while True:
            try:
                command, path, settings = connection.recv()
            except EOFError:
                return
            printed.seek(0)
            printed.truncate()
            logging.getLogger().handlers.clear()  # or the first command would have settled what is logged
            began = _processor_time()
            code = _commanded(command, path, settings)
            seconds = _processor_time() - began
            printed.seek(0)
            text = printed.read(1 << 20).decode(errors="replace")
            found = (
                *_of_output(code, command, text),
                *(_of_result(printed) if command == "run" and code == 0 else ()),
            )
            if seconds > LIMIT and not announced(text):
                found += (f"took {seconds:.1f} s of processor time",)
            connection.send((code, seconds, text[-4000:], found))


def _processor_time() -> float:
    """Seconds of this process and of those that it started."""
    return sum(os.times()[:4])


def _commanded(command: str, path: str, settings: Iterable[str]) -> int:
    """Exit code of the command line."""
    output = ["-o", "out.h5"] if command == "run" else []
    Path("out.h5").unlink(missing_ok=True)
    given = [part for setting in settings for part in ("--set", setting)]
    return _exit_code([command, path, *output, *given])


def _exit_code(words: list[str]) -> int:
    """As the program would end it."""
    from flexbearing.__main__ import command

    try:
        return command(words)
    except BaseException as problem:  # of any kind: that none reaches the user is what is measured
        sys.stderr.write(f"Traceback: {type(problem).__name__}: {problem}\n")
        return 3
    finally:
        sys.stdout.flush()
        sys.stderr.flush()


def _of_output(code: int, command: str, text: str) -> Iterator[str]:
    if code not in (0, 1, 2):
        yield f"exit {code}: {text.strip()[-400:]}"
    for word in WARNINGS:
        if word in text and code in (0, 1, 2):
            yield f"printed {text[max(text.index(word) - 200, 0) : text.index(word) + 300]!r}"
            break
    if code == 2 and not text.strip():
        yield "refused without a word"
    if len(text) > LONGEST_MESSAGE:
        yield f"printed {len(text)} characters"


def _of_result(printed) -> Iterator[str]:
    """Read the result of a run back, also as `summary --json`."""
    from flexbearing import api
    from tests.sound_results import faults

    yield from faults(api.read("out.h5"))
    printed.seek(0)
    printed.truncate()
    code = _exit_code(["summary", "--json", "out.h5"])
    printed.seek(0)
    text = printed.read(1 << 20).decode(errors="replace")
    if code or any(word in text for word in WARNINGS):
        yield f"summary: exit {code}: {text.strip()[-300:]}"


if __name__ == "__main__":
    main()
