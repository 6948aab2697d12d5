"""What the model leaves out that this case touches."""

from collections.abc import Iterator
from typing import Any

from flexbearing.report.html.reader import Reader

_ONE_STATE = (
    "One steady state at constant load and speed: start, shocks, vibrations and load spectra are left out; "
    "a study with a duty cycle adds up the damage of several states."
)
_FATIGUE = (
    "The life is that of rolling contact fatigue: wear, smearing, corrosion, current and the life of grease "
    "are left out."
)


NOT_COMPUTED = (
    "Not computed at all: strength of the cage, creep of rings in their seats, hoop stress of rigid rings by "
    "fit and speed, load on ribs, seals, the speeds at which oil or cage fail, natural frequencies."
)


def simplifications(reader: Reader) -> tuple[str, ...]:
    """Sentences on what is left out, for the keys of the case."""
    if not (reader.of_rollers or reader.of_balls):
        return ()
    case: dict[str, Any] = reader.attributes["case_si"]
    of_family = _of_rollers if reader.of_rollers else _of_balls
    lived = "life_L10" in reader.blocks.get(reader.last, {})
    return (*of_family(case), *_mounting(case), _ONE_STATE, *([_FATIGUE] if lived else []), NOT_COMPUTED)


def _of_rollers(case: dict[str, Any]) -> Iterator[str]:
    yield from _rings({race: case[race]["kind"] for race in ("outer", "inner")})
    yield "No axial load: cylindrical rollers carry radial load and tilt; what ribs bear is left out."
    if case["bearing"]["contact"] == "slices":
        yield (
            "Rollers are cut into slices that do not press each other: pressure at the ends is not resolved "
            '(bearing.contact = "half_space" computes the most loaded roller as a whole).'
        )
    if case["bearing"].get("form_error") is None:
        yield "Raceways are round and rollers are alike: no form errors, no scatter of roller diameters."
    if not case["lubricant"].get("film_heating"):
        inlet = " but for its inlet" if case["lubricant"].get("inlet_heating") else ""
        yield f"The oil film is isothermal{inlet} (lubricant.film_heating = true heats it)."
    if case["life"].get("lubrication") == "a_ISO":
        yield (
            "a_ISO is taken once for the bearing at its reference load; the edition of 2025 of ISO 16281 "
            "takes it slice by slice."
        )


def _of_balls(case: dict[str, Any]) -> Iterator[str]:
    rings = case.get("rings")
    yield from _rings({race: rings[race]["kind"] for race in ("outer", "inner")} if rings else {})
    yield "The cage is left out: balls keep their own orbital speed, and do not push it."
    yield "No oil film is computed: contacts are dry, and oil counts in a_ISO alone, if asked for."
    yield "Races are round and balls are alike: no form errors, no scatter of ball diameters."


def _rings(kinds: dict[str, str]) -> Iterator[str]:
    """Which rings are rigid, and what that leaves out."""
    rigid = [race for race in ("outer", "inner") if kinds.get(race, "rigid") == "rigid"]
    if len(rigid) == 2:
        yield (
            "Both rings are rigid, and so are shaft and housing: no ring bends between the rolling "
            "elements, no housing or shaft gives way. Thin rings and soft housings share the load otherwise."
        )
    elif rigid:
        yield f"The {rigid[0]} ring and what holds it are rigid."


def _mounting(case: dict[str, Any]) -> Iterator[str]:
    """What of fits and temperatures is left open."""
    bearing, operation = case["bearing"], case["operation"]
    fits = bearing.get("fits")
    if fits is None:
        if bearing.get("clearance") is not None:
            yield (
                "The clearance is the one given: fits, temperatures and speed do not change it, and whether "
                "a ring creeps on its seat is not checked."
            )
    else:
        if not _seated(fits.get("housing"), "interference", "tolerance_class"):
            yield (
                "The housing fit is left open: the outer ring is free in its seat, and changes no clearance "
                "but by its temperature."
            )
        if not _seated(fits, "shaft_interference", "shaft"):
            yield "The shaft fit is left open: the inner ring changes no clearance by its seat."
        if not operation.get("temperatures"):
            yield "No temperatures are given: parts are equally warm, and heat changes no clearance."
    if "roller" in bearing and (case["outer"]["kind"], case["inner"]["kind"]) != ("rigid", "rigid"):
        yield "Flexible parts stay linearly elastic: stresses beyond yield change no answer."


def _seated(seat: dict[str, Any] | None, *names: str) -> bool:
    return bool(seat) and any(seat.get(name) is not None for name in names)
