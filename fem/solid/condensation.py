"""The stiffness of a ring condensed to what rollers feel on its raceway."""

from collections.abc import Callable

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly import elasticity, roller_loads as load
from fem.assembly.factorisation import Factorisation, factorised, threads
from fem.half_space.load_patch import half_space
from fem.mesh.solid import MILLIMETRES, meshed
from fem.parts.resolution import Resolution
from fem.parts.rings import Elastic, Part, Patches
from fem.parts.step_solid import StepSolid
from fem.raceway import symmetry
from fem.raceway.compliance import RacewayCompliance
from fem.stages import Stage


def condense_solid(part: Part | StepSolid, resolution: Resolution, stage: Stage) -> RacewayCompliance:
    """Compliance of a raceway to its rollers, by as few solves as symmetry leaves.

    Parameters
    ----------
    part : Part or StepSolid
        ring with its seat
    resolution : Resolution
        of rollers, patches and mesh
    stage : callable (name)
        around "mesh", "factor" and "condense"

    Returns
    -------
    RacewayCompliance
        without times

    Raises
    ------
    ImpossiblePart
        if the loaded band is longer than the track, or a drawing does not hold such a part
    NotSolved
        if a residual is too large, or the mesh too coarse for the patches

    Valid
    -----
    Small displacement, perfect bonds, rigid clamps; no load outside the band.
    """
    patches, mesh = resolution.patches, resolution.mesh
    with stage("mesh"):
        solid = meshed(part, patches.length, mesh)
    with threads(resolution.threads):
        with stage("factor"):
            space = ngs.VectorH1(solid, order=mesh.order, dirichlet="clamped")
            stiffness = factorised(space, elastic_energy(solid, part.materials))
        with stage("condense") as progress:
            band = load.band(space, "raceway", load.quadrature_order(patches, mesh))
            return condensed(part, patches, stiffness, band, progress)


def condensed(
    part: Part | StepSolid,
    patches: Patches,
    stiffness: Factorisation,
    band: load.Band,
    progress: Callable[[float], None] = lambda fraction: None,
) -> RacewayCompliance:
    """Compliance of a raceway whose stiffness is factored.

    Parameters
    ----------
    part : Part or StepSolid
        ring with its seat
    patches : Patches
        rollers, and how finely their forces are resolved
    stiffness : Factorisation
        of the part
    band : Band
        its raceway
    progress : callable (fraction)
        told the finished fraction of the solves

    Returns
    -------
    RacewayCompliance
        without times

    Raises
    ------
    NotSolved
        if a residual is too large, or the mesh too coarse for the patches
    """
    absolute, translation, support = _answers(stiffness, band, _renumbered(part, patches), patches, progress)
    own = np.arange(len(patches.azimuths))
    absolute[own, :, own] -= half_space(patches, part.materials["ring"])
    return RacewayCompliance(
        azimuths=np.array(patches.azimuths),
        absolute=absolute,
        translation=translation,
        support_stiffness=2 / np.trace(support),
        unknowns=stiffness.unknowns,
        elements=stiffness.form.space.mesh.ne,
        seconds={},
    )


def elastic_energy(mesh, materials: dict[str, Elastic]):
    """Weak form of a body of several materials on a mesh in millimetres.

    Parameters
    ----------
    mesh : ngsolve.Mesh
        in millimetres, with named bodies
    materials : dict
        `Elastic` of every body by its name

    Returns
    -------
    callable (u, v)
        the form whose matrix is in N/m: a modulus in Pa integrated over millimetres is one in mN/m
    """
    constants = {
        name: elasticity.lame_constants(m.youngs_modulus, m.poisson_ratio) for name, m in materials.items()
    }
    lame, shear = (
        mesh.MaterialCF({name: values[k] / MILLIMETRES for name, values in constants.items()}) for k in (0, 1)
    )
    return lambda u, v: elasticity.elasticity(u, v, lame, shear)


def _renumbered(part: Part | StepSolid, patches: Patches) -> NDArray:
    """Renumberings of the rollers that change nothing; of a drawn solid no symmetry is known."""
    if isinstance(part, StepSolid):
        return np.arange(len(patches.azimuths))[None]
    return symmetry.permutations(patches.azimuths, part.bars)


def _answers(stiffness: Factorisation, band: load.Band, renumbered: NDArray, patches: Patches, progress):
    """Full compliance (Z, M, Z, M), translations (2, Z, M) and support compliance (2, 2) [m/N]."""
    Z, M = len(patches.azimuths), patches.axial_modes
    rollers, translations = load.roller_forces(band, patches), load.translation_forces(band)
    solved = symmetry.representatives(renumbered)
    needed = (solved[:, None] * M + np.arange(M)).ravel()
    sides = np.hstack([translations, rollers[:, needed].toarray()])
    shifts = np.empty_like(sides)
    for k, side in enumerate(sides.T):
        shifts[:, k] = stiffness.solve(side)
        progress((k + 1) / sides.shape[1])
    read = rollers.T @ shifts
    absolute = symmetry.completed(read[:, 2:].reshape(Z, M, solved.size, M), solved, renumbered)
    return absolute, read[:, :2].T.reshape(2, Z, M), translations.T @ shifts[:, :2]
