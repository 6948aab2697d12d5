"""Findings: every limit is declared once, and note, check and report follow it."""

import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from pytest import approx

from flexbearing import api, findings
from flexbearing.findings import DANGER, MET, NOT_CHECKED, NOT_MET, OUTSIDE, USUAL, declared
from flexbearing.findings.finding import AT_MOST
from flexbearing.findings.row import RowFinding, in_rows, information, of_records, read, words, written
from flexbearing.report.html import METRIC, checks as of_report
from flexbearing.report.html.reader import Reader
from flexbearing.runs import angular_contact, fields, groove_fields, judged
from flexbearing.units import unit
from quasidynamic.contact.film.roughness import MIXED_FROM
from quasidynamic.outcome import rating_life
from tests.flexbearing.hostile_cases import CONFIGS

# kind of case with a value of the finding: keys that it needs
A_ISO = ("life.lubrication=a_ISO", "life.cleanliness=oil, in-line filter, -/17/14")
ROLLERS = ("nu209_fits.toml", "operation.misalignment=1 arcmin", "life.required=1 h", *A_ISO)
BARS = ("mao2016.toml", "accuracy.structure=beam", "materials.outer_ring.yield_stress=900 MPa")
BALLS = (
    "harris218.toml",
    "lubricant.oil=ISO VG 68",
    "lubricant.inlet_temperature=60 degC",
    "life.required=1 h",
    "life.dynamic_rating=70 kN",
    *A_ISO,
)
DEEP = ("6209.toml",)
STRESSED = (
    "6209.toml", "outer.kind=ring", "outer.thickness=5 mm", "outer.width=19 mm", "outputs.stresses=true",
    "bearing.outer.shoulder=2.2 mm", "accuracy.stations=3", "accuracy.element_order=3",
    "accuracy.patch_width=2 mm", "materials.outer_ring.youngs_modulus=206 GPa",
    "materials.outer_ring.poisson_ratio=0.3", "materials.outer_ring.yield_stress=900 MPa",
)  # fmt: skip
RATED = ("catalogue/nj2210.toml", "bearing.roller.length=12 mm")
RATED_BALLS = ("catalogue/6208.toml", "bearing.balls=8")
THRUST = (
    *ROLLERS, "operation.axial_load=-500 N", "bearing.ribs.inner_height=1.5 mm",
    "bearing.ribs.outer_height=1.2 mm", "bearing.ribs.end_radius=500 mm", "bearing.ribs.friction=0.05",
)  # fmt: skip
OF_RATINGS = ("rating-above-formula", "rating-below-formula", "changed-rating")
FLEXIBLE = ("yield-stress", "stiffness-not-in-series")  # which rigid rings do not have
LIMITS = {  # code, grade and quantity that the limit is a multiple of, to the number
    ("contact-pressure", DANGER, "static_pressure"): 1.0,
    ("static-safety", DANGER, ""): 1.0,
    ("static-safety", USUAL, ""): 1.5,  # SKF
    ("yield-stress", DANGER, "yield_stress"): 1.0,
    ("heavy-load", OUTSIDE, "dynamic_rating"): 0.5,  # ISO 281
    ("heavy-load", OUTSIDE, "static_rating"): 1.0,  # ISO 281, of balls
    ("axial-load", DANGER, "radial_load"): 0.5,  # SKF
    ("rib-strength", DANGER, "rib_strength"): 1.0,
    ("rib-strength", USUAL, "rib_strength_of_series_2"): 1.0,
    ("rib-heat", USUAL, "warm_rib_load"): 1.0,
    ("short-life", DANGER, ""): 3600.0,
    ("rating-above-formula", USUAL, ""): 1.15,
    ("rating-below-formula", USUAL, ""): 1 / 1.15,
    ("changed-rating", OUTSIDE, ""): 2.0,
    ("required-life", DANGER, "required_life"): 1.0,
    ("limiting-speed", DANGER, "limiting_speed"): 1.0,
    ("reference-speed", USUAL, "reference_speed"): 1.0,  # ISO 15312
    ("viscosity-ratio", USUAL, ""): 1.0,
    ("no-modified-life", OUTSIDE, ""): 0.1,  # ISO 281
    ("film-ratio", USUAL, "mixed_film_ratio"): 1.0,
    ("stiffness-not-in-series", OUTSIDE, ""): 0.02,
    ("no-positive-stiffness", OUTSIDE, ""): 0.0,
    ("neglected-force", DANGER, ""): 0.1,
    ("neglected-force", OUTSIDE, ""): 0.01,
    ("reversed-thrust", DANGER, ""): 0.0,
    ("contact-height", DANGER, ""): 0.45,
    ("gyroscopic-moment", OUTSIDE, "friction"): 1.0,
    ("gyroscopic-slip", OUTSIDE, "friction"): 1.0,
    ("several-equilibria", DANGER, ""): 0.01,
    ("preload", USUAL, ""): 0.0,
    ("raceway-slope", USUAL, ""): np.radians(4 / 60),
    ("pressed-end", OUTSIDE, ""): 0.095,
    ("rib-contact", OUTSIDE, ""): 1.0,
    ("contact-at-roller-end", OUTSIDE, ""): 0.745,  # (1 - 1/1.5^2)^(1/2)
    ("small-oscillation", OUTSIDE, ""): 1.0,  # of the width of the contacts
}
QJ = ("joshi2015_qj309.toml", "operation.speed=10000 rpm", "operation.load.axial=2 kN")
BASES = {"static_pressure": rating_life.ROLLERS, "dynamic_rating": 7e4, "static_rating": 6e4,
         "yield_stress": 9e8, "friction": 0.1, "mixed_film_ratio": MIXED_FROM,
         "required_life": 7.2e7, "radial_load": 4e3, "rib_strength": 5e3, "rib_strength_of_series_2": 4e3,
         "warm_rib_load": 1e3, "limiting_speed": 900.0, "reference_speed": 800.0}  # fmt: skip
