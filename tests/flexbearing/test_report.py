import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from flexbearing.families import FAMILIES
from flexbearing.quantities.reductions import loaded_arc, loaded_rollers
from flexbearing.report.figure import Rule
from flexbearing.report.html.figures import around, convergence, deviations
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import METRIC
from flexbearing.report.output import pictures, text, write_figures
from flexbearing.report.panels import picture
from flexbearing.report.picture import Format, LeftOut, picture_bytes
from flexbearing.report.roller.pressure_figures import pressure_along
from flexbearing.results import Result

ROLLERS, SLICES = 30, 4
PITCH = 2 * np.pi / ROLLERS
AZIMUTH = PITCH * np.arange(ROLLERS)
LOSSES = {
    "sliding": 10,
    "rolling": 50,
    "drag": 9,
    "pocket": 3,
    "land": 2,
    "churning": 3,
    "ribs": 1,
    "transport": -1,
}
SLICE_POSITION = np.array([-1.5e-3, -0.5e-3, 0.5e-3, 1.5e-3])


def loads(largest, spread):
    """Static load distribution, with its loaded zone set by the spread."""
    return largest * np.clip(1 - (1 - np.cos(AZIMUTH)) / (2 * spread), 0, None) ** (10 / 9)


def pressures(load):
    """Line contacts, tilted along the roller [Pa]."""
    return 3e7 * np.sqrt(load)[:, None] * (1 + SLICE_POSITION / 1e-2)


def deviation(size, tilt=0.0):
    """Ovalised raceway, tilted along the roller."""
    return size * np.cos(2 * AZIMUTH)[:, None] * (1 + tilt * SLICE_POSITION / 1e-3)


def block(largest=3537.0, spread=0.19, bending=0.0):
    return {
        "inner_load": loads(largest, spread),
        "outer_load": loads(largest, spread) + 92.0,
        "inner_pressure": pressures(loads(largest, spread)),
        "outer_pressure": pressures(loads(largest, spread) + 92.0),
        "inner_deviation": deviation(-0.2 * bending),
        "outer_deviation": deviation(bending, tilt=0.2),
        "roller_azimuth": AZIMUTH,
        "slice_position": SLICE_POSITION,
        "cage_speed": np.array(1700.0),
        "cage_slip": np.array(0.0628),
        "ring_displacement": np.array([1e-6, 60e-6]),
        "life_L10": np.array(2.5e9),
        "stiffness": np.array(7.7e8),
        "total_stiffness": np.array(1.2e8),
        "driving_torque": np.array(0.21),
        "peak_pressure": np.array([1.9e9, 1.7e9]),
        "minimum_film": np.array([0.31e-6, 0.36e-6]),
        "cage_force": np.where(np.arange(ROLLERS) == 7, -12.5, 3.0),
        "load_direction": np.array(0.0),
        "stiffness_matrix": np.diag([0.0, 3e8, 7e8, 2000.0, 500.0]),
        "compliance_matrix": np.diag([np.inf, 1 / 3e8, 1 / 7e8, 1 / 2000.0, 1 / 500.0]),
        "driving_power": np.array(77.0),
        **{f"loss_{cause}": np.array(float(watts)) for cause, watts in LOSSES.items()},
    }


NOTE = {
    "grade": "outside validity",
    "code": "traction-data",
    "text": "4109 regression used outside its calibration",
}


def history(count):
    sizes = 10.0 ** -np.arange(1, count + 1)
    return tuple({"load_change": np.array(size), "residual": np.array(size / 30)} for size in sizes)


def result(**changes):
    attributes = {
        "title": "squirrel cage of an aircraft engine",
        "status": "converged",
        "ending": "converged",
        "message": "load change below 1e-8",
        "case_si": {"bearing": {"roller": {}}, "operation": {}},
        "clearance": {"operating_m": 75.5e-6, "steps": []},
        "life": {},
        "tilt": {"inner_ring": "free"},
        "regimes": {},
        "method": "newton",
        "iterations": 5,
        "wall_time_s": 12.34,
        "assumed": ("bearing.cage.mass", "lubricant.name"),
        "calibrated": {"lubricant.oil_fraction": "cage slip of 6.28 % in the publication"},
        "notes": [NOTE],
    }
    attributes.update(changes.pop("attributes", {}))
    return Result(
        **{
            "path": Path("case.h5"),
            "family": FAMILIES["cylindrical_roller"],
            "attributes": attributes,
            "rigid": block(),
            "flexible": block(3035.0, 0.27, bending=14e-6),
            "iterations": history(5),
            **changes,
        }
    )


