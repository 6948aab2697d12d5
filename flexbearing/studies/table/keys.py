"""Columns of varied keys, in the units that engineers write in tables."""

from collections.abc import Sequence
from fractions import Fraction
from math import nan, pi
from typing import Any

from flexbearing.case.declarations import Declaration, by_path, toml
from flexbearing.case.quantity import Section
from flexbearing.studies.plan import Plan
from flexbearing.studies.table.column import Column
from flexbearing.units import unit

UNITS = {"N": "N", "N m": "N m", "rad/s": "rpm", "K": "degC"}  # of SI units; all others stay
SMALL, LENGTH = ("clearance", "interference"), ("um", "mm")
DIGITS = 12  # of numbers that went through a conversion


def key_columns(plan: Plan, model: type[Section]) -> tuple[Column, ...]:
    """Columns of all varied keys of a plan, by the case model."""
    columns = zip(*(variant.values for variant in plan.variants), strict=True)
    keys = zip(plan.base.keys, columns, strict=True)
    return tuple(key_column(by_path(model)[key], values) for key, values in keys)


def key_column(declaration: Declaration, values: Sequence[Any]) -> Column:
    """Column of a varied key.

    Parameters
    ----------
    declaration : Declaration
        of the key
    values : sequence
        row by row, in the words of a case file; None where a row leaves the key as the case has it

    Returns
    -------
    Column
        of numbers, or of texts where the key is no quantity and no number; NaN or an empty text for None
    """
    kind = declaration.kind
    if kind is None or declaration.listed:
        if None not in values and (declaration.number or bool in {*map(type, values)}):
            return Column(declaration.path, "", tuple(values), varied=True)
        if declaration.number:
            return Column(declaration.path, "", tuple(nan if v is None else v for v in values), varied=True)
        return Column(declaration.path, "", tuple(map(_text, values)), varied=True)
    name = _unit(declaration.path, kind.unit)
    scale = unit(name or "1")
    factor, offset = float(scale.factor * Fraction(pi) ** scale.pi_power), float(scale.offset)
    known: dict[Any, float] = {None: nan}
    for value in values:
        if value not in known:
            known[value] = float(f"{(kind.to_si(value) - offset) / factor:.{DIGITS}g}")
    return Column(declaration.path, name, tuple(known[value] for value in values), varied=True)


def _unit(path: str, si: str) -> str:
    if si == "m":
        return LENGTH[not any(word in path.rpartition(".")[2] for word in SMALL)]
    return "" if si == "1" else UNITS.get(si, si)


def _text(value: Any) -> str:
    if value is None:
        return ""
    return value if isinstance(value, str) else toml(value)
