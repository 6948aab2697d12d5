r"""A ring on springs per area that only push, and leave its outer surface where they would pull.

The ring is condensed on springs that pull as well. With the outward displacement u of P A points of its outer
surface and their springs K, inward forces t at points that are open take the pull of these springs away:

.. math:: u = U F - S t, \quad y = u + K^{-1} t \ge 0, \quad t \ge 0, \quad t^T y = 0, \quad w = C F - U^T t

where y is the compression of the springs. Springs along the surface hold the ring everywhere.

Source
------
Flexibility method with Signorini's conditions at points; derived here.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from fem.errors import NotSolved
from fem.parts.boundary_conditions import Foundation
from fem.parts.resolution import Resolution
from fem.parts.rings import ImpossiblePart, OuterRing
from fem.raceway.compliance import RacewayCompliance
from fem.raceway.harmonics import Responses
from fem.raceway.stations import GrooveCompliance
from fem.section.raceway_shapes import Raceway, raceway_compliance

ALONG = 4  # points along the width, and harmonics around
AROUND = 60  # 90 of them and 6 points move the deviation of a thin ring by less than 1e-3 of the largest
LEFT = 1e-9  # part of its springs that an open point keeps: without any, a ring in the air has no place
ROUNDING = 1e-12  # of the largest compression
EXCHANGES = 3  # for each point; a dozen in all is usual, and only a matrix that is not definite needs more
BLOCKS = 5  # exchanges of all wrong points at once that may fail to make their number smaller


@dataclass(frozen=True, kw_only=True)
class RingOnFoundation:
    """A ring on its springs, rollers have no places yet."""

    raceway: Raceway  # on springs that pull as well as push
    face: NDArray  # (N + 1, A, A) [m/N] displacement at A points along the width per force there
    through: NDArray  # (N + 1, A, M) [m/N] the same per roller force
    x: NDArray  # (A,) [m]
    area: NDArray  # (A,) [m^2] of each point at one of the 2 N + 1 azimuths
    radial: float  # [N/m^3] springs per area

    def under_rollers(self, azimuths) -> "RollersOnFoundation":
        """The ring with rollers at given azimuths (Z,) [rad], all different.

        Raises `NotSolved` if the harmonics end too early.
        """
        phi, n = np.asarray(azimuths, dtype=float), np.arange(len(self.face))
        around = 2 * np.pi * np.arange(2 * n.size - 1) / (2 * n.size - 1)
        weight = np.where(n > 0, 2.0, 1.0)
        size = around.size * self.x.size
        to_rollers = weight * np.cos(np.multiply.outer(around[:, None] - phi, n))
        between = weight * np.cos(np.multiply.outer(around[:, None] - around, n))
        first = 2 * np.stack([np.sin(around), np.cos(around)], axis=1)
        return RollersOnFoundation(
            closed=self.raceway.at(phi),
            around=around,
            x=self.x,
            area=self.area,
            springs=np.tile(self.radial * self.area, around.size),
            face=np.einsum("pqn,nab->paqb", between, self.face, optimize=True).reshape(size, size),
            through=np.einsum("pjn,nam->pajm", to_rollers, self.through, optimize=True).reshape(size, -1),
            shifted=np.einsum("pd,a->pad", first, self.through[1, :, 0]).reshape(size, 2),
            reading=self.reading,
        )

    @property
    def reading(self) -> NDArray:
        """What shapes of the raceway read of a translation towards them (M,) [-]."""
        if isinstance(self.raceway, GrooveCompliance):
            return np.cos(self.raceway.angles)
        return np.eye(self.through.shape[2])[0]


@dataclass(frozen=True, kw_only=True)
class RollersOnFoundation:
    """A ring on springs with Z rollers at their places; P A points of its outer surface, azimuth first."""

    closed: RacewayCompliance  # where no point is open
    around: NDArray  # (P,) azimuths of the points [rad]
    x: NDArray  # (A,) [m]
    area: NDArray  # (A,) [m^2] of a point
    springs: NDArray  # (P A,) [N/m]
    face: NDArray  # (P A, P A) [m/N] outward displacement per outward force there, springs pull as well
    through: NDArray  # (P A, Z M) [m/N] the same per roller force
    shifted: NDArray  # (P A, 2) [m/N] the same per pressure on the raceway like sin and cos
    reading: NDArray  # (M,) [-] what shapes of the raceway read of a translation towards them
    pushing: bool = True  # points open where they would pull

    @property
    def azimuths(self) -> NDArray:
        """Of the rollers (Z,) [rad]."""
        return self.closed.azimuths

    @property
    def axial_modes(self) -> int:
        """M."""
        return self.closed.absolute.shape[1]

    def near(self, forces: NDArray) -> RacewayCompliance:
        """Compliance of the raceway with the open points o that go with given forces.

        .. math:: C + U_o^T (K^{-1} - S)_{oo}^{-1} U_o

        Exact as long as the same points are open: springs are relaxed where the free ring is. Roller forces
        (Z, M) are outward [N], here and in `pressure`.
        Raises `NotSolved` if the foundation cannot hold the ring.

        Source
        ------
        Flexibility method with Signorini's conditions at points; derived here.
        """
        is_open = self.open_points(forces)
        if not is_open.any():
            return self.closed
        root = np.sqrt(self.springs[is_open])
        U = root[:, None] * np.column_stack([self.through, self.shifted])[is_open]
        change = U.T @ np.linalg.solve(self._released[np.ix_(is_open, is_open)], U)
        Z, M = self.closed.absolute.shape[:2]
        support = 2 / self.closed.support_stiffness * np.eye(2) / 2 + change[-2:, -2:]
        return replace(
            self.closed,
            absolute=self.closed.absolute + change[:-2, :-2].reshape(Z, M, Z, M),
            translation=self.closed.translation + change[-2:, :-2].reshape(2, Z, M),
            support_stiffness=float(2 / np.trace(support)),
        )

    def open_points(self, forces: NDArray) -> NDArray:
        """Points that are lifted off (P A,) under outward roller forces (Z, M) [N]; raises as `near`."""
        return self._solution(forces)[0]

    def pressure(self, forces: NDArray) -> NDArray:
        """Pressure (P, A) [Pa] on the outer surface at `around` and `x`, positive where it pushes.

        It is negative only of springs that pull.
        Raises `NotSolved` if the foundation cannot hold the ring.
        """
        is_open, compression = self._solution(forces)
        force = np.where(is_open, 0.0, self.springs * compression)
        return force.reshape(self.around.size, -1) / self.area

    @cached_property
    def _released(self) -> NDArray:
        """Unit springs less what the ring on them answers (P A, P A), between 0 and 1."""
        root = np.sqrt(self.springs)
        return (1 + LEFT) * np.eye(root.size) - root[:, None] * self.face * root

    def _solution(self, forces: NDArray) -> tuple[NDArray, NDArray]:
        """Open points (P A,) and compression of the springs (P A,) [m]."""
        free = self.through @ np.ravel(forces)
        root = np.sqrt(self.springs)
        if not self.pushing or not free.any():
            return np.zeros(free.size, dtype=bool), free
        is_open, left = complementary(self._released, root * free)
        if is_open.all():
            raise NotSolved("the ring lifts off its foundation, which only pushes: nothing holds it")
        return is_open, left / root

    def with_axial_modes(self, count: int) -> "RollersOnFoundation":
        """The same ring for rollers that exchange fewer axial modes with it: a part of every array."""
        closed = self.closed
        Z, M = closed.absolute.shape[:2]
        return replace(
            self,
            through=self.through.reshape(-1, Z, M)[..., :count].reshape(-1, Z * count),
            reading=self.reading[:count],
            closed=replace(
                closed,
                absolute=closed.absolute[:, :count, :, :count],
                translation=closed.translation[..., :count],
                initial_deviation=closed.initial_deviation[:, :count],
            ),
        )


def complementary(matrix: NDArray, constant: NDArray) -> tuple[NDArray, NDArray]:
    r"""Solve a linear complementarity problem.

    .. math:: y = A t + b \ge 0, \quad t \ge 0, \quad t^T y = 0

    A is symmetric and positive definite; the result is where t is above zero, and y.
    Raises `NotSolved` if A is singular, or so far from positive definite that no solution is found.

    Source
    ------
    Block principal pivoting, Judice and Pires, Comput. Oper. Res. 21 (1994) 587: all wrong points change
    sides at once, and the last of them alone where that does not make fewer.
    """
    positive, wrong, fewest, left = constant < 0, np.zeros(0), constant.size + 1, BLOCKS
    small = ROUNDING * np.abs(constant).max()
    for _ in range(EXCHANGES * constant.size):
        t = np.zeros_like(constant)
        try:
            t[positive] = np.linalg.solve(matrix[np.ix_(positive, positive)], -constant[positive])
        except np.linalg.LinAlgError as problem:
            raise NotSolved(f"nothing holds the ring: {problem}") from problem
        y = np.where(positive, 0.0, matrix @ t + constant)
        wrong = np.flatnonzero(np.where(positive, t, y) < -small)
        if not wrong.size:
            return positive, y
        left = BLOCKS if wrong.size < fewest else left - 1
        fewest = min(fewest, wrong.size)
        changed = wrong if left > 0 else wrong[-1:]
        positive[changed] = ~positive[changed]
    raise NotSolved(
        f"{wrong.size} of {constant.size} points neither push nor stand open: no set of them was found"
    )


def ring_on_foundation(
    part: OuterRing, resolution: Resolution, responses: Responses, seconds: dict
) -> RingOnFoundation:
    """Put a condensed ring on its radial springs.

    Responses are those of the ring on springs that pull as well, to shapes of the raceway and, after them, to
    `ALONG` of the outer surface.
    Raises `ImpossiblePart` if the ring has another support.
    """
    support = part.support
    if not isinstance(support, Foundation):
        raise ImpossiblePart(f"{type(support).__name__} is impossible as springs; allowed is a Foundation")
    W = responses.response
    M, N = W.shape[1] - ALONG, min(AROUND, len(W) - 1)
    xi, gauss = legendre.leggauss(ALONG)
    at_points = legendre.legvander(xi, ALONG - 1)  # from the modes of the outer surface to its points
    radius = part.raceway_diameter / 2 + part.thickness
    raceway = raceway_compliance(part, resolution, responses._replace(response=W[:, :M, :M]), seconds)
    return RingOnFoundation(
        raceway=raceway,
        face=at_points @ W[: N + 1, M:, M:] @ at_points.T,
        through=at_points @ W[: N + 1, M:, :M] * raceway.fade[: N + 1, None],
        x=xi * part.width / 2 - part.offset,
        area=2 * np.pi * radius / (2 * N + 1) * part.width * gauss / 2,
        radial=support.radial,
    )  # fmt: skip
