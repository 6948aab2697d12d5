r"""Two condensed bodies joined at their faces: the forces there that go with a jump between them.

Both bodies are elastic; the ring moves as it must to be in balance. With the compliance C of both, the rigid
motions R a of the ring, loads f on its raceway and a jump d beyond that of free expansion,

.. math:: \begin{pmatrix} C & R \\ R^T & 0 \end{pmatrix} \begin{pmatrix} q \\ a \end{pmatrix} =
          \begin{pmatrix} d \\ 0 \end{pmatrix} - X f, \quad X = \begin{pmatrix} C_f \\ R_f^T \end{pmatrix}

Source
------
Derived here: compatibility of both bodies at every point of the faces and balance of the ring.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from fem.joint.face_condensation import CondensedBody, FacePoints

MOVES = 1e-9  # of the largest trace: below it a rigid motion does not show in the directions kept


@dataclass(frozen=True)
class InterfaceStiffness:
    """A ring with its mate: A points on each of P azimuths, D directions of force, M raceway modes."""

    carries: NDArray  # of bool, which points of the bodies are meant: A of them
    points: FacePoints
    directions: int  # D: 3, or 1 for pressure alone
    stiffness: NDArray  # (N + 1, A D, A D) [N/m] force per radian on the ring per jump; complex
    raceway: NDArray  # (N + 1, M, A D) [-] displacement of the raceway per jump; complex
    bonded: NDArray  # (N + K + 1, M, M) [m/N] of the raceway per force per radian; beyond N the ring alone
    push: NDArray  # (A D,) [1/rad] force without a jump per axial push, zero where none is carried

    @property
    def azimuths(self) -> NDArray:
        """Azimuths (P,) [rad], 2 N + 1 of them: an even number would leave half a harmonic."""
        P = 2 * len(self.stiffness) - 1
        return 2 * np.pi * np.arange(P) / P

    @property
    def unknowns(self) -> int:
        """Gaps and slips at all points."""
        return self.azimuths.size * int(self.carries.sum()) * self.directions

    @cached_property
    def blocks(self) -> NDArray:
        """Stiffness between points by the difference of their places in `azimuths` (P, A D, A D) [N/m]."""
        return np.fft.irfft(self.stiffness, n=self.azimuths.size, axis=0)

    def forces(self, jump: NDArray) -> NDArray:
        """Forces per radian on the ring [N] by a jump [m], both (..., P, A D); none by a rigid one."""
        d = np.fft.rfft(jump, axis=-2)
        q = np.einsum("nkl,...nl->...nk", self.stiffness, d, optimize=True)
        return np.fft.irfft(q, n=self.azimuths.size, axis=-2)

    def forces_of_raceway(self, loads: NDArray) -> NDArray:
        """Forces per radian (..., P, A D) [N] without a jump, by raceway loads (..., N + 1, M) [N/rad]."""
        q = -np.einsum("nml,...nm->...nl", self.raceway.conj(), loads, optimize=True)
        return np.fft.irfft(q, n=self.azimuths.size, axis=-2, norm="forward")

    def raceway_harmonics(self, jump: NDArray) -> NDArray:
        """Harmonics of the raceway displacement (..., N + 1, M) [m] by a jump (..., P, A D) [m]."""
        d = np.fft.rfft(jump, axis=-2, norm="forward")
        return np.einsum("nml,...nl->...nm", self.raceway, d, optimize=True)


def interface_stiffness(
    ring: CondensedBody, mate: CondensedBody, carries: NDArray, tangential: bool
) -> InterfaceStiffness:
    """Join a free ring and its mate, that is held; both have the same faces, their points at the same places.

    Only points that carry a force are joined, along the surface, too, if `tangential`.
    """
    L = 3 * carries.size
    D = 3 if tangential else 1
    kept = np.flatnonzero(np.repeat(carries, 3) & (np.arange(L) % 3 < D))
    turn = np.where(kept % 3 == 2, -1j, 1.0)  # the circumferential direction goes with the sine
    stiffness, raceway, bonded = [], [], []
    push = np.zeros(kept.size)
    for n, (of_ring, of_mate) in enumerate(zip(ring.compliance, mate.compliance, strict=True)):
        C = of_ring[np.ix_(kept, kept)] + of_mate[np.ix_(kept, kept)]
        R = ring.motions[n] if n < 2 else np.empty((len(of_ring), 0))
        shown = np.abs(R[kept]).max(axis=0, initial=0) > MOVES * np.abs(R).max(initial=0)
        R = R[:, shown]
        scale = np.abs(C).max() / (np.abs(R).max(initial=0) or 1.0)
        X = np.concatenate([of_ring[kept, L:], scale * R[L:].T])
        border = scale * R[kept]
        inverse = np.linalg.inv(np.block([[C, border], [border.T, np.zeros((R.shape[1], R.shape[1]))]]))
        inverse = (inverse + inverse.T) / 2
        answer = inverse @ X
        stiffness.append(turn[:, None] * inverse[: kept.size, : kept.size] * turn.conj())
        raceway.append(answer[: kept.size].T * turn.conj())
        bonded.append(of_ring[L:, L:] - X.T @ answer)
        if n == 0 and shown[0]:
            load = np.append(ring.axisymmetric[kept, 2], np.eye(R.shape[1])[0] * scale / (2 * np.pi))
            push = -(inverse @ load)[: kept.size]
    return InterfaceStiffness(
        carries=carries,
        points=FacePoints(
            *(getattr(ring.points, name)[carries] for name in ("face", "x", "radius", "weight"))
        ),
        directions=D,
        stiffness=np.array(stiffness),
        raceway=np.array(raceway),
        bonded=np.concatenate([bonded, ring.beyond]),
        push=push,
    )
