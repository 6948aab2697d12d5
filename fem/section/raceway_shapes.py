"""Shapes in which elements press a raceway: polynomials along a cylinder, patches on arcs of a groove."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from fem.assembly.factorisation import threads
from fem.parts.boundary_conditions import FreeMotions
from fem.parts.groove import Groove, Stations
from fem.parts.material import ImpossiblePart, require
from fem.parts.part import Part
from fem.parts.resolution import Resolution
from fem.parts.rings import MIDDLE, OuterRing, RingOnShaft
from fem.parts.squirrel_cage import SquirrelCage
from fem.raceway.harmonics import HarmonicCompliance, Responses, harmonic_compliance, highest_harmonic
from fem.raceway.stations import DETAIL, GrooveCompliance
from fem.section.revolved_body import Body, edge_modes, station_modes
from fem.section.rigid_body_modes import body_of, responses, rigid_motions
from fem.section.smeared_cage import assembled_cage
from fem.stages import Stage

Raceway = HarmonicCompliance | GrooveCompliance


def raceway_modes(body: Body, part: Part, resolution: Resolution) -> NDArray:
    """Load vectors (unknowns, M) of the shapes in which a raceway is loaded, which also read it.

    They are `edge_modes` of axial modes or `station_modes` of a groove.
    Raises `ImpossiblePart` if a groove has no stations, or stations no place on its arcs.
    """
    if part.groove is None:
        return np.hstack(list(_of_rows(body, part, resolution)))
    return station_modes(body, part.groove, part.outward, _stations(part, part.groove, resolution))


def _of_rows(body: Body, part: Part, resolution: Resolution) -> Iterator[NDArray]:
    """Yield axial modes of each row, each followed by a force along its raceway where that is a shape."""
    one = resolution.rows == MIDDLE
    for place, angle in zip(resolution.rows, (taper(part), -taper(part)), strict=False):
        of_row = {"band": None if one else (place, resolution.length), "taper": angle}
        yield edge_modes(body, "raceway", resolution.axial_modes, **of_row)
        if resolution.along:
            yield edge_modes(body, "raceway", 1, direction=0, **of_row)


def body_of_revolution(part: Part, resolution: Resolution) -> Body:
    """Assembled sections of a part; bars of a cage are spread evenly around it."""
    if isinstance(part, SquirrelCage):
        return assembled_cage(part, resolution)
    return body_of(part, resolution)


def raceway_compliance(part: Part, resolution: Resolution, answers: Responses, seconds: dict) -> Raceway:
    """Compliance of a raceway for elements anywhere, from the answers (N + 1, M, M) of its shapes."""
    if part.groove is None:
        return harmonic_compliance(
            answers._replace(rows=len(resolution.rows), taper=taper(part), along=resolution.along),
            radius=part.raceway_diameter / 2, length=resolution.length, elastic=part.materials["ring"],
            bars=None, seconds=seconds,
        )  # fmt: skip
    stations = _stations(part, part.groove, resolution)
    return GrooveCompliance(
        groove=part.groove,
        outward=part.outward,
        angles=np.array(stations.angles),
        width=stations.width,
        response=answers.response,
        elastic=part.materials["ring"],
        unknowns=answers.unknowns,
        elements=answers.elements,
        seconds=seconds,
    )


def last_harmonic_of_patches(part: Part, resolution: Resolution) -> int:
    """Harmonics that the patches on a groove have, or that are given.

    Raises `ImpossiblePart` if the part has no groove; `NotSolved` if the mesh is too coarse for them.
    """
    groove, stations = part.groove, resolution.stations
    if groove is None or stations is None:
        raise ImpossiblePart(f"groove = {groove} with stations = {stations} is impossible; give both")
    outermost = max(groove.bottom(part.outward), groove.centre_radius)
    return highest_harmonic(outermost, DETAIL * stations.width, resolution.mesh, resolution.harmonics)


@threads(1)
def groove_compliance(part: Part, resolution: Resolution, stage: Stage, seconds: dict) -> Raceway:
    """Compliance of the groove of a body of revolution at stations of its arcs.

    Bars of a cage are spread evenly around it. Harmonics are by default as many as the patches of the
    stations have.
    Raises `ImpossiblePart` if stations are not on the arc; `NotSolved` if a solve fails, or the mesh is too
    coarse for the patches.
    """
    last = last_harmonic_of_patches(part, resolution)
    with stage("factor"):
        body = body_of_revolution(part, resolution)
    free = FreeMotions() if isinstance(part, SquirrelCage) else part.free_motions
    with stage("condense"):
        modes = raceway_modes(body, part, resolution)
        W = responses(body, free, modes, last) / (2 * np.pi)
        if free.axial:
            W[0] = without_axial_motion(W[0], body, modes)
    answers = Responses(W, body.stiffness.unknowns, body.space.mesh.ne)
    return raceway_compliance(part, resolution, answers, seconds)


def without_axial_motion(W: NDArray, body: Body, modes: NDArray) -> NDArray:
    """Answer (L, L) [m/N] of shapes to loads all around, with no axial motion of their mean."""
    return referred(W, modes.T @ rigid_motions(body)[0][:, :1], np.full(len(W), True))


def referred(W: NDArray, rigid: NDArray, of_raceway: NDArray) -> NDArray:
    r"""Answer with no rigid motion in the raceway's displacements, which react to loads out of balance.

    .. math:: \bar W = \Pi^T W \Pi, \quad \Pi = I - E (E^T R)^{-T} R^T

    W (L, L) [m/N] are answers of shapes, right but for rigid motions; R (L, A) is what they read of these
    motions, E what shapes of the raceway alone read of them.

    Source
    ------
    Fourier series of the answer of a body of revolution; derived here.
    """
    projection = balancing(rigid, of_raceway)
    return projection.T @ W @ projection


def balancing(rigid: NDArray, of_raceway: NDArray) -> NDArray:
    """The projection of `referred` (L, L) [-]: loads with the reaction on the raceway that balances them."""
    own = rigid * of_raceway[:, None]
    return np.eye(len(rigid)) - own @ np.linalg.solve(rigid.T @ own, rigid.T)


def _stations(part: Part, groove: Groove, resolution: Resolution) -> Stations:
    """Stations that are on the arcs of a groove."""
    stations = resolution.stations
    if stations is None:
        raise ImpossiblePart(f"groove = {groove} with stations = None is impossible; give both")
    end = groove.end(part.raceway_diameter / 2, part.outward)
    first = groove.bottom_angle if groove.aside else -end
    margin = stations.width / groove.radius
    require(
        first + margin < min(stations.angles) and max(stations.angles) + margin < end,
        "angles", stations.angles, f"between {first:.4g} and {end:.4g} rad, where the arc of the groove ends",
    )  # fmt: skip
    return stations


def taper(part: Part) -> float:
    """Angle of a raceway from the axis [rad], of two of that at -x; zero of a cylinder."""
    return part.taper if isinstance(part, OuterRing | RingOnShaft) else 0.0
