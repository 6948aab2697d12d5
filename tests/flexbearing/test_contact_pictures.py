"""Pictures of contacts: what is drawn is what the files hold, of one result and of two side by side."""

import numpy as np
import pytest
from matplotlib.collections import QuadMesh
from matplotlib.image import imread
from matplotlib.quiver import Quiver
from pytest import approx

import flexbearing
from flexbearing import read
from flexbearing.report.balls.side_by_side import compared, notes
from tests.places import CONFIGS

B1, A3 = "heras2017_b1", "heras2017_a3"
FEW = "fields.points=7"
STICKING = ("friction.model=fastsim", "friction.cells=[16, 32]")
SHAPES = {"sliding": (7, 7), "sticking": (32, 16)}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Result files: the same ball in full sliding and with stick and slip, and others."""
    place = tmp_path_factory.mktemp("contacts")
    runs = {
        "sliding": (B1, FEW),
        "sticking": (B1, *STICKING),
        "local": (B1, *STICKING, "friction.spin=local", 'operation.contact_loads=["9.40 kN", "0 N"]'),
        "both": (A3, FEW),
        "third": (B1, FEW, "bearing.balls=5", "fields.balls=[3]"),
        "fast": ("rivera2021_7008",),
    }
    for name, (case, *settings) in runs.items():
        flexbearing.run(CONFIGS / f"{case}.toml", settings, output=place / f"{name}.h5")
    return place


@pytest.fixture
def result(folder):
    return lambda name: read(folder / f"{name}.h5")


def maps(axes):
    return [each for each in axes.collections if isinstance(each, QuadMesh)]


def panels(figure):
    """Panels of a figure, without its scales of colours."""
    return [axes for axes in figure.axes if maps(axes) and axes.get_xlim()[0] < 0]


def of(values, race, name):
    return values[name][0, 0, race]


def require_drawn(axes, values, race, drawn):
    """Require that the cells of a panel are those of the file, as far as they are in contact."""
    (mesh,) = maps(axes)
    touching = of(values, race, "field_pressure") > 0
    colours = np.ma.asarray(mesh.get_array())
    assert (np.ma.getmaskarray(colours) == ~touching).all()
    assert colours.compressed() == approx(drawn[touching], rel=1e-12)
    edges = np.ma.getdata(mesh.get_coordinates())
    middles = (edges[:-1, :-1] + edges[1:, 1:]) / 2
    places = np.stack([of(values, race, f"field_{name}") for name in ("across", "along")], -1)
    assert middles == approx(1e3 * places, abs=1e-9)


def test_two_models_on_different_cells_are_drawn_as_their_files_hold_them(result):
    pair = [result(name) for name in SHAPES]
    (figure,) = compared(*pair).values()
    drawn = panels(figure)
    assert len(drawn) == 12  # two contacts, two results, three maps
    places = [(race, one) for race in (0, 1) for one in pair]
    for number, (race, one) in enumerate(places):
        values = one.rigid
        pressure, shear, stick = drawn[3 * number : 3 * number + 3]
        assert of(values, race, "field_stick").shape == SHAPES[one.stem]
        stress = np.hypot(of(values, race, "shear_across"), of(values, race, "shear_along"))
        require_drawn(pressure, values, race, 1e-6 * of(values, race, "field_pressure"))
        require_drawn(shear, values, race, 1e-6 * stress)
        require_drawn(stick, values, race, of(values, race, "field_stick"))


def test_slip_is_drawn_of_a_single_result(result):
    one = result("sticking")
    (figure,) = (figure for name, figure in one.family.report().pictures()(one).items() if "contacts" in name)
    drawn = panels(figure)
    assert len(drawn) == 8
    for race in (0, 1):
        slip = np.hypot(of(one.rigid, race, "slip_across"), of(one.rigid, race, "slip_along"))
        require_drawn(drawn[4 * race + 2], one.rigid, race, 1e3 * slip)


def test_arrows_have_the_direction_of_the_stored_stress(result):
    one = result("sticking")
    (figure,) = compared(result("sliding"), one).values()
    shear = panels(figure)[4]  # inner race, on the right
    (arrows,) = (each for each in shear.collections if isinstance(each, Quiver))
    places, directions = np.asarray(arrows.XY), np.stack([arrows.U, arrows.V], -1)
    assert 20 < len(places) <= 160
    across, along = (1e3 * of(one.rigid, 0, f"field_{name}") for name in ("across", "along"))
    for (x, y), direction in zip(places, directions, strict=True):
        cell = np.unravel_index(np.hypot(across - x, along - y).argmin(), across.shape)
        assert (across[cell], along[cell]) == approx((x, y))
        stress = np.array([of(one.rigid, 0, f"shear_{name}")[cell] for name in ("across", "along")])
        assert direction == approx(stress / np.hypot(*stress))


def test_both_columns_and_all_contacts_have_one_scale_of_colours(result):
    pair = [result("sliding"), result("local")]  # of more load
    (figure,) = compared(*pair).values()
    shear = [np.hypot(one.rigid["shear_across"], one.rigid["shear_along"]).max() for one in pair]
    pressure = [one.rigid["field_pressure"].max() for one in pair]
    assert pressure[0] < pressure[1]
    for kind, largest in ((0, max(pressure)), (1, max(shear))):
        for axes in panels(figure)[kind::3]:
            assert maps(axes)[0].get_clim() == approx((0.0, 1e-6 * largest))


def test_contacts_are_to_scale(result):
    (figure,) = compared(result("sliding"), result("sticking")).values()
    width, height = figure.get_size_inches()
    for axes in panels(figure):
        box, (left, right), (low, high) = axes.get_position(), axes.get_xlim(), axes.get_ylim()
        assert box.width * width / (right - left) == approx(box.height * height / (high - low), rel=1e-9)


def words(figure):
    return [text.get_text() for text in figure.texts]


@pytest.mark.slow
def test_columns_name_model_spin_torque_error_and_cells(result):
    one, other = result("sliding"), result("local")
    (figure,) = compared(one, other).values()
    written = words(figure)
    assert {"full sliding, spin of the centre", "FASTSIM (springs), local spin"} <= set(written)
    torque, error = other.rigid["ball_torque"][0, 0], other.rigid["grid_error"][0]
    assert f"torque of the ball {one.rigid['ball_torque'][0, 0]:.4g} N m, 7 cells across, 7 along" in written
    (line,) = (text for text in written if "±" in text)
    shown = [float(line.split()[place]) for place in (4, 6)]
    assert shown == approx([torque, error], abs=0.05 * error)
    assert line.endswith(" N m, 32 cells across, 16 along")


def test_other_differences_than_the_model_are_told(result):
    one, other = result("sliding"), result("local")
    first, second = notes(one, other)
    assert "friction.spin (centre and local)" in first
    assert "operation.contact_loads ([8301.4, 0] and [9400, 0])" in first
    assert "one friction.spin for both" in second
    assert notes(one, result("sticking")) == []
    (figure,) = compared(one, other).values()
    assert first in " ".join(words(figure))


def test_contact_of_one_result_alone_stands_beside_an_empty_panel(result):
    (figure,) = compared(result("sliding"), result("both")).values()
    assert len(panels(figure)) == 6 * 3
    empty = [axes for axes in figure.axes if [text.get_text() for text in axes.texts] == ["no load"]]
    assert len(empty) == 2 * 3


def test_command_draws_two_results_and_tells_what_differs(command, folder, tmp_path):
    code, told, wrong = command(
        "plot", folder / "sliding.h5", "--against", folder / "local.h5", "-o", tmp_path / "new"
    )
    (picture,) = (tmp_path / "new").iterdir()
    assert (code, wrong) == (0, "")
    assert picture.name == "sliding_against_local_ball_0.png"
    assert f"picture: {picture}" in told
    assert "friction.spin (centre and local)" in told


REFUSED = {
    "no cells": ("fast", "fast", "fast.h5: it holds no cells of contacts (field_ball is not stored)"),
    "another kind": ("sliding", "fast", "of a four_point_ball"),
    "another ball": ("sliding", "third", "of ball 3: none of the same ball"),
}


@pytest.mark.parametrize(("one", "other", "reason"), REFUSED.values(), ids=REFUSED)
def test_results_without_contacts_to_compare_are_refused_in_a_line(
    command, folder, tmp_path, one, other, reason
):
    code, told, wrong = command(
        "plot", folder / f"{one}.h5", "--against", folder / f"{other}.h5", "-o", tmp_path / "new"
    )
    assert (code, told) == (2, "")
    assert wrong.count("\n") == 1
    assert reason in wrong
    assert not (tmp_path / "new").exists()


@pytest.mark.slow
def test_sheet_without_heading_is_as_wide_and_lacks_the_room_of_the_heading(command, folder, tmp_path):
    heights = []
    for words in ((), ("--no-titles",)):
        assert command("plot", folder / "both.h5", "-o", tmp_path, *words)[0] == 0
        heights.append(imread(tmp_path / "both_contacts_of_ball_0.png").shape[:2])
    (tall, wide), (lower, as_wide) = heights
    assert as_wide == wide
    assert 50 < tall - lower < 150  # dots, of three lines at 150 to the inch
