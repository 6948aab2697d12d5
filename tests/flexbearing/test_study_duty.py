"""Duty cycles: life under a load spectrum by the rule of Palmgren and Miner, against calculations by hand."""

import re
from dataclasses import replace
from math import inf, isnan, nan, pi

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import check
from flexbearing.case import BadCase
from flexbearing.findings import row as row_findings
from flexbearing.life import ball_lives, roller_influences
from flexbearing.studies.file.spectrum import Spectrum
from flexbearing.studies.idle import LEAST_FACTOR
from flexbearing.studies.plan import Row
from flexbearing.studies.prepare import prepare_source
from flexbearing.studies.table import Table
from flexbearing.studies.table.duty import Conditions, Cycles, texts
from flexbearing.studies.table.files import csv_bytes
from quasidynamic.outcome.life import basic_life, raceway_lives
from quasidynamic.outcome.life_factors import (
    BALLS as BALLS_OF_ISO,
    ROLLERS as ROLLERS_OF_ISO,
    modification_factor,
)
from quasidynamic.outcome.load_spectrum import cumulated_life, revolution_shares, time_shares
from tests.bearings import paper_bearing
from tests.flexbearing.toy_studies import CASE

LOADS = "50 N", "100 N", "2 kN", "5 kN", "8 kN", "10 kN", "12 kN", "15 kN"
SPEEDS = 14000, 12000, 6000, 4000, 3000, 2500, 2000, 1500  # [rpm]
TIMES = 5, 10, 15, 20, 20, 15, 10, 5  # [%]


def study_of(folder, text, name="cycle"):
    file = folder / f"{name}.toml"
    file.write_text(f'case = "{CASE}"\n{text}')
    return file


@pytest.fixture(scope="module")
def cycle(tmp_path_factory):
    folder = tmp_path_factory.mktemp("cycle")
    rows = zip(TIMES, LOADS, SPEEDS, strict=True)
    lines = [f"{time},{load},{speed}" for time, load, speed in rows]
    table = "\n".join(["time [%],operation.radial_load,operation.inner_speed [rpm]", *lines])
    (folder / "spectrum.csv").write_text(table)
    file = study_of(folder, '[duty]\nfile = "spectrum.csv"\n[collect]\nslip = "cage_slip [%]"')
    return flexbearing.study(file, folder, jobs=1)


@pytest.mark.slow
def test_eight_rows_against_a_calculation_by_hand(cycle):
    """Lives of single runs; two rows under light load skid by more than half."""
    lives = {name: [] for name in ("life_L10_Mrev", "inner", "outer")}
    for load, speed in zip(LOADS, SPEEDS, strict=True):
        settings = {"operation.radial_load": load, "operation.inner_speed": f"{speed} rpm"}
        summary = flexbearing.run(CASE, settings).summary()["flexible"]
        lives["life_L10_Mrev"].append(summary["life_L10_Mrev"])
        for race in ("inner", "outer"):
            lives[race].append(summary["raceway_life_Mrev"][race])
    turned = [time / 100 * speed for time, speed in zip(TIMES, SPEEDS, strict=True)]  # [1/min]
    mean = sum(turned)
    assert sum(slip > 50 for slip in cycle["slip"].values) == 2
    columns = {"life_L10_Mrev": "", "inner": "inner_", "outer": "outer_"}
    for name, words in columns.items():
        harm = [turns / mean / life for turns, life in zip(turned, lives[name], strict=True)]
        million = 1 / sum(harm)
        assert cycle.cycles[f"{words}revolutions"].values[0] == approx(million, rel=1e-6)
        assert cycle.cycles[f"{words}life [h]"].values[0] == approx(1e6 * million / (60 * mean), rel=1e-6)
        shares = [100 * each * million for each in harm]
        assert cycle[f"{words}damage_share"].values == approx(shares, rel=1e-6)
    assert cycle.cycles["mean_speed"].values[0] == approx(mean, rel=1e-12)
    assert cycle["time_share"].values == approx(TIMES, rel=1e-12)
    assert sum(cycle["revolution_share"].values) == approx(100, rel=1e-12)


def test_the_lives_of_the_cycle_stand_in_files_and_words(cycle):
    from flexbearing.studies import messages

    words = "\n".join(messages.cycles(cycle.cycles))
    assert f"duty cycle: basic L10 life {cycle.cycles['life [h]'].values[0]:.6g} h; " in words
    assert cycle.cycles.name == "cycle_duty"
    assert cycle.cycles.to_xarray()["life"].shape == ()


