"""Random roller bearings, and a check of their forces that the solver does not use."""

from functools import partial

import numpy as np

from quasidynamic import (
    BairWiner,
    Cage,
    CylindricalRollerBearing,
    Eyring,
    FourPointCurve,
    Logarithmic,
    Lubrication,
    Material,
    Operation,
    Regression4109,
    Roller,
    RollerBearing,
    oil_at,
)

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850)
RPM = 2 * np.pi / 60


def design(rng: np.random.Generator) -> tuple[RollerBearing, str]:
    """A random bearing, and the name of its traction law."""
    rollers = int(rng.integers(6, 60))
    diameter = rng.uniform(4e-3, 20e-3)
    share = rng.uniform(0.5, 0.9)  # of the pitch circle that rollers fill
    pitch = max(rollers * diameter / (np.pi * share), 2.5 * diameter)
    length = diameter * rng.uniform(0.8, 1.8)
    guidance = rng.choice(["outer", "inner", "rollers"])
    land = pitch + (0.8 if guidance == "outer" else -0.8) * diameter
    cage = Cage(
        guidance=str(guidance),
        pocket_friction=rng.uniform(0.0, 0.1),
        thickness=diameter * rng.uniform(0.3, 0.7),
        mass=1.2e3 * pitch * diameter * length,
        land_diameter=land,
        land_width=length / 2,
        land_clearance=rng.uniform(2e-3, 8e-3) * pitch,
    )
    oil = oil_at("MIL-PRF-23699", rng.uniform(313.15, 473.15))
    name, traction = law(str(rng.choice(["4109", "eyring", "bair-winer", "four points"])), oil, rng)
    tilted = rng.random() < 1 / 3
    load = log_uniform(rng, 10.0, 1e5)
    bearing = CylindricalRollerBearing(
        rollers=rollers,
        outer_raceway_diameter=pitch + diameter,
        clearance=rng.uniform(-50e-6, 300e-6),
        roller=Roller(
            diameter=diameter,
            length=length,
            material=STEEL,
            profile=Logarithmic(amplitude=0.00035 * diameter),
        ),
        cage=cage,
        inner_ring=STEEL,
        outer_ring=STEEL,
        first_roller_azimuth=rng.uniform(0, 2 * np.pi),
    )
    operation = Operation(
        radial_load=load,
        load_direction=rng.uniform(0, 2 * np.pi),
        inner_speed=log_uniform(rng, 100.0, 1e5) * RPM,
        moment=load * length * rng.uniform(-0.3, 0.3) if tilted else 0.0,
        free_tilt=tilted,
    )
    lubrication = Lubrication(oil=oil, oil_fraction=log_uniform(rng, 1e-3, 0.3), traction=traction)
    return RollerBearing(bearing=bearing, operation=operation, lubrication=lubrication), name


def law(name, oil, rng):
    if name == "4109":
        return name, Regression4109
    limit = rng.uniform(0.03, 0.08)
    if name == "eyring":
        return name, partial(Eyring, limiting_ratio=limit, eyring_stress=2 * limit / oil.pressure_viscosity)
    if name == "bair-winer":
        return name, partial(BairWiner, limiting_ratio=limit)
    curve = FourPointCurve.through(
        at_rest=0.0, peak=limit, peak_slip=log_uniform(rng, 5e-3, 0.1), far=limit * rng.uniform(0.4, 0.95)
    )
    return name, lambda **pair: curve


def log_uniform(rng, low, high):
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def pocket_rounding(bearing) -> float:
    """Width over which the force in a pocket changes its sign [N]: 1e-10 E' R l of the inner contact."""
    steepness = sum(
        (1 - m.poisson_ratio**2) / m.youngs_modulus for m in (bearing.roller.material, bearing.inner_ring)
    )
    curvature = 2 / bearing.roller.diameter + 1 / bearing.inner_radius
    return 1e-10 * 2 / steepness / curvature * bearing.roller.length


def imbalance(state) -> float:
    """Largest imbalance over the largest force, from the reported quantities alone."""
    bearing, points = state.balance.roller.bearing, state.balance.points
    t, shear, load, force = state.traction, state.rolling_shear, state.loads, state.cage_force
    g, nominal = bearing.diameter_ratio, points.inner_speed[0, 0] - points.outer_speed[0, 0]
    s = state.roller_speed / np.hypot(state.roller_speed, 1e-3 * nominal * (1 - g**2) / (2 * g))
    r_w, r_m = bearing.roller.diameter / 2, bearing.pitch_diameter / 2
    friction = bearing.cage.pocket_friction * force**2 / np.hypot(force, pocket_rounding(bearing))
    down = np.array([points.gravity_y[0, 0], points.gravity_z[0, 0]]) * bearing.roller.mass
    centrifugal = bearing.roller.mass * r_m * state.cage_speed**2
    drag = state.rollers.drag[0, 0]
    sin, cos = np.sin(bearing.azimuths), np.cos(bearing.azimuths)
    tangential = t[0] + (1 - 2 * g) * shear[0]
    radial = load[0] - load[1] + centrifugal + down @ [sin, cos] + s * bearing.cage.pocket_friction * force
    along = t[0] + t[1] + (1 - 2 * g) * shear[0] - (1 + 2 * g) * shear[1] - drag + force
    along += down @ [cos, -sin]
    spin = (
        t[0] - t[1] - shear[0] - shear[1] - s * friction - (state.transport + state.rollers.churning[0]) / r_w
    )
    ring = [
        load[0] @ sin + tangential @ cos - points.load_y[0, 0],
        load[0] @ cos - tangential @ sin - points.load_z[0, 0],
    ]
    cage = -force.sum() * r_m - (s * friction).sum() * r_w + state.land_torque
    cage -= state.rollers.churning.sum()
    moments = [0.0]
    if points.free_tilt[0, 0]:
        applied = np.array([points.moment_z[0, 0], points.moment_y[0, 0]])
        moments = (state.ring_moment - applied) / bearing.roller.length
    parts = [*radial, *along, *spin, *ring, cage / r_m, *moments]
    size = max(points.load[0, 0], load.max(), points.moment[0, 0] / bearing.roller.length)
    return float(np.abs(parts).max() / size)
