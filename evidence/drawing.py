"""Figures of the pages."""

import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

LOOK = {
    "figure.dpi": 110,
    "font.size": 9,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.alpha": 0.3,
    "legend.frameon": False,
}


def one(across: str, up: str, height: float = 3.0, **settings: object) -> tuple[Figure, Axes]:
    """A figure with one pair of axes."""
    figure, axes = plt.subplots(figsize=(4.6, height))
    axes.set(xlabel=across, ylabel=up, **settings)
    return figure, axes


def legend_beside(axes: Axes) -> None:
    """A legend right of the axes, where it hides nothing."""
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
