"""What the probes of a case read of its rings."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from quasidynamic.note import Note, information

if TYPE_CHECKING:
    from fem.parts.probe import Probe
    from fem.solid.probes import Readings
    from flexbearing.build.ring_parts import Race
    from flexbearing.case.balls.angular_contact import FastCase
    from flexbearing.case.roller import Case


def readings(
    case: "Case | FastCase", read: "Callable[[Race, Sequence[Probe]], Readings]"
) -> "Readings | str":
    """Readings of its rings in the order of the probes of a case, or why there are none."""
    from fem.solid.probes import Readings
    from flexbearing.build.probes import probes
    from flexbearing.build.ring_parts import NAMES
    from flexbearing.runs.part_fields import NoFields

    numbers, of_rings = [], []
    for race in NAMES:
        if there := probes(case, race):
            numbers += there
            try:
                of_rings.append(read(race, list(there.values())))
            except NoFields as problem:
                return str(problem)
    order = np.argsort(numbers)
    return Readings(*(np.concatenate(column, axis=-1)[..., order] for column in zip(*of_rings, strict=True)))


def notes(read: "Readings | str | None") -> tuple[Note, ...]:
    """Why there are no readings."""
    return (information("no-probes", f"no probes: {read}"),) if isinstance(read, str) else ()
