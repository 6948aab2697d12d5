"""Random bearings with cold or thick oil, and every equilibrium that many random starts lead to."""

from dataclasses import replace
from functools import cache

import numpy as np

from quasidynamic import (
    Lubrication,
    Operation,
    RollerBearing,
    SolverOutcome,
    oil_at,
)
from quasidynamic.outcome.capacity import static_rating
from quasidynamic.parts.oil_curves import two_point_oil
from quasidynamic.solve.rollers.pseudo_time import growth_rates
from quasidynamic.solve.rollers.static_equilibrium import film_at, frictionless_loads
from quasidynamic.solve.rollers.strategy import solve_each
from quasidynamic.solve.start import static_unknowns
from quasidynamic.solve.start.frictionless import frictionless_ring
from tests.random_rollers import RPM, drawn_bearing, drawn_cage, law, log_uniform

GRADES = {32: 5.4, 68: 8.7, 100: 11.1, 220: 18.7, 460: 30.5}  # ISO VG by nu at 100 degC [mm2/s], typical
VISCOSITIES = 0.15, 2.5  # [Pa s]
DIFFERENT = 1e-3  # of the largest load, or of rolling, by which two equilibria differ
ROUNDS = 3  # of pseudo-time


def design(rng: np.random.Generator) -> RollerBearing:
    """A bearing under C0/500 to C0/25 with an oil of 0.15 to 2.5 Pa s; one in five tilts under a moment."""
    rollers, diameter = int(rng.integers(8, 41)), log_uniform(rng, 4e-3, 25e-3)
    pitch = max(rollers * diameter / (np.pi * rng.uniform(0.55, 0.9)), 3.0 * diameter)
    length = diameter * rng.uniform(0.8, 1.8)
    guidance = str(rng.choice(["outer", "inner", "rollers"]))
    cage = drawn_cage(rng, guidance, pitch, diameter, length)
    oil = oil_of_viscosity(int(rng.choice(list(GRADES))), log_uniform(rng, *VISCOSITIES))
    _, traction = law(str(rng.choice(["4109", "eyring", "bair-winer", "four points"])), oil, rng)
    bearing = drawn_bearing(rng, rollers, pitch, diameter, length, rng.uniform(0, 1e-3) * pitch, cage)
    load = static_rating(bearing) * log_uniform(rng, 1 / 500, 1 / 25)
    speed = min(log_uniform(rng, 200.0, 6000.0), 500.0 / pitch) * RPM
    tilted = rng.random() < 0.2
    operation = Operation(
        radial_load=load,
        load_direction=rng.uniform(0, 2 * np.pi),
        inner_speed=speed,
        moment=load * length * rng.uniform(-0.2, 0.2) if tilted else 0.0,
        free_tilt=tilted,
    )
    lubrication = Lubrication(oil=oil, oil_fraction=log_uniform(rng, 1e-3, 0.3), traction=traction)
    return RollerBearing(bearing=bearing, operation=operation, lubrication=lubrication)


def oil_of_viscosity(grade, viscosity):
    """A mineral oil at the temperature where it has a viscosity [Pa s], or as cold as it may be."""
    oil = mineral_oil(grade)
    (cold, hot), inside = oil.usable, 0.01  # [K]
    for _ in range(40):
        middle = (cold + hot) / 2
        thicker = oil_at(oil, middle).viscosity > viscosity
        cold, hot = (middle, hot) if thicker else (cold, middle)
    return oil_at(oil, max(cold, oil.usable[0] + inside))


@cache
def mineral_oil(grade):
    return two_point_oil(
        f"grade {grade}",
        viscosities=((313.15, grade * 1e-6), (373.15, GRADES[grade] * 1e-6)),
        density=880.0,
        pressure_viscosities=((313.15, 22e-9), (373.15, 17e-9)),
        conductivity=0.137,
        source="typical of mineral oils",
    )


def random_starts(balance, rng, number):
    """Scaled unknowns of many starts: random slips of the cage, random spins of three kinds.

    Every roller has a spin of its own, or is fast or slow by lot, or rollers roll in a zone that begins and
    ends anywhere and slow down behind it. Films and the place of the ring follow from that.
    """
    many = balance.take(np.zeros(number, int))
    shape, kind = (number, balance.layout.rollers), rng.random((number, 1))
    slip = np.exp(rng.uniform(np.log(1e-5), np.log(0.9), (number, 1)))
    each = rng.uniform(-0.1, 1.0, shape)
    either = np.where(rng.random(shape) < rng.random((number, 1)), 1.0, rng.uniform(0, 0.9, (number, 1)))
    zone = zones(balance, rng, number)
    spin = np.where(kind < 1 / 3, each, np.where(kind < 2 / 3, either, zone))
    state = static_unknowns(many, -slip * many.rolling_cage)
    state = state._replace(spin_drift=(spin - 1) * many.rolling_spin)
    load = np.array([many.points.load_y[:, 0], many.points.load_z[:, 0]])
    state = state._replace(film=film_at(many, state, frictionless_loads(many, state)))
    state = frictionless_ring(many, state, load)
    return many, many.pack(state._replace(film=film_at(many, state, frictionless_loads(many, state))))


def zones(balance, rng, number):
    """Spins over rolling that are one in a zone and fall behind it."""
    direction = np.arctan2(balance.points.load_y, balance.points.load_z)[0, 0]
    passed = (balance.roller.bearing.azimuths - direction) * np.sign(balance.rolling_cage[0, 0])
    behind = np.mod(passed, 2 * np.pi)[None]  # the load [rad]
    end = rng.uniform(0, np.pi / 1.2, (number, 1))
    begin, fall = rng.uniform(0, np.pi / 1.2, (number, 1)), rng.uniform(0, 0.6, (number, 1))
    rolling = (behind < end) | (behind > 2 * np.pi - begin)
    return np.where(rolling, 1.0, 1 - fall * np.maximum(behind - end, 0))


def others_by_search(state, rng, number=60):
    """Stable equilibria that differ from a state, from as many random starts."""
    found = []
    with np.errstate(all="ignore"):
        many, starts = random_starts(state.balance, rng, number)
        solved = solve_each(many, starts, ROUNDS)
    for unknowns, outcome in zip(solved.unknowns, solved.outcomes, strict=True):
        if outcome is SolverOutcome.CONVERGED:
            other = replace(state, scaled=unknowns)
            if all(apart(other, one) > DIFFERENT for one in [state, *found]) and decays(other):
                found.append(other)
    return found


def apart(one, other):
    """Largest difference of two states: of a load over the largest, of a spin over rolling."""
    largest = max(one.loads[0].max(), other.loads[0].max())
    spin = np.abs(one.roller_speed - other.roller_speed).max() / abs(one.balance.rolling_spin[0, 0])
    return max(np.abs(one.loads - other.loads).max() / largest, spin)


def decays(state):
    return np.real(growth_rates(state.balance, state.system)).max() < 0
