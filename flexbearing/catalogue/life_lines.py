"""The lines of a case that rate its life: oil, ratings of the maker, modified life; for rollers and balls."""

from collections.abc import Iterator

from flexbearing.catalogue.lines import CHOSEN, THUMB, Line, assumed
from flexbearing.catalogue.page import Page


def oil(page: Page) -> Iterator[Line]:
    """The oil and its temperature."""
    if "oil" in page:
        yield Line("lubricant.oil", page["oil"].text, CHOSEN)
    else:
        yield assumed("lubricant.oil", "ISO VG 68", "usual for rolling bearings")
    if "temperature" in page:
        yield Line("lubricant.inlet_temperature", page["temperature"].text)
    else:
        yield assumed("lubricant.inlet_temperature", "70 degC", THUMB)


def life(page: Page) -> Iterator[Line]:
    """Ratings of the maker where they are given, and what modifies the life."""
    why = "of the maker, with these balls" if "balls" in page else "of the maker"
    ratings = {"dynamic_rating": "", "static_rating": "", "fatigue_limit": "_load"}
    for name, ending in ratings.items():
        if name in page:
            yield Line(f"life.{name}{ending}", page[name].text, why)
    yield Line("life.lubrication", "a_ISO", "modified life of ISO 281")
    if "cleanliness" in page:
        yield Line("life.cleanliness", page["cleanliness"].text)
    else:
        yield assumed("life.cleanliness", "oil, in-line filter, -/17/14", "usual cleanliness")
