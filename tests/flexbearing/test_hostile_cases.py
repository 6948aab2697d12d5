"""Whatever stands in a case file or a setting is a case or a short refusal, without more work than a case."""

import copy
import os
import tomllib

import pytest
from hypothesis import HealthCheck, given, settings as examples, strategies as st

import flexbearing
from flexbearing.case import BadCase, text
from flexbearing.case.declarations import toml
from flexbearing.case.problems import MOST
from flexbearing.case.read import MOST_SETTINGS
from flexbearing.printable import printable
from tests.flexbearing.hostile_cases import CONFIGS, FILES, GOOD, SETTINGS

PAPER = CONFIGS / "mao2016.toml"
LONGEST_LINE = 700  # characters: a key, a value, what is allowed, the keys of a table


def refusal(file, settings=()):
    """What is said of a case; red for any other exception, and for a case that is taken."""
    with pytest.raises(BadCase) as problem:
        flexbearing.api.check(file, settings)
    return str(problem.value)


def require_short(message):
    lines = message.split("\n")
    assert 1 <= len(lines) <= MOST + 1
    assert max(map(len, lines)) <= LONGEST_LINE
    assert all(line.strip() for line in lines)
    assert printable(message) == message


def written(folder, content):
    file = folder / "hostile.toml"
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    return file


@pytest.mark.parametrize("content", FILES.values(), ids=FILES.keys())
def test_hostile_file_is_refused_in_a_few_short_lines(content, tmp_path):
    (tmp_path / "step_ring.step").write_bytes((CONFIGS / "step_ring.step").read_bytes())
    require_short(refusal(written(tmp_path, content)))


@pytest.mark.parametrize("settings", SETTINGS.values(), ids=SETTINGS.keys())
def test_hostile_setting_is_refused_in_a_few_short_lines(settings):
    require_short(refusal(PAPER, settings))


def test_a_file_as_large_as_allowed_is_read(tmp_path):
    case = flexbearing.api.read_case(written(tmp_path, GOOD + "#" * (text.LARGEST - len(GOOD))))
    assert case.bearing.rollers == 30
    assert "is larger than 64 KiB" in refusal(written(tmp_path, GOOD + "#" * (text.LARGEST - len(GOOD) + 1)))


def test_a_case_whose_name_is_no_text_is_computed(tmp_path):
    file = tmp_path / os.fsdecode(b"\xff.toml")
    file.write_text(GOOD)
    result = flexbearing.run(file, ["outer.kind=rigid", "inner.kind=rigid"], output=tmp_path / "out.h5")
    assert result.attributes["case_file"].endswith("\\xff.toml")


@pytest.mark.parametrize("name", ["a\0b.toml", "a" * 5000, "x/" * 3000], ids=["NUL", "long", "deep"])
def test_a_name_that_no_file_can_have_is_refused(name):
    require_short(refusal(name))


def test_the_mark_at_the_beginning_of_a_text_is_no_part_of_it(tmp_path):
    case = flexbearing.api.read_case(written(tmp_path, b"\xef\xbb\xbf" + GOOD.encode()))
    assert case.source.text == GOOD


def test_a_file_of_another_encoding_is_told_which_one_to_take(tmp_path):
    message = refusal(written(tmp_path, GOOD.encode("utf-16")))
    assert message.endswith("hostile.toml: is not text in UTF-8 (byte 0xff at 0); save it as UTF-8")


@pytest.mark.parametrize(
    "line", ["x = " + "[" * 9 + "]" * 9, "a.b.c.d.e.f.g.h.i = 1", 'x = {"a" . b.c.d.e.f.g.h.i=1}']
)
def test_depth_is_counted_before_the_parser_recurses(line, tmp_path, monkeypatch):
    monkeypatch.setattr(text.tomllib, "loads", lambda _: pytest.fail("was parsed"))
    assert "more than 8" in refusal(written(tmp_path, line))


