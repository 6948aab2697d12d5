"""Outputs of many roller cases at once, equal to those of single runs."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from flexbearing.build import roller_bearing
from flexbearing.case.roller import Case
from flexbearing.coupling import LinearPair
from flexbearing.outputs import wanted
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.quantities.roller import LAYOUT
from flexbearing.runs import validate_roller
from flexbearing.runs.solved_together import ANSWER, Together
from quasidynamic import ImpossiblePart, NotSolved, OutOfRange, RollerBearing, SolverOutcome, solve_many
from quasidynamic.note import Note, graded
from quasidynamic.outcome.equilibria import Batch, Equilibria

CONVERGED = "converged"
AT_ONCE = 32  # cases whose matrices fit into the processor's cache
NO_RINGS = LinearPair(None, None)


@dataclass(frozen=True)
class Answer:
    """What a run of a case gives."""

    status: str  # "converged", or how it ended
    message: str  # dangers of a run that converged, else why it did not
    numbers: Mapping[str, float]  # by the texts of outputs; absent: the case does not have it


Alone = Callable[[int], Answer]  # the answer of a case, by its place, from a run of its own


@dataclass(frozen=True)
class Answers:
    """What runs of many cases give."""

    statuses: tuple[str, ...]
    messages: tuple[str, ...]
    numbers: Mapping[str, NDArray]  # (cases) by the texts of outputs; NaN where a case does not have it


def told(notes: Iterable[Note]) -> str:
    """Message of a run that converged: its dangers, one after the other."""
    return "; ".join(f"danger: {note.text}" for note in graded(notes) if note.grade == "danger")


def answers(cases: Sequence[Case], texts: Sequence[str], alone: Alone, *, search: bool = True) -> Answers:
    """Compute the wanted outputs of many cases.

    Cases that differ in numbers only are solved side by side, and their outputs are arrays. What needs a run
    of its own has one: cases that are not solved there, those with `accuracy.target`, with several positions
    of the rollers or with stresses. Nothing is computed but what is wanted, and what dangers need.

    Parameters
    ----------
    cases : sequence of Case
        as they were read
    texts : sequence of str
        outputs with their units, as `flexbearing.outputs.wanted` takes them
    alone : callable
        the answer of a case from a run of its own
    search : bool
        whether other equilibria are searched where they are likely, as a run does, for about a thousand times
        the cost of a case; else its message says that they are likely

    Returns
    -------
    Answers
        equal to those of single runs to 1e-9

    Raises
    ------
    UnknownOutput, WrongUnit
        for texts that name no output
    """
    outputs = {text: wanted(LAYOUT, text) for text in texts}
    numbers = {text: np.full(len(cases), np.nan) for text in texts}
    messages: dict[int, str] = {}
    # The bearings' matrices are small: threads of the linear algebra would only wait for each other.
    with linear_algebra_alone():
        for together in _solved(cases):
            try:
                found = {
                    text: together.numbers(output)
                    for text, output in outputs.items()
                    if output.block in together.blocks
                }
                dangers = together.dangers(search=search)
            except (NotSolved, OutOfRange):  # of one of them, which its own run tells
                continue
            for text, values in found.items():
                numbers[text][together.places] = values
            messages |= zip(together.places.tolist(), map(told, dangers), strict=True)
    statuses = dict.fromkeys(messages, CONVERGED)
    for place in sorted(set(range(len(cases))) - messages.keys()):
        answer = alone(place)
        statuses[place], messages[place] = answer.status, answer.message
        for text, number in answer.numbers.items():
            numbers[text][place] = number
    places = range(len(cases))
    return Answers(
        tuple(statuses[place] for place in places), tuple(messages[place] for place in places), numbers
    )


def _solved(cases: Sequence[Case]) -> Iterator[Together]:
    """Yield cases that converge side by side."""
    models = {place: model for place, case in enumerate(cases) if (model := _model(case))}
    places = np.array(list(models), int)
    if not len(places):
        return
    for batch in _converged(solve_many(list(models.values()))):
        own = places[batch.places].tolist()
        yield Together(
            [cases[place] for place in own],
            [models[place] for place in own],
            replace(batch, places=places[batch.places]),
            [NO_RINGS] * len(own),
            (*ANSWER, "rigid"),
        )


def _model(case: Case) -> RollerBearing | None:
    """Bearing of a case that may be solved beside others; None where it needs a run of its own."""
    elastic = case.inner.kind != "rigid" or case.outer.kind != "rigid"
    if elastic or case.accuracy.target is not None or case.operation.roller_positions is not None:
        return None
    try:
        validate_roller.build(case)
        return roller_bearing.bearing(case)
    except (ImpossiblePart, OutOfRange):  # which its own run tells
        return None


def _converged(found: Equilibria) -> Iterator[Batch]:
    """Yield the cases that converged, some at once."""
    for batch in found.batches:
        solved = np.flatnonzero([outcome is SolverOutcome.CONVERGED for outcome in batch.outcomes])
        for first in range(0, len(solved), AT_ONCE):
            some = solved[first : first + AT_ONCE]
            yield batch if len(some) == len(batch) else batch.take(some)
