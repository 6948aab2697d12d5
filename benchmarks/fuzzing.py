"""Changed inputs through the command line, each in a process whose time, memory and files are judged.

Modules are loaded once and every process is a fork: an input takes no start of the program. The folder of a
process holds the files of its input and nothing else, and is gone with it.
"""

import importlib
import json
import os
import pkgutil
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from hashlib import file_digest
from multiprocessing.connection import wait
from pathlib import Path
from typing import Any, Protocol, Self

WORKERS = 2
LONG = 124  # in place of an exit code: a large job, announced as such, that was ended
KILLED, DIED = -9, 139  # the same: ended here, ended by itself
LONGEST_MESSAGE = 20_000  # characters
# Sizes above which a job may take its time, by the words that announce them.
LARGE = {
    "unknowns on the axial section": 1_000, "unknowns in the solid": 15_000, "unknowns in the fit": 2_000,
    "variants": 500,
    "points where several states are likely": 4, "ends of stable states": 2,
}  # fmt: skip
ANNOUNCED = re.compile(rf"(?:about|of) (\d+) ({'|'.join(LARGE)})")
WARNINGS = (
    "Warning:",
    "Traceback",
    "internal error",
    "MUMPS",
    "Fatal Python error",
)  # of this process: one that
# meshes and crashes is reported in words, with its signal
LEFTOVER = re.compile(r"\.(part|tmp|lock)$")
MODULES = ("h5py", "matplotlib.pyplot", "netCDF4", "ngsolve", "pandas", "pyarrow.parquet", "scipy.optimize",
           "xarray")  # fmt: skip


class Input(Protocol):
    """Files and a command line, made of a good base by changes."""

    @property
    def kind(self) -> str:
        """What it is counted as."""
        ...

    @property
    def story(self) -> str:
        """What was changed, for people."""
        ...

    @property
    def mutations(self) -> tuple[Any, ...]:
        """The changes."""
        ...

    def without(self, mutation: Any) -> Self:
        """The input with one change less."""
        ...

    def put(self, folder: Path) -> Sequence[str]:
        """Write the files; words of the command line, which begins in this folder."""
        ...

    def may_change(self, name: str) -> bool:
        """Whether the command may write this file of the input."""
        ...


@dataclass(frozen=True)
class Limits:
    """What an input may take."""

    seconds: float = 10.0  # of processor time: other programs may keep the machine busy
    large_seconds: float = 60.0  # of a job that announced itself as a large one
    patience: float = 600.0  # [s] until a process is ended that waits for something
    memory: int | None = None  # [bytes] of a process; more is a fault
    most_memory: int = 8 << 30  # [bytes] of addresses; more is refused
    file: int = 1 << 30  # [bytes] of a file; more is refused


@dataclass(frozen=True)
class Answer:
    """What came of an input."""

    number: int
    input: Input
    code: int
    seconds: float = 0.0  # of processor time
    memory: int = 0  # [bytes]
    text: str = ""
    faults: tuple[str, ...] = ()


@dataclass
class Running:
    """A process with its input."""

    number: int
    input: Input
    place: Path
    process: int
    since: float

    @property
    def printed(self) -> Path:
        return self.place / "printed"

    @property
    def processor_time(self) -> float:
        """Seconds of the command so far."""
        with suppress(OSError, ValueError):  # its files are being written
            return processor_time(self.process) - float((self.place / "began").read_text())
        return 0.0

    def text(self) -> str:
        """The beginning of what was printed."""
        with suppress(OSError), self.printed.open("rb") as file:
            return file.read(1 << 20).decode(errors="replace")
        return ""