@pytest.mark.slow
def test_shares_of_revolutions_give_the_same_life(cycle, tmp_path):
    shares = ", ".join(map(str, cycle["revolution_share"].values))
    speeds = ", ".join(f'"{speed} rpm"' for speed in SPEEDS)
    loads = ", ".join(f'"{load}"' for load in LOADS)
    file = study_of(
        tmp_path,
        f'[duty]\nrevolutions = [{shares}]\n"operation.radial_load" = [{loads}]\n'
        f'"operation.inner_speed" = [{speeds}]',
    )
    other = flexbearing.study(file, tmp_path, jobs=1).cycles
    for column in ("life [h]", "inner_life [h]", "outer_life [h]", "mean_speed"):
        assert other[column].values[0] == approx(cycle.cycles[column].values[0], rel=1e-12)


def test_a_cycle_has_a_life_for_each_other_variant(tmp_path):
    duty = '[duty]\ntime = [1, 3]\n"operation.radial_load" = ["5 kN", "10 kN"]\n'
    duty += '[collect]\nlife = "life_L10 [Mrev]"'
    file = study_of(tmp_path, f'[over]\n"bearing.clearance" = ["20 um", "40 um"]\n{duty}')
    table = flexbearing.study(file, tmp_path, jobs=1)
    assert table.cycles["bearing.clearance"].values == (20.0, 40.0)
    lives = np.reshape(table["life"].values, (2, 2))
    assert table.cycles["revolutions"].values == approx(
        1 / (0.25 / lives[:, 0] + 0.75 / lives[:, 1]), rel=1e-9
    )
    assert (tmp_path / "cycle_duty.csv").read_text().startswith("bearing.clearance [um],life [h],")


SPECTRUM = Spectrum("time", (0.25, 0.25, 0.5), "life_L10")


def cycles(*lives, speed=100.0, spectrum=SPECTRUM):
    names = texts(spectrum).values()
    rows = [
        Row(str(life), "not solved" if life is None else "converged", "", 1.0,
            {} if life is None else dict.fromkeys(names, life))
        for life in lives
    ]  # fmt: skip
    return Cycles(spectrum, np.full((1, len(rows)), speed), [rows])


def test_the_error_of_a_cycle_is_that_of_its_rows_by_their_damage():
    """Row 3 does no damage, and may have no estimate."""
    lives, errors, turned = (2.0, 8.0, inf), (1.0, 4.0, nan), (0.25, 0.25, 0.5)
    found = cycles(*lives)
    name = f"{texts(SPECTRUM)['']} error"
    rows = [
        replace(row, values={**row.values, name: error})
        for row, error in zip(found.rows[0], errors, strict=True)
    ]
    estimated = replace(found, rows=[rows], errors=(name,))
    harm = [turns / life for turns, life in zip(turned, lives, strict=True)]
    expected = (harm[0] * 1.0 + harm[1] * 4.0) / sum(harm)
    assert column(estimated.of_cycles(), "life error [%]") == approx([expected], rel=1e-14)
    step = 1e-6  # of the errors: the change of the life when every row errs by that much, to one side
    higher = cycles(*(life * (1 + step * error) for life, error in zip(lives, (1.0, 4.0, 0.0), strict=True)))
    one, other = (column(each.of_cycles(), "life [h]")[0] for each in (found, higher))
    assert (other / one - 1) / step == approx(expected, rel=1e-5)
    assert "life error [%]" not in [each.heading for each in found.of_cycles()]


def column(columns, heading):
    return next(each.values for each in columns if each.heading == heading)


def test_a_row_without_load_does_no_damage():
    found = cycles(2.0, inf, 4.0)
    assert column(found.of_cycles(), "revolutions [Mrev]") == approx([1 / (0.25 / 2 + 0.5 / 4)], rel=1e-15)
    assert column(found.of_rows(), "damage_share [%]") == approx([50.0, 0.0, 50.0], rel=1e-15)


def test_a_cycle_without_any_load_lasts_for_ever():
    found = cycles(inf, inf, inf)
    assert column(found.of_cycles(), "life [h]") == (inf,)
    assert all(isnan(share) for share in column(found.of_rows(), "damage_share [%]"))