@pytest.mark.parametrize(
    "line",
    [
        "x = [[[[[[[[1]]]]]]]]",
        "x = [1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5, 1.5]",
        'x = "a.b.c.d.e.f.g.h.i.j [[[[[[[[[[ {{{{{{{{{{"',
        "# a.b.c.d.e.f.g.h.i.j [[[[[[[[[[",
        "x = '''\na.b.c.d.e.f.g.h.i.j\n[[[[[[[[[['''",
        'x = """\\"""[[[[[[[[[["""',
        "[a.b.c.d.e.f.g.h]",
    ],
)
def test_what_only_looks_deep_is_parsed(line):
    assert isinstance(text.tables(line), dict)


def depth(parsed):
    if not isinstance(parsed, dict | list):
        return 0
    return 1 + max(map(depth, parsed.values() if isinstance(parsed, dict) else parsed), default=0)


PIECES = ['"', "'", '"""', "'''", "\\", "#", "\n", "[", "]", "{", "}", "a", ".", "=", " = ", "x = ", ","]


@pytest.mark.slow
@given(st.lists(st.sampled_from(PIECES), max_size=12).map("".join), st.sampled_from(["", '"', "'''", '"""']))
@examples(max_examples=500)
def test_nothing_deep_hides_behind_quotes(before, quotes):
    """What the parser would see as deep arrays, the count sees, whatever quotes stand before."""
    hidden = f"{before}x = {quotes}{'[' * 30}{']' * 30}{quotes}"
    try:
        parsed = tomllib.loads(hidden)
    except tomllib.TOMLDecodeError:
        return
    if depth(parsed) > 30:
        with pytest.raises(text.Unreadable):
            text.tables(hidden)
    else:
        assert text.tables(hidden) == parsed


def test_a_setting_that_is_too_deep_is_taken_as_text():
    assert flexbearing.api.read_case(PAPER, ["title=and so on ........... [[[[[[[[[["]).title.startswith(
        "and so on"
    )
    assert '[bearing] rollers = "[[[[' in refusal(PAPER, ["bearing.rollers=" + "[" * 3000])


def test_only_the_first_problems_are_told_with_the_number_of_the_others(tmp_path):
    lines = refusal(written(tmp_path, FILES["unknown keys"])).split("\n")
    unknown = FILES["unknown keys"].count(b"clearanse")
    assert lines[-1] == f"hostile.toml: {unknown - MOST} more of them."
    assert len(lines) == MOST + 1


def test_similar_names_are_sought_for_told_problems_only(tmp_path, monkeypatch):
    import difflib

    sought = []
    search = difflib.get_close_matches
    monkeypatch.setattr(difflib, "get_close_matches", lambda *a, **k: sought.append(a[0]) or search(*a, **k))
    for name in (
        "unknown keys",
        "short unknown keys",
        "assumed of many",
        "long key",
        "calibrated of many parts",
    ):
        refusal(written(tmp_path, FILES[name]))
    assert len(sought) <= 3 * 2 * MOST
    assert max(map(len, sought)) <= 60


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        ([f"outer.bars={n}" for n in range(MOST_SETTINGS + 1)], "more than 500 settings"),
        (["title=" + "a" * text.LARGEST], "or 64 KiB of them"),
    ],
    ids=["many", "long"],
)
def test_settings_are_limited(settings, told):
    assert told in refusal(PAPER, settings)


def test_lists_that_cost_are_limited(tmp_path):
    """4000 lines around a ring were taken, and computed for minutes."""
    lines = refusal(written(tmp_path, FILES["more lines than can stand around a ring"]))
    assert "it must be a list of at most 360, each an angle" in lines
    balls = refusal(CONFIGS / "joshi2015_fag.toml", ["fields.balls=[0, 0]"])
    assert "[fields] balls = [0, 0] cannot be; it must be different numbers of balls" in balls


def test_as_many_settings_as_allowed_are_taken():
    assert flexbearing.api.read_case(PAPER, ["outer.bars=18"] * MOST_SETTINGS).outer.bars == 18


