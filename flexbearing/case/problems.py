"""What is wrong with a case file, said so that it can be put right."""

from collections.abc import Callable, Collection, Mapping
from itertools import islice
from typing import Any, TypeVar

from pydantic import ValidationError

from flexbearing.case.declarations import Declaration, by_path, find, kinds_with, toml
from flexbearing.case.family import Families
from flexbearing.case.missing import LACKING, of_every_layer
from flexbearing.case.quantity import Section
from flexbearing.printable import LONGEST, excerpt, printable

MOST = 20  # problems that are reported
MOST_PLACES = 3  # of one name
Problem = TypeVar("Problem")
File = TypeVar("File", bound=Section)


class BadCase(ValueError):
    """A case that cannot be computed; one line for each problem, without control characters."""

    def __init__(self, message: str):
        super().__init__(printable(message))


def listed(problems: Collection[Problem], file: str, line: Callable[[Problem], str]) -> str:
    """One line for each of the first problems, and how many more there are."""
    lines = [f"{file}: {line(problem)}" for problem in islice(problems, MOST)]
    if (left := len(problems) - len(lines)) > 0:
        lines.append(f"{file}: {left} more of them.")
    return "\n".join(lines)


def validated(raw: Mapping[str, Any], file: str, model: type[File], families: Families) -> File:
    """What a file holds, as its model.

    Raises `BadCase` with a line for each problem.
    """
    try:
        return model.model_validate(raw)
    except ValidationError as error:
        raise BadCase(_messages(error, raw, file, model, families)) from None


def _messages(
    error: ValidationError, raw: Mapping[str, Any], file: str, model: type[Section], families: Families
) -> str:
    """One line per problem: file, key, value found, what is allowed, nearest valid name.

    Keys that lack are reported at once, those of a table that lacks in the line of the table.
    """
    found = of_every_layer(error, raw, model)
    lacking = {path: detail for (path, kind, _), detail in found.items() if kind in LACKING}
    lines = [item for item in found.items() if not _told_above(item[0][0], lacking, model)]
    return listed(lines, file, lambda item: _message(item[1], item[0][0], raw, model, families, lacking))


def _told_above(path: str, lacking: Mapping[str, Any], model: type[Section]) -> bool:
    """Whether the line of a table above, or those of tables beneath, say what lacks."""
    declaration = find(path, model)
    if path not in lacking or declaration is None:
        return False
    if not declaration.section:
        return path.rpartition(".")[0] in lacking
    beneath = [one for one in lacking if one.startswith(f"{path}.")]
    return bool(beneath) and not _values_of(path, lacking, model)


def _message(
    detail: Any,
    path: str,
    raw: Mapping[str, Any],
    model: type[Section],
    families: Families,
    lacking: Mapping[str, Any],
) -> str:
    context, kind = detail.get("ctx", {}), detail["type"]
    if kind == "extra_forbidden":
        return f"{shown(path)}{_found(raw, path)} is not a key here.{nearest(path, model, families)}"
    if kind in LACKING:
        why = f": {context['choice']} needs it" if kind == "needed" else ""
        return f"{shown(path)} is missing{why}; it is {_allowed(path, model)}{_with(path, lacking, model)}."
    if kind == "impossible":
        return f"{shown(path)}{_found(raw, path)} cannot be; it must be {_ended(context['allowed'])}"
    reason = f" {context['why']}" if kind == "quantity" else " is not allowed"
    return f"{shown(path)}{_found(raw, path)}{reason}; it must be {_allowed(path, model)}."


def _ended(words: str) -> str:
    """A sentence with its full stop."""
    return words if words.endswith("?") else f"{words}."


def _with(path: str, lacking: Mapping[str, Any], model: type[Section]) -> str:
    """Keys that a table which lacks must hold, and those that it must unless another one stands there."""
    by_reason: dict[str, list[str]] = {}
    for item in _values_of(path, lacking, model):
        reason = lacking[item.path].get("ctx", {}).get("choice", "")
        by_reason.setdefault(reason, []).append(f"{item.path.rpartition('.')[2]} ({item.brief})")
    words = [
        f"{f'{reason} needs' if reason else 'with'} {', '.join(by_reason[reason])}" for reason in by_reason
    ]
    return f"{'' if '' in by_reason else ';'} {'; '.join(words)}" if words else ""


def _values_of(table: str, lacking: Mapping[str, Any], model: type[Section]) -> list[Declaration]:
    """Keys of a table that lack, other tables left out."""
    return [item for item in _children(table, model) if item.path in lacking and not item.section]


def refused(raw: Mapping[str, Any], path: str, why: str) -> str:
    """Message for a key that belongs to another choice."""
    return f"{shown(path)}{_found(raw, path)} is not used: {why}."


def shown(path: str) -> str:
    """Write a dotted key as its place in the file, `[bearing.roller] diameter`."""
    section, _, name = path.rpartition(".")
    return f"[{excerpt(section)}] {excerpt(name)}" if section else excerpt(name)


def quoted(value: Any) -> str:
    """Write the beginning of a value as a case file would."""
    return excerpt(toml(value))


def _found(raw: Mapping[str, Any], path: str) -> str:
    value: Any = raw
    for part in path.split("."):
        if not isinstance(value, Mapping) or part not in value:
            return ""
        value = value[part]
    return "" if isinstance(value, Mapping) else f" = {quoted(value)}"


def _allowed(path: str, model: type[Section]) -> str:
    declaration = find(path, model)
    return declaration.allowed if declaration else "something else"


def nearest(path: str, model: type[Section], families: Families) -> str:
    """Suggest the key that was probably meant, else list the keys of that table."""
    if len(path) > LONGEST:  # no key is so long, and none is near to it
        return ""
    section, _, name = path.rpartition(".")
    if former := model.former.get(path):
        return f" {path} is now {former}."
    if hint := model.hints.get(path):
        return f" {hint}"
    if kinds := kinds_with(path, families):
        return f" It belongs to kind = {' or '.join(map(toml, kinds))}, which is the first key of a file."
    if meant := _meant(name, section, model):
        return f" Did you mean {' or '.join(meant)}?"
    if section and find(section, model) is None:
        return nearest(section, model, families)
    siblings = [_name(item.path) for item in _children(section, model)]
    if not siblings:
        return f" {section} has no keys beneath it."
    return f" Keys here: {', '.join(siblings)}."


def _meant(name: str, section: str, model: type[Section]) -> list[str]:
    """Keys that were probably meant: a like one here and those of that name, else a like one elsewhere."""
    from difflib import get_close_matches  # a case without fault does without

    here = get_close_matches(name, [_name(item.path) for item in _children(section, model)], n=1)
    places = [path for path in by_path(model) if _name(path) == name]
    beneath_first = sorted(places, key=lambda path: not path.startswith(f"{section}."))
    if meant := [*here, *map(shown, beneath_first[:MOST_PLACES])]:
        return meant
    elsewhere = {_name(path): path for path in by_path(model)}
    return [shown(elsewhere[like]) for like in get_close_matches(name, elsewhere, n=1, cutoff=0.8)]


def _name(path: str) -> str:
    return path.rpartition(".")[2]


def _children(section: str, model: type[Section]) -> list[Declaration]:
    if not section:
        return list(_direct(model, ""))
    parent = find(section, model)
    return list(_direct(parent.section, f"{section}.")) if parent and parent.section else []


def _direct(model: type[Section], prefix: str) -> list[Declaration]:
    return [Declaration(f"{prefix}{name}", field) for name, field in model.model_fields.items()]
