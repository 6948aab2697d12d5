"""Dimensions and moduli of a part as numbers by name, and the part with other ones."""

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any, TypeVar

PLACES = ("offset",)  # numbers that may be zero; other dimensions of zero are features that are not there

Part = TypeVar("Part")


def numbers(part: Any) -> dict[str, float]:
    """Numbers of a frozen part and of what it consists of."""
    found = {}
    for name, value in _fields(part).items():
        if is_dataclass(value):
            found |= {f"{name}.{inner}": number for inner, number in numbers(value).items()}
        elif isinstance(value, float) and (value or name in PLACES):
            found[name] = value
    return found


def with_numbers(part: Part, changed: Mapping[str, float]) -> Part:
    """The same part with other numbers, by their dotted names; a part that cannot be raises its own error."""
    new: dict[str, Any] = {}
    for name, value in _fields(part).items():
        inner = {key.removeprefix(f"{name}."): v for key, v in changed.items() if key.startswith(f"{name}.")}
        if inner:
            new[name] = with_numbers(value, inner)
        elif name in changed:
            new[name] = changed[name]
    return replace(part, **new)  # type: ignore[type-var]


def _fields(part: Any) -> dict[str, Any]:
    return {each.name: getattr(part, each.name) for each in fields(part) if each.init}
