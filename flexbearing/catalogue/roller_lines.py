"""The lines of a case of a cylindrical roller bearing, between rigid rings or in a squirrel cage."""

from collections.abc import Iterator

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

# Of Mao, Wang and Zhang (2016), who give the thickness of the ring and the length of the bars alone.
CAGE = {"bar_width": 4 / 75, "bar_thickness": 2.6 / 3.6, "bar_length": 10.25 / 10, "flange_length": 5 / 10}


def lines(page: Page, rollers: RollerSet) -> list[Line]:
    """Lines of a case."""
    cage = page.like == "squirrel_cage"
    rings = _squirrel_cage(page, rollers) if cage else [Line("outer.kind", "rigid")]
    parts = (
        _bearing(page, rollers),
        mounting(page),
        materials(page),
        surroundings(page),
        oil(page),
        _film(),
        _operation(page, cage),
        rings,
        [Line("inner.kind", "rigid")],
        life(page),
        _reference_life(),
    )
    return [line for part in parts for line in part]


def _bearing(page: Page, rollers: RollerSet) -> Iterator[Line]:
    number, length = rollers_of(page, rollers, "at a usual spacing", "0.4 to 0.7 B")
    yield Line("bearing.kind", "cylindrical_roller")
    yield number
    if "outer_raceway" in page:
        yield entry(page, "outer_raceway", "bearing.outer_raceway_diameter", "E of the catalogue")
    else:
        raceway = f"{1e3 * rollers.outer_raceway:.9g} mm"
        guessed = "diameter" in page.assumed
        yield Line("bearing.outer_raceway_diameter", raceway, "F + 2 D_w", assumed=guessed)
    yield Line("bearing.contact_law", "iso16281", "as the life, ISO/TS 16281")
    if "diameter" in page:
        yield entry(page, "diameter", "bearing.roller.diameter")
    else:
        yield Line("bearing.roller.diameter", f"{1e3 * rollers.diameter:.9g} mm", "(E - F)/2")
    yield length
    yield assumed("bearing.roller.profile", "iso16281", "taken by ISO/TS 16281")
    yield assumed("bearing.cage.guidance", "rollers", "usual of catalogue bearings")
    yield assumed("bearing.cage.pocket_friction", 0.05, THUMB)
    yield assumed("bearing.cage.thickness", mm(0.5 * rollers.diameter), f"{THUMB}, half a roller diameter")


def _film() -> Iterator[Line]:
    """Laws of the film, beside the oil."""
    why = "a law for any oil; the default is fitted to one of turbines"
    yield assumed("lubricant.traction", "eyring", why)
    yield assumed("lubricant.limiting_ratio", 0.05, THUMB)
    yield assumed("lubricant.oil_fraction", 0.02, THUMB)


def _reference_life() -> Iterator[Line]:
    yield Line("life.capacity", "iso281", "life by ISO/TS 16281, with C of the maker where it is given")
    yield Line("life.edge_stress", True)
    yield Line("accuracy.slices", 30, "as many as ISO/TS 16281 requires beside the edge stress")


def _operation(page: Page, cage: bool) -> Iterator[Line]:
    yield entry(page, "load", "operation.radial_load", CHOSEN)
    yield from speeds(page)
    if cage:
        yield assumed("operation.tilt", "fixed", "a stiff shaft keeps the inner ring straight")
    else:
        why = "a straight shaft, with seats in line"
        yield assumed("operation.misalignment", "0 arcmin", why)


def _squirrel_cage(page: Page, rollers: RollerSet) -> Iterator[Line]:
    """A ring on bars in the proportions of a published one."""
    paper = "as in the bearing of Mao, Wang and Zhang (2016)"
    thickness, width = (page["outside"].si - rollers.outer_raceway) / 2, page["width"].si
    yield Line("outer.kind", "squirrel_cage")
    yield Line("outer.thickness", f"{1e3 * thickness:.9g} mm", "(D - E)/2")
    yield Line("outer.width", page["width"].text, "B of the catalogue")
    yield assumed("outer.bars", 24, f"{paper}, assumed there")
    for name, whole, of in (
        ("bar_width", rollers.outer_raceway, "E"),
        ("bar_thickness", thickness, "the thickness"),
        ("bar_length", width, "B"),
        ("flange_length", width, "B"),
    ):
        share = CAGE[name]
        yield assumed(f"outer.{name}", mm(share * whole), f"{share:.3g} of {of}, {paper}")
