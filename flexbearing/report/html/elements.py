"""Rolling elements one by one, and their figures over the azimuth."""

from dataclasses import dataclass, replace

import numpy as np

from flexbearing.report.family_report import Elements
from flexbearing.report.figure import Figure
from flexbearing.report.html.document import Cell, Number, Table
from flexbearing.report.html.figures import along_rollers, around, same_map, shows_something
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import NOTHING, with_unit

_HEADINGS = {  # other than the name
    "roller_slip": "roller slip", "roller_tilt": "roller tilt", "cage_force": "pocket force",
    "roller_skew": "roller skew",
}  # fmt: skip


@dataclass(frozen=True)
class MostLoaded:
    """The rolling element with the largest load at the inner raceway, and how many carry load."""

    word: str  # "roller"
    number: int  # from 1
    count: int
    carrying: int
    load: Number
    azimuth: Number


def most_loaded(reader: Reader, block: str) -> MostLoaded | None:
    """The most loaded rolling element of an end state; None where the result has none."""
    shown, values = reader.result.family.report().elements, reader.blocks.get(block, {})
    if shown is None or not values:
        return None
    name = next(iter(shown.figures.values()))[0]
    symbols, loads = reader.layout[name].shape, np.asarray(values[name])
    races = [
        axis for axis, symbol in enumerate(symbols) if reader.layout.axis[symbol].entries[:1] == ("inner",)
    ]
    inner = loads[tuple(slice(1) if axis in races else slice(None) for axis in range(loads.ndim))]
    index = tuple(int(step) for step in np.unravel_index(np.argmax(inner), inner.shape))
    axis = symbols.index("Z")
    highest = inner.max(axis=tuple(other for other in range(inner.ndim) if other != axis))
    return MostLoaded(
        word=shown.word,
        number=index[axis] + 1,
        count=loads.shape[axis],
        carrying=reader.summary[block].get("loaded_rollers", int(np.count_nonzero(highest > 0))),
        load=reader.element(block, name, *index, digits=",.4g"),
        azimuth=reader.element(block, shown.azimuth, index[axis], digits=".1f"),
    )


def maps(reader: Reader, elements: Elements) -> list[Figure]:
    """Maps of what varies along the rollers, one of each that the eye can distinguish."""
    drawn: list[Figure] = []
    known = [name for name in elements.maps if name in reader.blocks.get(reader.last, {})]
    for name in known:
        if not same_map(reader, known[0], name):
            drawn.append(along_rollers(reader, name, *elements.maps[name], known))
    return drawn


def figures(reader: Reader, wanted: dict[str, tuple[str, ...]], azimuth: str) -> list[Figure]:
    """Figures over the azimuth that the result has and that show something."""
    if not reader.last or reader.blocks[reader.last][azimuth].size == 1:
        return []
    found = (around(reader, title, names, azimuth) for title, names in wanted.items())
    return [figure for figure in found if figure and shows_something(figure)]


def table(reader: Reader, elements: Elements) -> Table:
    """A row for each rolling element of the last end state."""
    block = reader.blocks[reader.last]
    columns = [(name, index) for name in elements.columns if name in block for index in _places(reader, name)]
    head = ["number"]
    for name, index in columns:
        unit = reader.units.of(reader.layout[name].unit_for_people.name)
        heading = _HEADINGS.get(name) or name.replace("_", " ")
        head.append(with_unit(" ".join([heading, *_words(reader, name, index)]), unit))
    digits = {name: _digits(reader, name) for name, _ in columns}
    rows: list[tuple[Cell, ...]] = []
    for number in range(block[elements.azimuth].size):
        cells = []
        for name, index in columns:
            cell = reader.element(reader.last, name, *_with(reader, name, index, number), digits=digits[name])
            unloaded = "film" in name and not cell.text.strip("0.")
            cells.append(replace(cell, text=NOTHING) if unloaded else cell)
        rows.append((str(number + 1), *cells))
    return Table(tuple(head), tuple(rows), sortable=True)


def _digits(reader: Reader, name: str) -> str:
    """Format of a column: as many decimals for all as the largest needs for four significant digits."""
    values = np.abs(reader.layout[name].for_people(reader.blocks[reader.last][name]))
    largest = values[np.isfinite(values)].max(initial=0.0)
    return f",.{max(0, 3 - int(np.floor(np.log10(largest)))) if largest else 0}f"


def _places(reader: Reader, name: str) -> list[tuple[int, ...]]:
    """Places on the axes beside that of the rolling elements."""
    shape, values = reader.layout[name].shape, reader.blocks[reader.last][name]
    return list(np.ndindex(*(values.shape[axis] for axis in range(values.ndim) if shape[axis] != "Z")))


def _with(reader: Reader, name: str, index: tuple[int, ...], number: int) -> tuple[int, ...]:
    """A place with the number of the rolling element at its axis."""
    axis = reader.layout[name].shape.index("Z")
    return (*index[:axis], number, *index[axis:])


def _words(reader: Reader, name: str, index: tuple[int, ...]) -> list[str]:
    others = [symbol for symbol in reader.layout[name].shape if symbol != "Z"]
    axes = [reader.layout.axis[symbol] for symbol in others]
    return [
        axis.entries[step] if axis.entries else f"{axis.name} {step + 1}"
        for axis, step in zip(axes, index, strict=True)
    ]
