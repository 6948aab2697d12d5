"""Numbers that have a limit, each with it and whether it is met."""

from collections.abc import Iterator

from flexbearing.report.html.document import Cell, Table
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed

DENTING, DENTING_OF_BALLS = 4e9, 4.2e9  # [Pa] static limits of roller and ball bearings by ISO 76
ENDS = {"pressed-end", "sharp-roller-end", "sliced-peak"}  # notes by which slices do not have the peak
_NOT_KNOWN = "not checked: no number"
_NOTE = (
    "A limit of ISO 76 is that of a lasting dent of 1e-4 of the diameter. P_0 is the equivalent static "
    "load, of a radial roller bearing its radial load."
)


def _verdict(met: bool) -> str:
    return "met" if met else "EXCEEDED"


def table(reader: Reader) -> Table:
    """Numbers that have a limit, each with it."""
    rows = [
        row
        for row in (
            *_pressures(reader),
            *_static(reader),
            *_stresses(reader),
            *_films(reader),
            *_clearance(reader),
        )
    ]
    head = ("checked", "value", "unit", "limit", "verdict")
    return Table(
        "Against limits",
        head,
        tuple(rows),
        _NOTE,
    )


def _pressures(reader: Reader) -> Iterator[tuple[Cell, ...]]:
    limit_si = DENTING_OF_BALLS if reader.attributes["kind"].endswith("ball") else DENTING
    limit = reader.units.number(limit_si, "Pa", "MPa", ",.0f", "")
    ends = ENDS & {note["code"] for note in reader.attributes["notes"]}
    for race, number in (reader.summary[reader.last].get("peak_pressure_MPa") or {}).items():
        value = reader.units.number(
            number, "MPa", "MPa", ",.0f", f"summary/{reader.last}/peak_pressure_MPa/{race}"
        )
        verdict = _NOT_KNOWN if number is None else _verdict(number < limit_si / 1e6)
        yield (
            f"Peak contact pressure, {race} raceway",
            value,
            printed(value.unit),
            f"at most {limit.text} (ISO 76)",
            f"{verdict} by slices, not checked at the ends" if ends and verdict == "met" else verdict,
        )


def _static(reader: Reader) -> Iterator[tuple[Cell, ...]]:
    """Static safety, where the bearing has one."""
    number = reader.summary[reader.last].get("static_safety")
    if number is not None:
        value = reader.units.number(number, "", "", ",.2f", f"summary/{reader.last}/static_safety")
        yield "Static safety C_0/P_0", value, "", "at least 1 (ISO 76)", _verdict(number >= 1)


def _stresses(reader: Reader) -> Iterator[tuple[Cell, ...]]:
    for part, found in (reader.attributes.get("stresses") or {}).items():
        for body, most in found["bodies"].items():
            of = f"stresses/{part}/bodies/{body}/von_mises_MPa"
            value = reader.of_attribute(of, "MPa", "MPa", ",.0f")
            limits = _against_yield(reader, most["von_mises_MPa"], yield_stress(reader, part, body))
            yield f"Von Mises stress, {part}: {body}", value, printed(value.unit), *limits
    nominal = reader.summary[reader.last].get("nominal_bar_stress_MPa")
    if nominal is not None:
        of = f"summary/{reader.last}/nominal_bar_stress_MPa"
        value = reader.units.number(nominal, "MPa", "MPa", ",.0f", of)
        limits = _against_yield(reader, nominal, yield_stress(reader, "outer", "bars"))
        yield "Nominal stress of the bars", value, printed(value.unit), *limits


def _against_yield(reader: Reader, stress: float, limit: float | None) -> tuple[str, str]:
    """Yield stress [Pa] of a material and verdict on a stress [MPa]; where none is given, that is said."""
    if limit is None:
        return "–", "not checked: yield stress not given"
    words = f"at most {reader.units.number(limit, 'Pa', 'MPa', ',.0f', '').text} (yield)"
    return words, _verdict(stress * 1e6 < limit)


def yield_stress(reader: Reader, part: str, body: str) -> float | None:
    """Yield stress [Pa] of a body by its name, else of the ring of its part; None where it is not given."""
    materials = reader.attributes["case_si"].get("materials", {})
    named = "shaft" if "shaft" in body else "housing" if "housing" in body else f"{part}_ring"
    return (materials.get(named) or {}).get("yield_stress")


def _films(reader: Reader) -> Iterator[tuple[Cell, ...]]:
    found = reader.summary[reader.last].get("minimum_lambda")
    regimes = (reader.attributes.get("regimes") or {}).get(reader.last, {})
    for race in ("inner", "outer") if found else ():
        of = f"summary/{reader.last}/minimum_lambda/{race}"
        value = reader.units.number(found[race], "", "", ".2f", of)
        yield (
            f"Smallest film ratio Λ, {race} raceway",
            value,
            "",
            "3 (full film)",
            regimes.get(race, _NOT_KNOWN),
        )


def _clearance(reader: Reader) -> Iterator[tuple[Cell, ...]]:
    of_rollers = "ball" not in reader.attributes["case_si"].get("bearing", {})
    if of_rollers and (reader.attributes.get("clearance") or {}).get("operating_m") is not None:
        value = reader.of_attribute("clearance/operating_m", "m", "um", ".3g")
        preload = reader.attributes["clearance"]["operating_m"] < 0
        verdict = "preload: see Clearance" if preload else _verdict(True)
        yield f"Diametral {reader.clearance_words}", value, printed(value.unit), "at least 0", verdict
