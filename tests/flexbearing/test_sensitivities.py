"""Derivatives of outputs by keys: against cases that are solved again, identities, both sides, refusals."""

import csv
import json
from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

import flexbearing as fb
from flexbearing import __main__ as program, api
from flexbearing.case import BadCase
from flexbearing.derivatives.rollers import BEYOND, REACH, sensitivities
from flexbearing.families import FAMILIES
from flexbearing.progress import Silent
from flexbearing.sensitivity.page import draw_tornado
from tests.places import CONFIGS

PAPER, TEXTBOOK = CONFIGS / "mao2016.toml", CONFIGS / "nu209.toml"
RIGID = ["inner.kind=rigid", "outer.kind=rigid", "operation.tilt=fixed"]
BEAM = ["inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam"]  # nothing is meshed
OUTPUTS = ["life_L10", "max_roller_load", "cage_slip", "stiffness_zz", "minimum_film.inner"]
KEYS = {  # value and unit in the paper's case
    "operation.radial_load": (19621.1, "N"),
    "operation.inner_speed": (38000.0, "rpm"),
    "operation.temperatures.roller": (226.0, "degC"),
    "bearing.clearance": (75.5, "um"),
    "bearing.roller.drop": (1.75, "um"),
    "materials.roller.youngs_modulus": (209.0, "GPa"),
    "lubricant.inlet_temperature": (220.0, "degC"),
    "lubricant.oil_fraction": (0.3324, ""),
}


def rigid_case(*settings):
    return api.read_case(PAPER, [*RIGID, *settings])


def solved_again(settings, key, step=1e-5):
    """Central differences of runs by a key, per its unit."""
    value, unit = KEYS[key]
    ends = [
        fb.run(PAPER, [*settings, f"{key}={value * (1 + sign * step)!r} {unit}".strip()]) for sign in (-1, 1)
    ]
    numbers = np.array([[end[name].number for name in OUTPUTS] for end in ends])
    return (numbers[1] - numbers[0]) / (2 * step * value)


@pytest.fixture(scope="module")
def of_rigid():
    return sensitivities(rigid_case(), OUTPUTS, list(KEYS))


@pytest.mark.parametrize("key", KEYS)
def test_derivatives_are_those_of_cases_solved_again(of_rigid, key):
    again = solved_again(RIGID, key)
    found = np.array([of_rigid[name, key].slope for name in OUTPUTS])
    values = np.array([output.value for output in of_rigid.outputs])
    floor = 1e-3 * np.abs(values) / KEYS[key][0]  # elasticities below are rounding of the runs
    assert (np.abs(found - again) <= 1e-5 * np.maximum(np.abs(again), floor)).all()


def test_rollers_that_go_around_between_flexible_rings_change_the_direction_of_their_translation():
    """By symmetry nothing changes at azimuth 0 but through friction: what is left is small, but not zero."""
    case = api.read_case(PAPER, [*BEAM, "bearing.first_roller_azimuth=0 deg"])
    key = "bearing.first_roller_azimuth"
    found = sensitivities(case, ["stiffness_zz"], [key])["stiffness_zz", key]
    ends = [fb.run(PAPER, [*BEAM, f"{key}={sign * 5e-4!r} deg"])["stiffness_zz"].number for sign in (-1, 1)]
    assert found.slope == approx((ends[1] - ends[0]) / 1e-3, rel=1e-3)


def test_displacement_by_load_is_the_inverse_of_the_stiffness():
    case = rigid_case()
    found = sensitivities(case, ["displacement_along_load", "stiffness"], ["operation.radial_load"])
    slope = found["displacement_along_load", "operation.radial_load"].slope * 1e-6  # [m/N]
    assert slope * found.outputs[1].value == approx(1.0, rel=1e-8)


