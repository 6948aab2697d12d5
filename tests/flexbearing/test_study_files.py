"""Study files: which variants they make, and what is said of those that are wrong."""

import numpy as np
import pytest
from pytest import approx

from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.families import FAMILIES
from flexbearing.studies.file import read, rows as tables
from flexbearing.studies.file.values import BadValues
from tests.places import CONFIGS

CASE = CONFIGS / "mao2016.toml"


@pytest.fixture
def study_of(tmp_path):
    def read_text(text, **files):
        for name, content in files.items():
            (tmp_path / f"{name}.csv").write_bytes(content.encode())
        file = tmp_path / "thin.toml"
        file.write_text(f'case = "{CASE}"\n{text}')
        return read(file, FAMILIES)

    return read_text


def rows(study):
    return [tuple(axis.rows) for axis in study.axes]


def test_every_key_is_an_axis_and_the_last_one_changes_fastest(study_of):
    study = study_of(
        """[over]
        "outer.thickness" = "2.9 mm .. 5.1 mm, 3"
        operation.radial_load = ["10 kN", "19621.1 N"]
        "outer.bars" = 24
        "operation.tilt" = "fixed"
        """
    )
    assert study.name == "thin"
    assert study.keys == ("outer.thickness", "operation.radial_load", "outer.bars", "operation.tilt")
    assert rows(study) == [
        (("2.9 mm",), ("4.0 mm",), ("5.1 mm",)), (("10 kN",), ("19621.1 N",)), ((24,),), (("fixed",),)
    ]  # fmt: skip


TWO = '"bearing.roller.length" = ["4 mm", "5 mm"]'
APART = {
    f'"life.dynamic_rating" = "50 kN"\n{TWO}': False,
    f'zip = true\n"life.dynamic_rating" = "50 kN"\n{TWO}': False,
    f'zip = true\n"life.dynamic_rating" = ["50 kN", "60 kN"]\n{TWO}': True,
    '"life.dynamic_rating" = ["50 kN", "60 kN"]\n"bearing.roller.length" = "4 mm"': True,
}


@pytest.mark.parametrize(("text", "possible"), APART.items(), ids=["alone", "constant", "rows", "one size"])
def test_a_rating_stands_in_the_row_of_its_sizes(study_of, text, possible):
    """One that is set for all rows would not follow the sizes of each."""
    if possible:
        assert study_of(f"[over]\n{text}").keys
    else:
        with pytest.raises(
            BadCase, match=r"life\.dynamic_rating is set while bearing\.roller\.length varies"
        ):
            study_of(f"[over]\n{text}")


RANGES = {
    '"operation.radial_load" = "log 1 N .. 1 kN, 4"': ["1 N", "10 N", "100 N", "1000 N"],
    '"operation.inner_speed" = "3000rpm..6000rpm, 2"': ["3000 rpm", "6000 rpm"],
    '"lubricant.oil_fraction" = "0.1 .. 0.3, 3"': [0.1, 0.2, 0.3],
    '"outer.bars" = "20 .. 24, 3"': [20, 22, 24],
    '"operation.temperatures.shaft" = "20 degC .. 30 degC, 3"': ["20 degC", "25 degC", "30 degC"],
    '"bearing.clearance" = "-5 um .. 5 um, 3"': ["-5 um", "0 um", "5 um"],
    '"lubricant.oil" = "MIL-L-7808"': ["MIL-L-7808"],
}


@pytest.mark.parametrize(("text", "expected"), RANGES.items(), ids=list(RANGES))
def test_ranges_hold_both_ends_and_are_even(study_of, text, expected):
    values = [value for (value,) in study_of(f"[over]\n{text}").axes[0].rows]
    if isinstance(expected[0], str) and " " in expected[0]:
        numbers, units = zip(*(value.split(" ") for value in values), strict=True)
        assert [float(number) for number in numbers] == [float(each.split()[0]) for each in expected]
        assert set(units) == {expected[0].split()[1]}
    else:
        assert values == expected


def test_ends_in_two_units_make_a_range_in_si_units(study_of):
    values = study_of('[over]\n"operation.radial_load" = "500 N .. 1.5 kN, 3"').axes[0].rows[:]
    assert values == (("500.0 N",), ("1000.0 N",), ("1500.0 N",))


