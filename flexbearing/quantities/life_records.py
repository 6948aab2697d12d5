"""Root attributes of every bearing that has a rating life, and what they hold."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
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
    of_class,
)

ROLLER_BODY = "roller body"  # factor of rollers that fail too
BY_LOADS = "load"  # effect of a factor that changes loads or capacities, not the life


@dataclass(frozen=True)
class Factor:
    """A factor of a life."""

    name: str
    value: float
    effect: str
    note: str
    life_exponent: float | None = None  # how it grows with the life it multiplies; None: not known

    @property
    def growth(self) -> float | None:
        """Its exponent; those that loads and capacities have do not follow the life."""
        return 0.0 if self.effect == BY_LOADS else self.life_exponent


@dataclass(frozen=True)
class FactoredLife:
    """The basic life of a state [10^6 revolutions], and what its factors make of it."""

    basic_Mrev: float  # noqa: N815
    factors: list[Factor]
    modified_Mrev: float | None = None  # noqa: N815  # None where a factor does not hold


def factored_lives(stored: Mapping[str, Any]) -> dict[str, FactoredLife]:
    """Lives of the attribute `life` by block."""
    return {
        block: FactoredLife(**{**life, "factors": [Factor(**each) for each in life["factors"]]})
        for block, life in stored.items()
    }


@dataclass(frozen=True)
class Stage:
    """A life on the way from that of a catalogue to that of the case."""

    name: str
    settings: list[str]  # "key=value" with which `run` computes this life
    left_out_by: list[str]  # those that leave out what it is named after
    life_Mrev: float  # noqa: N815
    life_h: float
    factor: float | None  # over the life before
    meaning: str = ""  # of what it is named after


@dataclass(frozen=True, kw_only=True)
class Ratings:
    """What a catalogue's page says of a bearing, and what it says of the load."""

    ratings_N: dict[str, float]  # noqa: N815
    given: list[str]  # those that the case gives
    scales: dict[str, float] = field(default_factory=dict)  # of given ones, by settings that change sizes
    formulas_N: dict[str, float | None]  # noqa: N815
    load_N: float  # noqa: N815
    equivalent_load: dict[str, Any] | None = None  # of balls: what it is made of
    static_safety: float
    life_Mrev: float  # noqa: N815
    life_h: float
    viscosity_ratio: float | None = None  # of the oil, and what follows of it, where a_ISO counts
    a_ISO: float | None = None  # noqa: N815
    modified_Mrev: float | None = None  # noqa: N815
    modified_h: float | None = None

    def stored(self) -> dict[str, Any]:
        """The same as JSON can hold it."""
        return {name: value for name, value in asdict(self).items() if value is not None}


BLOCKS = "rigid or flexible"
RATINGS = ("C_r", "C_0r", "C_u")
MODIFIED = {"a_ISO", "modified_Mrev", "modified_h"}  # all of them with a viscosity ratio, or none


def _same_factors(lives: Any) -> bool:
    return len({tuple(factor["name"] for factor in life["factors"]) for life in lives.values()}) <= 1


LIFE: Form = Such(
    Each(BLOCKS, of_class(FactoredLife, factors=ListOf(of_class(Factor)), modified_Mrev=NUMBER)),
    _same_factors,
    "with the same factors in every block",
)
_TEXTS = ListOf(TEXT)
_EQUIVALENT = ("F_r_N", "F_a_N", "P_0_N", "e", "X", "Y", "X_0", "Y_0")


def _whole(found: Any) -> bool:
    modified = MODIFIED & set(found["ratings"])
    return bool(found["stages"]) and (not modified or {"viscosity_ratio", *MODIFIED} <= set(found["ratings"]))


_RATINGS = of_class(
    Ratings,
    ratings_N=Record(dict.fromkeys(RATINGS, NUMBER)),
    given=_TEXTS,
    scales=Record({}, optional=dict.fromkeys(RATINGS, NUMBER)),
    formulas_N=Record(dict.fromkeys(RATINGS, NUMBER_OR_NULL)),
    equivalent_load=Record({"note": TEXT} | dict.fromkeys(_EQUIVALENT, NUMBER), further=NUMBER),
    **dict.fromkeys(("viscosity_ratio", *MODIFIED), NUMBER),
)
_STAGES = ListOf(of_class(Stage, settings=_TEXTS, left_out_by=_TEXTS))
_CATALOGUE: Form = Record({"title": TEXT, "ratings": _RATINGS, "stages": _STAGES})
CATALOGUE_LIFE: Form = Such(
    _CATALOGUE, _whole, "with a first life, and a modified life with all it comes from"
)
LIFE_ATTRIBUTE = Attribute(
    "life", "json", "factors of [life] with value and note, and the modified life; by block", form=LIFE
)
RULE_ATTRIBUTE = Attribute(
    "life_rule",
    "text",
    "rules that the lives of the case are computed by, with their editions; absent without a life, and in "
    "results of older versions",
    optional=True,
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
