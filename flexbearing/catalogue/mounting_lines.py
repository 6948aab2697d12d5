"""The lines of a case that say how a bearing is mounted, of rollers and balls alike."""

from collections.abc import Iterator

from flexbearing.catalogue.lines import CHOSEN, THUMB, Line, assumed, mm
from flexbearing.catalogue.page import Page


def mounting(page: Page) -> Iterator[Line]:
    """Clearance in operation, or before mounting with the fits that change it."""
    if "clearance" in page:
        yield Line("bearing.clearance", page["clearance"].text, "in operation")
    elif page.like != "angular_contact_ball":  # which has a contact angle instead
        yield _clearance_class(page)
    if not _fitted(page):
        return
    if "shaft" in page:
        yield Line("bearing.fits.shaft", page["shaft"].text, CHOSEN)
    else:
        yield assumed("bearing.fits.shaft", "k5", f"{THUMB} for a rotating inner ring")
    yield Line("bearing.fits.bore", page["bore"].text)
    yield Line("bearing.fits.at", "mean", "the middle of all tolerance classes")
    if page.like != "squirrel_cage":
        yield Line("bearing.fits.outer_diameter", page["outside"].text)
    if "housing" in page:
        yield Line("bearing.fits.housing.tolerance_class", page["housing"].text, CHOSEN)
        why = f"{THUMB}, 1.5 times that of the bearing"
        yield assumed("bearing.fits.housing.diameter", mm(1.5 * page["outside"].si), why)


def surroundings(page: Page) -> Iterator[Line]:
    """Materials of shaft and housing, where fits need them."""
    if _fitted(page):
        yield assumed("materials.shaft", "structural steel", "the usual")
    if _fitted(page) and "housing" in page:
        yield assumed("materials.housing", "grey cast iron", "the usual")


def _fitted(page: Page) -> bool:
    """Whether the fits of the rings count."""
    if page.like == "angular_contact_ball":
        return "shaft" in page or "housing" in page
    return "clearance" not in page


def _clearance_class(page: Page) -> Line:
    if "clearance_class" in page:
        return Line(
            "bearing.clearance_class", page["clearance_class"].text, "chosen among those of ISO 5753-1"
        )
    why = "bearings without suffix have the Normal class"
    return assumed("bearing.clearance_class", "CN", why)