def test_a_cycle_without_any_load_has_no_damage_and_no_infinite_cells():
    found = Table("cycle", tuple(cycles(inf, inf, inf).of_cycles()), ())
    assert found["status"].values == ("no damage",)
    heads, cells = (line.split(",") for line in csv_bytes(found).decode().splitlines())
    assert dict(zip(heads, cells, strict=True))["life [h]"] == ""
    assert "inf" not in cells


def test_a_row_without_an_answer_is_left_out_and_its_share_stands_beside_the_life():
    found = list(cycles(2.0, None, 4.0).of_cycles())
    assert column(found, "revolutions [Mrev]") == approx([1 / (0.25 / 2 + 0.5 / 4)], rel=1e-15)
    assert column(found, "left_out_time_share [%]") == approx([25.0], rel=1e-14)
    assert column(found, "left_out_revolution_share [%]") == approx([25.0], rel=1e-14)
    assert column(found, "status") == ("rows left out",)
    assert column(found, "message") == ("left out: row 2, 25 % of the time",)


def test_a_cycle_of_rows_without_an_answer_has_no_life():
    found = list(cycles(None, inf, None).of_cycles())
    assert isnan(column(found, "life [h]")[0])
    assert column(found, "status") == ("no row solved",)


def bounded(loads, others=(0, 0, 0)):
    return replace(
        cycles(2.0, None, 4.0), conditions=Conditions(np.array(loads, dtype=float)[:, None], np.array(others))
    )


def test_the_damage_of_a_row_without_an_answer_is_that_of_the_next_higher_load():
    found = bounded([9.0, 5.0, 7.0])
    columns = list(found.of_cycles())
    assert column(columns, "revolutions [Mrev]") == approx([1 / (0.25 / 2 + 0.75 / 4)], rel=1e-15)
    assert column(columns, "bounded_time_share [%]") == approx([25.0], rel=1e-14)
    assert column(columns, "left_out_time_share [%]") == (0.0,)
    assert column(columns, "status") == ("bounded",)
    assert [row_findings.words(each) for each in found.findings()] == [
        "",
        "counted with the life of row 3 of the cycle",
        "",
    ]


@pytest.mark.parametrize(("loads", "others"), [((9.0, 10.0, 7.0), (0, 0, 0)), ((9.0, 5.0, 7.0), (0, 1, 0))])
def test_neither_a_lower_load_nor_another_speed_bounds_a_row(loads, others):
    assert column(bounded(loads, others).of_cycles(), "left_out_time_share [%]") == approx([25.0], rel=1e-14)


def test_a_row_that_takes_no_time_needs_no_answer():
    found = list(cycles(2.0, None, 4.0, spectrum=Spectrum("time", (0.5, 0.0, 0.5), "life_L10")).of_cycles())
    assert column(found, "revolutions [Mrev]") == approx([1 / (0.5 / 2 + 0.5 / 4)], rel=1e-15)
    assert column(found, "life [h]") == approx([8e6 / 3 * 2 * pi / 100 / 3600], rel=1e-15)
    assert [each.values for each in found if each.name == "status"] == [("converged",)]


def test_shares_of_time_and_of_revolutions_are_inverse_to_each_other():
    time, speed = np.array([0.2, 0.3, 0.5]), np.array([100.0, -700.0, 20.0])
    assert time_shares(revolution_shares(time, speed), speed) == approx(time, rel=1e-14)


def test_cumulated_life_of_equal_rows_is_that_of_one():
    assert cumulated_life([0.1, 0.2, 0.7], [3e6] * 3) == approx(3e6, rel=1e-14)


def test_lives_of_the_raceways_make_that_of_the_bearing():
    bearing, generator = paper_bearing().bearing, np.random.default_rng(5)
    inner, outer = generator.uniform(0, 300, (2, 4, bearing.rollers, 11))
    turning = (np.array([1.0, 0.0, 0.3, 1.0]), np.array([0.0, 1.0, 0.3, 1.0]))
    lives = raceway_lives(inner, outer, bearing, turning)
    together = (lives ** (-9 / 8)).sum(axis=-1) ** (-8 / 9)
    assert together == approx(basic_life(inner, outer, bearing, turning), rel=1e-13)
    assert np.isinf(raceway_lives(0 * inner, outer, bearing, turning)[:, 0]).all()


