"""Static equilibrium of every roller between its raceways, the ring held, without friction."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.rigid_rings import RigidRings, RigidRingState
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.contact.line import EXPONENT
from quasidynamic.contact.raceways import Raceways
from quasidynamic.errors import NotSolved
from quasidynamic.solve.step_length import before_the_minimum

LYING_STEPS, LYING = 60, 1e-6  # on the inner raceway by its weight: steps, and what is left of it
MAX_STEPS = 8  # Newton on a nearly linear law inside a bracket
NEAR_ENOUGH = 1e-2  # lengths of the scales, of the last step; what is left after it is far less
TOLERANCE = 1e-11  # of the largest force: unbalanced force on the ring
STEPS = 60  # rarely more than ten: the energy is convex
STIFFENING = 1e-2  # of the whole stiffness over the relative imbalance, where no roller resists a direction


def outward_force(balance: BearingBalance, unknowns: Unknowns) -> NDArray:
    """What presses an unloaded roller outwards (C, Z) [N]; negative where it rests on the inner raceway.

    Centrifugal force, weight, and the friction of the pocket that carries weight and drag along the motion.
    """
    motion, roller = balance.motion(unknowns.cage_drift, unknowns.spin_drift), balance.roller
    (centrifugal, _), (drag, _) = roller.centrifugal(motion.cage_speed), roller.drag(motion.cage_speed)
    outward, along = balance.weight
    lift = roller.bearing.cage.pocket_friction * motion.spin / np.hypot(motion.spin, motion.standstill_spin)
    return centrifugal + outward + lift * (drag - along)


def frictionless_loads(balance: BearingBalance, unknowns: Unknowns, uneven: bool = False) -> NDArray:
    """Loads (2, C, Z) [N] of rollers, untilted on even raceways or, if `uneven`, as they are."""
    approach = balance.approach(unknowns)
    beyond = axial_variation(balance, approach) if uneven else 0.0
    return _contact_loads(balance, approach[:, 0], beyond)[0]


def slice_loads(balance: BearingBalance, unknowns: Unknowns, uneven: bool = False) -> NDArray:
    """Loads per length (K, 2, C, Z) [N/m] of rollers, as `frictionless_loads` has them."""
    raceways, approach = balance.roller.raceways, balance.approach(unknowns)
    beyond = axial_variation(balance, approach) if uneven else 0.0
    return raceways.law(approach[:, 0] + beyond - raceways.drop)[0]


def series_stiffness(balance: BearingBalance, unknowns: Unknowns) -> NDArray:
    """Stiffness (C, Z) [N/m] of both raceways of an untilted roller in series."""
    inner, outer = _contact_loads(balance, balance.approach(unknowns)[:, 0])[1]
    return inner * outer / (inner + outer)


def _contact_loads(
    balance: BearingBalance, approach: NDArray, beyond: NDArray | float = 0.0
) -> tuple[NDArray, NDArray]:
    """Loads [N] and stiffnesses [N/m] (2, C, Z) of rollers at their approaches (2, C, Z) [m].

    Slices are closer by `beyond` (K, 2, C, Z) [m]; rollers without it are untilted.
    """
    raceways = balance.roller.raceways
    line_load, slope = raceways.law(approach + beyond - raceways.drop)
    return raceways.slices.total(line_load), raceways.slices.total(slope)


def static_equilibrium(
    balance: BearingBalance, unknowns: Unknowns, uneven: bool = False, outward: NDArray | None = None
) -> Unknowns:
    """Unknowns with every roller in static equilibrium between its raceways, without friction.

    A step that linearises contact may move a roller off its outer raceway, where the load law has no
    slope that leads back; this puts it on again. Rollers are untilted on even raceways, or, if
    `uneven`, tilted as they are on raceways of the shape that they have. What presses them outwards
    (C, Z) [N] is that of `outward_force`, unless it is known.
    """
    approach = balance.approach(unknowns)
    beyond = axial_variation(balance, approach) if uneven else np.zeros((1, 2, 1, 1))
    room = approach[:, 0].sum(0)  # both of them, wherever the roller is
    raceways, force = (
        balance.roller.raceways,
        outward_force(balance, unknowns) if outward is None else outward,
    )
    falls, size = force < 0, np.abs(force)  # on the inner raceway
    pressed = np.where(falls, *raceways.softness) * size ** (1 / EXPONENT)  # of a straight roller
    nearest = np.where(falls, *(raceways.drop[:, race] - beyond[:, race] for race in (0, 1)))
    lowest, highest = pressed + nearest.min(0), np.maximum(room, pressed + nearest.max(0))
    side = np.maximum(room / 2, lowest)  # approach at the raceway that the roller rests on
    running = np.ones((len(side), 1), bool)  # each case stops by itself
    for _ in range(MAX_STEPS):
        outer = np.where(falls, room - side, side)
        (load_i, load_o), slopes = _contact_loads(balance, np.array([room - outer, outer]), beyond)
        change = (np.where(falls, load_i - load_o, load_o - load_i) - size) / slopes.sum(0)
        side = np.where(running, np.minimum(np.maximum(side - change, lowest), highest), side)
        near = np.abs(change) < NEAR_ENOUGH * balance.scales.length
        running &= ~near.all(axis=1, keepdims=True)
        if not running.any():
            break
    return unknowns._replace(approach=np.where(falls, room - side, side))


def room_between_raceways(balance: BearingBalance, approach: NDArray) -> NDArray:
    """Sum of both approaches (C, Z) [m] of the nearest slice; negative where a roller cannot be pressed."""
    raceways = balance.roller.raceways
    both = np.einsum("km,mcz->kcz", raceways.slices.modes, approach.sum(0))
    return (both - raceways.drop.sum(1)).max(0)


def tilts_between_raceways(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Limit the tilt of every roller to those of its two raceways.

    Hardly any moment holds the tilt of a roller without load: a linearised step may tilt it by any amount,
    but it cannot rest where its moments at both raceways have one sense.
    """
    if balance.roller.axial_modes == 1 or balance.layout.ribs:  # whose couples tilt rollers beyond
        return unknowns
    approach = balance.approach(unknowns)
    whole = approach[0, 1] + approach[1, 1]
    slack = 3 * np.abs(approach[:, 3::2]).sum((0, 1))
    low, high = np.minimum(whole, 0.0) - slack, np.maximum(whole, 0.0) + slack
    return unknowns._replace(tilt=np.clip(unknowns.tilt, low, high))


