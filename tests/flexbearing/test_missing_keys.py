"""Keys that a case lacks are told at once, each with its place."""

import re
import tomllib
from pathlib import Path

import pytest
from pydantic import BaseModel

from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.case.declarations import by_path, toml
from flexbearing.families import FAMILIES
from tests.places import CONFIGS

CASES = [
    "nu209_fits.toml",
    "mao2016.toml",
    "step_ring.toml",
    "heras2017_a3.toml",
    "slewing_bolted.toml",
    "harris218.toml",
]


def written(raw: dict) -> str:
    return "\n".join(f"{name} = {toml(value)}" for name, value in raw.items())


def refusal(raw: dict, folder: Path) -> list[str]:
    file = folder / "case.toml"
    file.write_text(written(raw))
    with pytest.raises(BadCase) as problem:
        read_case(file, ())
    return str(problem.value).splitlines()


def without_a_key_in_each_table(raw: dict, model: type[BaseModel]) -> list[str]:
    """Take the last required key out of every table that keeps another; the dotted keys taken out."""
    taken: dict[str, str] = {}
    for path, item in by_path(model).items():
        table, _, name = path.rpartition(".")
        inside = raw
        for part in table.split(".") if table else ():
            inside = inside.get(part, {})
        choice = len(item.choices) > 0  # decides what else is needed
        if item.required and not item.section and not choice and name in inside and name not in ("kind",):
            taken[table] = path
    for table, path in taken.items():
        inside = raw
        for part in table.split(".") if table else ():
            inside = inside[part]
        del inside[path.rpartition(".")[2]]
    raw.pop("assumed", None)
    return list(taken.values())


@pytest.mark.parametrize("name", CASES)
def test_a_key_missing_in_each_table_is_told_at_once_with_its_place(name, tmp_path):
    raw = tomllib.loads((CONFIGS / name).read_text())
    model = FAMILIES[raw.get("kind", next(iter(FAMILIES)))].case()
    taken = without_a_key_in_each_table(raw, model)
    assert len(taken) > 2
    lines = refusal(raw, tmp_path)
    for path in taken:
        table, _, key = path.rpartition(".")
        place = f"[{table}] {key} is missing" if table else f"{key} is missing"
        assert sum(place in line for line in lines) == 1
    assert len(lines) == len(taken)


def test_conditions_behind_a_missing_key_are_told_with_it(tmp_path):
    raw = tomllib.loads((CONFIGS / "nu209.toml").read_text())
    del raw["bearing"]["roller"]["length"], raw["bearing"]["clearance"], raw["lubricant"]["inlet_temperature"]
    del raw["lubricant"]["viscosity"], raw["lubricant"]["limiting_ratio"], raw["assumed"]
    raw["bearing"]["bore"] = "50 mm"
    text = "\n".join(refusal(raw, tmp_path))
    assert text.count("is missing") == 5
    assert '[bearing] bore = "50 mm" is not a key here' in text
    assert "[lubricant] viscosity is missing: an oil without name (oil) or data sheet (data_sheet)" in text
    assert '[lubricant] limiting_ratio is missing: traction = "eyring" needs it' in text
    assert "[bearing] clearance is missing" in text


def test_tables_that_are_missing_tell_what_they_hold(tmp_path):
    lines = refusal({"bearing": {"kind": "cylindrical_roller"}}, tmp_path)
    cage = next(line for line in lines if "[bearing] cage is missing" in line)
    assert re.search(
        r'a table with guidance \("outer" or .*\), pocket_friction \(a number.*thickness \(such as', cage
    )
    assert "land_diameter" not in cage  # only some kinds of guidance need it
    assert any("lubricant is missing" in line and "viscosity (such as" in line for line in lines)
    assert any("[materials] roller is missing" in line for line in lines)
    assert not any(
        re.search(r": materials is missing", line) for line in lines
    )  # its tables say what it holds


def test_one_round_of_messages_is_enough(tmp_path):
    """A case of the keys that were told, and of nothing else, is complete."""
    known = tomllib.loads((CONFIGS / "nu209.toml").read_text())
    start = {"bearing": {"kind": "cylindrical_roller", "rollers": 14}, "operation": {"radial_load": "4450 N"}}
    told = "\n".join(refusal(start, tmp_path))

    def of_told(table: dict) -> dict:
        inside = {name: of_told(value) if isinstance(value, dict) else value for name, value in table.items()}
        return {name: value for name, value in inside.items() if isinstance(value, dict) or name in told}

    case = of_told(known)
    assert "title" not in case
    assert "mass" not in case["bearing"]["cage"]
    case["bearing"] |= start["bearing"]
    case["operation"] |= start["operation"]
    file = tmp_path / "again.toml"
    file.write_text(written(case))
    read = read_case(file, ())
    assert read.title == "again"  # the name of the file
    assert read.bearing.cage.mass is None


@pytest.mark.parametrize("name", [".", "a.b", "..", ""])
def test_a_key_with_dots_in_its_name_is_refused_beside_a_missing_one(name, tmp_path):
    raw = tomllib.loads((CONFIGS / "nu209.toml").read_text())
    del raw["bearing"]["rollers"]
    raw["materials"]["roller"][name] = False
    lines = refusal(raw, tmp_path)
    assert any("is not a key here" in line for line in lines)
    assert any("[bearing] rollers is missing" in line for line in lines)
