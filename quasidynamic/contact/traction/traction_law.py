"""Traction of a slice from its slip, load and film."""

from dataclasses import dataclass
from functools import cached_property
from math import log
from typing import Any, NamedTuple, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line import SMALLEST_LOAD
from quasidynamic.parts.oil_properties import Lubricant

Law = TypeVar("Law")


class Traction(NamedTuple):
    """Traction per length [N/m], signed like the sliding, with its derivatives."""

    force: NDArray
    by_load: NDArray  # d/dq [-]
    by_sliding: NDArray  # [N s/m2]
    by_entrainment: NDArray  # [N s/m2]
    by_film: NDArray  # [N/m2]


class TractionLaw(Protocol):
    """Maps load per length, sliding, entrainment speed and film to a traction."""

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Evaluate on arrays that broadcast against each other."""
        ...


def in_any_contact(law: Law, **_: Any) -> Law:
    """The law itself: it is that of a contact of any radius, modulus, length and oil."""
    return law


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

    radius: NDArray | float  # [m] R
    modulus: NDArray | float  # [Pa] E'
    length: NDArray | float  # [m] l, turns a load per length into Q
    oil: Lubricant
    smallest_load: float = SMALLEST_LOAD  # [-] q/(E' R) below which coefficients keep their value

    # X0, exponents of P, U and Theta
    _FORMULA = np.array(
        [
            [6.96e2, -0.163, 0.577, 0.308],  # D
            [5.19e6, -0.373, 1.000, 0.687],  # B
            [6.826e5, -0.170, 0.578, 0.373],  # C
        ]
    )
    _LOAD_POWERS = _FORMULA[:, 1]
    _SPEED_POWERS = _FORMULA[:, 2] - 2 * _FORMULA[:, 3]  # of the entrainment speed, in U and Theta
    # of ln D, ln B and ln C by ln(load), and by ln(speed) at constant sliding, where S falls as speed rises
    _LOG_SLOPES = np.array([_LOAD_POWERS, _SPEED_POWERS - [0, 1, 1]])

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Traction; the film does not enter this law."""
        share = line_load * self._per_smallest_load
        squared = share * share
        floored = 1 + squared  # square of the load over the smallest one, rounded
        slip, log_speed, log_load = np.abs(sliding) / entrainment, np.log(entrainment), np.log(floored)
        d, b, c = (
            np.exp((at_smallest + by_speed * log_speed) + by_load * log_load)
            for at_smallest, by_speed, by_load in self._logarithmic
        )
        decay = np.exp(c * -slip)
        fading, steepness = d * decay, b * decay
        climb = steepness * slip
        plateau, excess = d - fading, fading - climb
        curve, falling = plateau + climb, excess * c
        # d mu / d ln D = plateau, d mu / d ln B = climb, d mu / d ln C = falling slip
        shares = np.array([plateau, climb, falling * slip])
        by_log_load, by_log_speed = (self._LOG_SLOPES @ shares.reshape(3, -1)).reshape(2, *curve.shape)
        sign, load_per_speed = np.sign(sliding), line_load / entrainment
        return Traction(
            force=sign * line_load * curve,
            by_load=sign * (curve + by_log_load * (squared / floored)),
            by_sliding=load_per_speed * (falling + steepness),
            by_entrainment=sign * load_per_speed * by_log_speed,
            by_film=np.zeros(curve.shape),
        )

    @cached_property
    def _per_smallest_load(self) -> NDArray | float:
        return 1 / (self.smallest_load * self.modulus * self.radius)

    @cached_property
    def _logarithmic(self) -> list[tuple[NDArray, float, float]]:
        """Of D, B and C: ln at the smallest load and unit speed, powers of the speed and of `floored`."""
        oil, elastic = self.oil, self.modulus * self.radius
        pressure = np.log(self.smallest_load * self.length / self.radius)
        speed = np.log(oil.viscosity / elastic)
        heat = np.log(oil.conductivity * oil.temperature / oil.viscosity)
        return [
            (log(x0) + p * pressure + u * speed + t * heat, u - 2 * t, p / 2)
            for x0, p, u, t in self._FORMULA.tolist()
        ]
