"""Strain and displacement that gauges and sensors read of a loaded part."""

from collections.abc import Sequence
from math import ceil, cos, degrees, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from fem.parts.material import ImpossiblePart, in_mm
from fem.parts.part import Part
from fem.parts.probe import Probe, radius
from fem.parts.step_solid import StepSolid
from fem.solid.extremes import CAUTION, Sampled
from fem.solid.lattice import hooke_reversed

ON_A_PATCH = 5  # points along a gauge on the width of a load patch, as far as strain varies


class Readings(NamedTuple):
    """Means over the lengths of P probes."""

    azimuth: NDArray  # (P,) [rad]
    displacement: NDArray  # (3, P) along x, outward, towards growing azimuth [m]
    strain: NDArray  # (6, P) xx, rr, tt, 2 xr, 2 rt, 2 xt [-] that stress makes
    angle: NDArray  # (P,) of each probe to the circumference [rad]
    strain_error: NDArray  # (P,) estimated, of the strains [-], >= 0

    @property
    def gauge_strain(self) -> NDArray:
        r"""Strain along each probe (P,) [-].

        .. math:: \varepsilon = \varepsilon_t \cos^2\alpha + \varepsilon_x \sin^2\alpha
                  + \gamma_{xt} \sin\alpha \cos\alpha

        Source
        ------
        Turned axes of a strain; any text on strain gauges.
        """
        (axial, _, hoop, *_, shear), s, c = self.strain, np.sin(self.angle), np.cos(self.angle)
        return hoop * c**2 + axial * s**2 + shear * s * c

    @property
    def principal_strains(self) -> NDArray:
        """Larger and smaller principal strain in the surface (2, P) [-], as a rosette gives them."""
        axial, _, hoop, *_, shear = self.strain
        return (hoop + axial) / 2 + np.multiply.outer([0.5, -0.5], np.hypot(hoop - axial, shear))


def readings(sampled: Sampled, part: Part | StepSolid, probes: Sequence[Probe], width: float) -> Readings:
    """Read probes of a loaded part by two orders of displacements; load patches have a `width` [m].

    The error is twice the largest change of a strain from the lower order of displacements.
    Raises `ImpossiblePart` where the part has no material.

    Valid
    -----
    As the loaded part: under a roller the load patch is not its contact, whose strain is another one.
    """
    lines = [_line(part, probe, width) for probe in probes]
    places, weights = np.concatenate([line[0] for line in lines]), [line[1] for line in lines]
    starts = np.cumsum([0, *map(len, weights[:-1])])
    values, others = (
        np.add.reduceat(each * np.concatenate(weights)[:, None], starts)
        for each in (_at(sampled, part, places, higher=higher) for higher in (True, False))
    )
    for probe, row in zip(probes, values + others, strict=True):
        if np.isnan(row).any():
            where = f"x = {in_mm(probe.x)}, {degrees(probe.azimuth):.4g} deg"
            raise ImpossiblePart(f"a probe at {where} reaches beyond the material")
    error = CAUTION * np.abs(values - others)[:, 3:].max(axis=1)
    azimuth, angle = np.array([(probe.azimuth, probe.angle) for probe in probes]).T
    return Readings(azimuth, values[:, :3].T, values[:, 3:].T, angle, error)


def _line(part: Part | StepSolid, probe: Probe, width: float) -> tuple[NDArray, NDArray]:
    """Places (n, 3) along a probe, and their weights (n,) in its mean."""
    r = radius(part, probe)
    intervals = ceil(probe.length / width)
    nodes, weights = np.polynomial.legendre.leggauss(ON_A_PATCH) if intervals else (np.zeros(1), np.ones(1))
    intervals = max(intervals, 1)
    ends = (2 * np.arange(intervals) + 1) / intervals - 1
    along = (ends[:, None] + nodes / intervals).ravel() * probe.length / 2
    azimuth = probe.azimuth + along * cos(probe.angle) / r
    places = np.stack([probe.x + along * sin(probe.angle), r * np.sin(azimuth), r * np.cos(azimuth)], axis=1)
    return places, np.tile(weights / weights.sum() / intervals, intervals)


def _at(sampled: Sampled, part: Part | StepSolid, places: NDArray, *, higher: bool) -> NDArray:
    """Displacement and strain (n, 9) at places (n, 3), not a number outside of the part."""
    different, inverse = np.unique(places, axis=0, return_inverse=True)  # gauges of a rosette share theirs
    found, tree = np.full((len(different), 9), np.nan), KDTree(different)
    for body, elastic in part.materials.items():
        for piece in sampled.pieces(body):
            samples = sampled.at(body, piece, different, higher=higher)
            which = np.asarray(tree.query(samples.place)[1])
            strain = hooke_reversed(samples.stress, elastic)
            new = np.isnan(found[which, 0])  # a place between two bodies reads the first
            found[which[new]] = np.hstack([samples.displacement, strain])[new]
    return found[inverse]
