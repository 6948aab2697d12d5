"""Work in a process of its own, so that what ends that process does not end this one.

The mesh generator has been seen to abort, on solids that nearly touch themselves. The process is a plain
interpreter and not one of `multiprocessing`, which would import the caller's script once more; it is
started fresh because forking a program with threads may hang. Loading NGSolve there takes a second.
"""

import logging
import os
import pickle
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from threading import Event, Thread, Timer, current_thread, main_thread
from typing import Any, BinaryIO

from fem.parts.material import ImpossiblePart
from fem.stages import Report, unheard

WAIT = 3600.0  # [s] without a word from the process before it is given up; factoring is one silence
LAST_WORDS = 400  # bytes of its error output that are quoted
_START = "import sys; sys.path[:] = {path!r}; from fem.subprocess import _work; _work()"
_ENDING = {number for name in ("SIGINT", "SIGTERM", "SIGHUP") if (number := getattr(signal, name, None))}
_ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}


def in_subprocess(function: Callable, *arguments: Any, report: Report = unheard, wait: float = WAIT) -> Any:
    """Call an importable function in a process of its own, with arguments and a result that can be pickled.

    The function takes `report` (stage, fraction), too: what it reports and logs there is reported and logged
    here. `wait` is the longest silence, between two reports or before the end [s].
    Raises `NotSolved` if the process ends without a result or is silent for too long; ImpossiblePart and
    NotSolved of the function come through, its other exceptions become a NotSolved.
    """
    with started(function, *arguments, wait=wait) as answer:
        return answer(report)


@contextmanager
def started(function: Callable, *arguments: Any, wait: float = WAIT) -> Iterator[Callable[[Report], Any]]:
    """Have a function at work in a process of its own while the block goes on, as `in_subprocess` calls it.

    Start it while no threads of NGSolve are at work here: a process that starts beside them may hang. The
    callable (report) waits for the result; without it the process ends with the block.
    """
    with tempfile.TemporaryFile() as errors, _started(errors) as process:
        _hand_over(process, (function, arguments))
        yield lambda report: _answer(process, report, wait, errors)


@contextmanager
def _started(errors: BinaryIO) -> Iterator[subprocess.Popen]:
    """A process that lives no longer than the block, and that no signal but that at its end reaches.

    What a terminal or a queue sends to all processes of a job is for the caller to answer; the block of
    signals in which the process begins is inherited.
    """
    release = _held(_ENDING)
    try:
        with subprocess.Popen(
            [sys.executable, "-c", _START.format(path=sys.path)],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=errors, env=os.environ | _ONE_THREAD,
        ) as process:  # fmt: skip
            assert process.stdin
            try:
                release()
                yield process
            finally:  # also after Ctrl-C; a process that has ended is not harmed
                process.kill()
                with suppress(BrokenPipeError):  # of a task that was not taken
                    process.stdin.close()
    finally:
        release()


def _held(numbers: set[int]) -> Callable[[], None]:
    """Hold signals back; what is returned lets them through again, those that came meanwhile at once.

    They are blocked for the process that begins, and their handlers wait: what this thread blocks, another
    thread takes for the whole program.
    """
    if not hasattr(signal, "pthread_sigmask"):  # a system without
        return lambda: None
    came: list[int] = []
    before = signal.pthread_sigmask(signal.SIG_BLOCK, numbers)
    handlers = {}
    if current_thread() is main_thread():  # the only one that may set them
        handlers = {number: signal.getsignal(number) for number in numbers}
        handlers = {number: handler for number, handler in handlers.items() if callable(handler)}
    for number in handlers:
        signal.signal(number, lambda number, _: came.append(number))

    def release() -> None:
        while handlers:
            signal.signal(*handlers.popitem())
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
        while came:
            signal.raise_signal(came.pop())

    return release


def _hand_over(process: subprocess.Popen, task: tuple) -> None:
    assert process.stdin
    with suppress(BrokenPipeError):  # the process has ended: its result says how
        pickle.dump(task, process.stdin)
        process.stdin.flush()


def _answer(process: subprocess.Popen, report: Report, wait: float, errors: BinaryIO) -> Any:
    """Pass reports on, and take the answer."""
    while True:
        word, *content = _next(process, wait, errors)
        if word == "result":
            return content[0]
        if word == "raised":
            raise content[0]
        if word == "log":
            name, level, text = content
            logging.getLogger(name).log(level, text)
        else:
            report(*content)


def _next(process: subprocess.Popen, wait: float, errors: BinaryIO) -> tuple:
    """The next message; a process that stays silent is ended."""
    assert process.stdout
    silence = Event()
    watch = Timer(wait, lambda: (silence.set(), process.kill()))
    watch.daemon = True
    watch.start()
    try:
        return pickle.load(process.stdout)
    except (EOFError, pickle.UnpicklingError):
        # Loads NGSolve, which a program that only waits for an answer does without.
        from fem.assembly.factorisation import NotSolved

        silent = f"was silent for {wait:g} s and was ended; take larger elements"
        what = silent if silence.is_set() else _ending(process, errors)
        raise NotSolved(f"the process that meshes and condenses {what}") from None
    finally:
        watch.cancel()


def _ending(process: subprocess.Popen, errors: BinaryIO) -> str:
    """How a process ended, and its last words."""
    code = process.wait()
    how = f"by signal {-code} ({signal.strsignal(-code)})" if code < 0 else f"with exit code {code}"
    errors.seek(0, os.SEEK_END)
    errors.seek(max(0, errors.tell() - LAST_WORDS))
    words = errors.read().decode(errors="replace").strip()
    advice = (
        "Gaps and walls that are nearly nothing do that to the mesh generator: widen or remove them; damaged "
        "drawings do it to the geometry kernel: export them again"
    )
    if code == -9:  # also what a system does that runs out of memory
        advice = "Nobody but the system ends it so: take larger elements, they need less memory"
    return f"ended {how}; its last words: {words or 'none'}. {advice}"


def _work() -> None:
    """What the process does: take a task, report, answer."""
    # What libraries print must not get between the messages.
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)

    def send(*message):
        pickle.dump(message, answers)
        answers.flush()

    class ToCaller(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            send("log", record.name, record.levelno, record.getMessage())

    logging.getLogger("fem").addHandler(ToCaller())
    logging.getLogger("fem").setLevel(logging.INFO)
    task = sys.stdin.buffer
    function, arguments = pickle.load(task)
    Thread(target=_leave_with_parent, args=(task,), daemon=True).start()
    try:
        result = function(*arguments, report=lambda stage, fraction=None: send("report", stage, fraction))
        send("result", result)
    except Exception as problem:
        send("raised", _sendable(problem))


def _leave_with_parent(task: BinaryIO) -> None:
    """End this process when the parent is gone, whose end of the pipe closes then."""
    task.read()
    os._exit(1)


def _sendable(problem: Exception) -> Exception:
    """The exception itself if it is one of ours, or one that says the same."""
    if isinstance(problem, ImpossiblePart | MemoryError):
        return problem
    from fem.assembly.factorisation import NotSolved

    if isinstance(problem, NotSolved):
        return problem
    return NotSolved(f"meshing or condensing failed: {type(problem).__name__}: {problem}")
