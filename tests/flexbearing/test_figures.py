"""A figure is the same in a page and in a picture."""

from dataclasses import replace

import numpy as np
import pytest

from flexbearing.report.figure import Axis, Figure, Line, Rule
from flexbearing.report.html.plotly import layout, traces
from flexbearing.report.panels import picture

RULES = (
    Rule(-1.0, level=True, name="edges of the contact", dash="dash"),
    Rule(1.0, level=True, name="edges of the contact", dash="dash"),
    Rule(0.0, level=True),
)
FIGURE = Figure(
    "example", "example", Axis("times", "log", ticks=(0.5, 0.7, 1.0, 2.0)), Axis("place"),
    (Line((0.4, 1.0, 3.0), (-1.2, 0.3, 1.2), "place"), *RULES),
)  # fmt: skip


def test_named_rules_are_in_the_legend_once():
    axes, drawn = picture("title", "what", [FIGURE]).axes[0], layout(FIGURE)
    page_legend = [each["name"] for each in (*traces(FIGURE), *drawn["shapes"]) if each.get("showlegend")]
    (legend,) = axes.figure.legends or [axes.get_legend()]
    assert drawn["showlegend"]
    assert (
        page_legend == [text.get_text() for text in legend.get_texts()] == ["place", "edges of the contact"]
    )
    assert [each.get("legendgroup") for each in drawn["shapes"]] == ["edges of the contact"] * 2 + [None]


def test_a_single_rule_without_a_name_has_no_legend():
    assert not layout(replace(FIGURE, items=(Line((1.0,), (2.0,)), RULES[2])))["showlegend"]


@pytest.mark.parametrize("scale", ["log", "linear"])
def test_ticks_are_those_of_the_axis(scale):
    figure = replace(FIGURE, x=replace(FIGURE.x, scale=scale))
    page = picture("title", "what", [figure])
    page.draw_without_rendering()
    axis, (low, high) = page.axes[0].xaxis, page.axes[0].get_xlim()
    inside = [tick for tick in figure.x.ticks if low <= tick <= high]
    shown = [
        (tick, text.get_text()) for tick, text in zip(axis.get_ticklocs(), axis.get_ticklabels(), strict=True)
    ]
    assert [tick for tick, text in shown if low <= tick <= high] == inside
    assert [text for tick, text in shown if low <= tick <= high] == [f"{tick:g}" for tick in inside]
    assert not np.size(axis.get_minorticklocs())
    assert layout(figure)["xaxis"]["tickvals"] == figure.x.ticks


def test_rounding_is_not_drawn_as_a_shape():
    """Angles of 1e-20 degrees filled a panel."""
    rounded = Figure("angles", "angles", Axis("x"), Axis("angle [deg]"), (Line((0.0, 1.0), (1e-20, -3e-20)),))
    assert rounded.y.ends == (-1.0, 1.0)
    small = Figure("strains", "strains", Axis("x"), Axis("strain"), (Line((0.0, 1.0), (1e-6, -3e-6)),))
    assert small.y.ends is None
