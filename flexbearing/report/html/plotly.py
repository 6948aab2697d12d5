"""Figures as Plotly takes them: traces and layout."""

from collections.abc import Iterator
from math import log10
from typing import Any

from flexbearing.report.figure import BAND, Axis, Bars, Figure, Item, Line, Map, Rule


def traces(figure: Figure) -> list[dict[str, Any]]:
    """Lines, bars and maps of a figure."""
    return [{key: value for key, value in trace.items() if value not in ("", (), None)}
            for item in figure.items for trace in _traces(item)]  # fmt: skip


def _traces(item: Item) -> Iterator[dict[str, Any]]:
    if isinstance(item, Line):
        yield _line(item)
    elif isinstance(item, Bars):
        yield _bars(item)
    elif isinstance(item, Map):
        yield _map(item)
        yield from _contours(item)


def _shared(item: Line | Bars | Map) -> dict[str, Any]:
    """What traces of all kinds have."""
    return {
        "x": item.x, "y": item.y, "customdata": item.places, "hovertemplate": item.hover, "meta": item.of,
    }  # fmt: skip


def _line(line: Line) -> dict[str, Any]:
    mode = "+".join(filter(None, ["lines" if line.dash else "", "markers" if line.mark else ""]))
    style = {"color": line.colour, "dash": line.dash or "solid", "width": line.width}
    return _shared(line) | {
        "type": "scatter", "mode": mode, "name": line.name, "legendgroup": line.group, "text": line.words,
        "showlegend": bool(line.name), "line": style,
        "marker": {"color": line.colour, "size": line.size, "symbol": line.mark or "circle"},
    }  # fmt: skip


def _bars(bars: Bars) -> dict[str, Any]:
    below, above = bars.errors or (None, None)
    error = {"type": "data", "symmetric": False, "thickness": 1, "array": above, "arrayminus": below}
    return _shared(bars) | {
        "type": "bar", "name": bars.name, "orientation": "h" if bars.level else "v", "width": bars.thickness,
        "marker": {"color": bars.colour}, "error_x" if bars.level else "error_y": error if below else None,
    }  # fmt: skip


def _map(drawn: Map) -> dict[str, Any]:
    low, high = drawn.ends or (None, None)
    above = {"orientation": "h", "y": 1.0, "yanchor": "bottom", "thickness": 12}  # as narrow screens need it
    title = {"title": {"text": drawn.label, "side": "right"}} if drawn.label else {}
    return _shared(drawn) | {
        "type": "heatmap", "z": drawn.z, "zmin": low, "zmax": high,
        "colorscale": drawn.colours.capitalize(), "colorbar": above | title,
    }  # fmt: skip


def _contours(drawn: Map) -> Iterator[dict[str, Any]]:
    for each in drawn.contours:
        at = {"start": each.value, "end": each.value, "size": 1.0, "coloring": "none", "showlabels": True}
        yield {
            "type": "contour", "x": drawn.x, "y": drawn.y, "z": drawn.z, "autocontour": False,
            "contours": at | {"labelfont": {"color": each.colour}}, "showscale": False, "hoverinfo": "skip",
            "line": {"color": each.colour, "width": each.width}, "name": f"{each.value:g}", "meta": drawn.of,
        }  # fmt: skip


def layout(figure: Figure) -> dict[str, Any]:
    """Axes of a figure, lines across it."""
    rules = [item for item in figure.items if isinstance(item, Rule)]
    names = [rule.name for rule in rules]
    lines = [item.name for item in figure.items if isinstance(item, Line | Bars)]
    named = len([*filter(None, [*lines, *dict.fromkeys(names)])])
    y = _axis(figure.y) | ({"scaleanchor": "x"} if figure.equal else {})
    parts = {
        "shapes": [_rule(rule) | _named(rule, names.index(rule.name) == k) for k, rule in enumerate(rules)],
        "annotations": [_word(rule) for rule in rules if rule.word],
        **(
            {"barmode": "overlay", "bargap": 0}
            if any(isinstance(item, Bars) for item in figure.items)
            else {}
        ),
    }
    return {"xaxis": _axis(figure.x), "yaxis": y, "showlegend": named > 1,
            **{name: part for name, part in parts.items() if part != []}}  # fmt: skip


def _axis(axis: Axis) -> dict[str, Any]:
    log = axis.scale == "log"
    settings = {
        "dtick": axis.step, "range": [*map(log10, axis.ends)] if log and axis.ends else axis.ends,
        "tickvals": axis.ticks or None, "rangemode": "tozero" if axis.from_zero else None,
        "autorange": "reversed" if axis.falling else None,
        "exponentformat": "power" if axis.decades else None,
    }  # fmt: skip
    known = {name: value for name, value in settings.items() if value is not None}
    return {"title": {"text": axis.label}, "type": axis.scale, **known}


def _ends(rule: Rule) -> dict[str, Any]:
    """Both ends of a rule, along x or y."""
    across, along = ("y", "x") if rule.level else ("x", "y")
    far = rule.at if rule.to is None else rule.to
    return {f"{across}ref": across, f"{along}ref": "paper", f"{across}0": rule.at, f"{across}1": far,
            f"{along}0": 0, f"{along}1": 1}  # fmt: skip


def _rule(rule: Rule) -> dict[str, Any]:
    line = {"color": rule.colour, "dash": rule.dash, "width": rule.width}
    if rule.to is None:
        return {"type": "line", **_ends(rule), "line": line}
    return {"type": "rect", **_ends(rule), "fillcolor": rule.colour, "opacity": BAND, "line": {"width": 0}}


def _named(rule: Rule, first: bool) -> dict[str, Any]:
    """Place of a rule in the legend, one for all rules of a name."""
    return {"name": rule.name, "legendgroup": rule.name, "showlegend": first} if rule.name else {}


def _word(rule: Rule) -> dict[str, Any]:
    place = {"x": rule.at, "y": 0.01, "xref": "x", "yref": "paper", "xanchor": "left", "yanchor": "bottom"}
    font = {"color": rule.colour}
    return place | {"text": rule.word, "showarrow": False, "font": font, "bgcolor": "rgba(255,255,255,0.75)"}
