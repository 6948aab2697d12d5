"""Figures of a result."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np

from flexbearing.quantities.reductions import RACES
from flexbearing.report.figure import (
    COLOURS,
    Axis,
    Figure,
    Line,
    Map,
    Rule,
    Values,
)
from flexbearing.report.html.reader import Reader, listed
from flexbearing.report.html.units import printed, with_unit

LOAD = "#a61c00"  # as in drawings
SHORT = 6  # lines that a legend names within a figure of usual height
MARKED = 60  # places of a line that are marked at most
SAME = 5e-3  # of the largest value: lines, or maps, that differ by less are drawn as one
DASHES = {"rigid": "dot", "flexible": "solid"}
AZIMUTH = Axis("azimuth [°]", ends=(-185, 185), step=60)


def around(reader: Reader, title: str, names: tuple[str, ...], azimuth: str) -> Figure | None:
    """Draw quantities of rolling elements over the azimuth."""
    lines = [
        _line(reader, block, name, index, azimuth, _label(name, words, alone=len(names) == 1))
        for block in reader.blocks
        for name in names
        if name in reader.blocks[block]
        for words, index in _lines(reader, block, name, reader.layout[azimuth].shape[0])
    ]
    if not lines:
        return None
    lines = _drawn_once(lines)
    groups = list(dict.fromkeys(line.group for line in lines))
    coloured = (replace(line, colour=COLOURS[groups.index(line.group) % len(COLOURS)]) for line in lines)
    unit = reader.units.of(reader.layout[names[0]].unit_for_people.name)
    name = f"around-{names[0]}".replace("_", "-")
    y = Axis(with_unit(title, unit), from_zero=unit != "deg")
    return Figure(name, title, AZIMUTH, y, (*coloured, *_load_mark(reader)), tall=len(lines) > SHORT)


def _drawn_once(lines: list[Line]) -> list[Line]:
    """Lines without those that coincide with an earlier one, which has the names of both.

    A line is left out only where it coincides in every end state, so that all end states have the same lines.
    """
    groups: dict[str, list[Line]] = {}
    for line in lines:
        groups.setdefault(line.group, []).append(line)
    kept: dict[str, list[Line]] = {}
    for name, group in groups.items():
        twin = next((other for other in kept if _alike(group, groups[other])), None)
        if twin is None:
            kept[name] = group
        else:
            both = _both(twin, name)
            kept[twin] = [replace(line, name=line.name.replace(twin, both, 1)) for line in kept[twin]]
    return [line for group in kept.values() for line in group]


def _alike(one: list[Line], other: list[Line]) -> bool:
    """Whether lines coincide in every end state."""
    if len(one) != len(other):
        return False
    pairs = [np.array([first.y, second.y], dtype=float) for first, second in zip(one, other, strict=True)]
    if any((np.isnan(first) != np.isnan(second)).any() for first, second in pairs):
        return False
    largest = max(np.nanmax(np.abs(pair), initial=0.0) for pair in pairs)
    difference = max(np.nanmax(np.abs(first - second), initial=0.0) for first, second in pairs)
    return bool(difference <= SAME * largest)


def _both(one: str, other: str) -> str:
    """Name of two lines: "inner and outer load", "contact load, inner and outer"."""
    first, second = one.split(" "), other.split(" ")
    if first[1:] == second[1:]:
        return " ".join([first[0], "and", second[0], *first[1:]])
    return f"{one} and {second[-1]}" if first[:-1] == second[:-1] else f"{one} and {other}"


def shows_something(figure: Figure) -> bool:
    """Whether a figure over the azimuth has different values."""
    return len({value for line in figure.lines for value in line.y}) > 1


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


def _load_mark(reader: Reader) -> tuple[Rule, ...]:
    """A line with a word at the azimuth of the load, across a figure."""
    azimuth = _load_azimuth(reader)
    return () if azimuth is None else (Rule(azimuth, "load", colour=LOAD, dash="dash", width=1.5),)


def _lines(reader: Reader, block: str, name: str, around: str) -> Iterator[tuple[str, tuple[Any, ...]]]:
    """Words and index of every line of an array along an axis, one of each row of balls."""
    shape, values = reader.layout[name].shape, reader.blocks[block][name]
    others = [axis for axis in range(values.ndim) if shape[axis] != around]
    for place, (row, part) in product(
        np.ndindex(*(values.shape[axis] for axis in others)), _rows(reader.blocks[block]).items()
    ):
        index: list[Any] = [part] * values.ndim
        for axis, step in zip(others, place, strict=True):
            index[axis] = step
        words = [
            RACES[step] if shape[axis] == "race" else f"diagonal {step + 1}"
            for axis, step in zip(others, place, strict=True)
            if shape[axis] == "race" or values.shape[axis] > 1
        ]
        yield ", ".join(filter(None, [*words, row])), tuple(index)


def _rows(block: Mapping[str, Any]) -> dict[str, slice]:
    """Places of each row of rolling elements, by its words; all of one row, without words."""
    rows = next((block[name] for name in ("ball_row", "roller_row") if name in block), None)
    if rows is None:
        return {"": slice(None)}
    counts = np.bincount(np.asarray(rows, int))
    ends = np.cumsum(counts)
    return {
        f"row {number}": slice(int(end - count), int(end))
        for number, (count, end) in enumerate(zip(counts, ends, strict=True), start=1)
    }


def _label(name: str, words: str, *, alone: bool) -> str:
    """Name of a line; without the quantity, where no other is drawn beside it."""
    return words if alone and words else ", ".join(filter(None, [name.replace("_", " "), words]))


def _line(reader: Reader, block: str, name: str, index: tuple[Any, ...], azimuth: str, label: str) -> Line:
    """One line, its places in order from -180 to 180 degrees."""
    values, unit, of = reader.drawn(block, name, index)
    row = index[reader.layout[name].shape.index(reader.layout[azimuth].shape[0])]
    degrees, order = closed(reader.blocks[block][azimuth][row])
    if "0 without load" in reader.layout[name].meaning:
        values = [value or None for value in values]
    if name == "contact_angle":  # without load it is that of no contact
        loads = reader.blocks[block]["contact_load"][index]
        values = [value if load > 0 else None for value, load in zip(values, loads, strict=True)]
    several = len(reader.blocks) > 1
    marked = "" if len(values) > MARKED else "circle" if block == "flexible" else "circle-open"
    return Line(
        degrees,
        [values[place] for place in order],
        f"{label}, {block}" if several else label,
        dash=DASHES[block] if several else "solid",
        mark=marked,
        group=label,
        places=tuple(place + (row.start or 0) for place in order),
        hover=f"%{{x:.1f}}°<br>%{{y}} {printed(unit)}<extra>{label}</extra>",
        of=of,
    )


def _in_order(azimuth: np.ndarray) -> tuple[list[float], list[int]]:
    """Azimuths in degrees from -180 to 180, and the places where they stand."""
    degrees = (np.degrees(azimuth) + 180 + 1e-9) % 360 - 180 - 1e-9
    order = np.argsort(degrees, kind="stable")
    return listed(degrees[order]), order.tolist()


def closed(azimuth: np.ndarray) -> tuple[Values, list[int]]:
    """The same with one place more beyond both ends, so that lines have no gap there."""
    degrees, order = _in_order(azimuth)
    if not np.isfinite(azimuth).all():
        return degrees, order
    return [degrees[-1] - 360, *degrees, degrees[0] + 360], [order[-1], *order, order[0]]


def along_rollers(reader: Reader, name: str, title: str, people: str, alike: list[str]) -> Figure:
    """Draw a quantity of every slice of every roller as a map, on one scale with others of its unit."""
    block = reader.last
    values, unit, of = reader.drawn(block, name, people=people)
    along, length, _ = reader.drawn(block, "slice_position")
    degrees, order = _in_order(reader.blocks[block]["roller_azimuth"])
    together = [reader.drawn(block, each, people=people)[0] for each in alike]
    largest = max(
        (value for each in together for row in each for value in row if value is not None), default=0
    )
    drawn = Map(
        degrees,
        along,
        [[values[place][slice_] for place in order] for slice_ in range(len(along))],
        printed(unit),
        (0.0, largest),
        places=tuple(order),
        hover=f"%{{x:.1f}}°, %{{y}} {printed(length)}<br>%{{z}} {printed(unit)}<extra></extra>",
        of=of,
    )
    up = "+x" if reader.result.kind == "cylindrical_roller" else "large or outer end"
    y = Axis(with_unit(f"along the roller, {up} up", length))
    return Figure(f"map-{name}".replace("_", "-"), title, AZIMUTH, y, (drawn, *_load_mark(reader)))


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
    histories = {name: reader.result.history(name) for name in labels}
    together = np.array([*histories.values()])
    known = together[np.isfinite(together) & (together > 0)]
    floor = 0.1 * float(known.min()) if known.size else 1e-16  # for zeros, a decade below all others
    items: list[Line | Rule] = []
    for (name, sizes), colour in zip(histories.items(), COLOURS, strict=False):
        numbers, y = list(range(1, sizes.size + 1)), listed(np.where(sizes > 0, sizes, np.nan))
        items.append(
            Line(numbers, y, labels[name], colour, hover="iteration %{x}: %{y}<extra></extra>",
                 of=f"iterations/{name}")
        )  # fmt: skip
        if zeros := [number for number, size in zip(numbers, sizes, strict=True) if size == 0]:
            items.append(Line(zeros, [floor] * len(zeros), "exactly zero", colour, "", "circle-open", 8.0))
    lost = 1 + np.flatnonzero(~np.isfinite(together).all(axis=0))
    items += [Rule(float(at), name=f"not finite in iteration {at}", dash="dot") for at in lost]
    x = Axis("iteration", step=max(1, len(reader.result.iterations) // 10))
    # a logarithmic axis of nothing has no ends
    y = Axis("relative size", "log", None if known.size else (floor / 10, 10 * floor), decades=True)
    return Figure("convergence", "convergence", x, y, tuple(items))


def deviations(reader: Reader) -> Figure | None:
    """Draw the deviation of both raceways at mid-roller, with its range; none where no ring is flexible."""
    block = reader.blocks.get("flexible", {})
    names = {f"{race}_deviation": f"{race} raceway" for race in RACES}
    known = [name for name in names if name in block]
    if not known:
        return None
    degrees, order = closed(block["roller_azimuth"])
    lines = []
    for name, colour in zip(known, COLOURS, strict=False):
        values, unit, of = reader.drawn("flexible", name)
        rows = np.array(values, dtype=float)[order]
        middle = [np.interp(0.0, block["slice_position"], row) for row in rows]
        hover = f"%{{x:.1f}}°<br>%{{y}} {printed(unit)}<extra>{names[name]}</extra>"
        lines.append(Line(degrees, listed(np.array(middle)), names[name], colour, hover=hover, of=of))
        for end in (rows.min(axis=1), rows.max(axis=1)):
            lines.append(Line(degrees, listed(end), "", colour, "dot", "", width=0.8))
    y = Axis(with_unit("deviation, positive outward", reader.units.of("um")))
    title = "deviation from circles at mid-roller; dotted: range along the roller"
    return Figure("deformed", title, AZIMUTH, y, (*lines, Rule(0.0, level=True), *_load_mark(reader)))
