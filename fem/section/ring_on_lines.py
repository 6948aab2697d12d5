r"""A ring on frictionless line supports along its outer surface.

A line carries an evenly distributed force, or one that grows linearly from end to end; it is given by
its parts at the K S points: the middle of each line, or its two ends. The forces f on the points and the
rigid motions a of the ring follow from the loads F on the raceway,

.. math:: \begin{pmatrix} C_{ss} + D & R_s \\ R_s^T & 0 \end{pmatrix} \begin{pmatrix} f \\ a \end{pmatrix}
          = -\begin{pmatrix} C_{sr} \\ R_r^T \end{pmatrix} F

Under a line the displacement of an elastic body has no bound. C_ss has at the lines what differs from
a half-space, as the raceway under rollers: the indentation at the support is left out.

Source
------
Flexibility method: forces of the supports from compatibility, rigid motions from balance; derived here.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from fem.parts.boundary_conditions import LineSupports
from fem.parts.rings import ImpossiblePart
from fem.raceway.compliance import RacewayCompliance
from fem.section.free_ring import LINE_MODES, FreeRing, felt_motions
from fem.section.raceway_shapes import Raceway
from fem.section.unilateral_points import SupportPoints, bordered_inverse, pushing_points, require_energy

MIDDLE = np.array([[1.0], [0.0]])  # Legendre shapes 0 and 1 of a force evenly spread along a line
ENDS = np.array([[1.0, 1.0], [-1 / 3, 1 / 3]])  # of forces that grow towards its two ends


@dataclass(frozen=True)
class RingOnLines:
    """A condensed ring whose line supports have their places, rollers not yet."""

    ring: FreeRing
    support: LineSupports

    def __post_init__(self):
        require_held(self.support, self.ring.raceway.response.shape[1])

    def at(self, azimuths, forces: NDArray | None = None) -> RacewayCompliance:
        """Compliance for rollers at different azimuths (Z,) [rad], as `RollersOnLines.near` gives it.

        Outward roller forces (Z, M) [N] decide which points of lines touch, where lines only push.
        Raises `ImpossiblePart` if lines only push and no forces are given; `NotSolved` if the harmonics end
        too early, or the lines cannot hold the forces.
        """
        if self.support.pushing and forces is None:
            raise ImpossiblePart(
                "lines that only push have no compliance of their own; give the roller forces"
            )
        rollers = self.under_rollers(azimuths)
        return rollers.near(np.zeros(rollers.free.shape[:2]) if forces is None else forces)

    def line_forces(self, azimuths, forces: NDArray) -> NDArray:
        """Forces of the lines on the ring, as `RollersOnLines.line_forces` gives them."""
        return self.under_rollers(azimuths).line_forces(forces)

    def under_rollers(self, azimuths) -> "RollersOnLines":
        """The ring with its lines and rollers at given azimuths (Z,) [rad], all different.

        Raises `NotSolved` if the harmonics end too early, `ImpossiblePart` if lines are too close together.
        """
        phi = np.asarray(azimuths, dtype=float)
        points = self._points(phi)
        require_energy(points)
        return RollersOnLines(
            azimuths=phi,
            free=self.ring.raceway.absolute(phi),
            points=points,
            line_azimuths=np.array(self.support.azimuths),
            pushing=self.support.pushing,
            raceway=self.ring.raceway,
        )

    def _points(self, phi: NDArray) -> SupportPoints:
        psi = np.array(self.support.azimuths)
        basis, moves = (MIDDLE, 2) if self.support.tilting else (ENDS, 4)
        S = basis.shape[1]
        of_raceway, of_lines = np.split(self.ring.reading, [-LINE_MODES])
        between_lines = self.ring.lines.absolute(psi)
        line_compliance = np.diag([1.0, 3.0]) / self.support.stiffness
        between_lines[np.arange(psi.size), :, np.arange(psi.size)] += line_compliance
        through = self.ring.under_radial(phi, psi)
        size = psi.size * S
        M = through.shape[1]
        return SupportPoints(
            azimuths=np.repeat(psi, S),
            compliance=np.einsum("sa,kslt,tb->kalb", basis, between_lines, basis).reshape(size, size),
            motions=np.einsum("sa,ksc->kac", basis, felt_motions(psi, of_lines)).reshape(size, 4)[:, :moves],
            loads=np.einsum("sa,imks->kaim", basis, through).reshape(size, phi.size * M),
            load_motions=felt_motions(phi, of_raceway).reshape(-1, 4)[:, :moves],
        )


@dataclass(frozen=True, kw_only=True)
class RollersOnLines:
    """A ring on lines with Z rollers at their places."""

    azimuths: NDArray  # (Z,) [rad]
    free: NDArray  # (Z, M, Z, M) [m/N] of the free ring
    points: SupportPoints  # K S, S of each line
    line_azimuths: NDArray  # (K,) [rad]
    pushing: bool  # lines lift off where they would pull
    raceway: Raceway  # of the free ring

    @property
    def axial_modes(self) -> int:
        """M."""
        return self.free.shape[1]

    def near(self, forces: NDArray) -> RacewayCompliance:
        r"""Compliance of the raceway on the points of lines that touch under given forces.

        .. math:: C = C_{rr} - X^T S^{-1} X, \quad X = (C_{sr}, R_r^T)

        Exact as long as the same points touch: lines stand where the free ring is. Roller forces (Z, M) are
        outward [N].
        Raises `NotSolved` if the lines only push and cannot hold the forces.

        Source
        ------
        Flexibility method: forces of the supports from compatibility, rigid motions from balance; derived
        here.
        """
        touching = self.touching(forces)
        Z, M = self.free.shape[:2]
        X = np.concatenate([self.points.loads[touching], self.points.load_motions.T])
        inverse = bordered_inverse(self.points, touching)
        absolute = self.free.reshape(Z * M, Z * M) - X.T @ inverse @ X
        first = np.count_nonzero(touching)
        motion = -inverse[first:] @ X
        support = -inverse[first : first + 2, first : first + 2]
        return RacewayCompliance(
            azimuths=self.azimuths,
            absolute=((absolute + absolute.T) / 2).reshape(Z, M, Z, M),
            translation=motion[:2].reshape(2, Z, M),
            support_stiffness=float(2 / np.trace(support)),
            unknowns=self.raceway.unknowns,
            elements=self.raceway.elements,
            seconds=self.raceway.seconds,
        )

    def line_forces(self, forces: NDArray) -> NDArray:
        """Inward forces (K, S) [N] of the lines on the ring, so positive when they push.

        They are whole, or the parts at x < 0 and x > 0 that the line pressure grows towards.
        Raises `NotSolved` as `near`.
        """
        touching = self.touching(forces)
        pushes, F = np.zeros(touching.size), np.ravel(forces)
        X = np.concatenate([self.points.loads[touching] @ F, self.points.load_motions.T @ F])
        pushes[touching] = (bordered_inverse(self.points, touching) @ X)[: np.count_nonzero(touching)]
        return pushes.reshape(self.line_azimuths.size, -1)

    def touching(self, forces: NDArray) -> NDArray:
        """Points in touch (K S,) under outward roller forces (Z, M) [N]; raises `NotSolved` as `near`."""
        if not self.pushing:
            return np.ones(len(self.points.compliance), dtype=bool)
        return pushing_points(self.points, np.ravel(forces))

    def with_axial_modes(self, count: int) -> "RollersOnLines":
        """The same ring for rollers that exchange fewer axial modes with it: a part of every array."""
        Z, M = self.free.shape[:2]
        points, kept = self.points, np.arange(Z * M).reshape(Z, M)[:, :count].ravel()
        return replace(
            self,
            free=self.free[:, :count, :, :count],
            points=replace(points, loads=points.loads[:, kept], load_motions=points.load_motions[kept]),
        )


def require_held(support: LineSupports, axial_modes: int) -> None:
    """Refuse lines that leave a motion which the raceway can cause.

    Raises `ImpossiblePart` if rollers can tilt the ring.
    """
    if support.tilting and axial_modes > 1:
        raise ImpossiblePart(
            "tilting = True: the ring can still tilt about y and z, as its lines hold only the mean "
            "displacement along them; let them hold the tilt, or take one axial shape"
        )
