"""The stiffness of a ring condensed to its raceway under rollers or balls."""

from collections.abc import Callable
from math import ceil, pi

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from fem.assembly import roller_loads
from fem.assembly.bar_readings import bar_readings
from fem.assembly.factorisation import threads
from fem.half_space.gaussian_patch import patch_answers
from fem.half_space.load_patch import half_space
from fem.mesh.solid import meshed
from fem.parts.groove import BallPatches
from fem.parts.part import Part
from fem.parts.resolution import Resolution, neighbour
from fem.parts.squirrel_cage import SquirrelCage
from fem.parts.step_solid import StepSolid
from fem.raceway import symmetry
from fem.raceway.bar_response import BarResponse, is_mirrored
from fem.raceway.compliance import RacewayCompliance
from fem.raceway.harmonics import FINENESS
from fem.solid.factored_solid import FactoredSolid, balls_of, factored_on
from fem.stages import Stage

MOST_OF_BARS = 200  # harmonics that reach the bars: higher ones do not reach through the ring


def condense_solid(part: Part | StepSolid, resolution: Resolution, stage: Stage) -> RacewayCompliance:
    """Compliance of a raceway to its rollers, by as few solves as symmetry leaves; or to balls at stations.

    Raises `ImpossiblePart` if the loaded band is longer than the track, or a drawing does not hold such a
    part; `NotSolved` if a residual is too large, or the mesh too coarse for the patches.

    Valid
    -----
    Small displacement, perfect bonds, rigid clamps; no load outside the band.
    """
    patches = resolution.patches
    with stage("mesh"):
        mesh = meshed(part, patches.length, resolution.mesh, balls_of(patches))
    with stage("factor"):
        solid = factored_on(mesh, part, patches, resolution.mesh, resolution.threads)
    with stage("condense") as progress:
        return (
            under_balls(solid, progress) if isinstance(patches, BallPatches) else condensed(solid, progress)
        )


def under_balls(solid: FactoredSolid, progress: Callable[[float], None]) -> RacewayCompliance:
    """Compliance of a groove at the stations of its balls, from the ground; `progress` as in `condensed`.

    Raises `NotSolved` if a residual is too large, or the mesh too coarse for the patches.
    """
    patches, groove = solid.patches, solid.part.groove
    assert isinstance(patches, BallPatches)
    assert groove
    loads, angles = solid.loads, np.array(patches.stations.angles)
    Z, K = len(patches.azimuths), len(angles)
    absolute = np.empty((Z * K, Z * K))
    with threads(solid.thread_number):
        for k in range(Z * K):
            absolute[:, k] = loads.T @ solid.stiffness.solve(loads[:, [k]].toarray()[:, 0])
            progress((k + 1) / (Z * K))
    absolute = ((absolute + absolute.T) / 2).reshape(Z, K, Z, K)
    apart, ball = groove.radius * np.abs(angles[:, None] - angles), np.arange(Z)
    absolute[ball, :, ball] -= patch_answers(apart, patches.width, solid.part.materials["ring"])
    return RacewayCompliance(
        azimuths=np.array(patches.azimuths),
        absolute=absolute,
        translation=np.zeros((2, Z, K)),
        support_stiffness=np.inf,  # as `GrooveCompliance.at`: places count from the ground
        unknowns=solid.stiffness.unknowns,
        elements=solid.space.mesh.ne,
        seconds={},
    )


