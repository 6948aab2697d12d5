"""How far the resolution of a case may put its life off."""

from contextlib import suppress
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.roller import Case
from flexbearing.coupling import LinearPair, PartnerFailed
from flexbearing.progress import Report
from flexbearing.rings.more_shapes import more_shapes_matter, with_more_shapes
from quasidynamic import Equilibrium, NotSolved
from quasidynamic.note import Note, outside
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.finer_life import Compliances, life_error, life_errors

RESOLVED = 0.05  # of the life: an error that is worth a word (assumed)


@dataclass(frozen=True)
class LifeError:
    """Estimated numerical error of the life of a state, with what is to be said of it."""

    value: float | None  # over the life [-]; None where nothing was estimated
    notes: tuple[Note, ...] = ()


def estimated(case: Case, state: Equilibrium, rings: LinearPair, report: Report) -> LifeError:
    """Estimate what finer slices and more axial shapes would change; see `life_error`.

    Parameters
    ----------
    case : Case
        of the state
    state : Equilibrium
        solved
    rings : LinearPair
        at its forces
    report : Report
        hears of parts that are condensed for it

    Returns
    -------
    LifeError
    """
    if case.accuracy.target is not None or not np.isfinite(state.life):  # a target has its own estimate
        return LifeError(None)
    notes: tuple[Note, ...] = ()
    richer: Compliances = (None, None)
    try:
        richer = with_more_shapes(case, rings, more_shapes_matter(state.cases, rings)[0].tolist(), report)
    except PartnerFailed as problem:
        notes = (outside("life-resolution", f"life: its error counts slices, not axial shapes: {problem}"),)
    try:
        value = life_error(state, richer)
    except NotSolved as problem:
        return LifeError(None, (outside("life-resolution", f"life: no error estimated: {problem}"),))
    if value > RESOLVED:
        notes += (
            outside(
                "life-resolution",
                f"life: numerical error of about {value:.0%}; accuracy.slices, accuracy.axial_shapes or "
                "accuracy.target resolve it",
            ),
        )
    return LifeError(value, notes)


def estimated_errors(case: Case, states: BearingStates, rings: LinearPair, report: Report) -> NDArray:
    """Estimate the errors of many states between rings of the same parts.

    Parameters
    ----------
    case : Case
        of one of the states, with the parts and the `accuracy` of all
    states : BearingStates
        C of them, solved
    rings : LinearPair
        at their forces
    report : Report
        hears of parts that are condensed for it

    Returns
    -------
    array (C)
        as `estimated` has them, over the life [-]; not a number where it has none
    """
    errors = np.full(len(states.scaled), np.nan)
    if case.accuracy.target is not None:  # which has its own estimate
        return errors
    matter = more_shapes_matter(states, rings)
    for races in np.unique(matter, axis=0):
        some, richer = np.flatnonzero((matter == races).all(axis=1)), (None, None)
        with suppress(PartnerFailed):  # which leaves the error of the slices
            richer = with_more_shapes(case, rings, races.tolist(), report)
        of_some = states if len(some) == len(errors) else states.take(some)
        errors[some] = life_errors(of_some, richer)
    return errors