def rigid_only():
    return result(attributes={"iterations": 0}, flexible=block(), iterations=())


def rigid_alone():
    """The flexible state was not reached."""
    return result(attributes={"status": "not solved", "iterations": 0}, flexible={}, iterations=())


def result_without_iterations():
    return result(iterations=())


def unsolved():
    ending = {
        "status": "not solved",
        "ending": "stalled",
        "message": "no equilibrium",
        "iterations": 0,
    }
    return result(attributes=ending, rigid={}, flexible={}, iterations=())


def diverged():
    lost = block() | {"inner_load": np.full(ROLLERS, np.nan), "life_L10": np.array(np.inf)}
    lost["inner_pressure"] = np.full((ROLLERS, SLICE_POSITION.size), np.nan)
    steps = (*history(2), {"load_change": np.array(np.nan), "residual": np.array(np.inf)})
    return result(attributes={"status": "not finite", "iterations": 3}, flexible=lost, iterations=steps)


EVERY_ENDING = pytest.mark.parametrize(
    "run", [result, rigid_only, unsolved, diverged], ids=lambda run: run.__name__
)


# -- the loaded zone -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("loaded", "degrees"),
    [
        (range(-4, 5), 96.0),
        (range(6, 15), 96.0),
        (range(-2, 10), 132.0),
        (range(-14, 15), 336.0),
        (range(30), 360.0),
        ([3], 0.0),
        ([], 0.0),
        ([-5, -4, 4, 5], 120.0),
    ],
    ids=["around 0", "off the load line", "across 0", "all but one", "all", "one", "none", "two lobes"],
)
@pytest.mark.parametrize("branch", [0.0, -np.pi, 0.3], ids=["0..360", "-180..180", "turned"])
def test_loaded_arc_runs_from_the_first_to_the_last_loaded_roller(loaded, degrees, branch):
    load = np.zeros(ROLLERS)
    load[[index % ROLLERS for index in loaded]] = 100.0
    azimuth = (AZIMUTH + branch) % (2 * np.pi) + branch
    assert np.degrees(loaded_arc(azimuth, load)) == pytest.approx(degrees, rel=1e-12, abs=1e-9)


@pytest.mark.parametrize(
    ("one", "other", "degrees"),
    [(range(30), range(-5, 6), 360.0), (range(-2, 3), range(-5, 6), 120.0), ([3], [], 0.0), ([3], [3], 0.0)],
)
def test_loaded_arc_of_two_rows_is_that_of_both(one, other, degrees):
    load = np.zeros((2, ROLLERS))
    for row, loaded in enumerate((one, other)):
        load[row, [index % ROLLERS for index in loaded]] = 100.0
    assert np.degrees(loaded_arc(np.tile(AZIMUTH, 2), load.ravel())) == pytest.approx(degrees, abs=1e-9)


def test_loaded_arc_does_not_depend_on_the_order_of_the_rollers_or_on_whole_turns():
    turns = 2 * np.pi * (np.arange(ROLLERS) % 3 - 1)
    order = np.random.default_rng(7).permutation(ROLLERS)
    load = loads(3537.0, 0.19)
    assert loaded_arc((AZIMUTH + turns)[order], load[order]) == pytest.approx(
        loaded_arc(AZIMUTH, load), rel=1e-12
    )


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e6])
def test_a_roller_is_loaded_above_a_share_of_the_largest_load(size):
    assert loaded_rollers(size * np.array([0.0, 0.0149, 0.0151, 50.0])) == 2


# -- the JSON object -----------------------------------------------------------------------------


