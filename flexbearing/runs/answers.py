"""Outputs of many cases of a family, side by side where it can."""

from collections.abc import Sequence
from functools import partial
from typing import Any

from flexbearing.case import BadCase
from flexbearing.case.family import Family
from flexbearing.outputs import wanted
from flexbearing.runs.answer import BAD_INPUT, CONVERGED, Answer
from flexbearing.runs.run_case import compared
from flexbearing.runs.validate import require_possible

AT_ONCE = 64  # cases


def answers(cases: Sequence[Any], texts: Sequence[str], family: Family) -> list[Answer]:
    """An answer for each case; one that cannot be computed says why."""
    found = [_refused(case, family) for case in cases]
    possible = [place for place, answer in enumerate(found) if answer is None]
    for first in range(0, len(possible), AT_ONCE):
        places = possible[first : first + AT_ONCE]
        some = [cases[place] for place in places]
        alone = partial(_alone, some, texts, family)
        solved = family.rows()(some, texts, alone) if family.rows else map(alone, range(len(some)))
        for place, answer in zip(places, solved, strict=True):
            found[place] = answer
    return [answer for answer in found if answer is not None]


def _refused(case: Any, family: Family) -> Answer | None:
    """Why a case cannot be computed; None where it can."""
    try:
        require_possible(case, family)
    except BadCase as problem:
        return Answer(BAD_INPUT, _first_line(problem, case), {})
    return None


def _alone(cases: Sequence[Any], texts: Sequence[str], family: Family, place: int) -> Answer:
    """The answer of a run."""
    try:
        result = compared(cases[place], family)
    except BadCase as problem:
        return Answer(BAD_INPUT, _first_line(problem, cases[place]), {})
    blocks = {"rigid": result.rigid, "flexible": result.flexible}
    numbers = {text: wanted(family.layout(), text).number(blocks) for text in texts}
    status = str(result.attributes["status"])
    solved = status == CONVERGED
    return Answer(status, str(result.attributes["message"]), numbers if solved else {})


def _first_line(problem: BadCase, case: Any) -> str:
    """What is wrong, without the name of the file."""
    return str(problem).splitlines()[0].removeprefix(f"{case.source.path}: ")
