r"""The compliance of a groove under balls, by patches at stations of its arcs.

The force of a ball passes through the centre of the groove at every contact angle, so that a normal patch
has no couple about it, and a turn of the section about that centre moves no contact. Stations at K contact
angles alpha_k carry normal forces and read normal displacements, both away from the axis of the bearing;
what a ball at any angle does follows by interpolation between them.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from fem.half_space.gaussian_patch import patch_answers
from fem.parts.groove import Groove
from fem.parts.material import Elastic
from fem.raceway.compliance import RacewayCompliance
from fem.raceway.harmonics import FINENESS, MOST

DETAIL = 5 / 3  # length over the width of a patch that harmonics resolve: beyond, exp(-13) of it is left


def narrowest_patch(radius: float) -> float:
    """Width of a patch that the most harmonics resolve, on a groove of largest radius R [m]; [m]."""
    return FINENESS * radius / (DETAIL * MOST)


def fade(groove: Groove, outward: int, angles: NDArray, width: float, last: int) -> NDArray:
    """Share of a line that patches of some width [m] at contact angles (K,) [rad] carry in harmonic n [-].

    (N + 1, K), as they read rigid motions.
    """
    radii = groove.centre_radius + outward * groove.radius * np.cos(angles)
    n = np.arange(last + 1)
    return np.exp(-(n[:, None] ** 2 - 1) * (width / radii) ** 2 / 2)


@dataclass(frozen=True, kw_only=True)
class GrooveCompliance:
    r"""How a groove answers the harmonics of forces on its stations; the azimuths of the balls stay free.

    .. math:: C_{jk,j'l} = \sum_{n=-N}^{N} W_{n,kl}\,
              e^{-\frac{n^2-1}{2} \sigma^2 (R_k^{-2} + R_l^{-2})} \cos n(\varphi_j - \varphi_{j'})
              - \delta_{jj'} h(r\,|\alpha_k - \alpha_l|)

    with the contact circles :math:`R_k = R_c \pm r \cos\alpha_k` and the half-space h of
    `fem.half_space.gaussian_patch`, which is left out between stations of one arc. Patches are divided by
    their mean of the cosine of the angle from their middle, around and along, to read rigid motions.

    Source
    ------
    Fourier series of a Gaussian; derived here.

    Valid
    -----
    Small displacement. The own half-space is that of a patch: own terms fall by some percent where patches
    are as wide as a tenth of the groove radius, so that the width belongs to the answer.
    """

    groove: Groove
    outward: int  # 1 where the race is outside the balls, else -1
    angles: NDArray  # (K,) [rad] of the stations
    width: float  # [m] of their patches, see `fem.parts.groove.Stations`
    response: NDArray  # (N + 1, A K, A K) [m/N] W of lines around the axis, n = 0 .. N; arc by arc
    elastic: Elastic  # material below the groove
    unknowns: int
    elements: int
    seconds: dict[str, float] = field(compare=False)  # by stage: factor, condense
    coupled: NDArray | None = None  # (2 H + 1, A K, 2 H + 1, A K) [m/N] beyond W, -H .. H: not of revolution

    def at(self, azimuths: NDArray) -> RacewayCompliance:
        """Compliance for balls at azimuths (Z,) [rad]: A arcs of the first ball, then those of the next.

        Of two rows first the balls of that at -x, then those of the other.
        Displacements are normal to the arc, away from the axis of the bearing, and from the ground: no mean
        translation is known beside them.
        """
        phi, arcs = np.asarray(azimuths, dtype=float), len(self.groove.sides)
        each = len(phi) * arcs, len(self.angles)
        around, absolute = np.repeat(phi, arcs), self.absolute(phi)
        if self.groove.place:
            around = np.tile(phi, arcs)
            of_rows = absolute.reshape((len(phi), arcs, len(self.angles)) * 2)
            absolute = of_rows.transpose(1, 0, 2, 4, 3, 5)
        return RacewayCompliance(
            azimuths=around,
            absolute=absolute.reshape(each * 2),
            translation=np.zeros((2, *each)),
            support_stiffness=np.inf,
            unknowns=self.unknowns,
            elements=self.elements,
            seconds=self.seconds,
        )

    def absolute(self, azimuths: NDArray) -> NDArray:
        """The matrix of `at` alone (Z, A K, Z, A K) [m/N], also for a groove without a hold of its own."""
        phi = np.asarray(azimuths, dtype=float)
        n = np.arange(len(self.response))
        apart, place = np.unique(np.round(np.abs(phi[:, None] - phi) % (2 * np.pi), 12), return_inverse=True)
        waves = np.cos(np.outer(apart, n)) * np.where(n > 0, 2.0, 1.0)
        faded = self.response * (self.fade[:, :, None] * self.fade[:, None])
        rows = np.tensordot(waves, faded, axes=1)  # (D, A K, A K)
        absolute = rows[place.reshape(len(phi), -1)].transpose(0, 2, 1, 3)
        own = np.arange(len(phi))
        absolute[own, :, own] -= np.kron(np.eye(len(self.groove.sides)), self._half_space)
        if self.coupled is not None:
            n = np.arange(len(self.coupled)) - len(self.coupled) // 2
            turn = np.exp(1j * np.outer(phi, n))[..., None] * self.fade[np.abs(n)]
            at_balls = np.einsum("jnk,nkml->jkml", turn, self.coupled)
            change = np.real(np.einsum("jkml,iml->jkil", at_balls, turn.conj()))
            absolute += (change + change.transpose(2, 3, 0, 1)) / 2
        return absolute

    @property
    def fade(self) -> NDArray:
        """Share of a line that patches of some width carry in each harmonic (N + 1, A K) [-]."""
        angles = np.tile(self.angles, len(self.groove.sides))
        return fade(self.groove, self.outward, angles, self.width, len(self.response) - 1)

    @property
    def _half_space(self) -> NDArray:
        along = self.groove.radius * np.abs(self.angles[:, None] - self.angles)
        return patch_answers(along, self.width, self.elastic)
