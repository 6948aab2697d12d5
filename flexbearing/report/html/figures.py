"""Figures of a result, as Plotly draws them."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from flexbearing.quantities.reductions import RACES
from flexbearing.report.html.document import Figure
from flexbearing.report.html.reader import Reader, listed
from flexbearing.report.html.units import printed, with_unit

BLUE, ORANGE, GREEN, PURPLE = "#0072B2", "#D55E00", "#007a5a", "#8a3f7c"
LOAD = "#a61c00"  # as in drawings
COLOURS = (BLUE, ORANGE, GREEN, PURPLE)
SHORT = 6  # lines that a legend names within a figure of usual height
MARKED = 60  # places of a line that are marked at most
SAME = 5e-3  # of the largest value: lines, or maps, that differ by less are drawn as one
DASHES = {"rigid": "dot", "flexible": "solid"}


def around(reader: Reader, title: str, names: tuple[str, ...], azimuth: str) -> Figure | None:
    """Draw quantities of rolling elements over the azimuth."""
    traces = [
        _line(reader, block, name, index, words, azimuth)
        for block in reader.blocks
        for name in names
        if name in reader.blocks[block]
        for words, index in _lines(reader, block, name, reader.layout[azimuth].shape[0])
    ]
    if not traces:
        return None
    traces = _drawn_once(traces)
    for number, name in enumerate(dict.fromkeys(trace["legendgroup"] for trace in traces)):
        for trace in traces:
            if trace["legendgroup"] == name:
                trace["line"]["color"] = trace["marker"]["color"] = COLOURS[number % len(COLOURS)]
    unit = reader.units.of(reader.layout[names[0]].unit_for_people.name)
    layout = {
        "xaxis": {"title": {"text": "azimuth [°]"}, "dtick": 60, "range": [-185, 185]},
        "yaxis": {"title": {"text": with_unit(title, unit)}, "rangemode": "tozero"},
        **_load_mark(reader),
    }
    name = f"around-{names[0]}".replace("_", "-")
    return Figure(name, title, tuple(traces), layout, tall=len(traces) > SHORT)


def _drawn_once(traces: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Traces without those that coincide with an earlier one, which has the names of both.

    A line is left out only where it coincides in every end state, so that all end states have the same lines.
    """
    groups: dict[str, list[dict[str, Any]]] = {}
    for trace in traces:
        groups.setdefault(trace["legendgroup"], []).append(trace)
    kept: dict[str, list[dict[str, Any]]] = {}
    for name, group in groups.items():
        twin = next((other for other in kept if _alike(group, groups[other])), None)
        if twin is None:
            kept[name] = group
            continue
        for trace in kept[twin]:
            trace["name"] = trace["name"].replace(twin, _both(twin, name), 1)
    return [trace for group in kept.values() for trace in group]


def _alike(one: list[dict[str, Any]], other: list[dict[str, Any]]) -> bool:
    """Whether lines coincide in every end state."""
    if len(one) != len(other):
        return False
    pairs = [
        np.array([first["y"], second["y"]], dtype=float) for first, second in zip(one, other, strict=True)
    ]
    if any((np.isnan(first) != np.isnan(second)).any() for first, second in pairs):
        return False
    largest = max(np.nanmax(np.abs(pair), initial=0.0) for pair in pairs)
    difference = max(np.nanmax(np.abs(first - second), initial=0.0) for first, second in pairs)
    return bool(difference < SAME * largest)


def _both(one: str, other: str) -> str:
    """Name of two lines: "inner and outer load", "contact load, inner and outer"."""
    first, second = one.split(" "), other.split(" ")
    if first[1:] == second[1:]:
        return " ".join([first[0], "and", second[0], *first[1:]])
    return f"{one} and {second[-1]}" if first[:-1] == second[:-1] else f"{one} and {other}"


def shows_something(figure: Figure) -> bool:
    """Whether a figure over the azimuth has different values."""
    return len({value for trace in figure.traces for value in trace["y"]}) > 1


def _load_azimuth(reader: Reader) -> float | None:
    """Direction of the radial load [deg], from -180 to 180; none where the result does not state one."""
    direction = reader.blocks.get(reader.last, {}).get("load_direction")
    if direction is None:  # of a ball bearing, whose case gives the components of its load
        load = reader.attributes["case_si"]["operation"].get("load") or {}
        across, along = ((load.get(name) or 0.0) for name in ("radial_y", "radial_z"))
        direction = np.arctan2(across, along) if across or along else np.nan
    if not np.isfinite(direction):
        return None
    return float((np.degrees(direction) + 180) % 360 - 180)


