"""Pictures of a part under its rollers: magnified deformation, coloured by stress."""

from __future__ import annotations

from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from fem.solid.skin import Skin

DRAWN = 0.12  # largest displacement in the picture over the largest radius, about
LIGHT = np.array([-0.4, 0.6, 0.7])  # towards the lamp, in the picture: right, up, to the viewer
PIXEL = 0.12  # [mm]
DARKEST = 0.5  # of the colour where the lamp grazes

# right, up, to the viewer: as in the picture of loads, azimuth 0 points down and 90 degrees to the right
_ALONG_AXIS = np.array([[0.0, 1, 0], [0, 0, -1], [-1, 0, 0]])


def deformed(title: str, skin: Skin, limit: float) -> Figure:
    """Draw a deformed part obliquely and along its axis.

    Parameters
    ----------
    title : str
        over the picture
    skin : Skin
        triangles of its outside
    limit : float
        stress at the upper end of the colours [Pa]

    Returns
    -------
    matplotlib.figure.Figure
        displacements magnified as the title says, von Mises stress [MPa]
    """
    # matplotlib takes a second to load: only pictures pay for it, not every command
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure

    largest = float(np.linalg.norm(skin.displacement, axis=2).max())
    factor = _round(DRAWN * np.hypot(skin.places[..., 1], skin.places[..., 2]).max() / largest)
    colours = ScalarMappable(Normalize(0, limit / 1e6), "YlOrRd")
    figure = Figure(figsize=(11.0, 5.6), layout="constrained")
    left, right = figure.subplots(1, 2)
    for axes, view, name in (
        (left, _turned(40, 20) @ _ALONG_AXIS, "obliquely"),
        (right, _ALONG_AXIS, "along the axis; dashed: before the load, azimuth 0 points down"),
    ):
        _draw(axes, skin, factor, view, colours)
        axes.set_title(name, fontsize=10)
    _draw_before(right, skin)
    figure.colorbar(colours, ax=right, extend="max", shrink=0.8, label="von Mises stress [MPa]")
    figure.suptitle(
        f"{fill(title, 100)}\ndisplacement magnified {factor:g} times, largest {1e6 * largest:.0f} µm",
        fontsize=11,
    )
    return figure


def _draw(axes: Axes, skin: Skin, factor: float, view: NDArray, colours: Any) -> None:
    """The triangles as an image; of all that fall on a pixel the nearest is seen."""
    corners = 1e3 * (skin.places + factor * skin.displacement) @ view.T  # (triangles, 3, right up near) [mm]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    light = DARKEST + (1 - DARKEST) * np.clip(normal @ LIGHT / np.linalg.norm(LIGHT), 0, 1)
    light = np.repeat(light, 3).reshape(-1, 3, 1)
    values = np.concatenate([corners, skin.von_mises[..., None] / 1e6, light], axis=2)
    place, near, stress, bright = np.split(_filled(values[normal[:, 2] > 0]), [2, 3, 4], axis=1)
    low, high = place.min(axis=0), place.max(axis=0)
    width, height = np.ceil((high - low) / PIXEL).astype(int) + 1
    column, row = np.rint((place - low) / PIXEL).astype(int).T
    seen = np.full(width * height, -1)
    order = np.argsort(near[:, 0])
    seen[(row * width + column)[order]] = order  # written in this order, the nearest stays
    image = colours.to_rgba(stress[seen, 0])
    image[:, :3] *= bright[seen]
    image[seen < 0] = 0
    image = image.reshape(height, width, 4)
    axes.imshow(image, origin="lower", extent=(low[0], high[0], low[1], high[1]))
    axes.set_axis_off()


def _filled(triangles: NDArray) -> NDArray:
    """Points (n, values) so close on triangles (t, 3, values) that no pixel between them stays empty."""
    edges = np.roll(triangles, 1, axis=1)[..., :2] - triangles[..., :2]
    count = np.ceil(1.3 * np.linalg.norm(edges, axis=2).max(axis=1) / PIXEL).astype(int)
    found = []
    for n in np.unique(count):
        i, j = np.array([(i, j) for i in range(n + 1) for j in range(n + 1 - i)]).T / max(n, 1)
        weight = np.stack([1 - i - j, i, j])
        found.append(np.einsum("wp,twv->tpv", weight, triangles[count == n]).reshape(-1, triangles.shape[2]))
    return np.concatenate(found)


def _draw_before(axes: Axes, skin: Skin) -> None:
    """Innermost and outermost circle of the part that is not deformed."""
    radii, around = 1e3 * np.hypot(skin.places[..., 1], skin.places[..., 2]), np.linspace(0, 2 * np.pi, 181)
    for radius in (radii.min(), radii.max()):
        axes.plot(
            radius * np.sin(around), -radius * np.cos(around), color="0.2", linestyle="--", linewidth=0.8
        )


def _turned(right: float, down: float) -> NDArray:
    """Turn the thing in the picture about its upright, then about its level axis [deg]."""
    (c, s), (d, t) = ((np.cos(angle), np.sin(angle)) for angle in np.radians((right, down)))
    return np.array([[1, 0, 0], [0, d, -t], [0, t, d]]) @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def _round(factor: float) -> float:
    """The next of 1, 2, 5, 10 ... below."""
    decade = 10.0 ** np.floor(np.log10(factor))
    return max(step * decade for step in (1, 2, 5) if step * decade <= factor)
