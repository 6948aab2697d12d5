"""The computing of a study: what is still lacking, by an engine, into journal and table."""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence, Set
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Any

from flexbearing.files import NotStored, require_folder, require_outputs, write
from flexbearing.report.picture import picture_bytes
from flexbearing.studies.engine import Done, Engine, completed, finished
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.plan import Condensed, Corners, Ring, Row, Task
from flexbearing.studies.plan.task import NOT_STORED, involves
from flexbearing.studies.prepared_study import PreparedStudy, Progress
from flexbearing.studies.table import Table, journal
from flexbearing.studies.table.files import PICTURE, store
from flexbearing.studies.table.table import draw

Tell = Callable[[Progress], None]


@dataclass(frozen=True)
class Work:
    """What workers do; both functions can be pickled."""

    rows: Callable[[Task], Sequence[Row]]
    condense: Callable[..., Any]  # of a Ring or Corners, gives a Condensed, or nothing for rigid rings; with
    # here=True what may crash is done in the calling process itself


def run(
    prepared: PreparedStudy,
    output: Path,
    work: Work,
    engine: Callable[[int], Engine],
    *,
    retry_failed: bool = False,
    tell: Tell = lambda progress: None,
) -> Table:
    """Compute what a study still lacks, and write its table.

    Raises `BadOutput` for a folder that cannot be written, an output that is read or where the same study
    runs already; `NotStored` when there is no room left; what is finished stays.
    """
    folder = require_folder(output)
    path, *_ = require_outputs(prepared.destinations(folder), prepared.study.inputs)
    rows: dict[str, Row] = {}
    try:
        with journal.opened(path, prepared.texts) as kept:
            suspects = journal.begun(path)
            rows |= prepared.rows(folder, retry_failed=retry_failed)
            tell(prepared.progress(rows))
            complaints = compute_missing(
                prepared, rows, work, partial(guarded, engine, kept, suspects), kept, tell
            )
    except BaseException as problem:
        if rows:
            done = prepared.progress(rows)
            problem.add_note(
                f"{done.done} of {done.total} variants are kept, the same study goes on from there"
            )
            if not prepared.part:
                with suppress(NotStored):
                    store(prepared.table(rows), folder)
        raise
    table = replace(prepared.table(rows), complaints=complaints)
    if prepared.part:
        return table
    store(table, folder)
    if prepared.plot:
        picture = folder / f"{prepared.study.name}{PICTURE}"
        write(picture.resolve(), picture_bytes(draw(table, prepared.plot)))
    return table


def guarded(engine: Callable[[int], Engine], kept: journal.Journal, suspects: Set[str], tasks: int) -> Engine:
    """The engine; one in this process does not meet again there what ended a former one."""
    started = engine(tasks)
    if isinstance(started, Serial):
        started.guard(kept.begins, partial(involves, suspects=suspects))
    return started


def _condensed(calls: Iterable[Ring | Corners], work: Work, started: Engine) -> Iterator[Done]:
    """Condense rings: in the process of a worker, if it is one whose death ends nothing else.

    A process of its own for each ring would load the finite elements once more.
    """
    if isinstance(started, Serial):
        return completed(calls, work.condense, started)
    return completed(calls, partial(work.condense, here=True), started, again=work.condense)


def compute_missing(
    prepared: PreparedStudy,
    rows: dict[str, Row],
    work: Work,
    engine: Callable[[int], Engine],
    kept: journal.Journal,
    tell: Tell,
) -> tuple[str, ...]:
    """Add the rows that are missing to those that there are, and to the journal, task by task.

    Raises `NotStored` when there is no room left; what is finished stays.
    """
    tasks = prepared.plan.tasks(lambda variant: variant.identity not in rows)
    rings = prepared.plan.rings(lambda variant: variant.identity not in rows and not variant.levels)
    first = (*rings, *prepared.plan.choices(lambda variant: variant.identity not in rows))
    if not tasks:
        return ()
    started, progress = engine(len(tasks)), prepared.progress(rows)
    try:
        levels: dict[str, Any] = {}
        for number, done in enumerate(_condensed(first, work, started), 1):
            ended = done.answer or Condensed()
            levels[done.argument.name] = ended.levels or done.problem or "the worker process died"
            progress = replace(progress.heard(ended.complaints), rings=(number, len(first)))
            tell(progress)
        tasks = [replace(task, levels=levels.get(task.variants[0].levels)) for task in tasks]
        began, rows_of = perf_counter(), Counter(variant.identity for variant in prepared.plan.variants)
        for end in finished(tasks, work.rows, started):
            end = replace(end, rows=tuple(row for row in end.rows if row.identity not in rows))
            stored = [row for row in end.rows if row.status != NOT_STORED]
            kept.add(stored)
            rows |= {row.identity: row for row in stored}
            for row in end.rows:
                if row.status == NOT_STORED:  # the next ones would find no place either
                    raise NotStored(row.message)
            progress = progress.after(end, rows_of, perf_counter() - began)
            tell(progress)
    finally:
        started.close()
    return progress.complaints
