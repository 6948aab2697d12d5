"""What is large is refused before it is made, kept small, or announced."""

import sys
import tracemalloc
from subprocess import run
from time import process_time
from types import SimpleNamespace

import pytest

from flexbearing.case import BadCase
from flexbearing.families import FAMILIES
from flexbearing.findings.row import by_sentence, information
from flexbearing.report.html.study import MOST_MESSAGES, _by_message
from flexbearing.studies import messages
from flexbearing.studies.file import read, sampled
from flexbearing.studies.maps.axes import axes
from flexbearing.studies.plan import plan
from flexbearing.studies.plan.checked import CheckedVariants
from flexbearing.studies.plan.task import Variant
from tests.flexbearing.toy_studies import CASE

MILLION = "1000000"
TOO_LARGE = {
    '[over]\n"operation.radial_load" = "1 kN .. 2 kN, 1000000"\n"operation.inner_speed" = "1 rpm .. 2 rpm, '
    '1000000"\n"bearing.clearance" = "log 1 um .. 2 um, 1000000"': "gives 1000000000000000000 variants",
    '[sample]\ncount = 1000000\n"bearing.form_error.roller_diameters" = "1000 x normal 0 um, 1 um"': "draws",
}


def study_of(folder, text):
    file = folder / "large.toml"
    file.write_text(f'case = "{CASE}"\n{text}')
    return read(file, FAMILIES)


@pytest.mark.parametrize(("text", "words"), TOO_LARGE.items())
def test_too_many_variants_are_refused_before_they_are_made(text, words, tmp_path):
    study_of(
        tmp_path, '[sample]\ncount = 2\n"bearing.clearance" = "normal 0 um, 1 um"'
    )  # loads what it needs
    began = process_time()
    with pytest.raises(BadCase, match=words):
        study_of(tmp_path, text)
    assert process_time() - began < 0.3


def test_axes_of_a_map_are_counted_before_they_are_made():
    began = process_time()
    keys = (
        "operation.radial_load=1 N..2 N",
        "operation.inner_speed=1 rpm..2 rpm",
        "bearing.clearance=1 um..2 um",
    )
    with pytest.raises(BadCase, match="gives 1000000000000000000 points"):
        axes([f"{key},{MILLION}" for key in keys], FAMILIES["cylindrical_roller"].case())
    assert process_time() - began < 0.3


@pytest.fixture(autouse=True)
def made_anew(monkeypatch):
    """As the variants of a large plan are."""
    monkeypatch.setattr(sys.modules[plan.__module__], "MADE_ONCE", 0)


def bytes_of_a_variant(folder, text, checked):
    """Memory of each further variant of a study in which COUNT stands for their number, and the last plan."""
    study_of(folder, text.replace("COUNT", "2"))  # loads what it needs
    sizes, made = [], None
    for count in (2000, 3000):  # fewer are as many as Python keeps of freed tuples
        tracemalloc.start()
        made = plan(study_of(folder, text.replace("COUNT", str(count))), checked)
        sizes.append(tracemalloc.get_traced_memory()[0])
        tracemalloc.stop()
    return (sizes[1] - sizes[0]) / 1000, made


def test_a_variant_of_a_plan_takes_some_ten_bytes_a_number(tmp_path):
    def checked(base, rows):
        for number, values in enumerate(rows):
            in_si = (1e3 * float(values[0].split()[0]),)
            yield Variant(values, f"{number:032x}", ("outer a",), "", in_si)

    text = '[over]\n"operation.radial_load" = "1 kN .. 2 kN, COUNT"'
    size, made = bytes_of_a_variant(tmp_path, text, lambda base, rows: [*checked(base, rows)])
    assert size < 45
    assert made.variants[5] == Variant(
        ("1.00166722241 kN",), f"{5:032x}", ("outer a",), "", (1e3 * 1.00166722241,)
    )
    assert [each.values for each in made.variants] == [*made.axes[0].rows]


