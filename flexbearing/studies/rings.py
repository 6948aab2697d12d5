"""Which elastic rings a case has, and which choices of levels: variants with the same ones go together."""

from functools import lru_cache
from typing import TYPE_CHECKING

from flexbearing.accuracy.levels import ladders
from flexbearing.build.ring_parts import Race, part_of
from flexbearing.cache.key import digest
from flexbearing.case import Head
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.roller import Case

if TYPE_CHECKING:
    from flexbearing.build.ring_parts import Part

RACES: tuple[Race, Race] = ("inner", "outer")


def rings(case: Head) -> tuple[str, ...]:
    """Races and digests of the elastic rings of a case."""
    if isinstance(case, Case):
        parts = {race: part_of(case, race) for race in RACES}
        accuracy = case.accuracy.model_dump_json()
        return tuple(f"{race} {_name(part, accuracy)}" for race, part in parts.items() if part is not None)
    if isinstance(case, FourPointCase) and not case.rings.rigid:
        return (f"bolted {digest(case.model_dump(include={'bearing', 'materials', 'rings'}))}",)
    return ()


@lru_cache(maxsize=64)  # most variants of a study have the rings of the one before
def _name(part: "Part", accuracy: str) -> str:
    return digest([part, accuracy])


def levels(case: Head) -> str:
    """Digest of the parts of a case with a target and of all that its levels are chosen from."""
    if not isinstance(case, Case) or case.accuracy.target is None:
        return ""
    choices = [(ladder.choice, ladder.settings, ladder.race) for ladder in ladders(case)]
    return digest([[part_of(case, race) for race in RACES], case.accuracy.model_dump(), choices])
