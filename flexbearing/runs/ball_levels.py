"""Balls between elastic rings at the levels that their target requires."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

import quasidynamic as qd
from flexbearing.accuracy.adaptive import adaptive_resolution
from flexbearing.accuracy.case_levels import Ladder, case_at
from flexbearing.accuracy.family import LevelsOfFamily, relative_changes
from flexbearing.accuracy.groove_levels import ladders
from flexbearing.accuracy.ladder import Place, Unusable
from flexbearing.accuracy.shared import Levels, UsualLevels
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.life import ball_lives
from flexbearing.progress import Report
from flexbearing.quantities.angular_contact import STIFFNESSES
from flexbearing.quantities.coupling import BALL_LOAD
from flexbearing.runs import angular_contact
from quasidynamic.note import Note


@dataclass(frozen=True)
class BallTrial:
    """The end state of a case at some levels."""

    case: FastCase
    state: qd.AngularContactState

    @property
    def loads(self) -> NDArray:
        """Loads (2, Z) [N] of the balls on both races."""
        return self.state.loads

    @cached_property
    def numbers(self) -> dict[str, float]:
        """Stiffness along the axes [N/m], and the life [rev] where there is one."""
        lives = ball_lives.lives(self.case, self.state)
        along = dict(zip(STIFFNESSES, np.diag(self.state.stiffness)[: len(STIFFNESSES)], strict=True))
        return along | ({} if lives is None else {"life": lives.basic})


def changes(trial: BallTrial, other: BallTrial) -> dict[str, float]:
    """How much two trials differ."""
    return relative_changes(BALL_LOAD, trial, other)


@dataclass
class BallTrials:
    """Trials of a case, each solved once; their grooves are those of the same case at the same levels."""

    case: FastCase
    ladders: tuple[Ladder, ...]
    report: Report
    grooves: dict[Any, Any] = field(default_factory=dict)  # by what decides them
    _solved: dict[Place, BallTrial] = field(default_factory=dict)

    def __call__(self, place: Place) -> BallTrial:
        """End state at a level of each choice; raises `Unusable` where there is none."""
        if place not in self._solved:
            case = at_levels(self.case, self.ladders, place)
            model = angular_contact.prepared(case)
            (state,) = angular_contact.between_elastic_rings([case], [model], self.report, self.grooves)
            if isinstance(state, Exception):
                raise Unusable(str(state)) from state
            self._solved[place] = BallTrial(case, state)
        return self._solved[place]


BALLS = LevelsOfFamily(ladders, BallTrials, changes, (BALL_LOAD, "life"))


@dataclass(frozen=True)
class ResolvedCase:
    """A case at definite levels of its resolution."""

    case: FastCase
    attributes: Mapping[str, Any] = field(default_factory=dict)  # of the result file
    notes: Callable[[NDArray], Iterable[Note]] = lambda loads: ()  # on the end state, by its loads (2, Z) [N]
    grooves: dict[Any, Any] = field(default_factory=dict)  # that are condensed


def resolved(case: FastCase, levels: Levels | None, report: Report) -> ResolvedCase:
    """A case as it stands, or at the levels that its target requires, or that others share with it."""
    if case.accuracy.target is None or case.rigid:
        return ResolvedCase(case)
    if levels is None:
        try:
            found = adaptive_resolution(case, BALLS, report)
        except Unusable as problem:
            levels = UsualLevels(str(problem))
        else:
            at = at_levels(case, ladders(case), found.place)
            return ResolvedCase(at, found.attributes(), found.notes, found.trials.grooves)
    at = case if levels.place is None else at_levels(case, ladders(case), levels.place)
    notes = levels.notes()
    return ResolvedCase(at, levels.attributes(), lambda loads: notes)


def at_levels(case: FastCase, choices: tuple[Ladder, ...], place: Place) -> FastCase:
    """A case at a level of each choice."""
    at = case_at(case, choices, place)
    assert at is not None  # no ring is left rigid
    return at
