"""The summary of a slow ball bearing, laid out as a page."""

from collections.abc import Iterator
from typing import Any

from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from flexbearing.quantities.four_point import LAYOUT, TORQUE_PARTS
from flexbearing.report.balls.sections import ending, of_races, ring, shown, single_values
from flexbearing.report.rows import formatted, label, value
from flexbearing.report.sections import clearance_steps, closing, opening, right_aligned, tolerances

_COMPARED = (  # keys of the summary
    "loaded_balls",
    "loaded_contacts",
    "max_contact_load_N",
    "contact_angle_range_deg",
    "torque_Nm",
    "largest_ring_yield_um",
)
_DIRECTIONS = ("x [N/um]", "y [N/um]", "z [N/um]", "about y [kN m/mrad]", "about z [kN m/mrad]")


def page(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Dangers, loads, torque in parts, ring, assumed keys, notes, and how the run ended.

    Elastic rings are compared with rigid ones; then everything is said of them.
    """
    yield from opening(numbers)
    if numbers["flexible"]:
        yield compared(numbers["rigid"], numbers["flexible"])
        yield Text("between the elastic rings", "bold")
    if block := numbers["flexible"] or numbers["rigid"]:
        yield single_values(block, LAYOUT)
        yield of_races(block, LAYOUT)
        yield Text(
            f"torque in parts [N m]; that of the bearing by the {block['torque_formula']} formula", "bold"
        )
        yield _torque_parts(block)
        yield from ring(block, LAYOUT)
    if clearance := numbers["clearance"]:
        yield from clearance_steps(clearance)
        yield from tolerances(clearance)
    yield from closing(numbers, ending(numbers))


def compared(rigid: dict[str, Any], elastic: dict[str, Any]) -> Table:
    """Compare end states between rigid and elastic rings: loads, torque, displacement, stiffness."""
    table = right_aligned("", "rigid rings", "elastic rings")
    both = rigid, elastic
    by_key = {entry.key: entry for entry in LAYOUT.summary}
    for entry in (by_key[key] for key in _COMPARED):
        part = entry.parts[0] if entry.parts else ""
        table.add_row(Text(label(entry)), *(shown(entry, value(entry, block, part)) for block in both))
    for index, name in enumerate("xyz"):
        displacements = (format(block["ring_displacement_um"][index], "z.3f") for block in both)
        table.add_row(Text(f"displacement {name} [um]"), *displacements)
    for index, name in enumerate(("about y", "about z")):
        turns = (format(block["ring_tilt_mrad"][index], "z.4f") for block in both)
        table.add_row(Text(f"turn {name} [mrad]"), *turns)
    for index, name in enumerate(_DIRECTIONS):
        stiffness = (format(1e-6 * block["stiffness_matrix_SI"][index][index], ".5g") for block in both)
        table.add_row(Text(f"tangent stiffness {name}"), *stiffness)
    return table


def _torque_parts(block: dict[str, Any]) -> Table:
    table = right_aligned("", "all balls", "mean ball", "most loaded ball")
    columns = ("torque_parts_Nm", "mean_ball_torque_parts_Nm", "largest_ball_torque_parts_Nm")
    for part in TORQUE_PARTS:
        table.add_row(part, *(formatted(block[column][part], ".5g") for column in columns))
    table.add_row("total, circumferential", formatted(block["circumferential_torque_Nm"], ".5g"), "", "")
    return table
