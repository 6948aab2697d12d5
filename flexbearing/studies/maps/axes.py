"""Axes of a map, from the words of `--over`."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np

from flexbearing.case import BadCase, Head
from flexbearing.case.declarations import Declaration, find
from flexbearing.case.problems import nearest
from flexbearing.families import FAMILIES
from flexbearing.printable import excerpt
from flexbearing.studies.file.values import BadValues, values
from flexbearing.studies.table.keys import in_table

FORM = 'it is KEY=FROM..TO,N, such as "operation.radial_load=500 N..20 kN,100"'
MOST_AXES, MOST = 3, 1_000_000  # axes; points


@dataclass(frozen=True)
class MapAxis:
    """A key of the case and its values."""

    declaration: Declaration
    values: Sequence[Any]  # in the words of a case file, as they were given
    unit: str = ""  # of `numbers`; empty for plain numbers
    numbers: tuple[float, ...] = ()  # the same for people

    @property
    def key(self) -> str:
        """Dotted name."""
        return self.declaration.path

    @property
    def column(self) -> str:
        """Heading in a table."""
        return f"{self.key} [{self.unit}]" if self.unit else self.key

    @property
    def words(self) -> str:
        """Name and unit as a picture has them."""
        name = self.key.rpartition(".")[2].replace("_", " ")
        return f"{name} [{self.unit}]" if self.unit else name

    @property
    def logarithmic(self) -> bool:
        """Whether the values grow by factors."""
        if len(self.numbers) < 3 or min(self.numbers) <= 0:
            return False
        steps = np.diff(np.log(self.numbers))
        return bool(np.allclose(steps, steps[0], rtol=1e-6, atol=0))


def axes(over: Sequence[str], model: type[Head]) -> tuple[MapAxis, ...]:
    """Axes of a map.

    Raises `BadCase` naming the key and what is wrong with it.
    """
    if not 1 <= len(over) <= MOST_AXES:
        raise BadCase(f"--over is given {len(over)} times; a map has one to three axes")
    found = tuple(_axis(text, model) for text in over)
    keys = [axis.key for axis in found]
    if twice := [key for key in keys if keys.count(key) > 1]:
        raise BadCase(f"--over {twice[0]}: the key is varied twice")
    if (count := prod(len(axis.values) for axis in found)) > MOST:
        raise BadCase(f"--over gives {count} points; a map has at most {MOST}")
    return found


def _axis(text: str, model: type[Head]) -> MapAxis:
    key, equals, span = (part.strip() for part in text.partition("="))
    if not equals or ".." not in span:
        raise BadCase(f"--over {excerpt(text)}: {FORM}")
    declaration = find(key, model)
    if declaration is None:
        raise BadCase(f"--over {excerpt(key)} is not a key of the case.{nearest(key, model, FAMILIES)}")
    if declaration.listed or declaration.section or not (declaration.kind or declaration.number):
        raise BadCase(f"--over {key}: a map is over keys that are numbers")
    try:
        return MapAxis(declaration, values(span, declaration))
    except BadValues as problem:
        raise BadCase(f"--over {key} {problem}") from None


def with_numbers(axis: MapAxis, in_si: Sequence[float]) -> MapAxis:
    """The same axis with its values in the unit of tables, from those in SI units that cases have."""
    if axis.declaration.kind is None:
        return MapAxis(axis.declaration, axis.values, "", tuple(map(float, in_si)))
    unit, converted = in_table(axis.key, axis.declaration.kind)
    return MapAxis(axis.declaration, axis.values, unit, tuple(converted(value) for value in in_si))
