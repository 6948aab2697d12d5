"""Random roller bearings, and a check of their forces that the solver does not use."""

from dataclasses import replace
from functools import partial
from typing import Any

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
    RollerRow,
    oil_at,
)
from quasidynamic.contact.traction import in_any_contact
from quasidynamic.contact.traction.asperity_friction import Carter, RoundedCoulomb
from quasidynamic.contact.traction.mixed import ZHOU_HOEPRICH, RoughContacts

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850)
CERAMIC = Material(youngs_modulus=310e9, poisson_ratio=0.26, density=3200)
RPM = 2 * np.pi / 60
SMALLEST = 0.1e-3  # [m] roller diameter, about


def drawn_cage(rng: np.random.Generator, guidance: Any, pitch: float, diameter: float, length: float) -> Cage:
    """Its friction, thickness and clearance; the land is beside the rollers."""
    return Cage(
        guidance=guidance,
        pocket_friction=rng.uniform(0.0, 0.1),
        thickness=diameter * rng.uniform(0.3, 0.7),
        mass=1.2e3 * pitch * diameter * length,
        land_diameter=pitch + (0.8 if guidance == "outer" else -0.8) * diameter,
        land_width=length / 2,
        land_clearance=rng.uniform(2e-3, 8e-3) * pitch,
    )


def drawn_bearing(
    rng, rollers, pitch, diameter, length, clearance, cage, material=STEEL
) -> CylindricalRollerBearing:
    """Rings of steel with logarithmic rollers, the first of them anywhere."""
    profile = Logarithmic(amplitude=0.00035 * diameter)
    return CylindricalRollerBearing(
        rollers=rollers,
        outer_raceway_diameter=pitch + diameter,
        clearance=clearance,
        roller=Roller(diameter=diameter, length=length, material=material, profile=profile),
        cage=cage,
        inner_ring=STEEL,
        outer_ring=STEEL,
        first_roller_azimuth=rng.uniform(0, 2 * np.pi),
    )


def design(rng: np.random.Generator) -> tuple[RollerBearing, str]:
    """A random bearing, and the name of its traction law."""
    rollers = int(rng.integers(6, 60))
    diameter = rng.uniform(4e-3, 20e-3)
    share = rng.uniform(0.5, 0.9)  # of the pitch circle that rollers fill
    pitch = max(rollers * diameter / (np.pi * share), 2.5 * diameter)
    length = diameter * rng.uniform(0.8, 1.8)
    guidance: Any = str(rng.choice(["outer", "inner", "rollers"]))
    cage = drawn_cage(rng, guidance, pitch, diameter, length)
    oil = oil_at("MIL-PRF-23699", rng.uniform(313.15, 473.15))
    name, traction = law(str(rng.choice(["4109", "eyring", "bair-winer", "four points"])), oil, rng)
    tilted = rng.random() < 1 / 3
    load = log_uniform(rng, 10.0, 1e5)
    bearing = drawn_bearing(rng, rollers, pitch, diameter, length, rng.uniform(-50e-6, 300e-6), cage)
    operation = Operation(
        radial_load=load,
        load_direction=rng.uniform(0, 2 * np.pi),
        inner_speed=log_uniform(rng, 100.0, 1e5) * RPM,
        moment=load * length * rng.uniform(-0.3, 0.3) if tilted else 0.0,
        free_tilt=tilted,
    )
    lubrication = Lubrication(oil=oil, oil_fraction=log_uniform(rng, 1e-3, 0.3), traction=traction)
    return RollerBearing(bearing=bearing, operation=operation, lubrication=lubrication), name


def row_design(rng: np.random.Generator) -> tuple[RollerBearing, str]:
    """A bearing of `design` with two rows, alike or not; half of the rings tilt freely, under any couple."""
    model, name = design(rng)
    bearing, length = model.bearing, model.bearing.roller.length
    distance = length * rng.uniform(1.1, 6.0)
    unlike = rng.random() < 0.5
    second = RollerRow(
        axial=distance / 2,
        clearance=rng.uniform(-20e-6, 20e-6) if unlike else 0.0,
        azimuth=rng.uniform(0, 1) if unlike else 0.0,
    )
    free, load = bool(rng.random() < 0.5), model.operation.radial_load
    operation = replace(
        model.operation,
        moment=load * distance * rng.uniform(-0.7, 0.7) if free else 0.0,
        free_tilt=free,
        tilt_direction=rng.uniform(0, 2 * np.pi),
        misalignment=0.0 if free else rng.choice([0.0, 1.0]) * rng.uniform(-1e-3, 1e-3),
    )
    rows = RollerRow(axial=-distance / 2), second
    return replace(model, bearing=replace(bearing, rows=rows), operation=operation), name


