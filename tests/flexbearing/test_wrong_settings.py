"""Whatever stands at a key of a study, an optimisation or a profile: it is refused in a line, or taken."""

from collections.abc import Iterator
from copy import deepcopy
from typing import Any

import pytest

from flexbearing import __main__ as program
from flexbearing.case import BadCase
from flexbearing.case.declarations import declared, toml
from flexbearing.case.quantity import Section
from flexbearing.optimise.run import optimise
from flexbearing.optimise.schema import OptimisationFile
from flexbearing.studies.file.schema import StudyFile
from flexbearing.studies.file.slurm_profile import SlurmProfile, profile
from flexbearing.studies.prepare import prepare_source
from tests.flexbearing.toy_studies import CASE

LONGEST = 900  # characters of a line: 500 of what is wrong with a variant, and its settings
LITERALS = (
    "1", "-1", "0", "1e308", "-1e308", "1000000000000000000", "nan", "-inf", "true", "2024-02-30T00:00:00",
    "1979-05-27", "07:32:00", '""', '" "', '"x"', '"nan"', '"inf"', '"1e999"', '"-1e999 N"', '"1 .. 2, 3"',
    '"nan .. inf, 3"', '"1e999 .. 2e999, 3"', '"1 N .. 2 mm, 3"', '"1 N .. 2 N"', '"log -1 .. 1, 3"',
    '"log 0 .. 1"', '"normal 1, inf"', '"uniform 0, 1e999"', '"lognormal 1, nan"', '"<= nan"', '"<= 1e999"',
    '">= 1 x"', '".. .."', '"/ / /"', '"."', '"/"', '"[N]"', '"\\u001b[31m"', "[]", "[1]", "[1, 2]", "[[]]",
    '["x"]', '["1 N", 1, true]', "[[1], [2]]", "[1979-05-27]", "{}", "{x = 1}", "[{}]", "[{x = 1}]",
    f'"{"9" * 5000}"', f'["{"9" * 70} N"]', f'"{"x" * 20_000}"',
)  # fmt: skip
KEYS = (  # of a case: a quantity, numbers, a list, a choice, tables, and what is none
    "operation.inner_speed", "accuracy.slices", "accuracy.target", "bearing.roller.point_drops", "outer.kind",
    "lubricant", "assumed", "title", "kind", "nonsense", "bearing.roller.point_drops.3",
)  # fmt: skip
LOAD = {"operation.radial_load": ["1 kN", "2 kN"]}
STUDIES = (
    {"over": LOAD, "collect": {"life": "life_L10 [h]"},
     "plot": {"x": "operation.radial_load", "y": ["life"],
              "marks": [{"y": "life", "value": "1 h", "label": "a", "source": "b"}]}},
    {"sample": {"count": 2, "operation.radial_load": "uniform 1 kN, 2 kN"},
     "duty": {"time": ["50 %", "50 %"], "operation.misalignment": ["0 deg", "0.1 deg"]}},
)  # fmt: skip
OPTIMISATION = {
    "vary": {"bearing.clearance": "10 um .. 60 um"}, "maximise": {"output": "life_L10 [h]"},
    "constrain": {"cage_slip": "<= 6 %"}, "search": {"starts": 2}, "set": {}, "surrogate": {}, "verify": [{}],
}  # fmt: skip
PROFILE = {"jobs": 1, "memory": "1 GB"}


class Raw(str):
    """A value as the file has it."""


class Computes(Exception):
    """Everything was checked."""


def places(model: type[Section], *tables: str) -> Iterator[tuple[str, ...]]:
    """Every key of a schema, also those of a case that its tables take."""
    for item in declared(model):
        yield tuple(item.path.split("."))
    for table in tables:
        yield from ((table, key) for key in KEYS)


def written(tables: dict[str, Any]) -> str:
    return "\n".join(f"{key} = {_value(value)}" for key, value in tables.items())


def _value(value: Any) -> str:
    if isinstance(value, Raw):
        return value
    if isinstance(value, dict):
        return "{" + ", ".join(f"{toml(key)} = {_value(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_value, value)) + "]"
    return toml(value)


def changed(tables: dict[str, Any], place: tuple[str, ...], literal: str) -> dict[str, Any]:
    """The tables with another value at a place; in the first table of a list of them."""
    found = deepcopy(tables)
    table: Any = found
    for name in place[:-1]:
        table = table.setdefault(name, {})
        table = table[0] if isinstance(table, list) else table
    table[place[-1]] = Raw(literal)
    return found


