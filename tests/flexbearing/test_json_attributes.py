"""JSON attributes of result files: their forms are declared, kept by the writer and asked of the reader."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

import flexbearing
from flexbearing.families import FAMILIES
from flexbearing.quantities.attributes import Attribute
from flexbearing.quantities.forms import COUNT, FLAG, NUMBER, TEXT, Each, ListOf, Record, Such
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import METRIC
from flexbearing.report.output import text
from flexbearing.report.page import page
from flexbearing.results import BadResult, NotInLayout, hdf5_read
from flexbearing.results.attributes import checked, decoded
from flexbearing.results.read import of_content
from tests.flexbearing.resealed import resealed
from tests.flexbearing.test_results import ENDING
from tests.places import CONFIGS

ROUGH = [f"bearing.roughness.{name}=0.1 um" for name in ("roller", "inner_raceway", "outer_raceway")]
RING = (
    "inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam", "accuracy.slices=8",
    "life.reliability=0.95", "outputs.catalogue_life=true", *ROUGH,
)  # fmt: skip
GOOD = {  # what this run does not have
    "clearance": {
        "operating_m": 3e-5,
        "cold_m": 5e-5,
        "steps": [{"name": "fit", "change_m": -2e-5, "clearance_m": 3e-5, "explanation": "pressed"}],
        "shaft_fit": "tight", "housing_fit": "loose", "verdict": "clearance remains",
    },
    "stresses": {"outer": {
        "bodies": {"ring": {
            "von_mises_MPa": 100.0, "von_mises_error_MPa": 2.0, "tension_MPa": 50.0,
            "tension_error_MPa": 1.0, "compression_MPa": -60.0, "compression_error_MPa": 3.0,
            "displacement_um": 4.0, "x_mm": 0.1, "radius_mm": 37.0, "azimuth_deg": 12.0,
        }},
        "loads": "rollers", "left_out": "", "seconds": 9.0,
        "support": {
            "tilting_Nm_per_rad": 1e5, "tilting_error_Nm_per_rad": 1e3,
            "axial_N_per_m": 1e7, "axial_error_N_per_m": 1e5,
        },
    }},
    "assumed_effects": {
        "of": {"life_L10_Mrev": 10.0},
        "keys": [{"key": "bearing.clearance", "source": "rule of thumb", "others": [{
            "words": "half", "settings": ["bearing.clearance=20 um"],
            "values": {"life_L10_Mrev": 12.0}, "problem": "",
        }]}],
    },
    "equilibria": ENDING["equilibria"],
    "choices": ENDING["choices"],
    "passage": ENDING["passage"],
    "error_estimate": {"target": 0.01, "met": True, "roller_load": 0.002, "life": None},
}  # fmt: skip
OTHERS = (None, True, 7, 2.5, "text", [], {}, [1], {"x": 1}, [[]])


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    """Content of a converged result with every JSON attribute."""
    path = tmp_path_factory.mktemp("json") / "good.h5"
    flexbearing.run(CONFIGS / "mao2016.toml", RING, output=path)
    content, _ = hdf5_read.content(path.read_bytes())
    return changed(content, **GOOD)


def changed(content, **records):
    """The same content with other records."""
    return stored(content, **{name: json.dumps(record) for name, record in records.items()})


def stored(content, **texts):
    """The same content with other texts of records."""
    return replace(content, attributes={**content.attributes, **texts})


def result_of(content):
    from flexbearing.results.content import digest

    return of_content(content, digest(content), Path("out.h5"), FAMILIES)


def places(record, place=()):
    """Places within a record, from the whole to its values; of a list, whose items are alike, both ends."""
    yield place
    items = record.items() if isinstance(record, dict) else ()
    if isinstance(record, list):
        items = {at: record[at] for at in (0, len(record) - 1) if record}.items()
    for key, item in items:
        yield from places(item, (*place, key))


def with_other(record, place, other):
    """The record with another value at a place; `KeyError` for `other` takes it away."""
    if not place:
        return other
    copy = dict(record) if isinstance(record, dict) else list(record)
    if len(place) == 1 and other is KeyError:
        del copy[place[0]]
    else:
        copy[place[0]] = with_other(record[place[0]], place[1:], other)
    return copy


def refusal(content):
    """Why a content is refused; of one that is read, page and summary are made (not laid out)."""
    try:
        result = result_of(content)
    except NotInLayout as problem:
        return str(problem)
    summary = result.summary()
    assert list(page(Reader(result, METRIC)))
    json.dumps(summary, allow_nan=False)
    return ""


ROLLER = [name for name, entry in FAMILIES["cylindrical_roller"].layout().attributes.items()
          if entry.kind in ("json", "records")]  # fmt: skip


@pytest.mark.sampled(6)
@pytest.mark.parametrize("name", [name for name in ROLLER if name != "case_si"])
def test_no_record_of_another_form_reaches_the_report(good, name):
    """Every value of every record, taken away or replaced: refused with its name, or harmless.

    Other values take turns: of ten neighbouring places each has two that the others have not.
    """
    record, refused = json.loads(good.attributes[name]), 0
    for number, place in enumerate(places(record)):
        for other in (*OTHERS[number % 5 :: 5], *([KeyError] if place else [])):
            wrong = with_other(record, place, other)
            problem = refusal(changed(good, **{name: wrong}))
            assert not problem or f"attribute {name} is not of its form: {name}" in problem
            assert len(problem) < 300
            refused += bool(problem)
    assert refused > 5


ODD = {
    "nested deeply": "[" * 400 + "]" * 400,
    "nested without end": "[" * 100_000,
    "object nested deeply": '{"a": ' * 50 + "1" + "}" * 50,
    "digits without end": "9" * 5000,
    "large whole number": "9" * 400,
    "beyond floats": "1e999",
    "not a number": "NaN",
    "infinite": "-Infinity",
    "half a character": '"\\ud800"',
    "two values": "1 2",
    "word": "nothing",
    "no JSON": "{'a': 1}",
    "zero byte": '"\x00',
}


@pytest.mark.parametrize("name", ["case_si", "structure", "calibrated", "error_estimate", "versions"])
@pytest.mark.parametrize("odd", ODD)
def test_json_that_no_reader_stands_is_refused(good, name, odd):
    for record in (ODD[odd], f'{{"a": {ODD[odd]}}}', f'{{"a": {{"b": [{ODD[odd]}]}}}}'):
        with pytest.raises(NotInLayout, match=f"attribute {name} is not of its form: ") as problem:
            result_of(stored(good, **{name: record}))
        assert len(str(problem.value)) < 300


def test_record_of_a_file_that_is_of_another_form_ends_with_bad_result(tmp_path):
    path = tmp_path / "out.h5"
    flexbearing.run(CONFIGS / "heras2017_a1.toml", [], output=path)
    resealed(path, lambda file: file.attrs.__setitem__("calibrated", '{"bearing.clearance": 1}'))
    with pytest.raises(BadResult) as problem:
        flexbearing.read(path)
    assert str(problem.value) == (
        f"{path}: attribute calibrated is not of its form: calibrated.bearing.clearance is 1; "
        "allowed is text. Run the case again."
    )


def test_case_without_a_key_that_the_summary_repeats_is_refused(tmp_path):
    path = tmp_path / "out.h5"
    flexbearing.run(CONFIGS / "joshi2015_fourpoint.toml", [], output=path)
    content, _ = hdf5_read.content(path.read_bytes())
    for case in ({}, {"friction": {}}, {"friction": []}, {"friction": {"torque": 1}}):
        with pytest.raises(NotInLayout, match="attribute case_si is not of its form: case_si"):
            result_of(changed(content, case_si=case))


@pytest.mark.parametrize("kind", FAMILIES)
def test_writer_stores_no_record_of_another_form(kind):
    layout = FAMILIES[kind].layout()
    for name, wrong in (("calibrated", {"a": 1}), ("versions", {"numpy": None}), ("case_si", [1])):
        with pytest.raises(NotInLayout, match=f"attribute {name} = "):
            checked(layout.attributes[name], wrong)
    assert {name for name, entry in layout.attributes.items() if entry.kind == "json"} <= set(ROLLER)


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_number_that_is_not_finite_is_refused(value):
    with pytest.raises(NotInLayout, match=r"wall_time_s = (nan|inf) is not finite"):
        decoded(Attribute("wall_time_s", "number", "time"), value)


FORMS = {
    "text": (TEXT, "a", 1),
    "number": (NUMBER, 1, "1"),
    "flag is no number": (NUMBER, 1.5, True),
    "number is no flag": (FLAG, False, 0),
    "fraction is no count": (COUNT, 3, 3.0),
    "list": (ListOf(TEXT), ["a"], {"a": "a"}),
    "item": (ListOf(TEXT), [], ["a", 1]),
    "object": (Each("part", NUMBER), {"a": 1}, []),
    "values": (Each("part", NUMBER), {}, {"a": "b"}),
    "names": (Each("rigid or flexible", NUMBER), {"rigid": 1}, {"stiff": 1}),
    "missing": (Record({"a": NUMBER}), {"a": 1}, {}),
    "unknown": (Record({"a": NUMBER}), {"a": 1}, {"a": 1, "b": 1}),
    "optional": (Record({}, {"a": NUMBER}), {"a": 1}, {"a": "b"}),
    "further": (Record({}, further=NUMBER), {"a": 1}, {"a": "b"}),
    "empty": (Record({"a": NUMBER}, empty=True), {}, {"a": "b"}),
    "such": (Such(NUMBER, lambda value: value > 0, "above zero"), 1, -1),
}


@pytest.mark.parametrize("name", FORMS)
def test_form_takes_what_it_says_and_nothing_else(name):
    form, right, wrong = FORMS[name]
    assert not form.problem(right)
    assert form.problem(wrong)


def test_unfinished_result_is_summarised(tmp_path, monkeypatch):
    """Records that the end of a run decides are empty until then."""
    monkeypatch.setattr("flexbearing.runs.roller.Postprocessing.attributes", lambda self: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        flexbearing.run(CONFIGS / "mao2016.toml", RING, output=tmp_path / "out.h5")
    (part,) = tmp_path.glob("*.part")
    assert "unfinished" in text(flexbearing.read(part)).lower()
