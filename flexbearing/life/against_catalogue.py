"""Why the life of a case is not that of a catalogue: one setting after the other."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import pi
from typing import Any

from flexbearing.case import BadCase
from flexbearing.findings.running import NO_MODIFIED_LIFE
from flexbearing.findings.words import of_note
from flexbearing.life.rated_bearing import RatedBearing
from flexbearing.quantities.life_records import Stage
from flexbearing.results import Result

Settings = Mapping[str, str]  # an empty one takes a key or table out, also one given by settings
SUMS = "rating"  # of life.loads, the life of a catalogue alone


@dataclass(frozen=True)
class Influence:
    """Something that a catalogue leaves out, and the settings that leave it out of a case as well."""

    name: str
    out: Settings
    meaning: str  # why it changes the life, a sentence
    also_out: Settings = field(default_factory=dict)  # what later influences need, once they are out too


LUBRICATION = Influence(
    "lubrication",
    {"life.lubrication": "", "life.cleanliness": ""},
    "a_ISO: oil film, particles in it and fatigue limit; see the factor in its own table.",
)
RELIABILITY = Influence(
    "reliability",
    {"life.reliability": ""},
    "More bearings than 90 % must survive this life, so it is shorter.",
)


def require_known_forces(case: Any) -> None:
    """Require forces that are known before the case is solved, and a ring that turns.

    Raises `BadCase` where one of them is missing.
    """
    if case.operation.inner_speed == case.operation.outer_speed:
        raise BadCase("[operation] inner_speed: no ring turns against the other; there is no life.")
    for name in case.operation.held:
        raise BadCase(f"[operation] {name}: a catalogue knows lives under given forces only; give a force.")


@dataclass(frozen=True)
class Catalogue:
    """How lives of one family of bearings are compared with those of a catalogue."""

    rating: tuple[Influence, ...]  # lives by ratings with settings that give them; last: by all loads
    influences: Callable[[Any], Sequence[Influence]]  # of a case, in the order in which they enter
    require_load: Callable[[Any], None]  # raises `BadCase` where a catalogue knows no life
    rated: Callable[[Any], RatedBearing]  # of a case

    def acting(self, case: Any, read: Callable[[Sequence[str]], Any]) -> list[Influence]:
        """Influences that a case has anything of, with the settings that change it."""
        influences = self.influences(case)
        bare, full = read(_together(influences)).to_json(), case.to_json()

        def changing(settings: Settings) -> Settings:
            return {key: value for key, value in settings.items() if _at(full, key) != _at(bare, key)}

        changed = (
            replace(each, out=changing(each.out), also_out=changing(each.also_out)) for each in influences
        )
        return [each for each in changed if each.out]


def against_catalogue(
    case: Any, catalogue: Catalogue, read: Callable[[Sequence[str]], Any], solved: Callable[[Any], Result]
) -> dict[str, Any]:
    """Ratings of a bearing, and the way from the catalogue's life to that of the case.

    Every life is that of the case with settings; those next to each other differ in what the second is named
    after. So the factors multiply to the last life over the first, and nothing is left over. They depend on
    the order, which is that of the `catalogue`.

    Raises `BadCase` without a load, for a case that requires the life by rating alone, and where a case of
    the way has no solution, or not the life that it requires.
    """
    catalogue.require_load(case)
    if case.life.loads == SUMS:
        raise BadCase('[life] loads = "rating": this is the life of a catalogue already; leave it out.')
    stages: list[Stage] = []
    hours = _hours(case)
    for each, settings, left_out in _way(catalogue.rating, catalogue.acting(case, read)):
        found = _lived(solved(_alone(read(settings))), each.name)
        factor = found / stages[-1].life_Mrev if stages else None
        stages.append(Stage(each.name, [*settings], [*left_out], found, found * hours, factor, each.meaning))
    return {
        "title": case.title,
        "ratings": catalogue.rated(case).page(hours).stored(),
        "stages": [*map(vars, stages)],
    }


def _alone(case: Any) -> Any:
    """The case without outputs that a comparison of lives does not need, such as a comparison of its own."""
    return case.model_copy(update={"outputs": type(case.outputs)()})


def _at(table: Any, key: str) -> Any:
    """The value of a dotted key; None where there is none."""
    for part in key.split("."):
        table = table.get(part) if isinstance(table, dict) else None
    return table


def _way(
    ratings: Sequence[Influence], acting: Sequence[Influence]
) -> Iterator[tuple[Influence, tuple[str, ...], tuple[str, ...]]]:
    """What every life is named after, the settings that give it, and those that leave that out."""
    for rating in ratings:
        yield rating, (*_written(rating.out), *_together(acting)), ()
    for place, influence in enumerate(acting):
        yield influence, _together(acting[place + 1 :]), _written(influence.out)


def _together(influences: Sequence[Influence]) -> tuple[str, ...]:
    """Settings that leave out some influences and all later ones."""
    return _written(*({**each.out, **each.also_out} for each in influences))


def _written(*settings: Settings) -> tuple[str, ...]:
    return tuple(f"{key}={value}" for each in settings for key, value in each.items())


def _lived(result: Result, name: str) -> float:
    """The life at the end of a run [10^6 revolutions]."""
    if result.attributes["status"] != "converged":
        raise BadCase(f"{name}: not converged: {result.attributes['message']}")
    block = "flexible" if result.flexible else "rigid"
    modified = (result.attributes.get("life") or {}).get(block, {}).get("modified_Mrev")
    if modified is not None:
        return float(modified)
    for note in result.attributes["notes"]:
        if note["code"] == NO_MODIFIED_LIFE:
            raise BadCase(f"{name}: {of_note(note)}")
    return float(result[f"{block}.life_L10"].to("Mrev"))


def _hours(case: Any) -> float:
    """Hours that a million revolutions take."""
    turning = abs(case.operation.inner_speed - case.operation.outer_speed) / (2 * pi)  # [1/s]
    return 1e6 / turning / 3600
