"""The verdict of a report: which life to use, what limits most, how exact the numbers are."""

from dataclasses import replace
from functools import cache
from itertools import pairwise

import pytest
from flexbearing.report.html.against_limits import ranked
from flexbearing.report.html.check import BUILD, NOT_CHECKED
from flexbearing.report.html.simplifications import simplifications
from pytest import approx

from flexbearing import api
from flexbearing.case import cage_room
from flexbearing.findings import DANGER, OUTSIDE, USUAL
from flexbearing.report import text
from flexbearing.report.html import METRIC, clearance, life as life_section, stiffness, verdict
from flexbearing.report.html.document import Number
from flexbearing.report.html.lives import COMPARED, lives
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.write import marked
from flexbearing.runs.notes import of_case
from tests.flexbearing.hostile_cases import CONFIGS
from tests.flexbearing.html_pages import Numbers, require_equal

A_ISO = (
    "life.lubrication=a_ISO", "life.cleanliness=oil, in-line filter, -/15/12", "life.capacity=iso281",
    "life.edge_stress=true", "accuracy.slices=30",
)  # fmt: skip
CASES = {
    "plain": ("nu209.toml", ()),
    "iso": ("nu209.toml", ("life.capacity=iso281",)),
    "oil": ("nu209.toml", A_ISO),
    "rating": ("nu209.toml", ("life.loads=rating",)),
    "film": ("nu209_fits.toml", ()),
    "ball": ("6209.toml", ()),
    "four-point": ("joshi2015_qj309.toml", ()),
    "heavy": ("nu209.toml", ("operation.radial_load=30 kN",)),
    "open seat": ("nu209_fits.toml", ("bearing.fits.housing=",)),
    "light": ("nu209.toml", ("operation.radial_load=500 N",)),
    "catalogue": ("catalogue/nu210.toml", ()),
}


@pytest.fixture(scope="module")
def readers(tmp_path_factory):
    folder = tmp_path_factory.mktemp("verdicts")

    @cache
    def computed(name):
        file, settings = CASES[name]
        path = folder / f"{name}.h5"
        api.run(CONFIGS / file, settings, output=path)
        return Reader(api.read(path), METRIC)

    return computed


def words(reader):
    """Everything that the verdict says, cell by cell."""
    return "\n".join(text if isinstance(text, str) else text.text for text in texts(reader))


def texts(reader):
    for block in verdict.blocks(reader):
        if block.kind == "table":
            yield from (block.caption, *block.head, *(cell for row in block.rows for cell in row), block.note)
        else:
            yield from block.paragraphs if block.kind == "words" else (block.title, *block.items)


def value(life):
    return float(life.turns.text.replace(",", ""))


@pytest.mark.parametrize(
    ("name", "chosen", "told"),
    [
        (
            "plain",
            "Basic life L10, Lundberg and Palmgren",
            "a requirement by ISO/TS 16281 needs life.capacity",
        ),
        ("iso", "Reference life L10r, ISO/TS 16281", 'life.lubrication = "a_ISO" adds them'),
        ("oil", "Modified reference life, ISO/TS 16281", "is compared with the reference life instead"),
        ("rating", "Life L10 of the catalogue, ISO 281", "one load P; clearance, tilt"),
        ("film", "Modified life", "a survival probability of 99 % and rollers that fail"),
        ("ball", "Reference life L10r, ISO/TS 16281", 'life.lubrication = "a_ISO" adds them'),
    ],
)
def test_the_verdict_names_the_most_detailed_life_and_which_to_compare(readers, name, chosen, told):
    first, *others = lives(readers(name))
    assert (first.name, first.chosen) == (chosen, True)
    assert not any(life.chosen for life in others)
    page = words(readers(name))
    assert f"Life of this case: {chosen}." in page
    assert page.count(COMPARED) == 1
    assert "where it says no more than L10h" in page
    assert ("for requirements that name no other" in page) == (name != "rating")
    assert told in page