HELD = (str(Path(__file__).with_name("held_in_a_cage.toml")),)
OTHER_BALLS = {"preload": DEEP, "yield-stress": STRESSED, "several-equilibria": HELD}
CASES = [
    *((number, "OF_ROLLERS",
       BARS if each.code in FLEXIBLE else RATED if each.code in OF_RATINGS
       else THRUST if each in declared.RIBS else ROLLERS)
      for number, each in enumerate(declared.OF_ROLLERS)),
    *((number, "OF_BALLS",
       OTHER_BALLS.get(each.code, RATED_BALLS if each.code in OF_RATINGS else BALLS))
      for number, each in enumerate(declared.OF_BALLS)),
    (declared.OF_SLOW_BALLS.index(declared.GYROSCOPIC_SLIP), "OF_SLOW_BALLS", QJ),
    (declared.OF_TAPERED.index(declared.RIB_CONTACT), "OF_TAPERED", ("32207.toml",)),
    (declared.OF_SPHERICAL_ROLLERS.index(declared.CUT_ELLIPSE), "OF_SPHERICAL_ROLLERS", ("22210.toml",)),
]  # fmt: skip


@pytest.fixture(autouse=True, scope="module")
def each_case_solved_once():
    """Runs that differ in their limits alone share balance, motions and stresses, which take most of them."""
    with pytest.MonkeyPatch.context() as patch:
        for module, name in (
            (angular_contact, "_balanced"),
            (angular_contact, "_force_of_motions"),
            (groove_fields, "stresses"),
        ):
            patch.setattr(module, name, remembered(getattr(module, name)))
        yield


def remembered(function):
    """Its answers by the case, or the cases, and the number of the other arguments."""
    known = {}

    def answer(cases, *others):
        key = str(cases), len(others)
        if key not in known:
            known[key] = function(cases, *others)
        return known[key]

    return answer


@cache
def computed(case, settings):
    return api.run(CONFIGS / case, settings)


def records(result, finding):
    """Stored records of a finding."""
    return [
        each for each in result.attributes["findings"]
        if (each["code"], each["grade"], each["source"]) == (finding.code, finding.grade, finding.source)
    ]  # fmt: skip


def test_declared_limits_are_those_of_their_sources():
    found = {(each.code, each.grade, each.times): each.limit for each in declared.DECLARED}
    light = [each.limit for each in (declared.LIGHT_LOAD_OF_ROLLERS, declared.LIGHT_LOAD_OF_BALLS)]
    assert light == [0.02, 0.01]
    pressures = (rating_life.ROLLERS, rating_life.BALLS, rating_life.SELF_ALIGNING_BALLS)
    assert pressures == (4.0e9, 4.2e9, 4.6e9)  # ISO 76
    assert MIXED_FROM == 1.0
    assert {key: limit for key, limit in found.items() if key[0] != "light-load"} == LIMITS


