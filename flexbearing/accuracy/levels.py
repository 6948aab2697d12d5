"""What a roller case leaves open to the accuracy that is ordered, from coarse to fine."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import fem
from fem.parts.step_solid import StepSolid
from flexbearing.accuracy import Choice
from flexbearing.build import expansion, ring_parts
from flexbearing.case.roller import Case
from flexbearing.case.roller.life import FEWEST_SLICES
from flexbearing.rings.condensed import IN_SPACE, ON_A_SECTION

Race = Literal["inner", "outer"]
Settings = Mapping[str, Any]  # keys of [accuracy]

NAMES = {"inner": "inner ring and shaft", "outer": "outer ring"}
SLICES = (10, 20, 40, 80, 160, 320, 640, 1280)  # the last only measures
SHAPES = (2, 4, 6, 8)  # two more at a time: of a pair one may see nothing, for symmetry; the last measures
LOOKS = 2  # levels of these to compare with: the life may pass its limit, and be the same on both sides
# Order of the elements, their size and that on the raceway over the roller length.
SECTION = ((2, 1.2, 0.5), (3, 1.2, 0.4), (4, 1.2, 0.3), (5, 1.2, 0.25), (6, 0.8, 0.2), (8, 0.6, 0.15))
CAGE = tuple((order, 0.6, 0.4) for order in (2, 3, 4, 5))
SOLID = tuple((order, 0.6, 0.4) for order in (2, 3, 4))
MESH = ("element_order", "mesh_size", "raceway_mesh_size")
FEWEST, MORE = 22, 1.5  # harmonics that the coarsest raceway resolves at least, and their growth by level
FEWEST_OF_A_FIT = 37  # which has 36 of its own
PER_SHAPE = 6.0  # of them for each axial shape on an arc as long as the radius
PER_ORDER = 0.6  # of them for each order and element on an arc as long as the radius
NO_PART, SECTIONED, APART, SOLID_PART, FITTED = range(5)  # kinds of choices, the cheapest first
WEIGHT = {NO_PART: 2, SECTIONED: 5, APART: 15, SOLID_PART: 15, FITTED: 15}  # parts of the target
# Errors over the change to the next level, and over that from the one before.
ABOVE = {NO_PART: 1.6, SECTIONED: 2.0, APART: 1.6, SOLID_PART: 2.0, FITTED: 2.0}
BELOW = {SECTIONED: 1.0, APART: 0.6, SOLID_PART: 1.0, FITTED: 1.0}


@dataclass(frozen=True)
class Ladder:
    """A choice with the settings of each of its levels."""

    choice: Choice
    settings: tuple[Settings | None, ...]  # None leaves a part rigid
    race: Race | None = None  # of a part; None: of the bearing, or of both parts
    cost: int = field(default=NO_PART, compare=False)  # place in the order of the climb


def ladders(case: Case) -> tuple[Ladder, ...]:
    """Everything that can be resolved more or less finely, the cheapest first."""
    both: dict[Race, Any] = {"inner": ring_parts.inner_part(case), "outer": ring_parts.outer_part(case)}
    parts: dict[Race, Any] = {race: part for race, part in both.items() if part is not None}
    found = [_slices(case), _shapes(case, parts), *_harmonics(case)]
    found += [_part(case, race, part) for race, part in parts.items()]
    return tuple(sorted(found, key=lambda ladder: ladder.cost))


def _given(case: Case, *keys: str) -> bool:
    """Whether the case itself says one of these keys."""
    return not case.accuracy.model_fields_set.isdisjoint(keys)


def _slices(case: Case) -> Ladder:
    """Slices double: what sharp ends of the line load leave falls as (log K) / K."""
    least, given = FEWEST_SLICES if case.life.edge_stress else 0, case.accuracy.slices
    open_counts = tuple(n for n in SLICES if n >= least)
    counts = (given, 2 * given, 4 * given) if _given(case, "slices") else open_counts
    return _counted("slices", "slices", counts, 0 if _given(case, "slices") else -2)


def _shapes(case: Case, parts: Mapping[Race, Any]) -> Ladder:
    """Axial shapes come two at a time. A raceway with few of them has too few harmonics for a fit."""
    given, length = case.accuracy.axial_shapes, expansion.roller_length(case)
    fits = [part.raceway_diameter / 2 for race, part in parts.items() if in_a_fit(case, race)]
    least = max((FEWEST_OF_A_FIT / (PER_SHAPE * radius / length) for radius in fits), default=0)
    if _given(case, "axial_shapes"):
        return _counted("axial shapes", "axial_shapes", (given, given + 2, given + 4), 0)
    return _counted("axial shapes", "axial_shapes", tuple(n for n in SHAPES if n >= least), -2)


def _counted(name: str, key: str, counts: tuple[int, ...], last: int) -> Ladder:
    """A number that grows; the levels beyond the last one only measure."""
    words = tuple(str(count) for count in counts)
    choice = Choice(
        name=name,
        levels=words,
        weight=WEIGHT[NO_PART],
        above=ABOVE[NO_PART],
        looks=LOOKS,
        last=range(len(counts))[last],
    )
    return Ladder(choice, tuple({key: count} for count in counts))


def _harmonics(case: Case) -> Iterator[Ladder]:
    """Harmonics are those that a mesh resolves, a level of the part; unless the case says how many."""
    if _given(case, "harmonics"):
        counts = (case.accuracy.harmonics, None)
        words = (f"{counts[0]}", "as many as the mesh resolves")
        choice = Choice(name="harmonics", levels=words, weight=WEIGHT[NO_PART], last=0, above=ABOVE[NO_PART])
        yield Ladder(choice, tuple({"harmonics": n} for n in counts))


def _part(case: Case, race: Race, part: Any) -> Ladder:
    """Rigid, then finer and finer; a mesh or structure that the case gives is only measured."""
    solid = case.accuracy.structure == "solid" or isinstance(part, StepSolid)
    cage = isinstance(part, fem.SquirrelCage)
    rows, usual = (SOLID, IN_SPACE) if solid else (CAGE, IN_SPACE) if cage else (SECTION, ON_A_SECTION)
    last = None
    if _given(case, *MESH) or case.accuracy.structure not in ("harmonics", "solid"):
        order = (case.accuracy.element_order or usual[0]) + _given(case, *MESH)
        structure = "solid" if solid else "harmonics"
        settings, last = ({}, {"element_order": order, "structure": structure}), 1
        words = ("as given", f"{structure}, order {order}")
    else:
        fewest = FEWEST_OF_A_FIT if in_a_fit(case, race) else FEWEST
        settings = tuple(_mesh(row, fewest * MORE**k, case, part) for k, row in enumerate(rows))
        words = tuple(f"order {row[0]}, {row[1]:g} / {row[2]:g} roller lengths" for row in rows)
    cost = FITTED if in_a_fit(case, race) else SOLID_PART if solid else APART if cage else SECTIONED
    choice = Choice(
        name=NAMES[race],
        levels=("rigid", *words),
        weight=WEIGHT[cost],
        converging=1,
        last=last,
        above=ABOVE[cost],
        below=BELOW[cost],
    )
    return Ladder(choice, (None, *settings), race, cost)


def in_a_fit(case: Case, race: Race) -> bool:
    """Whether a part is held by a contact that may open or slip, so that it is not linear."""
    return case.inner.fit != "bonded" if race == "inner" else case.outer.lifts_off


def _mesh(row: tuple[int, float, float], harmonics: float, case: Case, part: Any) -> Settings:
    """Settings of a level, its raceway so fine that it resolves at least so many harmonics."""
    order, size, raceway = row
    length, radius = expansion.roller_length(case), part.raceway_diameter / 2
    largest = PER_ORDER * order * radius / harmonics
    return dict(zip(MESH, (order, size * length, min(raceway * length, largest)), strict=True))


def of_place(
    case: Case, ladders: tuple[Ladder, ...], place: tuple[int, ...], race: Race | None
) -> Case | None:
    """The case as it is resolved at a level of each choice; None where a part is left rigid.

    Parameters
    ----------
    case : Case
        as it was read
    ladders : tuple of Ladder
        its choices
    place : tuple of int
        a level of each
    race : "inner", "outer" or None
        for this part, or for the bearing itself

    Returns
    -------
    Case or None
    """
    update: dict[str, Any] = {}
    for ladder, level in zip(ladders, place, strict=True):
        if ladder.race not in (None, race):
            continue
        settings = ladder.settings[level]
        if settings is None:
            return None
        update |= settings
    accuracy = case.accuracy.model_copy(update=update)
    return case.model_copy(update={"accuracy": accuracy})