def test_every_life_stands_beside_it_as_what_it_is(readers):
    reader = readers("oil")
    found = {life.key: value(life) for life in lives(reader)}
    rated = Numbers(reader.result.path).ratings
    assert set(found) == {"modified", "basic", "reference", "catalogue", "catalogue modified"}
    assert found["catalogue"] == approx(rated["life_Mrev"], rel=1e-3)
    assert found["catalogue modified"] == approx(rated["life_Mrev"] * rated["a_ISO"], rel=1e-3)
    assert found["reference"] == approx(float(reader.result["reference_life"].to("Mrev")), rel=1e-3)
    (factor,) = [each for each in reader.attributes["life"]["rigid"]["factors"] if each["name"] == "a_ISO"]
    assert found["modified"] == approx(found["reference"] * factor["value"], rel=1e-3)
    assert set(found.values()) != {found["modified"]}


def test_the_numerical_error_stands_beside_every_life(readers):
    errors = {life.key: life.error for life in lives(readers("oil"))}
    assert errors["catalogue"] == errors["catalogue modified"] == "none: a formula"
    basic, reference, modified = (float(errors[key].text) for key in ("basic", "reference", "modified"))
    (factor,) = [each for each in readers("oil").attributes["life"]["rigid"]["factors"]
                 if each["name"] == "a_ISO"]  # fmt: skip
    assert reference == basic > 0
    assert modified == approx(basic * (1 + factor["life_exponent"]), rel=0.06)  # two printed digits
    assert {life.error for life in lives(readers("film")) if life.key == "modified"} == {
        "not estimated: film"
    }
    assert {life.error for life in lives(readers("ball")) if life.chosen} == {"none: balls have no slices"}


def test_an_older_result_without_the_growth_of_a_iso_tells_no_error_of_its_life(readers):
    reader = readers("oil")
    factors = [
        {key: each[key] for key in each if key != "life_exponent"}
        for each in reader.attributes["life"]["rigid"]["factors"]
    ]
    older = {"rigid": {**reader.attributes["life"]["rigid"], "factors": factors}}
    result = replace(reader.result, attributes={**reader.result.attributes, "life": older})
    assert lives(Reader(result, METRIC))[0].error == "not estimated"


def test_a_bearing_without_a_rating_life_has_no_life_to_use(readers):
    assert lives(readers("four-point")) == ()
    page = words(readers("four-point"))
    assert "No life of this case. ISO 281 and ISO 76 have no ratings for this kind" in page


@pytest.mark.parametrize("name", CASES)
def test_limits_are_ranked_and_what_was_not_checked_says_why(readers, name):
    checks = ranked(readers(name))
    kept = [check.used for check in checks if check.verdict.startswith("met")]
    broken = [check for check in checks if check.broken]
    assert all(before >= after for before, after in pairwise(kept))
    assert list(checks[: len(broken)]) == broken
    grades = [(DANGER, OUTSIDE, BUILD, USUAL).index(check.grade) for check in broken]
    assert grades == sorted(grades)
    assert all(check.who for check in checks if check.unchecked)
    reasons = [check.verdict for check in checks if check.verdict.startswith(NOT_CHECKED)]
    assert all(len(reason) > len(NOT_CHECKED) + 10 for reason in reasons)
    told = " ".join(check.what for check in checks)
    for what in ("Peak contact pressure", "film ratio", "Temperature", "Speed", "inimum load"):
        assert what in told.replace("Highest temperature", "Temperature")


def test_a_load_above_half_the_rating_is_told_first(readers):
    check = ranked(readers("heavy"))[0]
    assert check.what == "Equivalent load P"
    assert check.verdict.startswith("OUTSIDE VALIDITY")
    rated = Numbers(readers("heavy").result.path).ratings["ratings_N"]["C_r"]
    assert check.used == approx(30e3 / (rated / 2), rel=1e-9)
    page = words(readers("heavy"))
    assert page.startswith("Not assured, outside the range of a law: Equivalent load P: 30 kN")
    assert "No limit of damage that was checked is exceeded." in page
    assert "load: life formulas hold up to there" in page
    assert "load: life formulas" not in words(readers("plain"))


def test_what_else_moves_the_life_is_told_beside_it(readers):
    result = readers("plain").result
    notes = [
        {"grade": "information", "code": code, "text": f"{code}: +10%"} for code in ("tilt", "drag-loss")
    ]
    told = words(Reader(replace(result, attributes={**result.attributes, "notes": notes}), METRIC))
    assert "What moves this life more than its numerical error\ntilt: +10%" in told
    assert "drag-loss" not in told


def test_a_light_load_is_below_the_minimum_load(readers):
    check = next(each for each in ranked(readers("light")) if each.what.startswith("Minimum load"))
    rated = Numbers(readers("light").result.path).ratings["ratings_N"]["C_r"]
    assert check.verdict == "BELOW THE USUAL MINIMUM"
    assert check.used == approx(0.02 * rated / 500, rel=1e-9)


