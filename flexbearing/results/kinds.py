"""What a result file holds, by the kind of bearing."""

from dataclasses import dataclass
from typing import Literal

from flexbearing.results.ball_layout import ANGULAR, FOUR_POINT
from flexbearing.results.layout import TABLE, Dataset, datasets

ROLLER = "cylindrical_roller"


@dataclass(frozen=True)
class Layout:
    """Datasets and blocks of one kind of bearing."""

    table: tuple[Dataset, ...]
    blocks: tuple[str, ...]  # that a converged run has
    further: tuple[str, ...] = ()  # that only some cases have

    def datasets(self, place: Literal["iteration", "block"]) -> dict[str, Dataset]:
        """Datasets of an iteration or of a block, by name."""
        return datasets(place, self.table)


LAYOUTS = {
    ROLLER: Layout(TABLE, ("rigid", "flexible")),
    "four_point_ball": Layout(FOUR_POINT, ("rigid",), ("flexible",)),
    "angular_contact_ball": Layout(ANGULAR, ("rigid",)),
}