def test_duty_cycle_of_balls_against_single_runs(tmp_path):
    case = CASE.parent / "harris218.toml"
    file = tmp_path / "cycle.toml"
    file.write_text(
        f'case = "{case}"\n[duty]\ntime = [3, 1]\n"operation.inner_speed" = ["5000 rpm", "10000 rpm"]'
    )
    cycle = flexbearing.study(file, tmp_path, jobs=1)
    lives = [
        float(flexbearing.run(case, {"operation.inner_speed": speed})["life_L10"].to("Mrev"))
        for speed in ("5000 rpm", "10000 rpm")
    ]
    turned = 3 * 5000, 1 * 10000
    expected = 1 / sum(turns / sum(turned) / life for turns, life in zip(turned, lives, strict=True))
    assert cycle.cycles["revolutions"].values[0] == approx(expected, rel=1e-9)


ROLLERS, BALLS = CASE.parent / "catalogue" / "nu210.toml", CASE.parent / "catalogue" / "6208.toml"


def duty_of(folder, loads, speeds, *further, case=ROLLERS, measure="time", shares=None):
    """A study of a duty cycle with radial loads [N] and speeds [rpm]."""
    lists = {
        f"operation.{'radial_load' if case == ROLLERS else 'load.radial_z'}": [f"{load} N" for load in loads],
        "operation.inner_speed": [f"{speed} rpm" for speed in speeds],
    }
    lines = [f'"{key}" = {values}' for key, values in lists.items()]
    text = [f'case = "{case}"', "[duty]", f"{measure} = {[*(shares or [1] * len(loads))]}", *lines, *further]
    file = folder / "cycle.toml"
    file.write_text("\n".join(text))
    return file


@pytest.mark.parametrize("life", ["life_L10", "modified_life"])
def test_standstill_and_no_load_are_time_without_damage(tmp_path, life):
    loads, speeds = (8000, 0, 8000), (3000, 3000, 0)
    file = duty_of(tmp_path, loads, speeds, f'life = "{life}"', f'[collect]\nlife = "{life} [Mrev]"')
    table = flexbearing.study(file, tmp_path, jobs=1)
    assert table["status"].values == ("converged", "no damage", "no damage")
    assert [words.partition(":")[0] for words in table["message"].values[1:]] == ["no load", "standstill"]
    assert table.failed == 0
    assert table.cycles["status"].values == ("converged",)
    assert table.cycles["revolutions"].values[0] == approx(2 * table["life"].values[0], rel=1e-12)
    assert table.cycles["mean_speed"].values[0] == approx(2000, rel=1e-12)
    assert (
        flexbearing.study(file, tmp_path, jobs=1).cycles["life [h]"].values == table.cycles["life [h]"].values
    )


def test_a_preloaded_bearing_without_load_is_computed(tmp_path):
    file = study_of(
        tmp_path,
        '[duty]\ntime = [1, 1]\n"operation.radial_load" = ["5 kN", "0 N"]\n"bearing.clearance" = "-20 um"\n',
    )
    assert [variant.idle for variant in prepare_source(file).plan.variants] == [None, None]


@pytest.mark.parametrize(("case", "pair", "pressed"), [
    ("32207.toml", {}, False),
    ("32207.toml", {"arrangement": "back_to_back", "offset": "-5 um"}, False),
    ("32207.toml", {"arrangement": "back_to_back", "offset": "5 um"}, True),
    ("catalogue/7208.toml", {"arrangement": "back_to_back", "preload": "100 N"}, True),
    ("22210.toml", {}, False),
    ("22210.toml", {"bearing.clearance": "-5 um"}, True),
])  # fmt: skip
def test_rows_that_press_each_other_are_computed_without_load(case, pair, pressed, tmp_path):
    file, keys = tmp_path / "cycle.toml", pair
    if "arrangement" in pair:
        keys = {f"bearing.pair.{key}": value for key, value in {"distance": "40 mm", **pair}.items()}
    text = [f'case = "{CASE.parent / case}"', "[duty]", "time = [1, 1]"]
    text += [f'"operation.load.{name}" = ["3 kN", "0 N"]' for name in ("axial", "radial_z")]
    file.write_text("\n".join([*text, *(f'"{key}" = "{value}"' for key, value in keys.items())]))
    loaded, unloaded = prepare_source(file).plan.variants
    assert loaded.idle is None
    assert (unloaded.idle is None) is pressed


