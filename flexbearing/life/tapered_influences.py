"""What the life of a tapered roller bearing has that a catalogue leaves out."""

from flexbearing.case.roller.profile import SHAPES
from flexbearing.life import tapered_lives
from flexbearing.life.against_catalogue import (
    LUBRICATION,
    RELIABILITY,
    Catalogue,
    Influence,
    require_known_forces,
)

WEIGHTLESS = "0.001 kg/m^3"  # of rollers without inertia
RATING = (
    Influence(
        "ISO 281: (C_r/P)^(10/3), P = X F_r + Y F_a",
        {"life.loads": "rating"},
        "One load P replaces radial and axial load; nothing else of the case counts.",
    ),
    Influence(
        "loads of all slices of straight rollers, without inertia or tilt",
        {},
        "The loads of all slices instead of one load P, with the exponent 4 of lines and without the factor "
        "0.83 of C_r for loads that are uneven along the rollers.",
    ),
)
_SPHERICAL = Influence(
    "loads of all slices of the barrels, without inertia",
    {},
    "The loads of all slices of both rows instead of one load P, with the exponent 4 of lines and without "
    "the factor 0.83 of C_r for loads that are uneven along the rollers.",
)
_SHAPE = (
    Influence(
        "profile of rollers and raceways",
        {
            "bearing.roller.profile": "straight",
            **{f"bearing.roller.{name}": "" for name in SHAPES},
            "bearing.inner_raceway": "",
            "bearing.outer_raceway": "",
        },
        "A profile takes load from the ends to the middle of the rollers.",
    ),
    Influence(
        "tilt of the inner ring",
        {
            "operation.tilt": "fixed",
            **{f"operation.load.moment_{axis}": "" for axis in "yz"},
            **{f"operation.displacement.tilt_{axis}": "" for axis in "yz"},
        },
        "A ring that turns, or is held askew, presses the rollers at one end.",
    ),
)
_FURTHER = (
    Influence(
        "inertia of the rollers at speed",
        {"materials.roller.density": WEIGHTLESS},
        "Centrifugal forces press the rollers to the cup and a rib.",
    ),
    LUBRICATION,
    RELIABILITY,
)


CATALOGUE = Catalogue(RATING, lambda case: (*_SHAPE, *_FURTHER), require_known_forces, tapered_lives.rated)
SPHERICAL = Catalogue(
    (RATING[0], _SPHERICAL), lambda case: _FURTHER, require_known_forces, tapered_lives.rated
)
