"""Traction of a slice from its slip, load and film."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from quasidynamic.parts.lubricant import Lubricant


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
    _LOAD_POWERS = _FORMULA[:, 1]
    _SPEED_POWERS = _FORMULA[:, 2] - 2 * _FORMULA[:, 3]  # of the entrainment speed, in U and Theta
    # How plateau, climb and fading below follow ln(load), and ln(speed): there S falls as the speed grows.
    _LOG_SLOPES = np.array([_LOAD_POWERS, _SPEED_POWERS - [0, 1, 1]])

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Traction; the film does not enter this law."""
        share = line_load * (self.length / self.load_floor)
        squared = share * share
        floored = 1 + squared  # square of the load over its floor, rounded
        slip = np.abs(sliding) / entrainment
        by_load = np.exp(np.multiply.outer(self._LOAD_POWERS / 2, np.log(floored)))
        by_speed = np.exp(np.multiply.outer(self._SPEED_POWERS, np.log(entrainment)))
        d, b, c = (x * y * z for x, y, z in zip(self._at_floor, by_speed, by_load, strict=True))
        fall = c * slip
        decay = np.exp(-fall)
        left, climb = d * decay, b * slip * decay
        plateau, excess = d - left, left - climb
        curve, fading = plateau + climb, excess * fall
        # d mu / d ln D = plateau, d mu / d ln B = climb, d mu / d ln C = fading
        shares = np.array([plateau, climb, fading])
        by_log_load, by_log_speed = (self._LOG_SLOPES @ shares.reshape(3, -1)).reshape(2, *curve.shape)
        sign, load_per_speed = np.sign(sliding), line_load / entrainment
        return Traction(
            force=sign * line_load * curve,
            by_load=sign * (curve + by_log_load * (squared / floored)),
            by_sliding=load_per_speed * (excess * c + b * decay),
            by_entrainment=sign * load_per_speed * by_log_speed,
            by_film=np.zeros(curve.shape),
        )

    @cached_property
    def _at_floor(self) -> list[NDArray]:
        """D, B, C at the load floor and unit speed."""
        oil, elastic = self.oil, self.modulus * self.radius
        pressure, speed = self.load_floor / (elastic * self.radius), oil.viscosity / elastic
        heat = oil.conductivity * oil.temperature / oil.viscosity
        return [x0 * pressure**p * speed**u * heat**t for x0, p, u, t in self._FORMULA]
