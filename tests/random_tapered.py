"""Random tapered roller bearings: short and long rollers, at rest and at speed, held and free, with rings."""

from dataclasses import replace
from math import pi, radians

import numpy as np

import fem
from fem.condense import HARMONICS, condense
from fem.parts.boundary_conditions import Support
from flexbearing.rings.cones import towards_large_end
from quasidynamic import Cage, Lubrication, TaperedLoads, oil_at
from quasidynamic.motion.tapered_speeds import tapered_speeds
from quasidynamic.parts.angular_contact_bearing import RingOperation, RowPlace
from quasidynamic.parts.material import Material
from quasidynamic.parts.profile import STRAIGHT, Logarithmic
from quasidynamic.parts.roller_bearing import Roller
from quasidynamic.parts.tapered_bearing import TaperedRollerBearing, apex_angles, spherical_rib
from quasidynamic.tapered import least_thrust
from quasidynamic.tapered_friction import TaperedFriction
from tests.bearings import TRACTION

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850)


def drawn(seed: int) -> tuple[TaperedRollerBearing, RingOperation]:
    """A bearing and what is asked of it; axial loads are above the least that holds cup and cone together."""
    random = np.random.default_rng(seed)
    rollers, filled = int(random.integers(8, 60)), random.uniform(0.7, 0.95)
    pitch = 10 ** random.uniform(-1.6, 0.3)
    diameter = filled * pi * pitch / rollers
    cup = radians(random.uniform(8, 32))
    axis, cone = apex_angles(cup, diameter / pitch)
    length = diameter * random.uniform(0.8, 2.5)
    drop = random.uniform(1e-4, 6e-4) * diameter
    profile = Logarithmic(amplitude=drop) if random.random() < 0.7 else STRAIGHT
    roller = Roller(diameter=diameter, length=length, material=STEEL, profile=profile)
    radius = random.uniform(0.85, 0.98) * (pitch / 2 / np.sin(axis) + length / 2)
    depth = random.uniform(0.3, 0.9) * diameter / 2
    bearing = TaperedRollerBearing(
        rollers=rollers,
        pitch_diameter=pitch,
        cup_angle=cup,
        cone_angle=cone,
        roller=roller,
        rib=spherical_rib(roller, axis, axis - np.arcsin(depth / radius), radius, STEEL),
        inner_ring=STEEL,
        outer_ring=STEEL,
        side=random.choice([-1, 1]),
        first_roller_azimuth=random.uniform(0, 1),
    )
    rating = 60e6 * rollers * diameter * length  # [N] a pressure of some 1 to 2 GPa
    radial, turn = rating * 10 ** random.uniform(-4, 0), random.uniform(0, 2 * pi)
    speed = random.choice([0.0, 1.0]) * 10 ** random.uniform(-1, 1.2) / pitch  # up to 8 m/s of the rollers
    centrifugal = tapered_speeds(bearing, speed).centrifugal_force
    axial = least_thrust(bearing, radial, centrifugal) * random.choice([1.1, 1.5, 3.0, 20.0])
    sin, cos, held = np.sin(turn), np.cos(turn), random.random()
    load = [bearing.side * axial, radial * sin, radial * cos, 0.0, 0.0]
    if held < 0.3:  # free to tilt, the load near the centre of pressure
        arm = bearing.side * radial * pitch / 2 * np.tan(cup) * random.uniform(0.95, 1.05)
        load[3:] = arm * cos, -arm * sin
        displacement: list[float | None] = [None] * 5
    else:
        displacement = [None, None, None, *(random.normal(0, 3e-4, 2) * random.integers(0, 2))]
    if held > 0.8:  # held axially as well, pressed or with a gap
        load[0], displacement[0] = 0.0, bearing.side * random.normal(0, 1e-3) * diameter
    axial_force, y, z, about_y, about_z = map(float, load)
    return bearing, RingOperation(
        load=(axial_force, y, z, about_y, about_z),
        displacement=tuple(None if place is None else float(place) for place in displacement),
        inner_speed=float(speed),
    )


def drawn_pair(seed: int, bearing: TaperedRollerBearing) -> TaperedRollerBearing:
    """The same with a second row in O, X or tandem arrangement, with preload or play."""
    random = np.random.default_rng([seed, 2])
    distance = bearing.roller.length * random.uniform(1.1, 6.0)
    first, second = ((False, True), (True, False), (False, False))[random.integers(3)]
    closer = bearing.roller.diameter * random.normal(5e-4, 1e-3) if first != second else 0.0
    rows = ((-1, first), (1, second))
    return replace(
        bearing,
        rows=tuple(
            RowPlace(axial=sign * distance / 2, closer=float(closer), mirrored=mirrored)
            for sign, mirrored in rows
        ),
    )


