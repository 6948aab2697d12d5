"""A study whose variants and columns are known: its rows, how many there are, its table."""

import glob
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

from flexbearing.case.variants import Variants
from flexbearing.families import FAMILIES
from flexbearing.studies.engine import TaskResult
from flexbearing.studies.file import Study
from flexbearing.studies.plan import Part, Plan, Row, Variant
from flexbearing.studies.plan.task import CONVERGED, NO_DAMAGE, NOT_COMPUTED, Base, file_name
from flexbearing.studies.table import Table, duty, journal
from flexbearing.studies.table.collected import Collected
from flexbearing.studies.table.duty import catalogued, duty_cycles, life_kinds
from flexbearing.studies.table.files import CYCLES, PICTURE, SCATTER, SCATTER_PICTURE, paths
from flexbearing.studies.table.keys import key_columns
from flexbearing.studies.table.table import Column, Plot, ends

Rows = Mapping[str, Row]  # by identity


@dataclass(frozen=True)
class Progress:
    """How far a study is."""

    done: int  # rows that are there
    total: int
    failed: int  # among them
    begun: int  # rows that were there at the start
    seconds: float  # since the first task began
    rings: tuple[int, int] = (0, 0)  # condensed or resolved for a target, of how many
    repeated: int = 0  # tasks whose worker process died
    complaints: tuple[str, ...] = ()  # of workers about the cache of rings, each once

    @property
    def left(self) -> float | None:
        """Time left [s], if the others take as long as those so far; None before the first."""
        new = self.done - self.begun
        return self.seconds / new * (self.total - self.done) if new else None

    def after(self, end: TaskResult, rows_of: Mapping[str, int], seconds: float) -> "Progress":
        """With a task more, whose rows are in the table as often as their variants do."""
        done = sum(rows_of[row.identity] for row in end.rows)
        failed = sum(rows_of[row.identity] for row in end.rows if not row.converged)
        return replace(
            self.heard(chain.from_iterable(row.complaints for row in end.rows)),
            done=self.done + done,
            failed=self.failed + failed,
            seconds=seconds,
            repeated=self.repeated + end.died,
        )

    def heard(self, complaints: Iterable[str]) -> "Progress":
        """With what a worker complained of."""
        return replace(self, complaints=tuple(dict.fromkeys((*self.complaints, *complaints))))


