"""A function for many arguments, on all cores.

Threads would wait for each other: NumPy holds the interpreter between operations as short as those on one
contact.
"""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from itertools import chain, count, islice
from multiprocessing.connection import wait
from typing import Any

from flexbearing.program.interpreter import Interpreter
from flexbearing.program.threads import cores

FEWEST = 8  # calls for each worker; the start of one takes as long as a few balls


@contextmanager
def shared_map(
    ahead: Callable[..., Any] | None = None,
) -> Iterator[Callable[[Callable[[Any], Any], Iterable[Any]], Iterator[Any]]]:
    """Give a `map` of a function whose calls are shared among the cores that this process may use.

    Answers come in the order of the arguments and are those of `map`: the number of cores changes nothing.
    Those of one call are all taken before the next one is made.
    The first exception that a call raises is raised here, `Died` where its worker did. All workers end with
    the context. Of a function `ahead` they load the module as soon as the context begins, while this process
    does something else; without one they start with the first call that needs them.
    """
    workers: list[Interpreter] = []
    loading: list[Interpreter] = []
    if ahead is not None and cores() > 1:
        workers.extend(Interpreter(cores()) for _ in range(cores()))
        loading.extend(workers)
        for worker in loading:
            worker.send(_loaded, ahead)

    def mapped(function: Callable[[Any], Any], arguments: Iterable[Any]) -> Iterator[Any]:
        left = iter(arguments)
        first = list(islice(left, FEWEST * cores()))
        number, waiting = len(first) // FEWEST, chain(first, left)
        if number < 2:
            return map(function, waiting)
        while loading:
            worker = loading.pop()
            worker.await_start()
            _answer(worker)
        started = range(len(workers), number)  # others are there from the call before
        workers.extend(Interpreter(number) for _ in started)
        for place in started:
            workers[place].await_start()
        return _in_order(workers[:number], function, waiting)

    try:
        yield mapped
    finally:
        for worker in workers:
            worker.end()


def _loaded(function: Callable[..., Any]) -> None:
    """A function that was sent, and so its module, is there."""


def _in_order(
    workers: list[Interpreter], function: Callable[[Any], Any], arguments: Iterator[Any]
) -> Iterator[Any]:
    """Answers in the order of the arguments, the next argument to the worker that is free first."""
    free, under_way, answers, left = workers, {}, {}, enumerate(arguments)
    for number in count():
        while number not in answers:
            for worker, (place, argument) in zip(free, left, strict=False):
                worker.send(function, argument)
                under_way[worker.calls] = worker, place
            if not under_way:
                return
            done = [under_way.pop(calls) for calls in wait(list(under_way))]
            answers |= {place: _answer(worker) for worker, place in done}
            free = [worker for worker, _ in done]
        yield answers.pop(number)


def _answer(worker: Interpreter) -> Any:
    answer, problem = worker.answer()
    if problem is not None:
        raise problem
    return answer
