"""Tasks until each variant has its row, also those whose worker dies."""

from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from flexbearing.printable import one_line
from flexbearing.program.interpreter import Died
from flexbearing.program.worker_processes import Done
from flexbearing.studies.plan import Row, Task
from flexbearing.studies.plan.task import ERROR, WORKER_DIED


class EngineLost(Died):
    """What computes the calls of an engine is gone: no call is at fault."""


class Engine(Protocol):
    """Calls a function for one argument after the other, here or elsewhere."""

    workers: int  # calls that run at the same time

    def submit(self, function: Callable[[Any], Any], argument: Any) -> None:
        """Have a function called; both can be pickled."""
        ...

    def as_completed(self) -> Iterator[Done]:
        """Yield the end of each call, also of those submitted meanwhile; ends when none is left."""
        ...

    def close(self) -> None:
        """Stop all that still runs, and every process that was started."""
        ...


ATTEMPTS = 3  # of a variant whose worker dies
DIED = f"its worker process died {ATTEMPTS} times without a word, out of memory or by a crash"


class Named(Protocol):
    """The argument of a call."""

    @property
    def name(self) -> str:
        """By which its attempts are counted."""
        ...


@dataclass(frozen=True)
class TaskResult:
    """How a task ended."""

    rows: tuple[Row, ...]  # of its variants; those without a row are in a task that is still to come
    died: bool = False  # with its worker process


def finished(
    tasks: Iterable[Task], function: Callable[[Task], Sequence[Row]], engine: Engine
) -> Iterator[TaskResult]:
    """Yield the end of every task.

    When a worker dies, its task is halved, so that the deadly variant is found; one that died three times, at
    last by itself, is a row that says so.
    """
    waiting, again, deaths = deque(tasks), deque[Task](), Counter[str]()
    running: set[Task] = set()

    def submit() -> None:
        # What waits behind a deadly task dies with it: suspects run with nothing waiting. One worker may be
        # left for all of them: the last attempts of a variant run alone.
        died = max((deaths[each.identity] for each in _variants([*again, *running])), default=0)
        most = 1 if died >= ATTEMPTS - 1 else engine.workers if died else 2 * engine.workers
        while (again or waiting) and len(running) < most:
            task = again.popleft() if again else waiting.popleft()
            running.add(task)
            engine.submit(function, task)

    submit()
    for done in engine.as_completed():
        running.discard(done.argument)
        if done.died:
            rows = tuple(_deaths(done.argument, deaths, again))
        else:
            rows = tuple(done.answer or _failed(done))
        submit()
        yield TaskResult(rows, done.died)


def completed(
    calls: Iterable[Named],
    function: Callable[[Any], Any],
    engine: Engine,
    again: Callable[[Any], Any] | None = None,
) -> Iterator[Done]:
    """Yield calls as they are completed: one whose worker dies is tried again, twice."""
    waiting, deaths = deque(calls), Counter[str]()

    def submit() -> None:
        argument = waiting.popleft()
        engine.submit(again if again and deaths[argument.name] else function, argument)

    for _ in range(min(engine.workers, len(waiting))):
        submit()
    for done in engine.as_completed():
        deaths[done.argument.name] += done.died
        if done.died and deaths[done.argument.name] < ATTEMPTS:
            waiting.append(done.argument)
        else:
            yield done
        if waiting:
            submit()


def _variants(tasks: Iterable[Task]):
    return (variant for task in tasks for variant in task.variants)


def _deaths(task: Task, deaths: Counter[str], again: deque[Task]) -> Iterator[Row]:
    """The row of a variant that died by itself, and often enough; everything else is queued in halves."""
    deaths.update(variant.identity for variant in task.variants)
    first = task.variants[0].identity
    if len(task.variants) == 1 and deaths[first] >= ATTEMPTS:
        yield Row(first, WORKER_DIED, DIED, 0.0)
    else:
        again.extend(task.halves)


def _failed(done: Done) -> Iterator[Row]:
    """Rows of a task whose function raised what it should have turned into rows."""
    for variant in done.argument.variants:
        yield Row(variant.identity, ERROR, one_line(done.problem), 0.0)
