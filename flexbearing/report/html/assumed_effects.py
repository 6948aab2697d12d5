"""What other values of assumed or fitted inputs, and the ends of tolerances, make of a result."""

from collections.abc import Iterator
from math import log
from typing import Any

from flexbearing.outputs import Output, outputs
from flexbearing.quantities import SummaryValue
from flexbearing.quantities.effects import COMPARISON, INPUT, LIVES
from flexbearing.report.html import assumptions, stiffness
from flexbearing.report.html.assumptions import TOLERANCES, WORTH
from flexbearing.report.html.document import Block, Cell, Figure, Items, Number, Table, Words
from flexbearing.report.html.figures import BLUE
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import NOTHING, units_in_words, with_unit
from flexbearing.report.rows import unit_of

SMALLEST = 5e-3  # relative change that is drawn
_STIFFNESSES = {"total_stiffness": "stiffness", "total_stiffness_yy": "stiffness along y"}
_WIDE = 1.5  # ratio of the ends of an axis from which it is logarithmic
_TICKS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5, 7, 10, 20, 50, 100]
_TALL = 8  # keys that a figure of usual height has room for
_NOT_COMPUTED = "How much each of them matters was not computed. "
_COMPARED = (
    " Loads are given: their rows show how results follow the load, and no range of this page counts them."
)
_RATED = (
    " The given C_r stays in every row: more or longer rollers then have less capacity each, which can "
    "shorten the life."
)
_STRAIGHT = (
    " Slices do not see the stress at the ends of straight or flat rollers: a longer life by less drop is no "
    "reason to choose it."
)
_HOW = (
    "`flexbearing run {case} --set outputs.assumed_effects=true` solves the case again with other values "
    "of each, some two solutions for a key; a report of that result ranks them by their effect on the life."
)


def how(reader: Reader) -> Words:
    """That effects are missing, or of other inputs, and which command computes them."""
    stale = reader.attributes.get("effects_left_out")
    return Words(((f"{stale.capitalize()}. " if stale else _NOT_COMPUTED) + _how(reader),))


def _how(reader: Reader) -> str:
    return _HOW.format(case=reader.case_name)


def blocks(reader: Reader) -> Iterator[Block]:
    """A figure and a table, the largest effect first; which command computes them where they are missing."""
    found = reader.attributes.get("assumed_effects")
    if not found:
        if reader.attributes["assumed"] or reader.attributes["calibrated"] or _tolerances(reader):
            yield how(reader)
        return
    name, places = ranked_by(reader), ranked(reader)
    if any(_effect(found, place, name) >= SMALLEST for place in places):
        yield _drawn(reader, found, places, name)
    yield _table(reader, found, places, name)
    if missing := tuple(_missing(found)):
        yield Items("Other values that were not computed", missing)


def at_ends(reader: Reader) -> Iterator[Block]:
    """Results at both ends of the tolerances; which command computes them where they are missing."""
    if not _tolerances(reader):
        return
    found = reader.attributes.get("assumed_effects")
    if not found:
        words = "What the ends of the tolerances make of the results was not computed."
        yield Words((f"{words} {_how(reader)}",))
        return
    names = [
        name for name in found["of"]
        if base(reader, name) is not None and (name == ranked_by(reader) or name not in LIVES)
    ]  # fmt: skip
    rows = [
        (units_in_words(other["words"]), *(_ratio(reader, place, number, name) for name in names))
        for place, key in enumerate(found["keys"])
        if key["key"] == TOLERANCES
        for number, other in enumerate(key["others"])
        if other["values"]
    ]
    head = (
        "end of the tolerances",
        *(f"{_heading(reader, name).partition(' [')[0]} [factor]" for name in names),
    )
    yield Table("What the tolerances make of the results", head, tuple(rows))


def moving(reader: Reader) -> list[str]:
    """Keys that change the life by `WORTH` or more, the largest first, with its ratio to that of the case."""
    found, name = reader.attributes["assumed_effects"], ranked_by(reader)
    if name not in LIVES:
        return []
    lines: list[str] = []
    for place in (place for place in ranked(reader) if _effect(found, place, name) > log(WORTH)):
        key = found["keys"][place]
        compared = " (for comparison)" * (key.get("role") == COMPARISON)
        lines.append(f"{assumptions.named(key['key'])}{compared}: {_of_life(reader, key)}")
    return lines


def ranked(reader: Reader) -> list[int]:
    """Places of the keys among the effects, the largest effect first."""
    found, name = reader.attributes["assumed_effects"], ranked_by(reader)
    return sorted(range(len(found["keys"])), key=lambda place: -_effect(found, place, name))


def largest(reader: Reader, count: int) -> list[tuple[str, list[Number]]]:
    """Keys with the largest effects, no comparisons, each with results over that of the case, growing."""
    found, name = reader.attributes["assumed_effects"], ranked_by(reader)
    chosen = [
        place for place in ranked(reader)
        if found["keys"][place].get("role") != COMPARISON and _effect(found, place, name) > SMALLEST
    ]  # fmt: skip
    rows = []
    for place in chosen[:count]:
        others = range(len(found["keys"][place]["others"]))
        ratios = [ratio for number in others
                  if isinstance(ratio := _ratio(reader, place, number, name), Number)]  # fmt: skip
        rows.append((found["keys"][place]["key"], sorted(ratios, key=lambda ratio: ratio.size)))
    return rows