def _load_mark(reader: Reader) -> dict[str, Any]:
    """A line with a word at the azimuth of the load, across a figure."""
    azimuth = _load_azimuth(reader)
    if azimuth is None:
        return {}
    line = {"color": LOAD, "dash": "dash", "width": 1.5}
    shape = {"type": "line", "xref": "x", "yref": "paper", "x0": azimuth, "x1": azimuth, "y0": 0, "y1": 1}
    word = {"x": azimuth, "y": 0.01, "xref": "x", "yref": "paper", "xanchor": "left", "yanchor": "bottom"}
    paper = {"text": "load", "showarrow": False, "font": {"color": LOAD}, "bgcolor": "rgba(255,255,255,0.75)"}
    return {"shapes": [shape | {"line": line}], "annotations": [word | paper]}


def _lines(reader: Reader, block: str, name: str, around: str) -> Iterator[tuple[str, tuple[Any, ...]]]:
    """Words and index of every line of an array along an axis."""
    shape, values = reader.layout[name].shape, reader.blocks[block][name]
    others = [axis for axis in range(values.ndim) if shape[axis] != around]
    for place in np.ndindex(*(values.shape[axis] for axis in others)):
        index: list[Any] = [slice(None)] * values.ndim
        for axis, step in zip(others, place, strict=True):
            index[axis] = step
        words = [
            RACES[step] if shape[axis] == "race" else f"diagonal {step + 1}"
            for axis, step in zip(others, place, strict=True)
            if shape[axis] == "race" or values.shape[axis] > 1
        ]
        yield ", ".join(words), tuple(index)


def _line(
    reader: Reader, block: str, name: str, index: tuple[Any, ...], words: str, azimuth: str
) -> dict[str, Any]:
    """Trace of one line, its places in order from -180 to 180 degrees."""
    values, unit, of = reader.drawn(block, name, index)
    degrees = (np.degrees(reader.blocks[block][azimuth]) + 180 + 1e-9) % 360 - 180 - 1e-9
    order = np.argsort(degrees, kind="stable")
    if "0 without load" in reader.layout[name].meaning:
        values = [value or None for value in values]
    label = ", ".join(filter(None, [name.replace("_", " "), words]))
    return {
        "type": "scatter",
        "mode": "lines+markers" if len(values) <= MARKED else "lines",
        "name": f"{label}, {block}" if len(reader.blocks) > 1 else label,
        "legendgroup": label,
        "x": listed(degrees[order]),
        "y": [values[place] for place in order],
        "customdata": [int(place) for place in order],
        "line": {"dash": DASHES[block] if len(reader.blocks) > 1 else "solid", "width": 1.5},
        "marker": {"size": 5, "symbol": "circle" if block == "flexible" else "circle-open"},
        "hovertemplate": f"%{{x:.1f}}°<br>%{{y}} {printed(unit)}<extra>{label}</extra>",
        "meta": of,
    }


def along_rollers(reader: Reader, name: str, title: str, people: str, alike: list[str]) -> Figure:
    """Draw a quantity of every slice of every roller as a map, on one scale with others of its unit."""
    block = reader.last
    values, unit, of = reader.drawn(block, name, people=people)
    along, length, _ = reader.drawn(block, "slice_position")
    degrees = (np.degrees(reader.blocks[block]["roller_azimuth"]) + 180 + 1e-9) % 360 - 180 - 1e-9
    order = np.argsort(degrees, kind="stable")
    together = [reader.drawn(block, each, people=people)[0] for each in alike]
    largest = max(
        (value for each in together for row in each for value in row if value is not None), default=0.0
    )
    trace = {
        "type": "heatmap",
        "zmin": 0.0,
        "zmax": largest,
        "x": listed(degrees[order]),
        "y": along,
        "z": [[values[place][slice_] for place in order] for slice_ in range(len(along))],
        "customdata": [int(place) for place in order],
        "colorscale": "Viridis",
        "colorbar": {
            "title": {"text": printed(unit), "side": "right"},
            "orientation": "h",
            "y": 1.0,
            "yanchor": "bottom",
            "thickness": 12,
        },
        "hovertemplate": f"%{{x:.1f}}°, %{{y}} {printed(length)}<br>%{{z}} {printed(unit)}<extra></extra>",
        "meta": of,
    }
    layout = {
        "xaxis": {"title": {"text": "azimuth [°]"}, "dtick": 60, "range": [-185, 185]},
        "yaxis": {"title": {"text": with_unit("along the roller, +x up", length)}},
        **_load_mark(reader),
    }
    return Figure(f"map-{name}".replace("_", "-"), title, (trace,), layout)


def same_map(reader: Reader, one: str, other: str) -> bool:
    """Whether two maps look the same."""
    block = reader.blocks[reader.last]
    difference, largest = np.abs(block[one] - block[other]).max(), np.abs(block[one]).max()
    return one != other and bool(difference < SAME * largest)


