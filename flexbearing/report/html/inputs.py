"""Inputs of a case with units, each marked as given, chosen, assumed, fitted or default."""

import tomllib
from collections.abc import Iterator, Mapping
from typing import Any

from flexbearing.case.belonging import foreign
from flexbearing.case.declarations import Declaration, by_path, toml
from flexbearing.report.html import assumed_effects, assumptions
from flexbearing.report.html.document import Block, Cell, Items, Table
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed, units_in_words
from flexbearing.results import BadResult

SETTINGS = ("coupling.", "accuracy.", "outputs.")
UNSOURCED = "given, no source named"
CHOSEN = "chosen"
HEAD = ("title", "assumed", "calibrated", "kind")


def blocks(reader: Reader) -> Iterator[Block]:
    """Keys that the case gives, what fitted ones were fitted to, then the defaults."""
    keys = by_path(reader.result.family.case())
    texts = written(reader)
    unused = foreign(reader.attributes["case_si"], reader.result.family.case())
    given, defaults = [], []
    for path, value in flat(reader.attributes["case_si"]):
        if path.split(".")[0] not in HEAD and value is not None:
            text = next((texts[name] for name in _upwards(path) if name in texts), None)
            row, mark = row_of_key(reader, keys.get(path), path, value), origin(reader, path)
            if text is None and set(_upwards(path)) & set(unused):
                continue
            if text is None:
                defaults.append((*row[:3], "default" if mark.startswith(("given", CHOSEN)) else mark, row[3]))
            else:
                given.append((*row[:3], text, mark, row[3]))
    head = ("key", "value", "unit", "as given", "origin", "meaning")
    yield Table("What the case gives", head, tuple(given), _source(reader))
    yield from assumed_effects.blocks(reader)
    yield from assumptions.blocks(reader)
    if reader.attributes["calibrated"]:
        yield Items("Fitted, so no validation", fitted_inputs(reader))
    if defaults:
        caption = f"Defaults that this kind of case uses: {len(defaults)}"
        yield Table(caption, (*head[:3], *head[4:]), tuple(defaults), folded=True)


def _source(reader: Reader) -> str:
    """The first line of the case where it is a comment, which names the source of its numbers."""
    first = reader.result.attributes["case_text"].partition("\n")[0]
    begins = f"The case begins: {first.lstrip('# ')}. " if first.startswith("#") else ""
    return f"{begins.replace('..', '.')}What is given without a source is a choice of whoever wrote the case."


def fitted_inputs(reader: Reader) -> tuple[str, ...]:
    """Fitted inputs: value, what it was fitted to, and what the case says of its effect."""
    texts, said = written(reader), assumptions.comments(reader.result.attributes["case_text"])
    lines = []
    for key, words in reader.attributes["calibrated"].items():
        value = texts.get(key, "given as a table")
        effect = f". Effect: {said[key]}" if key in said else ""
        lines.append(units_in_words(f"{assumptions.named(key)} = {value}, fitted to {words}{effect}"))
    return tuple(lines)


def written(reader: Reader) -> dict[str, str]:
    """Keys of the case file and the settings on top of it, each as it was written.

    Raises
    ------
    BadResult
        where the stored case is no TOML
    """
    try:
        case = tomllib.loads(reader.result.attributes["case_text"])
    except tomllib.TOMLDecodeError as problem:
        raise BadResult(f"{reader.result.place}: the case in it is no TOML: {problem}") from problem
    texts = {path: toml(value).strip('"') for path, value in flat(case)}
    for setting in reader.attributes["case_overrides"]:
        path, _, value = setting.partition("=")
        texts[path.strip()] = value.strip()
    return texts


def flat(table: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Every value of nested tables by its dotted key."""
    for name, value in table.items():
        if isinstance(value, Mapping) and value:
            yield from flat(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", value


def origin(reader: Reader, path: str) -> str:
    """Whether a key is assumed, fitted, chosen or given, by its own mark or that of a table above it.

    A given one has the comment behind it, or behind the head of its table, such as "of the maker"; where that
    begins with "chosen", the key is what no catalogue has, such as load and speed. Keys of the solution
    method have no source: they are settings.
    """
    above = set(_upwards(path))
    if path.startswith(SETTINGS):
        return "setting"
    if above & set(reader.attributes["calibrated"]):
        return "fitted"
    if above & set(reader.attributes["assumed"]):
        return "assumed"
    behind = assumptions.behind(reader.result.attributes["case_text"])
    told = next((behind[name] for name in _upwards(path) if name in behind), "")
    set_since = any(each.partition("=")[0].strip() in above for each in reader.attributes["case_overrides"])
    if not told or set_since:
        return UNSOURCED
    return told.partition(",")[0] if told.startswith(CHOSEN) else f"given: {told}"


def _upwards(path: str) -> list[str]:
    """A key and the tables above it, the innermost first."""
    words = path.split(".")
    return [".".join(words[:count]) for count in range(len(words), 0, -1)]


def row_of_key(
    reader: Reader, declared: Declaration | None, path: str, value: Any, place: str = "case"
) -> tuple[Cell, ...]:
    """A key with its value in the units of the report, the unit, and its meaning."""
    meaning = declared.meaning if declared else ""
    kind = declared.kind if declared else None
    if kind is not None and isinstance(value, int | float):
        number = reader.units.of_key(value, kind.unit, f"{place}/{path}")
        return path, number, printed(number.unit), meaning
    if kind is not None and isinstance(value, list) and all(isinstance(each, int | float) for each in value):
        numbers = [reader.units.of_key(each, kind.unit, "") for each in value]
        texts = (f"{number.text} {printed(number.unit)}".strip() for number in numbers)
        return path, ", ".join(texts), "", meaning
    if isinstance(value, int | float) and not isinstance(value, bool):
        number = reader.units.number(value, "", "", ",.6g", f"{place}/{path}")
        return path, number, "", meaning
    return path, toml(value).strip('"'), "", meaning
