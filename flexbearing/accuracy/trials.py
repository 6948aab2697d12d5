"""A roller case solved at any levels of its choices, without a file."""

from concurrent.futures import Executor, Future
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.accuracy import Unusable
from flexbearing.accuracy.ladder import Place
from flexbearing.accuracy.levels import APART, SHAPES, Ladder, Race, in_a_fit, of_place
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.coupled import states
from flexbearing.coupled.coupled import BearingPartner
from flexbearing.coupling import RULES, PartnerFailed, StoppingCriterion, fixed_point, newton
from flexbearing.progress import Report
from flexbearing.rings import condensed
from flexbearing.rings.raceways import CondensedRings
from quasidynamic import Equilibrium, RollerBearing

if TYPE_CHECKING:
    from fem.raceway.compliance import RacewayCompliance

FINEST_SHAPES = SHAPES[-1]  # rings are condensed for so many at once: fewer of them are a part of that


@dataclass(frozen=True)
class Trial:
    """The end state of a case at some levels."""

    found: Equilibrium
    rings: condensed.Rings

    @cached_property
    def loads(self) -> NDArray:
        """Roller loads (2, Z) [N]."""
        return self.found.forces[..., 0]

    @cached_property
    def numbers(self) -> dict[str, float]:
        """Life [10^6 revolutions], stiffness of the bearing and of bearing and supports [N/m]."""
        near = self.rings.linearised(self.found.forces)
        return {
            "life": self.found.life,
            "stiffness": self.found.tangent.radial_stiffness,
            "total_stiffness": states.supported(self.found, near).tangent.radial_stiffness,
        }


def changes(trial: Trial, other: Trial) -> dict[str, float]:
    """How much two trials differ.

    Parameters
    ----------
    trial, other : Trial
        of one case; shares are those of the first

    Returns
    -------
    dict
        `roller_load`, the largest change of a load of any roller over the largest load; `life`, `stiffness`
        and `total_stiffness`, changes over the value; `cage_slip`, the change itself. What is not finite
        in a trial, such as the life of a bearing without load, is left out.
    """
    found = {
        "roller_load": np.abs(other.loads - trial.loads).max() / trial.loads.max(),
        "cage_slip": abs(other.found.cage_slip - trial.found.cage_slip),
    }
    for name, value in trial.numbers.items():
        found[name] = abs(other.numbers[name] / value - 1)
    return {name: float(value) for name, value in found.items() if np.isfinite(value)}


