"""How the outputs of a sampled study scatter, and which keys cause it, as a section of its report."""

import csv
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from io import StringIO
from math import isnan, nan
from pathlib import Path
from typing import Any

from flexbearing import inputs
from flexbearing.inputs import is_plain
from flexbearing.printable import printable
from flexbearing.report.figure import BLUE, LIGHT, ORANGE, PALE, Axis, Bars, Figure, Line, Rule, stairs
from flexbearing.report.html.document import Cell, Number, Table
from flexbearing.report.html.table import table_text
from flexbearing.report.html.units import NOTHING, Units, converted, with_unit
from flexbearing.results import BadResult

_P = ("P10", "P50", "P90")
COLUMNS = {  # of the tables, by their names behind that of the study
    "percentiles": {
        "output", "unit", "mean", "deviation", *_P, *(f"{p}_{end}" for p in _P for end in ("low", "high")),
        "linear_mean", "linear_deviation", *(f"linear_{p}" for p in _P), "linear_explains [%]",
        "linear_of", "rows", "unsolved",
    },
    "shares": {
        "output", "key", "first", "total", "points", "linear_share", "halved_P10", "halved_P90",
        "narrower [%]",
        "by",
        *(f"{index}_{end}" for index in ("first", "total") for end in ("low", "high")),
    },
    "histogram": {"output", "bin", "unit", "from", "to", "rows", "linear_rows"},
}  # fmt: skip
MOST_FIGURES = 12  # outputs with figures; the tables have all
SUBJECTS = "key", "bin"  # of which an output has a row each
LONGEST = 60  # characters of a name in a message
TEXTS = ("output", "unit", "key", "by", "linear_of")  # columns of texts
Row = Mapping[str, Any]


@dataclass(frozen=True)
class ScatterTables:
    """The tables of a scatter; each row holds its cells by their headings, NaN where one is empty."""

    outputs: Sequence[Row]
    shares: Sequence[Row]
    bins: Sequence[Row]


def read_scatter(place: Path) -> ScatterTables | None:
    """Read the scatter beside the table of a sampled study.

    Raises `BadResult` where a table has other columns or outputs than `flexbearing study` writes.
    """
    files = [place.with_name(f"{place.stem}_{part}{place.suffix}") for part in COLUMNS]
    if not all(map(is_plain, files)):
        return None
    found = ScatterTables(*(_read(file, names) for file, names in zip(files, COLUMNS.values(), strict=True)))
    known = {row["output"] for row in found.outputs}
    for rows in (found.shares, found.bins):
        if {row["output"] for row in rows} != known:
            raise BadResult(f"{place}: its tables of the scatter have other outputs than each other.")
    return found


def _read(file: Path, names: set[str]) -> list[Row]:
    """Rows of one of the tables; none of one that only says that nothing scatters."""
    try:
        reader = csv.DictReader(StringIO(table_text(file)), strict=True)
        inputs.require_different(reader.fieldnames or ())
        rows: dict[str, Row] = {}
        for row in reader:
            if set(row) != names:
                raise BadResult(f"{file}: has other columns than a table of a sampled study.")
            subject = " ".join(row[name] for name in ("output", *SUBJECTS) if name in row)
            if subject in rows:  # before a long table fills the memory
                raise inputs.Unreadable(f"has several rows of {subject[:LONGEST]!r}; one of them is enough")
            rows[subject] = {name: _cell(name, cell) for name, cell in row.items()}
        return [*rows.values()]
    except inputs.Unreadable as problem:
        raise BadResult(f"{file}: {problem}.") from problem
    except (ValueError, TypeError, csv.Error) as problem:
        raise BadResult(f"{file}: is no table of a sampled study: {problem}.") from problem


def _cell(name: str, text: str) -> Any:
    if name in TEXTS:
        return text
    return float(text) if text else nan


def scatter_parts(found: ScatterTables, units: Units) -> dict[str, Any]:
    """Parts of the report: which key to tighten, percentiles, causes, two figures for each output."""
    return {
        "tighten": _tighten(found),
        "percentiles": _percentiles(found, units),
        "causes": _causes(found, units),
        "figures": figures_of(found, units, MOST_FIGURES),
    }


def figures_of(found: ScatterTables, units: Units, most: int) -> list[Figure]:
    """Histogram and shares of the keys of each of the first outputs."""
    figures: list[Figure] = []
    for number, output in enumerate(found.outputs[:most]):
        bins, shares = (
            [row for row in rows if row["output"] == output["output"]] for rows in (found.bins, found.shares)
        )
        figures += [
            _histogram(output, bins, units, f"scatter-{number}"),
            _shares(output, shares, f"shares-{number}"),
        ]
    return figures


def _tighten(found: ScatterTables) -> Table:
    """For each output the key to tighten first, and how much closer P10 and P90 come."""
    rows: list[tuple[Cell, ...]] = []
    for output in found.outputs:
        known = [(row, place) for place, row in enumerate(found.shares)
                 if row["output"] == output["output"] and not isnan(row["narrower [%]"])]  # fmt: skip
        if known:
            first, place = max(known, key=lambda each: each[0]["narrower [%]"])
            closer = _plain(first["narrower [%]"], "%", f"shares/{place}/narrower [%]")
            rows.append((_words(output), printable(first["key"]), closer))
    return Table(("output", "key", "P10 and P90 closer by [%]"), tuple(rows))


