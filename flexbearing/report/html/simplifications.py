"""What the model leaves out that this case touches."""

from collections.abc import Iterator
from typing import Any

from flexbearing.report.html.clearance import EXPANDED
from flexbearing.report.html.reader import Reader

Item = tuple[str, str]  # what is left out, and who checks it, with what
_STUDY = (
    "designer: a study with a duty cycle adds up the damage of several states; rotor designer: vibrations"
)
_MAKER, _SHAFT = "bearing maker", "shaft or housing designer"
_ANALYST_OF_HEAT = "thermal analyst or a test: temperatures of the parts"
_ONE_STATE = (
    "One steady state at constant load and speed: start, shocks, vibrations and load spectra are left out."
)
_FATIGUE = (
    "The life is that of rolling contact fatigue: wear, smearing, corrosion, current and the life of grease "
    "are left out."
)


NOT_COMPUTED = (
    "Not computed at all: load on ribs, seals, natural frequencies, and the last rows of Not checked here."
)


def simplifications(reader: Reader) -> tuple[Item, ...]:
    """What is left out, for the keys of the case, each with who checks it."""
    if not (reader.of_rollers or reader.of_balls):
        return ()
    case: dict[str, Any] = reader.attributes["case_si"]
    of_family = _of_rollers if reader.of_rollers else _of_balls
    lived = "life_L10" in reader.blocks.get(reader.last, {})
    fatigue = [(_FATIGUE, "lubrication engineer: oil or grease, filter, intervals; service records")]
    never = (NOT_COMPUTED, f"{_MAKER}: ribs and seals; rotor designer: natural frequencies")
    return (*of_family(case), *_mounting(case), (_ONE_STATE, _STUDY), *(fatigue if lived else []), never)


def _of_rollers(case: dict[str, Any]) -> Iterator[Item]:
    yield from _rings({race: case[race]["kind"] for race in ("outer", "inner")})
    yield (
        "No axial load: cylindrical rollers carry radial load and tilt; what ribs bear is left out.",
        f"{_MAKER}: permissible axial load of the ribs",
    )
    if case["bearing"]["contact"] == "slices":
        yield (
            "Rollers are cut into slices that do not press each other: pressure at the ends is not resolved "
            '(bearing.contact = "half_space" computes the most loaded roller as a whole).',
            "the author of the case, with that key",
        )
    if case["bearing"].get("form_error") is None:
        yield (
            "Raceways are round and rollers are alike: no form errors, no scatter of roller diameters.",
            f"{_MAKER}: form and sorting tolerances, then [bearing.form_error]",
        )
    if not case["lubricant"].get("film_heating"):
        inlet = " but for its inlet" if case["lubricant"].get("inlet_heating") else ""
        yield (
            f"The oil film is isothermal{inlet} (lubricant.film_heating = true heats it).",
            "the author of the case, with that key",
        )
    if case["life"].get("lubrication") == "a_ISO":
        yield (
            "a_ISO is taken once for the bearing at its reference load; the edition of 2025 of ISO 16281 "
            "takes it slice by slice.",
            f"{_MAKER}: a life by the edition of 2025",
        )


def _of_balls(case: dict[str, Any]) -> Iterator[Item]:
    rings = case.get("rings")
    yield from _rings({race: rings[race]["kind"] for race in ("outer", "inner")} if rings else {})
    yield (
        "The cage is left out: balls keep their own orbital speed, and do not push it.",
        f"{_MAKER}: cage and its limiting speed",
    )
    yield (
        "No oil film is computed: contacts are dry, and oil counts in a_ISO alone, where it is computed.",
        "lubrication engineer: film ratio at the temperature of the oil",
    )
    yield (
        "Races are round and balls are alike: no form errors, no scatter of ball diameters.",
        f"{_MAKER}: form and sorting tolerances",
    )


def _rings(kinds: dict[str, str]) -> Iterator[Item]:
    """Which rings are rigid, and what that leaves out."""
    rigid = [race for race in ("outer", "inner") if kinds.get(race, "rigid") == "rigid"]
    if len(rigid) == 2:
        yield (
            "Both rings are rigid, and so are shaft and housing: no ring bends between the rolling "
            "elements, no housing or shaft gives way. Thin rings and soft housings share the load otherwise.",
            f"{_SHAFT}: stiffness of seats and housing, or a case with flexible rings",
        )
    elif rigid:
        yield (
            f"The {rigid[0]} ring and what holds it are rigid.",
            f"{_SHAFT}: stiffness of its seat, or a case with both rings flexible",
        )


def _mounting(case: dict[str, Any]) -> Iterator[Item]:
    """What of fits and temperatures is left open."""
    bearing, operation = case["bearing"], case["operation"]
    fits, warm = bearing.get("fits"), "roller" in bearing and operation.get("temperatures")
    if fits is None:
        if bearing.get("clearance") is not None:
            yield (
                "The clearance is the one given: fits, temperatures and speed do not change it, and whether "
                f"a ring creeps on its seat is not checked.{f' {EXPANDED}' if warm else ''}",
                "designer: clearance after fits and heat, by [bearing.fits] with a clearance before mounting",
            )
    else:
        if not _seated(fits.get("housing"), "interference", "tolerance_class"):
            yield (
                "The housing fit is left open: the outer ring is free in its seat, and changes no clearance "
                "but by its temperature.",
                "designer: bearing.fits.housing",
            )
        if not _seated(fits, "shaft_interference", "shaft"):
            yield (
                "The shaft fit is left open: the inner ring changes no clearance by its seat.",
                "designer: bearing.fits.shaft",
            )
        if not operation.get("temperatures"):
            yield (
                "No temperatures are given: parts are equally warm, and heat changes no clearance.",
                _ANALYST_OF_HEAT,
            )
    if "roller" in bearing and (case["outer"]["kind"], case["inner"]["kind"]) != ("rigid", "rigid"):
        yield (
            "Flexible parts stay linearly elastic: stresses beyond yield change no answer.",
            "stress analyst: stresses against the yield stress of the material",
        )


def _seated(seat: dict[str, Any] | None, *names: str) -> bool:
    return bool(seat) and any(seat.get(name) is not None for name in names)
