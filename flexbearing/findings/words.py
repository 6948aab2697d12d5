"""The sentence of a finding, made of its record at the very end."""

from collections.abc import Mapping, Sequence
from typing import Any

from flexbearing.findings.declared import of_code
from flexbearing.units import unit


def text(record: Mapping[str, Any], places: Sequence[str] = (), values: Sequence[float] = ()) -> str:
    """Quantity, value or range of values, limit with its source, and what it means."""
    finding = of_code(record["code"], record["grade"])
    known = {"side": finding.side, "source": finding.source, **record}
    where = f"{finding.label}, {' and '.join(places)}" if places else finding.label
    value, limit = (_numbers(each, finding.shown) for each in (values or [known["value"]], [known["limit"]]))
    return f"{where}: {value}, {known['side']} {limit} ({known['source']}): {finding.meaning}"


def _numbers(values: Sequence[float], shown: str) -> str:
    """The least and the greatest of values in SI units as people write them, or the only one."""
    numbers = [unit(shown).of_si(value) if shown else value for value in values]
    ends = (f"{each:{',.0f' if abs(each) >= 1e3 else '.3g'}}" for each in (min(numbers), max(numbers)))
    return f"{' to '.join(dict.fromkeys(ends))} {shown}".rstrip()
