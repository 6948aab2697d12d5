"""Derivatives of unknowns and outputs of a roller bearing: residuals of all variants, one solve, outputs."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from flexbearing.derivatives.keys import Key
from flexbearing.derivatives.roller_state import SolvedState, Variant
from flexbearing.derivatives.sides import Stencil
from flexbearing.outputs import RequestedOutput
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.roller import side_by_side_batches
from quasidynamic.solve.rollers.parametric_balance import (
    between,
    moved_unknowns,
    nearest_switch,
    residuals,
    slice_approaches,
)

AT_ONCE = 64  # variants whose slices fit into the processor's cache


@dataclass(frozen=True)
class Difference:
    """A key with the variants that its differences are taken of."""

    key: Key
    stencil: Stencil
    variants: tuple[Variant, ...]  # of the places of the stencil

    @property
    def aligned(self) -> bool:
        """Whether no roller tilts in any of them."""
        return all(variant.aligned for variant in self.variants)


@dataclass(frozen=True)
class OutputSlopes:
    """Values (O) of outputs, and slopes (O, K) of them in SI of the keys."""

    values: NDArray
    slopes: NDArray
    below: NDArray  # one-sided differences, of first order; NaN where the stencil has none there
    above: NDArray
    nearest_switch: NDArray  # (K) smallest change of the key that opens or closes a contact, in its steps


@dataclass(frozen=True)
class _Group:
    """Variants that one balance stands for."""

    places: NDArray  # (C) among all variants
    balance: BearingBalance


@dataclass(frozen=True)
class RollerSlopes:
    """Derivatives at an equilibrium by some keys whose rollers all tilt, or none."""

    state: SolvedState
    differences: Sequence[Difference]

    @cached_property
    def _variants(self) -> list[Variant]:
        """Variants (V) of all keys, then the state's own case."""
        return [*(variant for each in self.differences for variant in each.variants), self.state.base]

    @cached_property
    def _key(self) -> NDArray:
        """Which key (V) each variant of a key belongs to."""
        return np.repeat(np.arange(len(self.differences)), [len(each.variants) for each in self.differences])

    @cached_property
    def _place(self) -> NDArray:
        """Steps (V) that each variant of a key is away."""
        return np.concatenate([each.stencil.places for each in self.differences])

    @cached_property
    def _weight(self) -> NDArray:
        return np.concatenate([each.stencil.weights for each in self.differences])

    @cached_property
    def _aligned(self) -> bool:
        return all(each.aligned for each in self.differences)

    @cached_property
    def _groups(self) -> list[_Group]:
        return list(self._grouped())

    def _grouped(self) -> Iterator[_Group]:
        """Variants side by side where raceways answer alike, others by themselves."""
        alike = np.array([self._same_raceways(variant) for variant in self._variants])
        places = np.flatnonzero(alike)
        models = [self._variants[place].model for place in places]
        for some, together in side_by_side_batches(models, AT_ONCE, tilting_apart=False):
            balance = together.balance(len(some), aligned=self._aligned)
            if not self.state.base.pair.rigid:
                deviations = [self._variants[place].pair.initial_deviation for place in places[some]]
                balance = between(balance, self._compliance, _stacked(deviations))
            yield _Group(places[some], balance)
        for place in np.flatnonzero(~alike):
            yield _Group(np.array([place]), self._variants[place].balance(aligned=self._aligned))

    def _same_raceways(self, variant: Variant) -> bool:
        """Whether compliance and translation are those of the state: rollers elsewhere have another one."""
        both = zip(variant.pair.raceways, self.state.base.pair.raceways, strict=True)
        flexible = [(one, other) for one, other in both if one is not None and other is not None]
        return all(
            one.absolute is other.absolute
            or (
                np.array_equal(one.absolute, other.absolute)
                and np.array_equal(one.translation, other.translation)
            )
            for one, other in flexible
        )

    @cached_property
    def _compliance(self) -> tuple[NDArray | None, NDArray | None]:
        return self.state.base.pair.compliance

    @cached_property
    def by_step(self) -> NDArray:
        """Change (N, K) of the unknowns, in SI, by a step of each key."""
        balance = self._base
        residual = np.empty((len(self._variants), balance.layout.size))
        for group in self._groups:
            residual[group.places] = residuals(group.balance, self.state.unknowns)
        return moved_unknowns(balance, self._here.system, self._slopes(residual).T)

    def outputs(self, outputs: Sequence[RequestedOutput]) -> OutputSlopes:
        """Derivatives of outputs, by differences along the keys and the unknowns together."""
        unknowns = (self._here.scaled * self._base.scales.unknown).repeat(len(self._variants), axis=0)
        unknowns[:-1] += self.by_step[:, self._key].T * self._place[:, None]
        values = np.empty((len(self._variants), len(outputs)))
        gaps = slice_approaches(self._base, self._here.scaled).reshape(-1)
        approach = np.empty((len(self._variants), len(gaps)))
        for group in self._groups:
            scaled = unknowns[group.places] / group.balance.scales.unknown
            values[group.places] = self._numbers(group, scaled, outputs)
            approach[group.places] = slice_approaches(group.balance, scaled).reshape(len(scaled), -1)
        below, above = self._sides(values)
        switch = nearest_switch(gaps, self._slopes(approach))
        return OutputSlopes(values[-1], self._slopes(values).T, below.T, above.T, switch)

    @cached_property
    def _base(self) -> BearingBalance:
        return self.state.base.balance(aligned=self._aligned)

    def _numbers(self, group: _Group, scaled: NDArray, outputs: Sequence[RequestedOutput]) -> NDArray:
        variants = [self._variants[place] for place in group.places]
        states = BearingStates(group.balance, scaled, self.state.base.model.axial_modes, self._here)
        return _numbers(variants, states, outputs)

    @cached_property
    def _here(self) -> BearingStates:
        """The state itself, whose tangent is that of the variants to first order."""
        return _state_of(self.state, self._base)

    def _slopes(self, values: NDArray) -> NDArray:
        """Derivatives (K, ...) by a step of each key, from values (V + 1, ...) of all variants."""
        slopes = np.zeros((len(self.differences), *values.shape[1:]))
        np.add.at(slopes, self._key, self._weight[:, None] * values[:-1])
        return slopes

    def _sides(self, values: NDArray) -> tuple[NDArray, NDArray]:
        """Differences (K, O) by a step, on the side of smaller keys and on that of larger ones."""
        sides = np.full((2, len(self.differences), values.shape[1]), np.nan)
        for side, place in enumerate((-1.0, 1.0)):
            at = np.flatnonzero(self._place == place)
            sides[side, self._key[at]] = place * (values[at] - values[-1])
        return sides[0], sides[1]


def numbers(state: SolvedState, outputs: Sequence[RequestedOutput], *, aligned: bool) -> NDArray:
    """Numbers (O) of outputs of a state."""
    return _numbers([state.base], _state_of(state, state.base.balance(aligned=aligned)), outputs)[0]


def _state_of(state: SolvedState, balance: BearingBalance) -> BearingStates:
    scaled = balance.layout.joined(state.unknowns) / balance.scales.unknown
    return BearingStates(balance, scaled, state.base.model.axial_modes)


def _numbers(
    variants: Sequence[Variant], states: BearingStates, outputs: Sequence[RequestedOutput]
) -> NDArray:
    """Numbers (C, O) of outputs of states."""
    cases, models, pairs = ([getattr(each, name) for each in variants] for name in ("case", "model", "pair"))
    return np.array(SolvedRows(cases, models, states, pairs).numbers(outputs), float).T


def _stacked(deviations: Sequence[NDArray | None]) -> NDArray | None:
    """Shapes (C, 2, Z, M) of raceways without load, zero where there is none; None where there are none."""
    known = [each for each in deviations if each is not None]
    if not known:
        return None
    return np.array([np.zeros_like(known[0]) if each is None else each for each in deviations])
