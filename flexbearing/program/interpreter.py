"""A process beside this one that answers calls.

It is a plain interpreter: those of `multiprocessing` would import the script that called. Calls and answers
go through a pair of connected sockets, of which it inherits one: nothing listens, and nobody else can call.
In a session of its own it does not hear what a terminal sends. It ends with this process, however that ends,
in the middle of a call too, and takes with it what it started, such as a mesh generator.
"""

import os
import pickle
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from importlib import import_module
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from queue import SimpleQueue
from tempfile import TemporaryFile
from threading import Thread
from typing import Any

from flexbearing.program.threads import environment

LAST_WORDS = 400  # bytes of its error output that are quoted
_START = (
    "import sys; sys.path[:] = {path!r}; "
    "from flexbearing.program.interpreter import serve; serve({end}, {ahead!r})"
)


class Died(RuntimeError):
    """A process ended without a result."""


class NeverStarted(Died):
    """A process ended before it took a call."""


class Interpreter:
    """A process that answers one call after the other."""

    def __init__(self, workers: int, ahead: str | None = None):
        """Start the process."""
        self._errors = TemporaryFile()  # noqa: SIM115  # closed with its process
        self.calls, theirs = Pipe()  # what `multiprocessing.connection.wait` waits for
        with theirs:
            self._process = subprocess.Popen(
                [sys.executable, "-c", _START.format(path=sys.path, end=theirs.fileno(), ahead=ahead)],
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=self._errors,
                env=environment(workers), pass_fds=[theirs.fileno()], start_new_session=True,
            )  # fmt: skip

    def await_start(self) -> None:
        """Wait until the process takes calls.

        Raises `NeverStarted` if it ends before, with its last words.
        """
        try:
            self.calls.recv()
        except (EOFError, ConnectionError) as ended:
            code = self._process.wait()
            raise NeverStarted(f"worker processes end with {code}: {self._last_words()}") from ended

    def send(self, function: Callable[[Any], Any], argument: Any) -> None:
        """Have a function called, without waiting; a process that has ended is reported by `answer`."""
        with suppress(ConnectionError):
            self.calls.send((function, argument))

    def answer(self) -> tuple[Any, Exception | None]:
        """Wait for the end of a call, in a process whose start was awaited.

        Raises `Died` if the process ends before.
        """
        try:
            return self.calls.recv()
        except (EOFError, ConnectionError) as ended:
            raise Died("a worker process ended without a result") from ended

    @property
    def code(self) -> int | None:
        """Exit code of the process, negative that of a signal; None as long as it lives."""
        return self._process.poll()

    def end(self) -> None:
        """End the process with all that it computes, and what it started."""
        if self.code is None:
            with suppress(ProcessLookupError):
                os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        self.calls.close()
        self._errors.close()

    def _last_words(self) -> str:
        self._errors.seek(0, os.SEEK_END)
        self._errors.seek(max(0, self._errors.tell() - LAST_WORDS))
        words = self._errors.read().decode(errors="replace")
        return "; ".join(line.strip() for line in words.splitlines() if line.strip()) or "without a word"


def serve(end: int, ahead: str | None) -> None:
    """Answer calls in the process beside, until the other one is gone."""
    calls, received = Connection(end), SimpleQueue[bytes]()
    Thread(target=_receive, args=(calls, received), daemon=True).start()
    if ahead is not None:
        import_module(ahead)
    with suppress(ConnectionError):
        calls.send("ready")
    while True:
        end_of_call = _end_of(received.get())
        with suppress(ConnectionError):  # the other one is gone: this process ends at once
            calls.send_bytes(end_of_call)


def _receive(calls: Connection, received: SimpleQueue[bytes]) -> None:
    """Take calls in a thread that also hears the end of the other process while one is answered."""
    try:
        while True:
            received.put(calls.recv_bytes())
    finally:
        os.killpg(0, signal.SIGKILL)


def _end_of(call: bytes) -> bytes:
    """Answer to a call, and what it raised, as bytes."""
    try:
        function, argument = pickle.loads(call)
        return pickle.dumps((function(argument), None))
    except Exception as problem:  # of one call, which must not end the others
        return pickle.dumps((None, _portable(problem)))


def _portable(problem: Exception) -> Exception:
    """An exception as it can be sent; its words where it cannot."""
    try:
        pickle.loads(pickle.dumps(problem))
    except Exception:  # its class may do anything there
        return RuntimeError(f"{type(problem).__name__}: {problem}")
    return problem
