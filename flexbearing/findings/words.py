"""The sentence of a finding, made of its numbers at the very end."""

from collections.abc import Sequence

from flexbearing.findings.finding import Finding
from flexbearing.units import unit


def text(finding: Finding, values: Sequence[float], limit: float, places: Sequence[str], source: str) -> str:
    """Quantity, value or range of values, limit with its source, and what it means."""
    where = f"{finding.label}, {' and '.join(places)}" if places else finding.label
    value, at = (_numbers(each, finding.shown) for each in (values, [limit]))
    return f"{where}: {value}, {finding.side} {at} ({source}): {finding.meaning}"


def _numbers(values: Sequence[float], shown: str) -> str:
    """The least and the greatest of values in SI units as people write them, or the only one."""
    numbers = [unit(shown).of_si(value) if shown else value for value in values]
    ends = (f"{each:{',.0f' if abs(each) >= 1e3 else '.3g'}}" for each in (min(numbers), max(numbers)))
    return f"{' to '.join(dict.fromkeys(ends))} {shown}".rstrip()
