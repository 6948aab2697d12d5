"""The summary of a roller bearing, laid out as a page."""

from collections.abc import Iterator
from typing import Any

from rich import box
from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from flexbearing.quantities import SummaryValue
from flexbearing.quantities.roller import LAYOUT
from flexbearing.report.catalogue_life import against_catalogue
from flexbearing.report.passage import passage
from flexbearing.report.rows import label, of_supports, rows, shown, unit_of, value
from flexbearing.report.sections import (
    clearance_steps,
    closing,
    contacts,
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
    """Say in a line how a run ended."""
    count, seconds = numbers["iterations"], f"{numbers['wall_time_s']:.1f} s"
    iterations = "1 iteration" if count == 1 else f"{count} iterations"
    if numbers["status"] == "unfinished":
        return f"unfinished, {iterations} so far: {numbers['message']}"
    if numbers["status"] != "converged":
        message = f": {numbers['message']}" if numbers["message"] else ""
        how = f" ({numbers['ending']})" if numbers["status"] == "not solved" and numbers["ending"] else ""
        return f"NOT CONVERGED: {numbers['status']}{how} after {iterations}, {seconds}{message}"
    if count == 0:
        return f"converged; no part is flexible, so no iterations, {seconds}"
    return f"converged in {iterations}, {seconds}"


def page(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Every section of a result, from its summary: dangers, numbers, matrices, clearance, life, notes."""
    yield from opening(numbers)
    states = by_state(numbers, {name: numbers[name] for name in ("rigid", "flexible")})
    if any(states.values()):
        yield _table(states, numbers["error_estimate"] or {})
    yield from tilt(numbers["tilt"])
    yield from contacts(states)
    yield from passage(numbers["passage"])
    yield from ordered_levels(numbers["choices"] or {}, numbers["error_estimate"] or {})
    yield from matrices(numbers["flexible"])
    yield from held(numbers["structure"])
    yield from equilibria(by_state(numbers, numbers["equilibria"]))
    yield from regimes(by_state(numbers, numbers["regimes"]))
    yield from supports(numbers["structure"])
    yield from skew(states)
    yield from clearance_steps(numbers["clearance"])
    yield from tolerances(numbers["clearance"])
    yield from life_factors(by_state(numbers, numbers["life"]))
    yield from against_catalogue(numbers["catalogue_life"])
    yield from stresses(numbers["stresses"])
    yield from closing(numbers, ending(numbers))


def by_state(numbers: dict[str, Any], blocks: dict[str, Any]) -> dict[str, Any]:
    """What is said of the rigid and of the flexible state; of one where no part is flexible."""
    same = numbers["flexible"] and not numbers["iterations"]
    return {"rigid rings": next(iter(blocks.values()))} if blocks and same else blocks


def _table(states: dict[str, dict[str, Any] | None], errors: dict[str, float | None]) -> Table:
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    table.add_column("")
    compared = len(states) > 1
    for name in (*states, *(["+-"] if errors else []), *(["change [%]"] if compared else [])):
        table.add_column(name, justify="right")
    for entry in rows(LAYOUT):
        if "flexible" not in states and of_supports(entry):
            continue
        for part in entry.parts or ("",):
            values = [value(entry, block, part) for block in states.values()]
            if all(one is None for one in values) and any(LAYOUT[name].optional for name in entry.of):
                continue
            row = [shown(entry, one) for one in values]
            if errors:
                row.append(_error(errors, entry, values[-1]))
            if compared:
                row.append(_change(values[0], values[-1]) if entry.compared else "")
            # as Text: rich would take the unit in brackets for a markup tag
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
