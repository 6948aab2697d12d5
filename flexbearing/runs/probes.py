"""What the probes of a case read of its rings."""

from typing import TYPE_CHECKING

import numpy as np

from flexbearing.build.probes import probes
from flexbearing.build.ring_parts import NAMES

if TYPE_CHECKING:
    from fem.solid.probes import Readings
    from flexbearing.runs.solved_rows import SolvedRows


def readings(rows: "SolvedRows") -> "Readings | str":
    """Readings of the only case in the order of its probes, or why there are none."""
    from fem.solid.probes import Readings
    from flexbearing.runs.part_fields import NoFields

    numbers, read = [], []
    for race in NAMES:
        if there := probes(rows.cases[0], race):
            numbers += there
            try:
                read.append(rows.fields(race).readings(list(there.values())))
            except NoFields as problem:
                return str(problem)
    order = np.argsort(numbers)
    return Readings(*(np.concatenate(column)[order] for column in zip(*read, strict=True)))