def test_a_row_at_rest_has_no_share_of_the_revolutions(tmp_path):
    file = duty_of(tmp_path, (8000, 8000), (3000, 0), measure="revolutions")
    with pytest.raises(BadCase, match=r"\[duty\] row 2 is at standstill"):
        prepare_source(file)


@pytest.mark.slow
def test_a_creeping_row_counts_with_the_least_factor(tmp_path):
    file = duty_of(
        tmp_path,
        (8000, 5000),
        (3000, 3),
        'life = "modified_life"',
        '[collect]\nl10 = "reference_life [Mrev]"',
    )
    table = flexbearing.study(file, tmp_path, jobs=1)
    turned = np.array([3000, 3]) / 3003
    shares = np.array(table["damage_share"].values)
    creeping = 0.1 * table["l10"].values[1]  # a_ISO at kappa = 0.1
    total = table.cycles["revolutions"].values[0]
    assert shares[1] == approx(100 * total * turned[1] / creeping, rel=1e-9)
    assert table.cycles["status"].values == ("bounded",)
    assert table.cycles["bounded_time_share"].values == approx([50.0], rel=1e-12)
    assert "kappa 0.00935 is below 0.1" in table["message"].values[1]


def test_a_row_without_load_is_not_among_the_problems_of_a_case(tmp_path):
    """Once the other fault is repaired, the row is time without damage."""
    case = tmp_path / "case.toml"
    text = BALLS.read_text().replace("assumed = [", 'assumed = ["bearing.rows", ') + '\nloads = "rating"\n'
    case.write_text(text)
    prepared = prepare_source(duty_of(tmp_path, (1000, 0), (3000, 3000), case=case))
    loaded, unloaded = prepared.plan.problems
    assert unloaded.message == loaded.message


def test_the_least_factor_is_that_of_kappa_0_1_at_any_load():
    ratios = np.array([1e-3, 0.1, 10.0])
    for elements in (ROLLERS_OF_ISO, BALLS_OF_ISO):
        assert modification_factor(0.1, ratios, elements).value == approx(LEAST_FACTOR, rel=1e-2)


def test_a_spectrum_with_idling_against_a_calculation_by_hand(tmp_path):
    """C of 5.54 kN; 3 kN for 10 %, 2 kN for 20 %, 1 kN for 30 % of the time, no load for the rest."""
    case = tmp_path / "case.toml"
    lines = re.sub(r',?\s*"life.cleanliness"', "", BALLS.read_text()).splitlines()
    of_oil = ("lubrication", "cleanliness")
    case.write_text("\n".join(line for line in lines if not line.startswith(of_oil)) + '\nloads = "rating"\n')
    file = duty_of(
        tmp_path, (0, 3000, 2000, 1000), (1000, 1000, 1000, 1000),
        '"life.dynamic_rating" = "5.54 kN"', 'life = "modified_life"', 'required_life = "500 h"',
        case=case, shares=("40 %", "10 %", "20 %", "30 %"),
    )  # fmt: skip
    cycle = flexbearing.study(file, tmp_path, jobs=1).cycles
    assert cycle["kind"].values == ("catalogue L10",)
    assert cycle["revolutions"].values[0] == approx(5.54**3 / 4.6, rel=1e-9)
    assert cycle["revolutions"].values[0] == approx(37.0, rel=2e-3)
    assert cycle["mean_load"].values[0] == approx(1000 * 4.6 ** (1 / 3), rel=1e-9)
    assert cycle["required_rating"].values[0] == approx(1000 * (4.6 * 30) ** (1 / 3), rel=1e-9)


def test_a_life_by_ratings_needs_no_equilibrium():
    from flexbearing.case import read
    from flexbearing.families import FAMILIES
    from flexbearing.studies.plan.task import ERROR
    from flexbearing.studies.worker import _by_ratings

    settings = ["life.loads=rating", "life.capacity=", "life.edge_stress=", "operation.radial_load=1 N"]
    case = read(ROLLERS, settings, FAMILIES)
    found = _by_ratings(Row("", ERROR, "no equilibrium", 0.0), case)
    expected = 50 * 73500 ** (10 / 3)  # a_ISO has its largest value
    assert found.values["modified_life [Mrev]"] == approx(expected, rel=1e-9)
    assert found.status == "rated"
    assert found.converged


