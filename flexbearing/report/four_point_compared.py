"""Rigid rings beside elastic ones, of a slow ball bearing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from rich.table import Table
from rich.text import Text

from flexbearing.quantities.reductions import LOADED
from flexbearing.report.ball_axes import STYLES, around, close_ring, stacked
from flexbearing.report.sections import right_aligned
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_DIRECTIONS = ("x [N/um]", "y [N/um]", "z [N/um]", "about y [kN m/mrad]", "about z [kN m/mrad]")
_ROWS = (  # label, key in the block, format
    ("balls that carry load", "loaded_balls", "d"),
    ("contacts that carry load", "loaded_contacts", "d"),
    ("largest contact load [N]", "max_contact_load_N", ",.1f"),
    ("contact angle [deg]", "contact_angle_range_deg", ".2f"),
    ("torque of the bearing [N m]", "torque_Nm", ".5g"),
    ("largest deflection of the rings [um]", "largest_ring_yield_um", ".2f"),
)


def beside(numbers: dict[str, Any]) -> Table:
    """Compare the blocks of a summary that has both: loads, angles, torque, displacement, stiffness."""
    table = right_aligned("", "rigid rings", "elastic rings")
    both = numbers["rigid"], numbers["flexible"]
    for label, key, form in _ROWS:
        table.add_row(Text(label), *(_shown(block[key], form) for block in both))
    for place, name in enumerate("xyz"):
        moved = (format(block["ring_displacement_um"][place], "z.3f") for block in both)
        table.add_row(Text(f"displacement {name} [um]"), *moved)
    for place, name in enumerate(("about y", "about z")):
        turned = (format(block["ring_tilt_mrad"][place], "z.4f") for block in both)
        table.add_row(Text(f"turn {name} [mrad]"), *turned)
    for place, name in enumerate(_DIRECTIONS):
        stiffness = (format(1e-6 * block["stiffness_matrix_SI"][place][place], ".5g") for block in both)
        table.add_row(Text(f"tangent stiffness {name}"), *stiffness)
    return table


def _shown(value: Any, form: str) -> str:
    match value:
        case None:
            return "-"
        case {"inner": torque}:
            return format(torque, form)
        case [first, last]:
            return f"{first:{form}} to {last:{form}}"
    return format(value, form)


def compared_loads(result: Result) -> Figure:
    """Draw loads and contact angles of both diagonals around the ring, rigid in dashes."""
    figure, (upper, lower) = stacked(result, "Contact loads and angles at the inner race", 2)
    for values, look, rings in (
        (result.rigid, {"linestyle": "--", "marker": "", "alpha": 0.6}, "rigid"),
        (result.flexible, {}, "elastic"),
    ):
        for diagonal in range(2):
            load = values["contact_load"][:, diagonal, 0]
            angle = np.where(load > LOADED, np.degrees(values["contact_angle"][:, diagonal, 0]), np.nan)
            style = {**STYLES[diagonal], **look}
            label = f"diagonal {diagonal + 1}, {rings} rings, largest {load.max():,.0f} N"
            around(upper, values["ball_azimuth"], load, {**style, "label": label})
            around(lower, values["ball_azimuth"], angle, style)
    upper.set_ylabel("contact load [N]")
    lower.set_ylabel("contact angle [deg]")
    close_ring(lower)
    figure.legend(loc="outside lower center", ncols=2, frameon=False, fontsize=8)
    return figure
