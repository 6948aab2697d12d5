"""Bonded bodies of revolution on their axial section, with the stiffness for every harmonic."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import cos, sin, tan
from typing import Any

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly import harmonic_elasticity as forms
from fem.assembly.elasticity import lame_constants
from fem.assembly.harmonic_stiffness import HarmonicStiffness, harmonic_stiffness
from fem.mesh.axial_section import AxialSection
from fem.mesh.section_mesh import meshed
from fem.mesh.solid import MILLIMETRES
from fem.parts.groove import Groove, Stations
from fem.parts.rings import Elastic, ImpossiblePart, MeshSize

FLAT = 1e-12  # mean square deviation of an edge from its radius, over the square of that


@dataclass(frozen=True)
class Springs:
    """An elastic foundation along an edge, per area."""

    axial: float  # [N/m^3] >= 0
    radial: float  # [N/m^3] >= 0
    tangential: float  # [N/m^3] >= 0


@dataclass(frozen=True)
class Body:
    """Bonded sections with their stiffness, ready for loads."""

    space: Any  # ngsolve.FESpace of u_x, u_r, u_t
    bulk: Any  # ngsolve.CoefficientFunction, K = lambda + 2 mu/3 [Pa]
    stiffness: HarmonicStiffness

    def load(self, form) -> NDArray:
        """Load vector (unknowns,) of a weak form, per radian [N]."""
        return ngs.LinearForm(form).Assemble().vec.FV().NumPy().copy()


def assembled(
    bodies: list[AxialSection], materials: Mapping[str, Elastic], mesh: MeshSize,
    foundations: Mapping[str, Springs] | None = None, nodes_of: list[AxialSection] | None = None,
) -> Body:  # fmt: skip
    """Mesh sections and assemble their stiffness.

    Bodies are bonded where they touch, held on the edges named "clamped". Materials are by the name of a
    body, `Springs` to ground by that of an edge; `nodes_of` is as in `fem.mesh.section_mesh.meshed`.
    Raises `ImpossiblePart` if no edge has the name of a foundation.
    """
    section = meshed(bodies, mesh, nodes_of)
    space = ngs.H1(section, order=mesh.order, dirichlet="clamped") ** 3
    u, v = space.TnT()
    constants = {name: lame_constants(m.youngs_modulus, m.poisson_ratio) for name, m in materials.items()}
    lame, shear = (section.MaterialCF({name: c[k] for name, c in constants.items()}) for k in (0, 1))
    plain, once, twice = forms.elasticity(u, v, lame, shear)
    for name, springs in (foundations or {}).items():
        k = (springs.axial, springs.radial, springs.tangential)
        plain += forms.foundation(u, v, _edge(section, name), k)
    return Body(
        space=space, bulk=lame + 2 * shear / 3, stiffness=harmonic_stiffness(space, plain, once, twice)
    )


def edge_modes(
    body: Body, edge: str, axial_modes: int, direction: int = 1, band: tuple[float, float] | None = None,
    taper: float = 0.0,
) -> NDArray:  # fmt: skip
    r"""Load vectors of Legendre pressures on a straight edge, which also read its displacement.

    .. math:: g_m(v) = \int \frac{2m+1}{l} L_m(2 s/l)\,v_d\,ds

    An array (unknowns, M) [-]; g_0 reads the mean displacement. The edge of length l has its middle at s = 0,
    s towards +x; d is 0 along x, 1 outward, 2 towards growing azimuth; on a cone with a `taper` [rad] from
    the axis 0 is along it, 1 normal to it. Of several parts a `band` has x_0 and axial length [m] of one.
    Raises `ImpossiblePart` if no edge has this name, or if it is not one cylinder or cone.

    Source
    ------
    Body of revolution in harmonics, virtual work per radian; derived here.
    """
    where = _edge(body.space.mesh, edge)

    inside = ngs.CF(1)
    if band is not None:
        middle, axial = (MILLIMETRES * each for each in band)
        inside = ngs.IfPos(axial / 2 - ngs.sqrt((ngs.x - middle) ** 2), 1.0, 0.0)

    def integral(f):
        return ngs.Integrate(inside * f, body.space.mesh, ngs.BND, definedon=where)

    length, radius = integral(1), integral(ngs.y)
    place = integral(ngs.x) / length
    if integral((ngs.y - radius / length - tan(taper) * (ngs.x - place)) ** 2) > FLAT * radius**2 / length:
        raise ImpossiblePart(f"the edge {edge!r} is not one cylinder or cone: its radius varies otherwise")
    xi = 2 * (ngs.x - place) / (length * cos(taper))
    v = body.space.TestFunction()
    along, across = (v[0], v[1]) if not taper else (
        cos(taper) * v[0] + sin(taper) * v[1], cos(taper) * v[1] - sin(taper) * v[0]
    )  # fmt: skip
    shapes = enumerate(legendre_polynomials(xi, axial_modes))
    patterns = (inside * (2 * m + 1) / length * L for m, L in shapes)
    towards = (along, across, v[2])[direction]
    return np.stack([body.load(forms.edge_pressure(towards, where, a)) for a in patterns], axis=1)


def station_modes(body: Body, groove: Groove, outward: int, stations: Stations) -> NDArray:
    r"""Load vectors of normal Gaussian patches on the arcs of a groove, which also read its displacement.

    .. math:: g_k(v) = \frac{\int p_k\,(\pm v_x \sin\alpha + v_r \cos\alpha)\,ds}
              {\int p_k \cos(\alpha - \alpha_k)\,ds}, \quad
              p_k = e^{-r^2 (\alpha - \alpha_k)^2/2 \sigma^2}

    with the sign of the side of the arc; two arcs end where they meet, or are grooves of two rows.

    An array (unknowns, A K) [-], one arc after the other; for unit forces away from the centre of the groove
    on an outer race (`outward` 1), towards it on an inner one (-1). Stations have alpha_k and sigma, the
    groove its radius r; its arc is named "raceway".

    Source
    ------
    Body of revolution in harmonics, virtual work per radian; derived here.

    Valid
    -----
    A patch reads the displacement of a rigid section to 1e-6 five widths from where its arc ends, to 0.7 %
    two widths from there, as it is cut (tests/fem/test_bolted_ring.py). Giving a cut patch the resultant of a
    whole one was tried: contact angles of 30 degrees are then further from those of narrow patches.
    """
    edge, v = _edge(body.space.mesh, "raceway"), body.space.TestFunction()
    cosine = outward * (ngs.y / MILLIMETRES - groove.centre_radius) / groove.radius
    loads = []
    for side in groove.sides:
        along = outward * (side * ngs.x / MILLIMETRES - groove.place)
        sine = (along + groove.aside) / groove.radius
        angle, normal = ngs.atan2(sine, cosine), side * sine * v[0] + cosine * v[1]
        here = 1.0
        if groove.aside:
            here = ngs.IfPos(along, 1.0, 0.0)
        elif groove.place:
            here = ngs.IfPos(side * groove.place * ngs.x, 1.0, 0.0)
        for station in stations.angles:
            patch = here * ngs.exp(-((groove.radius * (angle - station) / stations.width) ** 2) / 2)
            read = ngs.Integrate(patch * ngs.cos(angle - station), body.space.mesh, ngs.BND, definedon=edge)
            loads.append(body.load(forms.edge_pressure(normal, edge, patch / read)))
    return np.stack(loads, axis=1)


def _edge(section, name: str):
    if name not in section.GetBoundaries():
        raise ImpossiblePart(f"no edge is named {name!r}; there are {sorted(set(section.GetBoundaries()))}")
    return section.Boundaries(name)


def legendre_polynomials(xi, count: int) -> list:
    """Polynomials L_0 .. L_(count - 1) of a coefficient function, by their recurrence."""
    L = [ngs.CF(1), xi]
    for k in range(1, count - 1):
        L.append(((2 * k + 1) * xi * L[k] - k * L[k - 1]) / (k + 1))
    return L[:count]
