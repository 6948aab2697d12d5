"""Solved roller cases as the rows of a table: everything that follows from their states."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexbearing.build.lubrication import roughness
from flexbearing.build.ring_parts import outer_mass
from flexbearing.case.roller import Case
from flexbearing.coupled.states import EndStates, flat
from flexbearing.coupling import LinearPair
from flexbearing.life.life_of_state import MREV, LifeOfState
from flexbearing.life.rated_bearing import RatedBearing
from flexbearing.life.roller_lives import LoadedState, edge_stress, modified, rated
from flexbearing.outputs import RequestedOutput
from flexbearing.outputs.names import BLOCKS
from flexbearing.progress import Logged, Report
from flexbearing.quantities.quantity import Quantity, row, taken
from flexbearing.quantities.roller import LAYOUT
from flexbearing.runs import half_space, probes, several, skew, subsurface
from flexbearing.runs.life_error import LifeErrors, estimated
from flexbearing.runs.several import SeveralEquilibria
from quasidynamic import Equilibrium, RollerBearing, SolverOutcome
from quasidynamic.contact.film import lambda_ratio, regime
from quasidynamic.note import Note
from quasidynamic.outcome.acting_forces import Losses
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.pressed_ends import sliced_peak_error
from quasidynamic.outcome.rating_life import effective_static_safety, static_safety
from quasidynamic.outcome.skew import Skew
from quasidynamic.outcome.worst_line_contact import WorstLineContact
from quasidynamic.several.indicator import each_several_likely

if TYPE_CHECKING:
    from fem.solid.probes import Readings
    from fem.squirrel_cage.bar_forces import NominalStresses
    from flexbearing.runs.part_fields import PartFields, Race
    from quasidynamic.outcome.subsurface import Subsurface
    from quasidynamic.outcome.whole_roller import WholeRoller

OF_SOLUTIONS = ("life", "skew", "whole", "bars", "subsurface", "probes")  # parts that no other state has
QUANTITIES = LAYOUT.datasets("block")


@dataclass(frozen=True)
class SolvedRows:
    """States of C cases between raceways of the same compliance, and what the cases add; cases first.

    Nothing is computed before it is requested. What is computed case by case is a list, with None where a
    case has none.
    """

    cases: Sequence[Case]
    models: Sequence[RollerBearing]
    states: BearingStates
    rings: Sequence[LinearPair]  # of each case; only their deviations without load differ
    report: Report = field(default_factory=Logged)  # is called with parts that are condensed for an error
    converged: bool = True  # whether the states are solutions
    doubtful: NDArray | None = None  # (C) whether several equilibria are likely; None where not asked yet

    @classmethod
    def of(cls, case: Case, model: RollerBearing, state: Equilibrium, rings: LinearPair) -> "SolvedRows":
        """The table of one solved case."""
        return cls([case], [model], state.cases, [rings])

    def __len__(self) -> int:
        return len(self.cases)

    def block(self, wanted: Iterable[Quantity] = QUANTITIES.values()) -> dict[str, NDArray]:
        """Quantities of all cases; without those that no case has."""
        wanted = list(wanted)
        words = {str(entry.path[0]) for entry in wanted}
        absent = () if self.converged else OF_SOLUTIONS
        return taken(wanted, {word: getattr(self, word) for word in words.difference(absent)})

    def numbers(self, outputs: Sequence[RequestedOutput]) -> list[NDArray]:
        """Numbers (C) of outputs of this block; NaN where a case does not have one."""
        names = dict.fromkeys(chain.from_iterable(map(_quantities, outputs)))
        block = self.block(QUANTITIES[name] for name in names)
        numbers = (output.numbers({output.block or BLOCKS[0]: block}) for output in outputs)
        return [each if np.shape(each) else np.full(len(self), each) for each in numbers]

    @cached_property
    def each(self) -> list[Equilibrium]:
        """The states one by one."""
        one = [self.states] if len(self) == 1 else [self.states.take(np.array([k])) for k in range(len(self))]
        return [Equilibrium.of(states, SolverOutcome.CONVERGED, 0) for states in one]

    # -- parts that hold quantities ------------------------------------------------------------

    @property
    def state(self) -> BearingStates:
        """The states themselves."""
        return self.states

    @property
    def rows(self) -> "SolvedRows":
        """These rows, for what follows from the cases."""
        return self

    @property
    def losses(self) -> Losses:
        """Power losses by cause."""
        return self.states.losses

    @cached_property
    def end(self) -> EndStates:
        """Stiffness with what carries the raceways."""
        return EndStates(self.states, self.rings[0])

    @property
    def whole(self) -> "list[WholeRoller | None]":
        """The most loaded rollers on half-spaces; None where slices answer."""
        return [roller for roller, _ in self._most_loaded]

    @property
    def notes_of_whole(self) -> list[tuple[Note, ...]]:
        """What must be said of them."""
        return [notes for _, notes in self._most_loaded]

    @cached_property
    def _most_loaded(self) -> "list[tuple[WholeRoller | None, tuple[Note, ...]]]":
        if not self.converged or all(case.bearing.contact != "half_space" for case in self.cases):
            return [(None, ())] * len(self)
        return [
            half_space.most_loaded(case, state) for case, state in zip(self.cases, self.each, strict=True)
        ]

    @cached_property
    def life(self) -> list[LifeOfState | None]:
        """Lives after every factor; None where nothing modifies them."""
        return [
            None if case.life.is_basic else modified(case, self._loaded(place))
            for place, case in enumerate(self.cases)
        ]

    def _loaded(self, place: int) -> LoadedState:
        states, whole, model = self.states, self.whole[place], self.models[place]
        loads = states.slice_loads[place] if whole is None else whole.slice_loads
        return LoadedState(
            bearing=model.bearing,
            basic=float(self.basic_life[place]) / MREV,
            loads=loads * (model.bearing.roller.length / loads.shape[-1]),
            turning=(states.turning[0][place], states.turning[1][place]),
            minimum_film=states.minimum_film[place],
        )

    @cached_property
    def skew(self) -> list[Skew | None]:
        """Skew of the rollers between flanges; None without."""
        if all(case.bearing.flange is None for case in self.cases):
            return [None] * len(self)
        return [skew.at(case, state) for case, state in zip(self.cases, self.each, strict=True)]

    @cached_property
    def bars(self) -> "NominalStresses | None":
        """Nominal stresses of the bars of squirrel cages; None without bars."""
        if not self.converged or self.rings[0].outer is None:
            return None
        return subsurface.nominal_stresses(self.cases[0], self.end)

    @property
    def bar_azimuths(self) -> NDArray | None:
        """Places of the bars (C, B) [rad]."""
        return None if self.bars is None else np.tile(self.bars.forces.azimuths, (len(self), 1))

    @cached_property
    def subsurface(self) -> "list[Subsurface | None]":
        """Stresses below the most pressed contacts; None where a case does not require them."""
        if not any(case.outputs.subsurface_stresses for case in self.cases):
            return [None] * len(self)
        bearings, worst = [model.bearing for model in self.models], self.worst
        contacts = (worst.pressure, worst.half_width, self._friction_of_worst)
        return [subsurface.of_rollers(*each) for each in zip(self.cases, bearings, *contacts, strict=True)]

    def fields(self, race: "Race") -> "PartFields":
        """Displacement and stress of a flexible part of the only case; raises `NoFields`."""
        from flexbearing.runs import fields

        if race not in self._fields:
            block = self.block(QUANTITIES[name] for name in ("roller_azimuth", f"{race}_slice_load"))
            self._fields[race] = fields.fields(self.cases[0], race, "flexible", row(block, 0))
        return self._fields[race]

    @cached_property
    def _fields(self) -> "dict[Race, PartFields]":
        return {}

    @property
    def probes(self) -> "list[Readings | None]":
        """What probes read; None where a case has none, or its fields are not known."""
        return [None if isinstance(each, str) else each for each in self._probes]

    @property
    def notes_of_probes(self) -> list[Note]:
        """Why there are no readings."""
        return [note for each in self._probes for note in probes.notes(each)]

    @cached_property
    def _probes(self) -> "list[Readings | str | None]":
        if self.rings[0].rigid or all(case.outputs.probes is None for case in self.cases):
            return [None] * len(self)
        if len(self) > 1:  # one by one, as the fields of a squirrel cage take much memory
            each = zip(self.cases, self.models, self.each, self.rings, strict=True)
            return [SolvedRows.of(*one)._probes[0] for one in each]
        self.report.stage("strains at the probes", None)
        return [probes.readings(self.cases[0], lambda race, there: self.fields(race).readings(there))]

    @property
    def _friction_of_worst(self) -> NDArray:
        """Traction on the raceway over the load (C, 2) [-] of the rollers that press most."""
        roller = self.slice_pressure.max(axis=3).argmax(axis=2)[..., None]
        load, traction = (
            np.take_along_axis(values, roller, axis=2)[..., 0]
            for values in (self.states.loads, self.states.traction)
        )
        return np.divide(-traction, load, out=np.zeros_like(load), where=load > 0)

    # -- what follows from the cases -----------------------------------------------------------

    @property
    def unknowns(self) -> NDArray:
        """Where neighbouring cases may start (C, N)."""
        return flat(self.states)

    @property
    def relative_speed(self) -> NDArray:
        """Speed of the inner ring less that of the outer ring (C) [rad/s]."""
        return self.states.balance.points.relative_speed[:, 0]

    @property
    def basic_life(self) -> NDArray:
        """Basic rating life (C) [rev]."""
        return self._with_whole(self.states.life, lambda whole: whole.life) * MREV

    @property
    def raceway_life(self) -> NDArray:
        """Basic rating life (C, 2) of each raceway on its own [rev]."""
        return self._with_whole(self.states.raceway_lives, lambda whole: whole.raceway_lives) * MREV

    @cached_property
    def life_errors(self) -> LifeErrors:
        """Estimated errors of the lives."""
        if not self.converged:
            return LifeErrors(None)
        return estimated(self.cases[0], self.states, self.rings[0], self.report)

    @property
    def life_error(self) -> NDArray | None:
        """Estimated error over the life (C) [-]; None where nothing was estimated."""
        return self.life_errors.values

    @cached_property
    def edge_stress(self) -> NDArray | None:
        """Factor on the load of slices (C, K) [-]; None where no case takes any."""
        if not any(case.life.edge_stress for case in self.cases):
            return None
        slices = self.states.slice_loads.shape[-1]
        each = [edge_stress(case, slices) for case in self.cases]
        return np.array([np.ones(slices) if factor is None else factor for factor in each])

    @cached_property
    def slice_pressure(self) -> NDArray:
        """Largest pressure (C, 2, Z, K) of each slice [Pa], which goes with the root of the load."""
        pressure = self._pressure_of_slices
        if any(self.whole):
            pressure = pressure.copy()
        for place, whole in enumerate(self.whole):
            if whole is not None:
                pressure[place, :, whole.number] = whole.slice_pressure
        return pressure

    @cached_property
    def _pressure_of_slices(self) -> NDArray:
        pressure = self.states.slice_pressure
        return pressure if self.edge_stress is None else pressure * np.sqrt(self.edge_stress)[:, None, None]

    @cached_property
    def peak_pressure(self) -> NDArray:
        """Largest pressure (C, 2) at the inner and outer raceway [Pa]."""
        return self._with_whole(self._sliced_peak, lambda whole: whole.peak_pressure)

    @property
    def bounded_pressure(self) -> NDArray:
        """The same (C, 2), but for one without bound, at a sharp end, which says nothing."""
        sliced = self.states.peak_pressure
        bounded = self.peak_pressure.copy()
        for place, whole in enumerate(self.whole):
            if whole is not None:
                bounded[place] = np.where(whole.peak_at_ends, sliced[place], bounded[place])
        return bounded

    @property
    def _sliced_peak(self) -> NDArray:
        if self.edge_stress is None:
            return self.states.peak_pressure
        return self._pressure_of_slices.max(axis=(2, 3))

    @cached_property
    def sliced_peak_error(self) -> NDArray:
        """Error of the peak pressure (C) of slices [-]; not a number where half-spaces have it."""
        sliced = np.array([case.bearing.contact == "slices" for case in self.cases])
        if not self.converged or not sliced.any():
            return np.full(len(self), np.nan)
        bearings = [model.bearing for model in self.models]
        return np.where(sliced, sliced_peak_error(self.states, bearings, self._sliced_peak), np.nan)

    @property
    def worst(self) -> WorstLineContact:
        """Most pressed contact of each raceway (C, 2)."""
        states = self.states
        return WorstLineContact.under(self.peak_pressure, states.contact_radius, states.contact_modulus)

    @cached_property
    def rated(self) -> list[RatedBearing]:
        """The bearings as the standards rate them."""
        return [rated(case, model.bearing) for case, model in zip(self.cases, self.models, strict=True)]

    @cached_property
    def static_safety(self) -> NDArray:
        """C_0/P_0 (C) of ISO 76 [-]."""
        ratings = np.array([each.static for each in self.rated])
        return static_safety(ratings, np.hypot(*self.states.applied_load.T))

    @property
    def effective_static_safety(self) -> NDArray:
        """Static safety (C) from the most loaded slice [-]."""
        bearings = [model.bearing for model in self.models]
        largest = self.states.slice_loads.max(axis=(1, 2, 3)) * [each.roller.length for each in bearings]
        elements = [each.rollers * each.row_count for each in bearings]
        return effective_static_safety([each.static for each in self.rated], largest, elements)

    @property
    def outer_mass(self) -> NDArray | None:
        """Masses (C) of what carries the outer raceway [kg]; None where one is not known."""
        masses = [outer_mass(case) for case in self.cases]
        return None if None in masses else np.array(masses, dtype=float)

    @cached_property
    def roughness(self) -> NDArray | None:
        """Composite roughness (C, 2) of both contacts [m]; None where no case has any."""
        rough = [roughness(case) for case in self.cases]
        if all(each is None for each in rough):
            return None
        return np.array([np.full(2, np.nan) if each is None else each for each in rough])

    @property
    def film_ratio(self) -> NDArray | None:
        """Film over roughness (C, 2, Z), 0 without load; None where the roughness is not known."""
        return None if self.roughness is None else self.states.loaded_film / self.roughness[..., None]

    @property
    def regimes(self) -> list[dict[str, str]]:
        """Lubrication regime of each case at both raceways; empty where their roughness is not known."""
        if self.roughness is None:
            return [{}] * len(self)
        return [
            dict(zip(("inner", "outer"), map(str, regime(lambda_ratio(film, rough))), strict=True))
            if np.isfinite(rough).all()
            else {}
            for film, rough in zip(self.states.minimum_film, self.roughness, strict=True)
        ]

    def _with_whole(self, values: NDArray, of: "Callable[[WholeRoller], NDArray | float]") -> NDArray:
        """Values (C, ...) of slices, with those of half-spaces where these answer for a roller."""
        if not any(self.whole):
            return values
        values = values.copy()
        for place, whole in enumerate(self.whole):
            if whole is not None:
                values[place] = of(whole)
        return values

    # -- other equilibria ----------------------------------------------------------------------

    @property
    def several_likely(self) -> NDArray:
        """Whether each case (C) may have several equilibria."""
        return each_several_likely(self.states) if self.doubtful is None else self.doubtful

    def other_equilibria(self, place: int) -> SeveralEquilibria | None:
        """Other equilibria of a case; None where nothing hints at them or none was found."""
        if not self.several_likely[place]:
            return None
        if self.rings[0].rigid:
            return several.between_rigid_raceways(self.models[place], self.each[place])
        return several.between_flexible_raceways(self.each[place], self.rings[place])


def _quantities(output: RequestedOutput) -> tuple[str, ...]:
    """Names of the quantities that an output is computed from."""
    declared = output.output.declared
    return (*declared.of, declared.speed) if declared.speed else declared.of