def wrong(take, file, tables, places) -> list[str]:
    """What ends otherwise than in a short line; the literals take turns, so that it is soon known."""
    found = []
    for number, place in enumerate(places):
        turns = 12 if place[-1] in KEYS else 4
        for literal in LITERALS[number % turns :: turns]:
            file.write_text(written(changed(tables, place, literal)))
            where = f"{'.'.join(place)} = {literal[:40]}"
            try:
                take(file)
            except BadCase as problem:
                lines = str(problem).splitlines()
                if not lines or max(map(len, lines)) > LONGEST:
                    found.append(f"{where}: {str(problem)[:200]}")
            except Computes:
                pass
            except Exception as problem:
                found.append(f"{where}: {type(problem).__name__}: {str(problem)[:200]}")
    return found


def checked(file):
    prepare_source(file).plan.require_sound()


def searched(file):
    def computes(problem, folder):
        raise Computes

    optimise(file, file.parent / "results", work=computes)


@pytest.mark.parametrize("study", STUDIES, ids=["over", "sample"])
def test_studies(study, tmp_path):
    keys = [*places(StudyFile, "over", "sample", "duty", "collect")]
    keys = [place for place in keys if place[0] in {*study, "case", "name", "results", "search_equilibria"}]
    assert wrong(checked, tmp_path / "s.toml", {"case": str(CASE), **study}, keys) == []


def test_optimisations(tmp_path):
    keys = [*places(OptimisationFile, "set", "vary", "surrogate", "verify", "constrain", "over")]
    keys = [place for place in keys if place[0] not in ("duty",)]
    assert wrong(searched, tmp_path / "o.toml", {"case": str(CASE), **OPTIMISATION}, keys) == []


def test_profiles(tmp_path):
    assert wrong(profile, tmp_path / "p.toml", PROFILE, places(SlurmProfile)) == []


IMPOSSIBLE = {  # in each table alone; the message names it
    '[set]\n"operation.radial_load" = "x kN"': r"o.toml: \[set\]: .*radial_load = .x kN",
    '[set]\n"operation.radial_load" = ["5 kN", 1]': r"o.toml: \[set\]: ",
    '[set]\n"accuracy.target" = "5 %"': r"o.toml: \[set\]: accuracy.target chooses levels anew",
    '[surrogate]\n"accuracy.slices" = 1979-05-27': r"o.toml: \[surrogate\]: .*slices = 1979-05-27",
    '[[verify]]\n"accuracy.slices" = 50\n[[verify]]\n"accuracy.slices" = -3': r"\[\[verify\]\] 2: .*-3",
    '[vary]\n"bearing.clearance" = "6 mm .. 7 mm"': r"o.toml: \[vary\]: .*clearance",
    '[vary]\n"operation.radial_load" = "-1 kN .. 5 kN"': r"\[vary\] operation.radial_load .*at least 0 kN",
    '[set]\nbearing = {}': r"o.toml: \[set\]: ",
}  # fmt: skip


@pytest.mark.parametrize(("text", "words"), IMPOSSIBLE.items(), ids=list(IMPOSSIBLE))
def test_what_no_start_can_have_is_refused_by_its_table(text, words, tmp_path):
    file = tmp_path / "o.toml"
    vary = "" if "[vary]" in text else '[vary]\n"bearing.roller.drop" = "1 um .. 20 um"\n'
    file.write_text(f'case = "{CASE}"\n{vary}[maximise]\noutput = "life_L10 [h]"\n{text}\n')
    with pytest.raises(BadCase, match=words):
        searched(file)


def test_an_impossible_start_beside_possible_ones_ends_nothing(tmp_path):
    """The case is outside of these bounds, whose upper half no bearing has."""
    file = tmp_path / "o.toml"
    vary = '[vary]\n"bearing.clearance" = "1 um .. 20 mm"\n[maximise]\noutput = "life_L10 [h]"\n'
    file.write_text(f'case = "{CASE}"\n{vary}')
    with pytest.raises(Computes):
        searched(file)


def test_names_that_no_output_has_are_refused_before_the_first_variant(tmp_path, monkeypatch):
    file = tmp_path / "s.toml"
    file.write_text(f'case = "{CASE}"\n{written(STUDIES[0])}\n'.replace("life_L10 [h]", "no_such_output"))
    monkeypatch.setattr("flexbearing.studies.prepare.plan", None)
    with pytest.raises(BadCase, match=r"\[collect\] life: 'no_such_output': no output has this name"):
        prepare_source(file)


@pytest.mark.parametrize("place", [".", "..", "/", ""])
def test_folders_are_no_files(place, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    over = "operation.radial_load=1 kN..2 kN,2"
    for words in (["report", place], ["map", str(CASE), "--over", over, "-o", place], ["study", place]):
        assert program.command(words) == 2
    assert max(map(len, capsys.readouterr().err.splitlines())) < 200
