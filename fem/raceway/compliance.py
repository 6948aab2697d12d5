"""How a raceway deflects under its rollers, by any discretisation."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from fem.parts.material import ImpossiblePart
from fem.raceway.bar_response import BarResponse


@dataclass(frozen=True, kw_only=True)
class RacewayCompliance:
    """How a raceway deflects under Z rollers with M forces each; symbols as in `assembly.roller_loads`."""

    azimuths: NDArray  # (Z,) [rad]
    absolute: NDArray  # (Z, M, Z, M) [m/N] outward displacement per outward force; half-space removed
    translation: NDArray  # (2, Z, M) [m/N] mean rigid translation (y, z) of the band per generalised force
    support_stiffness: float  # [N/m] resultant over mean translation under a load like cos(phi)
    unknowns: int
    elements: int
    seconds: dict[str, float] = field(compare=False)  # by stage: mesh, factor, condense
    initial_deviation: NDArray = field(default_factory=lambda: np.zeros((0, 0)))  # (Z, M) [m] outward
    initial_translation: NDArray = field(default_factory=lambda: np.zeros(2))  # (y, z) [m]
    support_error: float | None = None  # of the support's stiffness, over it; None: not estimated [-]
    bar_response: BarResponse | None = None  # of a squirrel cage

    def __post_init__(self):
        if self.initial_deviation.size == 0:
            object.__setattr__(self, "initial_deviation", np.zeros(self.absolute.shape[:2]))

    def at(self, azimuths) -> "RacewayCompliance":
        """Return this compliance, for the rollers that it was made for.

        Raises `ImpossiblePart` for other azimuths [rad].
        """
        if not np.array_equal(azimuths, self.azimuths):
            raise ImpossiblePart(
                f"azimuths = {azimuths!r} are impossible; allowed are those of the solid, {self.azimuths!r}"
            )
        return self

    def repeated(self, rows: int) -> "RacewayCompliance":
        """Of so many rows, one after the other, each on a raceway of its own like this one."""
        count, shapes = self.absolute.shape[:2]
        absolute = np.einsum("ab,jmkn->ajmbkn", np.eye(rows), self.absolute)
        return replace(
            self,
            azimuths=np.tile(self.azimuths, rows),
            absolute=absolute.reshape((rows * count, shapes) * 2),
            translation=np.tile(self.translation, (1, rows, 1)),
            initial_deviation=np.tile(self.initial_deviation, (rows, 1)),
        )

    @property
    def relative(self) -> NDArray:
        r"""Outward deviation from the translated raceway per outward force.

        .. math:: \bar C_{jm,j'm'} = C_{jm,j'm'} - \delta_{m0}\,(t_y \sin\varphi_j + t_z \cos\varphi_j)_{j'm'}

        An array (Z, M, Z, M) [m/N], not symmetric, because a translation was taken from the answers only. The
        mean tilt of the raceway is still in it.

        Source
        ------
        The mean translation belongs to the balance of the bearing; derived here.
        """
        direction = np.stack([np.sin(self.azimuths), np.cos(self.azimuths)], axis=1)
        reduced = self.absolute.copy()
        reduced[:, 0] -= np.tensordot(direction, self.translation, 1)
        return reduced


def combined(compliances: Sequence[RacewayCompliance], weights: Sequence[float]) -> RacewayCompliance:
    """Weighted sum of compliances of raceways of one kind, such as a first-order change from one of them.

    All are under the same rollers, and weights add up to one. The support's compliance, not its stiffness, is
    summed; errors are not estimated.
    """

    def summed(name: str) -> NDArray:
        return np.tensordot(weights, [getattr(each, name) for each in compliances], 1)

    first = compliances[0]
    names = "absolute", "translation", "initial_deviation", "initial_translation"
    support = sum(w / each.support_stiffness for w, each in zip(weights, compliances, strict=True))
    bars = [each.bar_response.response for each in compliances if each.bar_response]
    response = first.bar_response and replace(
        first.bar_response, response=np.tensordot(weights, bars, 1), neighbour=None
    )
    return replace(
        first,
        **{name: summed(name) for name in names},
        support_stiffness=1 / support if support else np.inf,
        support_error=None,
        bar_response=response,
    )
