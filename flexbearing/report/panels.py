"""Figures as panels of one picture, drawn by Matplotlib."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.report.figure import BAND, Axis, Bars, Figure, Item, Line, Map, Rule, Values
from flexbearing.report.html.figures import convergence
from flexbearing.report.html.reader import Reader
from flexbearing.report.picture import NUMBERS, plain_grid, set_heading

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Page

_DASHES = {"solid": "-", "dash": "--", "dot": ":", "": "none"}
_MARKS = {"": "", "circle": "o", "circle-open": "o", "square": "s", "diamond": "D", "x": "x", "star": "*",
          "tick": "|"}  # fmt: skip
SMALL = 0.01  # numbers along an axis that have a power of ten
NARROW = 300.0  # ends of a logarithmic axis that has plain numbers, one over the other
LETTERS = 13  # of a title in an inch


def picture(
    title: str, what: str, figures: Sequence[Figure], columns: int = 1, size: tuple[float, float] = (7.0, 3.4)
) -> Page:
    """Draw figures beside and below each other, each in a panel of some width and height [inches]."""
    from matplotlib.figure import Figure as Page  # a second to load: only pictures pay for it

    rows = -(-len(figures) // columns)
    page = Page(figsize=(size[0] * columns, 1.0 + size[1] * rows), layout="constrained")
    alike = [_is_shared([getattr(figure, side) for figure in figures]) for side in "xy"]
    panels = page.subplots(rows, columns, sharex=alike[0], sharey=alike[1], squeeze=False)
    grid: list[Axes] = [*panels.ravel()]
    for number, (axes, figure) in enumerate(zip(grid, figures, strict=False)):
        _draw(axes, figure)
        if len(figures) > 1 and not _is_labelled(figure):
            axes.set_title(figure.title, fontsize=10, parse_math=False)
        lowest = not alike[0] or number + columns >= len(figures)
        axes.tick_params(labelbottom=lowest, labelleft=True)
        axes.xaxis.label.set_visible(lowest)
    for axes in grid[len(figures) :]:
        axes.remove()
    letters = round(LETTERS * size[0] * columns)
    set_heading(page, title, what, letters)
    _scales(page, grid, figures)
    _legends(page, grid[: len(figures)], letters)
    return page


def _is_shared(axes: Sequence[Axis]) -> bool:
    """Whether panels have one axis; categories are those of a panel alone."""
    return len({*axes}) == 1 and axes[0].scale != "category"


def convergence_picture(reader: Reader) -> Page | None:
    """Draw load change and residual of every iteration; none where nothing was iterated."""
    solved, ended = convergence(reader), reader.result.attributes
    what = f"Convergence ({ended.get('method')}): {ended['status']}"
    return picture(reader.attributes["title"], what, [solved]) if solved else None


def _scales(page: Page, grid: Sequence[Axes], figures: Sequence[Figure]) -> None:
    """A scale of colours for each map; one for those that share it."""
    shared: dict[tuple[str, object], list[Axes]] = {}
    for axes, figure in zip(grid, figures, strict=False):
        for drawn in figure.items:
            if isinstance(drawn, Map):
                shared.setdefault((drawn.label, drawn.ends or figure.title), []).append(axes)
    for (label, _), alike in shared.items():
        mesh = alike[0].collections[0]
        bar = page.colorbar(mesh, ax=alike, label=label)
        if bar.ax.get_yscale() != "log":
            bar.ax.yaxis.set_major_formatter(NUMBERS)


def _legends(page: Page, grid: Sequence[Axes], letters: int) -> None:
    """Names of what is drawn: below all panels where all have them, else in their panel."""
    named: list[dict[str, Any]] = []
    for handles, labels in (axes.get_legend_handles_labels() for axes in grid):
        named.append(dict(zip(labels, handles, strict=True)))
    shared = set[str].intersection(*(set(each) for each in named if each)) if any(named) else set()
    for axes, each in zip(grid, named, strict=True):
        if apart := {name: handle for name, handle in each.items() if name not in shared}:
            _legend(axes, apart, loc="best", fontsize=8, framealpha=0.7)
    each = {name: handle for all_of in named for name, handle in all_of.items() if name in shared}
    if each and (len(each) > 1 or any(axes.collections for axes in grid)):
        rows = -(-len(each) // max(1, letters // (8 + max(map(len, each)))))
        _legend(page, each, loc="outside lower center", ncols=-(-len(each) // rows), frameon=False)


def _legend(place: Axes | Page, named: dict[str, Any], **style: Any) -> None:
    for text in place.legend(named.values(), named.keys(), **style).get_texts():
        text.set_parse_math(False)


def _draw(axes: Axes, figure: Figure) -> None:
    plain_grid(axes)
    x, y = (_places(figure, side) for side in "xy")
    for item in figure.items:
        _draw_item(axes, item, (x, y))
    _shape(axes, "x", figure.x, x)
    _shape(axes, "y", figure.y, y)
    if figure.equal:
        axes.set_aspect("equal")


def _is_labelled(figure: Figure) -> bool:
    """Whether a label has the title."""
    labels = [figure.y.label, *(item.label for item in figure.items if isinstance(item, Map))]
    return any(label.startswith(figure.title) for label in labels)


def _places(figure: Figure, side: str) -> dict[str, int]:
    """Place of each category along an axis."""
    texts = (value for item in figure.items if isinstance(item, Line | Bars) for value in getattr(item, side)
             if isinstance(value, str))  # fmt: skip
    return {text: place for place, text in enumerate(dict.fromkeys(texts))}


def _numbers(values: Values, places: dict[str, int]) -> np.ndarray:
    return np.array([places[each] if isinstance(each, str) else each for each in values], dtype=float)


def _draw_item(axes: Axes, item: Item, places: tuple[dict[str, int], dict[str, int]]) -> None:
    if isinstance(item, Line):
        _draw_line(axes, item, *map(_numbers, (item.x, item.y), places))
    elif isinstance(item, Bars):
        _draw_bars(axes, item, *map(_numbers, (item.x, item.y), places))
    elif isinstance(item, Map):
        _draw_map(axes, item)
    else:
        _draw_rule(axes, item)


def _draw_line(axes: Axes, line: Line, x: np.ndarray, y: np.ndarray) -> None:
    axes.plot(
        x,
        y,
        linestyle=_DASHES[line.dash],
        linewidth=line.width,
        marker=_MARKS[line.mark],
        markersize=line.size,
        markerfacecolor="white" if line.mark.endswith("open") else line.colour,
        color=line.colour,
        label=line.name or None,
    )


def _draw_bars(axes: Axes, bars: Bars, x: np.ndarray, y: np.ndarray) -> None:
    style = {"color": bars.colour, "label": bars.name or None, "error_kw": {"elinewidth": 1}}
    if bars.level:
        axes.barh(y, x, height=bars.thickness, xerr=bars.errors, **style)
    else:
        axes.bar(x, y, width=bars.thickness, yerr=bars.errors, **style)


def _draw_map(axes: Axes, drawn: Map) -> None:
    from matplotlib.colors import LogNorm, Normalize

    values = np.ma.masked_invalid(np.array(drawn.z, dtype=float))
    norm = LogNorm() if drawn.logarithmic else Normalize(*(drawn.ends or (None, None)))
    axes.grid(visible=False)
    axes.pcolormesh(
        drawn.x, drawn.y, values, norm=norm, cmap=drawn.colours, shading="nearest", rasterized=True
    )
    for each in drawn.contours:
        lines = axes.contour(
            drawn.x, drawn.y, values, [each.value], colors=each.colour, linewidths=0.8 * each.width
        )
        axes.clabel(lines, fmt=lambda value: f"{value:g}", fontsize=8)


def _draw_rule(axes: Axes, rule: Rule) -> None:
    name, style = rule.name or None, {"color": rule.colour, "zorder": 0 if rule.level else 2}
    line = style | {"linestyle": _DASHES[rule.dash], "linewidth": rule.width, "label": name}
    if rule.to is not None:
        band = axes.axhspan if rule.level else axes.axvspan
        band(rule.at, rule.to, alpha=BAND, linewidth=0, label=name, **style)
    else:
        (axes.axhline if rule.level else axes.axvline)(rule.at, **line)
    if rule.word:
        below = {"xycoords": ("data", "axes fraction"), "textcoords": "offset points"}
        axes.annotate(rule.word, (rule.at, 0.0), (3, 3), color=rule.colour, parse_math=False, **below)


def _shape(axes: Axes, side: str, declared: Axis, places: dict[str, int]) -> None:
    """Label, scale, ends and ticks of an axis."""
    axis, (low, high) = getattr(axes, f"{side}axis"), getattr(axes.dataLim, f"interval{side}")
    axis.set_label_text(declared.label, parse_math=False)
    if declared.scale == "log":
        axes.set(**{f"{side}scale": "log"})
    _ticks(axis, declared, places, (low, high))
    if declared.from_zero and low >= 0:
        axes.set(**{f"{side}lim": (0, None)})
    if declared.ends:
        axes.set(**{f"{side}lim": declared.ends})
    if declared.falling:
        axis.set_inverted(True)


def _ticks(axis: Any, declared: Axis, places: dict[str, int], ends: tuple[float, float]) -> None:
    """Ticks of an axis: categories, those declared, or usual ones between the ends of what is drawn."""
    from matplotlib.ticker import FixedLocator, LogLocator, MultipleLocator, NullLocator

    low, high = ends
    narrow = declared.scale == "log" and low > high / NARROW
    if places and declared.scale != "log":
        axis.set_ticks([*places.values()], [*places], parse_math=False, fontsize=8)
    elif declared.ticks or ((declared.scale != "log" or narrow) and max(-low, high) > SMALL):
        axis.set_major_formatter(NUMBERS)
    if narrow:
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_minor_locator(NullLocator())
    if declared.step:
        axis.set_major_locator(MultipleLocator(declared.step))
    if declared.ticks:
        axis.set_major_locator(FixedLocator(declared.ticks))
        axis.set_minor_locator(NullLocator())
