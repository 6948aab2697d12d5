"""Inputs that no source gives, with what the case's own comments say of them."""

import re
from collections.abc import Iterator
from functools import cache
from math import log

from flexbearing.report.html.document import Block, Items
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import units_in_words

_TIMES = re.compile(r"(\d+(?:\.\d+)?) times with")
_MARKS = ("assumed: ", "calibrated: ", "tolerances: ")
TOLERANCES = "bearing.fits.at"  # stands for all classes of clearance and fits
_NAMES = {
    TOLERANCES: "tolerances of clearance and fits",
    "bearing.rollers": "number of rollers",
    "bearing.balls": "number of balls",
    "bearing.first_roller_azimuth": "azimuth of the first roller",
    "outer.bars": "number of bars",
    "operation.temperatures.reference": "reference temperature",
    "operation.tilt": "whether the shaft lets the inner ring tilt",
    "operation.misalignment": "misalignment of the inner ring",
    "operation.radial_load": "radial load",
    "operation.axial_load": "axial load",
    "life.edge_stress": "edge stress in the life",
    "life.capacity": "rule of the load capacity",
    "lubricant.inlet_temperature": "oil temperature at the inlets",
    "life.cleanliness": "cleanliness of the oil",
}
_TABLES = ("bearing", "outer", "inner", "lubricant", "operation")  # that a key is clear without
_OF_RINGS = {
    f"{race}.{size}" for race in ("inner", "outer") for size in ("width", "thickness", "bore", "kind")
}
_TABLE, _KEY = re.compile(r"\[([^\]\[]+)\]"), re.compile(r'"?([\w.-]+)"?\s*=')
_TITLE = "Assumed: the source does not give these inputs"
WORTH = 1.25  # change of a life by an assumed input that is told beside the life, as a factor
_RANKED = (
    " The largest effect on the life first, by the comments in the case file: a life in them is the modified "
    "life where the case has one, and of several values each changes this one input alone."
)


def blocks(reader: Reader) -> Iterator[Block]:
    """Every assumed key with its comment, that of the largest effect on life first."""
    assumed = reader.attributes["assumed"]
    if not assumed:
        return
    said = comments(reader.result.attributes["case_text"])
    if reader.attributes.get("assumed_effects"):  # computed, so not told with other values beside it
        said = {key: _reason(text) for key, text in said.items()}
    ranked = sorted(assumed, key=lambda key: -effect(said.get(key, "")))
    weighted = _RANKED if any(effect(text) for text in said.values()) else ""
    untold = "its effect is not known"
    lines = (f"{named(key)}: {units_in_words(said.get(key, untold))}" for key in ranked)
    yield Items(f"{_TITLE}.{weighted}", tuple(lines))


def _reason(comment: str) -> str:
    """A comment without the effects that it tells.

    >>> _reason("usual; life 1.08 times with a, 0.888 times with b; load unchanged with a; see Table 2")
    'usual; see Table 2'
    """
    return ";".join(part for part in comment.split(";") if not weighed(part)) or comment


def named(key: str) -> str:
    """A key behind its plain name.

    >>> named("bearing.roller.drop"), named("outer.bars")
    ('roller drop (bearing.roller.drop)', 'number of bars (outer.bars)')
    """
    return f"{name(key)} ({key})"


def name(key: str) -> str:
    """A key in plain words.

    >>> name("materials.inner_ring"), name("outer.width"), name("friction.coefficient")
    ('material of the inner ring', 'width of the outer ring', 'friction coefficient')
    """
    if key in _NAMES:
        return _NAMES[key]
    table, *rest = key.split(".")
    words = " ".join(rest[-2:]).replace("_", " ")
    if key.startswith("materials.") and len(rest) == 1:
        return f"material of the {words}"
    if key in _OF_RINGS:
        return f"{words} of the {table} ring"
    return words if table in _TABLES or len(rest) > 1 else f"{table} {words}"


