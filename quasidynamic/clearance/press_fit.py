"""One round body pressed over another."""

import math
from dataclasses import dataclass

from quasidynamic.clearance.annulus import (
    Annulus,
    heat_displacement,
    pressure_displacement,
    rotation_displacement,
)
from quasidynamic.errors import ImpossiblePart


@dataclass(frozen=True, kw_only=True)
class PressFit:
    """Two bodies on one nominal radius, such as a ring on a shaft."""

    inside: Annulus
    outside: Annulus
    interference: float  # [m] diametral, cold, standing; negative is a loose fit

    def __post_init__(self):
        shaft, bore = self.inside.outer_radius, self.outside.inner_radius
        if not math.isclose(shaft, bore, rel_tol=1e-9):
            raise ImpossiblePart(
                f"fit: outer radius {1e3 * shaft:.6g} mm of the inside body and inner radius "
                f"{1e3 * bore:.6g} mm of the outside body must be the same nominal radius; give their "
                "difference as the interference"
            )
        if not abs(self.interference) < 0.02 * shaft:
            raise ImpossiblePart(
                f"interference of a fit = {1e6 * self.interference:.6g} um must stay below 1 % of the "
                f"diameter, {2e4 * shaft:.4g} um"
            )


@dataclass(frozen=True, kw_only=True)
class FitConditions:
    """Temperatures and speed of a mounted fit."""

    inside_rise: float = 0.0  # [K] over the reference temperature
    outside_rise: float = 0.0  # [K]
    speed: float = 0.0  # [rad/s] of both bodies together, also while the fit is open


@dataclass(frozen=True, kw_only=True)
class Seat:
    """How two bodies sit on each other; pressure or gap, never both."""

    pressure: float  # [Pa] >= 0
    gap: float  # [m] radial, >= 0

    @property
    def is_open(self) -> bool:
        """Whether the fit has opened: the bodies do not touch."""
        return self.gap > 0.0

    @property
    def words(self) -> str:
        """The seat in one phrase, MPa or um."""
        if self.is_open:
            return f"fit open by {2 * self.gap * 1e6:.1f} um in diameter, pressure zero"
        return f"fit pressure {self.pressure / 1e6:.3g} MPa"


def free_displacement(body: Annulus, radius: float, rise: float, speed: float) -> float:
    """Radial displacement [m], positive outwards, of a body alone at a radius [m], hot and turning.

    The rise [K] is over the reference temperature, the speed in rad/s.

    Source
    ------
    Superposition of `heat_displacement` with `rotation_displacement`.
    """
    return float(heat_displacement(body, radius, rise) + rotation_displacement(body, radius, speed))


def fit_compliance(fit: PressFit) -> float:
    r"""Radial interference that one pascal takes up.

    .. math:: c = u_2(R; p_a = 1) - u_1(R; p_b = 1)

    Parameters
    ----------
    fit : PressFit
        1 inside, 2 outside, R their common radius [m]

    Returns
    -------
    float
        c [m/Pa], > 0

    Source
    ------
    Timoshenko and Goodier, Theory of Elasticity (1970), art. 28, shrink fit of two cylinders.
    """
    stretch = pressure_displacement(fit.outside, fit.outside.inner_radius, 1.0, 0.0)
    squeeze = pressure_displacement(fit.inside, fit.inside.outer_radius, 0.0, 1.0)
    return float(stretch - squeeze)


def running_interference(fit: PressFit, conditions: FitConditions) -> float:
    r"""Overlap the two bodies would have if they did not touch.

    .. math:: \delta = \Delta/2 + u_1(R) - u_2(R)

    Parameters
    ----------
    fit : PressFit
        1 inside, 2 outside, R common radius [m], Delta diametral interference [m]
    conditions : FitConditions
        temperature rises [K], speed [rad/s]

    Returns
    -------
    float
        delta, radial [m], negative is a gap

    Source
    ------
    Geometry; u_1, u_2 from `free_displacement`.
    """
    shaft = free_displacement(fit.inside, fit.inside.outer_radius, conditions.inside_rise, conditions.speed)
    bore = free_displacement(fit.outside, fit.outside.inner_radius, conditions.outside_rise, conditions.speed)
    return fit.interference / 2 + shaft - bore


def seat(fit: PressFit, conditions: FitConditions) -> Seat:
    r"""Pressure of a fit, or the gap where it has opened.

    .. math:: p = \max(\delta, 0) / c, \qquad g = \max(-\delta, 0)

    The pressure has a kink where the fit opens.

    Parameters
    ----------
    fit : PressFit
        c from `fit_compliance` [m/Pa]
    conditions : FitConditions
        delta from `running_interference` [m]

    Returns
    -------
    Seat
        p [Pa], g radial [m]

    Source
    ------
    Timoshenko and Goodier, Theory of Elasticity (1970), art. 28, shrink fit of two cylinders.

    Valid
    -----
    Linear elastic; both bodies equally long, so that the pressure is even along the fit.
    """
    overlap = running_interference(fit, conditions)
    return Seat(pressure=max(overlap, 0.0) / fit_compliance(fit), gap=max(-overlap, 0.0))


def inside_displacement(fit: PressFit, conditions: FitConditions, radius: float) -> float:
    """Radial displacement [m], positive outwards, of the inside body at a radius [m], pressed from outside.

    For the outer ring of a bearing: ring inside, housing outside.

    Source
    ------
    Superposition of `free_displacement` with `pressure_displacement`.
    """
    free = free_displacement(fit.inside, radius, conditions.inside_rise, conditions.speed)
    return free + float(pressure_displacement(fit.inside, radius, 0.0, seat(fit, conditions).pressure))


def outside_displacement(fit: PressFit, conditions: FitConditions, radius: float) -> float:
    """Radial displacement [m], positive outwards, of the outside body at a radius [m], pressed from its bore.

    For the inner ring of a bearing: shaft inside, ring outside.

    Source
    ------
    Superposition of `free_displacement` with `pressure_displacement`.
    """
    free = free_displacement(fit.outside, radius, conditions.outside_rise, conditions.speed)
    return free + float(pressure_displacement(fit.outside, radius, seat(fit, conditions).pressure, 0.0))
