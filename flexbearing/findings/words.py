"""The sentence of a finding, made of its record at the very end."""

from collections.abc import Mapping, Sequence
from typing import Any

from flexbearing.findings.declared import of_code
from flexbearing.units import unit


def text(record: Mapping[str, Any], places: Sequence[str] = ()) -> str:
    """Quantity, value, limit with its source, and what it means."""
    finding = of_code(record["code"], record["grade"])
    where = ", ".join(filter(None, (finding.label, " and ".join(filter(None, places or [record["place"]])))))
    value, limit = (_number(record[name], finding.shown) for name in ("value", "limit"))
    return f"{where}: {value}, {record['side']} {limit} ({record['source']}): {finding.meaning}"


def _number(value: float, shown: str) -> str:
    """A value in SI units as people write it."""
    number = unit(shown).of_si(value) if shown else value
    return f"{number:{',.0f' if abs(number) >= 1e3 else '.3g'}} {shown}".rstrip()
