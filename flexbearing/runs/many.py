"""Outputs of many roller cases at once, equal to those of single runs."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.roller import Case
from flexbearing.outputs import wanted
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.quantities.roller import LAYOUT
from flexbearing.runs.solved_together import solved_together
from quasidynamic import NotSolved, OutOfRange
from quasidynamic.note import Note, graded

if TYPE_CHECKING:
    from flexbearing.accuracy.shared import Levels

CONVERGED = "converged"


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


def answers(
    cases: Sequence[Case],
    texts: Sequence[str],
    alone: Alone,
    *,
    search: bool = False,
    levels: "Levels | None" = None,
) -> Answers:
    """Compute the wanted outputs of many cases.

    Cases that differ in numbers only, between rigid rings or between the same elastic ones, are solved side
    by side, and their outputs are arrays. What needs a run of its own has one, see `solved_together`; so has
    what is not solved. Nothing is computed but what is wanted, and what dangers need.

    Parameters
    ----------
    cases : sequence of Case
        as they were read
    texts : sequence of str
        outputs with their units, as `flexbearing.outputs.wanted` takes them
    alone : callable
        the answer of a case from a run of its own
    search : bool
        whether other equilibria are searched where they are likely, as a run does, for some hundred times the
        cost of a case; else the message says that they are likely, which is so for more cases than have any
    levels : Levels, optional
        of cases with a target, which share them

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
    blocks = {output.block for output in outputs.values()}
    numbers = {text: np.full(len(cases), np.nan) for text in texts}
    messages: dict[int, str] = {}
    failed: set[int] = set()
    of_levels = levels.notes() if levels else ()
    # The bearings' matrices are small: threads of the linear algebra would only wait for each other.
    with linear_algebra_alone():
        for together in solved_together(cases, blocks, levels):
            places = together.places.tolist()
            try:
                found = {
                    text: together.numbers(output)
                    for text, output in outputs.items()
                    if output.block in together.blocks
                }
                if together.answer:
                    dangers = together.dangers(search=search)
                    messages |= {
                        place: told((*of_levels, *notes))
                        for place, notes in zip(places, dangers, strict=True)
                    }
            except (NotSolved, OutOfRange):  # of one of them, which its own run tells
                failed |= set(places)
                continue
            for text, values in found.items():
                numbers[text][places] = values
    statuses = dict.fromkeys(messages, CONVERGED)
    for place in sorted(failed | (set(range(len(cases))) - messages.keys())):
        answer = alone(place)
        statuses[place], messages[place] = answer.status, answer.message
        for text in texts:
            numbers[text][place] = answer.numbers.get(text, np.nan)
    places = range(len(cases))
    return Answers(
        tuple(statuses[place] for place in places), tuple(messages[place] for place in places), numbers
    )
