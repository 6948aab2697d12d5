"""The raceway of a plain outer ring on any of its supports."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import inf

import numpy as np
from numpy.typing import NDArray

from fem.assembly.factorisation import threads
from fem.parts.boundary_conditions import LineSupports, PlanetGear
from fem.parts.rings import ImpossiblePart, MeshSize, OuterRing, RingOnShaft
from fem.raceway.harmonics import HarmonicCompliance
from fem.section import expansion, free_ring, revolved
from fem.section.free_ring import FreeRing
from fem.section.rigid_body_modes import body_of, held_on_points
from fem.section.ring_on_lines import RingOnLines, require_held
from fem.solid.condensation import RacewayCompliance


@dataclass(frozen=True)
class PlanetRim:
    """A condensed planet gear: its raceway deviates from its own mean place and tilt.

    That place is a matter of the rollers, which balance the tooth forces. What they leave out of balance
    meets a pressure on the raceway like cos(phi).
    """

    ring: FreeRing
    gear: PlanetGear

    def at(self, azimuths) -> RacewayCompliance:
        """Compliance for rollers at given azimuths, and the deviation by the tooth forces.

        Parameters
        ----------
        azimuths : array (Z,)
            phi of the rollers, all different [rad]

        Returns
        -------
        RacewayCompliance
            without translation, its support infinitely stiff

        Raises
        ------
        ImpossiblePart
            if two rollers stand at one azimuth
        NotSolved
            if the harmonics end too early for the own terms
        """
        phi = np.asarray(azimuths, dtype=float)
        absolute = self.ring.raceway.absolute(phi)
        psi, radial, tangential = np.array(
            [(force.azimuth, force.radial, force.tangential) for force in self.gear.forces]
        ).reshape(-1, 3).T  # fmt: skip
        deviation = self.ring.under_radial(phi, psi)[..., 0] @ radial
        deviation += self.ring.under_tangential(phi, psi) @ tangential
        return RacewayCompliance(
            azimuths=phi,
            absolute=absolute,
            translation=np.zeros((2, *deviation.shape)),
            support_stiffness=inf,
            unknowns=self.ring.raceway.unknowns,
            elements=self.ring.raceway.elements,
            seconds=self.ring.raceway.seconds,
            initial_deviation=deviation,
        )


@dataclass(frozen=True, kw_only=True)
class AxisymmetricLoad:
    """Heat and rotation of a part, by the names of its bodies."""

    thermal_strains: Mapping[str, float | expansion.Along] = field(default_factory=dict)  # alpha (T - T0) [-]
    densities: Mapping[str, float] = field(default_factory=dict)  # [kg/m^3], needed if it turns
    speed: float = 0.0  # [rad/s]


def condense(
    part: OuterRing, length: float, axial_modes: int, mesh: MeshSize, harmonics: int | None = None
) -> HarmonicCompliance | RingOnLines | PlanetRim:
    """Compliance of the raceway of a plain outer ring, for rollers anywhere.

    Parameters
    ----------
    part : OuterRing
        with its support
    length, axial_modes, mesh
        as for `fem.section.revolved.condense`
    harmonics : int
        N, the highest; by default what the band needs, and line supports and tooth forces

    Returns
    -------
    HarmonicCompliance, RingOnLines or PlanetRim
        whose `at` gives the compliance of rollers at their azimuths

    Raises
    ------
    ImpossiblePart
        if the band is longer than the track, or if the ring can still move freely
    NotSolved
        if a solve fails, or if the mesh is too coarse for the harmonics

    Valid
    -----
    Small displacement, perfect bonds, supports without friction or mass of their own; no load outside
    the band.
    """
    support = part.support
    if isinstance(support, LineSupports):
        require_held(support, axial_modes)
        return RingOnLines(free_ring.condense(part, length, axial_modes, mesh, harmonics), support)
    if isinstance(support, PlanetGear):
        return PlanetRim(free_ring.condense(part, length, axial_modes, mesh, harmonics), support)
    last = free_ring.last_harmonic(part, length / axial_modes, mesh, harmonics)
    return revolved.condense(part, length, axial_modes, mesh, last)


def raceway_expansion(
    part: OuterRing | RingOnShaft, length: float, axial_modes: int, mesh: MeshSize, load: AxisymmetricLoad
) -> NDArray:
    """Growth of a raceway by heat and rotation, as it is supported.

    Parameters
    ----------
    part : OuterRing, RingOnShaft
        body of revolution; a planet gear grows freely
    length, axial_modes, mesh
        as for `condense`
    load : AxisymmetricLoad
        of all bodies of the part; clamps, springs and what they stand on stay as they are

    Returns
    -------
    array (M,)
        w_m [m] outward, mean displacement first

    Raises
    ------
    ImpossiblePart
        on line supports, against which a ring grows into waves
    NotSolved
        if the solve fails
    """
    if isinstance(part, OuterRing) and isinstance(part.support, LineSupports):
        raise ImpossiblePart("expansion on line supports is impossible; allowed are supports of revolution")
    with threads(1):
        body = body_of(part, length, mesh)
        f = np.zeros(body.stiffness.unknowns)
        if any(load.thermal_strains.values()):
            f += expansion.heating(body, load.thermal_strains)
        if load.speed != 0:
            f += expansion.rotation(body, load.densities, load.speed)
        held = replace(body, stiffness=held_on_points(body, part.free_motions, 0))
        return expansion.radial_expansion(held, f, "raceway", axial_modes)