def test_zipped_keys_change_together_and_single_values_stay(study_of):
    study = study_of(
        """[over]
        zip = true
        "outer.thickness" = ["3 mm", "4 mm"]
        "operation.radial_load" = "1 kN .. 2 kN, 2"
        "operation.inner_speed" = "30000 rpm"
        """
    )
    assert rows(study) == [(("3 mm", "1.0 kN", "30000 rpm"), ("4 mm", "2.0 kN", "30000 rpm"))]
    assert study.axes[0].name == "variant"


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_a_table_of_variants_is_one_axis_beside_the_others(study_of, separator):
    table = "\ufeffoperation.radial_load [kN],outer.kind,outer.bars\n10,squirrel_cage,24\n\n 20 ,rigid,12\n"
    study = study_of(
        '[over]\nfile = "list.csv"\n"bearing.clearance" = ["50 um", "60 um"]',
        list=table.replace(",", separator),
    )
    assert rows(study) == [
        (("10 kN", "squirrel_cage", 24), ("20 kN", "rigid", 12)), (("50 um",), ("60 um",))
    ]  # fmt: skip
    assert study.inputs[-1].name == "list.csv"


def sampled(study_of, **keys):
    text = "\n".join(f'"{key.replace("__", ".")}" = "{value}"' for key, value in keys.items())
    return study_of(f'[sample]\ncount = 64\nseed = 7\nmethod = "sobol"\n{text}').axes[0].rows


def test_samples_are_the_quantiles_of_scipy_at_its_points(study_of):
    """Each distribution against that of scipy.stats at the points of its own generator."""
    from scipy import stats
    from scipy.stats import qmc

    drawn = sampled(
        study_of,
        bearing__clearance="normal 75.5 um, 5 um",
        operation__radial_load="uniform 10 kN, 20 kN",
        operation__temperatures__shaft="truncated normal 230 degC, 5 K, 220 degC, 235 degC",
        operation__temperatures__roller="normal 226 degC, 0.5 K",
        lubricant__oil_fraction="lognormal 0.1, 1.5",
    )
    points = qmc.Sobol(5, seed=7).random(64).T
    expected = (
        stats.norm(75.5e-6, 5e-6),
        stats.uniform(10e3, 10e3),
        stats.truncnorm(-2, 1, 230 + 273.15, 5),
        stats.norm(226 + 273.15, 0.5),
        stats.lognorm(np.log(1.5), scale=0.1),
    )
    for column, point, distribution in zip(zip(*drawn, strict=True), points, expected, strict=True):
        numbers = [float(str(value).split()[0]) for value in column]
        assert numbers == approx(distribution.ppf(point), rel=1e-12)


