"""The entries of a page, read: numbers with their units, names of the lists of the case."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from math import pi
from typing import Any, get_args

from pydantic_core import PydanticCustomError

from flexbearing import inputs
from flexbearing.case import BadCase, quantity
from flexbearing.case.declarations import find
from flexbearing.case.quantity import Kind
from flexbearing.catalogue.entries import ENTRIES, LIKES, Entry, Like
from flexbearing.printable import excerpt

# Assumed: Harris' 209 and an NU 210 have rollers of 0.55 (D - d)/2 and pitch diameters of 1.007 (d + D)/2, an
# NU 308 and an NUP 204 0.56 and 1.015.
ROLLER, PITCH = 0.555, 1.01
NEEDLE = 0.4  # with which both ratings of NA 4905 to NA 4916 of SKF are met; assumed


def raceways(
    of: Sequence[str], given: Mapping[str, float], roller: float = ROLLER
) -> Iterator[tuple[str, tuple[str, str]]]:
    """Estimate raceways and rollers that are needed besides those given [m], each with its reason.

    Any two of the inner raceway, the outer raceway and the diameter of the rollers give the third.
    """
    if not of:
        return
    known = [name for name in of if name in given]
    diameter = given.get("diameter", roller * (given["outside"] - given["bore"]) / 2)
    if "diameter" not in given and len(known) < 2:  # of three
        yield "diameter", (f"{1e3 * diameter:.4g} mm", f"rule of thumb, {roller:g} (D - d)/2")
    if not {"inner_raceway", "outer_raceway"} & {*given}:
        raceway = PITCH * (given["outside"] + given["bore"]) / 2 + diameter
        yield "outer_raceway", (f"{1e3 * raceway:.5g} mm", f"rule of thumb, {PITCH:g} (d + D)/2 + D_w")


ELEMENTS = 3, 1000  # how many rollers or balls a case may have
SIGNED = ("clearance", "speed", "outer_speed", "axial")  # a negative clearance is a preload


@dataclass(frozen=True)
class Value:
    """What was given for an entry."""

    text: str
    si: float = 0.0  # of a number

    unit: str = ""  # of a number with one
    size: float = 1.0  # of that unit in SI

    def with_unit_of_this(self, si: float) -> str:
        """Another value of the same kind in the unit that was given, for messages."""
        return f"{si / self.size:.4g} {self.unit}"


@dataclass(frozen=True)
class Page:
    """A page of a catalogue with load and speed."""

    like: str
    values: Mapping[str, Value]
    assumed: Mapping[str, str] = field(default_factory=dict)  # entries that nobody gave, and why they are so

    def __contains__(self, name: str) -> bool:
        return name in self.values

    def __getitem__(self, name: str) -> Value:
        return self.values[name]

    def option(self, name: str) -> str:
        """An entry as it was given, for messages."""
        return f"{ENTRIES[name].option} {self.values[name].text}"


def read(like: str, options: Mapping[str, str | None], assumed: Mapping[str, str] | None = None) -> Page:
    """Read the entries of a page.

    Raises `BadCase`, one line for each entry that is missing, cannot be read, or has no use for this kind.
    """
    if like not in LIKES:
        raise BadCase(f"--like {excerpt(like)}: it must be {_either(like, tuple(LIKES))}")
    wanted = LIKES[like]
    given = {name: text for name, text in options.items() if text}
    problems = [f"{ENTRIES[name].option}: a {like} takes none." for name in given if name not in wanted.taken]
    values: dict[str, Value] = {}
    for name in wanted.taken:
        try:
            if name in given:
                values[name] = value(name, given[name], like)
        except BadCase as problem:
            problems.append(str(problem))
    if "clearance" in given:
        beside = [ENTRIES[name].option for name in wanted.instead if name in given]
        problems += [f"--clearance: it is that in operation; leave out {' and '.join(beside)}."] * bool(
            beside
        )
    problems += [f"{words}." for words in missing(wanted, given, like)]
    problems += _together(values)
    if problems:
        raise BadCase("\n".join(problems))
    roller = NEEDLE if like == "needle_roller" else ROLLER
    estimates = dict(raceways(wanted.two_of, {name: each.si for name, each in values.items()}, roller))
    values |= {name: value(name, text, like) for name, (text, _) in estimates.items()}
    reasons = {name: why for name, (_, why) in estimates.items()}
    return Page(like, values, {**(assumed or {}), **reasons})


def _together(values: Mapping[str, Value]) -> Iterator[str]:
    """What is wrong with entries that are right alone."""
    load, speed, outer = (values.get(name) for name in ("load", "speed", "outer_speed"))
    if load and not load.si and "axial" not in values:
        yield f"{ENTRIES['load'].option} {load.text}: it must be above zero."
    if speed and speed.si == (outer.si if outer else 0):
        yield f"--speed {excerpt(speed.text)}: it must be another one than that of the outer ring."


def value(name: str, text: str, like: str) -> Value:
    """Read one entry.

    Raises `BadCase` where it is no quantity of this kind with a unit, no whole number, or not on the list.
    """
    entry = ENTRIES[name]
    given = f"{entry.option} {excerpt(text)}"
    if entry.key:
        choices = names(entry, like)
        if text not in choices:
            raise BadCase(f"{given}: it must be {_either(text, choices)}")
        return Value(text)
    if not entry.quantity:
        try:
            return Value(text.strip(), inputs.whole(text, *ELEMENTS))
        except inputs.BadNumber:
            raise BadCase(f"{given}: it must be {_allowed(entry)}.") from None
    try:
        si = _kind(entry).to_si(text)
    except PydanticCustomError as problem:
        why = (problem.context or {})["why"]
        raise BadCase(f"{given} {why}; it must be {_allowed(entry)}.") from None
    if allowed_sizes := _beyond(name, si):
        raise BadCase(f"{given}: it must {allowed_sizes}.")
    return Value(text.strip(), si, *_kind(entry).unit_of(text))


def _beyond(name: str, si: float) -> str:
    """What a number must be where it is not; empty where it is."""
    thrust_alone = name == "load" and si == 0
    if si <= 0 and name not in SIGNED and not thrust_alone:
        return "be above zero"
    if si == 0 and name == "axial":
        return "not be zero"
    return "be below 90 deg" if name == "angle" and si >= pi / 2 else ""


def missing(wanted: Like, given: Mapping[str, object], like: str) -> Iterator[str]:
    """What a page lacks, each in the words of a message without its end."""
    for name in wanted.needed:
        if wanted.must_be_given(name, given):
            yield f"{called(name)} is missing; it is {allowed(name, like)}"


def called(name: str) -> str:
    """Option and meaning of an entry."""
    entry = ENTRIES[name]
    return f"{', '.join(filter(None, (entry.option, entry.letter)))} ({entry.meaning})"


def allowed(name: str, like: str) -> str:
    """What may stand for an entry."""
    entry = ENTRIES[name]
    return " or ".join(names(entry, like)) if entry.key else _allowed(entry)


def names(entry: Entry, like: str) -> tuple[str, ...]:
    """Names that the case of a kind lists for an entry."""
    from flexbearing.families import FAMILIES

    declaration = find(entry.key, FAMILIES[LIKES[like].kind].case())
    assert declaration is not None
    return tuple(declaration.choices)


def _allowed(entry: Entry) -> str:
    least, most = ELEMENTS
    number = f"a whole number from {least} to {most}"
    what = f"{_kind(entry).name} with its unit" if entry.quantity else number
    return f'{what}, such as "{entry.example}"'


def _kind(entry: Entry) -> Kind:
    annotation: Any = getattr(quantity, entry.quantity)
    return get_args(annotation)[1]


def _either(text: str, choices: tuple[str, ...]) -> str:
    """The choices, and the one that was probably meant."""
    close = get_close_matches(text, choices, n=1)
    return f"{' or '.join(choices)}.{f' Did you mean {close[0]}?' if close else ''}"
