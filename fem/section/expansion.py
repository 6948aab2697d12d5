"""Expansion of raceways by rotation or heat, from harmonic 0 of a body of revolution."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly import harmonic_elasticity as forms
from fem.mesh.moved_nodes import vertex_places
from fem.mesh.solid import MILLIMETRES
from fem.parts.material import ImpossiblePart, require
from fem.section.revolved_body import Body, edge_modes

ENDS = 1e-9  # of its length, by which a body may reach beyond the places of its expansion


@dataclass(frozen=True, kw_only=True)
class Along:
    """Free expansion of a body along the axis, linear between places."""

    at: Sequence[float]  # (K,) x [m] growing, from end to end of the body or beyond
    values: Sequence[float]  # (K,) alpha (T - T0) there [-], positive when it grows

    def __post_init__(self):
        at, values = (tuple(float(v) for v in column) for column in (self.at, self.values))
        require(
            len(at) >= 2 and all(map(isfinite, at)) and bool(np.all(np.diff(at) > 0)),
            "at", at, "two or more places in growing order",
        )  # fmt: skip
        require(
            len(values) == len(at) and all(map(isfinite, values)),
            "values", values, f"one finite number for each of {len(at)} places",
        )  # fmt: skip
        object.__setattr__(self, "at", at)
        object.__setattr__(self, "values", values)


def rotation(body: Body, densities: Mapping[str, float], speed: float) -> NDArray:
    """Load vector [N] of rotation at a speed [rad/s], per radian, harmonic 0; densities by body [kg/m^3]."""
    density = body.space.mesh.MaterialCF(dict(densities))
    return body.load(forms.centrifugal(body.space.TestFunction(), density, speed))


def heating(body: Body, thermal_strains: Mapping[str, float | Along]) -> NDArray:
    """Load vector of free thermal strains of every body by its name, per radian, harmonic 0 [N].

    They are alpha (T - T0) [-], positive when it grows; even, or `Along` the axis.
    Raises `ImpossiblePart` if an expansion ends inside its body.

    Valid
    -----
    Elements through which a kink of the expansion passes integrate it only nearly.
    """
    expansion = body.space.mesh.MaterialCF(
        {name: _field(body, name, e) for name, e in thermal_strains.items()}
    )
    return body.load(forms.thermal(body.space.TestFunction(), body.bulk, expansion))


def radial_expansion(body: Body, load: NDArray, edge: str, axial_modes: int = 1) -> NDArray:
    """Radial displacement (M,) [m] of a cylindrical edge under an axisymmetric load.

    The load is the sum of vectors of `rotation` and `heating`. Outward as in `edge_modes`: the displacement
    along the edge is the sum of w_m L_m. The body is held axially and against turning.
    Raises `NotSolved` if the body is not held.
    """
    u = body.stiffness.solve(0, load[:, None])
    return edge_modes(body, edge, axial_modes).T @ u[:, 0]


def _field(body: Body, name: str, expansion: float | Along):
    """Expansion of one body over its section."""
    if not isinstance(expansion, Along):
        return expansion
    section = body.space.mesh
    vertices = {v.nr for element in section.Materials(name).Elements() for v in element.vertices}
    x = vertex_places(section)[list(vertices), 0]
    reach, at, values = ENDS * np.ptp(x), np.array(expansion.at), np.array(expansion.values)
    if x.min() < at[0] - reach or x.max() > at[-1] + reach:
        raise ImpossiblePart(
            f"at = {expansion.at} m of the expansion of {name!r} is impossible; allowed is what covers the "
            f"body, {x.min():.6g} to {x.max():.6g} m"
        )
    slopes = np.diff(values) / np.diff(at) / MILLIMETRES
    strain = values[0] + slopes[0] * (ngs.x - at[0] * MILLIMETRES)
    for place, kink in zip(at[1:-1] * MILLIMETRES, np.diff(slopes), strict=True):
        strain += kink * ngs.IfPos(ngs.x - place, ngs.x - place, 0.0)
    return strain