@dataclass
class Trials:
    """Trials of a case, each solved once; the last one is where the next begins."""

    case: Case
    ladders: tuple[Ladder, ...]
    report: Report
    _known: dict[Place, Trial] = field(default_factory=dict)
    _parts: dict[Any, Any] = field(default_factory=dict)  # condensed, by name and settings
    _begun: dict[Any, "Future[Any]"] = field(default_factory=dict)  # the same, on their way

    def __call__(self, place: Place) -> Trial:
        """End state at a level of each choice.

        Parameters
        ----------
        place : tuple of int
            levels

        Returns
        -------
        Trial

        Raises
        ------
        Unusable
            if a part could not be condensed there, or no equilibrium was found
        """
        if place not in self._known:
            try:
                self._known[place] = self._solved(place)
            except (PartnerFailed, BadCase) as problem:
                raise Unusable(str(problem)) from problem
        return self._known[place]

    def model(self, place: Place) -> RollerBearing:
        """The bearing at these levels."""
        case = of_place(self.case, self.ladders, place, None)
        assert case is not None  # only parts are left rigid
        return replace(self._bearing, slices=case.accuracy.slices, axial_modes=case.accuracy.axial_shapes)

    @cached_property
    def _bearing(self) -> RollerBearing:
        return roller_bearing.bearing(self.case)

    def _solved(self, place: Place) -> Trial:
        partner, both = BearingPartner(self.model(place)), self._rings(place)
        if both.rigid:
            return Trial(partner.solve(self._near(place)), both)
        for start, iterate in self._ways(place, partner, isinstance(both, CondensedRings)):
            *_, last = iterate(partner, both, start(), self._ending)
            if last.status == "converged":
                return Trial(last.state, both)
        raise PartnerFailed(last.message or last.status, last.ending)

    def _ways(self, place: Place, partner: BearingPartner, linear: bool):
        """Where to begin and how to iterate, the fastest first: from a trial nearby, or from rigid ones."""
        near = self._near(place)
        if near is not None and (
            linear or near.axial_modes == partner.model.axial_modes
        ):  # a fit asks for the forces
            yield lambda: near, newton
        yield partner.solve, newton
        yield partner.solve, partial(fixed_point, rule=RULES["iqn-ils"])

    @property
    def _ending(self) -> StoppingCriterion:
        given = self.case.coupling
        return StoppingCriterion(tolerance=given.tolerance, limit=given.max_iterations)

    def _near(self, place: Place) -> Equilibrium | None:
        """The last trial with the same rigid parts, or else the last one."""
        rigid = self._left_rigid(place)
        same = [trial for at, trial in self._known.items() if self._left_rigid(at) == rigid]
        found = [*self._known.values(), *same]
        return found[-1].found if found else None

    def _left_rigid(self, place: Place) -> list[bool]:
        return [ladder.settings[level] is None for ladder, level in zip(self.ladders, place, strict=True)]

    def _rings(self, place: Place) -> condensed.Rings:
        outer = self._raceway(place, "outer")
        return condensed.side_by_side(self._raceway(place, "inner"), outer, self._bearing.bearing.azimuths)

    def _raceway(self, place: Place, race: Race):
        """A condensed part for as many axial shapes as the bearing has; None where it is left rigid."""
        case = of_place(self.case, self.ladders, place, race)
        if case is None:
            return None
        if in_a_fit(case, race):
            return self._condensed(case, race)
        shapes = case.accuracy.axial_shapes
        found = self._condensed(finer(case, axial_shapes=max(shapes, FINEST_SHAPES)), race)
        return None if found is None else first_shapes(found, shapes)

    def _condensed(self, case: Case, race: Race):
        key = _part_key(case, race)
        if key in self._begun:
            return self._begun[key].result()
        if key not in self._parts:
            self._parts[key] = self._condense(case, race)
        return self._parts[key]

    def _condense(self, case: Case, race: Race):
        condense = condensed.inner_ring if race == "inner" else condensed.outer_ring
        return condense(case, self._bearing.bearing.azimuths, self.report)

    def foresee(self, pool: Executor) -> None:
        """Begin with the first two levels of a squirrel cage, which take longest.

        The first is needed to judge the cage, the second nearly always; they are condensed in processes
        of their own, while this one does all else.
        """
        place = tuple(ladder.choice.start for ladder in self.ladders)
        for k, ladder in enumerate(self.ladders):
            if ladder.cost == APART:
                for level in (1, 2):
                    case = of_place(
                        self.case, self.ladders, (*place[:k], level, *place[k + 1 :]), ladder.race
                    )
                    assert case is not None
                    wanted = finer(case, axial_shapes=max(case.accuracy.axial_shapes, FINEST_SHAPES))
                    self._begun[_part_key(wanted, "outer")] = pool.submit(self._condense, wanted, "outer")


def _part_key(case: Case, race: Race) -> tuple[Race, str]:
    """All of a level that a part has; slices it has none."""
    return race, repr(finer(case, slices=0).accuracy)


def finer(case: Case, **settings: Any) -> Case:
    """The case with other settings of [accuracy]."""
    return case.model_copy(update={"accuracy": case.accuracy.model_copy(update=settings)})


def first_shapes(raceway: "RacewayCompliance", shapes: int) -> "RacewayCompliance":
    """The same raceway for rollers that exchange fewer axial shapes with it: a part of every array."""
    return replace(
        raceway,
        absolute=raceway.absolute[:, :shapes, :, :shapes],
        translation=raceway.translation[..., :shapes],
        initial_deviation=raceway.initial_deviation[:, :shapes],
    )
