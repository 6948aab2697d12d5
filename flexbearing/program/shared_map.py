"""A function for many arguments, on all cores.

Threads would wait for each other: NumPy holds the interpreter between operations as short as those on one
contact.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from contextlib import closing, contextmanager
from functools import partial
from itertools import chain, islice
from typing import Any

from flexbearing.program.interpreter import Died
from flexbearing.program.threads import cores
from flexbearing.program.worker_processes import Processes, keep_freed

ATTEMPTS = 3  # of a call whose worker dies: another program may have taken the memory
AHEAD = 2  # arguments that are taken for each worker
FEWEST = 8  # calls for each worker; the start of one takes as long as a few balls


@contextmanager
def shared_map(
    ahead: str | None = None,
) -> Iterator[Callable[[Callable[[Any], Any], Iterable[Any]], Iterator[Any]]]:
    """Give a `map` of a function whose calls are shared among the cores that this process may use.

    Answers come in the order of the arguments and are those of `map`: the number of cores changes nothing.
    Those of one call are all taken before the next one is made.
    The first exception that a call raises is raised here, `Died` where its worker did `ATTEMPTS` times. All
    workers end with the context. With a module `ahead` they start at once, and load it while this process
    does something else; without one they start with the first call that needs them.
    """
    keep_freed()  # the calls of one process are made here
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
            return _in_order(_answered(processes, function, waiting))

        yield mapped


def _answered(
    processes: Processes, function: Callable[[Any], Any], arguments: Iterator[Any]
) -> Iterator[tuple[int, Any]]:
    """Places and answers as they come; an argument is taken when a worker will soon be free."""
    call, left, deaths = partial(_answer, function), enumerate(arguments), Counter[int]()
    for numbered in islice(left, AHEAD * processes.workers):
        processes.submit(call, numbered)
    for done in processes.as_completed():
        if done.raised is not None:
            raise done.raised
        place, _ = done.argument
        deaths[place] += done.died
        if deaths[place] == ATTEMPTS:
            raise Died(f"a worker process ended {ATTEMPTS} times without a result: is there enough memory?")
        for numbered in [done.argument] if done.died else islice(left, 1):
            processes.submit(call, numbered)
        if not done.died:
            yield place, done.answer


def _in_order(answered: Iterator[tuple[int, Any]]) -> Iterator[Any]:
    early, following = {}, 0
    for place, answer in answered:
        early[place] = answer
        while following in early:
            yield early.pop(following)
            following += 1


def _answer(function: Callable[[Any], Any], numbered: tuple[int, Any]) -> Any:
    keep_freed()
    return function(numbered[1])
