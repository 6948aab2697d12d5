"""Raceways that answer roller forces at once: rigid, or condensed to their stiffness at the rollers."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexbearing.program.threads import cores

if TYPE_CHECKING:
    from fem.raceway.compliance import RacewayCompliance
    from fem.raceway.harmonics import HarmonicCompliance
    from flexbearing.case.roller import Case

Ahead = Callable[[], "HarmonicCompliance"]


@dataclass(frozen=True)
class RigidRaceway:
    """A raceway that no force moves."""

    azimuths: NDArray  # (Z) [rad]
    rigid = True
    solved_in_full = False

    def answer(self, outward: NDArray) -> tuple[NDArray, NDArray]:
        """No deviation (Z, M) [m], no translation (2) [m]."""
        return np.zeros_like(outward), np.zeros(2)

    def linearised(self, outward: NDArray) -> None:
        """No compliance."""

    def under(self, azimuths: NDArray) -> "RigidRaceway":
        """The same under rollers at other azimuths (Z) [rad]."""
        return replace(self, azimuths=azimuths)

    def figures(self) -> dict[str, object]:
        """Nothing was computed."""
        return {}


@dataclass(frozen=True)
class CondensedRaceway:
    """A raceway whose stiffness is condensed: linear for all forces."""

    compliance: "RacewayCompliance"
    at: "Callable[[NDArray], RacewayCompliance] | None" = field(default=None, compare=False, repr=False)
    further: Mapping[str, Mapping[str, float]] = field(default_factory=dict)  # figures for the result file
    rigid = False
    solved_in_full = False

    @property
    def azimuths(self) -> NDArray:
        """Of the rollers (Z) [rad]."""
        return self.compliance.azimuths

    def answer(self, outward: NDArray) -> tuple[NDArray, NDArray]:
        """Outward deviations (Z, M) and mean translation (2) [m] under outward forces (Z, M) [N]."""
        from flexbearing.coupling.raceway_pair import linear_answer  # rings are begun without

        return linear_answer(self.compliance, outward)

    def linearised(self, outward: NDArray) -> "RacewayCompliance":
        """The same for all forces."""
        return self.compliance

    def figures(self) -> dict[str, object]:
        """What the finite elements cost and how stiff the support is."""
        return compliance_figures(self.compliance) | dict(self.further)

    def with_axial_modes(self, count: int) -> "CondensedRaceway":
        """The same raceway for rollers that exchange fewer axial modes with it: a part of every array."""
        return replace(self, compliance=with_axial_modes(self.compliance, count))

    def under(self, azimuths: NDArray) -> "CondensedRaceway":
        """The same raceway under rollers at other azimuths (Z) [rad]; a solid is condensed anew for them."""
        assert self.at is not None  # of a raceway that was condensed for a case
        modes = self.compliance.absolute.shape[1]
        return replace(self, compliance=self.at(azimuths)).with_axial_modes(modes)


def with_axial_modes(compliance: "RacewayCompliance", count: int) -> "RacewayCompliance":
    """The same compliance in fewer axial modes."""
    return replace(
        compliance,
        absolute=compliance.absolute[:, :count, :, :count],
        translation=compliance.translation[..., :count],
        initial_deviation=compliance.initial_deviation[:, :count],
    )


def compliance_figures(compliance: "RacewayCompliance") -> dict[str, object]:
    """What the finite elements cost and how stiff the support is, for the result file."""
    stiffness, error = compliance.support_stiffness, compliance.support_error
    known_error = None if error is None or not np.isfinite(stiffness) else error * stiffness
    return {
        "unknowns": compliance.unknowns,
        "elements": compliance.elements,
        "support_stiffness_N_per_m": stiffness if np.isfinite(stiffness) else None,
        "support_stiffness_error_N_per_m": known_error,
        "seconds": compliance.seconds,
    }


@contextmanager
def outer_ring_ahead(case: "Case") -> Iterator[Ahead | None]:
    """Begin with the outer ring of a case in a process of its own."""
    from flexbearing.build.ring_parts import part_of  # balls are between the same raceways without rollers

    part = part_of(case, "outer")
    chosen_later = case.accuracy.target is not None or case.coupling.structure == "full"
    if part is None or chosen_later or cores() == 1:
        yield None
        return
    # finite elements are not loaded between rigid rings
    from fem.condense import condensing, is_cage_in_space
    from flexbearing.cache import configured
    from flexbearing.rings.resolution import resolved

    arguments = resolved(part, case)
    if not is_cage_in_space(*arguments[:2]) or configured().holds(arguments):
        yield None
        return
    with condensing(*arguments) as answer:
        yield answer
