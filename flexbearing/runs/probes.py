"""What the probes of a case read of its rings, with the largest stresses of those under balls."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from quasidynamic.note import Note, information

if TYPE_CHECKING:
    from fem.parts.probe import Probe
    from fem.solid.probes import Readings
    from flexbearing.build.groove_parts import BallCase
    from flexbearing.build.ring_parts import Race
    from flexbearing.case.roller import Case

STAGE = "stresses and strains of the rings"
Stresses = Mapping["Race", "dict[str, Any] | str"]  # records of the largest ones, or why there are none


def readings(
    case: "Case | BallCase", read: "Callable[[Race, Sequence[Probe]], Readings]"
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


def records(stresses: Stresses | None) -> "dict[Race, dict[str, Any]]":
    """Largest stresses of the rings of which they are known."""
    return {race: each for race, each in (stresses or {}).items() if not isinstance(each, str)}


def values(case: "BallCase", stresses: Stresses | None) -> dict[str, Any]:
    """Largest stresses and the yield stress, for findings."""
    if not (known := records(stresses)):
        return {}
    from flexbearing.runs import fields  # with finite elements

    return fields.values(case, known)


def notes(read: "Readings | str | None", stresses: Stresses | None = None) -> tuple[Note, ...]:
    """Why there are no readings, and no stresses."""
    lines = (information("no-probes", f"no probes: {read}"),) if isinstance(read, str) else ()
    reasons = (why for why in (stresses or {}).values() if isinstance(why, str))
    return lines + tuple(information("no-stresses", f"no stresses: {why}") for why in reasons)