def slow_design(rng: np.random.Generator, asperities=None) -> tuple[RollerBearing, str]:
    """A bearing of `design` at 0.1 to 20 rpm in hot thin oil, whose rough surfaces touch.

    `asperities` makes their friction from a coefficient, by default `Carter`.
    """
    model, name = design(rng)
    oil = oil_at("MIL-PRF-23699", rng.uniform(423.15, 473.15))
    name, fluid = law(str(rng.choice(["4109", "eyring", "bair-winer", "four points"])), oil, rng)
    friction = rng.uniform(0.05, 0.15)
    rough = RoughContacts(
        fluid=fluid,
        share=ZHOU_HOEPRICH,
        asperities=(asperities or _creeping)(friction),
        inner_roughness=log_uniform(rng, 0.1e-6, 1e-6),
        outer_roughness=log_uniform(rng, 0.1e-6, 1e-6),
    )
    operation = replace(model.operation, inner_speed=log_uniform(rng, 0.1, 20.0) * RPM)
    lubrication = replace(model.lubrication, oil=oil, traction=rough)
    return replace(model, operation=operation, lubrication=lubrication), name


def slow_rounded_design(rng: np.random.Generator) -> tuple[RollerBearing, str]:
    """The same bearing as `slow_design` with Coulomb friction rounded over 1 mm/s."""
    return slow_design(rng, _rounded)


def _creeping(friction):
    return partial(Carter, coefficient=friction)


def _rounded(friction):
    return partial(in_any_contact, RoundedCoulomb(coefficient=friction, sign_speed=1e-3))


def wide_design(rng: np.random.Generator) -> tuple[RollerBearing, str]:
    """A random bearing from far beyond what is built, and what is special about it.

    3 to 700 rollers, about 0.1 mm thick at least, on a pitch circle of 1 mm to 5 m, length over diameter 0.2
    to 10, a third of the rollers ceramic; clearance from a preload of 0.3 % of a roller's diameter to 2 %.
    Surfaces move at 10 um/s to 100 m/s; either ring stands, both turn together or against each other. Loads
    of 1e-8 to 1e-3 E D l Z/5, 20 MPa to 4 GPa, a sixth of the bearings under a moment alone. Any direction
    of load and gravity, upright shafts, misalignment; free cages, churning, starved inlets.
    """
    bearing = _wide_bearing(rng)
    roller, oil = bearing.roller, _wide_oil(rng)
    name, traction = law(str(rng.choice(["4109", "eyring", "bair-winer", "four points"])), oil, rng)
    operation, kind = _wide_operation(rng, bearing)
    churning, starved = rng.random() < 0.25, rng.random() < 0.2
    lubrication = Lubrication(
        oil=oil,
        oil_fraction=log_uniform(rng, 1e-3, 0.3),
        traction=traction,
        churning_gap=roller.diameter * log_uniform(rng, 0.02, 0.2) if churning else None,
        inlet_length=log_uniform(rng, 0.3, 10.0) if starved else None,
    )
    words = [name, kind, *(["free cage"] if bearing.cage.free else []), *(["starved"] if starved else [])]
    return RollerBearing(bearing=bearing, operation=operation, lubrication=lubrication), ", ".join(words)


