"""The static load distribution: rollers between rigid rings without friction, film or centrifugal force."""

from dataclasses import dataclass
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.rigid_rings import RigidRings
from quasidynamic.contact.line.slices import Slices
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing
from quasidynamic.solve.rollers.static_equilibrium import balanced


@dataclass(frozen=True)
class StaticLoads:
    """How rollers at rest share the load. Z rollers, K slices."""

    loads: NDArray  # (Z) [N] the same at both raceways
    slice_loads: NDArray  # (Z, K) load per length [N/m]
    approach: NDArray  # (Z) of both raceways together at mid-roller [m], profile drop not taken off
    ring_displacement: NDArray  # (2) y, z of the inner ring against the outer one [m]
    ring_tilt: NDArray  # (2) slopes dz/dx, dy/dx of the inner ring [rad]
    stiffness: NDArray  # (2, 2) tangent, force along y, z per displacement along y, z [N/m]; tilts held
    iterations: int  # evaluations of all contacts


def static_loads(
    bearing: CylindricalRollerBearing,
    load: float,
    direction: float = 0.0,
    moment: float = 0.0,
    slices: int = 30,
    tilt_direction: float = 0.0,
) -> StaticLoads:
    r"""Static load distribution between rigid rings.

    .. math:: \sum_j Q_j\, n_j = F,\quad \sum_j M_j\, n_j = M,\quad n_j = (\sin\varphi_j, \cos\varphi_j), \\
              q_{jk} = c\, [u \cdot n_j + x_k\, \theta \cdot n_j - G/2 - 2 C_k]_+^{10/9},\quad
              c^{-0.9} = c_i^{-0.9} + c_o^{-0.9}

    with Q_j and M_j the sums of q_jk and q_jk x_k over the slices of roller j, places x_k along the axis from
    the middle of the rings, u the displacement there and theta the slopes (dy/dx, dz/dx) of the inner ring.
    Newton's method on a convex energy.

    Parameters
    ----------
    bearing : CylindricalRollerBearing
        geometry, clearance G, profile drop C, materials and load law
    load : float
        F, radial load on the inner ring [N], >= 0
    direction : float
        azimuth the load points to [rad]
    moment : float
        M, tilts the ring [N m]; at zero a ring that is symmetric along its axis stays straight
    slices : int
        number of slices of each roller
    tilt_direction : float
        azimuth of the plane in which the moment tilts, from that of the load [rad]

    Raises
    ------
    ImpossiblePart
        when the load cannot be
    NotSolved
        when nothing holds the ring, or no balance is found

    Source
    ------
    ISO/TS 16281 (2008), cylindrical rollers, with both radial directions; load laws see `LoadLaw`.

    Valid
    -----
    Slow, rigid and round raceways; contact begins smoothly over `gap_rounding`. The approach of every
    slice is shared between the raceways as their load laws ask: exact for rings of one material and for
    straight rollers; else a profiled roller would have to bend a little to follow: half the modulus in one
    ring moves loads by 1e-4 and slice loads by 4 %.

    >>> from quasidynamic import Cage, Material, Roller
    >>> steel = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850)
    >>> bearing = CylindricalRollerBearing(
    ...     rollers=14, outer_raceway_diameter=75.032e-3, clearance=41e-6,
    ...     roller=Roller(diameter=10e-3, length=9.601e-3, material=steel),
    ...     cage=Cage(guidance="rollers", pocket_friction=0.0, thickness=5e-3, mass=0.1),
    ...     inner_ring=steel, outer_ring=steel, contact_law="iso16281")
    >>> round(float(static_loads(bearing, 4450.0).loads.max()), 1)
    1958.7
    """
    _check(bearing, load, moment)
    sliced = Slices(slices, bearing.roller.length, 2 if moment or not bearing.symmetric else 1)
    tilting, half = direction + tilt_direction, sliced.length / 2
    along = [np.sin(direction), np.cos(direction)], [np.sin(tilting), np.cos(tilting)]
    applied = np.transpose(along) * [load, moment / half]
    rings = RigidRings.of(bearing, sliced, applied[:, : sliced.axial_modes])
    state, evaluations = balanced(rings)
    return StaticLoads(
        loads=state.slice_load @ sliced.widths,
        slice_loads=sliced.unfolded(state.slice_load),
        approach=rings.stations.at_rollers(rings.normal @ state.place)[:, 0] - bearing.clearances / 2,
        ring_displacement=state.place[:, 0],
        ring_tilt=state.place[::-1, 1] / half if sliced.axial_modes > 1 else np.zeros(2),
        stiffness=state.stiffness[:, 0, :, 0],
        iterations=evaluations,
    )


def _check(bearing: CylindricalRollerBearing, load: float, moment: float) -> None:
    """Refuse loads that cannot be, and a ring that nothing holds."""
    if not (isfinite(load) and load >= 0.0):
        raise ImpossiblePart(f"load = {load} N must be finite and >= 0: turn `direction` instead")
    if not isfinite(moment):
        raise ImpossiblePart(f"moment = {moment} N m must be finite")
    if load == 0.0 and moment == 0.0 and np.min(bearing.clearances) >= 0.0:
        raise NotSolved(
            f"neither load nor moment, and a clearance of {bearing.clearance * 1e6:g} um: nothing holds "
            "the ring, its position is undetermined; give a load or a preload (negative clearance)",
            "undetermined",
        )
