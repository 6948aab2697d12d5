"""Pages of evidence are what their numbers say, and the numbers are what is computed."""

import re
from dataclasses import replace

import pytest

from evidence import trust
from evidence.case import Case, Estimate, Findings, Number, Trend
from evidence.cases import CASES
from evidence.measured.experiments import EXPERIMENTS
from evidence.measured.page import listed
from evidence.measured.stored import all_registered
from evidence.page import index, page
from evidence.stored import DOCS, moved, read
from evidence.verdict import verdict

EACH = pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())


@pytest.fixture(scope="module")
def kept():
    return {name: read(case) for name, case in CASES.items()}


@EACH
def test_page_is_what_its_declaration_and_its_numbers_say(case, kept):
    assert (DOCS / f"{case.name}.md").read_text() == page(case, kept[case.name])


@pytest.fixture(scope="module")
def registered():
    return all_registered(EXPERIMENTS.values())


def test_index_lists_every_case_with_its_verdict(kept, registered):
    text = (DOCS / "index.md").read_text()
    measurements = listed(EXPERIMENTS.values(), registered)
    assert text == index(list(CASES.values()), kept, measurements)
    assert set(re.findall(r"\]\((.+?)\.md\)", measurements)) == set(EXPERIMENTS)
    cases = text.split("known numbers and statements")[1]
    assert re.findall(r"\]\((.+?)\.md\)", cases) == [
        case.name for case in sorted(CASES.values(), key=lambda case: subjects().index(case.subject))
    ]


def test_table_of_trust_is_what_the_evidence_says_on_one_screen(kept, registered):
    text = (DOCS / "trust.md").read_text()
    assert text == trust.page(kept, registered)
    assert len(trust.ROWS) <= trust.MOST_ROWS
    assert {name for row in trust.ROWS for name in row.measured} == set(EXPERIMENTS)


def test_table_of_trust_shows_the_largest_misfit_of_each_kind(kept):
    (torque,) = (row for row in trust.ROWS if (row.family, row.output) == (trust.SLOW, "torque"))
    size, name = trust.largest(torque, "measured", kept)
    assert (name, round(100 * size)) == ("joshi-measured", 24)
    larger = replace(kept["joshi-measured"].numbers[0], ours=0.0)
    changed = {**kept, "joshi-measured": replace(kept["joshi-measured"], numbers=(larger,))}
    assert trust.largest(torque, "measured", changed) == (1.0, "joshi-measured")
    assert trust.largest(torque, "closed form", kept) is None


@pytest.mark.parametrize("row", trust.ROWS, ids=lambda row: f"{row.family}, {row.output}")
def test_every_comparison_of_the_table_of_trust_has_numbers(row, kept):
    assert all(compared.numbers(kept) for compared in row.compared)


def subjects():
    return list(dict.fromkeys(case.subject for case in CASES.values()))


def test_statements_on_bearings_that_we_chose_are_no_tests():
    assert {case.name for case in CASES.values() if case.chosen} == {
        "gearbox-slip",
        "skidding",
        "skidding-guidance",
    }


def test_there_are_forty_cases_of_many_sources():
    assert len(CASES) >= 40
    assert len({case.source for case in CASES.values()}) >= 30


def test_no_page_is_left_over():
    pages = {path.stem for path in DOCS.glob("*.md")} - {"index", "trust", *EXPERIMENTS}
    numbers = {path.stem for path in (DOCS / "numbers").glob("*.json")}
    figures = {path.stem for path in (DOCS / "figures").glob("*.png")}
    assert pages == numbers == set(CASES)
    assert figures == {case.name for case in CASES.values() if case.draw}


@EACH
def test_case_names_source_error_and_the_files_it_uses(case, kept):
    assert case.source.endswith(".")
    assert case.known
    assert case.run
    assert case.error
    assert kept[case.name].numbers or kept[case.name].trends
    root = DOCS.parents[1]
    for file in (case.numbers_from, case.module, *case.case_files):
        assert (root / file).exists(), file


@pytest.mark.parametrize(
    "case",
    [pytest.param(case, marks=[pytest.mark.slow] * case.slow, id=name) for name, case in CASES.items()],
)
def test_numbers_are_those_that_are_computed(case, kept):
    assert moved(case, kept[case.name], case.compute()) == []


def toy(ours, allowed=0.0, holds=True, **changes):
    """A declaration with one number known as 100, and its findings."""
    words = dict.fromkeys(("title", "subject", "source", "known", "run", "numbers_from", "error"), "x")
    number = Number(name="size", known=100.0, ours=ours, allowed=allowed)
    trend = Trend(statement="rises", places=("a", "b"), ours=(1.0, 2.0), holds=holds)
    findings = Findings(numbers=(number,), trends=(trend,), errors=(Estimate(name="grid", value=0.1),))
    return Case(name="toy", compute=lambda: findings, **words, **changes), findings


@pytest.mark.parametrize(
    ("ours", "changes", "expected"),
    [
        (100.4, {"allowed": 0.5}, "agrees"),
        (100.4, {}, "agrees within 0.5 %"),
        (95.2, {}, "agrees within 5 %"),
        (94.9, {}, "differs, reason not known"),
        (94.9, {"reason": "another load"}, "differs, reason known"),
        (100.0, {"holds": False}, "differs, reason not known"),
        (100.0, {"chosen": "the bearing"}, "not testable"),
        (94.9, {"chosen": "the bearing"}, "not testable"),
    ],
)
def test_verdict_follows_from_the_numbers(ours, changes, expected):
    assert verdict(*toy(ours, **changes)) == expected


@pytest.mark.parametrize(("ours", "lines"), [(100.09, 0), (100.11, 1), (94.0, 2), (float("nan"), 2)])
def test_number_that_moved_by_more_than_the_page_allows_is_told(ours, lines):
    """The second line tells of another verdict."""
    (case, before), (_, after) = toy(100.0, allowed=1.0), toy(ours, allowed=1.0)
    assert len(moved(case, before, after)) == lines


def test_trend_and_error_that_moved_are_told():
    case, before = toy(100.0)
    (trend,), (error,) = before.trends, before.errors
    turned = replace(trend, ours=(1.0, 2.01))
    assert len(moved(case, before, replace(before, trends=(turned,)))) == 1
    assert len(moved(case, before, replace(before, errors=(replace(error, value=0.2),)))) == 1
    assert len(moved(case, before, replace(before, trends=()))) == 1


def test_known_number_that_changed_is_told():
    case, before = toy(100.0, allowed=1.0)
    after = replace(before, numbers=(replace(before.numbers[0], known=100.2),))
    assert len(moved(case, before, after)) == 1
