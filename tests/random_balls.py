"""Random angular-contact and deep groove bearings, with a check of forces that the solver does not use."""

from dataclasses import replace
from functools import partial

import numpy as np

from quasidynamic import BairWiner, Eyring, Regression4109, oil_at, preloaded_place
from quasidynamic.angular_contact import AngularContactBallBearing as Model
from quasidynamic.contact.lubrication import BallLubrication
from quasidynamic.outcome.angular_contact_state import AngularContactState
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing, RingOperation, RowPlace
from quasidynamic.parts.ball import Ball, Groove
from quasidynamic.parts.ball_cage import BallCage
from quasidynamic.parts.material import Material

RPM = np.pi / 30
STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7800.0)
CERAMIC = Material(youngs_modulus=310e9, poisson_ratio=0.26, density=3200.0)
FILM = partial(Eyring, limiting_ratio=0.05, eyring_stress=5e6)


def unbalanced(state: AngularContactState) -> float:
    """Force left on ring or balls over the largest force, from the contact forces anew."""
    load, traction = state.loads, state.tractions
    axial = load * np.sin(state.contact_angles) + traction * np.cos(state.contact_angles)
    radial = load * np.cos(state.contact_angles) - traction * np.sin(state.contact_angles)
    ball = np.abs([axial[0] - axial[1], radial[0] - radial[1] + state.centrifugal_force])
    azimuth, own = state.bearing.azimuths, state.bearing
    lever = own.inner.conformity * own.ball.diameter / own.inner_groove_radius
    towards, place = np.array([(-1.0 if row.mirrored else 1.0, row.axial) for row in own.rows])[
        own.ball_rows
    ].T
    moment = towards * (axial[0] - lever * traction[0]) - place / own.inner_groove_radius * radial[0]
    arms = [towards * axial[0], radial[0] * np.sin(azimuth), radial[0] * np.cos(azimuth)]
    arms += [moment * np.cos(azimuth), -moment * np.sin(azimuth)]
    scale = np.array([1.0, 1.0, 1.0, own.inner_groove_radius, own.inner_groove_radius])
    free = [place is None for place in state.operation.displacement]
    ring = np.abs(np.sum(arms, axis=1) - np.array(state.operation.load) / scale)[free]
    largest = max(load.max(), np.abs(state.operation.load / scale).max())
    return float(max(ball.max(), ring.max(initial=0.0)) / largest)


def drawn_sliding(seed: int) -> tuple[Model, RingOperation]:
    """The same bearing, its balls moved by Coulomb friction of 0.03 to 0.12."""
    model, operation = drawn(seed)
    friction = np.exp(np.random.default_rng([seed, 1]).uniform(np.log(0.03), np.log(0.12)))
    return Model(bearing=model.bearing, control="coulomb", friction=float(friction)), operation


def drawn_pair(seed: int) -> tuple[Model, RingOperation]:
    """Two rows of the same balls in any arrangement, from play to a preload of a tenth of the rating."""
    model, operation = drawn(seed)
    random, row = np.random.default_rng([seed, 3]), model.bearing
    first, second = ((False, True), (True, False), (False, False))[int(random.integers(3))]
    static = row.balls * row.ball.diameter**2 * 5e7
    pressed = preloaded_place(row, static * 10 ** random.uniform(-5.0, -1.0))
    closer = pressed if random.random() < 0.8 else -random.uniform(0.0, 1e-3) * row.ball.diameter
    apart = row.ball.diameter * 10 ** random.uniform(0.0, 1.0)
    rows = ((-apart / 2, first), (apart / 2, second))
    places = tuple(RowPlace(axial=at, mirrored=mirrored, closer=closer) for at, mirrored in rows)
    return Model(bearing=replace(row, rows=places), control=model.control), operation


