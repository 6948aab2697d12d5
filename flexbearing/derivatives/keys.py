"""The continuous keys of a case: their values, the units they are stated in, cases with other values."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from flexbearing.case import BadCase, Head
from flexbearing.case.declarations import Declaration, declared, find
from flexbearing.case.key_ranges import range_of
from flexbearing.case.problems import nearest
from flexbearing.case.quantity import Section
from flexbearing.case.text import setting_value, tables
from flexbearing.printable import excerpt
from flexbearing.progress import Report

NUMERICS = ("coupling.", "accuracy.", "outputs.", "life.required")  # how it is computed or judged, not what
# Small against the nanometres by which a slice is pressed that just carries load: of a clearance of 60 um and
# of fits that grow the steps are 60 pm. Shorter ones lose the digits of a stiffness between flexible rings.
RELATIVE_STEP = 1e-6  # of a value
TEMPERATURE_STEP = 2e-4  # [K]
AZIMUTH_STEP = 1.5e-7  # [rad] by which all rollers go around: with longer ones contacts stiffen
# Steps of values that are zero, by SI unit: what moves a usual bearing about as far as 2e-6 of a value.
STEPS_FROM_ZERO = {
    "m": 2e-11, "rad": 2e-9, "N": 2e-3, "N m": 2e-6, "m/s^2": 2e-5, "rad/s": 2e-4, "kg": 2e-8,
}  # fmt: skip
STEP_FROM_ZERO = 2e-7  # of other units

Table = TypeVar("Table", bound=Section)


@dataclass(frozen=True)
class Key:
    """A key of a case that holds a continuous value."""

    path: str  # dotted
    value: float  # SI
    unit: str  # as the case states it; empty of a plain number
    size: float  # of that unit in SI
    stated: float  # the value in that unit
    si_unit: str
    relative_step: float = RELATIVE_STEP  # of its differences, of the value
    above: float = float("-inf")  # what the value must stay above, or at
    below: float = float("inf")

    @property
    def step(self) -> float:
        """Of its differences, in SI."""
        if self.si_unit == "K":
            return TEMPERATURE_STEP
        if self.path == "bearing.first_roller_azimuth":
            return AZIMUTH_STEP
        return abs(self.value) * self.relative_step or STEPS_FROM_ZERO.get(self.si_unit, STEP_FROM_ZERO)

    @property
    def is_ratio(self) -> bool:
        """Whether a percent of it means something: not of temperatures, nor of zero."""
        return self.value != 0.0 and self.si_unit != "K"

    @property
    def realistic_step(self) -> float:
        """By which it changes in practice, in its unit."""
        return range_of(self.path).step_of(self.value, self.si_unit) / self.size

    def allows(self, change: float) -> bool:
        """Whether the value may change by so many steps."""
        return self.above <= self.value + change * self.step <= self.below


def given_keys(case: Head) -> list[Key]:
    """Continuous keys that a case states, file and settings together."""
    stated = _stated(case)
    found = []
    for item in _continuous(type(case)):
        value = _value(case, item.path, given=True)
        if isinstance(value, float) and not item.path.startswith(NUMERICS):
            found.append(_key(item, value, stated))
    return found


def keys_of(case: Head, path: str) -> list[Key]:
    """The continuous key of a name, or one for each number of its list, "KEY.1" and so on.

    Raises `BadCase` as `key_of`.
    """
    item = find(path, type(case))
    value = _value(case, path, given=False) if item and item.listed else None
    if item is None or not value or not all(isinstance(each, float) for each in value):
        return [key_of(case, path)]
    stated = _stated(case)
    return [
        _key(replace(item, path=f"{path}.{number}"), each, stated) for number, each in enumerate(value, 1)
    ]


def key_of(case: Head, path: str) -> Key:
    """A continuous key of a case by its name, also where the case leaves it at its default.

    Raises `BadCase` for another key, or one without a value in this case.
    """
    item, named = find(path, type(case)), f"key {excerpt(path)}"
    if item is None:
        families: Any = {}
        raise BadCase(f"{named}: is not a key of this case.{nearest(path, type(case), families)}")
    value = _value(case, path, given=False)
    if item.section or item.listed or not isinstance(value, float) or path.startswith(NUMERICS):
        why = "is not given in this case" if value is None else "does not hold a continuous value"
        raise BadCase(f"{named}: {why}; derivatives are by lengths, loads, speeds and other such numbers.")
    return _key(item, value, _stated(case))


def with_value(case: Table, path: str, value: float) -> Table:
    """The same case with another value of a key, or of a number of its list [SI].

    Limits of the key are not checked; `Key.allows` knows them.
    """
    name, _, below = path.partition(".")
    here = getattr(case, name)
    if isinstance(here, tuple):
        changed = tuple(value if number == int(below) else each for number, each in enumerate(here, 1))
    else:
        changed = with_value(here, below, value) if below else value
    return case.model_copy(update={name: changed})


def _continuous(model: type[Head]) -> Iterator[Declaration]:
    for item in declared(model):
        if not item.section and not item.listed and (item.kind or (item.number and not item.whole)):
            yield item


def _key(item: Declaration, value: float, stated: Mapping[str, str]) -> Key:
    limits = {
        name: limit for part in item.field.metadata for name in ("gt", "ge", "lt", "le")
        if (limit := getattr(part, name, None)) is not None
    }  # fmt: skip
    above = max((limits[name] for name in ("gt", "ge") if name in limits), default=float("-inf"))
    below = min((limits[name] for name in ("lt", "le") if name in limits), default=float("inf"))
    if item.kind is None:
        return Key(item.path, value, "", 1.0, value, "", above=above, below=below)
    like = stated.get(item.path, f"1 {item.kind.unit}")
    unit, size = item.kind.unit_of(like)
    return Key(
        item.path, value, unit, size, item.kind.number(value, like), item.kind.unit, above=above, below=below
    )


def _value(case: Head, path: str, *, given: bool) -> Any:
    """Value of a key; None where a table on the way is left out, or the key itself if it must be given."""
    table: Any = case
    for name in path.split("."):
        if table is None or (given and name not in table.model_fields_set):
            return None
        table = getattr(table, name)
    return table


def _stated(case: Head) -> dict[str, str]:
    """Quantities as the file and its settings write them, by key."""
    texts = dict(_texts(tables(case.source.text), "")) if case.source.text else {}
    for setting in case.source.overrides:
        key, _, value = setting.partition("=")
        written = setting_value(value.strip()) if value.strip() else None
        texts[key.strip()] = written if isinstance(written, str) else ""
    return {key: text for key, text in texts.items() if text}


def _texts(table: Mapping[str, Any], prefix: str) -> Iterator[tuple[str, str]]:
    for name, value in table.items():
        if isinstance(value, Mapping):
            yield from _texts(value, f"{prefix}{name}.")
        elif isinstance(value, str):
            yield f"{prefix}{name}", value


def announced(keys: Sequence[Key], report: Report) -> Iterator[Key]:
    """Yield keys one by one, and tell how many are done: a key that changes a flexible ring takes seconds."""
    text = f"derivatives by {len(keys)} keys" if len(keys) != 1 else f"derivatives by {keys[0].path}"
    report.stage(text, 0.0)
    for number, key in enumerate(keys, 1):
        yield key
        report.stage(text, number / len(keys))
