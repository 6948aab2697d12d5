"""Variants of a case are the cases that reading the file anew with their values as settings makes."""

import re
from typing import Any

import pytest

from flexbearing.case import BadCase, understood
from flexbearing.case.declarations import by_path
from flexbearing.case.quantity import Section
from flexbearing.case.text import tables
from flexbearing.case.variants import Variants, checks
from flexbearing.families import FAMILIES
from tests.flexbearing.test_every_case_key import CONFIGS, CONTEXTS, effects

PAPER = CONFIGS / "mao2016.toml"


def of_paper(*keys):
    return Variants(PAPER, PAPER.read_text(), keys, FAMILIES)


def fields_set(section):
    """Which keys were given, in every table."""
    inside = {name: getattr(section, name) for name in type(section).model_fields}
    return section.model_fields_set, {
        name: fields_set(item) for name, item in inside.items() if isinstance(item, Section)
    }


def same(case, other):
    return (
        case == other
        and case.source == other.source
        and fields_set(case) == fields_set(other)
        and case.to_json() == other.to_json()
    )


def in_file(text, key):
    found = tables(text)
    for part in key.split("."):
        found = found.get(part) if isinstance(found, dict) else None
    return found


@pytest.mark.sampled(3)
@pytest.mark.parametrize("context", CONTEXTS)
def test_a_variant_equals_the_case_read_with_settings(context):
    """By every key of every kind of case, beginning at the value of the file where it has one."""
    for key, value, _ in effects(context):
        assert_is_the_case_read(*CONTEXTS[context], key, value)


def assert_is_the_case_read(name, settings, key, value):
    changes = settings | (value if isinstance(value, dict) and key in value else {key: value})
    file = CONFIGS / f"{name}.toml"
    text = file.read_text()
    for left_out in (path for path, given in changes.items() if given is None):
        text = re.sub(rf"^{left_out.rpartition('.')[2]} = .*\n", "", text, flags=re.MULTILINE)
        text = text.replace(f'"{left_out}",', "")
    changes = {path: given for path, given in changes.items() if given is not None}
    before = settings.get(key, in_file(text, key))
    variants = Variants(file, text, tuple(changes), FAMILIES)
    if before is not None and not isinstance(value, dict):
        variants.case(tuple({**changes, key: before}.values()))
    expected = understood(text, file, changes, FAMILIES)
    for _ in range(2):
        assert same(case := variants.case(tuple(changes.values())), expected), key
    elsewhere = Variants(file, text, tuple(changes), FAMILIES)
    for _ in range(2):
        assert same(elsewhere.known(tuple(changes.values()), variants.in_si(case)), expected), key


REFUSED = (
    {"operation.radial_load": "-1 N"},
    {"operation.radial_load": "1 mm"},
    {"operation.radial_load": 5},
    {"operation.inner_speed": "0 rpm"},  # which is that of the outer ring
    {"outer.thickness": "1 m", "outer.bars": 2.5},
    {"bearing.roller.diameter": "2 mm"},  # thinner than its cage
    {"outer.kind": "rigid", "inner.kind": "solid gold"},
    {"outer.kind": "ring", "outer.bars": 30},
    {"lubricant.oil_fraction": 2.0},
    {"accuracy.axial_shapes": 30},
    {"bearing.fits.bore": "50 mm"},
    {"calibrated.bearing.clearance": 5},
    {"no.such": 1},
)


@pytest.mark.parametrize("changes", REFUSED, ids=str)
def test_a_bad_variant_is_refused_in_the_words_of_a_setting(changes):
    with pytest.raises(BadCase) as by_setting:
        understood(PAPER.read_text(), PAPER, changes, FAMILIES)
    variants = of_paper(*changes)
    if all(in_file(PAPER.read_text(), key) is not None for key in changes):
        variants.case(tuple(in_file(PAPER.read_text(), key) for key in changes))
    with pytest.raises(BadCase) as as_variant:
        variants.case(tuple(changes.values()))
    assert str(as_variant.value) == str(by_setting.value)


def test_a_value_that_is_left_out_is_that_of_the_file():
    variants, text = of_paper("operation.radial_load", "outer.kind", "outer.bars"), PAPER.read_text()
    for values in (
        ("5 kN", None, 30),
        (None, "rigid", None),
        (None, None, 12),
        ("5 kN", None, None),
        (None,) * 3,
    ):
        given = dict(zip(variants.keys, values, strict=True))
        expected = understood(text, PAPER, {key: value for key, value in given.items() if value}, FAMILIES)
        assert same(variants.case(values), expected)


def test_kinds_of_parts_may_vary_from_one_variant_to_the_next():
    keys = ("outer.kind", "inner.kind", "operation.radial_load")
    variants, text = of_paper(*keys), PAPER.read_text()
    for outer in ("squirrel_cage", "rigid", "squirrel_cage"):
        for inner in ("rigid", "ring_on_shaft"):
            for load in ("5 kN", "6 kN"):
                values = outer, inner, load
                expected = understood(text, PAPER, dict(zip(keys, values, strict=True)), FAMILIES)
                assert same(variants.case(values), expected)


def test_only_the_first_variant_is_read_in_full(monkeypatch):
    variants = of_paper("operation.radial_load", "bearing.clearance")
    variants.case(("1 kN", "50 um"))
    monkeypatch.setattr("flexbearing.case.variants.with_settings", None)
    case: Any = variants.case(("2 kN", "60 um"))
    assert case.operation.radial_load == 2000.0


def test_no_text_of_a_known_variant_is_parsed(monkeypatch):
    keys, values = ("operation.radial_load", "bearing.clearance"), ("2 kN", "60 um")
    there, here = of_paper(*keys), of_paper(*keys)
    here.known(("1 kN", "50 um"), (1000.0, 50e-6))
    in_si = there.in_si(there.case(values))
    monkeypatch.setattr("flexbearing.case.quantity.Kind.to_si", None)
    known: Any = here.known(values, in_si)
    assert (known.operation.radial_load, known.bearing.clearance) == in_si
    assert known.source.overrides == ('operation.radial_load="2 kN"', 'bearing.clearance="60 um"')


TABLES = [
    table
    for family in FAMILIES.values()
    for table in (family.case(), *(item.section for item in by_path(family.case()).values() if item.section))
]


@pytest.mark.parametrize("table", dict.fromkeys(TABLES))
def test_tables_check_their_values_after_they_are_read(table):
    """So that a variant, whose values are read one by one, is checked as a whole."""
    modes = [check.info.mode for check in table.__pydantic_decorators__.model_validators.values()]
    assert set(modes) <= ({"before", "after"} if table.by_name else {"after"})  # a text becomes a table
    assert len(checks(table)) == modes.count("after")