def test_summary_states_the_numbers_in_the_units_of_their_names():
    numbers = result().summary()
    flexible = numbers["flexible"]
    assert numbers["status"] == "converged"
    assert numbers["iterations"] == 5
    assert numbers["calibrated"] == {"lubricant.oil_fraction": "cage slip of 6.28 % in the publication"}
    assert flexible["max_roller_load_N"] == pytest.approx(3035.0, rel=1e-12)
    assert flexible["max_outer_load_N"] == pytest.approx(3127.0, rel=1e-12)
    assert (numbers["rigid"]["loaded_rollers"], flexible["loaded_rollers"]) == (9, 11)
    assert (numbers["rigid"]["loaded_arc_deg"], flexible["loaded_arc_deg"]) == (96.0, 120.0)
    assert flexible["roller_azimuths_deg"] == pytest.approx(list(range(0, 360, 12)), rel=1e-12)
    assert flexible["roller_loads_N"] == pytest.approx(loads(3035.0, 0.27), rel=1e-12)
    assert flexible["cage_slip_percent"] == pytest.approx(6.28, rel=1e-12)
    assert flexible["cage_speed_rpm"] == pytest.approx(1700 * 60 / (2 * np.pi), rel=1e-12)
    assert flexible["ring_displacement_um"] == pytest.approx([1.0, 60.0], rel=1e-12)
    assert flexible["life_L10_Mrev"] == pytest.approx(2500.0, rel=1e-12)
    assert flexible["stiffness_N_per_m"] == pytest.approx(7.7e8, rel=1e-12)
    assert flexible["peak_pressure_MPa"] == pytest.approx({"inner": 1900.0, "outer": 1700.0}, rel=1e-12)
    assert flexible["minimum_film_um"] == pytest.approx({"inner": 0.31, "outer": 0.36}, rel=1e-12)


def test_losses_are_told_by_cause_and_add_up():
    flexible = result().summary()["flexible"]
    assert flexible["power_loss_W"] == {**LOSSES, "total": 77.0}
    assert flexible["driving_power_W"] == 77.0
    page = text(result())
    assert row(page, "power lost by sliding") == ["10.00", "10.00", "W", "0.0"]
    assert row(page, "discretisation residual") == ["-1.00", "-1.00", "W"]
    assert row(page, "total") == row(page, "driving power") == ["77.00", "77.00", "W", "0.0"]


def test_largest_pocket_force_counts_either_way():
    assert result().summary()["flexible"]["max_pocket_force_N"] == 12.5
    assert row(text(result()), "largest pocket force") == ["12.50", "12.50", "N", "0.0"]


def test_displacements_are_told_along_and_across_the_load():
    turned = block() | {"load_direction": np.array(np.pi / 2), "ring_displacement": np.array([60e-6, 1e-6])}
    flexible = result(flexible=turned).summary()["flexible"]
    assert flexible["displacement_along_load_um"] == pytest.approx(60.0, rel=1e-12)
    assert flexible["displacement_across_load_um"] == pytest.approx(-1.0, rel=1e-12)
    assert row(text(result(flexible=turned)), "ring displacement along load") == [
        "60.00",
        "60.00",
        "um",
        "0.0",
    ]


def test_stiffness_and_compliance_are_told_and_nothing_infinite_is_a_number():
    flexible = result().summary()["flexible"]
    assert flexible["stiffness_matrix_SI"][2][2] == 7e8
    assert flexible["compliance_matrix_SI"][0][0] is None
    page = text(result())
    rows = [line.split() for line in page.splitlines() if line.startswith(" z ")]
    assert [words[3] for words in rows] == ["7.000e+08", "1.429e-09"]
    assert "tangent compliance [m, rad, N]; infinite along x" in page


def test_film_ratios_are_those_of_loaded_contacts():
    inner, outer = np.full(ROLLERS, 1.5), np.full(ROLLERS, 3.5)
    inner[[3, 4]] = 1.2, 0.0  # the second carries nothing
    ratios = {"inner_film_ratio": inner, "outer_film_ratio": outer}
    words = {"flexible": {"inner": "mixed", "outer": "full film"}}
    run = result(flexible=block() | ratios, attributes={"regimes": words})
    numbers = run.summary()
    assert numbers["flexible"]["minimum_lambda"] == {"inner": 1.2, "outer": 3.5}
    assert numbers["flexible"]["lambda_ratios"]["inner"] == list(inner)
    assert numbers["rigid"]["minimum_lambda"] is None
    assert row(text(run), "smallest film ratio, inner") == ["-", "1.20"]
    assert row(text(run).split("lubrication ")[-1], "flexible") == ["mixed", "full", "film"]
    assert "film ratio" not in text(result())