def identities(state: AngularContactState) -> tuple[float, float, float]:
    """What is left of three sums, relative: power of the rings less heat by cause, angular momentum, cage.

    The second is torque of the rings less that of the drag: zero without churning. The third is what exceeds
    the torque that a pocket film makes of the last digit of the orbital speed, which is all a ball can be
    balanced to: of seed 122 4e-14 N m are left of 7e-7, where a digit makes 1e-13.
    """
    oil, operation, pitch = state.oil, state.operation, state.bearing.pitch_diameter / 2
    assert oil is not None
    inner, outer = oil.ring_torque.sum(1)
    power = inner * operation.inner_speed + outer * operation.outer_speed
    turning = np.where(state.orbital_speed != 0, state.orbital_speed, 1.0)
    left = abs(inner + outer - (oil.drag_heat / turning).sum())
    torques = np.abs(oil.ring_torque).sum() + pitch * np.abs(oil.pocket_force).sum()
    cage = abs(oil.land_torque.sum() - oil.pocket_torque.sum()) - _of_a_digit(state)
    return power / oil.heat.sum() - 1, left / np.abs(oil.ring_torque).sum(), max(cage, 0.0) / torques


def _of_a_digit(state: AngularContactState) -> float:
    """Torque [N m] of the pocket films on a cage by rounding the orbital speed of each ball to a double."""
    oil, own = state.oil, state.bearing
    assert oil is not None
    pushed = oil.pocket_displacement != 0
    film = np.abs(oil.pocket_force[pushed] / oil.pocket_displacement[pushed])  # [N/m]
    advance = np.pi * own.pitch_diameter / own.balls  # [m] by the orbital speed over that of the cage
    return float(own.pitch_diameter / 2 * advance * film.sum() * np.finfo(float).eps / 2)


def drawn_oiled(seed: int) -> tuple[Model, RingOperation]:
    """A random bearing of `drawn` in a random oil."""
    model, operation = drawn(seed)
    random = np.random.default_rng([seed, 7])
    laws = [
        FILM,
        partial(FILM, film_heating=True),
        partial(BairWiner, limiting_ratio=0.06),
        Regression4109,
    ]
    lubrication = BallLubrication(
        oil=oil_at(
            str(random.choice(["ISO VG 32", "ISO VG 68", "MIL-PRF-23699"])), random.uniform(313.0, 383.0)
        ),
        oil_fraction=random.uniform(0.0, 0.1),
        traction=laws[int(random.integers(4))],
        churning_gap=1e-3 if random.random() < 0.5 else None,
        inlet_length=2.0 if random.random() < 0.5 else None,
    )
    oiled = Model(bearing=model.bearing, control="oil", lubrication=lubrication)
    return oiled, operation


def drawn_caged(seed: int) -> tuple[Model, RingOperation]:
    """The same in a cage, on balls or on a land, with a wide range of clearances."""
    model, operation = drawn_oiled(seed)
    random, row = np.random.default_rng([seed, 8]), model.bearing
    guidance = ("balls", "outer", "inner")[int(random.integers(3))]
    towards = {"balls": 0.0, "outer": 1.0, "inner": -1.0}[guidance]
    cage = BallCage(
        guidance=guidance,
        pocket_clearance=row.ball.diameter * 10 ** random.uniform(-3.0, -1.0),
        pocket_friction=float(random.choice([0.0, random.uniform(0.0, 0.2)])),
        land_diameter=row.pitch_diameter + towards * 0.6 * row.ball.diameter,
        land_width=0.4 * row.ball.diameter,
        land_clearance=row.pitch_diameter * 10 ** random.uniform(-3.0, -2.0),
        land_flow="vortices" if random.random() < 0.5 else "laminar",
    )
    return replace(model, cage=cage), operation


