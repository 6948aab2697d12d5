"""Pictures of studies: which columns they need, which points are joined."""

from dataclasses import replace
from math import isnan, pi

import pytest

from flexbearing import run, study
from flexbearing.case import BadCase
from flexbearing.quantities.roller import LAYOUT
from flexbearing.studies.plan import Row
from flexbearing.studies.table.collected import of_text
from flexbearing.studies.table.table import Mark, Plot, draw
from tests.flexbearing.test_studies import computed
from tests.flexbearing.test_study_tables import CROSSED
from tests.flexbearing.toy_studies import CASE, COLLECT, toy

PLOT = '\n[plot]\nx = "operation.radial_load"\nlines = "bearing.clearance"\ny = ["life", "cage_slip [%]"]\n'


def drawn(table, **changes):
    figure = draw(table, Plot(**{"x": "operation.radial_load", "lines": None, "y": ("life",), **changes}))
    return figure, [axes.get_lines() for axes in figure.axes]


@pytest.mark.slow
def test_a_study_with_a_plot_leaves_a_picture_and_no_column_twice(tmp_path):
    prepared = toy(tmp_path, CROSSED, collect=COLLECT + PLOT)
    assert [column.column for column in prepared.columns] == ["life", "slip"]
    assert prepared.plot == Plot("operation.radial_load", "bearing.clearance", ("life", "slip"), (None, None))
    computed(prepared, tmp_path)
    assert (tmp_path / "toy.png").read_bytes().startswith(b"\x89PNG")


def test_what_a_plot_needs_is_collected(tmp_path):
    collect = '[plot]\nx = "max_roller_load [kN]"\ny = ["life_L10 [h]", "cage_slip"]\nrigid = true\n'
    collect += '[collect]\na = "stiffness_zz"'
    prepared = toy(tmp_path, collect=collect)
    assert {column.column: column.text for column in prepared.columns} == {
        "a": "stiffness_zz [N/m]",
        "max_roller_load": "max_roller_load [kN]",
        "life_L10": "life_L10 [h]",
        "cage_slip": "cage_slip [%]",
        "life_L10_rigid": "rigid.life_L10 [h]",
        "cage_slip_rigid": "rigid.cage_slip [%]",
    }
    assert prepared.plot.rigid == ("life_L10_rigid", "cage_slip_rigid")


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


MARK = """
[plot]
x = "operation.radial_load"
y = ["life", "cage_slip [%]"]
[[plot.marks]]
y = "life"
value = "1 rev .. 2e6 rev"
label = "printed"
source = "Book, p. 3"
[[plot.marks]]
y = "cage_slip [%]"
value = "0.5"
x = "4 kN"
label = "measured"
source = "Report"
"""


def test_marks_are_drawn_in_the_units_of_their_axes(tmp_path):
    prepared = toy(tmp_path, collect=COLLECT + MARK)
    assert prepared.plot.marks == (
        Mark("life", pytest.approx(1e-6), pytest.approx(2.0), None, "printed (Book, p. 3)"),
        Mark("slip", pytest.approx(50.0), pytest.approx(50.0), 4000.0, "measured (Report)"),
    )
    figure = draw(computed(prepared, tmp_path), prepared.plot)
    named = [[text.get_text() for text in axes.get_legend().get_texts()] for axes in figure.axes]
    assert named == [["printed (Book, p. 3)"], ["measured (Report)"]]


def test_quotients_are_columns_of_two_outputs_in_the_same_unit(tmp_path):
    collect = '[collect]\ngain = "life_L10 / life_L10 [%]"\nslip = "cage_slip"'
    prepared = toy(tmp_path, collect=collect)
    share = of_text("share", "flexible.max_roller_load / rigid.max_roller_load [%]", LAYOUT)
    (above, below), row = share.texts, Row("", "converged", "", 0.0)
    assert share.values([replace(row, values={above: 3.0, below: 4.0})]).values == (75.0,)
    assert all(map(isnan, share.values([replace(row, values={above: 3.0, below: 0.0}), row]).values))
    values = computed(prepared, tmp_path)["gain"].values
    assert isnan(values[0])
    assert values[-1] == 100.0


