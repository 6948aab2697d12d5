r"""Inner and outer raceway side by side, as the bearing meets them.

A raceway answers from the ground, under forces that push it outward. The bearing counts the deviations of
each raceway from its own mean place: its ring displacement is free, so a translation loads no roller.

.. math:: w = u - e\,t,\quad e_j = (\sin\varphi_j, \cos\varphi_j)

with u the outward deviations from the ground and t the mean translation along (y, z), of the first shape
only.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupling.partners import Compliance, LinearRaceway, Raceway

NAMES = "inner", "outer"
OUTWARD = np.array([-1.0, 1.0])  # outward force on a raceway over the force of a roller on it


def radial(azimuths: NDArray, translation: NDArray) -> NDArray:
    """Outward displacement (Z, ...) at the azimuths (Z) [rad] by a translation (2, ...) along (y, z)."""
    return np.tensordot(np.stack([np.sin(azimuths), np.cos(azimuths)], axis=1), translation, axes=1)


def from_mean_place(azimuths: NDArray, absolute: NDArray, translation: NDArray) -> NDArray:
    """Deviations (Z, M, ...) from the ground without the mean translation (2, ...) they contain."""
    relative = absolute.copy()
    relative[:, 0] -= radial(azimuths, translation)
    return relative


def linear_answer(raceway: LinearRaceway, outward: NDArray) -> tuple[NDArray, NDArray]:
    """Outward deviations (Z, M) and mean translation (2) [m] under outward forces (Z, M) [N]."""
    deviation = raceway.initial_deviation + np.tensordot(raceway.absolute, outward, axes=2)
    return deviation, raceway.initial_translation + translation_by(raceway, outward)


def translation_by(raceway: LinearRaceway, outward: NDArray) -> NDArray:
    """What outward forces (..., Z, M) [N] add to the mean translation (..., 2) [m]."""
    return np.tensordot(outward, raceway.translation, axes=([-2, -1], [1, 2]))


@dataclass(frozen=True)
class LinearPair:
    """Both raceways near some forces; None where a raceway is rigid."""

    inner: LinearRaceway | None
    outer: LinearRaceway | None

    @property
    def raceways(self) -> tuple[LinearRaceway | None, LinearRaceway | None]:
        """Inner and outer."""
        return self.inner, self.outer

    @property
    def rigid(self) -> bool:
        """Whether both raceways are rigid."""
        return self.inner is None and self.outer is None

    @property
    def compliance(self) -> Compliance:
        """Outward deviation from the mean place per outward force (Z, M, Z, M) [m/N]."""
        inner, outer = (
            None if r is None else from_mean_place(r.azimuths, r.absolute, r.translation)
            for r in self.raceways
        )
        return inner, outer

    @property
    def initial_deviation(self) -> NDArray | None:
        """Outward deviations (2, Z, M) [m] without roller loads, such as those of tooth forces."""
        return self._initial_deviation

    @cached_property
    def _initial_deviation(self) -> NDArray | None:
        shapes = [
            None if r is None else from_mean_place(r.azimuths, r.initial_deviation, r.initial_translation)
            for r in self.raceways
        ]
        known = [shape for shape in shapes if shape is not None]
        if not any(shape.any() for shape in known):
            return None
        return np.array([np.zeros_like(known[0]) if shape is None else shape for shape in shapes])

    def deviation(self, forces: NDArray) -> NDArray:
        """Outward deviations (2, Z, M) [m] under roller forces (2, Z, M) [N]."""
        initial = self.initial_deviation
        deviation = np.zeros_like(forces) if initial is None else initial.copy()
        for race, compliance in enumerate(self.compliance):
            if compliance is not None:
                deviation[race] += np.tensordot(compliance, OUTWARD[race] * forces[race], axes=2)
        return deviation

    def translation(self, forces: NDArray) -> NDArray:
        """Mean translations (..., 2, 2) of both raceways along (y, z) [m] under forces (..., 2, Z, M) [N]."""
        translation = self.translation_by(forces)
        for race, raceway in enumerate(self.raceways):
            if raceway is not None:
                translation[..., race, :] += raceway.initial_translation
        return translation

    def translation_by(self, forces: NDArray) -> NDArray:
        """What forces (..., 2, Z, M) [N] of the rollers add to these translations (..., 2, 2) [m]."""
        translation = np.zeros((*forces.shape[:-2], 2))
        for race, raceway in enumerate(self.raceways):
            if raceway is not None:
                translation[..., race, :] = translation_by(raceway, OUTWARD[race] * forces[..., race, :, :])
        return translation


@dataclass(frozen=True)
class RacewayPair:
    """What carries the raceways of a bearing, one partner of the coupling."""

    inner: Raceway
    outer: Raceway

    @property
    def rigid(self) -> bool:
        """Whether both raceways are rigid."""
        return self.inner.rigid and self.outer.rigid

    @property
    def solved_in_full(self) -> bool:
        """Whether an answer is a solve of whole solids, so that a tangent costs as much as many answers."""
        return self.inner.solved_in_full or self.outer.solved_in_full

    def linearised(self, forces: NDArray) -> LinearPair:
        """Both near roller forces (2, Z, M) [N]; raises `PartnerFailed`."""
        inner, outer = OUTWARD[:, None, None] * forces
        return LinearPair(self.inner.linearised(inner), self.outer.linearised(outer))

    def answer(self, forces: NDArray) -> tuple[NDArray, Compliance | None]:
        """Outward deviations (2, Z, M) [m] under roller forces (2, Z, M) [N], and the compliance there.

        The compliance is None where solids are solved in full. Raises `PartnerFailed`.
        """
        if not self.solved_in_full:
            linear = self.linearised(forces)
            return linear.deviation(forces), linear.compliance
        deviation = np.empty_like(forces)
        for race, raceway in enumerate((self.inner, self.outer)):
            absolute, translation = raceway.answer(OUTWARD[race] * forces[race])
            deviation[race] = from_mean_place(raceway.azimuths, absolute, translation)
        return deviation, None

    def under(self, azimuths: NDArray) -> "RacewayPair":
        """Both under rollers at other azimuths (Z) [rad]; raises `PartnerFailed`."""
        return RacewayPair(self.inner.under(azimuths), self.outer.under(azimuths))

    def figures(self) -> dict[str, dict[str, object]]:
        """What the result file says of the raceways that are not rigid."""
        raceways = zip(NAMES, (self.inner, self.outer), strict=True)
        return {name: raceway.figures() for name, raceway in raceways if not raceway.rigid}
