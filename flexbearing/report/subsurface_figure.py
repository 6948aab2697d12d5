"""Picture of the stresses below the most pressed contact of each raceway."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from flexbearing.quantities.reductions import RACES
from flexbearing.quantities.units import MPA, UM
from flexbearing.report.figure import Axis, Figure, Line, Map
from flexbearing.report.panels import picture

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Page
    from numpy.typing import NDArray


def subsurface(values: Mapping[str, NDArray], title: str, what: str) -> Page:
    """Draw von Mises and orthogonal shear stress in the plane of rolling."""
    mises, shear = (
        float(np.abs(values[f"subsurface_{name}"]).max()) or 1.0 for name in ("von_mises", "shear")
    )
    scales = {
        "von_mises": ("YlOrRd", (0.0, MPA.scale * mises)),
        "shear": ("RdBu_r", (-MPA.scale * shear, MPA.scale * shear)),
    }
    figures = [_figure(values, name, race, *scales[name]) for name in scales for race in (0, 1)]
    heading = f"Stresses below the most pressed contacts, {what}; the contact in black"
    return picture(title, heading, figures, columns=2, size=(4.8, 2.5))


def _figure(
    values: Mapping[str, NDArray], name: str, race: int, colours: str, ends: tuple[float, float]
) -> Figure:
    along, depth = (UM.scale * values[f"subsurface_{each}"][race] for each in ("position", "depth"))
    stress, half = (
        MPA.scale * values[f"subsurface_{name}"][race],
        UM.scale * values["contact_half_width"][race],
    )
    label = "von Mises stress [MPa]" if name == "von_mises" else "orthogonal shear stress [MPa]"
    items = [
        Map(along.tolist(), depth.tolist(), stress.tolist(), label, ends, colours),
        Line([-half, half], [0.0, 0.0], colour="black", mark="", width=3.0),
    ]
    stated = "von_mises" if name == "von_mises" else "orthogonal_shear"
    size, deep = MPA.scale * values[f"{stated}_stress"][race], UM.scale * values[f"{stated}_depth"][race]
    if name == "von_mises":
        most = along[np.unravel_index(stress.argmax(), stress.shape)[1]]
        items.append(Line([most], [deep], colour="black", dash="", mark="x"))
    amplitude = "" if name == "von_mises" else "amplitude "
    title = f"{RACES[race]} raceway: {amplitude}{size:,.0f} MPa, {deep:.0f} µm deep"
    x, y = Axis("in the rolling direction [µm]"), Axis("depth [µm]", ends=(depth[-1], 0.0))
    return Figure(f"{name}-{race}", title, x, y, tuple(items), equal=True)
