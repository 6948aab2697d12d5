"""A function for many arguments, on all cores.

Worker processes are plain interpreters, which do not import the script that called. In sessions of their own
they do not hear what a terminal sends; they end with this process, however that ends. Threads would wait for
each other: NumPy holds the interpreter between operations as short as those on one contact.
"""

import pickle
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from multiprocessing import Pipe
from multiprocessing.connection import Connection, wait
from typing import Any

from flexbearing.program.threads import cores, environment

FEWEST = 8  # calls for each worker; the start of one takes as long as a few balls
_START = "import sys; sys.path[:] = {path!r}; from flexbearing.program import workers; workers.serve({end})"


class WorkerDied(RuntimeError):
    """A worker process ended without an answer, as when memory is short."""


@contextmanager
def shared_map() -> Iterator[Callable[[Callable[[Any], Any], Iterable[Any]], Iterator[Any]]]:
    """Give a `map` of one function whose calls are shared among the cores that this process may use.

    Answers come in the order of the arguments and are those of `map`: the number of cores changes nothing.
    The first exception that a call raises is raised here. All workers end with the context.
    """
    workers: list[_Worker] = []

    def mapped(function: Callable[[Any], Any], arguments: Iterable[Any]) -> Iterator[Any]:
        waiting = list(arguments)
        count = min(cores(), len(waiting) // FEWEST)
        if count < 2:
            return map(function, waiting)
        for _ in range(count):
            workers.append(_Worker(function, count))
        return _in_order(workers[-count:], waiting)

    try:
        yield mapped
    finally:
        for worker in workers:
            worker.end()


class _Worker:
    """A process that calls one function."""

    def __init__(self, function: Callable[[Any], Any], workers: int):
        self.calls, theirs = Pipe()
        with theirs:
            self._process = subprocess.Popen(
                [sys.executable, "-c", _START.format(path=sys.path, end=theirs.fileno())],
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, env=environment(workers),
                pass_fds=[theirs.fileno()], start_new_session=True,
            )  # fmt: skip
        self.calls.send(function)

    def end(self) -> None:
        """End the process with whatever it computes."""
        self._process.kill()
        self._process.wait()
        self.calls.close()


def _in_order(workers: list[_Worker], arguments: list[Any]) -> Iterator[Any]:
    """Answers in the order of the arguments, the next argument to the worker that is free first."""
    free, under_way, answers, sent = workers, {}, {}, 0
    for number in range(len(arguments)):
        while number not in answers:
            for worker in free[: len(arguments) - sent]:
                _send(worker, arguments[sent])
                under_way[worker.calls], sent = (worker, sent), sent + 1
            done = [under_way.pop(calls) for calls in wait(list(under_way)) if isinstance(calls, Connection)]
            answers |= {place: _answer(worker) for worker, place in done}
            free = [worker for worker, _ in done]
        yield answers.pop(number)


def _send(worker: _Worker, argument: Any) -> None:
    try:
        worker.calls.send(argument)
    except ConnectionError as problem:
        raise WorkerDied("a worker process ended as soon as it was started") from problem


def _answer(worker: _Worker) -> Any:
    try:
        answer, problem = worker.calls.recv()
    except (EOFError, ConnectionError) as ended:
        raise WorkerDied("a worker process ended without an answer: is there enough memory?") from ended
    if problem is not None:
        raise problem
    return answer


def serve(end: int) -> None:
    """Answer calls in a worker process, until the other one is gone.

    Parameters
    ----------
    end : int
        file descriptor of this end of the connection
    """
    calls = Connection(end)
    try:
        function = calls.recv()
        while True:
            argument = calls.recv()
            try:
                answer = function(argument), None
            except Exception as problem:  # of one call: it is raised where the answer is wanted
                answer = None, portable(problem)
            calls.send(answer)
    except (EOFError, ConnectionError):  # the caller is gone
        return


def portable(problem: Exception) -> Exception:
    """An exception as it can be sent; its words where it cannot."""
    try:
        pickle.loads(pickle.dumps(problem))
    except Exception:  # whatever its class does there
        return RuntimeError(f"{type(problem).__name__}: {problem}")
    return problem