def condensed(
    solid: FactoredSolid, progress: Callable[[float], None] = lambda fraction: None
) -> RacewayCompliance:
    """Compliance of a factored solid under rollers; `progress` gets the finished fraction of the solves.

    Raises `NotSolved` if a residual is too large, or the mesh too coarse for the patches.
    """
    patches = solid.patches
    with threads(solid.thread_number):
        absolute, translation, support = _responses(solid, progress)
    neighbouring = solid.of_order(neighbour(solid.space.globalorder))  # settles its threads by itself
    with threads(solid.thread_number):
        error, bar_response = _compared(solid, neighbouring)
    roller = np.arange(len(patches.azimuths))
    absolute[roller, :, roller] -= half_space(patches, solid.part.materials["ring"])
    return RacewayCompliance(
        azimuths=np.array(patches.azimuths),
        absolute=absolute,
        translation=translation,
        support_stiffness=2 / np.trace(support),
        unknowns=solid.stiffness.unknowns,
        elements=solid.space.mesh.ne,
        seconds={},
        support_error=error,
        bar_response=bar_response,
    )


def _compared(solid: FactoredSolid, other: FactoredSolid) -> tuple[float, BarResponse | None]:
    """Error of the support's stiffness, over it, by a solid of another order; what bars carry by both."""
    here, there = (_support_compliance(one) for one in (solid, other))
    cage = solid.part
    if not isinstance(cage, SquirrelCage):
        return abs(here / there - 1), None
    both = (_bar_response(one, cage) for one in (solid, other))
    return abs(here / there - 1), BarResponse(cage.bars, *both)


def _support_compliance(solid: FactoredSolid) -> float:
    """Mean translation per load like cos(phi) [m/N]."""
    forces = roller_loads.translation_forces(solid.band)
    return float(np.mean([f @ solid.stiffness.solve(f) for f in forces.T]))


def _bar_response(solid: FactoredSolid, cage: SquirrelCage) -> NDArray:
    """Section forces of bars at azimuth 0 by harmonics of roller forces (K, M, 6), by reciprocity."""
    band, length, M = solid.band, solid.patches.length, solid.patches.axial_modes
    last = min(ceil(FINENESS * M * band.radius / length), MOST_OF_BARS)
    n = np.arange(-last, last + 1)
    readings = bar_readings(solid.space, cage, half=False)
    moved = np.stack([solid.stiffness.solve(reading) for reading in readings.T], axis=1)
    outward = np.sin(band.azimuth)[:, None] * (band.along_y @ moved)
    outward += np.cos(band.azimuth)[:, None] * (band.along_z @ moved)
    shapes = (
        legendre.legvander(2 * band.x / length, M - 1)
        * (2 * np.arange(M) + 1)
        / (2 * pi * band.radius * length)
    )
    turn = n[:, None] * band.azimuth
    waves = [np.cos(turn) if mirrored else np.sin(turn) for mirrored in is_mirrored(readings.shape[1])]
    return np.stack([(wave * w) @ shapes for wave, w in zip(waves, outward.T, strict=True)], axis=2)


def _responses(solid: FactoredSolid, progress: Callable[[float], None]) -> tuple[NDArray, NDArray, NDArray]:
    """Absolute compliance (Z, M, Z, M), translations (2, Z, M) and support compliance (2, 2) [m/N]."""
    Z, M = len(solid.patches.azimuths), solid.patches.axial_modes
    rollers = roller_loads.roller_forces(solid.band, solid.patches)
    translations = roller_loads.translation_forces(solid.band)
    renumbered = (
        np.arange(Z)[None]  # no symmetry is known of a drawn solid
        if isinstance(solid.part, StepSolid)
        else symmetry.permutations(solid.patches.azimuths, solid.part.bars)
    )
    solved = symmetry.representatives(renumbered)
    columns = (solved[:, None] * M + np.arange(M)).ravel()
    loads = np.hstack([translations, rollers[:, columns].toarray()])
    displacements = np.empty_like(loads)
    for k, load in enumerate(loads.T):
        displacements[:, k] = solid.stiffness.solve(load)
        progress((k + 1) / loads.shape[1])
    at_rollers = rollers.T @ displacements
    absolute = symmetry.completed(at_rollers[:, 2:].reshape(Z, M, solved.size, M), solved, renumbered)
    return absolute, at_rollers[:, :2].T.reshape(2, Z, M), translations.T @ displacements[:, :2]