@pytest.mark.slow
def test_drawn_lists_take_four_bytes_a_number(tmp_path, monkeypatch):
    def checked(base, rows):
        return [Variant(v, f"{1:032x}", (), "", (tuple(float(w.split()[0]) for w in v[0]),)) for v in rows]

    text = '[sample]\ncount = COUNT\n"bearing.form_error.roller_diameters" = "14 x normal 0 um, 1 um"'
    monkeypatch.setattr(sampled, "AT_ONCE", 50)  # rows whose words stay, as many of both counts
    size, made = bytes_of_a_variant(tmp_path, text, checked)
    assert size < 100
    words = made.variants[3].values[0]
    assert made.variants[3].in_si == (tuple(float(word.split()[0]) for word in words),)
    assert made.variants[:] == tuple(made.variants)


UNITS = ["5 N", "6 N", "x", "0.007 kN", "8 N", None, ["1 N", "2 N"], ["1 N", 2], "steel"]
IN_SI = [5.0, 6.0, None, 7.0, 8.0, 9.0, (1.0, 2.0), (1.0, 2.0), "steel"]


@pytest.mark.parametrize("count", range(1, len(UNITS) + 1))
def test_numbers_of_cases_are_those_of_rows_or_stored(count):
    """Whatever stood before: a number in another unit, one that is left out, a list, a word."""
    expected = [
        Variant((word,), "" if word == "x" else f"{number:032x}", (), "", () if word == "x" else (value,))
        for number, (word, value) in enumerate(zip(UNITS[:count], IN_SI, strict=False))
    ]
    stored = CheckedVariants([each.values for each in expected])
    for each in expected:
        stored.append(each if each.identity else None)
    assert [*stored] == [stored[number] for number in range(count)] == expected
    assert [[*map(type, each.in_si)] for each in stored] == [[*map(type, each.in_si)] for each in expected]


def test_a_drawn_number_below_every_size_is_zero(tmp_path):
    drawn = study_of(tmp_path, '[sample]\ncount = 4\n"bearing.clearance" = "normal 0 um, 1 um"').drawn
    assert drawn is not None
    assert drawn.factors[0].written([1e-13]) == "0.0 m"
    assert drawn.factors[0].written([1e-11]) == "1e-11 m"


def test_the_time_of_a_long_check_is_said_once_it_is_known(monkeypatch):
    """The first ones wait until workers have started."""
    stages, times = [], iter([20.0, 22.0, 23.0])
    monkeypatch.setattr(messages, "perf_counter", lambda: next(times))
    checking = messages.Checking(SimpleNamespace(stage=lambda *stage: stages.append(stage)))
    for checked in (1000, 3000, 4000):
        checking(checked, 201_000)
    assert stages == [
        ("check: 3000 of 201000 variants, 3.3 min left", 3000 / 201_000),
        ("check: 4000 of 201000 variants, 3.28 min left", 4000 / 201_000),
    ]


def test_messages_of_many_rows_are_grouped_once():
    rows = [(number, information("code", f"message {number % 20_000}")) for number in range(200_000)]
    began = process_time()
    lines = list(_by_message(dict(by_sentence(rows))))
    assert process_time() - began < 1
    assert len(lines) == MOST_MESSAGES + 1
    assert lines[0] == "rows 0, 20000, 40000, 60000, 80000, 100000, 120000, 140000, 160000, 180000: message 0"


def test_new_refuses_without_loading_what_computes():
    words = ["scipy", "h5py", "flexbearing.runs.roller"]
    code = (
        "import sys; from flexbearing.__main__ import command\n"
        "end = command(['new', 'x.toml', '--like', 'squirrel_cage', '-d', '95 mm', '-D', '90 mm', "
        "'-B', '20 mm', '-F', '59.5 mm', '-E', '81.5 mm', '--load', '5 kN', '--speed', '3000 rpm'])\n"
        f"print(end, [name for name in {words} if name in sys.modules])"
    )
    assert run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "2 []\n"
