"""What the schema says of a key: the one declaration behind messages, `explain` and the reference page."""

import json
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache, cached_property
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, get_args, get_origin

from pydantic import TypeAdapter
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from flexbearing.case.family import Families
from flexbearing.case.head import Head
from flexbearing.case.quantity import Kind, Section

_LIMITS = {"gt": "above", "ge": "at least", "lt": "below", "le": "at most"}
_quoted = json.JSONEncoder(ensure_ascii=False).encode
_PLAIN = {int: "a whole number", float: "a number", bool: "true or false", str: "text"}


@dataclass(frozen=True)
class Declaration:
    """A key of the case file."""

    path: str  # dotted
    field: FieldInfo
    table: str = ""  # the innermost table above it that a case may leave out
    names: tuple[str, ...] = ()  # that may stand there, the default first, where the model does not list them

    @property
    def meaning(self) -> str:
        """What the key says."""
        return self.field.description or ""

    @cached_property
    def section(self) -> type[Section] | None:
        """The model of a table; None for a value."""
        for part in _parts(self.field.annotation):
            if isinstance(part, type) and issubclass(part, Section):
                return part
        return None

    @property
    def kind(self) -> Kind | None:
        """The physical quantity; None for a plain value."""
        candidates = [*self.field.metadata, *_parts(self.field.annotation)]
        return next((item for item in candidates if isinstance(item, Kind)), None)

    @property
    def only(self) -> list[Mapping[str, tuple]]:
        """Choices the key belongs to, see `key`; empty for a key of every choice."""
        extra: Any = self.field.json_schema_extra
        return extra["only"] if extra else []

    @property
    def required(self) -> bool:
        """Whether every case that has its table must give it."""
        return self.field.is_required() and not self.names

    @property
    def need(self) -> str:
        """Who must give it; empty for a key that may be left out."""
        if not self.required:
            return ""
        return f"needed with [{self.table}]" if self.table else "needed"

    @property
    def default(self) -> str:
        """Default in the words of a case file; empty when there is none."""
        value = self.names[0] if self.names else self.field.default
        if value is PydanticUndefined or value is None or self.section:
            return ""
        return toml(value)

    @cached_property
    def choices(self) -> list[Any]:
        """The values that may stand there, of a table those besides it; empty when they are not a few."""
        if self.section:
            return list(self.section.by_name)
        if self.listed:
            return []
        return list(self.names) or [
            choice for part in _parts(self.field.annotation) for choice in _choices(part)
        ]

    @property
    def allowed(self) -> str:
        """What may stand there."""
        if self.section:
            return " or ".join([*map(toml, self.choices), "a table"])
        if self.choices:
            return " or ".join(toml(choice) for choice in self.choices)
        return f"{self._what}{self.range}"

    @property
    def brief(self) -> str:
        """What may stand there, where many keys are reported in one line."""
        return f"such as {self.example}" if self.kind and not self.choices else self.allowed

    @property
    def example(self) -> str:
        """A value as it would be written."""
        if self.field.examples:
            return toml(self.field.examples[0])
        if self.kind:
            return toml(self.kind.example)
        return toml(self.choices[0]) if self.choices else self.default

    @property
    def listed(self) -> bool:
        """Whether the key holds a list."""
        annotation = self.field.annotation
        members = get_args(annotation) if _is_union(annotation) else (annotation,)
        return any(get_origin(member) is tuple for member in members)

    @property
    def number(self) -> bool:
        """Whether the key holds a plain number."""
        plain = any(part in (int, float) for part in _parts(self.field.annotation))
        return plain and not (self.kind or self.choices or self.listed)

    @property
    def whole(self) -> bool:
        """Whether the key holds a whole number."""
        return self.number and float not in tuple(_parts(self.field.annotation))

    @cached_property
    def reader(self) -> Callable[[Any], Any]:
        """What reads a single value of the key, as its table does; raises ValidationError."""
        annotated: Any = Annotated[self.field.annotation, self.field]
        return TypeAdapter(annotated, config=Section.model_config).validate_python

    @property
    def _what(self) -> str:
        if self.listed:
            return self._list
        if self.kind:
            return f"{self.kind.name} as text with its unit, such as {self.example}"
        plain = next((_PLAIN[part] for part in _parts(self.field.annotation) if part in _PLAIN), None)
        return plain or "a table of texts"

    @property
    def _list(self) -> str:
        if self.path == "assumed":
            return "a list of keys"
        each = f"each {self.kind.name} as text with its unit" if self.kind else self._each
        most = next((item.max_length for item in self.field.metadata if hasattr(item, "max_length")), None)
        return f"a list{f' of at most {most}' if most else ''}, {each}, such as {self.example}"

    @property
    def _each(self) -> str:
        parts = list(_parts(self.field.annotation))
        if choices := [choice for part in parts for choice in _choices(part)]:
            return f"each {' or '.join(map(toml, choices))}"
        return "of texts" if str in parts else "of numbers"

    @property
    def range(self) -> str:
        """Between which limits a value must be, after a comma; empty without limits."""
        found = [
            f"{word} {self._limit(getattr(limit, name))}"
            for limit in [*self.field.metadata, *_parts(self.field.annotation)]
            for name, word in _LIMITS.items()
            if getattr(limit, name, None) is not None
        ]
        return ", " + " and ".join(found) if found else ""

    def _limit(self, value: float) -> str:
        """A limit in the unit of the example."""
        if not self.kind:
            return f"{value:g}"
        example = self.field.examples[0] if self.field.examples else self.kind.example
        return self.kind.written(value, example[0] if isinstance(example, list | tuple) else example)