def drawn(seed: int) -> tuple[Model, RingOperation]:
    random = np.random.default_rng(seed)
    balls_of = STEEL if random.random() < 0.7 else CERAMIC
    diameter, ratio = np.exp(random.uniform(np.log(3e-3), np.log(40e-3))), random.uniform(0.08, 0.3)
    pitch = diameter / ratio
    most = int(np.pi / np.arcsin(ratio) * 0.98)
    bearing = AngularContactBearing(
        ball=Ball(diameter=diameter, material=balls_of),
        inner=Groove(conformity=random.uniform(0.505, 0.55), material=STEEL),
        outer=Groove(conformity=random.uniform(0.505, 0.55), material=STEEL),
        balls=int(random.integers(max(3, most // 2), most + 1)),
        pitch_diameter=pitch,
        contact_angle=np.radians(random.uniform(5.0, 45.0)),
    )
    speed = 10 ** random.uniform(1.0, np.log10(5e5)) / (pitch * 1e3) * RPM
    lean, azimuth = np.radians(random.uniform(0.0, 90.0)), random.uniform(0.0, 2 * np.pi)
    size = bearing.balls * diameter**2 * 5e7 * 10 ** random.uniform(-5.0, 0.0)
    load = size * np.array([np.cos(lean), np.sin(lean) * np.sin(azimuth), np.sin(lean) * np.cos(azimuth)])
    moment = np.zeros(2)
    holding = ("free", "straight", "preloaded")[int(random.choice(3, p=[0.4, 0.3, 0.3]))]
    if holding == "free":
        about = random.uniform(0.0, 2 * np.pi)
        moment = random.uniform(0.0, 1.0) * size * pitch / 2 * -np.array([np.sin(about), np.cos(about)])
    if holding == "preloaded":
        load[0] = 0.0
    preload = random.uniform(0.0, 0.3) * min(bearing.inner_reach, bearing.outer_reach)
    operation = RingOperation(
        load=(float(load[0]), float(load[1]), float(load[2]), float(moment[0]), float(moment[1])),
        displacement={
            "free": (None,) * 5,
            "straight": (None, None, None, 0.0, 0.0),
            "preloaded": (float(preload), None, None, 0.0, 0.0),
        }[holding],
        inner_speed=speed,
    )
    control = ("outer", "inner", "equal")[int(random.integers(3))]
    return Model(bearing=bearing, control=control), operation


def drawn_deep_groove(seed: int) -> tuple[Model, RingOperation]:
    """A deep groove bearing of common proportions, from interference to twice the clearance of class C5."""
    random = np.random.default_rng([seed, 2])
    balls_of = STEEL if random.random() < 0.8 else CERAMIC
    diameter, ratio = np.exp(random.uniform(np.log(3e-3), np.log(40e-3))), random.uniform(0.1, 0.3)
    pitch = diameter / ratio
    most = int(np.pi / np.arcsin(ratio) * 0.98)
    bearing = AngularContactBearing(
        ball=Ball(diameter=diameter, material=balls_of),
        inner=Groove(conformity=random.uniform(0.505, 0.54), material=STEEL),
        outer=Groove(conformity=random.uniform(0.505, 0.54), material=STEEL),
        balls=int(random.integers(max(6, most // 2), max(6, most) + 1)),
        pitch_diameter=pitch,
        contact_angle=0.0,
        clearance=random.uniform(-0.3, 2.0) * 1e-3 * diameter,
        first_ball_azimuth=random.choice([0.0, random.uniform(0.0, 2 * np.pi)]),
    )
    speed = random.choice([0.0, 10 ** random.uniform(1.0, np.log10(5e5)) / (pitch * 1e3) * RPM])
    size = bearing.balls * diameter**2 * 5e7 * 10 ** random.uniform(-3.0, 0.0)
    kind = ("radial", "axial", "combined", "moment")[int(random.integers(4))]
    lean = {"radial": 0.5 * np.pi, "axial": 0.0}.get(kind, random.uniform(0.0, np.pi))
    azimuth, moment = random.choice([0.0, random.uniform(0.0, 2 * np.pi)]), np.zeros(2)
    load = size * np.array([np.cos(lean), np.sin(lean) * np.sin(azimuth), np.sin(lean) * np.cos(azimuth)])
    if kind == "moment":
        about = random.uniform(0.0, 2 * np.pi)
        moment = random.uniform(0.0, 0.3) * size * pitch / 2 * np.array([np.sin(about), np.cos(about)])
    level = kind == "radial" or random.random() < 0.5
    operation = RingOperation(
        load=(float(load[0]), float(load[1]), float(load[2]), *(0.0 * moment if level else moment)),
        displacement=(None, None, None, 0.0, 0.0) if level else (None,) * 5,
        inner_speed=float(speed),
    )
    control = ("outer", "inner", "equal")[int(random.integers(3))]
    return Model(bearing=bearing, control=control), operation
