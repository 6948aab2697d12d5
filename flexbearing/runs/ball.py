"""A ball bearing, from case to result file."""

from collections.abc import Mapping
from typing import Any

from numpy.typing import ArrayLike

from fem.errors import NotSolved as RingNotSolved
from flexbearing.case import BadCase, Head
from flexbearing.case.balls.angular_contact import AngularCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.progress import Report
from flexbearing.results import ResultFile
from flexbearing.rings import bolted
from flexbearing.runs import angular_contact, four_point
from quasidynamic import ImpossiblePart, NotSolved, OutOfRange


def opening(case: Head) -> dict[str, object]:
    """Root attributes that are known before anything is solved."""
    return {"notes": []}


def solve_four_point(case: FourPointCase, file: ResultFile, report: Report) -> dict[str, object]:
    """Write the solution of a slow bearing; returns the root attributes that say how it ended.

    Elastic rings come beside the rigid ones.

    Raises
    ------
    BadCase
        when no such bearing can exist
    """
    try:
        report.stage("slow balls between rigid rings", None)
        found = four_point.solved(case)
        file.block("rigid", four_point.block(found))
        if not case.rings.rigid:
            compliance = bolted.compliance(case, report)
            report.stage("slow balls between elastic rings", None)
            found = four_point.solved(case, compliance)
            file.block("flexible", four_point.block(found))
    except (NotSolved, RingNotSolved) as failure:
        return _not_solved(failure)
    except (ImpossiblePart, OutOfRange) as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem
    worst = found.balls.sliding.imbalance.max()
    message = f"friction of every ball in balance to {worst:.1e} of its power"
    if found.distribution is not None:
        message += f", the ring to {found.distribution.imbalance:.1e} of the largest force"
    return _converged(message, four_point.notes(case, found))


def solve_angular(case: AngularCase, file: ResultFile, report: Report) -> dict[str, object]:
    """Write the solution of a fast bearing; returns the root attributes that say how it ended.

    Raises
    ------
    BadCase
        when no such bearing can exist
    """
    report.stage("fast balls between rigid rings", None)
    try:
        found = angular_contact.solved(case)
    except NotSolved as failure:
        return _not_solved(failure)
    except (ImpossiblePart, OutOfRange) as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem
    message = f"ring and balls in balance after {found.state.evaluations} evaluations of all balls"
    return _stored(file, angular_contact.block(case, found), message, angular_contact.notes(case, found))


def _stored(
    file: ResultFile, arrays: Mapping[str, ArrayLike], message: str, notes: tuple[str, ...]
) -> dict[str, Any]:
    file.block("rigid", arrays)
    return _converged(message, notes)


def _converged(message: str, notes: tuple[str, ...]) -> dict[str, Any]:
    return _ending("converged", message, "converged") | {"notes": list(notes)}


def _not_solved(failure: NotSolved | RingNotSolved) -> dict[str, Any]:
    ending = str(failure.outcome) if isinstance(failure, NotSolved) else "rings not solved"
    return _ending("not solved", str(failure), ending)


def _ending(status: str, message: str, ending: str) -> dict[str, Any]:
    return {"status": status, "message": message, "ending": ending, "iterations": 0}