def test_the_first_sentence_says_whether_the_bearing_is_usable(readers):
    """A missed aim is no limit, and a danger or a limit that is not kept is never called usable."""
    plain, light = readers("plain"), readers("light")
    assert words(plain).startswith("Usable as far as checked: every limit that was checked is met")
    assert words(light).startswith("Below the usual minimum: Minimum load")
    notes = [{"grade": "danger", "code": "anything", "text": "anything"}]
    warned = replace(plain.result, attributes={**plain.result.attributes, "notes": notes})
    assert words(Reader(warned, METRIC)).startswith("Not to be used as computed: see the dangers")


def test_no_stiffness_with_supports_where_nothing_gives_way(readers):
    (which, table), reader = list(stiffness.blocks(readers("plain")))[:2], readers("plain")
    assert "there is one stiffness, that of the bearing alone" in which.paragraphs[0]
    assert not any("with supports" in row[0] for row in table.rows)
    assert "with supports" not in "".join(row[0] for row in verdict._main(reader).rows)
    across = next(row[1] for row in table.rows if row[0] == "bearing alone, along y")
    assert float(across.text) == approx(reader.blocks["rigid"]["stiffness_matrix"][1, 1] / 1e6, rel=1e-3)


def test_a_fitted_cage_slip_is_marked(readers):
    result = readers("plain").result
    fitted = {**result.attributes, "calibrated": {"lubricant.oil_fraction": "a cage slip of 1 %"}}
    assert "no prediction" in words(Reader(replace(result, attributes=fitted), METRIC))
    assert "no prediction" not in words(readers("plain"))


def test_lives_by_raceways_have_the_name_of_the_life_that_they_make(readers):
    found = {life.turns.text: life.name for life in lives(readers("oil"))}
    table = next(block for block in life_section.blocks(readers("oil")) if block.kind == "table")
    assert table.caption.startswith(found[table.rows[0][1].text])


def test_what_stands_between_backticks_is_code_and_nothing_else_is_markup():
    assert marked("<b> `run --set x` & `") == "&lt;b&gt; <code>run --set x</code> &amp; `"


def test_films_are_held_to_their_regime_and_without_roughness_not_checked(readers):
    rough = {check.what: check for check in ranked(readers("film"))}
    assert rough["Smallest film ratio Λ, inner raceway"].verdict == "met: mixed"
    plain = {check.what: check.verdict for check in ranked(readers("plain"))}
    assert plain["Smallest film ratio Λ"] == "not checked: no roughness given (bearing.roughness)"
    assert plain["Viscosity ratio κ"] == "met"
    assert {check.what: check.verdict for check in ranked(readers("oil"))}["Viscosity ratio κ"] == "met"


def test_what_has_no_estimated_error_is_said_to_have_none(readers):
    result = readers("plain").result
    older = {key: value for key, value in result.attributes.items() if key != "slice_error"}
    page = words(Reader(replace(result, attributes=older), METRIC))
    assert "largest roller load, inner; stiffness of the bearing; peak" not in page
    assert "largest roller load, inner; stiffness of the bearing; cage slip" in page
    assert "peak pressure, inner raceway\n\nnot estimated" in page
    assert "slices were within 5 % of whole contacts in cases without a note on peak pressure" in page
    noted = [{"grade": "outside validity", "code": "pressed-end", "text": "peak"}]
    told = words(Reader(replace(result, attributes={**older, "notes": noted}), METRIC))
    assert "not estimated; see the notes on peak pressure under Limits" in told
    assert "have no numerical error but that of the balance" in words(readers("ball"))


@pytest.mark.parametrize("name", CASES)
def test_every_number_of_verdict_life_and_clearance_is_that_of_the_file(readers, name):
    blocks = (*clearance.blocks(readers(name)), *life_section.blocks(readers(name)))
    tables = [block for block in blocks if block.kind == "table"]
    cells = [cell for table in tables for row in table.rows for cell in row]
    numbers = [each for each in (*texts(readers(name)), *cells) if isinstance(each, Number)]
    cells = [({"data-of": each.of, "data-stored": each.stored, "data-unit": each.unit}, each.text)
             for each in numbers]  # fmt: skip
    assert len(cells) > 5
    require_equal(cells, Numbers(readers(name).result.path))


