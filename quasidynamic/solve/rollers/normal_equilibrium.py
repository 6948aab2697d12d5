"""Ring and rollers of one case where normal forces balance, with the friction that they have."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.rigid_rings import Stations
from quasidynamic.balance.rollers.unknowns import TILT_Y, TILT_Z, Unknowns, Y, Z
from quasidynamic.solve.rollers.pressed_rollers import ContactWork, FilmOf, PressedRollers, PressedState

RIGID_MODES = 2  # in which rollers approach rigid raceways: shift and tilt
SWEEPS = 3  # of normal forces by friction, and of friction by normal forces
SMALL_MOVE = 1e-3  # lengths of the ring, in the last sweep
RING_STEPS = 25  # rarely more than ten
RING_DIGITS = 1e-7  # of the largest force: unbalanced force on the ring
HALVINGS = 12  # of a step of the ring
LONGEST_RING_STEP = 100.0  # lengths of the scales: 2 % of a roller's diameter
STIFFENING = 1e-2  # of the whole stiffness over the relative imbalance, where no roller resists a direction
ENDLESS = ContactWork()
LEAST_STIFFENING = 1e-6  # of the largest force over a length, where no roller touches at all


def normal_equilibrium(balance: BearingBalance, scaled: NDArray, work: ContactWork = ENDLESS) -> NDArray:
    """Move ring, rollers and films where normal forces balance; cage and spins stay.

    The energy of the contacts is convex, and its lowest place is found from anywhere: also where a linear
    step would send rollers through the bearing, such as with films far thicker than the approaches or a ring
    that friction pushes to the next roller. Friction follows in a few sweeps. Between rigid, even raceways.

    Raises `OutOfWork` where they do not suffice.
    """
    for _ in range(SWEEPS):
        system, unknowns = balance.evaluate(scaled), balance.unpack(scaled)
        unbalanced = (system.residual * balance.scales.residual)[0]
        force = system.state.contact.force[:, :RIGID_MODES, 0]
        rollers, free = _pressed(balance, unknowns, force, unbalanced, work)
        before = _place(balance, unknowns)
        outer = np.array([unknowns.approach[0] - unknowns.film[1, 0], unknowns.tilt[0]])
        state = _ring_at_rest(rollers, rollers.at(before, outer[: force.shape[1]]), free)
        scaled = balance.pack(_moved(balance, unknowns, state))
        if np.abs(state.place - before).max() < SMALL_MOVE * rollers.length:
            break
    return scaled


def _pressed(
    balance: BearingBalance, unknowns: Unknowns, force: NDArray, unbalanced: NDArray, work: ContactWork
) -> tuple[PressedRollers, NDArray]:
    """Rollers under the forces (N) that are not of the contacts, and where the ring is free to go (2, M)."""
    raceways, azimuths = balance.roller.raceways, balance.roller.bearing.azimuths
    normal = np.array([np.sin(azimuths), np.cos(azimuths)]).T
    stations = Stations.of(balance.roller.bearing, balance.kinematics.half_length)
    free, load = np.ones((2, force.shape[1])), normal.T @ stations.about_middle(force[0].T)
    load[:, 0] += unbalanced[[Y, Z]]
    if force.shape[1] > 1:
        free[:, 1] = balance.points.free_tilt[0, 0]
        load[:, 1] += unbalanced[[TILT_Y, TILT_Z]] / balance.kinematics.half_length
    film_of = work.counted(_films(balance, unknowns))
    return PressedRollers(
        law=type(raceways.law)(np.reshape(raceways.law.coefficient, (-1, 1)), raceways.law.rounding),
        slices=raceways.slices.with_axial_modes(force.shape[1]),
        drop=raceways.drop[:, :, 0],
        normal=normal,
        film_of=film_of,
        thickest=film_of(np.zeros(force[:, 0].shape), np.arange(force.shape[-1]))[0],
        outward=unbalanced[balance.layout.field(0)] - force[0, 0] + force[1, 0],
        gap=balance.roller.bearing.clearances / 2,
        load=load * free,
        length=float(balance.scales.length),
        stations=stations,
    ), free


def _films(balance: BearingBalance, unknowns: Unknowns) -> FilmOf:
    """Films at the speeds of the unknowns by load; those of starved inlets, which may grow with it, stay."""
    raceways, motion = balance.roller.raceways, balance.motion(unknowns.cage_drift, unknowns.spin_drift)
    sliding, entrainment, _ = balance.roller.surfaces(motion, balance.points)
    if balance.roller.lubrication.inlet_length is not None:
        film = unknowns.film[:, 0]
        return lambda load, rollers: (film[:, rollers], np.zeros(load.shape))

    def film_of(load: NDArray, rollers: NDArray) -> tuple[NDArray, NDArray]:
        film = raceways.film(load[:, None], sliding[..., rollers], entrainment[..., rollers])
        return film.thickness[:, 0], film.by_line_load[:, 0]

    return film_of


def _place(balance: BearingBalance, unknowns: Unknowns) -> NDArray:
    """Place of the ring (2, M) [m]; one that may not tilt freely at its slope."""
    ring, points = unknowns.ring[:, 0, 0], balance.points
    place = ring[[[Y, TILT_Y], [Z, TILT_Z]]]
    if not points.free_tilt[0, 0]:
        place[:, 1] = points.slope_y[0, 0], points.slope_z[0, 0]
    place[:, 1] *= balance.kinematics.half_length
    return place[:, : min(balance.roller.axial_modes, RIGID_MODES)]


def _moved(balance: BearingBalance, unknowns: Unknowns, state: PressedState) -> Unknowns:
    ring, film = unknowns.ring.copy(), state.contacts.film[:, None]
    ring[[Y, Z], 0, 0] = state.place[:, 0]
    moved = unknowns._replace(ring=ring, approach=state.outer[:1] + film[1], film=film)
    if len(state.outer) > 1:
        ring[[TILT_Y, TILT_Z], 0, 0] = state.place[:, 1] / balance.kinematics.half_length
        moved = moved._replace(tilt=state.outer[1:2])
    if balance.roller.lubrication.inlet_length is None:
        return moved
    motion = balance.motion(moved.cage_drift, moved.spin_drift)
    sliding, entrainment, _ = balance.roller.surfaces(motion, balance.points)
    load = state.contacts.force[:, 0, None]
    return moved._replace(film=balance.roller.raceways.film(load, sliding, entrainment).thickness)


def _ring_at_rest(rollers: PressedRollers, state: PressedState, free: NDArray) -> PressedState:
    """Newton's method on the place of the ring, halved where a step runs far past the lowest energy."""
    size, n, held = rollers.length, free.size, np.diag(1 - free.ravel())
    for _ in range(RING_STEPS):
        excess = state.excess * free
        largest = max(np.abs(rollers.load).max(), state.contacts.force[0, 0].max())
        imbalance = np.abs(excess).max() / largest
        if not imbalance > RING_DIGITS:  # also not a number
            break
        matrix = state.stiffness.reshape(n, n) * np.outer(free, free)
        stiffer = STIFFENING * min(imbalance, 1.0) * matrix.trace() + LEAST_STIFFENING * largest / size
        step = np.linalg.solve(matrix + stiffer * np.eye(n) + matrix.trace() * held, excess.ravel())
        step = step.reshape(free.shape) / max(np.abs(step).max() / (LONGEST_RING_STEP * size), 1.0)
        uphill, part = -0.5 * float((excess * step).sum()), 1.0
        for _ in range(HALVINGS):
            trial = rollers.at(state.place + part * step, state.outer, state.contacts)
            if float((trial.excess * step).sum()) >= uphill:
                break
            part /= 2
        state = trial
    return state