def test_a_setting_is_one_value():
    """Text behind a line break was left out silently."""
    for setting in (
        "bearing.rollers=30\nouter.bars=3",
        "bearing.rollers=30\n[x]",
        "bearing.rollers=30\nvalue=3",
    ):
        assert '[bearing] rollers = "30\\n' in refusal(PAPER, [setting])


@pytest.mark.parametrize("title", ["a\udcffb", "a\0b"], ids=["surrogate", "NUL"])
def test_a_title_that_cannot_be_stored_is_refused(title):
    assert "holds a character that is no text" in refusal(PAPER, {"title": title})


def test_integers_end_at_64_bits(tmp_path):
    assert "bearing.rollers holds an integer of more than 64 bits" in refusal(
        written(tmp_path, GOOD.replace("rollers = 30 ", f"rollers = {2**63} "))
    )
    assert "is not allowed; it must be a whole number" in refusal(PAPER, [f"bearing.rollers={2**63 - 1}"])


# Random structures in the place of good ones: a case, or a refusal.
SCALARS = st.one_of(
    st.booleans(),
    st.integers(),
    st.floats(),
    st.text(max_size=20),
    st.sampled_from(
        ["5 mm", "1e999 um", "0 rpm", "ring", "rigid", "step", "-1 N", "nan mm", "1/0 m", "20 1/min"]
    ),
    st.dates(),
    st.times(),
    st.datetimes(),
)
STRUCTURES = st.recursive(
    SCALARS,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=8), inner, max_size=3),
    max_leaves=6,
)
CASES = {
    name: tomllib.loads((CONFIGS / f"{name}.toml").read_text())
    for name in ("mao2016", "nu209_fits", "step_ring", "slewing_bolted", "harris218")
}


def places(tables, above=()):
    """Every key and table of a case, and one that is none in each table."""
    for name, item in [*tables.items(), ("other", None)]:
        yield *above, name
        if isinstance(item, dict):
            yield from places(item, (*above, name))


PLACES = [(name, place) for name, case in CASES.items() for place in places(case)]


def ends_well_or_is_refused(file, settings=()):
    try:
        assert flexbearing.api.check(file, settings).title is not None
    except BadCase as problem:
        require_short(str(problem))


@pytest.mark.slow
@examples(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(st.tuples(st.sampled_from(PLACES), STRUCTURES), min_size=1, max_size=3))
def test_any_structure_at_any_place_of_a_file_is_a_case_or_refused(tmp_path, changes):
    name = changes[0][0][0]
    tables = copy.deepcopy(CASES[name])
    for (_, (*above, key)), structure in changes:
        inside = tables
        for table in above:
            inside = inside.setdefault(table, {}) if isinstance(inside, dict) else {}
        if isinstance(inside, dict):
            inside[key] = structure
    text = "\n".join(f"{toml(key)} = {toml(item)}" for key, item in tables.items())
    (tmp_path / "step_ring.step").write_bytes((CONFIGS / "step_ring.step").read_bytes())
    ends_well_or_is_refused(written(tmp_path, text))


@pytest.mark.slow
@examples(max_examples=150)
@given(st.sampled_from(PLACES), STRUCTURES)
def test_any_structure_as_a_setting_is_a_case_or_refused(place, structure):
    name, keys = place
    ends_well_or_is_refused(CONFIGS / f"{name}.toml", {".".join(keys): structure})


@examples(max_examples=40)
@given(st.sampled_from(PLACES), st.text(max_size=40))
def test_any_text_as_a_setting_is_a_case_or_refused(place, text):
    name, keys = place
    ends_well_or_is_refused(CONFIGS / f"{name}.toml", [f"{'.'.join(keys)}={text}"])


@examples(max_examples=100, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.binary(max_size=200), st.integers(0, len(GOOD)))
def test_any_bytes_in_a_file_are_a_case_or_refused(tmp_path, inserted, place):
    content = GOOD.encode()
    ends_well_or_is_refused(written(tmp_path, content[:place] + inserted + content[place:]))
