"""Sentences of findings and notes, made of their data at the very end."""

from collections.abc import Mapping, Sequence
from typing import Any

from flexbearing.findings.finding import Finding
from flexbearing.units import unit


def text(finding: Finding, values: Sequence[float], limit: float, places: Sequence[str], source: str) -> str:
    """Quantity, value or range of values, limit with its source, and what it means."""
    where = f"{finding.label}, {' and '.join(places)}" if places else finding.label
    value, at = (_numbers(each, finding.shown) for each in (values, [limit]))
    return f"{where}: {value}, {finding.side} {at} ({source}): {finding.meaning}"


def settings(keys: Mapping[str, str]) -> str:
    """Keys and values as on a command line.

    >>> settings({"bearing.contact": "half_space", "life.edge_stress": ""})
    'bearing.contact=half_space, life.edge_stress'
    """
    return ", ".join(f"{key}={value}" if value else key for key, value in keys.items())


def of_note(record: Mapping[str, Any]) -> str:
    """Text of the record of a note, with its keys."""
    return f"{record['text']} ({settings(keys)})" if (keys := record.get("keys")) else record["text"]


def _numbers(values: Sequence[float], shown: str) -> str:
    """The least and the greatest of values in SI units as people write them, or the only one."""
    numbers = [unit(shown).of_si(value) if shown else value for value in values]
    ends = (f"{each:{',.0f' if abs(each) >= 1e3 else '.3g'}}" for each in (min(numbers), max(numbers)))
    return f"{' to '.join(dict.fromkeys(ends))} {shown}".rstrip()
