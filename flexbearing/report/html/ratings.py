"""Load ratings of a bearing, and the viscosity ratio of its oil."""

from math import inf, pi

from flexbearing.quantities.life_records import Ratings
from flexbearing.report.catalogue_life import scaled
from flexbearing.report.html.document import Cell, Number
from flexbearing.report.html.reader import Reader, once
from flexbearing.report.html.units import printed

NAMES = {"C_r": "dynamic rating C_r", "C_0r": "static rating C_0", "C_u": "fatigue limit load C_u"}
KEYS = {"C_r": "life.dynamic_rating", "C_0r": "life.static_rating", "C_u": "life.fatigue_limit_load"}
_STANDARDS = {"C_r": "ISO 281", "C_0r": "ISO 76", "C_u": "ISO 281, from C_0"}
BY_A_ISO = (  # for any cleanliness: κ does not depend on it
    "life.lubrication=a_ISO",
    "life.cleanliness=oil, in-line filter, -/17/14",
)


@once
def found(reader: Reader) -> tuple[Ratings, str] | str:
    """Ratings with their place in the file, or why there are none."""
    stored = reader.attributes.get("catalogue_life")
    if stored:
        return Ratings(**stored["ratings"]), "attributes/catalogue_life/ratings"
    catalogue = reader.result.family.catalogue
    if catalogue is None:
        return "ISO 281 and ISO 76 do not rate this kind"
    try:
        case, known = reader.case, catalogue()
        known.require_load(case)
        return known.rated(case).page(_hours(reader)), "ratings"
    except ValueError as problem:  # a refused case, or a formula outside its range
        return str(problem).splitlines()[0].rstrip(".")


def _hours(reader: Reader) -> float:
    """Hours that a million revolutions take."""
    speed = abs(float(reader.blocks.get(reader.last, {}).get("relative_speed", 0.0)))
    return 1e6 * 2 * pi / speed / 3600 if speed else inf


@once
def viscosity_ratio(reader: Reader) -> Number | None:
    """Viscosity ratio of ISO 281, also where the life does not use it; None without an oil, or at rest."""
    known, catalogue = found(reader), reader.result.family.catalogue
    if isinstance(known, str) or catalogue is None:
        return None
    rated, at = known
    if rated.viscosity_ratio is not None:
        return reader.units.number(rated.viscosity_ratio, "", "", ".3g", f"{at}/viscosity_ratio")
    try:
        kappa = catalogue().rated(reader.case_with(BY_A_ISO)).rated_kappa
    except ValueError:  # no oil in the case, or one outside its data
        return None
    return None if kappa is None else reader.units.number(kappa, "", "", ".3g", "viscosity_ratio")


def rows(reader: Reader) -> list[tuple[Cell, ...]]:
    """Each rating that is used, with its unit and its source."""
    known = found(reader)
    if isinstance(known, str):
        return []
    rated, at = known
    numbers = {
        name: reader.units.number(rating, "N", "kN", ",.4g", f"{at}/ratings_N/{name}")
        for name, rating in rated.ratings_N.items()
    }
    return [
        (NAMES[name], number, printed(number.unit),
         f"given{scaled(rated, name)}" if name in rated.given else f"formula of {_STANDARDS[name]}")
        for name, number in numbers.items()
    ]  # fmt: skip
