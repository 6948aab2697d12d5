"""Every key that a case lacks, also those that only show once others are given."""

from collections.abc import Mapping
from copy import deepcopy
from typing import Any

from pydantic import ValidationError

from flexbearing.case.declarations import Declaration, find
from flexbearing.case.quantity import Section
from flexbearing.case.text import setting_value

LAYERS = 12  # of keys that require others; the schema has about four
LACKING = ("missing", "needed")  # types of errors

Details = dict[tuple[str, str, str], Any]


def details(error: ValidationError) -> Details:
    """What an error says, by dotted key, type and context; an entry of a list has no key of its own."""
    return {
        (path, detail["type"], str(detail.get("ctx"))): detail
        for detail in error.errors(include_url=False)
        for path in _paths(detail)
    }


def of_every_layer(error: ValidationError, raw: Mapping[str, Any], model: type[Section]) -> Details:
    """What is wrong with a case, and what it lacks besides once that is repaired.

    Conditions between keys are looked at when the keys of their table are there. Keys that lack are therefore
    filled with examples, choices with the one that requires least, until nothing new lacks.
    """
    found, filled = details(error), deepcopy(dict(raw))
    new = found
    for _ in range(LAYERS):
        _mend(filled, new, model)
        known = {path for path, *_ in found}
        now = _problems(filled, model)
        new = {place: each for place, each in now.items() if place[1] in LACKING and place[0] not in known}
        if not new:
            break
        found |= new
    return found


def _mend(raw: dict[str, Any], problems: Details, model: type[Section]) -> None:
    """Take out what is no key, give what lacks, and replace what cannot be read."""
    choices = []
    for place in sorted(problems):
        path, kind, _ = place
        declaration = find(path, model)
        if kind == "extra_forbidden":
            _take(raw, problems[place]["loc"])
        elif declaration is None:
            continue
        elif declaration.section and (kind in LACKING or not declaration.choices):
            _put(raw, path, {})
        elif kind in LACKING and declaration.choices:
            _put(raw, path, declaration.choices[0])
            choices.append(declaration)
        elif kind != "impossible":  # a contradiction is reported, and hides nothing that lacks
            _put(raw, path, setting_value(declaration.example))
    for declaration in choices:
        _put_least(raw, declaration, model)


def _put_least(raw: dict[str, Any], declaration: Declaration, model: type[Section]) -> None:
    """Give the choice that leaves least to be said."""
    left = {}
    for choice in declaration.choices:
        _put(raw, declaration.path, choice)
        left[choice] = len(_problems(raw, model))
    _put(raw, declaration.path, min(left, key=left.__getitem__))


def _take(raw: dict[str, Any], place: tuple[str, ...]) -> None:
    """Take out a key by the names above it, which may hold dots where they are none of the schema."""
    *tables, name = place
    for table in tables:
        raw = raw[table]
    del raw[name]


def _put(raw: dict[str, Any] | list[dict[str, Any]], path: str, value: Any) -> None:
    """Give a key a value, in every table where there is a list of them."""
    name, _, rest = path.partition(".")
    for table in raw if isinstance(raw, list) else [raw]:
        if rest:
            _put(table.setdefault(name, {}), rest, value)
        else:
            table[name] = value


def _problems(raw: Mapping[str, Any], model: type[Section]) -> Details:
    try:
        model.model_validate(raw)
    except ValidationError as error:
        return details(error)
    return {}


def _paths(detail: Any) -> list[str]:
    """Dotted keys that a problem is about; an entry of a list or a table of texts has none of its own."""
    place = [part for part in detail["loc"] if isinstance(part, str)]
    if place and place[0] in ("assumed", "calibrated"):
        return place[:1]
    names = detail.get("ctx", {}).get("names", [])
    return [".".join([*place, name]) for name in names] or [".".join(place)]
