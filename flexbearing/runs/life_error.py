"""How far the resolution of cases may put their lives off."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.roller import Case
from flexbearing.coupling import LinearPair, PartnerFailed
from flexbearing.progress import Report
from flexbearing.rings.more_shapes import more_shapes_matter, with_more_shapes
from quasidynamic.note import Note, outside
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.finer_life import Compliances, life_errors

RESOLVED = 0.05  # of the life: an error that is worth a word (assumed)


@dataclass(frozen=True)
class LifeErrors:
    """Estimated numerical errors of the lives of C states."""

    values: NDArray | None  # (C) over the life [-], not a number where there is none; None without any
    sought: NDArray | None = None  # (C) whether an error was looked for
    problems: tuple[str, ...] = ()  # (C) what kept further axial shapes away; empty: nothing

    def notes(self, case: int) -> tuple[Note, ...]:
        """What is to be said of one of them."""
        if self.sought is None or not self.sought[case]:
            return ()
        value = np.nan if self.values is None else self.values[case]
        if np.isnan(value):
            words = "no error estimated: life with more axial modes: no line loads were found"
            return (_resolution(words),)
        problem, notes = self.problems[case], []
        if problem:
            notes.append(_resolution(f"its error counts slices, not axial shapes: {problem}"))
        if value > RESOLVED:
            words = "accuracy.slices, accuracy.axial_shapes or accuracy.target resolve it"
            notes.append(_resolution(f"numerical error of about {value:.0%}; {words}"))
        return tuple(notes)


def _resolution(words: str) -> Note:
    return outside("life-resolution", f"life: {words}")


def estimated(case: Case, states: BearingStates, rings: LinearPair, report: Report) -> LifeErrors:
    """Estimate what finer slices and more axial shapes would change; see `life_errors`."""
    sought = np.isfinite(states.life)
    if case.accuracy.target is not None or not sought.any():
        return LifeErrors(None)
    errors, problems = np.full(len(sought), np.nan), [""] * len(sought)
    matter = more_shapes_matter(states, rings)
    for races in sorted({*map(tuple, matter[sought].tolist())}):
        some = np.flatnonzero(sought & (matter == races).all(axis=1))
        richer: Compliances = (None, None)
        try:
            richer = with_more_shapes(case, rings, races, report)
        except PartnerFailed as problem:  # which leaves the error of the slices
            for place in some:
                problems[place] = str(problem)
        errors[some] = life_errors(states if len(some) == len(sought) else states.take(some), richer)
    return LifeErrors(None if np.isnan(errors).all() else errors, sought, tuple(problems))