def drawn_friction(seed: int, loads: TaperedLoads) -> TaperedFriction:
    """Friction in oils from thick to thin, with ribs and pockets from smooth to rough."""
    random = np.random.default_rng([seed, 3])
    oil = oil_at(str(random.choice(["ISO VG 32", "ISO VG 68", "ISO VG 100"])), random.uniform(293, 373))
    laws = Lubrication(
        oil=oil,
        oil_fraction=random.uniform(0, 0.3),
        churning_gap=1e-3 if random.random() < 0.5 else None,
        traction=TRACTION[str(random.choice(list(TRACTION)))](oil),
    )
    cage = Cage(guidance="rollers", pocket_friction=random.uniform(0, 0.2), thickness=0.0)
    return TaperedFriction(loads, laws, random.uniform(0, 0.15), cage)


def drawn_rings(seed: int, bearing: TaperedRollerBearing) -> list[fem.OuterRing | fem.RingOnShaft | None]:
    """Inner and outer ring, one or both elastic: a cup that is held in any way, a cone on a shaft.

    Opposed rows are in one ring, loaded in the planes of the roller centres; tandem in rigid ones.
    """
    if len(bearing.sides) > 1 and not bearing.opposed:
        return [None, None]
    random = np.random.default_rng([seed, 1])
    roller, cone = bearing.roller, bearing.cone_angle
    elastic = fem.Elastic(youngs_modulus=206e9, poisson_ratio=0.3)
    length, which = roller.length, random.random()
    width = length * random.uniform(1.05, 1.4)
    places = [row.axial for row in bearing.rows]
    beyond, apart = width / 2, max(places) - min(places)
    width, sign = width + apart, -max(bearing.sides[:1]) if apart else -1
    outer = fem.OuterRing(
        raceway_diameter=2 * raceway_middle(bearing, "outer"),
        thickness=beyond * np.tan(bearing.cup_angle) + roller.diameter * random.uniform(0.15, 1.0),
        width=width,
        elastic=elastic,
        support=_support(random, bearing, width),
        taper=sign * bearing.cup_angle,
        row_distance=apart,
    )
    middle = raceway_middle(bearing, "inner")
    below = middle - beyond * np.tan(cone)
    bore = 2 * (below - min(roller.diameter * random.uniform(0.2, 1.0), 0.6 * below))
    inner = fem.RingOnShaft(
        raceway_diameter=2 * middle,
        track_width=width,
        rib_diameter=None,
        bore=bore,
        width=width,
        shaft_bore=bore * random.choice([0.0, 0.5, 0.8]),
        shaft_length=width * random.uniform(1.1, 4.0),
        ring=elastic,
        shaft=elastic,
        taper=sign * cone,
        row_distance=apart,
    )
    return [inner if which > 0.6 else None, outer if which < 0.85 else None]


def raceway_middle(bearing: TaperedRollerBearing, race: str) -> float:
    """Distance of the middle of the contacts from the axis [m]."""
    reach = bearing.roller.diameter / 2 / np.cos(bearing.taper)
    if race == "outer":
        return bearing.pitch_diameter / 2 + reach * np.cos(bearing.cup_angle)
    return bearing.pitch_diameter / 2 - reach * np.cos(bearing.cone_angle)


def _support(random: np.random.Generator, bearing: TaperedRollerBearing, width: float) -> Support:
    which, soft = random.integers(4), 10 ** random.uniform(-2, 0.5)
    if which == 0:
        return fem.RigidSeat()
    if which == 1:
        return fem.ClampedFace()
    if which == 2:  # as stiff as a layer of the roller's size of aluminium, or much softer
        springs = soft * 70e9 / bearing.roller.diameter
        return fem.Foundation(axial=springs, radial=springs, tangential=springs)
    housing = fem.Elastic(youngs_modulus=70e9, poisson_ratio=0.33)
    thickness = bearing.roller.diameter * random.uniform(0.5, 2)
    return fem.Housing(thickness=thickness, width=width * random.uniform(0.8, 1.5), elastic=housing)


def compliance(
    bearing: TaperedRollerBearing, ring: fem.OuterRing | fem.RingOnShaft, shapes: int
) -> np.ndarray:
    """Compliance of a raceway as `tapered_loads` takes it, (Z, M, Z, M) [m/N]."""
    length = bearing.roller.length
    mesh = fem.MeshSize(order=5, size=1.2 * length, raceway_size=0.25 * length)
    band = length * np.cos(ring.taper)
    resolution = fem.Resolution(
        length=band,
        axial_modes=shapes,
        mesh_size=mesh,
        row_distance=ring.row_distance,
        along=isinstance(ring, fem.RingOnShaft),
    )
    first = int(np.sign(ring.taper))
    large_end = np.repeat([first, -first][: len(bearing.rows)], bearing.rollers)
    return towards_large_end(
        condense(ring, HARMONICS, resolution).at(bearing.azimuths).absolute, large_end, resolution.along
    )
