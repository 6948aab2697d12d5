"""A case as programs and notebooks hold it."""

from pathlib import Path

import numpy as np
import pytest
from pytest import approx

import flexbearing as fb

CONFIGS = Path(__file__).parents[2] / "configs"
PAGE = {
    "bore": "50 mm", "outside": "90 mm", "width": "20 mm", "inner_raceway": "59.5 mm",
    "outer_raceway": "81.5 mm", "clearance": "30 um", "oil": "ISO VG 68", "load": "15 kN",
    "speed": "3000 rpm",
}  # fmt: skip

BASIC = dict.fromkeys(("life.cleanliness", "life.lubrication", "life.capacity", "life.edge_stress"))


@pytest.fixture(scope="module")
def case():
    return fb.new("cylindrical_roller", **PAGE)


@pytest.fixture(scope="module")
def result(case):
    return case.run()


def test_none_takes_a_key_out_and_other_values_replace_it(case):
    changed = case.with_({"operation.radial_load": "8 kN", **BASIC})
    assert changed.head.operation.radial_load == 8e3
    assert changed.head.life.is_basic
    assert not case.head.life.is_basic


def test_a_saved_case_is_the_case(case, tmp_path):
    changed = case.with_(
        {"operation.radial_load": "8 kN", "life.cleanliness": "oil, in-line filter, -/15/12"}
    )
    again = fb.Case(changed.save(tmp_path / "case.toml"))
    assert again.head.to_json() == changed.head.to_json()
    with pytest.raises(fb.BadOutput, match="is there already"):
        case.save(tmp_path / "case.toml")


def test_an_entry_that_is_none_is_named(case):
    with pytest.raises(fb.BadCase, match="boar is no entry; there are bore"):
        fb.new("cylindrical_roller", boar="50 mm")


def test_messages_name_what_python_calls_it(case):
    with pytest.raises(fb.BadCase, match=r"^outside \(outside diameter\) is missing") as missing:
        fb.new("cylindrical_roller", bore="50 mm")
    with pytest.raises(fb.BadCase, match=r"^like cylindrical_roler: .*Did you mean") as unknown:
        fb.new("cylindrical_roler", bore="50 mm")
    with pytest.raises(fb.BadCase, match=r"^bore 50 ") as unreadable:
        fb.new("cylindrical_roller", **{**PAGE, "bore": "50"})
    assert not any("--" in str(each.value) for each in (missing, unknown, unreadable))


def test_one_name_is_a_list_of_one(case):
    table = case.sweep({"operation.radial_load": ["8 kN"]}, ["max_roller_load [kN]"])
    assert (
        table["max_roller_load [kN]"].values[0]
        == case.with_({"operation.radial_load": "8 kN"}).run()["max_roller_load [kN]"].number
    )
    assert [each.name for each in case.sensitivity("cage_slip", "bearing.clearance").outputs] == ["cage_slip"]


def test_life_is_the_most_detailed_one_that_there_is(result, case):
    assert result["life [h]"] == result["modified_life [h]"]
    basic = case.with_({**BASIC}).run()
    assert basic["life [h]"] == basic["life_L10 [h]"]
    assert result["life [h]"].number == approx(result["life"].to("h").number)


def test_outputs_are_a_table_of_what_the_case_gives(result):
    assert len(result.outputs) == len([*result.outputs]) > 40
    assert "max_roller_load" in result.outputs
    assert all(np.isfinite(value.number) for value in result.outputs.values())
    found = result.outputs.search("Stiffness")
    assert 0 < len(found) < len(result.outputs)
    assert "N/m" in repr(found)
    assert "<td>" in found._repr_html_()


def test_a_rigid_case_has_no_flexible_group(result):
    assert set(result.to_xarray()) == {"rigid"}


def test_pictures_have_short_names(result):
    assert {"loads", "pressure"} <= set(dir(result.plot))
    assert result.plot.loads().axes
    with pytest.raises(fb.AbsentOutput, match=r"plot\.load: is no picture of this result; there are"):
        result.plot.load()


def test_a_report_is_written_without_a_result_file(result, tmp_path):
    place = result.report(tmp_path / "a.html")
    assert result.attributes["title"] in place.read_text()


def test_a_sweep_gives_what_runs_give(case, tmp_path):
    table = case.sweep({"operation.radial_load": "8 .. 10 kN, 3"})
    assert table["operation.radial_load"].values == (8e3, 9e3, 10e3)
    run = case.with_({"operation.radial_load": "9 kN"}).run()
    assert table["modified_life [h]"].values[1] == approx(run["life [h]"].number, rel=1e-6)
    assert len(table.plot("modified_life").axes) == 1


def test_a_study_as_a_dictionary_is_its_file(case, tmp_path):
    over, clean = {"operation.radial_load": ["8 kN"]}, {"life.cleanliness": "oil, in-line filter, -/15/12"}
    collect = {"life": "modified_life [h]"}
    wanted = {"case": case, "set": clean, "over": over, "collect": collect}
    by_dictionary = fb.study(wanted, tmp_path / "one")
    case.save(tmp_path / "case.toml")
    (tmp_path / "s.toml").write_text(
        'case = "case.toml"\n[set]\n"life.cleanliness" = "oil, in-line filter, -/15/12"\n'
        '[over]\n"operation.radial_load" = ["8 kN"]\n[collect]\nlife = "modified_life [h]"\n'
    )
    by_file = fb.study(tmp_path / "s.toml", tmp_path / "two")
    run = case.with_(clean | {"operation.radial_load": "8 kN"}).run()
    assert by_dictionary["life"].values == by_file["life"].values
    assert by_file["life"].values[0] == approx(run["life [h]"].number, rel=1e-6)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"life.cleanlines": "oil"}, "Did you mean cleanliness"),
        ({"operation.radial_load": "1 kN"}, "is varied, too"),
    ],
)
def test_a_wrong_table_of_settings_is_refused(case, tmp_path, settings, words):
    wanted = {"case": case, "set": settings, "over": {"operation.radial_load": ["8 kN"]}}
    with pytest.raises(fb.BadCase, match=rf"\[set\].*{words}"):
        fb.study(wanted, tmp_path)


def test_an_optimisation_takes_the_case_as_it_is_changed(case, tmp_path):
    problem = {
        "vary": {"bearing.roller.length": "9 mm .. 11 mm"},
        "maximise": {"output": "life_L10 [h]"},
        "search": {"starts": 1},
    }
    best = case.with_({"operation.radial_load": "8 kN"}).optimise(problem, tmp_path)
    run = fb.run(tmp_path / "optimisation_optimum.toml")
    assert best.converged
    assert fb.Case(tmp_path / "optimisation_optimum.toml").head.operation.radial_load == 8e3
    assert run["life_L10 [h]"].number > case.run()["life_L10 [h]"].number
