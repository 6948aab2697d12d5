"""The summary of a roller bearing, laid out as a page."""

from collections.abc import Iterator
from typing import Any

from rich import box
from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from flexbearing.quantities import SummaryValue
from flexbearing.quantities.roller import LAYOUT
from flexbearing.report.passage import passage
from flexbearing.report.rows import label, rows, shown, unit_of, value
from flexbearing.report.sections import (
    clearance_steps,
    closing,
    equilibria,
    held,
    life_factors,
    matrices,
    opening,
    ordered_levels,
    regimes,
    skew,
    stresses,
    tilt,
    tolerances,
)
from flexbearing.report.supports import supports


def ending(numbers: dict[str, Any]) -> str:
    """Say in a line how a run ended.

    Parameters
    ----------
    numbers : dict
        the summary

    Returns
    -------
    str
        such as ``converged in 5 iterations, 12.3 s``
    """
    count, seconds = numbers["iterations"], f"{numbers['wall_time_s']:.1f} s"
    iterations = "1 iteration" if count == 1 else f"{count} iterations"
    if numbers["status"] == "unfinished":
        return f"unfinished, {iterations} so far: {numbers['message']}"
    if numbers["status"] != "converged":
        message = f": {numbers['message']}" if numbers["message"] else ""
        how = f" ({numbers['ending']})" if numbers["status"] == "not solved" and numbers["ending"] else ""
        return f"NOT CONVERGED: {numbers['status']}{how} after {iterations}, {seconds}{message}"
    if count == 0:
        return f"converged; no part is flexible, so nothing was iterated, {seconds}"
    return f"converged in {iterations}, {seconds}"


def page(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Every section of a result, from its summary: dangers, numbers, matrices, clearance, life, notes."""
    yield from opening(numbers)
    if numbers["rigid"] or numbers["flexible"]:
        yield _table(numbers["rigid"], numbers["flexible"], numbers["error_estimate"] or {})
    yield from tilt(numbers["tilt"])
    yield from passage(numbers["passage"])
    yield from ordered_levels(numbers["choices"] or {}, numbers["error_estimate"] or {})
    yield from matrices(numbers["flexible"])
    yield from held(numbers["structure"])
    yield from equilibria(numbers["equilibria"])
    yield from regimes(numbers["regimes"])
    yield from supports(numbers["structure"])
    yield from skew({name: numbers[name] for name in ("rigid", "flexible")})
    yield from clearance_steps(numbers["clearance"])
    yield from tolerances(numbers["clearance"])
    yield from life_factors(numbers["life"])
    yield from stresses(numbers["stresses"])
    yield from closing(numbers, ending(numbers))


def _table(
    rigid: dict[str, Any] | None, flexible: dict[str, Any] | None, errors: dict[str, float | None]
) -> Table:
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    table.add_column("")
    for name in ("rigid", "flexible", *(["+-"] if errors else []), "change [%]"):
        table.add_column(name, justify="right")
    for entry in rows(LAYOUT):
        for part in entry.parts or ("",):
            before, after = (value(entry, block, part) for block in (rigid, flexible))
            if before is None and after is None and any(LAYOUT[name].optional for name in entry.of):
                continue
            # as Text: rich would take the unit in brackets for a markup tag
            error = [_error(errors, entry, after)] if errors else []
            row = (
                shown(entry, before),
                shown(entry, after),
                *error,
                _change(before, after) if entry.compared else "",
            )
            table.add_row(Text(label(entry, part)), *row)
    return table


def _error(errors: dict[str, float | None], entry: SummaryValue, number: float | None) -> str:
    """Estimated error in the unit of its row; empty where none is estimated."""
    estimate = errors.get(entry.error)
    if estimate is None or number is None:
        return ""
    error = estimate * (abs(number) if entry.error_relative else unit_of(entry).scale)
    return f"{float(f'{error:.2g}'):,.10g}"


def _change(before: float | None, after: float | None) -> str:
    if before is None or after is None or before == 0:
        return "-"
    return f"{100 * (after - before) / abs(before):+.1f}"