def words_of(cycle):
    from flexbearing.studies import messages

    return "\n".join(messages.cycles(cycle.cycles))


RATED = '"life.loads" = "rating"'


@pytest.fixture(scope="module")
def reliabilities(tmp_path_factory):
    """Reliabilities of two variants; the application factor is on the loads of the required rating alone."""
    folder = tmp_path_factory.mktemp("reliabilities")
    further = [RATED, 'life = "modified_life"', 'required_life = "10000 h"', "application_factor = 1.3"]
    file = duty_of(folder, (8000, 5000), (3000, 1000), *further)
    file.write_text(f'{file.read_text()}\n[over]\n"life.reliability" = [0.9, 0.99]\n')
    return flexbearing.study(file, folder, jobs=1).cycles


def test_each_variant_requires_the_rating_of_its_own_reliability(reliabilities):
    """A life is a_1 (C / f P)^(10/3), with a_1 = 1 and 0.25 (ISO 281, table 12)."""
    turns = 10000 * 60 * reliabilities["mean_speed"].values[0] / 1e6
    expected = [
        1.3 * mean * (turns / a1) ** 0.3
        for mean, a1 in zip(reliabilities["mean_load"].values, (1.0, 0.25), strict=True)
    ]
    assert reliabilities["required_rating"].values == approx(expected, rel=3e-3)  # digits of the table


def test_each_variant_requires_the_rating_by_its_own_exponent(tmp_path):
    """With P_1 and P_2 for equal times and thrice as many turns under P_1, C = P_m L^(1/p)."""
    further = [RATED, 'life = "life_L10"', 'required_life = "10000 h"']
    file = duty_of(tmp_path, (8000, 5000), (3000, 1000), *further)
    file.write_text(f'{file.read_text()}\n[over]\n"life.load_exponent" = ["10/3", "4"]\n')
    cycles = flexbearing.study(file, tmp_path, jobs=1).cycles
    turns = 10000 * 60 * 2000 / 1e6
    for place, p in enumerate((10 / 3, 4.0)):
        mean = (0.75 * 8000**p + 0.25 * 5000**p) ** (1 / p)
        assert cycles["mean_load"].values[place] == approx(mean, rel=1e-9)
        assert cycles["required_rating"].values[place] == approx(mean * turns ** (1 / p), rel=1e-9)


@pytest.mark.parametrize(("exponent", "reduced"), [("10/3", "true"), ("4", "false")])
def test_the_required_rating_has_the_required_life(tmp_path, reduced, exponent):
    """The C of a cycle, given back as that of the bearing, lives as long as required."""
    own = [f'"life.stress_reduction" = {reduced}', f'"life.load_exponent" = "{exponent}"']
    plain = [f'"life.{key}" = ""' for key in ("lubrication", "cleanliness", "capacity", "edge_stress")]
    plain.append('"accuracy.slices" = 5')  # of which a catalogue life knows none
    further = [RATED, *own, *plain, 'life = "modified_life"', 'required_life = "10000 h"']
    for folder in ("first", "again"):
        (tmp_path / folder).mkdir()
        file = duty_of(tmp_path / folder, (8000, 5000, 1000), (3000, 1000, 500), *further)
        cycles = flexbearing.study(file, tmp_path / folder, jobs=1).cycles
        further.append(f'"life.dynamic_rating" = "{cycles["required_rating"].values[0]!r} N"')
    hours = cycles["revolutions"].values[0] * 1e6 / (60 * cycles["mean_speed"].values[0])
    assert hours == approx(10000, rel=1e-9)


def test_a_modified_life_that_nothing_modifies_is_refused(tmp_path):
    file = duty_of(tmp_path, (8000, 5000), (3000, 1000), 'life = "modified_life"', case=CASE)
    file.write_text(file.read_text().replace("load.radial_z", "radial_load"))
    with pytest.raises(BadCase, match=r"\[duty\] life"):
        prepare_source(file)


def test_the_mean_load_is_without_the_application_factor(reliabilities):
    mean = (0.75 * 8000 ** (10 / 3) + 0.25 * 5000 ** (10 / 3)) ** 0.3
    assert reliabilities["mean_load"].values == approx([mean, mean], rel=1e-12)
    turns = (roller_influences.rated(check(ROLLERS)).dynamic / mean) ** (10 / 3) * 1e6
    hours = turns / (60 * reliabilities["mean_speed"].values[0])
    assert reliabilities["rating_life"].values == approx([hours, hours], rel=1e-12)


