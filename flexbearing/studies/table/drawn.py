"""Columns that a picture needs, beside those that are collected."""

from collections.abc import Mapping
from typing import Any

from pydantic_core import PydanticCustomError

from flexbearing import inputs
from flexbearing.case import BadCase
from flexbearing.case.declarations import Declaration, by_path
from flexbearing.case.family import Families
from flexbearing.outputs import UnknownOutput, WrongUnit, requested
from flexbearing.outputs.value import conversion
from flexbearing.printable import excerpt
from flexbearing.studies.file import Study
from flexbearing.studies.file.schema import MarkTable
from flexbearing.studies.file.values import BadValues
from flexbearing.studies.table.collected import Collected, of_output, of_text
from flexbearing.studies.table.keys import in_table
from flexbearing.studies.table.table import Mark, Plot


def drawn(
    study: Study, columns: tuple[Collected, ...], families: Families
) -> tuple[Plot | None, tuple[Collected, ...]]:
    """What the table [plot] draws, and all columns with those that it needs.

    Raises `BadCase` for a name that is no key, no column and no output.
    """
    if study.plot is None:
        return None, columns
    needed, given = _Columns(study, families, {column.column: column for column in columns}), study.plot
    if given.lines is not None and given.lines not in study.keys:
        raise BadCase(
            f"{study.path.name}: [plot] lines = {excerpt(given.lines)} is no key that varies; it must be "
            f"{' or '.join(study.keys)}."
        )
    x = given.x if given.x in study.keys else needed.named(given.x)
    y = tuple(map(needed.named, given.y))
    rigid = tuple(needed.between_rigid_raceways(name) if given.rigid else None for name in y)
    if len({bool(name in needed.columns and needed.columns[name].rollers) for name in (x, *y)}) > 1:
        raise BadCase(
            f"{study.path.name}: [plot] x and y must both have a number for every roller, or both one; "
            'x = "roller_azimuth [deg]" as a column of [collect] stands with the former.'
        )
    panels = {name: needed.columns[column] for name, column in zip(given.y, y, strict=True)}
    along = by_path(families[study.kind].case())[x] if x in study.keys else needed.columns[x].unit
    try:
        found = tuple(mark(each, panels, along) for each in given.marks)
    except BadValues as problem:
        raise BadCase(f"{study.path.name}: [plot] marks: {problem}") from None
    return Plot(x, given.lines, y, rigid, found), tuple(needed.columns.values())


class _Columns:
    """Columns by their names, which grow as more are needed."""

    def __init__(self, study: Study, families: Families, columns: dict[str, Collected]):
        self.columns = columns
        self._file, self._layout = study.path.name, families[study.kind].layout()

    def named(self, text: str) -> str:
        """Name of the column of that name, or of an output."""
        if text in self.columns:
            return text
        try:
            output = requested(self._layout, text)
        except (UnknownOutput, WrongUnit) as problem:
            known = ", ".join(self.columns)
            raise BadCase(
                f"{self._file}: [plot] {problem} Columns of [collect]: {known or 'none'}."
            ) from None
        return self._added(output.name, of_output(output.name, output))

    def between_rigid_raceways(self, name: str) -> str | None:
        """Name of the column of the same output between rigid raceways; None for a quotient."""
        if self.columns[name].over:
            return None
        if rollers := self.columns[name].rollers:
            output, _, unit = self.columns[name].text.rpartition(".")[2].partition(" ")
            text = f"rigid.{output} {unit}"
            return self._added(f"{name}_rigid", of_text(f"{name}_rigid", text, self._layout, rollers))
        output = requested(self._layout, self.columns[name].text)
        rigid = requested(self._layout, f"rigid.{output.output.name} [{output.unit}]")
        return self._added(f"{name}_rigid", of_output(f"{name}_rigid", rigid))

    def _added(self, name: str, column: Collected) -> str:
        for other in self.columns.values():
            if other.texts == column.texts and other.unit == column.unit:
                return other.column
        self.columns[name] = column
        return name


def mark(given: MarkTable, panels: Mapping[str, Collected], along: Declaration | str) -> Mark:
    """Convert a mark to the units of a picture.

    Raises `BadValues` for another panel, or what is no number or has a unit of another kind.
    """
    if given.y not in panels:
        raise BadValues(f"y = {excerpt(given.y)} has no panel; it must be {' or '.join(panels)}.")
    column = panels[given.y]
    ends = [_number(text, column.unit) for text in given.value.split("..")]
    if len(ends) > 2:
        raise BadValues(f'value = {excerpt(given.value)} is no number and no range "FROM .. TO".')
    place = None if given.x is None else _place(given.x, along)
    return Mark(column.column, min(ends), max(ends), place, f"{given.label} ({given.source})")


def _place(text: str, along: Declaration | str) -> Any:
    if isinstance(along, str):
        return _number(text, along)
    if along.kind is None:
        return _number(text, "1") if along.number else text
    try:
        return in_table(along.path, along.kind)[1](along.kind.to_si(text))
    except PydanticCustomError as problem:
        raise BadValues(f"x = {excerpt(text)} {problem.message()}") from None


def _number(text: str, unit: str) -> float:
    number, _, given = text.strip().partition(" ")
    try:
        return inputs.number(number) / conversion(unit or "1", given.strip() or "1").factor
    except ValueError as problem:  # BadNumber, WrongUnit and BadUnit are such
        raise BadValues(f"{excerpt(text.strip())}: {problem}") from None
