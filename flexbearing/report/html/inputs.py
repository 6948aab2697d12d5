"""Inputs of a case with units, each marked as given, chosen, assumed, fitted or default."""

from collections.abc import Iterator
from typing import Any

from flexbearing.case.belonging import foreign
from flexbearing.case.declarations import Declaration, by_path, toml
from flexbearing.report.html import assumed_effects, assumptions
from flexbearing.report.html.document import Block, Cell, Items, Table
from flexbearing.report.html.reader import Reader, flat
from flexbearing.report.html.units import printed, units_in_words

SETTINGS = ("coupling.", "accuracy.", "outputs.")
HEAD = ("title", "assumed", "calibrated", "kind")


def blocks(reader: Reader) -> Iterator[Block]:
    """Keys that the case gives, what fitted ones were fitted to, then the defaults."""
    keys = by_path(reader.result.family.case())
    texts = reader.written
    unused = foreign(reader.attributes["case_si"], reader.result.family.case())
    given, defaults = [], []
    for path, value in flat(reader.attributes["case_si"]):
        if path.split(".")[0] not in HEAD and value is not None:
            text = next((texts[name] for name in _upwards(path) if name in texts), None)
            row, mark = row_of_key(reader, keys.get(path), path, value), origin(reader, path)
            if text is None and set(_upwards(path)) & set(unused):
                continue
            if text is None:
                defaults.append((*row[:3], "default" if mark == "given" else mark, row[3]))
            else:
                given.append((*row[:3], text, mark, row[3]))
    head = ("key", "value", "unit", "as given", "origin", "meaning")
    yield Table("What the case gives", head, tuple(given))
    yield from assumed_effects.blocks(reader)
    if reader.attributes["calibrated"]:
        yield Items("Fitted, so no validation", fitted_inputs(reader))
    if defaults:
        caption = f"Defaults that this kind of case uses: {len(defaults)}"
        yield Table(caption, (*head[:3], *head[4:]), tuple(defaults), folded=True)


def fitted_inputs(reader: Reader) -> tuple[str, ...]:
    """Fitted inputs: value, and what it was fitted to."""
    return tuple(
        units_in_words(
            f"{assumptions.named(key)} = {reader.written.get(key, 'given as a table')}, fitted to {words}"
        )
        for key, words in reader.attributes["calibrated"].items()
    )


def origin(reader: Reader, path: str) -> str:
    """Whether a key is assumed, fitted or given, by its own mark or that of a table above it.

    Keys of the solution method are settings.
    """
    above = set(_upwards(path))
    if path.startswith(SETTINGS):
        return "setting"
    if above & set(reader.attributes["calibrated"]):
        return "fitted"
    return "assumed" if above & set(reader.attributes["assumed"]) else "given"


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
