"""A ball bearing, from case to result file."""

from functools import partial
from typing import Any

from fem.errors import NotSolved as RingNotSolved
from flexbearing.build import clearance
from flexbearing.case import BadCase, Head
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.findings import Judged, records
from flexbearing.progress import Report
from flexbearing.results import Recorder
from flexbearing.rings import bolted
from flexbearing.runs import angular_contact, four_point
from quasidynamic import ImpossiblePart, NotSolved, OutOfRange
from quasidynamic.note import Note, graded

STICK = "stick and slip, ball by ball"  # what is told while it is found


def opening(case: Head) -> dict[str, object]:
    """Root attributes that are known before anything is solved."""
    return {"notes": []}


def solve_four_point(case: FourPointCase, record: Recorder, report: Report) -> dict[str, object]:
    """Write the solution of a slow bearing; returns the root attributes that say how it ended.

    Elastic rings come beside the rigid ones.

    Raises
    ------
    BadCase
        when no such bearing can exist
    """
    told = partial(report.stage, STICK)
    try:
        report.stage("slow balls between rigid rings", None)
        solution = four_point.solved(case, told=told)
        record.block("rigid", four_point.block(solution))
        if not case.rings.rigid:
            compliance = bolted.compliance(case, report)
            report.stage("slow balls between elastic rings", None)
            solution = four_point.solved(case, compliance, told)
            record.block("flexible", four_point.block(solution))
    except (NotSolved, RingNotSolved) as failure:
        return _not_solved(failure)
    except (ImpossiblePart, OutOfRange) as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem
    worst = solution.balls.sliding.imbalance.max()
    message = f"friction of every ball in balance to {worst:.1e} of its power"
    if solution.distribution is not None:
        message += f", the ring to {solution.distribution.imbalance:.1e} of the largest force"
    found = four_point.judge(solution)
    ending = _converged(message, four_point.notes(case, solution, found), found)
    return {**ending, "clearance": clearance.record(case)}


def solve_angular(case: FastCase, record: Recorder, report: Report) -> dict[str, object]:
    """Write the solution of a fast bearing; returns the root attributes that say how it ended.

    Raises
    ------
    BadCase
        when no such bearing can exist
    """
    report.stage("fast balls between rigid rings", None)
    try:
        solution = angular_contact.solved(case, partial(report.stage, STICK))
    except NotSolved as failure:
        return _not_solved(failure)
    except (ImpossiblePart, OutOfRange) as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem
    message = (
        f"ring and balls in balance to {solution.state.imbalance:.1e} of the largest force after "
        f"{solution.state.evaluations} evaluations of all balls"
    )
    record.block("rigid", angular_contact.block(case, solution))
    of_clearance = clearance.record(case)
    found = angular_contact.judge(case, solution, of_clearance)
    ending = _converged(message, angular_contact.notes(case, solution, found), found)
    life = solution.lives and solution.lives.of_state
    lives = {"rigid": life.record()} if life else {}
    return {**ending, "clearance": of_clearance, "life": lives}


def _converged(message: str, notes: tuple[Note, ...], found: tuple[Judged, ...]) -> dict[str, Any]:
    noted = {"notes": [note.record() for note in graded(notes)], "findings": records(found)}
    return _ending("converged", message, "converged") | noted


def _not_solved(failure: NotSolved | RingNotSolved) -> dict[str, Any]:
    ending = str(failure.outcome) if isinstance(failure, NotSolved) else "rings not solved"
    return _ending("not solved", str(failure), ending)


def _ending(status: str, message: str, ending: str) -> dict[str, Any]:
    return {"status": status, "message": message, "ending": ending, "iterations": 0}