def test_lists_are_drawn_and_single_values_belong_to_every_variant(study_of):
    text = """[sample]
        count = 6
        "operation.radial_load" = "20 kN"
        "bearing.form_error.roller_diameters" = "30 x normal 0 um, 0.3 um"
        "bearing.form_error.outer.waves" = 2"""
    study = study_of(text)
    (axis,) = study.axes
    assert axis.keys == (
        "bearing.form_error.roller_diameters", "operation.radial_load", "bearing.form_error.outer.waves"
    )  # fmt: skip
    deviations = np.array([[float(each.removesuffix(" m")) for each in row[0]] for row in axis.rows])
    assert deviations.shape == (6, 30)
    assert {row[1:] for row in axis.rows} == {("20 kN", 2)}
    from scipy import stats

    strata = np.sort(stats.norm(0, 0.3e-6).cdf(deviations) * 6 // 1, axis=0)
    assert (strata.T == np.arange(6)).all()  # of a Latin hypercube: one of each sixth


def test_the_seed_decides_the_samples_of_a_latin_hypercube(study_of):
    from scipy.stats import qmc

    text = '[sample]\ncount = 10\n{}"operation.radial_load" = "uniform 0 N, 1 N"'
    values = [
        [float(value.split()[0]) for (value,) in study_of(text.format(seed)).axes[0].rows]
        for seed in ("", "seed = 0\n", "seed = 1\n")
    ]
    assert values[0] == values[1] == approx(qmc.LatinHypercube(1, seed=0).random(10)[:, 0], rel=1e-15)
    assert values[0] != values[2]
    assert sorted(int(10 * value) for value in values[2]) == list(range(10))


def test_a_duty_cycle_is_the_last_axis_and_its_shares_add_up_to_one(study_of):
    study = study_of(
        """[over]
        "bearing.clearance" = ["50 um", "60 um"]
        [duty]
        time = ["10 h", "20 h", "10 h"]
        operation.radial_load = ["1 kN", "2 kN", "3 kN"]
        "operation.inner_speed" = "30000 rpm"
        """
    )
    assert [axis.name for axis in study.axes] == ["bearing.clearance", "duty"]
    assert tuple(study.axes[1].rows) == tuple((f"{load} kN", "30000 rpm") for load in (1, 2, 3))
    assert (study.spectrum.measure, study.spectrum.shares) == ("time", (0.25, 0.5, 0.25))


def test_a_duty_cycle_is_read_from_a_table(study_of):
    table = "revolutions [%],operation.radial_load [kN]\n33.3,1\n33.3,2\n33.3,3\n"
    study = study_of('[duty]\nfile = "list.csv"\n"operation.inner_speed" = "30000 rpm"', list=table)
    assert study.axes[0].keys == ("operation.inner_speed", "operation.radial_load")
    assert study.spectrum.measure == "revolutions"
    assert study.spectrum.shares == approx((1 / 3, 1 / 3, 1 / 3), rel=1e-15)
    assert study.inputs[-1].name == "list.csv"


SPREADSHEETS = {
    "semicolons": "time [%];operation.radial_load [kN];operation.inner_speed\n"
    "33,5;1,250;1,5e3 rpm\n66,5;-,5;2 rpm\n",
    "tabs": "\ufefftime [%]\toperation.radial_load [kN]\toperation.inner_speed\r\n"
    "33,5\t 1,250 \t1,5e3 rpm\r\n66,5\t-,5\t2 rpm\r\n\t\t\r\n",
    "named": "sep=;\r\ntime [%]; operation.radial_load [kN]; operation.inner_speed\r\n"
    '33.5; "1.250"; 1.5e3 rpm\r\n66.5; -.5; 2 rpm\r\n',
}


@pytest.mark.parametrize("name", SPREADSHEETS)
def test_tables_of_spreadsheets_are_read_with_their_separators_and_decimal_commas(study_of, name):
    study = study_of('[duty]\nfile = "list.csv"', list=SPREADSHEETS[name])
    assert tuple(study.axes[0].rows) == (("1.250 kN", "1.5e3 rpm"), ("-.5 kN", "2 rpm"))
    assert study.spectrum.shares == approx((0.335, 0.665), rel=1e-14)


def test_a_comma_is_decimal_only_in_numbers_without_a_point(study_of):
    table = "operation.radial_load;lubricant.oil\n1.234,5 N;a,5\n1,5 kN;1,2,3\n"
    study = study_of('[over]\nfile = "list.csv"', list=table)
    assert tuple(study.axes[0].rows) == (("1.234,5 N", "a,5"), ("1.5 kN", "1,2,3"))


OVER, LOAD = "[over]\n", '"operation.radial_load" = "1 kN"\n'
WRONG = {
    "": "[over], [sample] and [duty] are missing; a study has one of them.",
    OVER + LOAD + "[sample]\ncount = 2": "[over] and [sample] are both there; a study has one of them.",
    OVER: "[over] names no key; give one or more, such as",
    "[sample]\ncount = 2": "[sample] names no key; give one or more, such as",
    "[sample]\n" + LOAD: "[sample] count is missing; it is a whole number, at least 1",
    "[sample]\ncount = 2.5\n" + LOAD: "[sample] count = 2.5 is not allowed",
    OVER + LOAD + "[colect]\nx = 'life_L10'": "colect is not a key here. Did you mean collect?",
    OVER + LOAD + "[collect]\nstatus = 'life_L10'": "[collect] status cannot be a heading",
    'name = "a/b"\n' + OVER + LOAD: "name = a/b cannot be; it must be the beginning of names of files",
    OVER + '"outer.thicknesss" = "1 mm"': "[over] outer.thicknesss is not a key of the case. Did you mean",
    OVER + '"kind" = ["four_point_ball"]': "[over] kind is the same in every variant",
    OVER + '"outer.thickness" = []': "[over] outer.thickness is an empty list; give one value or more",
    OVER + '"outer.thickness" = "1 mm .. 2 mm"': "[over] outer.thickness is no range: a range is",
    OVER + '"outer.thickness" = "1 mm .. 2, 5"': '[over] outer.thickness has "2", which has no unit',
    OVER + '"outer.thickness" = "1 mm .. 2 N, 5"': '[over] outer.thickness has "2 N", which is not a length',
    OVER + '"outer.thickness" = "1 mm .. 2 mm, 1"': "[over] outer.thickness has 1 values; a range has 2 to",
    OVER + '"outer.bars" = "10 .. 20, 4"': "[over] outer.bars has 13.3333 among its values, which is no",
    OVER + '"lubricant.oil_fraction" = "0.1 .. x, 4"': '[over] lubricant.oil_fraction has an end',
    OVER + '"operation.radial_load" = "log 0 N .. 1 N, 4"': "[over] operation.radial_load has an end that",
    OVER + 'zip = true\n"operation.radial_load" = ["1 N", "2 N"]\n"outer.bars" = [1, 2, 3]':
        "[over] needs as many values of every key: operation.radial_load has 2, outer.bars has 3",
    OVER + '"operation.radial_load" = "1 N .. 2 N, 2000"\n"outer.thickness" = "1 mm .. 2 mm, 2000"':
        "[over] gives 4000000 variants; a study has at most 1000000",
    OVER + 'file = "none.csv"': '[over] file = "none.csv": there is no such file',
    OVER + 'file = "empty.csv"': '[over] file = "empty.csv": is empty; a header holds keys with units',
    OVER + 'file = "header.csv"': '[over] file = "header.csv": has no rows below its header',
    OVER + 'file = "short.csv"': '[over] file = "short.csv": row 2 has 1 cells, the header has 2',
    OVER + 'file = "unit.csv"': '[over] file = "unit.csv": column 1: outer.bars has no unit, found [mm]',
    OVER + 'file = "good.csv"\n"outer.bars" = 3': "[over] outer.bars is varied twice",
    '[sample]\ncount = 3\nmethod = "sobol"\n' + '"operation.radial_load" = "uniform 1 N, 2 N"':
        "[sample] count = 3 is not a power of 2, for which Sobol points are even: 2 or 4",
    '[sample]\ncount = 3\n"operation.radial_load" = "weibull 1 N, 2 N"':
        '[sample] operation.radial_load = "weibull 1 N, 2 N" is no distribution; it must be',
    '[sample]\ncount = 3\n"operation.radial_load" = "normal 1 N"':
        '[sample] operation.radial_load = "normal 1 N" has 1 numbers; it must be "normal MEAN, DEVIATION"',
    '[sample]\ncount = 3\n"operation.radial_load" = "uniform 2 N, 1 N"':
        '[sample] operation.radial_load = "uniform 2 N, 1 N" cannot be: its second number is not above',
    '[sample]\ncount = 3\n"operation.temperatures.shaft" = "normal 80 degC, 5 degC"':
        'has the deviation "5 degC": a difference of temperatures is in K',
    '[sample]\ncount = 3\n"outer.bars" = "uniform 10, 20"':
        "cannot be drawn: the key takes a whole number",
    '[sample]\ncount = 3\n"bearing.form_error.roller_diameters" = "normal 0 um, 1 um"':
        'has no count; a list of 30 numbers is drawn by "30 x normal ..."',
    '[sample]\ncount = 3\n"operation.radial_load" = "2 x uniform 1 N, 2 N"':
        "has a count, but the key takes a force as text",
    '[sample]\ncount = 262144\nmethod = "sobol_indices"\n"operation.radial_load" = "uniform 1 N, 2 N"\n'
    '"operation.inner_speed" = "uniform 1 rpm, 2 rpm"':
        "[sample] gives 1048576 variants; a study has at most 1000000",
    '[duty]\n' + LOAD: "[duty] needs the shares of its rows",
    "[duty]\ntime = [1, 2]": "[duty] needs the shares of its rows",
    "[duty]\ntime = [1, 2]\nrevolutions = [1, 2]\n" + LOAD: "[duty] needs the shares of",
    '[duty]\ntime = [1, 2]\n"operation.radial_load" = ["1 N", "2 N", "3 N"]':
        "[duty] needs as many values of every key: time has 2, operation.radial_load has 3",
    '[duty]\ntime = ["30 %", "60 %"]\n' + LOAD: "[duty] time adds up to 90 %; percentages must",
    '[duty]\ntime = ["30 %", "12 h"]\n' + LOAD: "[duty] time has shares in '%' and 'h'; write all",
    '[duty]\ntime = ["30 N", "12 N"]\n' + LOAD: '[duty] time has "30 N", which is no share of time',
    '[duty]\nrevolutions = ["3 h"]\n' + LOAD: '[duty] revolutions has "3 h", which is no share of',
    '[duty]\ntime = [1, -2]\n' + LOAD: "[duty] time has -2.0; a share is at least 0",
    '[duty]\ntime = [0, 0]\n' + LOAD: "[duty] time has no share above zero",
    '[duty]\ntime = ["much", 1]\n' + LOAD: '[duty] time has "much"; a share is a number',
    '[duty]\nfile = "gap.csv"': "[duty] time has an empty cell; every row has a share",
    '[duty]\nfile = "loads.csv"\n' + LOAD: "[duty] operation.radial_load is given here and in loads.csv",
    OVER + LOAD + '[duty]\nfile = "loads.csv"': "[duty] operation.radial_load is varied twice",
}  # fmt: skip
TABLES = {
    "loads": "time [%],operation.radial_load [kN]\n100,5\n",
    "empty": "\n",
    "header": "outer.bars\n",
    "unit": "outer.bars [mm]\n1",
    "gap": "operation.radial_load [N],time\n1,\n",
    "short": "outer.bars,operation.radial_load [N]\n1,2\n1\n",
    "good": "outer.bars\n12\n",
}


@pytest.mark.parametrize(("text", "message"), WRONG.items(), ids=list(WRONG.values()))
def test_a_wrong_study_is_told_by_file_key_and_what_is_allowed(study_of, text, message):
    with pytest.raises(BadCase) as problem:
        study_of(text, **TABLES)
    assert str(problem.value).startswith("thin.toml: ")
    assert message in str(problem.value)


def test_a_study_without_its_case_is_told(tmp_path):
    file = tmp_path / "lost.toml"
    file.write_text('case = "none.toml"\n[over]\n' + LOAD)
    with pytest.raises(BadCase, match=r"none\.toml: there is no such file"):
        read(file, FAMILIES)
    with pytest.raises(BadCase, match=r"is a folder, no file"):
        read(tmp_path, FAMILIES)


@pytest.mark.parametrize(("text", "what"), [
    ("operation.radial_load [N]\n1\n2\n3\n", "has more than 2 rows below its header"),
    ("operation.radial_load [N],,,,", "has more than 3 cells"),
], ids=["rows", "cells"])  # fmt: skip
def test_longer_tables_of_variants_are_refused_before_they_fill_the_memory(text, what, tmp_path, monkeypatch):
    monkeypatch.setattr(tables, "MOST", 2)
    monkeypatch.setattr(tables, "MOST_CELLS", 3)
    (tmp_path / "v.csv").write_text(text)
    with pytest.raises(BadValues, match=what):
        tables.rows(tmp_path / "v.csv", bool)


def test_an_empty_text_of_set_takes_a_key_out(tmp_path):
    case, file = CASE.parent / "catalogue" / "nu210.toml", tmp_path / "study.toml"
    without = '"life.lubrication" = ""\n"life.cleanliness" = ""'
    file.write_text(f'case = "{case}"\n[set]\n{without}\n[over]\n"operation.radial_load" = ["1 kN"]\n')
    settings = read(file, FAMILIES).settings
    assert settings == ("life.lubrication=", "life.cleanliness=")
    assert read_case(case, settings).life.lubrication is None
