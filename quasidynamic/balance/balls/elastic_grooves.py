"""Grooves that give way under the forces of balls, at any contact angle."""

from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.ball_position import Vectors
from quasidynamic.errors import ImpossiblePart

FURTHEST = 0.15  # [rad] beyond the outermost stations to which a groove is extrapolated at most
GROWTH = 12.0  # of the Chebyshev polynomial that shares of as many stations grow like, at most there
SYMMETRIC = 1e-7  # allowed difference of a compliance from its mirror image, over the largest entry: rounding


@dataclass(frozen=True, eq=False)
class ElasticGroove:
    """How one race gives way: normal displacement at stations of its arc per normal force on them.

    Both from ground and normal to the arc, away from the axis of the bearing; the answer of a
    half-space to the own force is left out, as the contact law has it.
    """

    angles: NDArray  # (K) [rad] contact angles of the stations, K odd
    compliance: NDArray  # (Z, K, Z, K) [m/N], symmetric; Z contacts, two for each ball on two arcs
    initial: NDArray = field(default_factory=lambda: np.zeros((0, 0)))  # (Z, K) [m] before balls press

    def __post_init__(self):
        count, stations = self.compliance.shape[:2]
        if self.initial.size == 0:
            object.__setattr__(self, "initial", np.zeros((count, stations)))
        if self.compliance.shape != (count, stations) * 2 or len(self.angles) != stations or not stations % 2:
            raise ImpossiblePart(
                f"a compliance of shape {self.compliance.shape} does not fit {len(self.angles)} stations, "
                "whose number is odd"
            )
        if self.initial.shape != (count, stations) or not np.isfinite(self.initial).all():
            raise ImpossiblePart(f"initial must be ({count}, {stations}) finite displacements")
        mirrored = self.compliance.transpose(2, 3, 0, 1)
        largest = np.abs(self.compliance).max()
        if not np.abs(self.compliance - mirrored).max() <= SYMMETRIC * largest:
            raise ImpossiblePart("the compliance of a groove must be finite and symmetric")

    def shares(self, angles: NDArray) -> "StationShares":
        """Shares of the stations at contact angles (C, Z) [rad]."""
        return StationShares.of(self.angles, angles)


def extrapolated(angles: NDArray | tuple[float, ...]) -> tuple[float, float]:
    """Contact angles [rad] between which a groove with stations at `angles` follows them, as there beyond.

    Source
    ------
    Polynomials through n + 1 stations grow like T_n outside: T_n(x) = cosh(n arccosh x).
    """
    least, most = min(angles), max(angles)
    beyond = (np.cosh(np.arccosh(GROWTH) / (len(angles) - 1)) - 1) * (most - least) / 2
    further = min(FURTHEST, float(beyond))
    return least - further, most + further


class ElasticGrooves(NamedTuple):
    """Both grooves of a bearing, None where a race is rigid."""

    inner: ElasticGroove | None
    outer: ElasticGroove | None

    def softened(self, part: float) -> "ElasticGrooves":
        """Grooves of a part of the compliance, and of what moves them before balls press."""
        if part == 1.0:
            return self
        return ElasticGrooves(
            *(
                each and replace(each, compliance=part * each.compliance, initial=part * each.initial)
                for each in self
            )
        )


class StationShares(NamedTuple):
    r"""Shares of K stations at contact angles, and how they change with them.

    A ball at the angle alpha reads and loads the stations by

    .. math:: T = c\,n^T + c'\,t^T, \quad n = (\sin\alpha, \cos\alpha),\; t = (\cos\alpha, -\sin\alpha),
              \quad \frac{dT}{d\alpha} = (c + c'')\,t^T

    with the shares c of the stations in a function of 1, cos and sin of alpha and its multiples. Cosine and
    sine themselves are among them, so that a rigid motion of the section is exact.

    Source
    ------
    Virtual work: loads and displacements have the same shares; derived here.
    """

    angles: NDArray  # (C, Z) [rad]
    share: NDArray  # (C, Z, K) c [-]
    slope: NDArray  # (C, Z, K) c' [-]
    turn: NDArray  # (C, Z, K) c + c'' [-]

    @classmethod
    def of(cls, stations: NDArray, angles: NDArray) -> "StationShares":
        """Shares of stations (K) at contact angles (..., Z), as there beyond `extrapolated` [rad]."""
        least, most = extrapolated(stations)
        at = np.clip(angles, least, most)
        share, slope, bend = lagrange(stations, at)
        inside = (angles > least) & (angles < most)
        return cls(at, share, slope, np.where(inside[..., None], share + bend, 0.0))

    @property
    def by_vector(self) -> NDArray:
        """T of vectors axial, radial (C, Z, K, 2) [-]."""
        sine, cosine = np.sin(self.angles)[..., None], np.cos(self.angles)[..., None]
        axial = self.share * sine + self.slope * cosine
        return np.stack([axial, self.share * cosine - self.slope * sine], axis=-1)

    @property
    def by_turn(self) -> NDArray:
        """Derivative of T by the contact angle (C, Z, K, 2) [1/rad]."""
        sine, cosine = np.sin(self.angles)[..., None], np.cos(self.angles)[..., None]
        return np.stack([self.turn * cosine, -self.turn * sine], axis=-1)