def test_life_of_slices_falls_with_the_fourth_power_of_the_load_without_clearance():
    """Without clearance, crowning, weight and films the distribution of the load does not change with it."""
    still = ["operation.gravity=0 m/s^2", "bearing.roller.profile=straight", "bearing.clearance=0 um"]
    case = api.read_case(TEXTBOOK, [*still, "operation.inner_speed=1 rpm", "lubricant.oil_fraction=0"])
    slope = sensitivities(case, ["life_L10"], ["operation.radial_load"])["life_L10", "operation.radial_load"]
    assert slope.elasticity == approx(-4, rel=1e-3)  # the last bit of film remains


def test_derivative_is_by_the_unit_that_the_case_states():
    one = sensitivities(rigid_case(), ["max_roller_load"], ["bearing.clearance"])
    other = sensitivities(
        rigid_case("bearing.clearance=0.0755 mm"), ["max_roller_load [kN]"], ["bearing.clearance"]
    )
    per_um, per_mm = (each["max_roller_load", "bearing.clearance"] for each in (one, other))
    assert (per_um.key.unit, per_mm.key.unit) == ("um", "mm")
    # N/um is kN/mm; clearances that differ by rounding are solved apart
    assert per_mm.slope == approx(per_um.slope, rel=1e-7)
    assert per_mm.elasticity == approx(per_um.elasticity, rel=1e-7)


def test_stated_speed_in_turns_a_minute_is_differentiated_by_them(of_rigid):
    slope = of_rigid["cage_slip", "operation.inner_speed"]
    assert (slope.key.unit, slope.key.stated) == ("rpm", approx(38000.0))
    assert slope.elasticity == approx(slope.slope * 38000.0 / slope.output.value, rel=1e-9)


def test_temperature_has_a_derivative_by_kelvin_and_no_elasticity(of_rigid):
    slope = of_rigid["life_L10", "operation.temperatures.roller"]
    assert slope.key.unit == "degC"
    assert np.isnan(slope.elasticity)
    assert slope.reaches


def test_keys_stand_in_the_order_of_what_a_realistic_step_changes():
    slopes = sensitivities(rigid_case(), ["life"]).by_output["life_L10"]
    sizes = [abs(slope.change) for slope in slopes]
    assert sizes == sorted(sizes, reverse=True)
    assert slopes[0].key.path == "bearing.roller.diameter"
    place = [slope.key.path for slope in slopes].index("operation.temperatures.roller")
    assert place < len(slopes) - 1  # 5 K, without an elasticity
    assert slopes[place].change == approx(5 * slopes[place].slope)
    assert "bearing.cage.mass" not in [
        slope.key.path for slope in slopes
    ]  # without a free centre it does nothing


def test_choices_are_ranked_among_numbers_by_what_they_change():
    """Of a slip that rounds to zero no percentage is formed."""
    found = api.sensitivities(rigid_case(), ["life", "cage_slip"])
    rollers = next(each for each in found.by_output["life_L10"] if getattr(each, "words", "") == "31")
    again = fb.run(PAPER, [*RIGID, "bearing.rollers=31"])["life_L10"].number
    assert rollers.value == approx(again, rel=1e-6)
    assert all(np.isnan(each.percent) for each in found.by_output["cage_slip"])


def at_a_contact_switch(share):
    """The paper's load at which a slice of a roller opens, times 1 + share."""
    from flexbearing.derivatives.keys import key_of
    from flexbearing.derivatives.roller_slopes import RollerSlopes
    from flexbearing.derivatives.roller_state import solved
    from flexbearing.derivatives.rollers import difference, requested_of

    load = 19621.1
    for _ in range(6):  # Newton's method on the smallest approach
        case = rigid_case(f"operation.radial_load={load!r} N")
        state, key = solved(case), key_of(case, "operation.radial_load")
        by_load = difference(state, key)
        steps = RollerSlopes(state, [by_load]).outputs(requested_of(case, ["life"])).nearest_switch[0]
        if steps < 1e-3:
            break
        up = solved(rigid_case(f"operation.radial_load={float(load + steps * key.step)!r} N"))
        slopes = RollerSlopes(up, [difference(up, key_of(up.base.case, key.path))])
        nearer = slopes.outputs(requested_of(case, ["life"])).nearest_switch[0] < steps
        load += float(steps * key.step) * (1 if nearer else -1)
    return load * (1 + share)


