"""Rating life: of the end states, its factors, and the way from that of a catalogue."""

from collections.abc import Iterator
from math import inf, isclose, log
from typing import Any

import numpy as np

from flexbearing.quantities.reductions import RACES
from flexbearing.report.html import oil, ratings
from flexbearing.report.html.document import Block, Cell, Items, Table, Words
from flexbearing.report.html.lives import lives
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed

_STEPS = {  # by end state: name, why of rollers, why of balls
    "rigid": (
        "loads of all rolling elements, rigid rings",
        "several influences in one factor, which one solution cannot split: clearance, profile, centrifugal "
        "force, and capacities of Lundberg and Palmgren instead of C_r",
        "several influences in one factor, which one solution cannot split: clearance, contact angles and "
        "centrifugal force",
    ),
    "flexible": (
        "flexible rings",
        *2
        * (
            "elastic rings, shaft and supports change how many rolling elements carry, how much, and where "
            "along them",
        ),
    ),
}
_BY_C_R = (
    "loads of all slices by the same C_r",
    "several influences in one factor, which one solution cannot split: exponent 4 of slices instead of "
    "10/3, λν = 0.83 taken out of C_r, clearance, profile, centrifugal force",
)
_HELD = (
    "flexible rings, inner ring held straight",
    "elastic rings, shaft and supports change how many rolling elements carry, and how much; estimated by "
    "Newton steps",
)
_FREE = (
    "inner ring free to tilt",
    "it follows the elastic rings until the moments balance, which shares the load along the rollers anew",
)
_MISALIGNED = "; the tilt of the inner ring presses the ends of the rollers"
_REFERENCE = "Reference life L10r, ISO/TS 16281"
_CAPACITY = "capacity"  # factor from the capacities of Lundberg and Palmgren to C_r
_FIRST = "outputs/{}.life_L10"  # place of the first life of a case
_OWN = (
    "This a_ISO holds at the equivalent load of its note, which gives the reference life of the loads "
    "computed here; that of a catalogue holds at P of the ratings."
)
_NO_CAUSE = (
    "Capacity leads from the capacities of Lundberg and Palmgren back to C_r, by which the catalogue's life "
    "is computed, too: it is no difference from that life. "
)
_HOW = (
    "The first factor above holds these influences together. To split it, each needs a solution of its own: "
    "`flexbearing life {case}` prints them. For a report with them: "
    "`flexbearing run {case} --set outputs.catalogue_life=true -o OUT.h5`, then `flexbearing report OUT.h5`."
)


def blocks(reader: Reader) -> Iterator[Block]:
    """Lives, factors, ratings; a sentence where this kind of bearing has no life."""
    if not reader.blocks:
        return
    if "life_L10" not in reader.blocks[reader.last]:
        yield Words(("No rating life was computed for this case.",))
        return
    yield from _of_raceways(reader)
    yield from _shorter(reader)
    yield from _factors(reader)
    rated = ratings.table(reader)
    yield Words((rated,)) if isinstance(rated, str) else rated
    if ratings.viscosity_ratio(reader) is not None:
        yield from ratings.at_other_temperatures(reader, oil.sufficient_at(reader)[0])
    catalogue = reader.attributes.get("catalogue_life")
    if catalogue:
        yield from _catalogue(reader, catalogue)
    elif not isinstance(rated, str):
        yield from _by_what_was_solved(reader)
        yield from _left_out(reader)


def _of_raceways(reader: Reader) -> Iterator[Table]:
    """First life of the case, that of each raceway alone, where it is known."""
    block = reader.blocks[reader.last]
    names = [f"raceway_life.{race}" for race in RACES if "raceway_life" in block]
    labels = ["both raceways together", *(f"{race} raceway alone" for race in RACES)]
    rows: list[tuple[Cell, ...]] = []
    for label, name in zip(labels, ["life_L10", *names], strict=False):
        hours: Cell = reader.output(name, "h", ",.4g") if block.get("relative_speed") else ""
        rows.append((label, reader.output(name, "Mrev", ",.4g"), hours))
    first = next(each.name for each in lives(reader) if each.turns.of.startswith(_FIRST.format(reader.last)))
    note = "Which life to use, and all others, are in the verdict."
    caption = f"{first} by raceways, {reader.state}, 90 % survive"
    yield Table(caption, ("of", "10⁶ revolutions", "hours"), tuple(rows), note)


def _shorter(reader: Reader) -> Iterator[Words]:
    """Which raceway has the shorter life."""
    lives = reader.summary[reader.last].get("raceway_life_Mrev") or {}
    known = {race: life for race, life in lives.items() if life is not None}
    if len(set(known.values())) > 1:
        yield Words((f"The {min(known, key=known.__getitem__)} raceway has the shorter life.",))


