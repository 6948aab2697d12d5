"""Components of a gearbox model with their attributes and relations."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from flexbearing import inputs
from flexbearing.case import BadCase
from flexbearing.printable import excerpt

UNITS = {"": "none", "\N{DEGREE SIGN}": "deg", "\N{DEGREE SIGN}C": "C"}  # other spellings of files
Roles = Mapping[str, str]  # role to number of a component


@dataclass(frozen=True)
class Value:
    """What an attribute has: a text, or several in an array."""

    unit: str
    text: str
    array: tuple[str, ...] = ()

    @property
    def has_content(self) -> bool:
        """Whether it is neither empty nor zero."""
        return bool(self.array) or self.text.rstrip("0.") not in ("", "false", "none")


@dataclass(frozen=True)
class Part:
    """A component with its attributes."""

    number: str
    kind: str
    name: str
    attributes: Mapping[str, Value]

    def number_of(self, name: str, unit: str) -> float | None:
        """A number in a unit as REXS spells it; None where the part does not have it.

        Raises `BadCase` for another unit, or no number.
        """
        value = self.attributes.get(name)
        return None if value is None else self._number(name, value, value.text, unit)

    def vector_of(self, name: str, unit: str) -> tuple[float, ...]:
        """Numbers of an array, see `number_of`; empty where the part does not have it."""
        value = self.attributes.get(name)
        return () if value is None else tuple(self._number(name, value, each, unit) for each in value.array)

    def text_of(self, name: str) -> str:
        """A text; empty where the part does not have it."""
        return self.attributes[name].text if name in self.attributes else ""

    def _number(self, name: str, value: Value, text: str, unit: str) -> float:
        where = f"component {excerpt(self.number)}: {name}"
        try:
            if UNITS.get(value.unit, value.unit) == unit:
                return inputs.number(text)
        except inputs.BadNumber as problem:
            raise BadCase(f"{where}: {problem}.") from problem
        raise BadCase(f"{where} is {excerpt(text)} {excerpt(value.unit)}, no number in {unit}.")


@dataclass(frozen=True)
class Model:
    """The components of a model by their numbers, their relations, and what changes in its load cases."""

    version: str
    parts: Mapping[str, Part]
    related: Mapping[tuple[str, str, str], tuple[Roles, ...]]  # kind, role and number of one that has it
    load_cases: tuple[Mapping[str, Part], ...]
    not_read: tuple[str, ...] = ()  # other files of the archive, further spectra

    @cached_property
    def contents(self) -> Mapping[str, Mapping[str, bool]]:
        """Attributes of each component in the model and its load cases, and whether one has content."""
        found: dict[str, dict[str, bool]] = {}
        for parts in (self.parts, *self.load_cases):
            for number, part in parts.items():
                of_part = found.setdefault(number, {})
                for name, value in part.attributes.items():
                    of_part[name] = of_part.get(name, False) or value.has_content
        return found

    def loaded(self, part: Part, number: int) -> Part:
        """A component with its attributes in a load case; the same where there is no such load case."""
        changed = self.load_cases[number].get(part.number) if number < len(self.load_cases) else None
        return replace(part, attributes={**part.attributes, **changed.attributes}) if changed else part

    def all_of(self, relation: str, part: Part | None, own_role: str, role: str) -> Iterator[Part]:
        """The components in a role of the relations in which one has its own role, in their order."""
        for roles in self.related.get((relation, own_role, part.number), ()) if part else ():
            if found := self.parts.get(roles.get(role, "")):
                yield found

    def one_of(self, relation: str, part: Part | None, own_role: str, role: str, kind: str) -> Part | None:
        """The first one of a kind, see `all_of`."""
        return next((each for each in self.all_of(relation, part, own_role, role) if each.kind == kind), None)