class Pool:
    """Processes, each for one input."""

    def __init__(
        self,
        folder: Path,
        limits: Limits,
        read_back: Callable[[Input, int], Iterable[str]] = lambda task, code: (),
        workers: int = WORKERS,
    ):
        self.folder, self.limits, self.read_back, self.workers = folder, limits, read_back, workers
        os.environ["FLEXBEARING_CACHE"] = str(folder / "cache")
        preload()

    def answers(self, inputs: Iterable[tuple[int, Input]]) -> Iterator[Answer]:
        """What came of each numbered input, in the order in which they end."""
        left, running = iter(inputs), dict[int, Running]()
        while True:
            while len(running) < self.workers and (task := next(left, None)):
                job = self._started(*task)
                running[os.pidfd_open(job.process)] = job
            if not running:
                return
            ready = wait([*running], timeout=0.2)
            for handle, job in [*running.items()]:
                answer = self._ended(job) if handle in ready else self._stopped(job)
                if answer:
                    os.close(handle)
                    del running[handle]
                    shutil.rmtree(job.place, ignore_errors=True)
                    if answer.faults:
                        sys.stderr.write(f"fault: {job.input.story[:200]}: {answer.faults[0][:300]}\n")
                    yield answer

    def _started(self, number: int, task: Input) -> Running:
        place = self.folder / f"input_{number}"
        shutil.rmtree(place, ignore_errors=True)
        (place / "files").mkdir(parents=True)
        sys.stdout.flush()
        sys.stderr.flush()
        process = os.fork()
        if not process:
            try:
                self._work(place, task)
            finally:
                os._exit(1)
        return Running(number, task, place, process, time.perf_counter())

    def _work(self, place: Path, task: Input) -> None:
        """In the process: the command, and what is to be said of it."""
        for what, most in (("AS", self.limits.most_memory), ("FSIZE", self.limits.file), ("CORE", 0)):
            resource.setrlimit(getattr(resource, f"RLIMIT_{what}"), (most, most))
        os.chdir(place / "files")
        words = task.put(Path())
        before = {name: content for name, content in _contents() if not task.may_change(name)}
        printed = os.open(place / "printed", os.O_RDWR | os.O_CREAT)
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        os.dup2(printed, 1)
        os.dup2(printed, 2)
        _warn_always()
        _forget_peak()
        began = _processor_time()
        (place / "began").write_text(str(began))  # what came before made the files
        code = exit_code(words)
        seconds, memory = _processor_time() - began, _peak()
        length = os.fstat(printed).st_size
        faults = [*_of_files(before, words), *self.read_back(task, code)]
        answer = {"code": code, "seconds": seconds, "memory": memory, "length": length, "faults": faults}
        (place / "answer").write_text(json.dumps(answer))
        os._exit(0)

    def _ended(self, job: Running) -> Answer:
        """Of a process that has ended by itself."""
        _, status, used = os.wait4(job.process, 0)
        text = job.text()
        try:
            answer = json.loads((job.place / "answer").read_bytes())
        except (OSError, ValueError):
            how = f"the process died, {os.waitstatus_to_exitcode(status)}: {text[-400:]}"
            return Answer(job.number, job.input, DIED, used.ru_utime, 0, text[-4000:], (how,))
        code, seconds, memory = answer["code"], answer["seconds"], answer["memory"]
        faults = [*_of_output(code, text, answer["length"]), *answer["faults"]]
        if seconds > self.limits.seconds and not announced(text):
            faults.append(f"took {seconds:.1f} s of processor time")
        if self.limits.memory and memory > self.limits.memory:
            faults.append(f"took {memory / 1e9:.2f} GB")
        return Answer(job.number, job.input, code, seconds, memory, text[-4000:], tuple(faults))

    def _stopped(self, job: Running) -> Answer | None:
        """Of a process that is ended here, where it takes too long."""
        used, waited = job.processor_time, time.perf_counter() - job.since
        if used < self.limits.seconds and waited < self.limits.patience:
            return None
        large = announced(job.text())
        if large and used < self.limits.large_seconds and waited < self.limits.patience:
            return None
        for process in [job.process, *descendants(job.process)]:
            with suppress(ProcessLookupError):  # it has just ended
                os.kill(process, signal.SIGKILL)
        os.waitpid(job.process, 0)
        fault = f"took more than {used:.0f} s of processor time, {waited:.0f} s, ended"
        return Answer(
            job.number, job.input, LONG if large else KILLED, used, 0, job.text(), () if large else (fault,)
        )

    def reduced(self, answer: Answer) -> Answer:
        """The same fault of an input with no change that it does not need."""
        if answer.code == KILLED or answer.seconds > self.limits.seconds:
            return answer
        for change in answer.input.mutations if len(answer.input.mutations) > 1 else ():
            for again in self.answers([(answer.number, answer.input.without(change))]):
                if {_shape(fault) for fault in again.faults} >= {_shape(answer.faults[0])}:
                    answer = replace(again, faults=(answer.faults[0], *again.faults[1:]))
        return answer