def _wide_bearing(rng) -> CylindricalRollerBearing:
    pitch = log_uniform(rng, 1e-3, 5.0)
    rollers = round(log_uniform(rng, 3.0, min(700.4, 2.5 * pitch / SMALLEST)))
    diameter = min(np.pi * pitch * rng.uniform(0.4, 0.95) / rollers, pitch / 2.5)
    length = diameter * log_uniform(rng, 0.2, 10.0)
    guidance: Any = str(rng.choice(["outer", "inner", "rollers"]))
    free = guidance != "rollers" and rng.random() < 0.4
    cage = drawn_cage(rng, guidance, pitch, diameter, length)
    cage = replace(cage, free=free, unbalance=rng.choice([0.0, 1e-4]) * pitch if free else 0.0)
    clearance = diameter * rng.uniform(-3e-3, 0.0 if rng.random() < 0.25 else 2e-2)
    material = CERAMIC if rng.random() < 1 / 3 else STEEL
    return drawn_bearing(rng, rollers, pitch, diameter, length, clearance, cage, material)


def _wide_oil(rng):
    if rng.random() < 0.5:
        return oil_at("MIL-PRF-23699", rng.uniform(313.15, 473.15))
    return oil_at(str(rng.choice(["ISO VG 32", "ISO VG 68", "ISO VG 100"])), rng.uniform(283.15, 373.15))


def _wide_operation(rng, bearing) -> tuple[Operation, str]:
    roller = bearing.roller
    speed = log_uniform(rng, 1e-5, 100.0) / (bearing.pitch_diameter / 2)
    inner, outer = speed * np.array(
        [(1.0, 0.0), (0.0, 1.0), (1.0, -rng.uniform(0.2, 5.0)), (1.0, rng.uniform(0.2, 0.95)), (-1.0, 0.0)][
            rng.choice(5, p=[0.4, 0.15, 0.25, 0.1, 0.1])
        ]
    )
    unit = STEEL.youngs_modulus * roller.diameter * roller.length * bearing.rollers / 5
    load, kind = unit * log_uniform(rng, 1e-8, 1e-3), "load"
    moment = slope = 0.0
    if (choice := rng.random()) < 1 / 6:
        moment, load, kind = load * roller.length * rng.uniform(0.05, 0.5), 0.0, "moment alone"
    elif choice < 1 / 3:
        moment, kind = load * roller.length * rng.uniform(-0.3, 0.3), "tilted"
    elif choice < 0.4:
        slope, kind = rng.uniform(-1e-3, 1e-3) * roller.diameter / roller.length, "misaligned"
    elif choice < 0.45 and bearing.clearance < 0:
        load, kind = 0.0, "preload alone"
    return Operation(
        radial_load=load,
        load_direction=rng.uniform(0, 2 * np.pi),
        inner_speed=float(inner),
        outer_speed=float(outer),
        moment=moment,
        misalignment=slope,
        free_tilt=moment != 0.0,
        gravity=rng.choice([9.81, 9.81, 9.81, 0.0]),
        gravity_direction=rng.uniform(0, 2 * np.pi),
    ), kind


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


def carried_moment(state, tangential) -> np.ndarray:
    """Moments (z, y) [N m] that rows of rollers carry about the middle of the rings, with forces along t."""
    bearing = state.balance.roller.bearing
    x = 0.0 if bearing.stations is None else bearing.stations
    sin, cos = np.sin(bearing.azimuths), np.cos(bearing.azimuths)
    about = state.forces[0, :, 1] * bearing.roller.length / 2 + x * state.loads[0]
    along = x * tangential
    return np.array([(about * cos - along * sin).sum(), (about * sin + along * cos).sum()])


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
    ring = np.array(
        [
            load[0] @ sin + tangential @ cos - points.load_y[0, 0],
            load[0] @ cos - tangential @ sin - points.load_z[0, 0],
        ]
    )
    if state.cage_offset is not None and bearing.cage.guidance == "inner":
        ring = ring + state.cases.acting.land[0]
    cage = -force.sum() * r_m - (s * friction).sum() * r_w + state.land_torque
    cage -= state.rollers.churning.sum()
    moments = [0.0]
    if points.free_tilt[0, 0]:
        applied = np.array([points.moment_z[0, 0], points.moment_y[0, 0]])
        moments = (carried_moment(state, tangential) - applied) / bearing.roller.length
    parts = [*radial, *along, *spin, *ring, cage / r_m, *moments]
    size = max(points.load[0, 0], load.max(), points.moment[0, 0] / bearing.roller.length)
    return float(np.abs(parts).max() / size)