def test_a_variant_whose_load_is_not_known_leaves_that_of_others(tmp_path):
    """ISO 281 ends at contact angles of 45 deg."""
    case = CASE.parent / "harris218.toml"
    file = study_of(tmp_path, "")
    file.write_text(
        f'case = "{case}"\n[over]\n"bearing.contact_angle" = ["40 deg", "46 deg"]\n[duty]\ntime = [1, 1]\n'
        '"operation.inner_speed" = ["500 rpm", "1000 rpm"]'
    )
    table = flexbearing.study(file, tmp_path, jobs=1)
    load = ball_lives.rated(check(case)).load().value
    assert table.cycles["mean_load"].values == approx([load, nan], rel=1e-12, nan_ok=True)
    assert "nan" not in words_of(table)


WITHOUT_A_LIFE = {  # loads [N], speeds [rpm] and what is printed
    "rated": (
        (8000, 1), (3000, 1000), [RATED, 'life = "modified_life"'],
        ["modified catalogue life 634", "no basic L10 life"],
    ),
    "unloaded": ((0, 0), (3000, 1000), [], ["basic L10 life: no damage"]),
    "standstill": ((8000, 0), (0, 0), ['life = "modified_life"'], ["modified life: no damage"]),
}  # fmt: skip


@pytest.mark.parametrize(("loads", "speeds", "further", "words"), WITHOUT_A_LIFE.values(), ids=WITHOUT_A_LIFE)
def test_a_life_that_no_cycle_has_is_no_number(loads, speeds, further, words, tmp_path):
    """One newton leaves a ring without support."""
    printed = words_of(
        flexbearing.study(duty_of(tmp_path, loads, speeds, *further, case=BALLS), tmp_path, jobs=1)
    )
    assert not re.search(r"\b(nan|inf)\b", printed)
    assert all(each in printed for each in words)


def test_a_cycle_without_an_answer_prints_no_number():
    from flexbearing.studies import messages

    found = Table("cycle", tuple(cycles(None, inf, None).of_cycles()), ())
    printed = "\n".join(messages.cycles(found))
    assert "no basic L10 life: no row solved" in printed
    assert not re.search(r"\b(nan|inf)\b", printed)


def series_of(
    folder, lines, *further, header="time [s],operation.radial_load [N],operation.inner_speed [rpm]"
):
    (folder / "measured.csv").write_text("\n".join([header, *lines]))
    return study_of(folder, "\n".join(['[duty]\nseries = "measured.csv"', *further]))


def test_a_time_series_is_sorted_into_bins_by_load_speed_and_direction(tmp_path):
    """Rows begin at 0, 1, 3, 6 and 10 s; the last one lasts as long as the one before."""
    lines = ["0,5000,3000", "1,5100,3000", "3,0,3000", "6,5000,-3000", "10,5000,0"]
    study = prepare_source(series_of(tmp_path, lines, "bins = 3")).study
    found = sorted(zip(study.axes[0].rows, study.spectrum.shares, strict=True), key=str)
    speeds = [float(speed.split()[0]) * 30 / pi for (_, speed), _ in found]
    loads = [float(load.split()[0]) for (load, _), _ in found]
    shares = [round(14 * share) for _, share in found]
    assert sorted(zip(np.round(speeds, 9), np.round(loads, 9), shares, strict=True)) == [
        (-3000, 5000, 4), (0, 5000, 4), (3000, 0, 3), (3000, 5000, 1), (3000, 5100, 2)
    ]  # fmt: skip
    assert study.spectrum.bin_errors == approx((0.0,) * 5, abs=1e-12)
    assert study.inputs[-1].name == "measured.csv"


def random_series(folder, rows, *further):
    generator = np.random.default_rng(3)
    loads, speeds = generator.normal(6000, 2500, rows).clip(0), generator.uniform(-3000, 3000, rows)
    speeds[::10] = 0
    lines = [f"{row},{load},{speed}" for row, (load, speed) in enumerate(zip(loads, speeds, strict=True))]
    return series_of(folder, lines, *further), loads, speeds