def stiffness_by_load_at(load):
    """Change of the stiffness with the load [1/m] between re-solved loads."""
    from flexbearing.derivatives.roller_slopes import numbers
    from flexbearing.derivatives.roller_state import solved
    from flexbearing.derivatives.rollers import requested_of

    step = 5e-6 * load
    found = []
    for at in (load - step, load + step):
        case = rigid_case(f"operation.radial_load={at!r} N")
        found.append(numbers(solved(case), requested_of(case, ["stiffness_zz"]), aligned=True)[0])
    return (found[1] - found[0]) / (2 * step)


@pytest.mark.slow
def test_where_a_slice_opens_both_sides_are_given():
    load = at_a_contact_switch(0.0)
    case = rigid_case(f"operation.radial_load={load!r} N")
    slope = sensitivities(case, ["stiffness_zz"], ["operation.radial_load"])[
        "stiffness_zz", "operation.radial_load"
    ]
    assert slope.one_sided
    below, above = (
        stiffness_by_load_at(load * (1 + sign * BEYOND * slope.key.relative_step)) for sign in (-1, 1)
    )
    assert slope.below == approx(below, rel=1e-3)
    assert slope.above == approx(above, rel=1e-3)
    assert abs(slope.above - slope.below) > 0.1 * abs(slope.below)


@pytest.mark.slow
def test_reach_is_a_hundredth_of_a_percent():
    load = at_a_contact_switch(0.0)
    far = sensitivities(
        rigid_case(f"operation.radial_load={load * (1 + 3 * REACH * 1e-6)!r} N"),
        ["life"], ["operation.radial_load"],
    )  # fmt: skip
    assert not far["life_L10", "operation.radial_load"].one_sided


def test_output_that_jumps_has_no_derivative_and_it_is_told():
    found = sensitivities(rigid_case(), ["life"], ["operation.outer_speed"])  # the ring begins to turn
    assert found.left_out == (("operation.outer_speed", "there is a jump of life_L10"),)
    assert found.by_output["life_L10"] == ()


def test_key_at_its_limit_is_differentiated_to_the_other_side():
    case = rigid_case("lubricant.oil_fraction=1")
    slope = sensitivities(case, ["cage_slip"], ["lubricant.oil_fraction"])[
        "cage_slip", "lubricant.oil_fraction"
    ]
    assert slope.below == approx(slope.slope, rel=1e-12)
    assert np.isnan(slope.above)
    inside = sensitivities(
        rigid_case("lubricant.oil_fraction=0.9999"), ["cage_slip"], ["lubricant.oil_fraction"]
    )
    assert slope.slope == approx(inside["cage_slip", "lubricant.oil_fraction"].slope, rel=1e-3)


def test_life_is_even_in_the_misalignment_of_a_straight_shaft():
    found = sensitivities(rigid_case(), ["life", "max_roller_load"], ["operation.misalignment"])
    assert found["life_L10", "operation.misalignment"].slope * 1e-3 == approx(
        0.0, abs=1e-6
    )  # by a milliradian


def test_elastic_ring_moves_with_the_bearing():
    settings = [*BEAM, "operation.temperatures="]
    found = sensitivities(
        api.read_case(PAPER, settings), OUTPUTS, ["operation.radial_load", "bearing.clearance"]
    )
    assert found.raceways == "flexible rings"
    for key in ("operation.radial_load", "bearing.clearance"):
        again = solved_again(settings, key, step=2e-6)
        slopes = np.array([found[name, key].slope for name in OUTPUTS])
        values = np.array([output.value for output in found.outputs])
        floor = 1e-2 * np.abs(values) / KEYS[key][0]
        assert (np.abs(slopes - again) <= 1e-5 * np.maximum(np.abs(again), floor)).all()


RING_KEYS = {  # value in the paper's case, and unit
    "outer.thickness": (3.6, "mm"),
    "outer.width": (10.0, "mm"),
    "materials.outer_ring.youngs_modulus": (203.0, "GPa"),
    "bearing.outer_raceway_diameter": (75.0, "mm"),
}