def _factors(reader: Reader) -> Iterator[Table]:
    """Factors of the modified life."""
    life = (reader.attributes.get("life") or {}).get(reader.last)
    if not life or "modified_Mrev" not in life:
        return
    path, first = f"life/{reader.last}", _FIRST.format(reader.last)
    of = next(each.name for each in lives(reader) if each.turns.of.startswith(first))
    rows: list[tuple[Cell, ...]] = [
        (of, reader.of_attribute(f"{path}/basic_Mrev", "Mrev", "Mrev", ",.4g"), "10⁶ revolutions")
    ]
    for name, value, turns, note in _stepped(reader):
        rows.append((name, turns, note) if turns else (f"  times {name}", value, note))
    modified = reader.of_attribute(f"{path}/modified_Mrev", "Mrev", "Mrev", ",.4g")
    rows.append(("modified life", modified, ""))
    own = any(factor["name"] == "a_ISO" for factor in life["factors"])
    yield Table(
        "Modified life, factor by factor",
        ("step", "value", "note"),
        tuple(rows),
        _NO_CAUSE * by_same_rating(reader) + _OWN * own,
    )


def _stepped(reader: Reader, catalogue: float | None = None) -> Iterator[tuple[str, Cell, Cell, str]]:
    """Factors of the modified life with their notes; between them the reference life over the basic one.

    From a life of the catalogue [10^6 revolutions] on the capacity is no step, as states are by C_r, too.
    """
    life, path = reader.attributes["life"][reader.last], f"life/{reader.last}"
    reference = float(reader.blocks[reader.last].get("reference_life", inf)) / 1e6
    reached = life["basic_Mrev"]
    for place, factor in enumerate(life["factors"]):
        value = reader.of_attribute(f"{path}/factors/{place}/value", "", "", ".4g")
        if catalogue is None or factor["name"] != _CAPACITY:
            yield factor["name"], value, "", factor["note"]
        before, reached = reached, reached * factor["value"]
        if isclose(reached, reference, rel_tol=1e-9) and before != reached:
            of = "basic life" if catalogue is None else "catalogue's life"
            times = f"{reference / (catalogue or life['basic_Mrev']):.4g} times the {of}"
            times += ", product of the factors since"
            yield _REFERENCE, "", reader.output("reference_life", "Mrev", ",.4g"), times


def _by_what_was_solved(reader: Reader) -> Iterator[Table]:
    """From the catalogue's life to that of the case, by the end states and factors of this run alone."""
    rated = ratings.found(reader)
    if isinstance(rated, str) or reader.attributes["case_si"]["life"].get("loads") == "rating":
        return
    values, at = rated
    rows: list[tuple[Cell, ...]] = []
    before, place = values["life_Mrev"], f"{at}/life_Mrev"
    start = reader.units.number(before, "Mrev", "Mrev", ",.4g", place)
    rows.append(("Catalogue's life L10, ISO 281", "", start, "(C_r/P)^p: one load P on a usual bearing"))
    for name, now, path, why in _states(reader):
        times = reader.units.number(now / before, "", "", ".3g", f"ratio/{path}:{place}")
        rows.append((name, times, reader.units.number(now, "Mrev", "Mrev", ",.4g", path), why))
        before, place = now, path
    life, path = (reader.attributes.get("life") or {}).get(reader.last), f"life/{reader.last}"
    if life and "modified_Mrev" in life:
        rows += _stepped(reader, values["life_Mrev"])
        modified = reader.of_attribute(f"{path}/modified_Mrev", "Mrev", "Mrev", ",.4g")
        rows.append(("Life of this case after all factors", "", modified, ""))
    head = ("step", "times", "life [10⁶ revolutions]", "why")
    yield Table("Why the life is not that of the catalogue: by what this run solved", head, tuple(rows))


def chain(reader: Reader) -> list[tuple[str, float]]:
    """Factors from the catalogue's life to that of the case, the largest first; none without a catalogue."""
    stages = (reader.attributes.get("catalogue_life") or {}).get("stages", ())
    found = [(stage["name"], stage["factor"]) for stage in stages if stage["factor"]]
    if not found:
        found = list(_solved_factors(reader))
    return sorted(found, key=lambda step: -abs(log(step[1])))


def _solved_factors(reader: Reader) -> Iterator[tuple[str, float]]:
    """The same by what this run solved."""
    rated = ratings.found(reader)
    if isinstance(rated, str) or reader.attributes["case_si"]["life"].get("loads") == "rating":
        return
    before = rated[0]["life_Mrev"]
    for name, now, _, _ in _states(reader):
        yield name, now / before
        before = now
    for factor in ((reader.attributes.get("life") or {}).get(reader.last) or {}).get("factors", ()):
        if factor["name"] != _CAPACITY:  # which lives of states have
            yield factor["name"], factor["value"]


