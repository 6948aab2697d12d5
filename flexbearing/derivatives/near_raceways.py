"""Raceways of cases that differ a little from one that is solved, linear near its roller forces."""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from fem.parts.resolution import Shape
from fem.raceway.compliance import combined
from flexbearing.build.ring_parts import Race
from flexbearing.case.roller import Case
from flexbearing.coupling import LinearPair
from flexbearing.coupling.raceway_pair import OUTWARD
from flexbearing.derivatives.ring_slopes import RingSlopes, shape_of
from flexbearing.progress import Silent
from flexbearing.rings.condensed import RACES, raceway, with_growth
from flexbearing.rings.fits import is_in_fit
from flexbearing.rings.moved import raceway_of_shape

if TYPE_CHECKING:
    from fem.raceway.compliance import RacewayCompliance


@dataclass(frozen=True)
class NearRaceways:
    """Raceways of a case in equilibrium, and what other cases change of them."""

    case: Case
    azimuths: NDArray  # (Z) of the rollers [rad]
    forces: NDArray  # (2, Z, M) of the rollers [N]
    pair: LinearPair

    def meshed_alike(self, case: Case) -> Case:
        """Another case, on moved nodes of this one where it changes a flexible ring."""
        if self.pair.rigid:
            return case
        moved = case.on_nodes_of(self.case)
        return case if all(shape_of(moved, race) == shape for race, shape in self._shapes.items()) else moved

    def of(self, case: Case, azimuths: NDArray, forces: NDArray) -> LinearPair:
        """Raceways of a case from `meshed_alike` under rollers at other azimuths, near other forces.

        Raises `RingChanged` where a flexible ring has other faces; `ImpossiblePart`, `BadCase` where the
        dimensions of a ring have no room to change.
        """
        return LinearPair(*(self._raceway(race, case, azimuths, forces) for race in RACES))

    def _raceway(self, race: Race, case: Case, azimuths: NDArray, forces: NDArray) -> Any:
        place = RACES.index(race)
        if self.pair.raceways[place] is None:
            return None
        if is_in_fit(case, race) or not np.array_equal(azimuths, self.azimuths):
            return raceway(case, race, azimuths, Silent()).linearised(OUTWARD[place] * forces[place])
        slopes = self.slopes[race]
        unmoved = case.nodes_of is self.case.nodes_of  # `meshed_alike` found the same shapes
        shape = slopes.shape if unmoved else shape_of(case, race)
        assert shape  # as it is flexible
        if shape == slopes.shape:
            case = case.on_nodes_of(None)  # whose growth is known
        return with_growth(slopes.near(shape), case, race, Silent())

    @cached_property
    def _shapes(self) -> dict[Race, Shape | None]:
        return {race: shape_of(self.case, race) for race in RACES}

    @cached_property
    def slopes(self) -> dict[Race, RingSlopes]:
        """Of flexible rings that no fit holds."""
        return {
            race: self._slopes_of(race, linear)
            for race, linear in zip(RACES, self.pair.raceways, strict=True)
            if linear is not None and not is_in_fit(self.case, race)
        }

    def _slopes_of(self, race: Race, linear: Any) -> RingSlopes:
        outward = OUTWARD[RACES.index(race)] * self.forces[RACES.index(race)]
        shape = shape_of(self.case, race)
        assert shape  # as it is flexible

        def of_shape(other: Shape) -> "RacewayCompliance":
            return raceway_of_shape(self.case, race, other, outward, self.azimuths, Silent())

        return RingSlopes(shape, with_growth(linear, self.case, race, Silent(), -1.0), of_shape, combined)