@pytest.mark.slow
def test_dimensions_of_a_flexible_ring_move_what_runs_with_them_do():
    settings = [*BEAM, "operation.temperatures=", "accuracy.harmonics=110"]  # else their number jumps
    found = sensitivities(api.read_case(PAPER, settings), OUTPUTS, list(RING_KEYS))
    for key, (value, unit) in RING_KEYS.items():
        ends = [fb.run(PAPER, [*settings, f"{key}={value * (1 + sign * 2e-5)!r} {unit}"]) for sign in (-1, 1)]
        low, high = (np.array([end[name].number for name in OUTPUTS]) for end in ends)
        slopes = np.array([found[name, key].elasticity for name in OUTPUTS])
        assert slopes == approx((high - low) / 4e-5 / (high + low) * 2, rel=1e-4, abs=1e-6), key


def test_ring_that_grows_with_everything_else_is_as_stiff_as_it_is_large():
    """Elasticities of a raceway by all lengths together are one: [m/N] of [Pa] and [m]."""
    from flexbearing.derivatives.ring_slopes import RingSlopes, numbers, with_numbers
    from flexbearing.derivatives.roller_state import solved

    slopes: RingSlopes = solved(api.read_case(PAPER, BEAM)).near.slopes["outer"]
    lengths = {name: value for name, value in numbers(slopes.shape).items() if value < 1}
    larger = with_numbers(
        slopes.shape, {name: 1.001 * value for name, value in lengths.items() if "ratio" not in name}
    )
    stiffer = with_numbers(slopes.shape, {"part.elastic.youngs_modulus": 203e9 * 1.001})
    for shape in (larger, stiffer):
        assert slopes.near(shape).absolute == approx(0.999 * slopes.raceway.absolute, rel=1e-6, abs=1e-16)


def test_key_that_no_ring_knows_leaves_raceways_as_they_are_to_the_last_digit():
    """Cases between raceways of one compliance are evaluated side by side."""
    from flexbearing.derivatives.keys import key_of
    from flexbearing.derivatives.roller_state import solved

    state = solved(api.read_case(PAPER, ["accuracy.structure=beam"]))
    pair = state.variant(key_of(state.base.case, "materials.roller.density"), 1.0).pair
    assert pair.inner.absolute is state.base.pair.inner.absolute
    assert pair.outer.absolute is state.base.pair.outer.absolute


def test_ring_that_has_no_room_to_change_is_told():
    case = api.read_case(PAPER, ["outer.kind=rigid", "inner.track_width=12 mm", "accuracy.structure=beam"])
    ((key, why),) = sensitivities(case, ["life"], ["inner.width"]).left_out  # ribs of no width
    assert key == "inner.width"
    assert "inside width" in why


@pytest.mark.parametrize(
    ("by", "words"),
    [
        ("bearing.clearence", "Did you mean clearance"),
        ("bearing.rollers", "does not hold a continuous value"),
        ("bearing.fits.shaft_interference", "is not given in this case"),
        ("accuracy.slices", "does not hold a continuous value"),
    ],
)
def test_key_without_derivatives_is_refused(by, words):
    with pytest.raises(BadCase, match=words):
        sensitivities(rigid_case(), ["life"], [by])


def test_case_with_a_target_is_refused():
    with pytest.raises(BadCase, match=r"accuracy.target chooses levels anew"):
        sensitivities(rigid_case("accuracy.target=1 %"), ["life"], ["operation.radial_load"])


def command(*words):
    return program.command(
        ["sensitivity", str(PAPER), *(word for each in RIGID for word in ("--set", each)), *words]
    )