@pytest.mark.parametrize(
    ("number", "table", "case"), CASES, ids=lambda each: str(each) if isinstance(each, int | str) else each[0]
)
def test_note_check_and_report_follow_each_limit(monkeypatch, number, table, case):
    """With its limit moved to the other side of the value, every view says the other."""
    finding = getattr(declared, table)[number]
    file, *settings = case
    before = computed(file, tuple(settings))
    known = records(before, finding)
    assert known, "the case has no value of it"
    first = max(known, key=lambda each: each["share"] or 0.0)
    past = {MET: 0.5, NOT_MET: 2.0}[first["verdict"]]
    factor = past * first["value"] / first["limit"] if first["limit"] else None
    if finding.side != AT_MOST and factor:
        factor = first["value"] / first["limit"] / past
    limit = 2 * first["value"] if factor is None else factor * finding.limit
    side = "at_most" if finding.side == AT_MOST else "at_least"
    moved = replace(finding, **{side: limit})
    others = (moved if each is finding else each for each in getattr(declared, table))
    monkeypatch.setattr(declared, table, tuple(others))
    after = api.run(CONFIGS / file, settings)
    assert max(records(after, finding), key=lambda each: each["share"] or 0.0)["verdict"] != first["verdict"]
    seen = [_views(result, finding, first["place"]) for result in (before, after)]
    assert seen[0]["check"] != seen[1]["check"]
    assert seen[0]["limit"] != seen[1]["limit"]
    if finding.noted:
        assert seen[0]["note"] != seen[1]["note"]
    else:
        assert [each["note"] for each in seen] == [[], []]


def _shown(number, finding):
    """A number in the unit that people see it in."""
    return unit(finding.shown or finding.unit or "1").of_si(number)


def _views(result, finding, place):
    """What note, check and the limits on the page say of it."""
    reader = Reader(result, METRIC)
    checks = [
        each for each in of_report.ranked(reader)
        if each.what.lower().startswith(finding.label.lower()) and each.place == place
    ]  # fmt: skip
    if finding.of_model and not checks:
        return {"check": "none, as it is kept", "limit": "", "note": []}
    (check,) = checks
    stored = [each for each in result.attributes["findings"]
              if (each["code"], each["place"]) == (finding.code, place)]  # fmt: skip
    for name, text in (("limit", check.limit), ("value", check.value.text)):
        printed = float(re.search(r"-?\d[\d.,]*(e[+-]?\d+)?", text)[0].replace(",", ""))
        assert any(printed == approx(_shown(each[name], finding), rel=1e-3, abs=1e-3) for each in stored)
    notes = [
        (note["grade"], note["text"]) for note in result.attributes["notes"] if note["code"] == finding.code
    ]
    return {"check": check.verdict, "limit": check.limit, "note": notes}


@pytest.mark.parametrize("finding", declared.DECLARED, ids=lambda each: f"{each.code}-{each.limit:g}")
def test_note_and_check_change_at_the_limit(finding):
    limit = finding.limit * BASES.get(finding.times, 1.0)
    step = 1e-6 * (limit or 1.0)
    result = computed("nu209.toml", ())
    for value in (limit - step, limit + step):
        found = findings.evaluate([finding], BASES | {finding.quantity: value})
        about = {**result.attributes, "findings": [*map(vars, findings.records(found))]}
        reader = Reader(replace(result, attributes=about), METRIC)
        checks = [each for each in of_report.ranked(reader) if not each.unchecked]
        broken = (value > limit) == (finding.side == AT_MOST)
        if finding.of_model and not broken:
            assert checks == []
        else:
            assert [check.verdict.startswith("met") for check in checks] == [not broken]
        assert bool(judged.notes(found)) == (broken and finding.noted)


def test_values_are_those_of_the_result():
    result = computed(ROLLERS[0], ROLLERS[1:])
    found = {(each["code"], each["place"]): each["value"] for each in result.attributes["findings"]}
    summary = result.summary()["flexible"]
    turns = 1e6 * result.attributes["life"]["flexible"]["modified_Mrev"]
    assert found["short-life", ""] == approx(turns * 60 / 3000)
    for race in ("inner", "outer"):
        assert found["film-ratio", f"{race} raceway"] == approx(summary["minimum_lambda"][race])