def test_the_terminal_shows_the_reference_life(readers):
    summary = text(readers("oil").result)
    (line,) = [each for each in summary.splitlines() if "reference life L10r, ISO/TS 16281 [Mrev]" in each]
    shown = float(line.split()[-1].replace(",", ""))
    factors = {each["name"]: each["value"] for each in readers("oil").attributes["life"]["rigid"]["factors"]}
    basic = readers("oil").attributes["life"]["rigid"]["basic_Mrev"]
    assert shown == approx(basic * factors["capacity"] * factors["edge stress"], abs=0.0051)
    assert "reference life" not in text(readers("plain").result)


def test_a_cage_within_the_ribs_cannot_be_built_which_is_no_limit_of_damage(readers):
    paper = CONFIGS / "mao2016.toml"
    case = api.read_case(paper)
    assert cage_room.overlap(case) == "cage inside Ø 69.2 mm, inner ribs Ø 69.6 mm"
    (note,) = [each for each in of_case(case) if each.code == "overlapping-dimensions"]
    assert (note.grade, "cannot be built" in note.text) == ("outside validity", True)
    for free in ("bearing.cage.thickness=2.2 mm", "inner.track_width=9 mm", "inner.kind=rigid"):
        assert cage_room.overlap(api.read_case(paper, [free])) == ""
    result = readers("plain").result
    noted = replace(result, attributes={**result.attributes, "notes": [note.record()]})
    assumed = {**noted.attributes, "assumed": ["bearing.cage.thickness"]}
    noted = replace(noted, attributes=assumed)
    assert ranked(Reader(result, METRIC))[0].what != "Dimensions of the cage"
    first = ranked(Reader(noted, METRIC))[0]
    assert (first.what, first.grade) == ("Dimensions of the cage", BUILD)
    assert first.verdict.startswith("CANNOT BE BUILT")
    told = words(Reader(noted, METRIC))
    assert told.startswith("It cannot be built as assumed: dimensions overlap")
    assert "dimensions overlap: cage inside Ø 69.2 mm" in told


@pytest.mark.parametrize(
    ("name", "told", "not_told"),
    [
        ("plain", "Both rings are rigid", "Flexible parts"),
        ("plain", "The clearance is the one given", "housing fit"),
        ("film", "No axial load", "isothermal"),
        ("film", "The life is that of rolling contact fatigue", "The clearance is the one given"),
        ("ball", "The cage is left out", "slices"),
        ("four-point", "No oil film is computed", "The life is that of rolling contact fatigue"),
        ("open seat", "The housing fit is left open", "The shaft fit is left open"),
    ],
)
def test_what_the_model_leaves_out_is_told_for_the_case(readers, name, told, not_told):
    items = simplifications(readers(name))
    assert all(who for _, who in items)
    said = " ".join(text for text, _ in items)
    assert told in said
    assert not_told not in said


def test_without_a_stored_comparison_the_page_says_why_the_life_is_not_the_catalogue_s(readers):
    told = {getattr(block, "caption", ""): block for block in life_section.blocks(readers("plain"))}
    (solved,) = [block for caption, block in told.items() if caption.startswith("Why")]
    left_out = told["What the catalogue's life leaves out of this case"]
    names = [row[0] for row in left_out.rows]
    assert names[0] == "ISO 281: (C_r/P)^(10/3)"
    assert "operating clearance" in names
    assert "flexible rings" not in names
    assert "--set outputs.catalogue_life=true" in left_out.note
    assert all(row[1].endswith(".") for row in left_out.rows)
    catalogue, rigid = (float(row[2].text.replace(",", "")) for row in solved.rows[:2])
    assert float(solved.rows[1][1].text) == approx(rigid / catalogue, rel=6e-3)


def test_the_way_from_the_catalogue_s_life_ends_at_that_of_the_case(readers):
    (solved,) = [block for block in life_section.blocks(readers("oil"))
                 if getattr(block, "caption", "").startswith("Why")]  # fmt: skip
    life = float(solved.rows[0][2].text.replace(",", ""))
    for name, factor, turns, _ in solved.rows[1:-1]:
        if name == "Reference life L10r, ISO/TS 16281":
            assert float(turns.text.replace(",", "")) == approx(life, rel=5e-3)
        else:
            life *= float(factor.text)
    assert life == approx(float(solved.rows[-1][2].text.replace(",", "")), rel=0.02)  # three digits each