def test_command_writes_a_table_and_a_picture(tmp_path, capsys):
    picture = tmp_path / "there" / "s.svg"
    assert command("--of", "life,cage_slip", "--by", "bearing.clearance", "-o", str(picture)) == 0
    said = capsys.readouterr().out
    assert "bearing.clearance" in said
    assert picture.read_text().startswith("<?xml")
    with picture.with_suffix(".csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["output"], row["key"], row["key_unit"]) for row in rows] == [
        ("life_L10", "bearing.clearance", "um"), ("cage_slip", "bearing.clearance", "um")
    ]  # fmt: skip
    assert float(rows[0]["elasticity"]) == approx(
        float(rows[0]["derivative"]) * float(rows[0]["key_value"]) / float(rows[0]["value"]), rel=1e-9
    )


def test_command_prints_json(capsys):
    assert command("--of", "life", "--by", "bearing.clearance", "--json") == 0
    (found,) = json.loads(capsys.readouterr().out)["derivatives"]
    assert (found["output"], found["one_sided"], found["derivative_below"]) == ("life_L10", False, None)


@pytest.mark.parametrize("case", ["mao2016", "6209"])
def test_a_person_hears_how_many_keys_are_done(case):
    settings = RIGID[:2] if case == "mao2016" else ()
    heard = []

    class Ear(Silent):
        def stage(self, text, fraction):
            heard.append((text, fraction))

    keys = ["bearing.clearance", "operation.inner_speed"]
    api.sensitivities(api.read_case(CONFIGS / f"{case}.toml", settings), ["life"], keys, Ear())
    assert heard == [("derivatives by 2 keys", done) for done in (0.0, 0.5, 1.0)]


def test_command_refuses_a_picture_of_no_known_form(capsys):
    assert command("-o", "tornado.jpg") == 2
    assert "its name ends in .png, .svg, .pdf" in capsys.readouterr().err


def unreachable():
    raise AssertionError("derivatives are imported and solved for")


@pytest.mark.parametrize("name", ["mao2016", "6209"])
@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--of", "max_bearing_load"), "--of 'max_bearing_load': no output has this name."),
        (("--of", "stiffness_zz [mm]"), "is a unit of another kind"),
        (("--by", "bearing.clearence"), "Did you mean clearance"),
    ],
)
def test_command_refuses_unknown_names_in_a_line_before_anything_is_solved(
    name, words, said, capsys, monkeypatch
):
    for kind, family in FAMILIES.items():
        if family.sensitivities:
            monkeypatch.setitem(FAMILIES, kind, replace(family, sensitivities=unreachable))
    assert program.command(["sensitivity", str(CONFIGS / f"{name}.toml"), *words]) == 2
    told = capsys.readouterr().err
    assert said in told
    assert told.count("\n") == 1
    assert len(told) < 400


def test_chart_draws_bars_of_both_senses_and_marks_both_sides(of_rigid):
    figure = draw_tornado(of_rigid)
    bars = [bar for bar in figure.axes[0].patches if np.isfinite(bar.get_width())]
    assert {np.sign(bar.get_width()) for bar in bars} == {-1.0, 1.0}
    for axes, slopes in zip(figure.axes, of_rigid.by_output.values(), strict=False):
        labels = [label.get_text() for label in axes.get_yticklabels()]
        assert labels[0].startswith(slopes[0].key.path)  # the strongest of its own panel
    top = min(bars, key=lambda bar: bar.get_y())
    assert abs(top.get_width()) == max(abs(bar.get_width()) for bar in bars)


def test_keys_apart_from_rings_leave_them_as_they_are():
    from flexbearing.derivatives.keys import given_keys, with_value
    from flexbearing.derivatives.roller_state import APART_FROM_RINGS, solved
    from flexbearing.progress import Logged
    from flexbearing.rings.condensed import condensed_raceways

    state = solved(api.read_case(PAPER, BEAM))
    apart = [key for key in given_keys(state.base.case) if key.path.startswith(APART_FROM_RINGS)]
    assert len(apart) > 8
    for key in apart:
        case = with_value(state.base.case, key.path, key.value * 1.1 + key.step)
        pair = condensed_raceways(case, state.base.model.bearing.azimuths, Logged()).linearised(state.forces)
        assert np.array_equal(pair.outer.absolute, state.base.pair.outer.absolute)
        assert np.array_equal(pair.outer.initial_deviation, state.base.pair.outer.initial_deviation)
