"""Pictures of studies: which columns they need, which points are joined."""

from math import isnan

import pytest

from flexbearing.case import BadCase
from flexbearing.studies.table.plot import Plot, draw
from tests.flexbearing.test_studies import computed
from tests.flexbearing.test_study_tables import CROSSED
from tests.flexbearing.toy_studies import COLLECT, toy

PLOT = '\n[plot]\nx = "operation.radial_load"\nlines = "bearing.clearance"\ny = ["life", "cage_slip [%]"]\n'


def drawn(table, **changes):
    figure = draw(table, Plot(**{"x": "operation.radial_load", "lines": None, "y": ("life",), **changes}))
    return figure, [axes.get_lines() for axes in figure.axes]


def test_a_study_with_a_plot_leaves_a_picture_and_no_column_twice(tmp_path):
    settled = toy(tmp_path, CROSSED, collect=COLLECT + PLOT)
    assert [column.column for column in settled.columns] == ["life", "slip"]
    assert settled.plot == Plot("operation.radial_load", "bearing.clearance", ("life", "slip"), (None, None))
    computed(settled, tmp_path)
    assert (tmp_path / "toy.png").read_bytes().startswith(b"\x89PNG")


def test_what_a_plot_needs_is_collected(tmp_path):
    collect = '[plot]\nx = "max_roller_load [kN]"\ny = ["life_L10 [h]", "cage_slip"]\nrigid = true\n'
    collect += '[collect]\na = "stiffness_zz"'
    settled = toy(tmp_path, collect=collect)
    assert {column.column: column.text for column in settled.columns} == {
        "a": "stiffness_zz [N/m]",
        "max_roller_load": "max_roller_load [kN]",
        "life_L10": "life_L10 [h]",
        "cage_slip": "cage_slip [%]",
        "life_L10_rigid": "rigid.life_L10 [h]",
        "cage_slip_rigid": "rigid.cage_slip [%]",
    }
    assert settled.plot.rigid == ("life_L10_rigid", "cage_slip_rigid")


def test_every_value_of_a_crossed_key_has_a_line_over_x(tmp_path):
    table = computed(toy(tmp_path, CROSSED), tmp_path)
    figure, (lines,) = drawn(table, lines="bearing.clearance", rigid=(None,))
    assert [line.get_label() for line in lines] == [
        f"clearance {clearance} um, tilt {tilt}" for clearance in (20, 30) for tilt in ("fixed", "free")
    ]
    for line in lines:
        assert list(line.get_xdata()) == [1e3, 2e3, 3e3, 4e3]
        assert isnan(line.get_ydata()[0])
        assert list(line.get_ydata()[1:]) == pytest.approx([125.0, 1000 / 27, 15.625])
    assert figure.axes[0].get_ylabel() == "life [Mrev]"
    assert figure.axes[0].get_xlabel() == "operation.radial_load [N]"


def test_points_stand_in_the_order_of_x_and_ranges_by_ratio_on_a_logarithmic_axis(tmp_path):
    over = '"operation.radial_load" = ["40 kN", "10 kN", "20 kN"]'
    figure, (lines,) = drawn(computed(toy(tmp_path, over), tmp_path), rigid=(None,))
    assert list(lines[0].get_xdata()) == [10e3, 20e3, 40e3]
    assert figure.axes[0].get_xscale() == "log"


def test_rigid_raceways_are_dashed_in_the_colour_of_their_line(tmp_path):
    table = computed(toy(tmp_path), tmp_path)
    _, (lines,) = drawn(table, rigid=("slip",))
    assert [line.get_linestyle() for line in lines] == ["-", "--", "--"]
    assert lines[0].get_color() == lines[1].get_color()
    assert lines[2].get_label() == "rigid raceways"


def test_outputs_over_an_output_are_points(tmp_path):
    _, (lines,) = drawn(computed(toy(tmp_path), tmp_path), x="slip", rigid=(None,))
    assert lines[0].get_linestyle() == "None"


WRONG = {
    'x = "operation.inner_speed"\ny = ["life"]': r"\[plot\] 'operation.inner_speed': no output has this name",
    'x = "operation.radial_load"\ny = ["live"]': r"\[plot\] 'live': .* Columns of \[collect\]: life, slip\.",
    'x = "operation.radial_load"\ny = ["life"]\nlines = "bearing.clearance"':
        r"\[plot\] lines = bearing\.clearance is no key that varies; it must be operation\.radial_load",
    'x = "operation.radial_load"\ny = []': r"\[plot\] y = \[\] is not allowed",
    'y = ["life"]': r"\[plot\] x is missing",
    'x = "operation.radial_load"\ny = ["life_L10 [N]"]': r"\[plot\] .*'N' is a unit of another kind",
}  # fmt: skip


@pytest.mark.parametrize(("text", "message"), WRONG.items(), ids=list(WRONG))
def test_a_wrong_plot_is_told(tmp_path, text, message):
    with pytest.raises(BadCase, match=rf"^toy\.toml: {message}"):
        toy(tmp_path, collect=f"{COLLECT}\n[plot]\n{text}")
