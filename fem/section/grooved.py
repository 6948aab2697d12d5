"""A groove on a body of revolution, or on a cage whose bars are spread, by harmonics on the axial section."""

import numpy as np

from fem.assembly.factorisation import threads
from fem.parts.bolted_ring import BoltedRing
from fem.parts.boundary_conditions import FreeMotions
from fem.parts.material import ImpossiblePart, require
from fem.parts.resolution import Resolution
from fem.parts.rings import Part, RingOnShaft, SquirrelCage
from fem.raceway.harmonics import highest_harmonic
from fem.raceway.stations import DETAIL, GrooveCompliance
from fem.section.revolved_body import station_modes
from fem.section.rigid_body_modes import body_of, responses
from fem.section.smeared_cage import assembled_cage
from fem.stages import Stage


@threads(1)
def groove_compliance(
    part: Part | BoltedRing, resolution: Resolution, stage: Stage, seconds: dict
) -> GrooveCompliance:
    """Compliance of the groove of a body of revolution at stations of its arcs.

    Parameters
    ----------
    part : OuterRing, RingOnShaft, SquirrelCage, BoltedRing
        with a groove, held; bars of a cage are spread evenly around it
    resolution : Resolution
        of mesh, with stations; harmonics by default as many as their patches have
    stage : callable (name)
        around "factor" and "condense"
    seconds : dict
        of the stages

    Returns
    -------
    GrooveCompliance

    Raises
    ------
    ImpossiblePart
        if stations are not on the arc
    NotSolved
        if a solve fails, or the mesh is too coarse for the patches
    """
    groove, stations, outward = part.groove, resolution.stations, _outward(part)
    if groove is None or stations is None:
        raise ImpossiblePart(f"groove = {groove} with stations = {stations} is impossible; give both")
    end = groove.end(part.raceway_diameter / 2, outward)
    first = groove.bottom_angle if groove.aside else -end
    margin = stations.width / groove.radius
    require(
        first + margin < min(stations.angles) and max(stations.angles) + margin < end,
        "angles", stations.angles, f"between {first:.4g} and {end:.4g} rad, where the arc of the groove ends",
    )  # fmt: skip
    outermost = max(groove.bottom(outward), groove.centre_radius)
    last = highest_harmonic(outermost, DETAIL * stations.width, resolution.mesh, resolution.harmonics)
    with stage("factor"):
        if isinstance(part, SquirrelCage):
            body, free = assembled_cage(part, resolution), FreeMotions()
        else:
            body, free = body_of(part, resolution.length, resolution.mesh), part.free_motions
    with stage("condense"):
        modes = station_modes(body, groove, outward, stations)
        W = responses(body, free, modes, last) / (2 * np.pi)
    return GrooveCompliance(
        groove=groove,
        outward=outward,
        angles=np.array(stations.angles),
        width=stations.width,
        response=W,
        elastic=part.materials["ring"],
        unknowns=body.stiffness.unknowns,
        elements=body.space.mesh.ne,
        seconds=seconds,
    )


def _outward(part: Part | BoltedRing) -> int:
    """1 where a part is outside of the balls, else -1."""
    if isinstance(part, BoltedRing):
        return part.outward
    return -1 if isinstance(part, RingOnShaft) else 1