def test_the_bearing_without_ratings_has_no_way_from_a_catalogue(readers):
    assert not any(
        getattr(block, "caption", "").startswith("Why")
        for block in life_section.blocks(readers("four-point"))
    )


@pytest.mark.slow
@pytest.mark.parametrize(
    ("settings", "row", "by"),
    [
        ("accuracy.target=1 %", "stiffness of the bearing", "neighbouring levels of accuracy"),
        ("bearing.contact=half_space", "peak pressure, inner raceway", "cells of twice the size"),
    ],
)
def test_estimated_errors_are_those_of_the_file(tmp_path, settings, row, by):
    api.run(CONFIGS / "nu209.toml", [settings], output=tmp_path / "a.h5")
    reader = Reader(api.read(tmp_path / "a.h5"), METRIC)
    (table,) = [block for block in verdict.blocks(reader) if getattr(block, "head", ("",))[0] == "number"]
    (error,) = [cells[1] for cells in table.rows if cells[0] == row and cells[2] == by]
    given = {"data-of": error.of, "data-stored": error.stored, "data-unit": error.unit}
    require_equal([(given, error.text)], Numbers(tmp_path / "a.h5"))
    assert 0 < float(error.text) < 1


def test_lives_stand_in_their_order(readers):
    keys = [life.key for life in lives(readers("oil"))]
    assert keys == ["modified", "reference", "basic", "catalogue", "catalogue modified"]


def main_results(reader):
    (table,) = [block for block in verdict.blocks(reader) if getattr(block, "caption", "") == "Main results"]
    return {row[0]: row for row in table.rows}


def test_main_results_stand_with_what_all_assumed_and_toleranced_inputs_make_of_them(readers):
    rows = main_results(readers("catalogue"))
    assert next(iter(rows)) == "Modified reference life, ISO/TS 16281"
    stiffness_row = rows["radial stiffness along the load, of the bearing alone"]
    assert [cell.text for cell in stiffness_row[4:8]] == ["0.855", "1.18", "0.746", "1.3"]
    assert stiffness_row[8] == "bearing.roller.profile"
    assert "490,000 h. Range: 79,800 to 6,700,000 h by what is assumed" in words(readers("catalogue"))
    assert rows["cage slip (error in percentage points)"][4:] == ("–",) * 5  # zero to the printed digit
    assert all(len(row) == 4 for row in main_results(readers("plain")).values())  # no comment tells anything


def test_the_first_block_says_what_is_open_of_clearance_and_misalignment(readers):
    page = words(readers("catalogue"))
    assert "an inner ring 10 K warmer than the outer one takes all clearance." in page
    assert "misalignment of the shaft, not known and computed as none" in words(readers("plain"))


def test_viscosity_ratio_at_other_temperatures_falls_as_the_oil_warms(readers):
    tables = {getattr(block, "caption", ""): block for block in life_section.blocks(readers("catalogue"))}
    rows = tables["Viscosity ratio at other oil temperatures"].rows
    assert [row[0] for row in rows] == [
        "50 °C", "60 °C", "70 °C (this case)", "80 °C", "90 °C", "95 °C (κ = 1)"
    ]  # fmt: skip
    ratios = [float(row[1].text) for row in rows]
    assert all(colder > warmer for colder, warmer in pairwise(ratios))
    assert ratios[-1] == approx(1, abs=0.05)
    assert ratios[2] == approx(Numbers(readers("catalogue").result.path).ratings["viscosity_ratio"], abs=5e-3)


def test_what_to_do_next_keeps_limits_first_then_measures_then_checks(readers):
    def steps(name):
        (block,) = [block for block in verdict.blocks(readers(name))
                    if getattr(block, "title", "") == "What to do next"]  # fmt: skip
        return block.items

    assert steps("heavy")[0] == "take a bearing with a rating 1.24 times as large, or a load as much lower"
    assert steps("catalogue")[:3] == (
        "find out and specify oil temperature at the inlets (lubricant.inlet_temperature): moves life, "
        "torque most",
        "find out and specify number of rollers (bearing.rollers): moves largest load most",
        "give bearing.roughness for the film ratio",
    )
    assert "give bearing.roughness for the film ratio" in steps("plain")
    assert not any("C_r" in step for step in steps("plain"))
