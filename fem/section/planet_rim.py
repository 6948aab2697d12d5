"""The rim of a planet gear between its rollers and the tooth forces."""

from dataclasses import dataclass
from math import inf

import numpy as np

from fem.parts.boundary_conditions import PlanetGear
from fem.raceway.compliance import RacewayCompliance
from fem.raceway.harmonics import HarmonicCompliance
from fem.section.free_ring import FreeRing


@dataclass(frozen=True)
class PlanetRim:
    """A condensed planet gear: its raceway deviates from its own mean place and tilt.

    That place is a matter of the rollers, which balance the tooth forces. What they leave out of balance
    meets a pressure on the raceway like cos(phi).
    """

    ring: FreeRing
    gear: PlanetGear

    def at(self, azimuths) -> RacewayCompliance:
        """Compliance for rollers at different azimuths (Z,) [rad], and the deviation by the tooth forces.

        It is without translation, its support infinitely stiff.
        Raises `ImpossiblePart` if two rollers stand at one azimuth, `NotSolved` if the harmonics end too
        early for the own terms.
        """
        phi = np.asarray(azimuths, dtype=float)
        absolute = self.ring.raceway.absolute(phi)
        psi, radial, tangential, axial = np.array(
            [(each.azimuth, each.radial, each.tangential, each.axial) for each in self.gear.forces]
        ).reshape(-1, 4).T  # fmt: skip
        lines, beyond = self.ring.lines, 0.0
        if self.gear.radius is not None:
            beyond = self.gear.radius - lines.radius
        by_radial = self.ring.under_radial(phi, psi)
        deviation = by_radial[..., 0] @ radial
        deviation += self.ring.under_tangential(phi, psi) @ tangential
        if beyond:
            deviation += self.ring.under_couple(phi, psi) @ (tangential * beyond)
        if axial.any():  # beyond the surface with a couple, that of radial forces like x
            deviation += self.ring.under_axial(phi, psi) @ axial
            deviation -= by_radial[..., 1] @ (axial * beyond / (lines.length / 2))
        if isinstance(self.ring.raceway, HarmonicCompliance):
            deviation = self.ring.raceway.of_rows(deviation)
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
