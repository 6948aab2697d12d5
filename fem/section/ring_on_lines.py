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

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.parts.boundary_conditions import LineSupports
from fem.parts.rings import ImpossiblePart
from fem.raceway.compliance import RacewayCompliance
from fem.section.free_ring import FreeRing, rigid_motions
from fem.section.unilateral_points import SupportPoints, bordered_inverse, pushing_points

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
        r"""Compliance for rollers at given azimuths.

        .. math:: C = C_{rr} - X^T S^{-1} X, \quad X = (C_{sr}, R_r^T)

        Parameters
        ----------
        azimuths : array (Z,)
            phi of the rollers, all different [rad]
        forces : array (Z, M)
            outward roller forces that decide which points of lines touch [N]; for lines that only push

        Returns
        -------
        RacewayCompliance
            with lines that only push, that of the points in touch, exact as long as they stay so

        Raises
        ------
        ImpossiblePart
            if lines only push and no forces are given
        NotSolved
            if the harmonics end too early, or the lines cannot hold the forces
        """
        phi = np.asarray(azimuths, dtype=float)
        points = self._points(phi)
        touching = self._touching(points, forces)
        Z, M = phi.size, self.ring.raceway.response.shape[1]
        X = np.concatenate([points.loads[touching], points.load_motions.T])
        inverse = bordered_inverse(points, touching)
        absolute = self.ring.raceway.absolute(phi).reshape(Z * M, Z * M) - X.T @ inverse @ X
        first = np.count_nonzero(touching)
        motion = -inverse[first:] @ X
        support = -inverse[first : first + 2, first : first + 2]
        return RacewayCompliance(
            azimuths=phi,
            absolute=((absolute + absolute.T) / 2).reshape(Z, M, Z, M),
            translation=motion[:2].reshape(2, Z, M),
            support_stiffness=float(2 / np.trace(support)),
            unknowns=self.ring.raceway.unknowns,
            elements=self.ring.raceway.elements,
            seconds=self.ring.raceway.seconds,
        )

    def line_forces(self, azimuths, forces: NDArray) -> NDArray:
        """Forces of the lines on the ring.

        Parameters
        ----------
        azimuths : array (Z,)
            phi of the rollers [rad]
        forces : array (Z, M)
            outward roller forces [N]

        Returns
        -------
        array (K, S)
            inward, so positive when they push [N]: whole, or the parts at x < 0 and x > 0 that the line
            pressure grows towards
        """
        points = self._points(np.asarray(azimuths, dtype=float))
        touching = self._touching(points, forces)
        pushes = np.zeros(touching.size)
        F = np.ravel(forces)
        X = np.concatenate([points.loads[touching] @ F, points.load_motions.T @ F])
        pushes[touching] = (bordered_inverse(points, touching) @ X)[: np.count_nonzero(touching)]
        return pushes.reshape(len(self.support.azimuths), -1)

    def _points(self, phi: NDArray) -> SupportPoints:
        psi = np.array(self.support.azimuths)
        basis, moves = (MIDDLE, 2) if self.support.tilting else (ENDS, 4)
        S = basis.shape[1]
        length, width = self.ring.raceway.length, self.ring.lines.length
        between_lines = self.ring.lines.absolute(psi)
        line_compliance = np.diag([1.0, 3.0]) / self.support.stiffness
        between_lines[np.arange(psi.size), :, np.arange(psi.size)] += line_compliance
        through = self.ring.under_radial(phi, psi)
        size = psi.size * S
        M = through.shape[1]
        return SupportPoints(
            azimuths=np.repeat(psi, S),
            compliance=np.einsum("sa,kslt,tb->kalb", basis, between_lines, basis).reshape(size, size),
            motions=np.einsum("sa,ksc->kac", basis, rigid_motions(psi, width, 2)).reshape(size, 4)[:, :moves],
            loads=np.einsum("sa,imks->kaim", basis, through).reshape(size, phi.size * M),
            load_motions=rigid_motions(phi, length, M).reshape(-1, 4)[:, :moves],
        )

    def _touching(self, points: SupportPoints, forces: NDArray | None) -> NDArray:
        """Points in touch (K S,)."""
        if not self.support.pushing:
            return np.ones(len(points.compliance), dtype=bool)
        if forces is None:
            raise ImpossiblePart(
                "lines that only push have no compliance of their own; give the roller forces"
            )
        return pushing_points(points, np.ravel(forces))


def require_held(support: LineSupports, axial_modes: int) -> None:
    """Refuse lines that leave a motion which the raceway can cause.

    Raises
    ------
    ImpossiblePart
        if rollers can tilt the ring
    """
    if support.tilting and axial_modes > 1:
        raise ImpossiblePart(
            "tilting = True: the ring can still tilt about y and z, as its lines hold only the mean "
            "displacement along them; let them hold the tilt, or take one axial shape"
        )