def test_bins_have_the_damage_and_the_revolutions_of_their_rows(tmp_path):
    file, loads, speeds = random_series(tmp_path, 2000, "bins = 12")
    study = prepare_source(file).study
    shares = np.array(study.spectrum.shares)
    of_bins = np.array([[float(text.split()[0]) for text in row] for row in study.axes[0].rows]).T
    turned, of_rows = shares * np.abs(of_bins[1]), np.abs(speeds) * pi / 30 / len(speeds)
    assert turned.sum() == approx(of_rows.sum(), rel=1e-12)
    assert (turned * of_bins[0] ** (10 / 3)).sum() == approx((of_rows * loads ** (10 / 3)).sum(), rel=1e-12)
    assert np.all(np.array(study.spectrum.bin_errors) >= -1e-12)


@pytest.mark.parametrize("measure", ["time [h]", "revolutions"])
def test_rows_with_shares_are_sorted_into_bins_as_those_of_a_series(tmp_path, measure):
    file, loads, speeds = random_series(tmp_path, 500, "bins = 12")
    series = prepare_source(file).study
    weights = np.ones(500) if measure == "time [h]" else np.abs(speeds)
    rows = zip(weights, loads, speeds, strict=True)
    lines = [f"{measure},operation.radial_load [N],operation.inner_speed [rpm]"]
    (tmp_path / "measured.csv").write_text("\n".join(lines + [",".join(map(str, row)) for row in rows]))
    file.write_text(file.read_text().replace("series", "file"))
    study = prepare_source(file).study
    found, expected = (
        np.array([float(load.split()[0]) for load, speed in each.axes[0].rows if float(speed.split()[0])])
        for each in (study, series)
    )
    assert np.sort(found) == approx(np.sort(expected), rel=1e-12)
    assert study.spectrum.measured == 500
    assert study.spectrum.measure == measure.split()[0]


def test_bins_need_rows_with_shares(tmp_path):
    file, *_ = random_series(tmp_path, 20, "bins = 12")
    given = file.read_text()
    (tmp_path / "measured.csv").write_text("operation.radial_load [N]\n5000\n3000")
    prepare_source(file)  # rows of a series last equally long
    file.write_text(given.replace("series", "file"))
    with pytest.raises(BadCase, match="shares of its rows"):
        prepare_source(file)
    file.write_text(
        given.replace('series = "measured.csv"', 'time = [1]\n"operation.radial_load" = ["5 kN"]')
    )
    with pytest.raises(BadCase, match="without file or series"):
        prepare_source(file)


@pytest.mark.slow
def test_the_error_of_the_bins_is_that_of_a_series_without_bins(tmp_path):
    """The life without bins is that of as many variants as the series has rows."""
    file, loads, speeds = random_series(tmp_path, 600, "bins = 8", "[collect]")
    binned = flexbearing.study(file, tmp_path, jobs=1).cycles
    table = "\n".join(f"1,{load},{speed}" for load, speed in zip(loads, speeds, strict=True))
    (tmp_path / "rows.csv").write_text(f"time,operation.radial_load [N],operation.inner_speed [rpm]\n{table}")
    single = study_of(tmp_path, '[duty]\nfile = "rows.csv"\n[collect]', "single")
    exact = flexbearing.study(single, tmp_path, jobs=1).cycles
    error = 100 * (binned["life [h]"].values[0] / exact["life [h]"].values[0] - 1)
    stated = binned["binning_error [%]"].values[0]
    assert 1e-3 < abs(error) < stated < 10
    assert binned["series_rows"].values == (600,)


WRONG_SERIES = {
    "time of row 3 is not above that of the row before": ["0,1,1", "2,1,1", "2,1,1"],
    "row 2, time": ["0,1,1", "x,1,1"],
    "row 1, operation.radial_load has": ["0,x,1", "1,1,1"],
    "row 2, operation.radial_load is empty": ["0,1,1", "1,,1"],
    "two rows or more": ["0,1,1"],
}


@pytest.mark.parametrize(("words", "lines"), WRONG_SERIES.items())
def test_what_is_wrong_with_a_series_is_told(tmp_path, words, lines):
    with pytest.raises(BadCase, match=words):
        prepare_source(series_of(tmp_path, lines))


@pytest.mark.parametrize("given", ["20000", "20000 kN", "-1 h", "long"])
def test_a_required_life_is_a_time(tmp_path, given):
    with pytest.raises(BadCase, match="required_life has"):
        prepare_source(duty_of(tmp_path, (8000, 1000), (3000, 3000), f'required_life = "{given}"'))
