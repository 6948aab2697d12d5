"""Root attributes of every bearing that has a rating life."""

from typing import Any

from flexbearing.quantities.attributes import Attribute
from flexbearing.quantities.forms import (
    NUMBER,
    NUMBER_OR_NULL,
    TEXT,
    Each,
    Form,
    ListOf,
    Record,
    Such,
)

BLOCKS = "rigid or flexible"
RATINGS = ("C_r", "C_0r", "C_u")
MODIFIED = {"a_ISO", "modified_Mrev", "modified_h"}  # all of them with a viscosity ratio, or none


_FACTOR = Record(
    {"name": TEXT, "value": NUMBER, "effect": TEXT, "note": TEXT}, optional={"life_exponent": NUMBER_OR_NULL}
)


def _same_factors(lives: Any) -> bool:
    return len({tuple(factor["name"] for factor in life["factors"]) for life in lives.values()}) <= 1


LIFE: Form = Such(
    Each(
        BLOCKS,
        Record(
            {
                "basic_Mrev": NUMBER,
                "factors": ListOf(_FACTOR),
            },
            optional={"modified_Mrev": NUMBER},
        ),
    ),
    _same_factors,
    "with the same factors in every block",
)
_SETTINGS = ListOf(TEXT)
_EQUIVALENT = ("F_r_N", "F_a_N", "P_0_N", "e", "X", "Y", "X_0", "Y_0")


def _whole(found: Any) -> bool:
    modified = MODIFIED & set(found["ratings"])
    return bool(found["stages"]) and (not modified or {"viscosity_ratio", *MODIFIED} <= set(found["ratings"]))


_CATALOGUE: Form = Record(
    {
        "title": TEXT,
        "ratings": Record(
            {
                "ratings_N": Record(dict.fromkeys(RATINGS, NUMBER)),
                "given": ListOf(TEXT),
                "formulas_N": Record(dict.fromkeys(RATINGS, NUMBER_OR_NULL)),
                "load_N": NUMBER,
                "static_safety": NUMBER,
                "life_Mrev": NUMBER,
                "life_h": NUMBER,
            },
            optional={
                "scales": Record({}, optional=dict.fromkeys(RATINGS, NUMBER)),
                "equivalent_load": Record(
                    {"note": TEXT} | dict.fromkeys(_EQUIVALENT, NUMBER), further=NUMBER
                ),
            }
            | dict.fromkeys(("viscosity_ratio", *sorted(MODIFIED)), NUMBER),
        ),
        "stages": ListOf(
            Record(
                {
                    "name": TEXT,
                    "settings": _SETTINGS,
                    "left_out_by": _SETTINGS,
                    "life_Mrev": NUMBER,
                    "life_h": NUMBER,
                    "factor": NUMBER_OR_NULL,
                },
                optional={"meaning": TEXT},
            )
        ),
    }
)
CATALOGUE_LIFE: Form = Such(
    _CATALOGUE, _whole, "with a first life, and a modified life with all it comes from"
)
LIFE_ATTRIBUTE = Attribute(
    "life", "json", "factors of [life] with value and note, and the modified life; by block", form=LIFE
)
CATALOGUE_ATTRIBUTE = Attribute(
    "catalogue_life",
    "json",
    "ratings of a catalogue, and every life from the one it computes to that of the case, with the settings "
    "that give it and its factor over the life before, as `flexbearing life` prints it; absent without "
    "outputs.catalogue_life",
    optional=True,
    form=CATALOGUE_LIFE,
)
