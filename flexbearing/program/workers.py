"""A function for many arguments, on all cores.

Threads would wait for each other: NumPy holds the interpreter between operations as short as those on one
contact.
"""

from collections.abc import Callable, Iterable, Iterator
from contextlib import closing, contextmanager
from functools import partial
from itertools import chain, count, islice
from typing import Any

from flexbearing.program.interpreter import Died
from flexbearing.program.processes import Processes
from flexbearing.program.threads import cores

AHEAD = 2  # arguments that are taken for each worker
FEWEST = 8  # calls for each worker; the start of one takes as long as a few balls


@contextmanager
def shared_map(
    ahead: str | None = None,
) -> Iterator[Callable[[Callable[[Any], Any], Iterable[Any]], Iterator[Any]]]:
    """Give a `map` of a function whose calls are shared among the cores that this process may use.

    Answers come in the order of the arguments and are those of `map`: the number of cores changes nothing.
    Those of one call are all taken before the next one is made.
    The first exception that a call raises is raised here, `Died` where its worker did. All workers end with
    the context. With a module `ahead` they start at once, and load it while this process does something else;
    without one they start with the first call that needs them.
    """
    with closing(Processes(cores(), ahead)) as processes:
        if ahead is not None and cores() > 1:
            processes.start()

        def mapped(function: Callable[[Any], Any], arguments: Iterable[Any]) -> Iterator[Any]:
            left = iter(arguments)
            first = list(islice(left, FEWEST * cores()))
            workers, waiting = len(first) // FEWEST, chain(first, left)
            if workers < 2:
                return map(function, waiting)
            processes.workers = workers
            return _in_order(processes, function, waiting)

        yield mapped


def _in_order(
    processes: Processes, function: Callable[[Any], Any], arguments: Iterator[Any]
) -> Iterator[Any]:
    """Answers in the order of the arguments, each of which is taken when a worker will soon be free."""
    answers, left, ends = {}, enumerate(arguments), processes.as_completed()

    def submit(some: int) -> None:
        for numbered in islice(left, some):
            processes.submit(partial(_answer, function), numbered)

    submit(AHEAD * processes.workers)
    for number in count():
        while number not in answers:
            done = next(ends, None)
            if done is None:
                return
            if done.raised is not None:
                raise done.raised
            if done.died:
                raise Died("a worker process ended without an answer: is there enough memory?")
            answers[done.argument[0]] = done.answer
            submit(1)
        yield answers.pop(number)


def _answer(function: Callable[[Any], Any], numbered: tuple[int, Any]) -> Any:
    return function(numbered[1])
