"""Columns of varied keys, in the units that engineers write in tables."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import nan, pi
from typing import Any

from flexbearing.case.declarations import Declaration, by_path, toml
from flexbearing.case.quantity import Kind, Section
from flexbearing.studies.plan import Plan
from flexbearing.studies.table.table import Column
from flexbearing.units import unit

UNITS = {"rad/s": "rpm", "rad": "deg", "K": "degC"}  # of SI units; all others stay
SMALL, LENGTH = ("clearance", "interference"), ("um", "mm")
DIGITS = 12  # of numbers that went through a conversion


def key_columns(plan: Plan, model: type[Section]) -> tuple[Column, ...]:
    """Columns of all varied keys of a plan whose cases were all read, by the case model."""
    rows = [(variant.values, variant.in_si) for variant in plan.variants]  # none of an empty part
    return tuple(
        _key_column(by_path(model)[key], [row[place] for row, _ in rows], [row[place] for _, row in rows])
        for place, key in enumerate(plan.base.keys)
    )


def _key_column(declaration: Declaration, values: Sequence[Any], in_si: Sequence[Any]) -> Column:
    """Column of a varied key; NaN or an empty text where a row leaves it as the case has it, or out."""
    values = [None if value == "" else value for value in values]
    if declaration.kind is None or declaration.listed:
        if None not in values and (declaration.number or bool in {*map(type, values)}):
            return Column(declaration.path, "", tuple(values), varied=True)
        if declaration.number:
            return Column(declaration.path, "", tuple(nan if v is None else v for v in values), varied=True)
        return Column(declaration.path, "", tuple(map(_text, values)), varied=True)
    name, converted = in_table(declaration.path, declaration.kind)
    both = zip(values, in_si, strict=True)
    numbers = tuple(nan if value is None else converted(number) for value, number in both)
    return Column(declaration.path, name, numbers, varied=True)


def in_table(path: str, kind: Kind) -> tuple[str, Callable[[float], float]]:
    """Unit of a quantity in the table, empty for plain numbers, and what converts to it from SI units."""
    name = _unit(path, kind.unit)
    scale = unit(name or "1")
    factor, offset = float(scale.factor * Fraction(pi) ** scale.pi_power), float(scale.offset)
    return name, lambda number: float(f"{(number - offset) / factor:.{DIGITS}g}")


def _unit(path: str, si: str) -> str:
    if si == "m":
        return LENGTH[not any(word in path.rpartition(".")[2] for word in SMALL)]
    return "" if si == "1" else UNITS.get(si, si)


def _text(value: Any) -> str:
    if value is None:
        return ""
    return value if isinstance(value, str) else toml(value)
