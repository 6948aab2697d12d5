"""Levels of choices as settings of [accuracy] of a case, as every family of bearings has them."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import IntEnum
from typing import TYPE_CHECKING, Any, TypeVar

from flexbearing.accuracy.ladder import Choice, Place

if TYPE_CHECKING:
    from flexbearing.build.ring_parts import Race

Settings = Mapping[str, Any]  # keys of [accuracy]
C = TypeVar("C", bound=Any)  # a case with the section [accuracy]

COMPARED = 2  # richer levels of a number: an output may pass its limit, and be the same on both sides


class Cost(IntEnum):
    """Kinds of choices, the cheapest first."""

    BEARING = 0
    SECTION = 1
    CYCLIC = 2
    SOLID = 3
    FIT = 4


WEIGHT = {Cost.BEARING: 2, Cost.SECTION: 5, Cost.CYCLIC: 15, Cost.SOLID: 15, Cost.FIT: 15}  # of the target
# Errors over the change to the next level, and over that from the one before.
ABOVE = {Cost.BEARING: 1.6, Cost.SECTION: 2.0, Cost.CYCLIC: 1.6, Cost.SOLID: 2.0, Cost.FIT: 2.0}
BELOW = {Cost.SECTION: 1.0, Cost.CYCLIC: 0.6, Cost.SOLID: 1.0, Cost.FIT: 1.0}


@dataclass(frozen=True)
class Ladder:
    """A choice with the settings of each of its levels."""

    choice: Choice
    settings: tuple[Settings | None, ...]  # None leaves a part rigid
    race: "Race | None" = None  # of a part; None: of the bearing, or of both parts
    cost: Cost = field(default=Cost.BEARING, compare=False)  # place in the order of the climb


def given(case: Any, *keys: str) -> tuple[str, ...]:
    """Those of these keys that the case itself sets."""
    return tuple(key for key in keys if key in case.accuracy.model_fields_set)


def counted(name: str, key: str, counts: tuple[int, ...], cost: Cost = Cost.BEARING) -> Ladder:
    """A number that grows; the richest level only measures."""
    choice = Choice(
        name=name,
        levels=tuple(str(count) for count in counts),
        weight=WEIGHT[cost],
        above=ABOVE[Cost.BEARING],
        compared=COMPARED,
        last=len(counts) - 2,
    )
    return Ladder(choice, tuple({key: count} for count in counts), cost=cost)


def fixed(name: str, key: str, counts: tuple[int, ...], cost: Cost = Cost.BEARING) -> Ladder:
    """A number that the case gives; the richer levels only measure."""
    ladder = counted(name, key, counts, cost)
    return replace(ladder, choice=replace(ladder.choice, last=0, fixed_by=(key,)))


def case_at(case: C, ladders: tuple[Ladder, ...], place: Place, race: "Race | None" = None) -> C | None:
    """The case as it is resolved at a level of each choice; None where a part is left rigid."""
    update: dict[str, Any] = {}
    for ladder, level in zip(ladders, place, strict=True):
        if ladder.race not in (None, race):
            continue
        settings = ladder.settings[level]
        if settings is None:
            return None
        update |= settings
    return with_accuracy(case, **update)


def with_accuracy(case: C, **settings: Any) -> C:
    """The case with other settings of [accuracy]."""
    return case.model_copy(update={"accuracy": case.accuracy.model_copy(update=settings)})