def lying_on_a_raceway(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Unknowns with every roller of a slow bearing that cannot be pressed at rest on one raceway.

    Its small weight alone holds its tilt: a linearised step lays it on one end, the next one on the other, in
    turns. Load and moment follow from a convex energy: Newton's method from where it lies flat, its steps
    halved until both are closer to balance. Where no roller falls on the inner raceway, centrifugal force
    holds the tilts, and nothing is done.
    """
    force = outward_force(balance, unknowns)
    slow = ~(force.min(axis=1, keepdims=True) > 0)
    if balance.roller.axial_modes == 1 or balance.layout.ribs or not slow.any():
        return unknowns
    approach = balance.approach(unknowns)
    loose = room_between_raceways(balance, approach) < 0
    after = unknowns._replace(approach=unknowns.approach.copy(), tilt=unknowns.tilt.copy())
    for race, outward in enumerate((-1.0, 1.0)):
        lying = slow & loose & (outward * force > 0)
        if lying.any():
            raceways = balance.take(np.nonzero(lying)[0]).roller.raceways  # a case for each of the rollers
            here = approach[race][:, lying, None]
            change = outward * (_rest(raceways, race, here, np.abs(force[lying])[:, None]) - here)
            after.approach[lying] += change[0, :, 0]
            after.tilt[lying] += change[1, :, 0]
    return after


def _rest(raceways: Raceways, race: int, approach: NDArray, force: NDArray) -> NDArray:
    """Approaches (M, C, 1) [m] at which a raceway carries forces (C, 1) [N] without a moment."""
    law = replace(raceways.law, coefficient=np.asarray(raceways.law.coefficient)[race])
    pressed = raceways.softness[race] * force ** (1 / EXPONENT)  # of a straight roller
    slices, drop = raceways.slices, raceways.drop[:, race]

    def unbalanced(place: NDArray) -> tuple[NDArray, NDArray]:
        load, slope = law(slices.spread(place) - drop)
        return slices.summed(load)[:2] - [force, 0 * force], slices.paired(slope)[:2, :2]

    place = approach.copy()
    place[:2] = 0.0
    place[0] = pressed - (slices.spread(place) - drop).max(0)
    wrong, stiffness = unbalanced(place)
    length = np.ones_like(force)
    for _ in range(LYING_STEPS):
        side = -wrong.transpose(1, 2, 0)[..., None]
        change = np.linalg.solve(stiffness.transpose(2, 3, 0, 1), side)[..., 0].transpose(2, 0, 1)
        trial = place.copy()
        trial[:2] += length * change
        there, by = unbalanced(trial)
        better = (there**2).sum(0) < (wrong**2).sum(0)
        place, wrong = np.where(better, trial, place), np.where(better, there, wrong)
        stiffness, length = np.where(better, by, stiffness), np.where(better, 1.0, length / 2)
        if (np.abs(wrong) < LYING * force).all():
            break
    return place


def axial_variation(balance: BearingBalance, approach: NDArray) -> NDArray:
    """Approaches (K, 2, C, Z) [m] of the slices beyond mid-roller, by higher modes (2, M, C, Z)."""
    higher = balance.roller.raceways.slices.modes[:, 1:]
    return np.einsum("km,rmcz->krcz", higher, approach[:, 1:])


def film_at(balance: BearingBalance, unknowns: Unknowns, load: NDArray) -> NDArray:
    """Films (2, C, Z) [m] at the speeds of the unknowns and roller loads [N] that broadcast to them."""
    motion = balance.motion(unknowns.cage_drift, unknowns.spin_drift)
    sliding, entrainment, _ = balance.roller.surfaces(motion, balance.points)
    return balance.roller.raceways.film(load, sliding, entrainment).thickness


def balanced(rings: RigidRings) -> tuple[RigidRingState, int]:
    """State in which the rollers carry the load, and the number of evaluations.

    A direction in which hardly anything resists, such as sideways on a single roller, is stiffened
    as long as forces are out of balance; close to balance the step is that of Newton.

    Raises `NotSolved` when the iteration limit is reached.
    """
    state, evaluations, n = rings.at(rings.first_place()), 1, rings.load.size
    for _ in range(STEPS):
        imbalance = rings.imbalance(state)
        if imbalance < TOLERANCE:
            return state, evaluations
        matrix = state.stiffness.reshape(n, n)
        stiffer = STIFFENING * min(imbalance, 1.0) * matrix.trace()
        step = np.linalg.solve(matrix + stiffer * np.eye(n), state.excess.ravel())
        state, trials = before_the_minimum(rings.at, state, step.reshape(state.excess.shape))
        evaluations += trials
    raise NotSolved(
        f"the ring found no static balance in {STEPS} steps: {imbalance:.1e} of the largest force is left; "
        f"load {np.hypot(*rings.load[:, 0]):.4g} N, {len(rings.normal)} rollers",
        "iteration limit",
    )