def of_life(reader: Reader, key: str) -> str:
    """Change of the life by other values of a key; empty where it is not known."""
    found = reader.attributes.get("assumed_effects") or {}
    known = [each for each in found.get("keys", ()) if each["key"] == key]
    return _of_life(reader, known[0]) if known and ranked_by(reader) in LIVES else ""


def _of_life(reader: Reader, key: dict[str, Any]) -> str:
    name = ranked_by(reader)
    base = reader.attributes["assumed_effects"]["of"][name]
    others = [
        f"{other['values'][name] / base:.3g} times with {units_in_words(other['words'])}"
        for other in key["others"] if other["values"].get(name) is not None
    ]  # fmt: skip
    return f"life {', '.join(others)}" if others else ""


def solved_again(reader: Reader, key: str, value: str) -> tuple[float, str] | None:
    """Life with another value of a key over that of the case, with its place; None where it is not known."""
    found = reader.attributes.get("assumed_effects")
    if not found:
        return None
    name = ranked_by(reader)
    for place, each in enumerate(found["keys"]):
        for number, other in enumerate(each["others"]):
            if each["key"] == key and other["words"] == value and name in other["values"]:
                of = f"ratio/attributes/{_at(place, number, name)}:attributes/assumed_effects/of/{name}"
                return other["values"][name] / found["of"][name], of
    return None


def keys(reader: Reader, role: str) -> list[str]:
    """Keys of a role whose effects were computed: "input", "choice" or "comparison"."""
    found = reader.attributes.get("assumed_effects") or {}
    return [
        each["key"] for each in found.get("keys", ())
        if each.get("role", INPUT) == role and any(other["values"] for other in each["others"])
    ]  # fmt: skip


def ranked_by(reader: Reader) -> str:
    """Name of the output that effects are ranked by: a life, else the first that there is."""
    of = reader.attributes["assumed_effects"]["of"]
    return next((name for name in (*LIVES, *of) if name in of), "")


def base(reader: Reader, name: str) -> float | None:
    """An output of the case, for ratios to it; None where it is not known or zero to the printed digit."""
    value = reader.attributes["assumed_effects"]["of"].get(name)
    return None if value is None or _output(reader, name).rounds_to_zero(value) else value


def of_zero(reader: Reader, name: str) -> str:
    """What other inputs make of an output that is zero, as a range of it; empty where it is not known."""
    found = reader.attributes.get("assumed_effects") or {}
    if name not in found.get("of", {}):
        return ""
    values = [
        (other["values"][name], key["key"])
        for key in found["keys"] if key.get("role") != COMPARISON
        for other in key["others"] if name in other["values"]
    ]  # fmt: skip
    if not values:
        return "zero to the printed digit; no other value could be computed"
    output, least, most = _output(reader, name), min(values), max(values)
    low, high = (format(value, output.declared.digits or ".4g") for value in (least[0], most[0]))
    low = low.lstrip("-") if output.rounds_to_zero(least[0]) else low
    if output.rounds_to_zero(least[0]) and output.rounds_to_zero(most[0]):
        return f"zero to the printed digit, {low} {output.unit}, with other values of every single input, too"
    most_by = assumptions.named(most[1])
    return f"{low} to {high} {output.unit} with other values of single inputs, most by {most_by}"


def _tolerances(reader: Reader) -> bool:
    return "ends" in ((reader.attributes.get("clearance") or {}).get("tolerances") or {})


def _effect(found: dict[str, Any], place: int, name: str) -> float:
    """Largest change of an output with other values of a key, as the size of its logarithm."""
    base = found["of"].get(name)
    values = (other["values"].get(name) for other in found["keys"][place]["others"])
    ratios = [value / base for value in values if base and value is not None]
    return max((abs(log(ratio)) for ratio in ratios if ratio > 0), default=0.0)


def _output(reader: Reader, name: str) -> Output:
    return next(output for output in outputs(reader.layout) if output.name == name)


def _heading(reader: Reader, name: str) -> str:
    """Label of an output with its unit, lives in millions of revolutions."""
    declared = _output(reader, name).declared
    part = name.partition(".")[2].split(".")[0]
    of_which = " with supports" if stiffness.supported(reader) else " of the bearing"
    text = _STIFFNESSES[name] + of_which if name in _STIFFNESSES else reader.label(declared).strip()
    label = ", ".join(filter(None, [text, part]))
    unit = reader.units.of(_unit(declared))
    return f"{label} [10⁶ revolutions]" if unit == "Mrev" else with_unit(label, unit)


def _cell(reader: Reader, name: str, path: str) -> Number:
    declared = _output(reader, name).declared
    stored = reader.layout[declared.of[0]].unit if declared.in_si else unit_of(declared).name
    digits = ",.4g" if name in LIVES or name in _STIFFNESSES else declared.digits or ".4g"
    return reader.of_attribute(path, stored, _unit(declared), digits)


