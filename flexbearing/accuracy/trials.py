"""A roller case solved at any levels of its choices, without a file."""

from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.accuracy import Unusable
from flexbearing.accuracy.case_levels import Cost, Ladder, case_at, with_accuracy
from flexbearing.accuracy.family import LevelsOfFamily, relative_changes
from flexbearing.accuracy.ladder import Place
from flexbearing.accuracy.levels import ladders
from flexbearing.build import roller_bearing
from flexbearing.build.ring_parts import Race
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.case.roller.numerics import AXIAL_MODES
from flexbearing.coupled.coupled import BearingPartner
from flexbearing.coupled.states import EndStates
from flexbearing.coupling import (
    RULES,
    Iteration,
    PartnerFailed,
    Raceway,
    RacewayPair,
    StoppingCriterion,
    fixed_point,
    newton,
)
from flexbearing.program.threads import of_solids
from flexbearing.progress import Report
from flexbearing.quantities.coupling import ROLLER_LOAD
from flexbearing.quantities.roller import CAGE_SLIP
from flexbearing.rings import condensed
from flexbearing.rings.fits import RacewayInFit, is_in_fit
from flexbearing.rings.raceways import CondensedRaceway, RigidRaceway
from flexbearing.rings.supported import SupportedRaceway
from quasidynamic import Equilibrium, RollerBearing

MOST_MODES = AXIAL_MODES[-1]  # rings are condensed for so many at once: fewer of them are a part of that


@dataclass(frozen=True)
class Trial:
    """The end state of a case at some levels."""

    state: Equilibrium
    rings: RacewayPair

    @cached_property
    def loads(self) -> NDArray:
        """Roller loads (2, Z) [N]."""
        return self.state.forces[..., 0]

    @cached_property
    def numbers(self) -> dict[str, float]:
        """Life [10^6 revolutions], stiffness of the bearing and of bearing and supports [N/m]."""
        end = EndStates(self.state.cases, self.rings.linearised(self.state.forces))
        return {
            "life": self.state.life,
            "stiffness": end.between_raceways.radial_stiffness[0],
            "total_stiffness": end.with_supports.radial_stiffness[0],
        }


def changes(trial: Trial, other: Trial) -> dict[str, float]:
    """How much two trials differ, the cage slip in parts of that of rolling."""
    slip = abs(other.state.cage_slip - trial.state.cage_slip)
    slips = {CAGE_SLIP.name: float(slip)} if np.isfinite(slip) else {}
    return relative_changes(ROLLER_LOAD, trial, other) | slips