def moving(reader: Reader) -> list[str]:
    """Keys whose comments tell a change of the life by `WORTH` or more, the largest first."""
    said = comments(reader.result.attributes["case_text"])
    known = {key: effect(text) for key, text in said.items() if effect(text) > log(WORTH)}
    ranked = sorted(known, key=lambda key: -known[key])
    return [units_in_words(f"{named(key)}{_mark(reader, key)}: life {changes(said[key])}") for key in ranked]


def _mark(reader: Reader, key: str) -> str:
    words = {"assumed": "assumed", "calibrated": "fitted"}
    return next((f", {word}" for mark, word in words.items() if key in reader.attributes[mark]), "")


def comments(text: str) -> dict[str, str]:
    r"""Comments on assumed, calibrated and toleranced keys, from the lines above a key or behind it.

    >>> comments('[a]\n# assumed: rule\n# of thumb\nb = 1\nc = 2  # assumed: usual')
    {'a.b': 'rule of thumb', 'a.c': 'usual'}
    """
    found: dict[str, str] = {}
    table, above = "", []
    for line in map(str.strip, text.splitlines()):
        if line.startswith("#"):
            above.append(line.lstrip("# "))
            continue
        if header := _TABLE.match(line):
            table = f"{header[1]}."
        elif key := _KEY.match(line):
            behind = line.rpartition("# ")[2] if "# " in line else ""
            words = " ".join(above) or behind
            if words.startswith(_MARKS):
                found[table + key[1]] = words.partition(": ")[2]
        above = []
    return found


def effect(comment: str, output: str = "life") -> float:
    """Largest change of an output that a comment tells, as the size of its logarithm.

    >>> effect("cage slip 9 times with a; life 7.41 times with a, 0.305 times with b") == log(7.41)
    True
    """
    return max((abs(log(ratio)) for ratio in ratios(comment, output)), default=0.0)


@cache
def behind(text: str) -> dict[str, str]:
    r"""Comments behind keys and behind the heads of tables.

    >>> behind('[a]  # Table 2\nb = 1  # E of the catalogue\nc = 2\n# above\nd = "#3"')
    {'a': 'Table 2', 'a.b': 'E of the catalogue'}
    """
    found: dict[str, str] = {}
    table = ""
    for line in map(str.strip, text.splitlines()):
        header, key = _TABLE.match(line), _KEY.match(line)
        if header:
            table = f"{header[1]}."
        if (header or key) and " # " in line:
            found[header[1] if header else f"{table}{key[1]}"] = line.rpartition(" # ")[2]  # type: ignore[index]
    return found


def weighed(comment: str) -> bool:
    """Whether a comment tells what other values do, be it nothing."""
    return bool(_TIMES.search(comment)) or "unchanged" in comment or "within" in comment


def ratios(comment: str, output: str = "life") -> list[float]:
    """An output with other values over that of the case, as a comment tells them.

    >>> ratios("usual; torque 1.08 times with a, 0.888 times with b; life 2 times with c", "torque")
    [1.08, 0.888]
    """
    return [float(value) for value in _TIMES.findall(changes(comment, output)) if float(value)]


def change(comment: str, output: str, value: str) -> float | None:
    """An output with another value over that of the case, as a comment tells it; None where it does not.

    >>> change('tolerances; life 1.93 times with "tightest", 0.598 times with "loosest"', "life", "loosest")
    0.598
    """
    found = re.search(rf'{_TIMES.pattern} "{re.escape(value)}"', changes(comment, output))
    return float(found[1]) if found else None


def changes(comment: str, output: str = "life") -> str:
    """What a comment tells of an output.

    >>> changes("rule of thumb; life 2 times with 3, 0.4 times with 1; torque 2 times with 3")
    '2 times with 3, 0.4 times with 1'
    >>> changes("bearing stiffness 2 times with 3; stiffness 1.1 times with 3", "stiffness")
    '1.1 times with 3'
    """
    return ", ".join(re.findall(rf"(?:^|; ?){output} ([^;]*)", comment))
