"""The summaries of ball bearings, laid out as pages."""

from collections.abc import Iterator
from typing import Any

from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from flexbearing.quantities import SummaryValue
from flexbearing.quantities.angular_contact import LAYOUT as FAST
from flexbearing.quantities.four_point import LAYOUT as SLOW, TORQUE_PARTS
from flexbearing.quantities.layout import Layout
from flexbearing.report.catalogue_life import against_catalogue
from flexbearing.report.rows import formatted, label, rows, value
from flexbearing.report.sections import (
    clearance_steps,
    closing,
    life_factors,
    matrix,
    opening,
    right_aligned,
    tolerances,
)

_COMPARED = {  # keys of the summary
    SLOW: (
        "loaded_balls",
        "loaded_contacts",
        "max_contact_load_N",
        "contact_angle_range_deg",
        "torque_Nm",
        "largest_ring_yield_um",
    ),
    FAST: (
        "balls_on_both_races",
        "contact_load_range_N",
        "contact_angle_range_deg",
        "life_L10_Mrev",
        "groove_displacement_um",
    ),
}
_DIRECTIONS = ("x [N/um]", "y [N/um]", "z [N/um]", "about y [kN m/mrad]", "about z [kN m/mrad]")


def of_slow(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Dangers, loads, torque in parts, ring, assumed keys, notes, and how the run ended.

    Elastic rings are compared with rigid ones; then everything is said of them.
    """
    yield from opening(numbers)
    if numbers["flexible"]:
        yield from compared(numbers["rigid"], numbers["flexible"], SLOW)
    if block := numbers["flexible"] or numbers["rigid"]:
        yield single_values(block, SLOW)
        yield of_races(block, SLOW)
        yield Text(
            f"torque in parts [N m]; that of the bearing by the {block['torque_formula']} formula", "bold"
        )
        yield _torque_parts(block)
        yield from ring(block, SLOW)
    if clearance := numbers["clearance"]:
        yield from clearance_steps(clearance)
        yield from tolerances(clearance)
    yield from closing(numbers, ending(numbers))


def compared(rigid: dict[str, Any], elastic: dict[str, Any], layout: Layout) -> Iterator[RenderableType]:
    """Compare end states between rigid and elastic rings; what follows is that between the elastic ones."""
    table = right_aligned("", "rigid rings", "elastic rings")
    both = rigid, elastic
    by_key = {entry.key: entry for entry in layout.summary}
    for entry in (by_key[key] for key in _COMPARED[layout]):
        for part in entry.parts or ("",):
            numbers = (shown(entry, value(entry, block, part)) for block in both)
            table.add_row(Text(f"{label(entry)} {part}".strip()), *numbers)
    for index, name in enumerate("xyz"):
        displacements = (format(block["ring_displacement_um"][index], "z.3f") for block in both)
        table.add_row(Text(f"displacement {name} [um]"), *displacements)
    for index, name in enumerate(("about y", "about z")):
        turns = (format(block["ring_tilt_mrad"][index], "z.4f") for block in both)
        table.add_row(Text(f"turn {name} [mrad]"), *turns)
    for index, name in enumerate(_DIRECTIONS):
        stiffness = (format(1e-6 * block["stiffness_matrix_SI"][index][index], ".5g") for block in both)
        table.add_row(Text(f"tangent stiffness {name}"), *stiffness)
    yield table
    yield Text("between the elastic rings", "bold")


def _torque_parts(block: dict[str, Any]) -> Table:
    table = right_aligned("", "all balls", "mean ball", "most loaded ball")
    columns = ("torque_parts_Nm", "mean_ball_torque_parts_Nm", "largest_ball_torque_parts_Nm")
    for part in TORQUE_PARTS:
        table.add_row(part, *(formatted(block[column][part], ".5g") for column in columns))
    table.add_row("total, circumferential", formatted(block["circumferential_torque_Nm"], ".5g"), "", "")
    return table


def of_fast(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Dangers, loads, motion, rolling lines, ring, life, assumed keys, notes, and how the run ended."""
    yield from opening(numbers)
    if numbers["flexible"]:
        yield from compared(numbers["rigid"], numbers["flexible"], FAST)
    if block := numbers["flexible"] or numbers["rigid"]:
        yield single_values(block, FAST)
        yield of_races(block, FAST)
        yield from ring(block, FAST)
    if clearance := numbers["clearance"]:
        yield from clearance_steps(clearance)
        yield from tolerances(clearance)
    yield from life_factors(numbers["life"] or {})
    yield from against_catalogue(numbers["catalogue_life"])
    yield from closing(numbers, ending(numbers))


def single_values(block: dict[str, Any], layout: Layout) -> Table:
    """What is one number, or one range, of the bearing."""
    table = right_aligned("", "value")
    for entry in rows(layout):
        if not entry.parts and block[entry.key] is not None:
            table.add_row(Text(label(entry)), shown(entry, value(entry, block)))
    return table


def of_races(block: dict[str, Any], layout: Layout) -> Table:
    """What inner and outer race have each."""
    table = right_aligned("", "inner", "outer")
    for entry in rows(layout):
        if entry.parts and block[entry.key] is not None:
            table.add_row(
                Text(label(entry)), *(shown(entry, value(entry, block, race)) for race in entry.parts)
            )
    return table


def ring(block: dict[str, Any], layout: Layout) -> Iterator[RenderableType]:
    """Displacement and stiffness of the inner ring; nothing when contact loads are given."""
    if block["ring_displacement_um"] is None:
        return
    table = right_aligned("inner ring", "")
    for entry in rows(layout, "ring"):
        components = (formatted(component, entry.digits) for component in value(entry, block))
        table.add_row(Text(label(entry)), ", ".join(components))
    yield table
    yield from matrix("tangent stiffness [N, m, rad]", block["stiffness_matrix_SI"])


def shown(entry: SummaryValue, number: Any) -> str:
    """A number, or a range in which both ends are reported apart only when they differ as shown."""
    if not isinstance(number, list):
        return "-" if number is None else formatted(number, entry.digits)
    first, last = (shown(entry, end) for end in number)
    return first if first == last else f"{first} to {last}"


def ending(numbers: dict[str, Any]) -> str:
    """Say in a line how a run ended."""
    if numbers["status"] == "unfinished":
        return f"unfinished: {numbers['message']}"
    seconds = f"{numbers['wall_time_s']:.1f} s"
    if numbers["status"] == "converged":
        return f"converged: {numbers['message']}, {seconds}"
    return f"NOT CONVERGED: {numbers['status']} ({numbers['ending']}), {seconds}: {numbers['message']}"
