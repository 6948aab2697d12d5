"""Numbers from elsewhere that a picture of a study shows, in the units of its axes."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from pydantic_core import PydanticCustomError

from flexbearing import inputs
from flexbearing.case.declarations import Declaration
from flexbearing.outputs.value import conversion
from flexbearing.printable import excerpt
from flexbearing.studies.file.schema import MarkTable
from flexbearing.studies.file.values import BadValues
from flexbearing.studies.table.collected import Collected
from flexbearing.studies.table.keys import in_table


@dataclass(frozen=True)
class Mark:
    """A printed or measured number."""

    y: str  # column of its panel
    low: float  # in the unit of the panel
    high: float  # the same as `low` but for a range
    x: Any  # in the unit of the axis; None where it is not known
    label: str


def mark(given: MarkTable, panels: Mapping[str, Collected], along: Declaration | str) -> Mark:
    """Convert a mark to the units of a picture.

    Raises
    ------
    BadValues
        for another panel, or what is no number or has a unit of another kind
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
