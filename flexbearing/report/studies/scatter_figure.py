"""Picture of the scatter of outputs: histograms, and the shares of the keys beside them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isnan
from typing import TYPE_CHECKING, Any

from flexbearing.report.picture import plain_grid, titled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Rows = Sequence[Mapping[str, Any]]
MOST = 6  # outputs of a picture; the tables have all
WIDE = 90  # characters of the title
PERCENTILES = ("P10", ":"), ("P50", "-"), ("P90", ":")
SAMPLED, LINEAR, TOTAL = "C0", "C1", "0.75"


def draw_scatter(name: str, outputs: Rows, shares: Rows, bins: Rows) -> Figure:
    """Draw how the outputs of a sampled study scatter."""
    from matplotlib.figure import Figure  # a second to load: only pictures pay for it

    shown = outputs[:MOST]
    figure = Figure(figsize=(9.0, 0.8 + 2.4 * len(shown)), layout="constrained")
    panels = figure.subplots(len(shown), 2, squeeze=False)
    for (left, right), output in zip(panels, shown, strict=True):
        of_output = [[row for row in rows if row["output"] == output["output"]] for rows in (bins, shares)]
        _histogram(left, output, of_output[0])
        _shares(right, of_output[1])
    panels[0][0].legend(fontsize=8)
    if panels[0][1].get_legend_handles_labels()[1]:
        panels[0][1].legend(fontsize=8, loc="lower right")
    panels[-1][1].set_xlabel("share of the variance [%]")
    figure.suptitle(titled(f"Study: {name}", WIDE), parse_math=False)
    return figure


def _histogram(axes: Axes, output: Mapping[str, Any], bins: Rows) -> None:
    """Rows in each bin, and how many are there by the linear prediction."""
    edges = [bins[0]["from"], *(row["to"] for row in bins)]
    axes.stairs([row["rows"] for row in bins], edges, fill=True, color=SAMPLED, alpha=0.5, label="sampled")
    linear = [row["linear_rows"] for row in bins]
    if not any(map(isnan, linear)):
        axes.stairs(linear, edges, color=LINEAR, label="linear")
    for percentile, line in PERCENTILES:
        axes.axvline(output[percentile], color="0.2", linestyle=line, linewidth=1)
    unit = f" [{output['unit']}]" if output["unit"] else ""
    axes.set_xlabel(f"{output['output'].replace('_', ' ')}{unit}   P10, P50, P90", fontsize=9)
    axes.set_ylabel("rows", fontsize=9)
    plain_grid(axes)


def _shares(axes: Axes, keys: Rows) -> None:
    """Shares of the keys in the variance, the largest above."""
    sampled = not isnan(keys[0]["total"])
    by = "total" if sampled else "linear_share"
    ordered = sorted(keys, key=lambda row: 0.0 if isnan(row[by]) else row[by])
    names = [row["key"].rpartition(".")[2].replace("_", " ") for row in ordered]
    for form, rows in (("total", ordered), ("first", ordered)) if sampled else ():
        colour = TOTAL if form == "total" else SAMPLED
        values = [100 * row[form] for row in rows]
        error = [
            [100 * max(0.0, row[form] - row[f"{form}_low"]) for row in rows],
            [100 * max(0.0, row[f"{form}_high"] - row[form]) for row in rows],
        ]
        label = "total index" if form == "total" else "first-order index"
        axes.barh(names, values, height=0.8 if form == "total" else 0.4, color=colour, label=label)
        axes.errorbar(values, names, xerr=error, fmt="none", ecolor="0.2", elinewidth=1)
    linear = [100 * row["linear_share"] for row in ordered]
    if not all(map(isnan, linear)):
        axes.plot(linear, names, "D", color=LINEAR, markersize=5, label="linear, by derivatives")
    axes.set_xlim(left=0)
    axes.tick_params(labelsize=8)
    plain_grid(axes)
