"""The summary of a result, laid out as a page."""

from collections.abc import Iterator
from math import hypot
from typing import Any

from rich import box
from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from flexbearing.quantities import SummaryValue
from flexbearing.quantities.four_point import TORQUE_PARTS
from flexbearing.quantities.layout import Layout
from flexbearing.report.catalogue_life import against_catalogue
from flexbearing.report.rows import formatted, label, of_supports, rows, shown, unit_of, value
from flexbearing.report.sections import (
    clearance_steps,
    closing,
    contacts,
    equilibria,
    held,
    life_factors,
    listed,
    matrices,
    opening,
    ordered_levels,
    probes,
    regimes,
    right_aligned,
    skew,
    stresses,
    tilt,
    tolerances,
)

TABLES = ("", "compared"), ("ring",)  # sections of the layout that share a table of numbers


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
    if count:
        return f"converged in {iterations}, {seconds}"
    return f"converged: {numbers['message']}, {seconds}"


def page(layout: Layout, numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Every section of a result, from its summary: dangers, numbers, matrices, clearance, life, notes."""
    known = numbers.get  # a family has some of the sections
    yield from opening(numbers)
    states = by_state(numbers, {name: numbers[name] for name in ("rigid", "flexible")})
    last = numbers["flexible"] or numbers["rigid"] or {}
    if any(states.values()):
        tables = (_table(layout, states, known("error_estimate") or {}, sections) for sections in TABLES)
        yield from (table for table in tables if table.rows)
    yield from tilt(known("tilt"))
    yield from _torque_parts(last)
    yield from contacts(layout, states)
    yield from passage(layout, known("passage"))
    yield from ordered_levels(known("choices") or {}, known("error_estimate") or {})
    yield from matrices(last)
    yield from held(known("structure"))
    yield from equilibria(by_state(numbers, known("equilibria")))
    yield from regimes(by_state(numbers, known("regimes") or {}))
    yield from supports(known("structure"))
    yield from skew(layout, states)
    yield from clearance_steps(known("clearance") or {})
    yield from tolerances(known("clearance") or {})
    yield from life_factors(by_state(numbers, known("life")) or {})
    yield from against_catalogue(known("catalogue_life"))
    yield from stresses(known("stresses"))
    yield from probes(last.get("probes"))
    yield from closing(numbers, ending(numbers))


def by_state(numbers: dict[str, Any], blocks: Any) -> Any:
    """What is said of the rigid and of the flexible state; of one where no part is flexible."""
    alone = numbers["flexible"] is None and numbers["status"] == "converged"
    same = alone or numbers["flexible"] == numbers["rigid"]
    return {"rigid rings": next(iter(blocks.values()))} if blocks and same else blocks


def _table(
    layout: Layout,
    states: dict[str, dict[str, Any] | None],
    errors: dict[str, float | None],
    sections: tuple[str, ...],
) -> Table:
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    table.add_column("")
    compared = len(states) > 1
    for name in (*states, *(["+-"] if errors else []), *(["change [%]"] if compared else [])):
        table.add_column(name, justify="right")
    for entry in (entry for section in sections for entry in rows(layout, section)):
        if "flexible" not in states and of_supports(entry):
            continue
        for part in entry.parts or ("",):
            values = [value(entry, block, part) for block in states.values()]
            if all(one is None for one in values) and any(layout[name].optional for name in entry.of):
                continue
            row = [shown(entry, one) for one in values]
            if errors:
                row.append(_error(errors, entry, values[-1]))
            if compared:
                row.append(_change(values[0], values[-1]) if entry.compared else "")
            # as Text: rich would take the unit in brackets for a markup tag
            table.add_row(Text(label(entry, part)), *row)
    return table


def _torque_parts(block: dict[str, Any]) -> Iterator[RenderableType]:
    """Causes of the torque of slow balls."""
    if "torque_formula" not in block:
        return
    words = f"torque in parts [N m]; that of the bearing by the {block['torque_formula']} formula"
    yield Text(words, "bold")
    table = right_aligned("", "all balls", "mean ball", "most loaded ball")
    columns = ("torque_parts_Nm", "mean_ball_torque_parts_Nm", "largest_ball_torque_parts_Nm")
    for part in TORQUE_PARTS:
        table.add_row(part, *(formatted(block[column][part], ".5g") for column in columns))
    table.add_row("total, circumferential", formatted(block["circumferential_torque_Nm"], ".5g"), "", "")
    yield table


def _error(errors: dict[str, float | None], entry: SummaryValue, number: float | None) -> str:
    """Estimated error in the unit of its row; empty where none is estimated."""
    estimate = errors.get(entry.error)
    if estimate is None or number is None:
        return ""
    error = estimate * (abs(number) if entry.error_relative else unit_of(entry).scale)
    return f"{float(f'{error:.2g}'):,.10g}"


def _change(before: Any, after: Any) -> str:
    if isinstance(before, list) or before is None or after is None or before == 0:
        return "-"
    return f"{100 * (after - before) / abs(before):+.1f}"


def passage(layout: Layout, passed: dict[str, Any] | None) -> Iterator[RenderableType]:
    """Smallest and largest of every number that changes over a pitch; nothing for one position."""
    if not passed:
        return
    azimuths, life = passed["azimuth_deg"], passed["mean_life_Mrev"]
    yield Text(f"rollers passing a pitch: {len(azimuths)} positions", style="bold")
    table = right_aligned("", "smallest", "at [deg]", "largest", "at [deg]")
    for entry in rows(layout):
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


SHEARED = 1e-4  # of the rollers' force: what radial springs leave to tangential ones


def supports(structure: dict[str, Any] | None) -> Iterator[RenderableType]:
    """Forces of lines or pressure of a foundation; nothing for a ring that is held otherwise."""
    outer = (structure or {}).get("outer", {})
    if "lines" in outer:
        yield from _lines(outer["lines"])
    if "foundation" in outer:
        yield from listed("foundation of the outer ring", _foundation(outer["foundation"]))


def _lines(lines: dict[str, Any]) -> Iterator[RenderableType]:
    can = "push and pull" if lines["pull"] else "push only"
    yield Text(f"lines that hold the outer ring: they {can}", style="bold")
    table = right_aligned("line [deg]", "force [N]")
    table.add_column("")
    for place, azimuth in enumerate(lines["azimuth_deg"]):
        force, carries = lines["force_N"][place], lines["carries"][place]
        state = ("pushes" if force > 0 else "pulls") if carries else "lifted off"
        table.add_row(f"{azimuth:.1f}", f"{force:,.1f}", state)
    yield table
    yield from listed("together", [_balance(lines)])


def _foundation(springs: dict[str, Any]) -> list[str]:
    can = "push and pull" if springs["pull"] else "push only"
    arcs = ", ".join(f"{begin:.0f} to {end % 360:.0f} deg" for begin, end in springs["touching_deg"])
    least = springs["least_pressure_MPa"]
    return [
        f"springs {can}; largest pressure {springs['largest_pressure_MPa']:.3g} MPa at "
        f"{springs['azimuth_deg']:.0f} deg, x = {springs['x_mm']:.1f} mm",
        f"pushes at azimuths {arcs or 'none'}; {100 * springs['open_share']:.0f} % of the surface "
        + (f"is pulled, by up to {-least:.3g} MPa" if least < 0 else "is lifted off"),
        _balance(springs),
    ]


def _balance(held: dict[str, Any]) -> str:
    (y, z), (along_y, along_z) = held["resultant_N"], held["rollers_N"]
    rest = hypot(along_y - y, along_z - z) > SHEARED * hypot(along_y, along_z)
    return (
        f"radial forces hold ({y:,.1f}, {z:,.1f}) N along (y, z) of ({along_y:,.1f}, {along_z:,.1f}) N "
        "of the bearing" + (", tangential springs the rest" if rest else "")
    )
