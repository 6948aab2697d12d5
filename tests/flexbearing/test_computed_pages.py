"""Tables of pages say what the stored tables of their commands say."""

import csv
import re
from pathlib import Path

from pytest import approx

DOCS = Path(__file__).parents[2] / "docs"
BEARINGS = {
    "squirrel cage": "mao2016", "NU 209 with fits": "nu209_fits", "catalogue NU 210": "nu210",
    "planet": "planet", "ball 7208": "b7208",
}  # fmt: skip


def stored(name):
    with (DOCS / "images" / f"{name}.csv").open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def tables(page):
    """Rows of cells of every computed table of a page, by its name."""
    text = (DOCS / "howto" / f"{page}.md").read_text(encoding="utf-8")
    blocks = re.findall(r"<!-- computed: (.+?) -->(.*?)<!-- end -->", text, re.DOTALL)
    return {name: [_cells(line) for line in block.splitlines() if line[:1] == "|"] for name, block in blocks}


def _cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def is_rounded(cell, value, digits=3):
    """Whether a cell shows a value in so many digits; errors below 1e-7 are shown as that."""
    if cell.startswith("<"):
        return value < float(cell[1:]) * 1.01
    return float(cell) == approx(value, rel=0.51 * 10 ** (1 - digits), abs=1e-12)


def test_fastest_level_of_a_bearing_is_numerical_and_keeps_its_bound():
    table = tables("speed-against-error")["cheapest"][2:]
    assert len(table) == 2 * len(BEARINGS)
    for bearing, when, *cells in table:
        rows = [row for row in stored(f"pareto_{BEARINGS[bearing]}") if row["kind"] == "numerical"]
        rows = [row for row in rows if row["error_load"]]
        for cell, bound in zip(cells, (0.05, 0.01, 0.001), strict=True):
            kept = [
                row for row in rows if all(float(row[key]) <= bound for key in row if key[:6] == "error_")
            ]
            best = min(kept, key=lambda row: float(row[f"{when}_s"]), default=None)
            assert cell.rpartition(",")[0] == best["level"] if best else cell == "none"


def test_targets_chose_what_the_page_says():
    for bearing, target, cold, cached, load, life in tables("speed-against-error")["targets"][2:]:
        (row,) = (row for row in stored(f"pareto_{BEARINGS[bearing]}") if row["level"] == f"target {target}")
        assert is_rounded(cold, float(row["cold_s"]), 2)
        assert is_rounded(cached, float(row["cached_s"]), 2)
        for cell, output in ((load, "load"), (life, "life")):
            told, true = cell.split(", ")
            assert is_rounded(told, 100 * float(row[f"told_{output}"]), 2)
            assert is_rounded(true, 100 * float(row[f"error_{output}"]), 2)


def test_fractions_solved_stand_on_the_page_with_their_commands():
    shown = {
        name: (what, share, command) for name, what, share, command in tables("hard-cases")["solved"][2:]
    }
    rows = stored("hard_cases")
    assert list(shown) == [row["name"] for row in rows]
    for row in rows:
        what, share, command = shown[row["name"]]
        assert what == row["asked"]
        assert command == f"`{row['command']}`"
        assert share.startswith(f"{row['solved']} of {row['of']} (")
        assert is_rounded(share[share.index("(") + 1 : -3], 100 * int(row["solved"]) / int(row["of"]))


def test_every_case_that_is_not_solved_is_told():
    told = dict(tables("hard-cases")["unsolved"][2:])
    for row in stored("hard_cases"):
        assert bool(row["unsolved"]) == (row["name"] in told)
        assert told.get(row["name"], "") == row["unsolved"].replace(" | ", "; ")


def test_sensitivities_stand_on_the_page_as_they_were_computed():
    rows, shown = stored("unknown_numbers"), tables("unknown-numbers")["sensitivity"][2:]
    assert sum(name.startswith("**") for name, *_ in shown) == sum(not row["number"] for row in rows)
    base: dict[str, str] = {}
    for name, values, life, slip, stiffness, torque in shown:
        if name.startswith("**"):
            (base,) = (row for row in rows if f"**{row['bearing']}**" == name and not row["number"])
            assert float(slip) == approx(100 * float(base["slip"]), rel=0.005, abs=1e-3)
            continue
        ends = [row for row in rows if (row["bearing"], row["number"]) == (base["bearing"], name)]
        assert values == ", ".join(row["value"] for row in ends)
        for output, cell in (("life", life), ("stiffness", stiffness), ("torque", torque)):
            for end, number in zip(ends, cell.split(", "), strict=True):
                assert is_rounded(number, float(end[output]) / float(base[output]))
        for end, number in zip(ends, slip.split(", "), strict=True):
            assert float(number) == approx(100 * float(end["slip"]), rel=0.005, abs=1e-3)