def test_clearance_is_told_step_by_step():
    steps = [
        {"name": "inner fit", "change_m": -70e-6, "clearance_m": -10e-6, "explanation": "mounted; tight"},
    ]
    clearance = {
        "operating_m": -10e-6,
        "cold_m": 60e-6,
        "steps": steps,
        "shaft_fit": "fit pressure 60 MPa",
        "housing_fit": "free ring, no housing",
        "verdict": "the bearing is preloaded: the rollers interfere by 10.000 um diametral",
    }
    page = text(result(attributes={"clearance": clearance}))
    assert row(page, "before mounting") == ["60.0"]
    assert row(page, "inner fit") == ["-70.00", "-10.0", "mounted;", "tight"]
    for words in (clearance["verdict"], "shaft: fit pressure 60 MPa", "housing: free ring, no housing"):
        assert words in page
    assert "step by step" not in text(result())


def test_every_life_factor_is_told_with_its_note():
    def life(film):
        factors = [
            {"name": "film", "value": film, "effect": "lubrication", "note": f"smallest film ratio {film}"},
            {"name": "a_1", "value": 0.25, "effect": "reliability", "note": "reliability 0.99"},
        ]
        return {"basic_Mrev": 2500.0, "factors": factors, "modified_Mrev": 2500.0 * film * 0.25}

    lives = {"rigid": life(1.5), "flexible": life(2.0)}
    modified = {"flexible": block() | {"modified_life": np.array(1.25e9)}}
    page = text(result(**modified, attributes={"life": lives}))
    rigid, flexible = page.split("modified life, ")[1:]
    for table, film in ((rigid, "1.5"), (flexible, "2")):
        assert row(table, "film") == [film, "smallest", "film", "ratio", str(float(film))]
        assert row(table, "a_1") == ["0.25", "reliability", "0.99"]
    assert result(**modified).summary()["flexible"]["modified_life_Mrev"] == pytest.approx(1250.0, rel=1e-12)


def test_largest_deviation_is_given_at_mid_roller_and_at_the_roller_ends_apart():
    flexible = result().summary()["flexible"]
    assert flexible["mid_roller_deviation_um"] == pytest.approx(14.0, rel=1e-12)
    assert flexible["roller_end_deviation_um"] == pytest.approx(14.0 * 1.4, rel=1e-12)  # tilted, 2 mm away


def test_largest_deviation_is_taken_over_both_raceways():
    inward = block() | {"inner_deviation": np.full((ROLLERS, SLICES), -20e-6)}
    flexible = result(flexible=inward).summary()["flexible"]
    assert flexible["mid_roller_deviation_um"] == pytest.approx(20.0, rel=1e-12)
    assert flexible["roller_end_deviation_um"] == pytest.approx(20.0, rel=1e-12)


@EVERY_ENDING
def test_summary_is_strict_json(run):
    numbers = run().summary()
    assert json.loads(json.dumps(numbers, allow_nan=False)) == numbers


def test_numbers_that_are_not_finite_are_missing_instead_of_wrong():
    flexible = diverged().summary()["flexible"]
    for name in ("max_roller_load_N", "loaded_rollers", "loaded_arc_deg", "life_L10_Mrev"):
        assert flexible[name] is None
    assert flexible["roller_loads_N"] == [None] * ROLLERS


def test_numbers_that_are_nowhere_finite_keep_their_row():
    lost = block() | {"inner_load": np.full(ROLLERS, np.nan)}
    assert row(text(result(rigid=lost, flexible=lost)), "largest roller load, inner") == ["-", "-", "N"]


def test_blocks_that_were_never_solved_are_none():
    numbers = unsolved().summary()
    assert numbers["rigid"] is None
    assert numbers["flexible"] is None


# -- the text ------------------------------------------------------------------------------------


def row(page, label):
    (line,) = [line for line in page.splitlines() if line.strip().startswith(label)]
    return line.strip().removeprefix(label).split()


def test_text_sets_rigid_beside_flexible_with_the_change():
    page = text(result())
    assert row(page, "largest roller load, inner") == ["3,537", "3,035", "N", "-14.2"]
    assert row(page, "loaded rollers") == ["9", "11", "+22.2"]
    assert row(page, "raceway deviation, mid-roller") == ["0.00", "14.00", "um"]
    assert row(page, "raceway deviation, roller ends") == ["0.00", "19.60", "um"]
    assert row(page, "stiffness of the bearing") == ["770.0", "770.0", "kN/mm", "0.0"]


