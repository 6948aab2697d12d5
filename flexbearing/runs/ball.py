"""Ball bearings, from cases to result files and to rows of a table."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from flexbearing.build import clearance
from flexbearing.case import BadCase, Head
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.coupled.attempts import NotCoupled
from flexbearing.findings import Judged, records
from flexbearing.life import four_point_lives, life_rules
from flexbearing.outputs import requested
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.progress import Logged, Report
from flexbearing.quantities.angular_contact import LAYOUT as OF_FAST_BALLS
from flexbearing.quantities.four_point import LAYOUT as OF_SLOW_BALLS
from flexbearing.quantities.layout import Layout
from flexbearing.results import Recorder
from flexbearing.runs import angular_contact, ball_levels, four_point, probes
from flexbearing.runs.angular_contact import Block, named
from flexbearing.runs.answer import BAD_INPUT, CONVERGED, Answer, row_findings
from quasidynamic import AngularContactState, ImpossiblePart, NotSolved, OutOfRange
from quasidynamic.note import Note, graded

if TYPE_CHECKING:
    from flexbearing.accuracy.shared import Levels

NOT_SOLVED = "not solved"


def opening(case: Head) -> dict[str, object]:
    """Root attributes that are known before anything is solved."""
    return {"notes": []}


def solve_four_point(case: FourPointCase, record: Recorder, report: Report) -> dict[str, object]:
    """Write the solution of a slow bearing; returns the root attributes that say how it ended.

    Elastic rings come beside the rigid ones.

    Raises `BadCase` when no such bearing can exist.
    """
    solution: Any = None
    try:
        for name, solution in four_point.blocks(case, report):
            record.block(name, four_point.block(solution))
    except NotSolved as failure:
        return _not_solved(failure)
    except OutOfRange as problem:  # under its loads; what is built is without them
        return _not_solved(NotSolved(str(problem), angular_contact.OUT_OF_RANGE))
    except ImpossiblePart as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem
    worst = solution.balls.sliding.imbalance.max()
    words = f"friction of every ball in balance to {worst:.1e} of its power"
    if solution.distribution is not None:
        words += f", the ring to {solution.distribution.imbalance:.1e} of the largest force"
    found = four_point.judge(solution)
    ending = _converged(words, four_point.notes(solution, found), found)
    return {**ending, "clearance": clearance.record(case), **_lives(solution), **_stresses(solution)}


def solve_angular(
    case: FastCase, record: Recorder, report: Report, levels: "Levels | None" = None
) -> dict[str, object]:
    """Write the solution of a fast bearing; returns the root attributes that say how it ended.

    A case with a target is solved at the `levels` that were chosen for it and others, where they are given.

    Raises `BadCase` when no such bearing can exist.
    """
    run, resolved = None, ball_levels.ResolvedCase(case)
    if not case.rigid:
        from flexbearing.coupled.balls import CouplingRecord  # with finite elements

        run, resolved = CouplingRecord(record, report), ball_levels.resolved(case, levels, report)
    (ended,) = angular_contact.solved([resolved.case], report, run, resolved.grooves)
    coupled = dict(resolved.attributes)
    coupled |= {"method": case.coupling.method, **run.attributes} if run else {}
    last: tuple[Block, angular_contact.Solution] | None = None
    for name, each in ended.items():
        if isinstance(each, BadCase):
            raise each
        if isinstance(each, NotSolved):
            _store_nearest(case, run and run.nearest, record)
            return _not_solved(each) | coupled
        record.block(name, angular_contact.block(each))
        last = name, each
    assert last  # of rigid rings, at least
    name, solution = last
    words = (
        f"ring and balls in balance to {solution.state.imbalance:.1e} of the largest force after "
        f"{solution.state.evaluations} evaluations of all balls"
    )
    found = angular_contact.judge(solution)
    notes = *resolved.notes(solution.state.loads), *angular_contact.notes(solution, found)
    ending = _converged(words, notes, found)
    life = solution.lives and solution.lives.of_state
    lives = {name: life.record()} if life else {}
    rule = {"life_rule": life_rules.of_elements(case)} if solution.lives else {}
    return {
        **ending, "clearance": clearance.record(case), "life": lives, **rule, **_stresses(solution), **coupled
    }  # fmt: skip


def _stresses(solution: angular_contact.Solution | four_point.Solution) -> dict[str, Any]:
    """Root attribute of the largest stresses where a case requires them."""
    return {"stresses": probes.records(solution.stresses)} if solution.case.outputs.stresses else {}


def _lives(solution: four_point.Solution) -> dict[str, Any]:
    """Root attributes of the life of a slow bearing."""
    if solution.lives is None:
        return {}
    block, state = "rigid" if solution.case.rigid else "flexible", solution.lives.of_state
    thrust = four_point_lives.rated_arcs(solution.case).thrust
    rule = {"life_rule": life_rules.of_arcs(solution.case, thrust=thrust)}
    return rule | ({} if state is None else {"life": {block: state.record()}})


def _store_nearest(case: FastCase, state: AngularContactState | None, record: Recorder) -> None:
    """Store the state that came nearest to balls and rings in balance, which is none."""
    if state is not None:
        block = named(case, lambda: angular_contact.block(angular_contact.followed(case, state)))
        if not isinstance(block, Exception):
            record.block("flexible", block, converged=False)


def _converged(message: str, notes: tuple[Note, ...], found: tuple[Judged, ...]) -> dict[str, Any]:
    noted = {"notes": [note.record() for note in graded(notes)], "findings": [*map(vars, records(found))]}
    return _ending("converged", message, "converged") | noted


def _not_solved(failure: NotSolved) -> dict[str, Any]:
    return _ending(_status(failure), str(failure), str(failure.outcome))


def _status(problem: Exception) -> str:
    return problem.status if isinstance(problem, NotCoupled) else NOT_SOLVED


def _ending(status: str, message: str, ending: str) -> dict[str, Any]:
    return {"status": status, "message": message, "ending": ending, "iterations": 0}


# -- rows of a table -------------------------------------------------------------------------------


def angular_answers(
    cases: Sequence[FastCase],
    texts: Sequence[str],
    *_: object,
    levels: "Levels | None" = None,
    **__: object,
) -> list[Answer]:
    """Outputs of fast bearings, see `flexbearing.runs.rows.answers`; same parts are side by side."""
    report, known = Logged(), {}
    with linear_algebra_alone():
        resolved = [ball_levels.resolved(case, levels, report) for case in cases]
        for each in resolved:
            known |= each.grooves
        ended = angular_contact.solved([each.case for each in resolved], report, known=known)
        return [_of_fast(*each, texts) for each in zip(ended, resolved, strict=True)]


def four_point_answers(
    cases: Sequence[FourPointCase], texts: Sequence[str], *_: Any, **__: Any
) -> list[Answer]:
    """Outputs of slow bearings, one after the other: elastic rings are those of the cases before.

    Between rigid rings the search for the loads begins where it ended in the case before.
    """
    known = four_point.Known()
    with linear_algebra_alone():
        return [_of_slow(case, texts, known) for case in cases]


def _of_fast(
    ended: Mapping[Block, angular_contact.Ended], resolved: ball_levels.ResolvedCase, texts: Sequence[str]
) -> Answer:
    blocks: dict[str, Any] = {}
    for name, each in ended.items():
        block = (
            each if isinstance(each, Exception) else named(each.case, partial(angular_contact.block, each))
        )
        if isinstance(block, Exception):
            of_rigid = [text for text in texts if text.startswith("rigid.")] if blocks else []
            return _unsolved(block, _numbers(OF_FAST_BALLS, blocks, of_rigid))
        blocks[name] = block
    last: Any = list(ended.values())[-1]
    judged = angular_contact.judge(last)
    notes = *resolved.notes(last.state.loads), *angular_contact.notes(last, judged)
    found = row_findings(records(judged), notes)
    return Answer(CONVERGED, "", _numbers(OF_FAST_BALLS, blocks, texts), found)


def _of_slow(case: FourPointCase, texts: Sequence[str], known: four_point.Known) -> Answer:
    outputs = [requested(OF_SLOW_BALLS, text) for text in texts]
    names = {name for each in outputs for name in (*each.output.declared.of, each.output.declared.speed)}
    rigid = any(each.block == "rigid" for each in outputs)
    blocks: dict[str, Any] = {}

    def solve() -> Answer:
        solution: Any = None
        for name, solution in four_point.blocks(case, Logged(), rigid=rigid, known=known):
            blocks[name] = four_point.block(solution, names)
        numbers = _numbers(OF_SLOW_BALLS, blocks, texts)
        judged = four_point.judge(solution, in_row=True)
        found = row_findings(records(judged), four_point.notes(solution, judged, in_row=True))
        return Answer(CONVERGED, "", numbers, found)

    answer = named(case, solve)
    if isinstance(answer, Exception):
        of_rigid = [text for text in texts if text.startswith("rigid.")]
        return _unsolved(answer, _numbers(OF_SLOW_BALLS, blocks, of_rigid))
    return answer


def _unsolved(problem: Exception, numbers: Mapping[str, float]) -> Answer:
    """The answer of a case without a solution; `numbers` are those of states on the way to it."""
    return Answer(BAD_INPUT if isinstance(problem, BadCase) else _status(problem), str(problem), numbers)


def _numbers(layout: Layout, blocks: Mapping[str, Any], texts: Sequence[str]) -> dict[str, float]:
    return {text: requested(layout, text).number(blocks) for text in texts}
