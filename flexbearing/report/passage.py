"""What the summary says of other positions of the rollers."""

from collections.abc import Iterator
from typing import Any

from rich.console import RenderableType
from rich.text import Text

from flexbearing.quantities import SummaryValue
from flexbearing.quantities.roller import LAYOUT
from flexbearing.report.rows import label, rows, shown, unit_of
from flexbearing.report.sections import right_aligned


def passage(passed: dict[str, Any] | None) -> Iterator[RenderableType]:
    """Smallest and largest of every number that changes over a pitch; nothing for one position."""
    if not passed:
        return
    azimuths, life = passed["azimuth_deg"], passed["mean_life_Mrev"]
    yield Text(f"rollers passing a pitch: {len(azimuths)} positions", style="bold")
    table = right_aligned("", "smallest", "at [deg]", "largest", "at [deg]")
    for entry in rows(LAYOUT):
        for part in entry.parts or ("",):
            column = passed["values"].get(f"{entry.key}.{part}" if part else entry.key, [])
            scale = unit_of(entry).scale if entry.in_si else 1.0
            known = [(scale * number, place) for number, place in zip(column, azimuths, strict=False)
                     if number is not None]  # fmt: skip
            if known:
                (least, at_least), (most, at_most) = _end(entry, *min(known)), _end(entry, *max(known))
                if least != most:
                    table.add_row(Text(label(entry, part)), least, at_least, most, at_most)
    yield table
    failed = sum(status != "converged" for status in passed["status"])
    yield Text(
        ("" if life is None else f"life by equal damage of all positions: {life:,.4g} Mrev")
        + (f"; {failed} positions were not solved" if failed else "")
    )
    yield Text("")


def _end(entry: SummaryValue, number: float, place: float) -> tuple[str, str]:
    """A number with its azimuth."""
    whole = entry.digits.endswith("d")
    return shown(entry, int(number) if whole else number), f"{place:.4g}"