@dataclass(frozen=True)
class PreparedStudy:
    """A study whose variants and columns are known."""

    study: Study
    plan: Plan
    columns: tuple[Collected, ...]
    plot: Plot | None = None
    life_errors: tuple[str, ...] = ()  # estimated ones of the lives that a duty cycle cumulates
    part: Part | None = None  # of the study, whose variants these are

    def of_part(self, part: Part) -> "PreparedStudy":
        """A part of the study: a part of its variants."""
        variants = part.variants(self.plan.tasks(lambda variant: True))
        return replace(self, plan=replace(self.plan, variants=variants), part=part)

    @property
    def outputs(self) -> tuple[str, ...]:
        """Outputs that rows hold."""
        of_cycles = duty.texts(self.study.spectrum).values() if self.study.spectrum else ()
        of_columns = chain(*(column.texts for column in self.columns if not column.error))
        return tuple(dict.fromkeys([*of_columns, *of_cycles]))

    @property
    def texts(self) -> tuple[str, ...]:
        """What rows hold: outputs and estimated errors."""
        of_columns = (column.text for column in self.columns if column.error)
        return tuple(dict.fromkeys([*self.outputs, *of_columns, *self.life_errors]))

    def journal(self, folder: Path) -> Path:
        """Where the rows are kept as they are finished."""
        part = f".{self.part}" if self.part else ""
        return folder / f"{self.study.name}{part}{journal.SUFFIX}"

    def files(self, folder: Path) -> Path | None:
        """Folder of result files; None where the table is all that is wanted."""
        return folder / self.study.name if self.study.full else None

    def destinations(self, folder: Path) -> list[Path]:
        """All that the study writes into a folder, but what workers keep there of rings."""
        study, files = self.study, self.files(folder)
        names = dict.fromkeys(file_name(each, final=study.final) for each in self.plan.variants)
        results = [files / name for name in names] if files else []
        if self.part:
            return [self.journal(folder), *results]
        ends = ["", *([CYCLES] if study.spectrum else []), *(SCATTER if study.drawn else [])]
        tables = chain.from_iterable(paths(folder, f"{study.name}{end}").values() for end in ends)
        pictures = [*([PICTURE] if self.plot else []), *([SCATTER_PICTURE] if study.drawn else [])]
        drawn = [folder / f"{study.name}{end}" for end in pictures]
        return [self.journal(folder), *results, *tables, *drawn]

    def rows(self, folder: Path, *, retry_failed: bool = False) -> dict[str, Row]:
        """Rows of former runs and of all parts that hold all that is wanted now; answers before failures."""
        wanted, found, files = {*self.texts}, dict[str, Row](), self.files(folder)
        parts = sorted(folder.glob(f"{glob.escape(self.study.name)}.part-*-of-*{journal.SUFFIX}"))
        for path in (*parts, folder / f"{self.study.name}{journal.SUFFIX}"):
            for identity, row in journal.read(path).items():
                answered = identity in found and found[identity].converged
                if wanted <= row.values.keys() and (row.converged or not (retry_failed or answered)):
                    found[identity] = row
        if files is not None:
            stored = {
                each.identity
                for each in self.plan.variants
                if (files / file_name(each, final=self.study.final)).exists()
            }
            found = {key: row for key, row in found.items() if key in stored or row.status != CONVERGED}
        return found | self.idle_rows

    @property
    def idle_rows(self) -> dict[str, Row]:
        """Rows of a duty cycle that are not computed."""
        variants = self.plan.variants if self.study.spectrum else ()
        return {
            each.identity: Row(each.identity, NO_DAMAGE, each.idle.why, 0.0) for each in variants if each.idle
        }

    def table(self, rows: Rows) -> Table:
        """The table of the rows that there are; the others are not computed."""
        ordered = [
            rows.get(variant.identity) or Row(variant.identity, NOT_COMPUTED, "", 0.0)
            for variant in self.plan.variants
        ]
        name, axes = self.study.name, self.plan.axes
        keys = key_columns(self.plan, FAMILIES[self.study.kind].case())
        outputs = [column.values(ordered) for column in self.columns if not column.rollers]
        arrays = tuple(column.values(ordered) for column in self.columns if column.rollers)
        if self.study.full:
            outputs.append(Column("result", "", tuple(map(self._file, self.plan.variants, ordered))))
        if self.study.spectrum is None or self.part:
            return Table(name, (*keys, *outputs, *ends(ordered)), axes, arrays=arrays)
        length, spectrum = len(axes[-1].rows), self.study.spectrum
        catalogue = catalogued(self.plan, FAMILIES[self.study.kind], spectrum, self._case)
        cycles = replace(
            duty_cycles(self.plan, spectrum, ordered, self.speeds, self.life_errors, catalogue),
            kinds=tuple(life_kinds(self.plan, spectrum, self._case)),
        )
        ordered = [
            replace(row, findings=(*row.findings, *of_cycle))
            for row, of_cycle in zip(ordered, cycles.findings(), strict=True)
        ]
        others = [
            replace(column, values=column.values[::length])
            for column in keys
            if column.name not in axes[-1].keys
        ]
        lives = Table(f"{name}{CYCLES}", (*others, *cycles.of_cycles()), axes[:-1])
        return Table(name, (*keys, *outputs, *cycles.of_rows(), *ends(ordered)), axes, lives, arrays)

    def _file(self, variant: Variant, row: Row) -> str:
        """Result file of a row, from the folder of the table; empty where there is none."""
        return (
            f"{self.study.name}/{file_name(variant, final=self.study.final)}"
            if row.status == CONVERGED
            else ""
        )

    @property
    def speeds(self) -> np.ndarray:
        """Speed of the inner ring against the outer one of each variant [rad/s]."""
        return np.array([each.idle.speed if each.idle else self._speed(each) for each in self.plan.variants])

    def _speed(self, variant: Variant) -> float:
        operation = self._case(variant).operation
        return operation.inner_speed - operation.outer_speed

    def _case(self, variant: Variant) -> Any:
        """The case of a variant that is not idle."""
        return variants_of(self.plan.base).known(variant.values, variant.in_si)

    def progress(self, rows: Rows) -> Progress:
        """How far some rows are."""
        there = [row for variant in self.plan.variants if (row := rows.get(variant.identity))]
        failed = sum(not row.converged for row in there)
        return Progress(len(there), len(self.plan.variants), failed, len(there), 0.0)


@lru_cache(maxsize=4)
def variants_of(base: Base) -> Variants:
    """Cases of a study, whose file is parsed once."""
    return Variants(base.path, base.text, base.keys, FAMILIES, base.settings)