WRONG_QUOTIENTS = {
    "life_L10 / cage_slip": r"'Mrev' is a unit of another kind than '%'",
    "life_L10 / live": r"'live.*no output has this name",
    "life_L10 / life_L10 [N]": r"'N' is a unit of another kind than '1'",
}  # fmt: skip


@pytest.mark.parametrize(("text", "message"), WRONG_QUOTIENTS.items(), ids=list(WRONG_QUOTIENTS))
def test_a_wrong_quotient_is_told(tmp_path, text, message):
    with pytest.raises(BadCase, match=rf"^toy\.toml: \[collect\] gain: .*{message}"):
        toy(tmp_path, collect=f'[collect]\ngain = "{text}"')


WRONG_MARKS = {
    ('y = "life"', 'y = "live"'): r"y = live has no panel; it must be life or cage_slip \[%\]",
    ("2e6 rev", "2 N"): r"2 N: 'N' is a unit of another kind",
    ("2e6 rev", "many"): r"many: 'many' is no number",
    ("2e6 rev", "2 rev .. 3 rev"): r"value = 1 rev \.\. 2 rev \.\. 3 rev is no number and no range",
    ('"4 kN"', '"4 mm"'): r"x = 4 mm is not a force",
}  # fmt: skip


@pytest.mark.parametrize(("change", "message"), WRONG_MARKS.items(), ids=lambda each: each[1])
def test_a_wrong_mark_is_told(tmp_path, change, message):
    with pytest.raises(BadCase, match=rf"^toy\.toml: \[plot\] marks: {message}"):
        toy(tmp_path, collect=COLLECT + MARK.replace(*change, 1))


def test_a_mark_without_a_key_is_told(tmp_path):
    """A list of tables, of which each may lack a key."""
    short = MARK.replace('label = "measured"\n', "").replace('y = "life"\n', "")
    with pytest.raises(BadCase) as problem:
        toy(tmp_path, collect=COLLECT + short)
    assert [line.split(" is missing")[0] for line in str(problem.value).splitlines()] == [
        "toy.toml: [plot.marks] y", "toy.toml: [plot.marks] label",
    ]  # fmt: skip


ROLLERS = """[collect]
azimuth = "roller_azimuth [deg]"
load = "rigid.inner_load [kN]"
sliding = "inner_sliding [m/s]"
[plot]
x = "azimuth"
y = ["load", "sliding"]
"""


def test_quantities_of_every_roller_are_those_of_a_single_run(tmp_path):
    over = '"operation.radial_load" = ["5 kN", "10 kN"]'
    toy(tmp_path, over, collect=ROLLERS)
    table = study(tmp_path / "toy.toml", tmp_path, jobs=1)
    arrays = table.to_xarray()
    assert arrays["load"].dims == ("operation.radial_load", "roller")
    assert "load" not in (tmp_path / "toy.csv").read_text().partition("\n")[0].split(",")
    for number, load in enumerate(["5 kN", "10 kN"]):
        rigid = run(CASE, {"operation.radial_load": load}).rigid
        assert arrays["load"].values[number] == pytest.approx(rigid["inner_load"] / 1e3, rel=1e-9, abs=1e-12)
        assert arrays["sliding"].values[number] == pytest.approx(rigid["inner_sliding"], rel=1e-8, abs=1e-9)
        assert arrays["azimuth"].values[number] == pytest.approx(rigid["roller_azimuth"] * 180 / pi)
    line = draw(table, toy(tmp_path, over, collect=ROLLERS).plot).axes[0].get_lines()[1]
    assert line.get_label() == "radial load 10000 N"
    assert min(line.get_xdata()) == pytest.approx(-180)
    assert list(line.get_xdata()) == sorted(line.get_xdata())
    assert max(line.get_ydata()) == pytest.approx(arrays["load"].values[1].max())


def test_rollers_must_be_as_many_in_every_variant(tmp_path):
    with pytest.raises(BadCase, match=r"'roller_azimuth \[deg\]': a number for every roller needs the same"):
        toy(tmp_path, '"bearing.rollers" = [12, 13]', collect=ROLLERS)


def test_rollers_stand_over_rollers_alone(tmp_path):
    with pytest.raises(BadCase, match=r"\[plot\] x and y must both have a number for every roller"):
        toy(tmp_path, collect=ROLLERS.replace('x = "azimuth"', 'x = "operation.radial_load"'))


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