def lagrange(nodes: NDArray, at: NDArray) -> tuple[NDArray, NDArray, NDArray]:
    r"""Shares of values at K nodes in a trigonometric polynomial through them, and two derivatives (..., K).

    .. math:: c_k(\alpha) = \prod_{j \ne k} \frac{\sin((\alpha - \alpha_j)/2)}{\sin((\alpha_k - \alpha_j)/2)}

    Source
    ------
    Gauss (1866), Theoria interpolationis methodo nova tractata; exact for 1, cos, sin, ..., K odd.
    """
    count = len(nodes)
    other = nodes[(np.arange(count) + np.arange(1, count)[:, None]) % count]
    half = (at[..., None, None] - other) / 2
    scale = np.sin((nodes - other) / 2)
    factors, turns = np.sin(half) / scale, np.cos(half) / (2 * scale)
    share = np.ones((*at.shape, count))
    slope, bend = np.zeros_like(share), np.zeros_like(share)
    for step in range(count - 1):
        factor, turn = factors[..., step, :], turns[..., step, :]
        bend = bend * factor + 2 * slope * turn - share * factor / 4
        slope, share = slope * factor + share * turn, share * factor
    return share, slope, bend


class GrooveShape(NamedTuple):
    """What forces of Z contacts make of one groove; vectors are axial, radial."""

    moved: NDArray  # (..., Z, 2) [m] displacement of the groove at the contacts
    loaded: NDArray  # (n) contacts with a force, in one case at least
    by_contact: NDArray  # (..., n, 3, Z, 2) [m/N, m/rad] its derivatives by their force and by their angle
    by_reading: NDArray  # (..., Z, 2) [m/rad] by the angle of the same contact, as another place is displaced

    def after(self, changes: NDArray) -> NDArray:
        """Displacements (..., Z, m, Z, 2) [m] by changes (..., Z, 3, m) [N, rad] of force and angle."""
        *cases, count, _, each = changes.shape
        moved, own = np.zeros((*cases, count, each, count, 2)), np.arange(count)
        by_contact = self.by_contact.reshape(*cases, len(self.loaded), 3, 2 * count)
        by_loaded = changes[..., self.loaded, :, :].swapaxes(-1, -2) @ by_contact
        moved[..., self.loaded, :, :, :] = by_loaded.reshape(*cases, len(self.loaded), each, count, 2)
        read = changes[..., 2, :, None] * self.by_reading[..., None, :]
        moved[..., own, :, own, :] += np.moveaxis(read, -3, 0)
        return moved


def shape_of(groove: ElasticGroove, angles: NDArray, force: Vectors) -> GrooveShape:
    """How a groove gives way to forces (..., Z) [N] on it at contact angles (..., Z) [rad]."""
    shares, (count, stations), cases = groove.shares(angles), groove.initial.shape, force.shape[:-1]
    by_vector, by_turn, size = shares.by_vector, shares.by_turn, count * stations
    vectors = np.stack([force.real, force.imag], axis=-1)
    loaded = np.flatnonzero(force.any(axis=tuple(range(len(cases)))))
    pressed = (by_vector @ vectors[..., None]).reshape(*cases, size)
    bent = pressed @ groove.compliance.reshape(size, size).T
    displaced = groove.initial + bent.reshape(*cases, count, stations)
    turned = by_turn[..., loaded, :, :] @ vectors[..., loaded, :, None]
    each = np.concatenate([by_vector[..., loaded, :, :], turned], axis=-1).swapaxes(-1, -2)  # (..., n, 3, K)
    answers = each @ groove.compliance[loaded].reshape(len(loaded), stations, size)  # which is symmetric
    by_place = answers.reshape(*cases, 3 * len(loaded), count, stations).swapaxes(-3, -2)
    read = (by_place @ by_vector).swapaxes(-3, -2)  # (..., 3 n, Z, 2)
    by_contact = read.reshape(*cases, len(loaded), 3, count, 2)
    moved, by_reading = ((displaced[..., None, :] @ shares)[..., 0, :] for shares in (by_vector, by_turn))
    return GrooveShape(moved, loaded, by_contact, by_reading)
