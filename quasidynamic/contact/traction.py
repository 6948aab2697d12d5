"""Traction of a slice from its slip, load and film."""

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.hertz import half_width
from quasidynamic.parts.lubricant import Lubricant


class Traction(NamedTuple):
    """Traction per length [N/m], signed like the sliding, with its derivatives."""

    force: NDArray
    by_load: NDArray  # d/dq [-]
    by_sliding: NDArray  # [N s/m2]
    by_entrainment: NDArray  # [N s/m2]


class TractionLaw(Protocol):
    """Maps load per length, sliding, entrainment speed and film to a traction."""

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Evaluate on arrays that broadcast against each other."""
        ...


@dataclass(frozen=True, kw_only=True)
class Regression4109:
    r"""Four-coefficient traction curve of the aviation oil 4109.

    .. math:: \mu(S) = (A + B S) e^{-C S} + D,\quad
              X = X_0 P^{x_1} \bar U^{x_2} \Theta^{x_3},\quad A = -D

    with S = |sliding|/u, P = Q/(E'R^2), U = eta0 u/(E'R), Theta = k T0/(eta0 u^2), T0 in kelvin.

    Source
    ------
    Regression published for 4109 oil (Wang et al.), as used in quasi-dynamic bearing programs.

    Valid
    -----
    Calibrated on point contacts; for a line contact Q = q l is outside the calibration.
    """

    radius: float  # [m] R
    modulus: float  # [Pa] E'
    length: float  # [m] l, turns a load per length into Q
    oil: Lubricant
    load_floor: float = 1.0  # [N] below it the coefficients keep their value: P^-0.37 would diverge

    # X0, exponents of P, U and Theta
    _FORMULA = np.array(
        [
            [6.96e2, -0.163, 0.577, 0.308],  # D
            [5.19e6, -0.373, 1.000, 0.687],  # B
            [6.826e5, -0.170, 0.578, 0.373],  # C
        ]
    )

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Traction; the film does not enter this law."""
        load = np.hypot(line_load * self.length, self.load_floor)
        d, b, c = self._coefficients(load, entrainment)
        slip = np.abs(sliding) / entrainment
        decay = np.exp(-c * slip)
        curve = d * (1 - decay) + b * slip * decay
        by_slip = decay * (d * c + b * (1 - c * slip))
        # d mu/d ln X for X = D, B, C
        shares = (d * (1 - decay), b * slip * decay, c * slip * decay * (d - b * slip))
        by_log_load = sum(row[1] * share for row, share in zip(self._FORMULA, shares, strict=True))
        by_log_speed = sum(
            (row[2] - 2 * row[3]) * share for row, share in zip(self._FORMULA, shares, strict=True)
        )
        sign = np.sign(sliding)
        return Traction(
            force=sign * line_load * curve,
            by_load=sign * (curve + by_log_load * (line_load * self.length / load) ** 2),
            by_sliding=line_load * by_slip / entrainment,
            by_entrainment=sign * line_load * (by_log_speed - by_slip * slip) / entrainment,
        )

    def _coefficients(self, load: NDArray, entrainment: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        oil = self.oil
        pressure = load / (self.modulus * self.radius**2)
        speed = oil.viscosity * entrainment / (self.modulus * self.radius)
        heat = oil.conductivity * oil.temperature / (oil.viscosity * entrainment**2)
        d, b, c = (x0 * pressure**p * speed**u * heat**t for x0, p, u, t in self._FORMULA)
        return d, b, c


@dataclass(frozen=True, kw_only=True)
class EyringLimited:
    r"""Eyring film with a limiting shear stress, isothermal.

    .. math:: \tau = \min[\tau_E \sinh^{-1}(\eta u_s/(\tau_E h)),\; \Lambda \bar p],\quad
              \bar p = \tfrac{\pi}{4} p_0

    acting on the strip of width 2b; Roelands viscosity at the mean pressure. The cap is a kink.

    Source
    ------
    Evans and Johnson (1986); Arana, Larranaga and Ulacia (2019), Eqs (7) and (13).

    Valid
    -----
    Small film heating (slide-to-roll ratio below about 1 %); above, it overestimates.
    """

    radius: float  # [m] R
    modulus: float  # [Pa] E'
    length: float  # [m] l
    oil: Lubricant
    limiting_ratio: float  # [-] Lambda
    eyring_stress: float  # [Pa] tau_E
    load_floor: float = 1.0  # [N] below it strip width over load keeps its value

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Traction; the entrainment speed enters through the film alone."""
        load = np.hypot(line_load, self.load_floor / self.length)
        strip = 2 * half_width(load, self.radius, self.modulus)
        mean_pressure = load / strip
        viscosity, by_pressure = roelands(mean_pressure, self.oil)
        rate = viscosity * np.abs(sliding) / (self.eyring_stress * film)
        stress = self.eyring_stress * np.arcsinh(rate)
        steepness = 1 / np.hypot(1.0, rate)  # d asinh
        capped = stress > self.limiting_ratio * mean_pressure
        stress = np.where(capped, self.limiting_ratio * mean_pressure, stress)
        by_sliding = np.where(capped, 0.0, viscosity / film * steepness)
        by_pressure = np.where(
            capped, self.limiting_ratio, self.eyring_stress * steepness * rate * by_pressure / viscosity
        )
        # force = q (strip/load) stress; strip/load = 1/p_mean, and p_mean ~ load^(1/2)
        log_load = (line_load / load) ** 2  # d ln load / d ln q
        coefficient = stress / mean_pressure
        sign = np.sign(sliding)
        return Traction(
            force=sign * line_load * coefficient,
            by_load=sign * (coefficient + 0.5 * log_load * (by_pressure - coefficient)),
            by_sliding=line_load * by_sliding / mean_pressure,
            by_entrainment=np.zeros_like(line_load * sliding),
        )


def roelands(pressure: NDArray, oil: Lubricant) -> tuple[NDArray, NDArray]:
    r"""Viscosity under pressure, and its derivative.

    .. math:: \eta = \eta_0 \exp\{(\ln\eta_0 + 9.67)[(1 + p/p_r)^Z - 1]\},\quad
              Z = \alpha p_r/(\ln\eta_0 + 9.67),\; p_r = 1.962\cdot 10^8\,\mathrm{Pa}

    Parameters
    ----------
    pressure : array (...)
        p [Pa]
    oil : Lubricant
        eta0 and alpha at the inlet

    Returns
    -------
    tuple of array (...)
        viscosity [Pa s], its derivative by pressure [s]

    Source
    ------
    Roelands (1966).
    """
    reference = 1.962e8
    span = np.log(oil.viscosity) + 9.67
    exponent = oil.pressure_viscosity * reference / span
    ratio = 1 + pressure / reference
    viscosity = oil.viscosity * np.exp(span * (ratio**exponent - 1))
    return viscosity, viscosity * span * exponent * ratio ** (exponent - 1) / reference
