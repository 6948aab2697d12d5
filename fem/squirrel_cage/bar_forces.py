"""Section forces of the bars of a squirrel cage, with the nominal stresses that beam theory makes of them.

At a sharp foot of a bar the stress itself has no finite value; section forces have, on any mesh.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fem.parts.bar_section import BarSection, bar_section
from fem.parts.squirrel_cage import SquirrelCage
from fem.raceway.bar_response import BarResponse


@dataclass(frozen=True, kw_only=True)
class BarForces:
    """What the bars carry at their two ends, at the ring and at the flange; of many cases (C, B, ..)."""

    azimuths: NDArray  # (B,) [rad]
    axial: NDArray  # (B,) [N] tension positive
    radial_moment: NDArray  # (B, 2) [N m] bends the bar radially, positive: tension outside
    tangential_moment: NDArray  # (B, 2) [N m] bends it tangentially, positive: tension at larger azimuth
    torque: NDArray  # (B,) [N m] of the part beyond on the part before a section, positive about +x
    length: float  # [m]
    section: BarSection

    @property
    def radial_shear(self) -> NDArray:
        r"""Outward force of the ring on the bar (B,) [N].

        .. math:: Q_n = (M_n(0) - M_n(L)) / L

        Source
        ------
        Balance of the moments on a bar that is loaded at its ends only; derived here.
        """
        return (self.radial_moment[..., 0] - self.radial_moment[..., 1]) / self.length

    @property
    def tangential_shear(self) -> NDArray:
        """Force of the ring on the bar towards larger azimuth (B,) [N]."""
        return (self.tangential_moment[..., 0] - self.tangential_moment[..., 1]) / self.length

    @property
    def stress(self) -> NDArray:
        r"""Largest nominal normal stress of the sections at both ends, by magnitude (B, 2) [Pa].

        .. math:: \sigma = \frac{N}{A} + \frac{M_n}{I_n}(n - n_0) + \frac{M_t}{I_t}\,t

        Source
        ------
        Beam theory, e.g. Timoshenko, Strength of Materials, part I.

        Valid
        -----
        Bars a few times longer than thick; without the stress concentration of feet and fillets.
        """
        bending = np.stack([self.radial_moment, self.tangential_moment], axis=-1) / self.section.inertia
        at_corners = bending @ self.section.corners.T + (self.axial / self.section.area)[..., None, None]
        return np.abs(at_corners).max(axis=-1)

    @property
    def torsion_stress(self) -> NDArray:
        """Largest shear stress of the torque, by magnitude, in the middle of the longer side (B,) [Pa]."""
        return np.abs(self.torque) / self.section.torsion_modulus


@dataclass(frozen=True, kw_only=True)
class NominalStresses:
    """Section forces of the bars at a state, with the discretisation error of their stresses."""

    forces: BarForces
    of_other_order: BarForces | None = None  # by displacements of another order; None where bars are spread

    @property
    def error(self) -> Any:
        """Estimated error of the largest nominal stress [Pa] or (C); None where bars are spread."""
        if self.of_other_order is None:
            return None
        return np.abs(self.forces.stress - self.of_other_order.stress).max(axis=(-2, -1))

    @property
    def largest(self) -> Any:
        """Largest nominal normal stress of all bars, by magnitude [Pa]; (C) of many cases."""
        return self.forces.stress.max(axis=(-2, -1))


def nominal_stresses(
    cage: SquirrelCage, response: BarResponse, azimuths: NDArray, forces: NDArray
) -> NominalStresses:
    """Section forces and nominal stresses of all bars under generalised forces (..., Z, M) [N], outward.

    The error is the largest change of a nominal stress from another order of displacements.
    """
    these, others = response.under(azimuths, forces)
    bars = _bar_forces(cage, response, these)
    return NominalStresses(
        forces=bars, of_other_order=None if others is None else _bar_forces(cage, response, others)
    )


def _bar_forces(cage: SquirrelCage, response: BarResponse, section_forces: NDArray) -> BarForces:
    axial, near_n, far_n, near_t, far_t, torque = np.moveaxis(section_forces, -1, 0)
    return BarForces(
        azimuths=response.azimuths,
        axial=axial,
        radial_moment=np.stack([near_n, far_n], axis=-1),
        tangential_moment=np.stack([near_t, far_t], axis=-1),
        torque=torque,
        length=cage.bar_length,
        section=bar_section(cage),
    )
