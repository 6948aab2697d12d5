"""Pictures of the parts of a result under its rollers: magnified deformation, coloured by stress."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.files import require_outputs, write
from flexbearing.report.picture import NUMBERS, PNG, Format, picture_bytes, set_heading
from flexbearing.results import Result
from flexbearing.runs import fields, stored_fields
from flexbearing.runs.part_fields import NAMES, NoFields, PartFields, Race

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from fem.solid.skin import Skin


COLOURED = 0.99  # share of the surface's corners with stresses up to the last colour


def pictures(result: Result, directory: Path, form: Format = PNG) -> Iterator[Path | NoFields]:
    """Draw every flexible part at the flexible end state, in files named after result and part.

    Raises `BadOutput` before anything is solved, if a picture cannot be written; `NotStored` if there is no
    room for it.
    """
    if not result.flexible or not result.family.report().deformed:
        return
    case = stored_fields.case_of(result)
    try:
        flexible = fields.parts(case)
    except NoFields as problem:
        yield problem
        return
    paths: dict[Race, Path] = {
        race: directory / f"{result.stem}_{race}_deformed.{form.name}" for race in flexible
    }
    require_outputs(paths.values(), result.files)
    for race, path in paths.items():
        try:
            part = fields.fields(case, race, "flexible", result.flexible)
        except NoFields as problem:
            yield problem
        else:
            write(path.resolve(), picture_bytes(_drawn(part, result), form))
            yield path


def _drawn(part: PartFields, result: Result) -> Figure:
    from fem.solid.skin import skin  # NGSolve takes a second to load

    outside = skin(part.loaded)
    limit = float(np.quantile(outside.von_mises, COLOURED))  # sharp edges would leave all else in one colour
    title = f"{result.attributes['title']}: {NAMES[part.race]}"
    return deformed(title, outside, limit)


DRAWN = 0.12  # largest displacement in the picture over the largest radius, about
LIGHT = np.array([-0.4, 0.6, 0.7])  # towards the lamp, in the picture: right, up, to the viewer
DARKEST = 0.5  # of the colour where the lamp grazes
SEAM = 0.3  # [pt] width of the edges of triangles

# right, up, to the viewer: as in the picture of loads, azimuth 0 points down and 90 degrees to the right
_ALONG_AXIS = np.array([[0.0, 1, 0], [0, 0, -1], [-1, 0, 0]])


def deformed(title: str, skin: Skin, limit: float) -> Figure:
    """Draw a deformed part obliquely and along its axis."""
    # matplotlib takes a second to load: only pictures pay for it, not every command
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure

    largest = float(np.linalg.norm(skin.displacement, axis=2).max())
    radius = np.hypot(skin.points[..., 1], skin.points[..., 2])
    factor = _rounded_down(DRAWN * radius.max() / largest)
    colours = ScalarMappable(Normalize(0, limit / 1e6), "YlOrRd")
    figure = Figure(figsize=(11.0, 5.6), layout="constrained")
    oblique, axial = figure.subplots(1, 2)
    _draw(oblique, skin, factor, _rotation(40, 20) @ _ALONG_AXIS, colours)
    oblique.set_title(f"obliquely; displacement magnified {factor:g} times", fontsize=10)
    _draw(axial, skin, factor, _ALONG_AXIS, colours)
    azimuth = np.linspace(0, 2 * np.pi, 181)
    for circle in (1e3 * radius.min(), 1e3 * radius.max()):
        axial.plot(circle * np.sin(azimuth), -circle * np.cos(azimuth), color="0.2", ls="--", lw=0.8)
    axial.set_title("along the axis; dashed: before the load, azimuth 0 points down", fontsize=10)
    figure.colorbar(
        colours, ax=axial, extend="max", shrink=0.8, label="von Mises stress [MPa]", format=NUMBERS
    )
    set_heading(
        figure, title, f"Deformed under its rollers, largest displacement {1e6 * largest:,.0f} µm", 100
    )
    return figure


def _draw(axes: Axes, skin: Skin, factor: float, view: NDArray, colours: Any) -> None:
    """Fill the triangles that face the viewer from far to near, so that the nearest is seen."""
    from matplotlib.collections import PolyCollection

    corners = 1e3 * (skin.points + factor * skin.displacement) @ view.T  # (triangles, 3, right up near) [mm]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    facing = np.flatnonzero(normal[:, 2] > 0)
    facing = facing[np.argsort(corners[facing, :, 2].mean(axis=1))]
    light = DARKEST + (1 - DARKEST) * np.clip(normal[facing] @ LIGHT / np.linalg.norm(LIGHT), 0, 1)
    filling = colours.to_rgba(skin.von_mises[facing].mean(axis=1) / 1e6)
    filling[:, :3] *= light[:, None]
    # edges in the colour of their triangle hide the seams that smoothing leaves between neighbours
    axes.add_collection(
        PolyCollection(
            list(corners[facing, :, :2]),
            facecolors=filling,
            edgecolors="face",
            linewidths=SEAM,
            rasterized=True,
        )
    )
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.set_axis_off()


def _rotation(vertical: float, horizontal: float) -> NDArray:
    """Rotation of the part in the picture about its upright, then about its level axis [deg]."""
    (c, s), (d, t) = ((np.cos(angle), np.sin(angle)) for angle in np.radians((vertical, horizontal)))
    return np.array([[1, 0, 0], [0, d, -t], [0, t, d]]) @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def _rounded_down(factor: float) -> float:
    """The next of 1, 2, 5, 10 ... below."""
    decade = 10.0 ** np.floor(np.log10(factor))
    return max(step * decade for step in (1, 2, 5) if step * decade <= factor)