def _unit(declared: SummaryValue) -> str:
    """Unit on the metric page."""
    unit = unit_of(declared).name
    return "kN/mm" if unit == "N/m" else unit


def _at(place: int, number: int, name: str) -> str:
    return f"assumed_effects/keys/{place}/others/{number}/values/{name}"


def _value(reader: Reader, place: int, number: int, name: str) -> Cell:
    other = reader.attributes["assumed_effects"]["keys"][place]["others"][number]
    return _cell(reader, name, _at(place, number, name)) if name in other["values"] else NOTHING


def _ratio(reader: Reader, place: int, number: int, name: str) -> Cell:
    """An output over that of the case."""
    found, of_case = reader.attributes["assumed_effects"], base(reader, name)
    value = found["keys"][place]["others"][number]["values"].get(name)
    if of_case is None or value is None:
        return NOTHING
    of = f"ratio/attributes/{_at(place, number, name)}:attributes/assumed_effects/of/{name}"
    return reader.units.number(value / of_case, "", "", ".3g", of)


def _table(reader: Reader, found: dict[str, Any], ranked: list[int], name: str) -> Table:
    """A row for each other value; the case itself in the first."""
    shown = [each for each in found["of"] if each == name or each not in LIVES]
    case = [_cell(reader, each, f"assumed_effects/of/{each}") for each in shown]
    rows: list[tuple[Cell, ...]] = [("this case", "", case[0], "", *case[1:], "")]
    for place in ranked:
        key = found["keys"][place]
        for number, other in enumerate(key["others"]):
            if other["values"]:
                first, *further = (_value(reader, place, number, each) for each in shown)
                ratio = _ratio(reader, place, number, name)
                words = units_in_words(other["words"])
                rows.append((key["key"], words, first, ratio, *further, units_in_words(key["source"])))
    label, *others = (_heading(reader, each) for each in shown)
    head = ("key", "with", label, "times", *others, "range from")
    life = label.partition(" [")[0]
    caption = f"With other values of assumed, fitted, toleranced or chosen inputs; by effect on the {life}"
    note = (
        "Each row is the case solved again with that one value; keys that belong to it change with it. A "
        "rule of thumb is a range of this program without a published source."
    )
    if (reader.attributes["case_si"].get("life") or {}).get("dynamic_rating"):
        note += _RATED
    if any("profile" in row[0] or "drop" in row[0] for row in rows if isinstance(row[0], str)):
        note += _STRAIGHT
    if keys(reader, COMPARISON):
        note += _COMPARED
    return Table(caption, head, tuple(rows), note)


def _drawn(reader: Reader, found: dict[str, Any], ranked: list[int], name: str) -> Figure:
    """Range of the output with other values of each key, over that of the case."""
    x: list[float | None] = []
    y: list[str | None] = []
    lines: list[str] = []
    base = found["of"][name]
    keys = [place for place in ranked if _effect(found, place, name) >= SMALLEST]
    for place in keys:
        key = found["keys"][place]
        label = ".".join(key["key"].split(".")[-2:])
        values = [(o["values"][name] / base, o["words"]) for o in key["others"] if name in o["values"]]
        for ratio, words in sorted([(1.0, "this case"), *values]):
            x.append(float(f"{ratio:.6g}"))
            y.append(label)
            lines.append(units_in_words(words))
        x.append(None)
        y.append(None)
        lines.append("")
    label = _heading(reader, name).partition(" [")[0]
    trace = {
        "type": "scatter", "mode": "lines+markers", "x": x, "y": y, "text": lines, "line": {"color": BLUE},
        "marker": {"size": 8}, "hovertemplate": "%{y}<br>%{text}: %{x} times<extra></extra>",
        "connectgaps": False,
    }  # fmt: skip
    ratios = [ratio for ratio in x if ratio is not None]
    axis = {"type": "log", "tickvals": _TICKS} if max(ratios) > _WIDE * min(ratios) else {}
    layout = {
        "xaxis": {"title": {"text": f"{label} over that of this case"}, **axis},
        "yaxis": {"autorange": "reversed", "type": "category"},
        "shapes": [{"type": "line", "xref": "x", "yref": "paper", "x0": 1, "x1": 1, "y0": 0, "y1": 1,
                    "line": {"color": "#4a535d", "width": 1, "dash": "dot"}}],
    }  # fmt: skip
    below = len(found["keys"]) - len(keys)
    rest = f" {below} keys change it by less than {100 * SMALLEST:g} % and are not drawn." if below else ""
    caption = (
        f"Change of the {label} with other values of assumed, fitted, toleranced or chosen inputs.{rest}"
    )
    return Figure("assumed-effects", caption, (trace,), layout, tall=len(keys) > _TALL)


def _missing(found: dict[str, Any]) -> Iterator[str]:
    """Keys, or other values of them, that have no result, and why."""
    for key in found["keys"]:
        if not key["others"] and key["source"].startswith("a text"):
            yield f"{key['key']}: {key['source']}"
        for other in key["others"]:
            if other["problem"]:
                yield f"{key['key']} = {other['words']}: {units_in_words(other['problem'])}"
