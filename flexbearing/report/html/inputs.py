"""Inputs of a case with units, each marked as given, assumed, fitted, default or setting."""

import re
from collections.abc import Iterator
from textwrap import shorten
from typing import Any

from flexbearing.case.belonging import foreign
from flexbearing.case.declarations import Declaration, by_path, toml
from flexbearing.report.html import ratings
from flexbearing.report.html.document import Cell, Table
from flexbearing.report.html.reader import Reader, flat
from flexbearing.report.html.units import printed, units_in_words

SETTINGS = ("coupling.", "accuracy.", "outputs.")
HEAD = ("title", "assumed", "calibrated", "kind", "report")
DATA = {  # keys of the data block on the first page, with their words
    "bearing.rollers": "rollers", "bearing.balls": "balls", "bearing.roller.diameter": "roller diameter",
    "bearing.roller.length": "roller length", "bearing.ball.diameter": "ball diameter",
    "bearing.pitch_diameter": "pitch diameter", "bearing.outer_raceway_diameter": "outer raceway diameter",
    "bearing.contact_angle": "contact angle", "bearing.fits.bore": "bore", "inner.bore": "bore",
    "bearing.fits.outer_diameter": "outside diameter", "bearing.clearance_class": "clearance class",
    "bearing.fits.shaft": "shaft fit", "bearing.fits.shaft_interference": "interference on the shaft",
    "bearing.fits.housing.tolerance_class": "housing fit",
    "bearing.fits.housing.interference": "interference in the housing",
    "operation.radial_load": "radial load", "operation.axial_load": "axial load",
    "operation.moment": "moment",
    "operation.load.axial": "axial load", "operation.load.radial_y": "radial load along y",
    "operation.load.radial_z": "radial load along z", "operation.load.moment_y": "moment about y",
    "operation.load.moment_z": "moment about z", "operation.preload.force": "preload",
    "operation.speed": "speed", "operation.inner_speed": "speed of the inner ring",
    "operation.outer_speed": "speed of the outer ring", "lubricant.oil": "oil",
    "lubricant.inlet_temperature": "oil temperature", "operation.temperatures.shaft": "shaft temperature",
    "operation.temperatures.inner_ring": "inner ring temperature",
    "operation.temperatures.outer_ring": "outer ring temperature",
    "operation.temperatures.housing": "housing temperature",
}  # fmt: skip
_FIRST_WORDS = re.compile(r"[^;:(]{3,60}?(?=[;:(,]| that | which |$)")  # of a meaning


def data(reader: Reader) -> Table:
    """The data block of the first page: bearing, ratings with their source, fits, load, speed, oil."""
    known = dict(flat(reader.attributes["case_si"]))
    declared = by_path(reader.result.family.case())
    rows: list[tuple[Cell, ...]] = [("kind", reader.attributes["kind"].replace("_", " "), "", "given")]
    rated = ratings.rows(reader)
    for path, words in DATA.items():
        if path.startswith("operation.") and rated:
            rows, rated = [*rows, *rated], []
        if (value := known.get(path)) not in (None, 0.0) and _stands_first(reader, path):
            _, number, unit, _ = row_of_key(reader, declared.get(path), path, value)
            rows.append((words, number, unit, origin(reader, path) if path in reader.written else "default"))
    return Table(("data", "value", "unit", "origin"), tuple(rows + rated))


def _stands_first(reader: Reader, path: str) -> bool:
    """Whether the value of a key in the data block is in it: what is written, and speeds in any case."""
    return path in reader.written or path.endswith("speed")


def tables(reader: Reader) -> tuple[Table, Table]:
    """Further keys that the case gives, and its defaults."""
    family, si = reader.result.family, reader.attributes["case_si"]
    keys, unused, texts = by_path(family.case()), foreign(si, family.case()), reader.written
    rated = ratings.found(reader)
    shown = {*DATA, *(ratings.KEYS.values() if not isinstance(rated, str) else ())}
    given: list[tuple[Cell, ...]] = []
    defaults: list[tuple[Cell, ...]] = []
    for path, value in flat(si):
        written = any(name in texts for name in _upwards(path))
        if (
            path.split(".")[0] in HEAD
            or value is None
            or (path in shown and (written or (value and _stands_first(reader, path))))
        ):
            continue
        if not written and set(_upwards(path)) & set(unused):
            continue
        key, number, unit, meaning = row_of_key(reader, keys.get(path), path, value)
        mark = origin(reader, path)
        if written:
            given.append((key, "kind" if key.endswith("kind") else _short(meaning), number, unit, mark))
        else:
            defaults.append((key, number, unit, "default" if mark == "given" else mark, meaning))
    return (
        Table(("key", "meaning", "value", "unit", "origin"), tuple(given)),
        Table(("key", "value", "unit", "origin", "meaning"), tuple(defaults)),
    )


def _short(meaning: str) -> str:
    """The first words of a meaning, as the reference has it whole."""
    found = _FIRST_WORDS.match(meaning)
    return found[0].strip() if found else shorten(meaning, 60, placeholder=" ...")


def fitted(reader: Reader) -> list[tuple[str, str]]:
    """Fitted keys, each with what it was fitted to."""
    return [(key, units_in_words(words)) for key, words in reader.attributes["calibrated"].items()]


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


def _upwards(path: str) -> Iterator[str]:
    """A key and the tables above it, the innermost first."""
    words = path.split(".")
    return (".".join(words[:count]) for count in range(len(words), 0, -1))


def row_of_key(
    reader: Reader, declared: Declaration | None, path: str, value: Any, place: str = "case"
) -> tuple[str, Cell, str, str]:
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
        return path, reader.units.number(value, "", "", ",.6g", f"{place}/{path}"), "", meaning
    return path, toml(value).strip('"'), "", meaning