def toml(value: Any) -> str:
    """Write a value as a case file would."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, list | tuple):
        return "[" + ", ".join(toml(item) for item in value) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{toml(name)} = {toml(item)}" for name, item in value.items()) + "}"
    return str(value)


def declarations(families: Families) -> Iterator[Declaration]:
    """Every key and table of every kind of case; those that several kinds have come several times."""
    yield from of_every_case(families)
    for family in families.values():
        yield from (item for item in declared(family.case()) if item.path not in Head.model_fields)


def of_every_case(families: Families) -> Iterator[Declaration]:
    """Keys of every case; `kind` names the families."""
    for item in declared(Head):
        yield replace(item, names=tuple(families)) if item.path == "kind" else item


def declared(model: type[Section], prefix: str = "", table: str = "") -> Iterator[Declaration]:
    """Every key and table of a schema, in its order."""
    for name, field in model.model_fields.items():
        found = Declaration(f"{prefix}{name}", field, table)
        yield found
        if found.section:
            within = table if found.required and not found.choices else found.path
            yield from declared(found.section, f"{found.path}.", within)


def find(path: str, model: type[Section]) -> Declaration | None:
    """Declaration of a dotted key of one kind of case; None when it has no such key."""
    return by_path(model).get(path)


@cache
def by_path(model: type[Section]) -> dict[str, Declaration]:
    """Every key and table of a schema by its dotted key, in its order."""
    return {item.path: item for item in declared(model)}


def kinds_with(path: str, families: Families) -> list[str]:
    """Kinds of case that have a dotted key."""
    return [kind for kind, family in families.items() if find(path, family.case())]


def _parts(annotation: Any) -> Iterator[Any]:
    """Members of a union and metadata of annotated types, NoneType left out."""
    if get_origin(annotation) is Annotated:
        base, *metadata = get_args(annotation)
        yield from _parts(base)
        yield from metadata
    elif get_origin(annotation) is tuple:
        yield from _parts(get_args(annotation)[0])
    elif _is_union(annotation):
        for member in get_args(annotation):
            if member is not NoneType:
                yield from _parts(member)
    else:
        yield annotation


def _is_union(annotation: Any) -> bool:
    return isinstance(annotation, UnionType) or str(get_origin(annotation)).endswith("Union")


def _choices(part: Any) -> tuple[Any, ...]:
    return get_args(part) if get_origin(part) is Literal else ()