def commit() -> str:
    """First digits of the commit that is measured."""
    asked = subprocess.run(
        ["git", "rev-parse", "HEAD"], capture_output=True, text=True, cwd=Path(__file__).parent, check=False
    )
    return asked.stdout.strip()[:8] or "00000000"


def preload() -> None:
    """Load what any command loads, so that every process has it."""
    import flexbearing

    for name in MODULES:
        importlib.import_module(name)
    for module in pkgutil.walk_packages(flexbearing.__path__, "flexbearing."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)


def announced(text: str) -> bool:
    """Whether a run said that it is a large one before it took its time."""
    return any(int(number) > LARGE[what] for number, what in ANNOUNCED.findall(text))


def by_shape(answers: Iterable[Answer]) -> dict[str, list[Answer]]:
    """Answers with a fault, those with the same first fault, but for numbers and names in it, together."""
    found: dict[str, list[Answer]] = {}
    for answer in sorted(answers, key=lambda answer: answer.number):
        if answer.faults:
            found.setdefault(f"{answer.input.kind}: {_shape(answer.faults[0])}", []).append(answer)
    return found


def _shape(fault: str) -> str:
    """A fault without numbers and quoted words."""
    return re.sub(r"'[^']*'|\"[^\"]*\"|\S*/\S*|\d+", "#", fault)[:90]


def descendants(process: int) -> list[int]:
    """Processes that a process and those below it have started and that still run."""
    parents = {}
    for place in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):  # it has just ended
            parents[int(place.name)] = int((place / "stat").read_text().rpartition(")")[2].split()[1])
    found = [process]
    for each in found:
        found += [child for child, parent in parents.items() if parent == each]
    return found[1:]


def processor_time(process: int) -> float:
    """Seconds of a process and of those that it started."""
    ticks = 0
    for each in [process, *descendants(process)]:
        with suppress(OSError):  # it has just ended
            fields = Path(f"/proc/{each}/stat").read_text().rpartition(")")[2].split()
            ticks += sum(map(int, fields[11:15]))
    return ticks / os.sysconf("SC_CLK_TCK")


def exit_code(words: Sequence[str]) -> int:
    """As the program would end."""
    from flexbearing.__main__ import command

    try:
        return command([*words])
    except BaseException as problem:  # of any kind: that none reaches the user is what is measured
        sys.stderr.write(f"Traceback: {type(problem).__name__}: {problem}\n")
        return 3
    finally:
        sys.stdout.flush()
        sys.stderr.flush()


def _warn_always() -> None:
    import warnings

    warnings.simplefilter("always")


def _processor_time() -> float:
    """Seconds of this process and of those that it started."""
    return sum(os.times()[:4])


def _forget_peak() -> None:
    """Let the largest memory begin anew."""
    Path("/proc/self/clear_refs").write_text("5")


def _peak() -> int:
    """Largest memory of this process or of one that it started [bytes]."""
    own = re.search(r"VmHWM:\s+(\d+)", Path("/proc/self/status").read_text())
    assert own
    return 1024 * max(int(own[1]), resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)


def _contents() -> Iterator[tuple[str, bytes]]:
    """Plain files of the folder with their digests: contents would count as memory of the command."""
    for path in Path().rglob("*"):
        if path.is_file() and not path.is_symlink():
            with path.open("rb") as file:
                yield str(path), file_digest(file, "sha256").digest()


def _of_files(before: dict[str, bytes], words: Sequence[str]) -> Iterator[str]:
    """Faults by what is in the folder: inputs that have changed, files that should be gone, unless named."""
    after = dict(_contents())
    for name, content in before.items():
        if after.get(name) != content:
            yield f"changed its input {name!r}" if name in after else f"removed its input {name!r}"
    for name in after.keys() - before.keys():
        if LEFTOVER.search(name) and name not in words:
            yield f"left {name!r}"
    if below := descendants(os.getpid()):
        yield f"left {len(below)} processes"


def _of_output(code: int, text: str, length: int) -> Iterator[str]:
    if code not in (0, 1, 2):
        yield f"exit {code}: {text.strip().rpartition(chr(10))[2][-400:]}"
    for word in WARNINGS:
        if word in text and code in (0, 1, 2):
            yield f"printed {text[max(text.index(word) - 200, 0) : text.index(word) + 300]!r}"
            break
    if code == 2 and not text.strip():
        yield "refused without a word"
    if code and length > LONGEST_MESSAGE:  # an output may be long
        yield f"printed {length} characters"
