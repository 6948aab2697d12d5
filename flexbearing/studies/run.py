"""The computing of a study: what is still lacking, by an engine, into journal and table."""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from time import perf_counter

from flexbearing.families import FAMILIES
from flexbearing.files import NotStored, require_folder, require_output
from flexbearing.studies.engine import Engine, condensed, finished
from flexbearing.studies.file import Study
from flexbearing.studies.plan import Plan, Ring, Row, Task
from flexbearing.studies.table import Table, journal
from flexbearing.studies.table.collected import Collected
from flexbearing.studies.table.column import ends
from flexbearing.studies.table.files import places, store
from flexbearing.studies.table.keys import key_columns

NOT_COMPUTED = "not computed"  # status of a row whose variant is still to come
Rows = Mapping[str, Row]  # by identity


@dataclass(frozen=True)
class Progress:
    """How far a study is."""

    done: int  # rows that are there
    total: int
    failed: int  # among them
    begun: int  # rows that were there at the start
    seconds: float  # since the first task began
    rings: tuple[int, int] = (0, 0)  # condensed, of how many

    @property
    def left(self) -> float | None:
        """Time left [s], if the others take as long as those so far; None before the first."""
        new = self.done - self.begun
        return self.seconds / new * (self.total - self.done) if new else None

    def after(self, rows: Sequence[Row], rows_of: Mapping[str, int], seconds: float) -> "Progress":
        """With some rows more, each of which stands in the table as often as its variant does."""
        done = sum(rows_of[row.identity] for row in rows)
        failed = sum(rows_of[row.identity] for row in rows if not row.converged)
        return replace(self, done=self.done + done, failed=self.failed + failed, seconds=seconds)


Tell = Callable[[Progress], None]


@dataclass(frozen=True)
class Work:
    """What workers do; both functions can be pickled."""

    rows: Callable[[Task], Sequence[Row]]
    condense: Callable[[Ring], None]


@dataclass(frozen=True)
class Prepared:
    """A study whose variants and columns are settled."""

    study: Study
    plan: Plan
    columns: tuple[Collected, ...]

    @property
    def texts(self) -> tuple[str, ...]:
        """Outputs that rows hold."""
        return tuple(dict.fromkeys(column.text for column in self.columns))

    def journal(self, folder: Path) -> Path:
        """Where the rows are kept as they are finished."""
        return folder / f"{self.study.name}{journal.SUFFIX}"

    def rows(self, folder: Path, *, retry_failed: bool = False) -> dict[str, Row]:
        """Rows of former runs that hold all that is wanted now."""
        wanted = {*self.texts}
        return {
            row.identity: row
            for row in journal.read(self.journal(folder)).values()
            if wanted <= row.values.keys() and (row.converged or not retry_failed)
        }

    def table(self, rows: Rows) -> Table:
        """The table of the rows that there are; the others are not computed."""
        ordered = [
            rows.get(variant.identity) or Row(variant.identity, NOT_COMPUTED, "", 0.0)
            for variant in self.plan.variants
        ]
        keys = key_columns(self.plan, FAMILIES[self.study.kind].case())
        outputs = (column.values(ordered) for column in self.columns)
        return Table(self.study.name, (*keys, *outputs, *ends(ordered)), self.plan.axes)

    def progress(self, rows: Rows) -> Progress:
        """How far some rows are."""
        there = [row for variant in self.plan.variants if (row := rows.get(variant.identity))]
        failed = sum(not row.converged for row in there)
        return Progress(len(there), len(self.plan.variants), failed, len(there), 0.0)


def run(
    settled: Prepared,
    output: Path,
    work: Work,
    engine: Callable[[int], Engine],
    *,
    retry_failed: bool = False,
    tell: Tell = lambda progress: None,
) -> Table:
    """Compute what a study still lacks, and write its table.

    Parameters
    ----------
    settled : Prepared
        the study
    output : Path
        folder
    work : Work
        what is called for rings and tasks
    engine : callable (tasks)
        starts where it is called; not asked where nothing is lacking
    retry_failed : bool
        whether rows that failed are computed again
    tell : callable (Progress), optional
        hears of every task that is finished

    Returns
    -------
    Table

    Raises
    ------
    BadOutput
        for a folder that cannot be written, or where the same study runs already
    NotStored
        when there is no room left; what is finished stays
    """
    folder, inputs = require_folder(output), settled.study.inputs
    paths = places(folder, settled.study.name, inputs)
    path = require_output(settled.journal(folder), inputs)
    rows: dict[str, Row] = {}
    try:
        with journal.opened(path, settled.texts) as kept:
            rows |= settled.rows(folder, retry_failed=retry_failed)
            tell(settled.progress(rows))
            _compute(settled, rows, work, engine, kept, tell)
    except BaseException as problem:
        if rows:
            done = settled.progress(rows)
            problem.add_note(
                f"{done.done} of {done.total} variants are kept, the same study goes on from there"
            )
            with suppress(NotStored):
                store(settled.table(rows), paths)
        raise
    table = settled.table(rows)
    store(table, paths)
    return table


def _compute(
    settled: Prepared,
    rows: dict[str, Row],
    work: Work,
    engine: Callable[[int], Engine],
    kept: journal.Journal,
    tell: Tell,
) -> None:
    """Add the rows that are lacking, task by task."""
    tasks = settled.plan.tasks(lambda variant: variant.identity not in rows)
    rings = settled.plan.rings(lambda variant: variant.identity not in rows)
    if not tasks:
        return
    started, progress = engine(len(tasks)), settled.progress(rows)
    try:
        for number, _ in enumerate(condensed(rings, work.condense, started), 1):
            progress = replace(progress, rings=(number, len(rings)))
            tell(progress)
        began, rows_of = perf_counter(), Counter(variant.identity for variant in settled.plan.variants)
        for new in finished(tasks, work.rows, started):
            kept.add(new)
            rows |= {row.identity: row for row in new}
            progress = progress.after(new, rows_of, perf_counter() - began)
            tell(progress)
    finally:
        started.close()