def _percentiles(found: ScatterTables, units: Units) -> Table:
    names = (
        "mean", "deviation", "P10_low", "P10", "P10_high", "P50_low", "P50", "P50_high", "P90_low", "P90",
        "P90_high", "linear_P10", "linear_P90",
    )  # fmt: skip
    rows = []
    for place, row in enumerate(found.outputs):
        unit = row["unit"]
        cells = [units.number(row[name], unit, unit, ",.5g", f"percentiles/{place}/{name}") for name in names]
        explained = _plain(row["linear_explains [%]"], "%", f"percentiles/{place}/linear_explains [%]")
        counts = [_plain(row[name], "", f"percentiles/{place}/{name}") for name in ("rows", "unsolved")]
        rows.append((with_unit(_words(row), units.of(unit)), *cells, explained, *counts))
    head = (
        "output",
        *(name.replace("_", " ") for name in names),
        "linear explains [%]",
        "rows",
        "without a number",
    )
    return Table(head, tuple(rows))


def _causes(found: ScatterTables, units: Units) -> Table:
    plain = ("first_low", "first", "first_high", "total_low", "total", "total_high", "linear_share")
    unit_of = {row["output"]: row["unit"] for row in found.outputs}
    rows: list[tuple[Cell, ...]] = []
    for place, row in enumerate(found.shares):
        unit = unit_of[row["output"]]
        shares = [_plain(row[name], "", f"shares/{place}/{name}") for name in plain]
        halved = [
            units.number(row[name], unit, unit, ",.5g", f"shares/{place}/{name}")
            for name in ("halved_P10", "halved_P90")
        ]
        narrower = _plain(row["narrower [%]"], "%", f"shares/{place}/narrower [%]")
        rows.append((row["output"].replace("_", " "), row["key"], *shares, *halved, narrower, row["by"]))
    head = (
        "output", "key", *(name.replace("_", " ") for name in plain), "P10, half the scatter",
        "P90, half the scatter", "closer by [%]", "known by",
    )  # fmt: skip
    return Table(head, tuple(rows), sortable=True)


def _plain(value: float, unit: str, of: str) -> Number:
    return Number(NOTHING if isnan(value) else f"{value:.4g}", unit, of, unit)


def _histogram(output: Row, bins: Sequence[Row], units: Units, name: str) -> Figure:
    unit = output["unit"]
    shown = units.of(unit)
    centres = [_shown((row["from"] + row["to"]) / 2, unit, shown) for row in bins]
    width = _shown(bins[0]["to"], unit, shown) - _shown(bins[0]["from"], unit, shown)
    items: list[Bars | Line | Rule] = [
        Bars(centres, [row["rows"] for row in bins], "sampled", LIGHT, thickness=width,
             hover="%{x}: %{y} rows<extra></extra>")
    ]  # fmt: skip
    linear = [row["linear_rows"] for row in bins]
    if not any(map(isnan, linear)):
        edges = [_shown(edge, unit, shown) for edge in (bins[0]["from"], *(row["to"] for row in bins))]
        items.append(Line(*stairs(edges, linear), "linear", ORANGE, mark=""))
    items += [
        Rule(_shown(output[percent], unit, shown), dash=dash)
        for percent, dash in (("P10", "dot"), ("P50", "solid"), ("P90", "dot"))
    ]
    title, x = f"{_words(output)}; lines at P10, P50 and P90", Axis(with_unit(_words(output), shown))
    return Figure(name, title, x, Axis("rows"), tuple(items))


def _shares(output: Row, keys: Sequence[Row], name: str) -> Figure:
    sampled = not isnan(keys[0]["total"])
    by = "total" if sampled else "linear_share"
    ordered = sorted(keys, key=lambda row: 0.0 if isnan(row[by]) else row[by])
    names = [printable(row["key"]) for row in ordered]
    bars = (("total", "total index", PALE, 0.8), ("first", "first-order index", BLUE, 0.4)) if sampled else ()
    items: list[Bars | Line] = []
    for form, words, colour, thickness in bars:
        below = [100 * max(0.0, row[form] - row[f"{form}_low"]) for row in ordered]
        above = [100 * max(0.0, row[f"{form}_high"] - row[form]) for row in ordered]
        sizes = [100 * row[form] for row in ordered]
        items.append(Bars(sizes, names, words, colour, True, thickness, (below, above)))
    if not any(isnan(row["linear_share"]) for row in ordered):
        linear = [100 * row["linear_share"] for row in ordered]
        items.append(Line(linear, names, "linear, by derivatives", ORANGE, "", "diamond", 9.0))
    x, y = Axis("share of the variance [%]", from_zero=True), Axis(scale="category")
    return Figure(name, f"shares of the keys in the scatter of {_words(output)}", x, y, tuple(items))


def _shown(value: float, stored: str, shown: str) -> float:
    return float(f"{converted(value, stored, shown):.6g}")


def _words(output: Row) -> str:
    return printable(output["output"].replace("_", " "))
