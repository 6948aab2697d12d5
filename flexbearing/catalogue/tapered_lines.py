"""The lines of a case of a tapered, thrust or spherical roller bearing between rigid rings."""

from collections.abc import Iterator
from math import asin, degrees, sin

from flexbearing.catalogue.lines import (
    CHOSEN,
    THUMB,
    Line,
    assumed,
    entry,
    life,
    materials,
    mm,
    mounting,
    oil,
    rollers_of,
    speeds,
    surroundings,
)
from flexbearing.catalogue.page import Page
from flexbearing.catalogue.roller_set import RollerSet
from flexbearing.catalogue.tapered_set import BARRELS, CONES, WASHERS
from quasidynamic.parts.tapered_bearing import apex_angles

# Rules of thumb, assumed: usual are spheres of 0.9 to 0.98 of the distance to the apex, contacts at 0.6 to
# 0.8 of the radius of the end.
END, DEPTH = 0.94, 0.7
OSCULATION = 0.97  # as another program has it (MESYS, manual: radii 0.5 and 0.485 of the sphere's diameter)


def lines(page: Page, found: RollerSet) -> list[Line]:
    """Lines of a case."""
    parts = (
        _bearing(page, found),
        _rib(page, found) if page.like == "tapered_roller" else (),
        materials(page),
        surroundings(page),
        oil(page),
        _operation(page),
        life(page),
    )
    return [Line("kind", page.like), *(line for part in parts for line in part)]


def _bearing(page: Page, found: RollerSet) -> Iterator[Line]:
    usual, lengths, thick = "filling the pitch circle", "0.5 to 0.8 B", f"{CONES:g} (D - d)/2"
    if "angle" not in page:
        usual, lengths, thick = "at a usual spacing", "0.5 to 0.8 (D - d)/2", f"{WASHERS:g} B"
    if spherical := page.like == "spherical_roller":
        lengths, thick = "0.25 to 0.4 B", f"{BARRELS:g} (D - d)/2"
    number, length = rollers_of(page, found, usual, lengths)
    yield number
    if "pitch_diameter" in page:
        yield entry(page, "pitch_diameter", "bearing.pitch_diameter")
    else:
        yield assumed("bearing.pitch_diameter", mm(found.pitch), "(d + D)/2")
    if "angle" in page:
        key = "bearing.contact_angle" if spherical else "bearing.cup_angle"
        yield entry(page, "angle", key, "tan = e/1.5 of the catalogue")
    yield Line("bearing.contact_law", "iso16281", "as the life, ISO/TS 16281")
    if "diameter" in page:
        yield entry(page, "diameter", "bearing.roller.diameter")
    else:
        yield assumed("bearing.roller.diameter", mm(found.diameter), f"{THUMB}, {thick}")
    yield length
    if spherical:
        yield from _osculation(page)
    else:
        yield assumed("bearing.roller.profile", "iso16281", "taken by ISO/TS 16281")
    yield from mounting(page)


def _osculation(page: Page) -> Iterator[Line]:
    for race in ("outer", "inner"):
        yield assumed(f"bearing.{race}_osculation", OSCULATION, "usual of spherical roller bearings")
    if "clearance" not in page:
        yield assumed("bearing.clearance", "0 um", f"{THUMB}, at the temperature of operation")


def _rib(page: Page, found: RollerSet) -> Iterator[Line]:
    """A rib that the spheres of the roller ends touch well inside."""
    _, length = found.chosen
    axis, _ = apex_angles(page["angle"].si, found.diameter / found.pitch)
    radius = END * (found.pitch / (2 * sin(axis)) + length / 2)
    angle = axis - asin(DEPTH * found.diameter / 2 / radius)
    why = f"{THUMB}, {DEPTH:g} of the radius of the roller's end"
    yield assumed("bearing.rib.angle", f"{degrees(angle):.4g} deg", why)
    yield assumed("bearing.rib.end_radius", mm(radius), f"{THUMB}, {END:g} of the distance to the apex")
    yield assumed("bearing.rib.friction", 0.05, THUMB)


def _operation(page: Page) -> Iterator[Line]:
    yield from speeds(page)
    if "axial" in page:
        yield entry(page, "axial", "operation.load.axial", CHOSEN)
    if "load" in page:
        yield entry(page, "load", "operation.load.radial_z", CHOSEN)
    if page.like != "spherical_roller":
        yield assumed("operation.tilt", "fixed", "a stiff shaft keeps the inner ring straight")