def test_balls_are_judged_by_their_ratings_and_those_that_turn_freely_by_no_friction():
    settings = ("life.static_rating=60 kN", "life.dynamic_rating=70 kN")
    judged_at, free = computed(BALLS[0], settings), computed(BALLS[0], ("operation.control=coulomb",))
    limits = (declared.LOAD_ABOVE_STATIC_RATING, declared.HEAVY_LOAD, declared.LIGHT_LOAD_OF_BALLS)
    assert [records(judged_at, each)[0]["limit"] for each in limits] == [60e3, 35e3, 700.0]
    assert [len(records(each, declared.GYROSCOPIC_MOMENT)) for each in (judged_at, free)] == [1, 0]
    turns, speed = (
        judged_at["life_L10"].number * 1e6,
        judged_at.attributes["case_si"]["operation"]["inner_speed"],
    )
    assert records(judged_at, declared.SHORT_LIFE)[0]["value"] == approx(turns * 2 * np.pi / speed)


def test_bodies_are_judged_by_the_yield_stress_of_their_material():
    case = api.read_case(CONFIGS / BARS[0], BARS[1:])
    found = fields.values(case, {"outer": {"bodies": {"ring": {"von_mises_MPa": 5.0}}}})
    place = "outer: ring (von Mises)"
    assert found == {"stress": {place: 5e6}, "yield_stress": {place: 9e8}}


def test_clearance_is_judged_at_the_tight_end_of_the_tolerances():
    result = computed("catalogue/nu210.toml", ())
    tight, ends = records(result, declared.CLEARANCE)[1], result.attributes["clearance"]["tolerances"]["ends"]
    assert (tight["value"], tight["verdict"]) == (ends["tightest_m"], MET)


def test_slope_counts_the_lean_of_elastic_raceways():
    """Radial distance between the raceways along the most loaded roller, end by end."""
    result = computed(BARS[0], BARS[1:])
    block = result.flexible
    roller, along = np.argmax(block["inner_load"]), block["slice_position"]
    azimuth = block["roller_azimuth"][roller]
    gap = block["inner_deviation"][roller] - block["outer_deviation"][roller]
    gap = gap + along * (block["ring_tilt"] @ (np.cos(azimuth), np.sin(azimuth)))
    (found,) = records(result, declared.RACEWAY_SLOPE)
    assert found["value"] == approx(abs(np.cov(along, gap)[0, 1] / np.var(along, ddof=1)), rel=1e-6)


def test_values_are_judged_cases_first():
    values = {"static_safety": np.array([0.9, 1.2, 1.6]), "contact_pressure": {"inner": 5e9, "outer": 3e9},
              "static_pressure": 4e9}  # fmt: skip
    found = findings.evaluate(declared.OF_ROLLERS, values)
    by_case = [[(note.code, note.grade) for note in judged.notes(found[2:], case)] for case in range(3)]
    assert by_case == [[("static-safety", "danger")], [("static-safety", "information")], []]
    (note,) = judged.notes(found[:2])
    assert "inner: 5,000 MPa, at most 4,000 MPa (ISO 76)" in note.text
    first = found[0].record()
    assert (first.share, first.verdict, first.limit) == (approx(1.25, rel=1e-12), NOT_MET, 4e9)


def test_share_of_a_limit_from_below_is_the_limit_over_the_value():
    found = findings.evaluate(declared.OF_ROLLERS, {"static_safety": np.array([0.8, 2.0])})
    assert (found[0].finding.at_least, found[0].share) == (1.0, approx([1.25, 0.5]))


def test_findings_of_rows_are_named_by_code_and_grade():
    """A table keeps no more of them: limit, source and meaning are those that are declared."""
    of_rows = [(each.code, each.grade) for each in declared.DECLARED if in_rows(each.code, each.grade)]
    assert len(of_rows) == len({*of_rows})


def test_what_is_usual_in_catalogues_is_checked_and_not_noted():
    silent = {each.code for each in declared.DECLARED if not each.noted}
    assert silent == {"viscosity-ratio", "film-ratio", "preload", "raceway-slope"}


def test_rows_hold_six_digits():
    (found,) = findings.records(findings.evaluate([declared.STATIC_SAFETY], {"static_safety": 0.123456789}))
    (row,) = of_records([found])
    assert (row.value, row.limit) == (0.123457, 1.0)


ROW = RowFinding("contact-pressure", DANGER, 4.5e9, 4e9, ("inner", "outer"))
NO_ROWS = {
    "no JSON": "danger: life",
    "no list": '{"code":"life"}',
    "unknown code": '[{"code":"weight","grade":"danger","value":1.0,"limit":2.0}]',
    "unknown grade": '[{"code":"seen","grade":"grave","text":"seen"}]',
    "number as text": written([ROW]).replace("4500000000.0", '"4.5e9"'),
    "no number": written([ROW]).replace("4500000000.0", "NaN"),
    "without a limit": written([ROW]).replace('"limit":4000000000.0,', ""),
    "further keys": written([ROW]).replace('"code"', '"label":"life","code"'),
    "number and text": written([ROW]).replace('"code"', '"text":"life","code"'),
    "deep": "[" * 100_000,
}