def by_same_rating(reader: Reader) -> bool:
    """Whether the life of the case is by the C_r of the catalogue's, not by Lundberg and Palmgren."""
    return _capacity(reader, reader.last) is not None


def _capacity(reader: Reader, block: str) -> tuple[float, str] | None:
    """Life by C_r over that by Lundberg and Palmgren at an end state, with its place; None without one."""
    factors = ((reader.attributes.get("life") or {}).get(block) or {}).get("factors", ())
    found = [
        (factor["value"], f"attributes/life/{block}/factors/{place}/value")
        for place, factor in enumerate(factors) if factor["name"] == _CAPACITY
    ]  # fmt: skip
    return next(iter(found), None)


def _states(reader: Reader) -> Iterator[tuple[str, float, str, str]]:
    """End states by their lives [10^6 revolutions]; a ring free to tilt also with its tilt held.

    Lives without edge stress, oil and steel: by C_r where the case has it, else basic ones.
    """

    def rated(life: float, path: str) -> tuple[float, str]:
        capacity = _capacity(reader, block)
        return (life, path) if capacity is None else (life * capacity[0], f"times/{capacity[1]}|{path}")

    held = reader.attributes.get("tilt") or {}
    for block in reader.blocks:
        name, *why = _STEPS[block]
        if block == "rigid" and by_same_rating(reader):
            name, why = _BY_C_R[0], [*2 * _BY_C_R[1:]]
        words = why[reader.of_balls] + _MISALIGNED * (block == "rigid" and _tilted(reader))
        if block == "flexible" and held.get("inner_ring") == "free" and "otherwise" in held:
            other = "attributes/tilt/otherwise/life_L10_Mrev"
            yield _HELD[0], *rated(held["otherwise"]["life_L10_Mrev"], other), _HELD[1]
            name, words = _FREE
        life = rated(reader.summary[block]["life_L10_Mrev"], f"summary/{block}/life_L10_Mrev")
        yield name, *life, words + _carrying(reader, block)


def _tilted(reader: Reader) -> bool:
    return reader.of_rollers and bool(np.any(reader.blocks["rigid"]["ring_tilt"]))


def _carrying(reader: Reader, block: str) -> str:
    """How many rollers of an end state carry, and how much the most loaded one."""
    numbers = reader.summary[block]
    if not reader.of_rollers:
        return ""
    load = reader.units.number(numbers["max_roller_load_N"], "N", "N", ",.4g", "")
    count, of = numbers["loaded_rollers"], reader.bearing["rollers"]
    return f". Here {count} of {of} rollers carry, the most loaded one {load.text} {printed(load.unit)}"


def _left_out(reader: Reader) -> Iterator[Block]:
    """What the catalogue's life leaves out of the case, without its size."""
    family = reader.result.family
    assert family.catalogue is not None  # there are ratings
    known: Any = family.catalogue()
    how = _HOW.format(case=reader.case_name)
    try:
        influences = (*known.rating, *known.acting(reader.case, reader.case_with))
    except ValueError as problem:  # the case without an influence is none
        yield Words((f"{how} What lies between is not known: {problem}",))
        return
    rows = tuple((influence.name, influence.meaning) for influence in influences)
    yield Table("What the catalogue's life leaves out of this case", ("influence", "why"), rows, how)


def _catalogue(reader: Reader, found: dict[str, Any]) -> Iterator[Block]:
    """Every life from the catalogue's to that of the case."""
    from flexbearing.report.catalogue_life import is_stated  # brings rich

    stages: list[tuple[Cell, ...]] = []
    for place, stage in enumerate(found["stages"]):
        why = stage["meaning"] if is_stated(stage) else ""
        path = f"catalogue_life/stages/{place}"
        factor: Cell = "" if stage["factor"] is None else reader.of_attribute(f"{path}/factor", "", "", ".4g")
        lives = (reader.of_attribute(f"{path}/life_{unit}", unit, unit, ",.4g") for unit in ("Mrev", "h"))
        stages.append((stage["name"], factor, *lives, why))
    head = ("influence", "factor", "life [10⁶ revolutions]", "life [h]", "why")
    note = (
        "Every life is that of a case of its own, without what the lines below it add; a factor is the "
        "ratio of neighbouring lives. Factors within 1 % of 1 have no sentence."
    )
    yield Table(
        "From the life of the catalogue (ISO 281) to that of the case (ISO/TS 16281)",
        head,
        tuple(stages),
        note,
    )
    left_out = [f"{stage['name']}: " + " ".join(f'--set "{each}"' for each in stage["left_out_by"])
                for stage in found["stages"] if stage["left_out_by"]]  # fmt: skip
    if left_out:
        yield Items("An influence is left out of `flexbearing run` by", tuple(left_out))
