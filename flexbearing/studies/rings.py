"""Which elastic rings a case has, and which choices of levels: variants with the same ones go together."""

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from flexbearing.build.ring_parts import Race, part_of
from flexbearing.build.roller_bearing import row_distance
from flexbearing.cache.key import digest
from flexbearing.case import Head
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.roller import Case
from flexbearing.case.tapered import TaperedCase
from flexbearing.families import FAMILIES

RACES: tuple[Race, Race] = ("inner", "outer")


def rings(case: Head) -> tuple[str, ...]:
    """Races and digests of the elastic rings of a case."""
    if isinstance(case, Case):
        parts = {race: part_of(case, race) for race in RACES}
        accuracy, rows = case.accuracy.model_dump_json(), row_distance(case)
        return _named({race: part and (part, accuracy, rows) for race, part in parts.items()})
    if isinstance(case, FastCase | FourPointCase) and not case.rigid:
        from flexbearing.rings import grooves  # finite elements are not described between rigid rings

        return _named(dict(zip(grooves.RACES, grooves.parts(case), strict=True)))
    if isinstance(case, TaperedCase) and not case.rigid:
        from flexbearing.rings import cones

        return _named(dict(zip(cones.RACES, cones.parts(case), strict=True)))
    return ()


def _named(rings: Mapping[str, Any]) -> tuple[str, ...]:
    """Name each elastic ring by its race and all that decides its compliance; None is a rigid one."""
    return tuple(f"{race} {_digest(ring)}" for race, ring in rings.items() if ring is not None)


@lru_cache(maxsize=64)  # most variants of a study have the rings of the one before
def _digest(ring: Any) -> str:
    return digest(ring)


def levels(case: Head) -> str:
    """Digest of the parts of a case with a target and of all that its levels are chosen from."""
    if not isinstance(case, Case | FastCase) or case.accuracy.target is None:
        return ""
    of_family = FAMILIES[case.kind].levels
    assert of_family  # of every family whose cases may have a target
    choices = [(ladder.choice, ladder.settings, ladder.race) for ladder in of_family().ladders(case)]
    return digest([_parts(case), case.accuracy.model_dump(), choices])


def _parts(case: Case | FastCase) -> list[Any]:
    """What carries both raceways, however finely it is resolved; None where that is rigid."""
    if isinstance(case, Case):
        return [part_of(case, race) for race in RACES]
    from flexbearing.rings import grooves  # finite elements are not described between rigid rings

    return [grooves.shape_of(case, race) for race in RACES]