def test_a_cell_holds_findings_whole():
    found = (ROW, information("seen", 'a "text";\nof two lines'))
    assert read(written(found)) == found
    assert (read(written(())), written(())) == ((), "")
    assert words(found[:1]).startswith("danger: peak contact pressure, inner and outer: 4,500 MPa, at most 4")


def test_values_of_several_rows_are_a_range_from_the_least_to_the_greatest():
    assert "inner and outer: 4,400 to 4,600 MPa, at most 4" in ROW.words([4.5e9, 4.6e9, 4.4e9])


@pytest.mark.parametrize("cell", NO_ROWS.values(), ids=NO_ROWS)
def test_a_cell_with_something_else_is_refused(cell):
    with pytest.raises(ValueError):  # noqa: PT011
        read(cell)


def test_what_to_act_on_first_is_the_gravest_broken_one_else_the_nearest_to_its_limit():
    (anything,) = findings.records(findings.evaluate([declared.STATIC_SAFETY], {"static_safety": 2.0}))

    def record(grade, verdict, share):
        return replace(anything, grade=grade, verdict=verdict, share=share)

    far, near = record(DANGER, "met", 0.2), record("usual", "met", 0.9)
    slight, grave, graver = (
        record(grade, NOT_MET, share) for grade, share in (("usual", 5.0), (DANGER, 1.1), (DANGER, 1.3))
    )
    assert findings.gravest([far, near]) is near
    assert findings.gravest([near, slight, far]) is slight
    assert findings.gravest([slight, grave, graver, near]) is graver


def test_a_note_names_the_places_of_its_grade_alone():
    shares = {"neglected": {"weight": 0.2, "friction": 0.05}}
    found = findings.evaluate((declared.MUCH_NEGLECTED, declared.NEGLECTED), shares)
    ((worst, places),) = findings.by_code(each for each in findings.records(found) if each.broken)
    assert (worst.grade, places) == (DANGER, ("weight",))


@pytest.mark.parametrize("family", ["OF_ROLLERS", "OF_BALLS"])
def test_a_negative_stiffness_is_a_finding(family):
    found = findings.evaluate(getattr(declared, family), {"least_stiffness": -1e6})
    assert [note.code for note in judged.notes(found)] == ["no-positive-stiffness"]


@pytest.mark.parametrize("case", ["harris218.toml", "joshi2015_qj309.toml"])
def test_balls_are_judged_by_their_radial_stiffness(case):
    result = computed(case, ())
    radial = result.rigid["stiffness_matrix"][1:3, 1:3]
    (found,) = records(result, declared.LEAST_STIFFNESS)
    assert found["value"] == approx(np.linalg.eigvalsh((radial + radial.T) / 2)[0], rel=1e-9)


def test_a_life_lasts_as_long_in_either_sense_of_rotation():
    assert judged.seconds([2.0, 2.0], [100 * np.pi, -100 * np.pi]) == approx([4e4, 4e4])


def test_a_limit_that_the_case_does_not_give_is_not_checked_and_warns_of_nothing():
    (found,) = findings.evaluate(
        declared.OF_ROLLERS, {"stress": {"bars": 1e9}, "yield_stress": {"bars": None}}
    )
    assert replace(found.record(), verdict=NOT_CHECKED, limit=None, share=None) == found.record()
    assert judged.notes([found]) == ()


@pytest.mark.parametrize("value", [np.inf, np.nan])
def test_what_is_not_finite_is_not_stored(value):
    found = findings.evaluate(declared.OF_ROLLERS, {"life": value})
    assert findings.records(found) == []


def test_dangers_are_notes_of_findings_that_are_not_met():
    settings = ["operation.radial_load=100 kN"]
    result = api.run(CONFIGS / "nu209.toml", settings)
    codes = [note["code"] for note in result.attributes["notes"] if note["grade"] == "danger"]
    assert codes == ["contact-pressure", "static-safety", "short-life"]
    broken = [each["code"] for each in result.attributes["findings"]
              if each["verdict"] == NOT_MET and each["grade"] == DANGER]  # fmt: skip
    assert list(dict.fromkeys(broken)) == codes
