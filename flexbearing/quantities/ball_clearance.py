"""The root attribute of ball and tapered roller bearings with their operating clearance."""

from flexbearing.quantities.attributes import Attribute
from flexbearing.quantities.roller_records import CLEARANCE

CLEARANCE_ATTRIBUTE = Attribute(
    "clearance",
    "json",
    "operating radial clearance, with the steps that led to it when it was computed; absent where nothing "
    "was solved, and of tapered rollers without fits",
    optional=True,
    form=CLEARANCE,
)
