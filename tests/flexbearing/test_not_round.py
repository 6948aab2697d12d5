"""Raceways of fast balls that are not round, and inner rings on cams."""

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import check, read_case, sensitivities
from flexbearing.case import BadCase
from flexbearing.report.card import of_result
from tests.flexbearing.noted import codes

DEEP = "configs/6209.toml"
CAM = "configs/strain_wave.toml"
OVAL = {"bearing.form_error.outer.waves": 2, "bearing.form_error.outer.amplitude": "4 um"}


SOLVED = {}
COARSE = {"accuracy.element_order": 3}


def run(case, settings=()):
    """Each case computed once."""
    given = (COARSE if case == CAM else {}) | dict(settings)
    key = case, repr(given)
    if key not in SOLVED:
        SOLVED[key] = flexbearing.run(case, given)
    return SOLVED[key]


def test_opposite_waves_of_both_races_are_none():
    inner = {"bearing.form_error.inner.waves": 2, "bearing.form_error.inner.amplitude": "-4 um"}
    both, without = run(DEEP, OVAL | inner).rigid, run(DEEP).rigid
    assert both["contact_load"] == approx(without["contact_load"], rel=1e-9, abs=1e-6)


def test_a_crest_under_the_load_is_pressed_more():
    below, aside = (
        run(DEEP, OVAL | {"bearing.form_error.outer.crest": crest}).rigid["contact_load"][0]
        for crest in ("0 deg", "90 deg")
    )
    without = run(DEEP).rigid["contact_load"][0]
    assert aside.max() < without.max() < below.max()
    for loads in (below, aside):  # the load is carried all the same
        assert loads @ np.cos(2 * np.pi * np.arange(len(loads)) / len(loads)) == approx(
            without @ np.cos(2 * np.pi * np.arange(len(loads)) / len(loads)), rel=1e-6
        )


def test_waves_add_up_as_those_of_rollers_do():
    two = {
        "bearing.form_error.outer.waves": 2, "bearing.form_error.outer.amplitude": "1 um",
        "bearing.form_error.outer.further_waves": [2],
        "bearing.form_error.outer.further_amplitudes": ["3 um"],
    }  # fmt: skip
    assert run(DEEP, two).rigid["contact_load"] == approx(run(DEEP, OVAL).rigid["contact_load"], rel=1e-9)


def test_a_ring_follows_its_cam_between_rigid_and_elastic_ones():
    result = run(CAM)
    loads = result.flexible["contact_load"]
    assert result.attributes["status"] == "converged"
    assert not result.rigid["contact_load"].any()  # without the cam
    assert loads[0] == approx(loads[1], rel=1e-9)  # at rest
    assert loads[1, 1:] == approx(loads[1, :0:-1], rel=1e-4, abs=0.05)  # from the crest to either side
    azimuth = 2 * np.pi * np.arange(23) / 23
    assert (loads[0, np.abs(np.cos(azimuth)) < 0.5] == 0).any()


def test_a_turned_cam_turns_the_loads():
    turned = run(CAM, {"inner.cam_crest": f"{360 * 3 / 23} deg"}).flexible["contact_load"][0]
    assert turned == approx(np.roll(run(CAM).flexible["contact_load"][0], 3), rel=1e-4, abs=0.01)


def test_a_cam_that_turns_in_a_ring_wears_them_as_a_ring_that_turns_around_it(tmp_path):
    """The load of a cam turns with it; between rigid rings, where there is none, no life is shown."""
    turning = flexbearing.run(CAM, COARSE | {"operation.inner_speed": "1 rpm"}, output=tmp_path / "cam.h5")
    around = run(CAM, {"operation.outer_speed": "-1 rpm"})
    for name in ("life_L10", "raceway_life"):
        assert turning.flexible[name] == approx(around.flexible[name], rel=1e-6)
        assert name not in turning.rigid
    inner, outer = turning.flexible["raceway_life"]
    assert outer > inner  # each place of the outer race meets the crest in its turn, the inner crest always
    assert "rigid" not in [line.subject for line in of_result(turning).lines]


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"outer": {"kind": "rigid"}}, r"\[outer\] kind .* around a cam"),
        ({"inner.cam_amplitude": None}, r"cam_amplitude is missing"),
        (
            {"operation.displacement.axial": None, "operation.preload.force": "5 N"},
            'another one than "cam" beside operation.preload',
        ),
        ({"inner.cam_amplitude": "0.8 mm"}, r"cam_amplitude .* at most 0.75 mm"),
    ],
)
def test_what_a_cam_cannot_have_is_refused(changes, words):
    with pytest.raises(BadCase, match=words):
        check(CAM, changes)


def test_waves_that_are_too_many_are_refused_as_those_of_rollers_are():
    with pytest.raises(BadCase, match=r"bearing.form_error.outer: 200 waves of 4 um; at most"):
        check(DEEP, OVAL | {"bearing.form_error.outer.waves": 200})


def test_notes_on_large_shapes_and_on_those_that_turn():
    still = set(codes(run(CAM)))
    assert not {"large-deflection", "turning-waves"} & still
    turning = {"inner.cam_amplitude": "0.2 mm", "operation.inner_speed": "100 rpm"}
    assert {"large-deflection", "turning-waves"} <= set(codes(run(CAM, turning)))


def test_derivative_by_the_amplitude_of_a_cam():
    output, key = "contact_load_range.outer.largest", "inner.cam_amplitude"
    table = sensitivities(read_case(CAM, COARSE), of=[output], by=[key])
    up, down = (
        run(CAM, {key: f"{amplitude} mm"}).flexible["contact_load"][1].max() for amplitude in (0.1001, 0.0999)
    )
    assert table.slopes[0, 0] == approx((up - down) / 0.2e-3, rel=1e-3)  # [N/mm]
