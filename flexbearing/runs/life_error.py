"""How far the resolution of a case may put its life off."""

from dataclasses import dataclass

import numpy as np

from flexbearing.case.roller import Case
from flexbearing.coupling import LinearPair, PartnerFailed
from flexbearing.progress import Report
from flexbearing.rings.more_shapes import with_more_shapes
from quasidynamic import Equilibrium, NotSolved
from quasidynamic.note import Note, outside
from quasidynamic.outcome.finer_life import Compliances, life_error

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
        richer = with_more_shapes(case, state, rings, report)
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