@dataclass
class Trials:
    """Trials of a case, each solved once; the last one is where the next begins."""

    case: Case
    ladders: tuple[Ladder, ...]
    report: Report
    _solved: dict[Place, Trial] = field(default_factory=dict)
    _raceways: dict[Any, Raceway] = field(default_factory=dict)  # by race and settings
    _begun: dict[Any, "Future[Raceway]"] = field(default_factory=dict)  # the same, on their way

    def __call__(self, place: Place) -> Trial:
        """End state at a level of each choice.

        Raises `Unusable` if a part could not be condensed there, or no equilibrium was found.
        """
        if place not in self._solved:
            try:
                self._solved[place] = self._solve(place)
            except (PartnerFailed, BadCase) as problem:
                raise Unusable(str(problem)) from problem
        return self._solved[place]

    def model(self, place: Place) -> RollerBearing:
        """The bearing at these levels."""
        return model_at(self._bearing, self.case, self.ladders, place)

    def rings(self, place: Place) -> RacewayPair:
        """The parts at these levels.

        Raises `PartnerFailed`, `BadCase` if one of them could not be condensed there.
        """
        return RacewayPair(self._raceway(place, "inner"), self._raceway(place, "outer"))

    @cached_property
    def _bearing(self) -> RollerBearing:
        return roller_bearing.bearing(self.case)

    def _solve(self, place: Place) -> Trial:
        partner = BearingPartner(self.model(place))
        rings = self.rings(place)
        if rings.rigid:
            return Trial(partner.solve(self._nearest(place)), rings)
        for iterations in self._attempts(place, partner, rings):
            *_, last = iterations()
            if last.status == "converged":
                return Trial(last.state, rings)
        raise PartnerFailed(last.message or last.status, last.ending)

    def _attempts(
        self, place: Place, partner: BearingPartner, rings: RacewayPair
    ) -> Iterator[Callable[[], Iterator[Iteration[Equilibrium]]]]:
        """Ways to couple, the fastest first: from a trial nearby, or from rigid raceways."""
        coupling, nearest = self.case.coupling, self._nearest(place)
        criterion = StoppingCriterion(tolerance=coupling.tolerance, limit=coupling.max_iterations)
        in_fit = any(isinstance(r, RacewayInFit | SupportedRaceway) for r in (rings.inner, rings.outer))
        # A fit is linearised at the forces of the start, which must have its axial modes.
        if nearest is not None and not (in_fit and nearest.axial_modes != partner.model.axial_modes):
            yield lambda: newton(partner, rings, nearest, criterion)
        yield lambda: newton(partner, rings, partner.solve(), criterion)
        yield lambda: fixed_point(partner, rings, partner.solve(), criterion, RULES["iqn-ils"])

    def _nearest(self, place: Place) -> Equilibrium | None:
        """The last trial with the same rigid parts, or else the last one."""
        rigid = self._left_rigid(place)
        similar = [trial for at, trial in self._solved.items() if self._left_rigid(at) == rigid]
        trials = [*self._solved.values(), *similar]
        return trials[-1].state if trials else None

    def _left_rigid(self, place: Place) -> list[bool]:
        return [ladder.settings[level] is None for ladder, level in zip(self.ladders, place, strict=True)]

    def _raceway(self, place: Place, race: Race) -> Raceway:
        """What carries a raceway, for as many axial modes as the bearing has."""
        case = case_at(self.case, self.ladders, place, race)
        if case is None:
            return RigidRaceway(self._bearing.bearing.azimuths)
        if is_in_fit(case, race):
            return self._condensed(case, race)
        modes = case.accuracy.axial_shapes
        raceway = self._condensed(with_most_modes(case), race)
        fewer = isinstance(raceway, CondensedRaceway | SupportedRaceway)
        return raceway.with_axial_modes(modes) if fewer else raceway

    def _condensed(self, case: Case, race: Race) -> Raceway:
        key = _raceway_key(case, race)
        if key in self._begun:
            return self._begun[key].result()
        if key not in self._raceways:
            self._raceways[key] = self._condense(case, race)
        return self._raceways[key]

    def _condense(self, case: Case, race: Race) -> Raceway:
        return condensed.raceway(case, race, self._bearing.bearing.azimuths, self.report)

    def begin(self, pool: Executor) -> None:
        """Begin with the first two levels of a squirrel cage, which take longest, given two threads.

        The first is needed to judge the cage, the second nearly always; they are condensed in processes
        of their own, while this one does all else.
        """
        if of_solids(self.case.accuracy.threads) < 2:
            return
        place = tuple(ladder.choice.start for ladder in self.ladders)
        for k, ladder in enumerate(self.ladders):
            if ladder.cost is Cost.CYCLIC:
                for level in (1, 2):
                    at = (*place[:k], level, *place[k + 1 :])
                    case = case_at(self.case, self.ladders, at, ladder.race)
                    assert case is not None
                    finest = with_most_modes(case)
                    future = pool.submit(self._condense, finest, "outer")
                    self._begun[_raceway_key(finest, "outer")] = future


def _raceway_key(case: Case, race: Race) -> tuple[Race, str]:
    """All settings of a level that a raceway depends on; it has no slices."""
    return race, repr(with_accuracy(case, slices=0).accuracy)


def model_at(model: RollerBearing, case: Case, ladders: tuple[Ladder, ...], place: Place) -> RollerBearing:
    """The bearing of a case at a level of each choice."""
    resolved = case_at(case, ladders, place, None)
    assert resolved is not None  # only parts are left rigid
    accuracy = resolved.accuracy
    return replace(model, slices=accuracy.slices, axial_modes=accuracy.axial_shapes)


def with_most_modes(case: Case) -> Case:
    """The case with as many axial modes as its rings are condensed for."""
    return with_accuracy(case, axial_shapes=max(case.accuracy.axial_shapes, MOST_MODES))


ROLLERS = LevelsOfFamily(ladders, Trials, changes, (ROLLER_LOAD, "life"), Trials.begin)