def test_text_of_rigid_rings_has_one_column():
    words = {"rigid": {"inner": "mixed", "outer": "full film"}, "flexible": {"inner": "x", "outer": "x"}}
    about = {**rigid_only().attributes, "regimes": words, "structure": {}}
    page = text(replace(rigid_only(), attributes=about))
    assert row(page, "largest roller load, inner") == ["3,537", "N"]
    assert row(page.split("lubrication ")[-1], "rigid") == ["mixed", "full", "film"]


def test_a_number_that_rounds_to_zero_has_no_sign_and_no_change():
    rigid, flexible = (block() | {"cage_slip": np.array(slip)} for slip in (-1e-7, 3e-7))
    assert row(text(result(rigid=rigid, flexible=flexible)), "cage slip") == ["0.00", "0.00", "%"]


def test_error_of_the_cage_slip_is_a_slip_and_that_of_a_load_a_share():
    estimate = {"target": 0.01, "met": True, "cage_slip": 0.001, "roller_load": 0.002}
    page = text(result(attributes={"choices": {}, "error_estimate": estimate}))
    assert row(page, "cage slip") == ["6.28", "6.28", "%", "0.1", "0.0"]
    assert row(page, "largest roller load, inner") == ["3,537", "3,035", "N", "0.2", "-14.2"]


@EVERY_ENDING
def test_text_fits_a_log_file(run):
    page = text(run())
    assert "\x1b" not in page
    assert max(map(len, page.splitlines())) <= 80


def test_text_names_what_was_assumed_fitted_and_left_its_range():
    page = text(result())
    for words in (
        "bearing.cage.mass",
        "lubricant.name",
        "lubricant.oil_fraction: cage slip of 6.28 %",
        "4109 regression used outside its calibration",
    ):
        assert words in page


