"""Rows of a table: outputs of many roller cases, solved side by side or each in a run of its own."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from flexbearing.case.roller import Case
from flexbearing.findings import RowFinding
from flexbearing.outputs import RequestedOutput, requested
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.quantities.roller import LAYOUT
from flexbearing.runs import notes, roller_findings
from flexbearing.runs.answer import CONVERGED, Alone, Answer, row_findings
from flexbearing.runs.side_by_side import Solved, solved_side_by_side
from quasidynamic import NotSolved, OutOfRange
from quasidynamic.note import Note

if TYPE_CHECKING:
    from flexbearing.accuracy.shared import Levels


def answers(
    cases: Sequence[Case],
    texts: Sequence[str],
    alone: Alone,
    *,
    search: bool = False,
    levels: "Levels | None" = None,
) -> list[Answer]:
    """Compute the wanted outputs of many cases.

    Cases that differ in numbers only, between rigid rings or between the same elastic ones, are solved side
    by side, and their outputs are arrays. What needs a run of its own has one, and its answer says why, see
    `solved_side_by_side`. Nothing is computed but what is wanted, and what dangers need.
    """
    outputs = {text: requested(LAYOUT, text) for text in texts}
    blocks = {output.block for output in outputs.values()}
    numbers: list[dict[str, float]] = [{} for _ in cases]
    findings: dict[int, tuple[RowFinding, ...]] = {}
    own_run: dict[int, str] = {}
    of_levels = tuple(levels.notes()) if levels else ()
    # The bearings' matrices are small: threads of the linear algebra would only wait for each other.
    with linear_algebra_alone():
        for solved in solved_side_by_side(cases, blocks, levels):
            if not isinstance(solved, Solved):
                own_run[solved.place] = solved.why
                continue
            try:
                for place, found in zip(solved.places, _numbers(solved, outputs), strict=True):
                    numbers[place] |= found
                if solved.answer:
                    findings |= zip(solved.places, _findings(solved, search, of_levels), strict=True)
            except (NotSolved, OutOfRange) as problem:  # of one of them
                own_run |= dict.fromkeys(solved.places, str(problem))
    return [
        replace(alone(place), own_run=own_run[place])
        if place in own_run
        else Answer(CONVERGED, "", numbers[place], findings[place])
        for place in range(len(cases))
    ]


def _numbers(solved: Solved, outputs: Mapping[str, RequestedOutput]) -> Iterator[dict[str, float]]:
    """Numbers of each case that its block has, by the texts of outputs."""
    some = {text: output for text, output in outputs.items() if output.block in solved.blocks}
    columns = [values.tolist() for values in solved.rows.numbers(list(some.values()))]
    rows = zip(*columns, strict=True) if columns else [()] * len(solved.places)
    return (dict(zip(some, row, strict=True)) for row in rows)


def _findings(solved: Solved, search: bool, of_levels: Sequence[Note]) -> Iterator[tuple[RowFinding, ...]]:
    """Findings of each case; without a `search` it is reported where other equilibria are likely."""
    rows = solved.rows
    each = zip(roller_findings.of_rows(rows), rows.several_likely.tolist(), strict=True)
    for place, (records, likely) in enumerate(each):
        others = notes.of_others(rows, place, search=search) if likely else ()
        yield row_findings(records, (*of_levels, *rows.rated[place].notes, *others))