def convergence(reader: Reader) -> Figure | None:
    """Draw load change and residual of every iteration; none where nothing was iterated."""
    if not reader.result.iterations:
        return None
    labels = {
        "load_change": "largest change of a load / largest load",
        "residual": "largest unbalanced force / applied load",
    }
    traces = []
    for (name, label), colour in zip(labels.items(), COLOURS, strict=False):
        sizes = reader.result.history(name)
        traces.append({
            "type": "scatter", "mode": "lines+markers", "name": label,
            "x": list(range(1, sizes.size + 1)), "y": listed(np.where(sizes > 0, sizes, np.nan)),
            "line": {"color": colour}, "hovertemplate": "iteration %{x}: %{y}<extra></extra>",
            "meta": f"iterations/{name}",
        })  # fmt: skip
    layout = {
        "xaxis": {"title": {"text": "iteration"}, "dtick": max(1, len(reader.result.iterations) // 10)},
        "yaxis": {"title": {"text": "relative size"}, "type": "log", "exponentformat": "power"},
    }
    return Figure("convergence", "convergence", tuple(traces), layout)


def deformed(reader: Reader) -> Figure | None:
    """Draw both raceways as circles with their deviation magnified; none where no ring is flexible."""
    block = reader.blocks.get("flexible", {})
    deviations = ("inner_deviation", "outer_deviation")
    names = [name for name in deviations if name in block and 0 < np.abs(block[name]).max() < np.inf]
    if not names or "balance_radii" not in block:
        return None
    azimuth = block["roller_azimuth"]
    middle = {name: _at_mid_roller(block[name], block["slice_position"]) for name in names}
    largest = max(np.abs(values).max() for values in middle.values())
    magnification = float(f"{0.12 * block['balance_radii'][1] / largest:.1g}")
    traces = []
    for name, colour in zip(names, COLOURS, strict=False):
        radius = float(block["balance_radii"][0 if name.startswith("inner") else 2])
        scale = 1 / _of_metres(reader)
        for words, values, dash in (("undeformed", 0 * azimuth, "dot"), ("deformed", middle[name], "solid")):
            size = (radius + magnification * values) / scale
            closed = np.append(np.arange(azimuth.size), 0)
            traces.append({
                "type": "scatter", "mode": "lines" if dash == "dot" else "lines+markers",
                "name": f"{name.split('_')[0]} raceway, {words}",
                "x": listed((size * np.sin(azimuth))[closed]), "y": listed((size * np.cos(azimuth))[closed]),
                "line": {"color": colour, "dash": dash, "width": 1.4}, "marker": {"size": 4},
                "text": [_place(reader, azimuth[each], values[each]) for each in closed],
                "hovertemplate": "%{text}<extra></extra>",
            })  # fmt: skip
    unit = printed(reader.units.of("mm"))
    layout = {
        "xaxis": {"title": {"text": f"y [{unit}]"}, "zeroline": False},
        "yaxis": {
            "title": {"text": f"z, azimuth 0 down [{unit}]"},
            "scaleanchor": "x",
            "autorange": "reversed",
            "zeroline": False,
        },
        "annotations": _load_arrow(reader, float(block["balance_radii"][0]) * _of_metres(reader)),
    }
    title = f"deviation from circles at mid-roller, magnified {magnification:,.0f} times"
    return Figure("deformed", title, tuple(traces), layout)


def _load_arrow(reader: Reader, radius: float) -> list[dict[str, Any]]:
    """Arrow of the load on the inner ring from the axis of the bearing, within a radius."""
    degrees = _load_azimuth(reader)
    if degrees is None:
        return []
    across, down = np.sin(np.radians(degrees)), np.cos(np.radians(degrees))
    tip = {
        "x": 0.75 * radius * across,
        "y": 0.75 * radius * down,
        "axref": "x",
        "ayref": "y",
        "ax": 0,
        "ay": 0,
    }
    style = {"text": "load", "font": {"color": LOAD}, "arrowcolor": LOAD, "arrowwidth": 2, "arrowhead": 2}
    return [tip | style | {"showarrow": True}]


def _at_mid_roller(values: np.ndarray, along: np.ndarray) -> np.ndarray:
    return np.array([np.interp(0.0, along, row) for row in values])


def _of_metres(reader: Reader) -> float:
    """Lengths of the page in a metre."""
    return reader.units.value(1.0, "m", "mm")


def _place(reader: Reader, azimuth: Any, value: Any) -> str:
    """What is reported at a point of a deformed raceway."""
    number = reader.units.number(float(value), "m", "um", ".2f", "")
    return f"{np.degrees(azimuth):.1f}°: {number.text} {printed(number.unit)}"
