"""Roller cases that converged side by side: outputs and dangers of their end states."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fem.cage.bar_forces import NominalStresses
from flexbearing.build.ring_parts import outer_mass
from flexbearing.build.rough_surfaces import roughness
from flexbearing.case.roller import Case
from flexbearing.coupled import states
from flexbearing.coupled.states import EndState, EndStates
from flexbearing.coupling import LinearPair
from flexbearing.findings import DANGER, declared, evaluate
from flexbearing.findings.strength import BARS
from flexbearing.outputs import Wanted
from flexbearing.progress import Logged
from flexbearing.quantities.quantity import Quantity, taken
from flexbearing.quantities.roller import LAYOUT
from flexbearing.runs import bars, half_space, judged, life, several, skew
from flexbearing.runs.end_state import end_state
from flexbearing.runs.life_error import estimated, estimated_errors
from flexbearing.runs.life_of_state import MREV, LifeOfState
from quasidynamic import Equilibrium, RollerBearing
from quasidynamic.note import Note, danger
from quasidynamic.outcome.equilibria import Batch
from quasidynamic.outcome.skew import Skew
from quasidynamic.outcome.static_pressure import ROLLERS
from quasidynamic.several.indicator import each_several_likely

QUANTITIES = LAYOUT.datasets("block")
BY_CASE = ("life.", "skew.")  # sources that are found case by case
LIFE_ERROR, OUTER_MASS = "life_error", "outer_mass"  # estimated and computed where they are wanted
ANSWER = ("", "flexible")  # the block that answers a case, which is also that of outputs that name none


@dataclass(frozen=True)
class SolvedCase:
    """One of them, with what is found case by case."""

    case: Case
    batch: Batch
    rings: LinearPair
    place: int  # in the batch
    relative_speed: float  # of the inner ring less that of the outer ring [rad/s]

    @cached_property
    def state(self) -> Equilibrium:
        """Its state, taken out of the batch, which takes as long as some of its outputs."""
        return self.batch[self.place]

    @cached_property
    def whole(self) -> EndState:
        """Its end state with the most loaded roller on half-spaces."""
        roller, _ = half_space.most_loaded(self.case, self.state)
        return end_state(self.case, self.state, self.rings, whole=roller)

    @cached_property
    def life(self) -> LifeOfState | None:
        """Life after every factor; None where nothing modifies it."""
        if self.case.life.is_basic:
            return None
        return life.modified(self.case, self.state, self.whole.whole if on_half_spaces(self.case) else None)

    @cached_property
    def skew(self) -> Skew | None:
        """Skew of the rollers between flanges; None without."""
        return None if self.case.bearing.flange is None else skew.at(self.case, self.state)

    def block(self, wanted: list[Quantity]) -> dict[str, NDArray]:
        """Quantities of a case whose most loaded roller is on half-spaces, as its own run has them."""
        names, end = {entry.name for entry in wanted}, self.whole
        if LIFE_ERROR in names:
            end = replace(end, life_error=estimated(self.case, self.state, self.rings, Logged()).value)
        nominal = bars.nominal_stresses(self.case, end)
        return states.block(end, wanted, life=self.life, skew=self.skew, bars=nominal)

    def quantities(self, wanted: list[Quantity]) -> dict[str, NDArray]:
        """Quantities of `BY_CASE` and the speed; nothing else is computed."""
        parts = {str(entry.path[0]) for entry in wanted} - {"end"}
        there = {"end": self} | {part: getattr(self, part) for part in parts}
        return taken([entry for entry in wanted if there[str(entry.path[0])] is not None], there)


@dataclass(frozen=True)
class Together:
    """C cases that converged side by side between raceways of the same compliance."""

    cases: list[Case]
    models: list[RollerBearing]
    batch: Batch
    rings: list[LinearPair]  # of each case; only their deviations without load differ
    blocks: tuple[str, ...]  # of their results that these states are

    @property
    def answer(self) -> bool:
        """Whether these states answer the cases, and are not on the way to it."""
        return "" in self.blocks

    @property
    def places(self) -> NDArray:
        """Places (C) among all cases."""
        return self.batch.places

    def numbers(self, output: Wanted) -> NDArray:
        """Numbers (C) of an output of these blocks; NaN where a case does not have it."""
        return self.all_numbers([output])[0]

    def all_numbers(self, outputs: Sequence[Wanted]) -> list[NDArray]:
        """Numbers (C) of outputs of one of these blocks each; a quantity that several need is taken once."""
        names = [datasets(output) for output in outputs]
        if self._on_half_spaces:
            blocks = [case.block(_quantities(names)) for case in self._each]
            return [np.array([_numbers(output, block) for block in blocks]) for output in outputs]
        together = self._arrays(_quantities(each for each in names if not _by_case(each)))
        apart = _quantities(each for each in names if _by_case(each))
        by_case = [case.quantities(apart) for case in self._each] if apart else []
        return [
            np.array([_numbers(output, block) for block in by_case])
            if _by_case(each)
            else self._of_each(_numbers(output, together))
            for output, each in zip(outputs, names, strict=True)
        ]

    def _of_each(self, numbers: Any) -> NDArray:
        """Numbers (C), also where all cases have the same."""
        return numbers if np.shape(numbers) else np.full(len(self.cases), numbers)

    def _arrays(self, quantities: list[Quantity]) -> dict[str, NDArray]:
        """Quantities of all cases at once."""
        if not quantities:
            return {}
        states, end, names = self.batch.states, self._end, {entry.name for entry in quantities}
        if LIFE_ERROR in names:
            errors = estimated_errors(self.cases[0], states, self.rings[0], Logged())
            end = replace(end, life_error=errors)
        if OUTER_MASS in names:
            end = replace(end, outer_mass=self._outer_mass)
        solved: dict[str, Any] = {"state": states, "end": end}
        solved |= {"bearing": states.balance.roller.bearing, "losses": states.losses}
        if any(entry.source.startswith("bars.") for entry in quantities):
            solved["bars"] = self._bars
        return taken(quantities, solved, many=True)

    @property
    def _on_half_spaces(self) -> bool:
        """Whether half-spaces answer for the most loaded roller of each case."""
        return on_half_spaces(self.cases[0])

    @property
    def _rigid(self) -> bool:
        return self.rings[0].rigid

    @cached_property
    def _end(self) -> EndStates:
        rough = [roughness(case) for case in self.cases]
        known = [np.full(2, np.nan) if each is None else each for each in rough]
        given = any(each is not None for each in rough)
        states = self.batch.states
        bearings = [model.bearing for model in self.models]
        ratings = [life.static(*each) for each in zip(self.cases, bearings, strict=True)]
        return EndStates(
            states,
            self.rings[0],
            np.array(known) if given else None,
            edge_stress=self._edge_stress,
            static_rating=np.array(ratings),
        )

    @property
    def _outer_mass(self) -> NDArray | None:
        """Masses (C) of what carries the outer raceway [kg]; None where one is not known."""
        masses = [outer_mass(case) for case in self.cases]
        return None if None in masses else np.array(masses, dtype=float)

    @property
    def _edge_stress(self) -> NDArray | None:
        """Factor on the load of slices (C, K); None where no case takes any."""
        if not any(case.life.edge_stress for case in self.cases):
            return None
        slices = self.batch.states.slice_loads.shape[-1]
        each = [life.edge_stress(case, slices) for case in self.cases]
        return np.array([np.ones(slices) if factor is None else factor for factor in each])

    @cached_property
    def _bars(self) -> NominalStresses | None:
        """Nominal stresses of the bars of a squirrel cage."""
        return bars.nominal_stresses(self.cases[0], self._end)

    @cached_property
    def _each(self) -> list[SolvedCase]:
        speeds = self.batch.states.balance.points.relative_speed[:, 0].tolist()
        each = enumerate(zip(self.cases, self.rings, speeds, strict=True))
        return [SolvedCase(case, self.batch, rings, place, speed) for place, (case, rings, speed) in each]

    def dangers(self, *, search: bool) -> list[tuple[Note, ...]]:
        """What makes the answer of each case dangerous, as its own run says it.

        Without a `search` for other equilibria it is told where they are likely.
        """
        found = evaluate(filter(lambda each: each.grade == DANGER, declared.OF_ROLLERS), self._values())
        known, others = self.batch.doubtful, self._others if search else _not_searched
        likely = each_several_likely(self.batch.states) if known is None else known
        return [
            (*judged.notes(found, case), *(others(case) if likely[case] else ()))
            for case in range(len(self.cases))
        ]

    def _values(self) -> dict[str, Any]:
        """What dangers are judged by, cases first."""
        pressure, lives = self._end.peak_pressure, self.batch.states.life
        if self._on_half_spaces:
            pressure = np.array([judged.bounded_pressure(each.whole) for each in self._each])
            lives = np.array([each.whole.life for each in self._each]) / MREV
        modified = (
            None if case.life.is_basic else each.life
            for case, each in zip(self.cases, self._each, strict=True)
        )
        rated = [
            basic if life is None else life.modified / MREV
            for basic, life in zip(lives, modified, strict=True)
        ]
        limits = [case.materials.outer_ring.yield_stress or np.nan for case in self.cases]
        stresses = (
            {"stress": {BARS: self._bars.largest}, "yield_stress": {BARS: limits}} if self._bars else {}
        )
        return {
            **judged.pressures(pressure.T, ROLLERS),
            "static_safety": self._end.static_safety,
            "life": judged.seconds(rated, self.batch.states.balance.points.relative_speed[:, 0]),
            **stresses,
        }

    def _others(self, case: int) -> Iterator[Note]:
        """Other equilibria that are found."""
        state, rings = self.batch[case], self.rings[case]
        if self._rigid:
            found = several.between_rigid_raceways(self.models[case], state)
        else:
            found = several.between_flexible_raceways(state, rings)
        if found:
            yield found.note()


def _not_searched(case: int) -> Iterator[Note]:
    yield danger(
        several.CODE, "several equilibria are likely; others than the computed one were not searched"
    )


def on_half_spaces(case: Case) -> bool:
    """Whether half-spaces answer for the most loaded roller of a case."""
    return case.bearing.contact == "half_space"


def _numbers(output: Wanted, block: Mapping[str, NDArray]) -> Any:
    """Numbers of an output, from quantities of the block that it means."""
    return output.numbers({output.block or ANSWER[1]: block})


def _quantities(names: Iterable[Sequence[str]]) -> list[Quantity]:
    """Quantities by their names, each once."""
    return [QUANTITIES[name] for name in dict.fromkeys(chain.from_iterable(names))]


@cache
def _by_case(names: tuple[str, ...]) -> bool:
    """Whether some of these quantities are found case by case."""
    return any(QUANTITIES[name].source.startswith(BY_CASE) for name in names)


def datasets(output: Wanted) -> tuple[str, ...]:
    """Names of the quantities that an output is computed from."""
    declared = output.output.declared
    return tuple(dict.fromkeys([*declared.of, *([declared.speed] if declared.speed else [])]))
