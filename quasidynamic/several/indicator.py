"""Whether bearings may have several equilibria, judged by one of them without a further solve."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import INNER, OUTER
from quasidynamic.contact.line import EXPONENT
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.solve.rollers.static_equilibrium import film_at
from quasidynamic.solve.start import LumpedRollers

LOADED = 3e-4  # of the largest inner load
MARGIN = 0.3  # of the films of a rolling roller: how nearly its gap has to be filled, or left open
SLIPS = np.concatenate([np.geomspace(1e-5, 0.05, 16), np.linspace(0.08, 0.98, 12)])


def several_likely(state: Equilibrium) -> bool:
    """Whether an equilibrium may be one of several; see `each_several_likely`."""
    return bool(each_several_likely(state.cases)[0])


def each_several_likely(states: BearingStates) -> NDArray:
    """Whether each equilibrium may be one of several: an indicator, to be confirmed by solving.

    Valid
    -----
    Films: fires for nearly all random bearings with thick oil that have several, and for most of those that
    have one, see `benchmarks/several_equilibria.py`. Cage: falling traction curves, but not the last tenth of
    the loads between both folds.
    """
    return films_decide(states) | cage_balances_often(states)


def films_decide(states: BearingStates) -> NDArray:
    """Whether some roller is loaded, or not, as its own film says (C); see `doubts`."""
    return np.logical_or.reduce(doubts(states) > -MARGIN, axis=-1)


@np.errstate(all="ignore")
def doubts(states: BearingStates) -> NDArray:
    """How much films decide whether each roller is loaded (C, Z) [-]: not at all far below zero.

    A roller that enters the loaded zone either rolls, with films that fill its gap and load it, or stays
    slow, with films too thin to touch. The gap is that of the raceways around the roller without films. An
    unloaded roller would be loaded, at the place of the ring as it is, if it rolled and its films were
    larger than the gap; a loaded one would not if it were at rest and they were smaller. The doubt is that
    difference over the films when it rolls.
    """
    balance, unknowns, raceways = states.balance, states.unknowns, states.balance.roller.raceways
    outward = states.loads[:, OUTER] - states.loads[:, INNER]  # presses a roller on one raceway alone
    load = np.maximum([-outward, outward], 0.0)
    pressed = (raceways.softness * load ** (1 / EXPONENT)).sum(0) + raceways.drop.min(0).sum(0)
    gap = pressed - balance.approach(unknowns)[:, 0].sum(0) + unknowns.film.sum(0)
    rolling, standing = (
        film_at(balance, unknowns._replace(spin_drift=drift), load).sum(0)
        for drift in (0 * unknowns.spin_drift, 0 * unknowns.spin_drift - balance.rolling_spin)
    )
    return np.where(is_loaded(states), gap - standing, rolling - gap) / rolling


@np.errstate(all="ignore")
def cage_balances_often(states: BearingStates) -> NDArray:
    """Whether the cage is in balance at several slips (C), the loads of the rollers kept.

    Each loaded roller slides on the raceway that grips it less and rolls on the other: its two tractions are
    then alike, and that of the weaker raceway drives the cage.
    """
    cases, tried = len(states.scaled), len(SLIPS)
    lumped = LumpedRollers(states.balance.take(np.arange(cases).repeat(tried)))
    balance, bearing = lumped.balance, lumped.balance.roller.bearing
    cage_drift = -np.tile(SLIPS, cases)[:, None] * balance.rolling_cage
    per_spin = cage_drift / (bearing.roller.diameter / 2)
    on_outer, on_inner = (
        lumped.surfaces(cage_drift, drift)[:2]
        for drift in (per_spin * bearing.outer_radius, -per_spin * bearing.inner_radius)
    )
    sliding, entrainment = (
        np.array([a[INNER], b[OUTER]]) for a, b in zip(on_outer, on_inner, strict=True)
    )  # each raceway as if all the sliding were there
    load = _loads_of_loaded_rollers(states).repeat(tried, axis=1)
    film = balance.roller.raceways.film(load, sliding, entrainment).thickness
    length = balance.roller.raceways.slices.length
    pull = balance.roller.raceways.traction(load / length, sliding, entrainment, film).force * length
    weaker = np.where(load[INNER] > 0, np.abs(pull).min(0), 0.0) * np.sign(balance.rolling_cage)
    drives = lumped.driving_torque(np.array([weaker, weaker, 0 * weaker, 0 * weaker]), cage_drift) > 0
    drives = drives.reshape(cases, tried)
    return (drives[:, 1:] != drives[:, :-1]).sum(axis=1) > 1


def _loads_of_loaded_rollers(states: BearingStates) -> NDArray:
    """Loads (2, C, n) [N] of the rollers that the inner ring loads, as many as the fullest case has."""
    loaded, loads = is_loaded(states), states.loads.swapaxes(0, 1)
    first = np.argsort(~loaded, axis=1, kind="stable")[:, : loaded.sum(axis=1).max()]
    return np.take_along_axis(np.where(loaded, loads, 0.0), first[None], axis=2)


def is_loaded(states: BearingStates) -> NDArray:
    """Which rollers (C, Z) the inner ring loads."""
    inner = states.loads[:, INNER]
    return inner > LOADED * inner.max(axis=-1, keepdims=True)


def rigid_balance(state: Equilibrium) -> BearingBalance:
    """Equations of a state, its raceways kept in the shape that they have there."""
    balance = state.balance
    if not balance.layout.elastic_raceways:
        return balance
    return replace(balance, compliance=(None, None), deviation=state.deviation)
