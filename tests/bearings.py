"""Bearings that several tests use, built without case files."""

from functools import partial
from math import pi

from quasidynamic import (
    Cage,
    CylindricalRollerBearing,
    Eyring,
    Lubrication,
    Material,
    Operation,
    Regression4109,
    Ribs,
    Roller,
    RollerBearing,
    RollerRow,
    Straight,
    oil_at,
)

RPM = 2 * pi / 60

CAGE = {
    "guidance": "outer",
    "pocket_friction": 0.05,
    "thickness": 2.5e-3,
    "mass": 0.025,
    "land_diameter": 74.6e-3,
    "land_width": 3e-3,
    "land_clearance": 0.4e-3,
}
RIBS = Ribs(inner_height=0.8e-3, outer_height=0.6e-3, end_radius=0.5, friction=0.05)


def paper_bearing(**changes) -> RollerBearing:
    """The bearing of Mao, Wang and Zhang (2016); what the paper leaves out is chosen here."""
    value = {
        "rollers": 30,
        "clearance": 75.5e-6,
        "load": 19621.1,
        "speed": 38000 * RPM,
        "outer_speed": 0.0,
        "moment": 0.0,
        "azimuth": 0.0,
        "profile": Straight(),
        "contact_law": "palmgren",
        "oil_fraction": 0.16,
        "cage": {},
        "load_direction": 0.0,
        "misalignment": 0.0,
        "gravity": 9.81,
        "traction": "4109",
        "inner_waves": None,
        "outer_waves": None,
        "roller_deviations": (),
        "inner_profile": Straight(),
        "outer_profile": Straight(),
        "rows": (RollerRow(),),
        "tilt_direction": 0.0,
        "axial_load": 0.0,
        "ribs": None,
        **changes,
    }
    ring = Material(youngs_modulus=203e9, poisson_ratio=0.28, density=7850)
    roller = Roller(
        diameter=5e-3,
        length=5e-3,
        material=Material(youngs_modulus=209e9, poisson_ratio=0.3, density=7860),
        profile=value.pop("profile"),
    )
    bearing = CylindricalRollerBearing(
        rollers=value.pop("rollers"),
        outer_raceway_diameter=75e-3,
        clearance=value.pop("clearance"),
        roller=roller,
        cage=Cage(**{**CAGE, **value.pop("cage")}),
        inner_ring=ring,
        outer_ring=ring,
        contact_law=value.pop("contact_law"),
        first_roller_azimuth=value.pop("azimuth"),
        inner_waves=value.pop("inner_waves"),
        outer_waves=value.pop("outer_waves"),
        roller_deviations=value.pop("roller_deviations"),
        inner_profile=value.pop("inner_profile"),
        outer_profile=value.pop("outer_profile"),
        rows=value.pop("rows"),
        ribs=value.pop("ribs"),
    )
    operation = Operation(
        radial_load=value.pop("load"),
        load_direction=value.pop("load_direction"),
        inner_speed=value.pop("speed"),
        outer_speed=value.pop("outer_speed"),
        free_tilt=value.pop("free_tilt", value["moment"] != 0),
        moment=value.pop("moment"),
        misalignment=value.pop("misalignment"),
        tilt_direction=value.pop("tilt_direction"),
        axial_load=value.pop("axial_load"),
        gravity=value.pop("gravity"),
    )
    oil = value.pop("oil", None) or oil_at("MIL-PRF-23699", 493.15)
    numerics = {name: value.pop(name) for name in ("slices", "axial_modes", "spin_inertia") if name in value}
    traction = value.pop("traction")
    if isinstance(traction, str):
        traction = TRACTION[traction](oil)
    lubrication = Lubrication(oil=oil, traction=traction, **value)
    return RollerBearing(bearing=bearing, operation=operation, lubrication=lubrication, **numerics)


def eyring(oil, limiting_ratio=0.05, **changes):
    """Eyring law with the Eyring stress that belongs to its limiting stress."""
    stress = {"eyring_stress": 2 * limiting_ratio / oil.pressure_viscosity, **changes}
    return partial(Eyring, limiting_ratio=limiting_ratio, **stress)


TRACTION = {"4109": lambda oil: Regression4109, "eyring": eyring}
