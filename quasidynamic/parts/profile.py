"""Profiles of rollers and raceways: how far a generatrix lies below the straight one."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart, require_positive
from quasidynamic.parts.monotone import monotone_slopes, piecewise_cubic

ROUNDING = 1e-6  # of half of the length: by how much points may miss an end


class Profile(Protocol):
    """How far the generatrix lies below the cylinder, at a distance from mid-roller."""

    def drop(self, position: NDArray, length: NDArray | float) -> NDArray:
        """Profile drop C >= 0 [m] at `position` [m] for a roller of `length` [m]."""
        ...


@dataclass(frozen=True)
class Straight:
    """No crowning."""

    def drop(self, position: NDArray, length: NDArray | float) -> NDArray:
        """Zero everywhere [m]."""
        return np.zeros_like(position)


STRAIGHT = Straight()


@dataclass(frozen=True, kw_only=True)
class Crowned:
    """A straight middle and one circle around mid-roller at both ends, which meets it with a corner.

    Source
    ------
    Mao, Wang and Zhang (2016), Eq. (1), with the drop counted positive.
    """

    straight_length: float  # [m]
    crown_radius: float  # [m] of the generatrix, far above the length

    def __post_init__(self):
        _require_circle(self.straight_length, self.crown_radius)

    def drop(self, position: NDArray, length: NDArray | float) -> NDArray:
        """Drop [m]; zero inside the straight part."""
        outside = np.maximum(np.abs(position), self.straight_length / 2)
        return np.sqrt(self.crown_radius**2 - self.straight_length**2 / 4) - np.sqrt(
            self.crown_radius**2 - outside**2
        )


@dataclass(frozen=True, kw_only=True)
class TangentCrowned:
    r"""A straight middle with circular ends that leave it without a corner.

    .. math:: C = R - \sqrt{R^2 - u^2},\quad u = \max(|x| - l_s/2, 0)

    A small R rounds the ends of a straight roller.

    Source
    ------
    Geometry of a circle that touches the straight middle at its ends.
    """

    straight_length: float  # [m]
    crown_radius: float  # [m] of the generatrix, far above the length

    def __post_init__(self):
        _require_circle(self.straight_length, self.crown_radius)

    def drop(self, position: NDArray, length: NDArray | float) -> NDArray:
        """Drop [m]; zero inside the straight part."""
        outside = np.maximum(np.abs(position) - self.straight_length / 2, 0.0)
        return outside**2 / (self.crown_radius + np.sqrt(self.crown_radius**2 - outside**2))


@dataclass(frozen=True, kw_only=True)
class Hollow:
    r"""A hollow raceway along the rollers, one circle: it comes closer towards their ends.

    .. math:: C = -(r - \sqrt{r^2 - x^2}) = -\frac{x^2}{r + \sqrt{r^2 - x^2}}

    Source
    ------
    Geometry. With a barrel of R < r the drops of both add up to about x^2/2 (1/R - 1/r) >= 0.
    """

    radius: float  # [m] r of the generatrix

    def __post_init__(self):
        require_positive("raceway radius", self.radius)

    def drop(self, position: NDArray, length: NDArray | float) -> NDArray:
        """Drop [m], <= 0."""
        return -(position**2) / (self.radius + np.sqrt(self.radius**2 - position**2))


def _require_circle(straight_length: float, crown_radius: float) -> None:
    if straight_length < 0:
        raise ImpossiblePart(f"straight_length = {straight_length} must not be negative")
    require_positive("crown_radius", crown_radius)


@dataclass(frozen=True, kw_only=True)
class Logarithmic:
    r"""The logarithmic profile with ends of any depth.

    .. math:: C = A \ln \frac{1}{1 - (2x/l)^2}

    Source
    ------
    Lundberg, Forsch. Ingenieurwes. 10 (1939), 201-211, for A = 2 Q/(pi l E'); ISO/TS 16281 (2008) for
    A = 0.00035 D.
    """

    amplitude: float  # [m] A

    def __post_init__(self):
        require_positive("profile drop", self.amplitude)

    def drop(self, position: NDArray, length: NDArray | float) -> NDArray:
        """Drop [m]; grows without bound towards the very end."""
        return -self.amplitude * np.log1p(-((2 * position / length) ** 2))


@dataclass(frozen=True, kw_only=True)
class LogarithmicCrown:
    r"""Logarithmic ends of finite depth beside a straight middle.

    .. math:: C = A \ln \frac{1}{1 - (1 - e^{-z_m/A})\, s^2},\quad
              s = \max\Big(0,\; 1 - \frac{1 - |2x/l|}{K_2}\Big)

    Source
    ------
    Fujiwara and Kawase, NTN Technical Review 75 (2007), 140-148, with A = 2 K_1 Q/(pi l E'). The profile of
    Johns and Gohar, Tribology International 14 (1981), 131-136, for K_1 = K_2 = 1 and its z_m.
    """

    amplitude: float  # [m] A
    end_drop: float  # [m] z_m, at the end of the length
    crowned_share: float  # [-] K_2, of each half of the length, up to 1

    def __post_init__(self):
        for name in ("amplitude", "end_drop", "crowned_share"):
            require_positive(f"profile {name}", getattr(self, name))
        if self.crowned_share > 1:
            raise ImpossiblePart(f"profile crowned_share = {self.crowned_share:.6g} must be at most 1")

    def drop(self, position: NDArray, length: NDArray | float) -> NDArray:
        """Drop [m]; zero inside the straight part."""
        inwards = np.maximum(1 - (1 - np.abs(2 * position / length)) / self.crowned_share, 0.0)
        return -self.amplitude * np.log1p(np.expm1(-self.end_drop / self.amplitude) * inwards**2)


@dataclass(frozen=True, kw_only=True, eq=False)
class PointsProfile:
    """A profile through points, monotone between neighbours: it never overshoots them.

    Source
    ------
    `piecewise_cubic`.
    """

    places: NDArray  # (n) 2x/l from -1 to 1, growing [-]
    drops: NDArray  # (n) [m] >= 0, the least one zero
    slopes: NDArray  # (n) of the drop by the place [m]
    symmetric: bool  # whether both halves are alike

    @classmethod
    def through(cls, positions: NDArray, drops: NDArray, length: float) -> "PointsProfile":
        """Profile through drops (n) [m] at positions (n) [m] of a roller of some length [m].

        Points from mid-roller to one end stand for both halves.

        Raises `ImpossiblePart` if positions do not grow or do not reach from end to end, or if the least drop
        is not zero.
        """
        places, drops = 2 * np.asarray(positions, float) / length, np.asarray(drops, float)
        _require_points(places, drops, length)
        if abs(places[0]) <= ROUNDING:
            places[0] = 0.0
            places, drops = np.r_[-places[:0:-1], places], np.r_[drops[:0:-1], drops]
        places[[0, -1]] = -1.0, 1.0
        slopes = monotone_slopes(places, drops)
        alike = np.allclose(places, -places[::-1], rtol=0, atol=ROUNDING) and np.array_equal(
            drops, drops[::-1]
        )
        return cls(places=places, drops=drops, slopes=slopes, symmetric=alike)

    def drop(self, position: NDArray, length: NDArray | float) -> NDArray:
        """Drop [m]."""
        return piecewise_cubic(self.places, self.drops, self.slopes, np.clip(2 * position / length, -1, 1))


def _require_points(places: NDArray, drops: NDArray, length: float) -> None:
    """Refuse points that are no profile of the whole roller."""
    if places.ndim != 1 or places.shape != drops.shape or len(places) < 2:
        raise ImpossiblePart(
            f"profile: {places.size} positions and {drops.size} drops; as many of both are needed, at least 2"
        )
    if not (np.isfinite(places).all() and np.isfinite(drops).all()):
        raise ImpossiblePart("profile: positions and drops must be finite")
    if not (np.diff(places) > 0).all():
        raise ImpossiblePart("profile: positions must grow from point to point")
    whole = abs(places[0] + 1) <= ROUNDING or abs(places[0]) <= ROUNDING
    if not (whole and abs(places[-1] - 1) <= ROUNDING):
        first, last, end = (1e3 * place * length / 2 for place in (places[0], places[-1], 1.0))
        raise ImpossiblePart(
            f"profile: points reach from {first:.6g} to {last:.6g} mm; they must reach from {-end:.6g} mm, "
            f"or from 0 mm for halves alike, to {end:.6g} mm, the end of the roller"
        )
    if drops.min() != 0.0:
        raise ImpossiblePart(
            f"profile: the least drop is {drops.min() * 1e6:.6g} um; it must be 0: a mean belongs to the "
            "clearance"
        )
