"""Steel bearings of the textbooks, for static load distributions."""

from math import pi

from quasidynamic import Cage, CylindricalRollerBearing, Material, Roller

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850)


def material_of(coefficient) -> Material:
    """Material for which Palmgren's law reads delta = coefficient Q^0.9 / l^0.8 (N, mm)."""
    pair = (coefficient / 3.81) ** (1 / 0.9)  # 2 (1 - nu^2) / (pi E) [mm2/N]
    return Material(youngs_modulus=2e6 * (1 - 0.3**2) / (pi * pair), poisson_ratio=0.3, density=7850)


PALMGREN_STEEL = material_of(3.84e-5)


def steel_bearing(rollers, clearance=0.0, **changes) -> CylindricalRollerBearing:
    """Rollers of 10 x 10 mm where nothing else is said; on a larger circle if they need one."""
    value = {"diameter": 10e-3, "length": 10e-3, "material": STEEL, "contact_law": "palmgren", **changes}
    diameter, material = value["diameter"], value["material"]
    return CylindricalRollerBearing(
        rollers=rollers,
        outer_raceway_diameter=value.get("outer_raceway", diameter * max(7.5, rollers / 2)),
        clearance=clearance,
        roller=Roller(diameter=diameter, length=value["length"], material=material),
        cage=Cage(guidance="rollers", pocket_friction=0.0, thickness=diameter / 2, mass=0.1),
        inner_ring=material,
        outer_ring=material,
        contact_law=value["contact_law"],
    )