@pytest.mark.parametrize(
    ("run", "words"),
    [
        (result, "converged in 5 iterations, 12.3 s"),
        (rigid_only, "converged: load change below 1e-8, 12.3 s"),
        (
            unsolved,
            "NOT CONVERGED: not solved (stalled) after 0 iterations, 12.3 s: no equilibrium",
        ),
        (diverged, "NOT CONVERGED: not finite after 3 iterations, 12.3 s: load change below 1e-8"),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)
def test_last_line_says_how_the_run_ended(run, words):
    assert text(run()).splitlines()[-1] == words


def test_iteration_limit_never_reads_as_converged():
    page = text(result(attributes={"status": "iteration limit", "iterations": 1, "message": ""}))
    assert page.splitlines()[-1] == "NOT CONVERGED: iteration limit after 1 iteration, 12.3 s"


# -- the pictures --------------------------------------------------------------------------------


def line(figure, beginning):
    (found,) = [each for each in figure.items if each.__dict__.get("name", "").startswith(beginning)]
    return found


def words(figure):
    figure.draw_without_rendering()
    return " ".join(each.get_text() for each in figure.findobj(lambda artist: hasattr(artist, "get_text")))


def loads_around(run):
    return around(Reader(run, METRIC), "contact load", ("inner_load",), "roller_azimuth")


def test_figure_of_loads_shows_both_distributions_around_the_ring():
    figure = loads_around(result())
    for name, largest, spread in (("rigid", 3537.0, 0.19), ("flexible", 3035.0, 0.27)):
        found = line(figure, f"inner load, {name}")
        assert (found.x[0], found.x[-1]) == pytest.approx((-192.0, 180.0), rel=1e-9)  # no gap at the edges
        stored = np.interp(
            np.radians(found.x) % (2 * np.pi), [*AZIMUTH, 2 * np.pi], [*loads(largest, spread), largest]
        )
        assert [value or 0.0 for value in found.y] == pytest.approx(stored, rel=6e-6, abs=1e-6)


@pytest.mark.parametrize(("direction", "degrees"), [(0.0, 0.0), (np.pi / 2, 90.0)])
def test_load_is_marked_at_its_azimuth(direction, degrees):
    figure = loads_around(result(flexible=block() | {"load_direction": np.array(direction)}))
    (mark,) = [item for item in figure.items if isinstance(item, Rule)]
    assert (mark.word, mark.at) == ("load", pytest.approx(degrees, abs=1e-9))


def test_convergence_shows_both_histories():
    figure = convergence(Reader(result(), METRIC))
    assert figure.y.scale == "log"
    change = line(figure, "largest change")
    assert change.x == [1, 2, 3, 4, 5]
    assert change.y == pytest.approx([1e-1, 1e-2, 1e-3, 1e-4, 1e-5], rel=1e-12)
    assert line(figure, "largest unbalanced").y == pytest.approx(np.array(change.y) / 30, rel=1e-5)


def test_zeros_on_the_logarithmic_axis_stand_below_everything_else():
    steps = (*history(3), {"load_change": np.array(0.0), "residual": np.array(2e-9)})
    figure = convergence(Reader(result(iterations=steps), METRIC))
    zero = line(figure, "exactly zero")
    assert zero.x == [4]
    assert zero.y == pytest.approx([2e-10], rel=1e-12)
    assert line(figure, "largest change").y[3] is None


def test_a_run_of_zeros_only_can_be_drawn():
    steps = ({"load_change": np.array(0.0), "residual": np.array(0.0)},)
    figure = convergence(Reader(result(iterations=steps), METRIC))
    picture("t", "w", [figure]).draw_without_rendering()


def test_convergence_marks_the_iteration_that_was_lost():
    assert line(convergence(Reader(diverged(), METRIC)), "not finite").at == 3


def test_deviations_are_those_at_mid_roller_around_the_ring():
    figure = deviations(Reader(result(), METRIC))
    outer = line(figure, "outer")
    degrees = np.array(outer.x)
    assert np.all(np.diff(degrees) > 0)
    assert (degrees[0], degrees[-1]) == pytest.approx((-192.0, 180.0), rel=1e-9)  # no gap at the edges
    expected = 14.0 * np.cos(2 * np.radians(degrees))
    assert outer.y == pytest.approx(expected, rel=2e-5, abs=1e-9)
    assert line(figure, "inner").y == pytest.approx(-0.2 * expected, rel=2e-5, abs=1e-9)


def test_loads_of_rigid_rings_are_one_line():
    (found,) = loads_around(replace(rigid_only(), flexible={})).lines
    assert found.name == "inner load"


EMPTY = {
    rigid_only: ["convergence: no part is flexible, so no iterations",
                 "raceway_deviation: no part is flexible"],
    rigid_alone: ["convergence: no iterations",
                  "raceway_deviation: the flexible state was not solved"],
    result_without_iterations: ["convergence: the result contains no iterations"],
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("run", EMPTY, ids=lambda run: run.__name__)
def test_empty_pictures_are_left_out_with_a_reason(run, tmp_path):
    left_out = [picture for picture in pictures(run(), tmp_path) if isinstance(picture, LeftOut)]
    assert [str(picture) for picture in left_out] == [f"case_{words}" for words in EMPTY[run]]
    assert len(list(tmp_path.iterdir())) == 5 - len(left_out)


@pytest.mark.slow
@EVERY_ENDING
def test_every_ending_can_be_drawn(run, tmp_path):
    paths = write_figures(run(), tmp_path / "new" / "figures")
    drawn = {
        unsolved: (),
        rigid_only: ("roller_loads", "pressure_map", "pressure_along"),
    }.get(run, ("roller_loads", "convergence", "raceway_deviation", "pressure_map", "pressure_along"))
    assert [path.name for path in paths] == [f"{run().path.stem}_{name}.png" for name in drawn]
    for path in paths:
        assert path.read_bytes().startswith(b"\x89PNG")


@pytest.mark.slow
@pytest.mark.parametrize(("form", "start"), [("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF")])
def test_pictures_are_written_as_asked_and_the_same_twice(form, start):
    one, other = (picture_bytes(picture("t", "w", [loads_around(result())]), Format(form)) for _ in range(2))
    assert one.startswith(start)
    assert one == other


def test_pictures_without_titles_keep_everything_else():
    figure = pressure_along({"rigid rings": block()}, "squirrel cage of an aircraft engine")
    assert "aircraft" in words(figure)
    bare = picture_bytes(figure, Format("svg", titles=False)).decode()
    assert "<!-- inner raceway, largest" in bare
    assert "aircraft" not in bare


def test_importing_the_report_does_not_load_matplotlib():
    code = "import sys, flexbearing.report; sys.exit('matplotlib' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_grids_lie_below_the_curves_and_ticks_separate_thousands():
    heavy = block() | {"inner_pressure": np.full((ROLLERS, SLICES), 3e9)}
    figure = pressure_along({"rigid rings": heavy}, "title")
    assert "3,000" in words(figure)
    assert all(axes.get_axisbelow() is True for axes in figure.axes)
    assert "3,000" in words(picture("t", "w", [loads_around(result())]))
