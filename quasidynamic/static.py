"""The static load distribution: rollers between rigid rings without friction, film or centrifugal force."""

from dataclasses import dataclass
from functools import cached_property
from math import isfinite
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line import EXPONENT, LoadLaw, Slices, iso16281, palmgren
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing

TOLERANCE = 1e-11  # of the largest force: unbalanced force on the ring
STEPS = 60  # rarely more than ten: the energy is convex
HALVINGS = 40
STIFFENING = 1e-2  # of the whole stiffness over the relative imbalance, where no roller resists a direction


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
) -> StaticLoads:
    r"""Static load distribution between rigid rings.

    .. math:: \sum_j Q_j\, n_j = F,\quad \sum_j M_j\, n_j = M,\quad n_j = (\sin\varphi_j, \cos\varphi_j), \\
              q_{jk} = c\, [u \cdot n_j + x_k\, \theta \cdot n_j - G/2 - 2 C_k]_+^{10/9},\quad
              c^{-0.9} = c_i^{-0.9} + c_o^{-0.9}

    with Q_j and M_j the sums of q_jk and q_jk x_k over the slices of roller j, u the displacement and
    theta the slopes (dy/dx, dz/dx) of the inner ring. Newton's method on a convex energy.

    Parameters
    ----------
    bearing : CylindricalRollerBearing
        geometry, clearance G, profile drop C, materials and load law
    load : float
        F, radial load on the inner ring [N], >= 0
    direction : float
        azimuth the load points to [rad]
    moment : float
        M, tilts the ring in the plane of the load [N m]; at zero the ring stays straight by symmetry
    slices : int
        number of slices of each roller

    Returns
    -------
    StaticLoads

    Raises
    ------
    ImpossiblePart
        when the load cannot be
    NotSolved
        when nothing holds the ring

    Source
    ------
    ISO/TS 16281 (2008), cylindrical rollers, with both radial directions; load laws see `LoadLaw`.

    Valid
    -----
    Slow, rigid and round raceways; contact begins smoothly over `GAP_ROUNDING`. The approach of every
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
    own = Slices(slices, bearing.roller.length, 2 if moment else 1)
    along, half = np.array([np.sin(direction), np.cos(direction)]), own.length / 2
    rings = _Rings(
        law=_series_law(bearing),
        slices=own,
        normal=np.array([np.sin(bearing.azimuths), np.cos(bearing.azimuths)]).T,
        gap=bearing.clearance / 2 + 2 * bearing.roller.profile.drop(own.centres, own.length),
        load=np.outer(along, [load, moment / half][: own.axial_modes]),
    )
    found, steps = _balanced(rings, _first_place(rings))
    place, loads = found.place, found.slice_load
    return StaticLoads(
        loads=loads @ own.widths,
        slice_loads=own.unfolded(loads),
        approach=rings.normal @ place[:, 0] - bearing.clearance / 2,
        ring_displacement=place[:, 0],
        ring_tilt=place[::-1, 1] / half if own.axial_modes > 1 else np.zeros(2),
        stiffness=found.stiffness[:, 0, :, 0],
        iterations=steps,
    )


def _check(bearing: CylindricalRollerBearing, load: float, moment: float) -> None:
    """Refuse loads that cannot be, and a ring that nothing holds."""
    if not (isfinite(load) and load >= 0.0):
        raise ImpossiblePart(f"load = {load} N must be finite and >= 0: turn `direction` instead")
    if not isfinite(moment):
        raise ImpossiblePart(f"moment = {moment} N m must be finite")
    if load == 0.0 and moment == 0.0 and bearing.clearance >= 0.0:
        raise NotSolved(
            f"neither load nor moment, and a clearance of {bearing.clearance * 1e6:g} um: nothing holds "
            "the ring, its position is undetermined; give a load or a preload (negative clearance)"
        )


def _series_law(bearing: CylindricalRollerBearing) -> LoadLaw:
    """Law of both raceways of a roller together: approaches add up, the load is the same."""
    length, roller = bearing.roller.length, bearing.roller.material
    if bearing.contact_law == "iso16281":
        laws = [iso16281(length)] * 2
    else:
        laws = [palmgren(roller, ring, length) for ring in (bearing.inner_ring, bearing.outer_ring)]
    return LoadLaw(sum(law.coefficient ** (-1 / EXPONENT) for law in laws) ** -EXPONENT)


class _Balance(NamedTuple):
    """Forces on the ring at one place of it; M is 1 or 2, with tilt."""

    place: NDArray  # (2, M) y, z and half the length times dy/dx, dz/dx [m]
    slice_load: NDArray  # (Z, K) [N/m]
    excess: NDArray  # (2, M) load less what the rollers carry [N]
    stiffness: NDArray  # (2, M, 2, M) [N/m]


@dataclass(frozen=True)
class _Rings:
    """Two rigid rings with rollers between them."""

    law: LoadLaw  # of both raceways
    slices: Slices
    normal: NDArray  # (Z, 2) y, z of the outward radius at each roller
    gap: NDArray  # (K) that has to close before a slice carries [m]
    load: NDArray  # (2, M) [N] force along y, z and moment over half the length

    def at(self, place: NDArray) -> _Balance:
        """Evaluate every slice."""
        own, m = self.slices, self.slices.axial_modes
        load, slope = self.law(self.normal @ (place @ own.modes.T) - self.gap)
        stiffness = (self._squares @ (slope @ own.products)).reshape(2, 2, m, m).transpose(0, 2, 1, 3)
        return _Balance(place, load, self.load - self.normal.T @ (load @ own.weights), stiffness)

    @cached_property
    def _squares(self) -> NDArray:
        """Products of two components of the normals (4, Z) [-]."""
        return (self.normal[:, :, None] * self.normal[:, None, :]).reshape(-1, 4).T

    def imbalance(self, found: _Balance) -> float:
        """Largest unbalanced force over the largest force [-]."""
        size = max(np.abs(self.load).max(), (found.slice_load @ self.slices.widths).max())
        return float(np.abs(found.excess).max() / size)


def _first_place(rings: _Rings) -> NDArray:
    """Ring (2, M) where the nearest roller alone would carry the load: too far, but on the safe side."""
    load = rings.load[:, 0]
    size = float(np.hypot(*load))
    if size == 0.0:
        return np.zeros_like(rings.load)
    nearest = (rings.normal @ load).max() / size
    approach = rings.gap.min() + rings.law.approach(np.asarray(size / nearest / rings.slices.length))
    place = np.zeros_like(rings.load)
    place[:, 0] = load / size * max(approach, 0.0) / nearest
    return place


def _balanced(rings: _Rings, place: NDArray) -> tuple[_Balance, int]:
    """Place where the rollers carry the load, and the number of evaluations."""
    here, count = rings.at(place), 1
    for _ in range(STEPS):
        imbalance = rings.imbalance(here)
        if imbalance < TOLERANCE:
            return here, count
        here, tries = _next(rings, here, imbalance)
        count += tries
    raise NotSolved(
        f"the ring found no static balance in {STEPS} steps: {imbalance:.1e} of the largest force is left; "
        f"load {np.hypot(*rings.load[:, 0]):.4g} N, {len(rings.normal)} rollers"
    )


def _next(rings: _Rings, here: _Balance, imbalance: float) -> tuple[_Balance, int]:
    """A step of Newton's method, halved while it runs far past the lowest energy on its way.

    A direction in which hardly anything resists, such as sideways on a single roller, is stiffened
    as long as forces are out of balance; close to balance the step is that of Newton.
    """
    n = rings.load.size
    matrix = here.stiffness.reshape(n, n)
    stiffer = STIFFENING * min(imbalance, 1.0) * matrix.trace()
    step = np.linalg.solve(matrix + stiffer * np.eye(n), here.excess.ravel()).reshape(here.excess.shape)
    uphill = -0.5 * float((here.excess * step).sum())
    for halvings in range(HALVINGS):
        there = rings.at(here.place + step * 0.5**halvings)
        if float((there.excess * step).sum()) >= uphill:
            break
    return there, halvings + 1
