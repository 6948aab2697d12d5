"""What the probes of a case read of its rings."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from flexbearing.build.probes import probes
from flexbearing.build.ring_parts import NAMES, Race
from flexbearing.case.roller import Case

if TYPE_CHECKING:
    from fem.solid.probes import Readings
    from flexbearing.runs.part_fields import PartFields


def readings(case: Case, fields: "Callable[[Race], PartFields]") -> "Readings | str":
    """Readings of the fields of its rings in the order of its probes, or why there are none."""
    from fem.solid.probes import Readings
    from flexbearing.runs.part_fields import NoFields

    numbers, read = [], []
    for race in NAMES:
        if there := probes(case, race):
            numbers += there
            try:
                read.append(fields(race).readings(list(there.values())))
            except NoFields as problem:
                return str(problem)
    order = np.argsort(numbers)
    return Readings(*(np.concatenate(column, axis=-1)[..., order] for column in zip(*read, strict=True)))
