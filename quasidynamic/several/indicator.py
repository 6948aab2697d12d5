"""Whether a bearing may have several equilibria, told from one of them without a further solve."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import INNER, OUTER
from quasidynamic.contact.line import EXPONENT
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.solve.rollers.static_equilibrium import film_at
from quasidynamic.solve.start import LumpedRollers

LOADED = 3e-4  # of the largest inner load
MARGIN = 0.3  # of the films of a rolling roller: how nearly its gap has to be filled, or left open
SLIPS = np.concatenate([np.geomspace(1e-5, 0.05, 16), np.linspace(0.08, 0.98, 12)])


def several_likely(state: Equilibrium) -> bool:
    """Whether an equilibrium may be one of several: an indicator, to be confirmed by solving.

    Parameters
    ----------
    state : Equilibrium
        a solved one, between rigid or elastic raceways

    Returns
    -------
    bool

    Valid
    -----
    Films: fires for nearly all random bearings with thick oil that have several, and for most of those that
    have one, see `benchmarks/several_equilibria.py`. Cage: falling traction curves, but not the last tenth of
    the loads between both folds.
    """
    return films_decide(state) or cage_balances_often(state)


def films_decide(state: Equilibrium) -> bool:
    """Whether some roller is loaded, or not, as its own film says; see `doubts`."""
    return bool((doubts(state) > -MARGIN).any())


@np.errstate(all="ignore")
def doubts(state: Equilibrium) -> NDArray:
    """How much films decide whether each roller is loaded (Z) [-]: not at all far below zero.

    A roller that enters the loaded zone either rolls, with films that fill its gap and load it, or stays
    slow, with films too thin to touch. The gap is that of the raceways around the roller without films. An
    unloaded roller would be loaded, at the place of the ring as it is, if it rolled and its films were
    larger than the gap; a loaded one would not if it stood still and they were smaller. The doubt is that
    difference over the films when it rolls.
    """
    balance, unknowns, raceways = state.balance, state.unknowns, state.balance.roller.raceways
    outward = state.loads[OUTER] - state.loads[INNER]  # what presses a roller on one raceway alone
    load = np.maximum([-outward, outward], 0.0)[:, None]
    pressed = (raceways.softness[:, None, None] * load ** (1 / EXPONENT)).sum(0) + 2 * raceways.drop.min()
    gap = pressed - balance.inputs(unknowns).approach[:, 0].sum(0) + unknowns.film.sum(0)
    rolling, standing = (
        film_at(balance, unknowns._replace(spin_drift=drift), load).sum(0)
        for drift in (0 * unknowns.spin_drift, 0 * unknowns.spin_drift - balance.rolling_spin)
    )
    return (np.where(is_loaded(state), gap - standing, rolling - gap) / rolling)[0]


@np.errstate(all="ignore")
def cage_balances_often(state: Equilibrium) -> bool:
    """Whether the cage is in balance at several slips, the loads of the rollers kept.

    Each loaded roller slides on the raceway that grips it less and rolls on the other: its two tractions are
    then alike, and that of the weaker raceway drives the cage.
    """
    lumped = LumpedRollers(rigid_balance(state).take(np.zeros(len(SLIPS), int)))
    balance, bearing = lumped.balance, lumped.balance.roller.bearing
    length, loads = balance.roller.raceways.slices.length, state.loads[:, is_loaded(state)]
    cage_drift = -SLIPS[:, None] * balance.rolling_cage
    per_spin = cage_drift / (bearing.roller.diameter / 2)
    on_outer, on_inner = (
        lumped.surfaces(cage_drift, drift)[:2]
        for drift in (per_spin * bearing.outer_radius, -per_spin * bearing.inner_radius)
    )
    sliding, entrainment = (
        np.array([a[INNER], b[OUTER]]) for a, b in zip(on_outer, on_inner, strict=True)
    )  # each raceway as if all the sliding were there
    load = np.broadcast_to(loads[:, None], (2, len(SLIPS), loads.shape[1]))
    film = balance.roller.raceways.film(load, sliding, entrainment).thickness
    pull = balance.roller.raceways.traction(load / length, sliding, entrainment, film).force * length
    weaker = np.abs(pull).min(0) * np.sign(balance.rolling_cage)
    drives = lumped.driving_torque(np.array([weaker, weaker, 0 * weaker, 0 * weaker]), cage_drift) > 0
    return int((drives[1:] != drives[:-1]).sum()) > 1


def is_loaded(state: Equilibrium) -> NDArray:
    """Which rollers (Z) the inner ring loads."""
    inner = state.loads[INNER]
    return inner > LOADED * inner.max()


def rigid_balance(state: Equilibrium) -> BearingBalance:
    """Equations of a state, its raceways kept in the shape that they have there."""
    balance = state.balance
    if not balance.layout.elastic_raceways:
        return balance
    return replace(balance, compliance=(None, None), deviation=state.deviation)
