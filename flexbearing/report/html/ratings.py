"""Load ratings of a bearing and the loads that they are compared with."""

from collections.abc import Iterator
from math import inf, pi
from typing import Any

from flexbearing.report.html import assumed_effects
from flexbearing.report.html.document import Cell, Number, Table
from flexbearing.report.html.reader import Reader, once
from flexbearing.report.html.units import printed

_NAMES = {
    "C_r": "dynamic load rating C_r",
    "C_0r": "static load rating C_0",
    "C_u": "fatigue load limit C_u",
}
_KEYS = {"C_r": "dynamic_rating", "C_0r": "static_rating", "C_u": "fatigue_limit_load"}
_STANDARDS = {"C_r": "ISO 281", "C_0r": "ISO 76", "C_u": "ISO 281, from C_0"}
APART = 0.05  # of a rating from its formula that is worth a remark
_WARMER = (-20.0, -10.0, 0.0, 10.0, 20.0)  # [K]
_AT_P = " a_ISO and L10m at the load P are those of the catalogue."
_OF_CASE = (
    " The last column is the life of this case: solved again at the temperatures of its effects, "
    "at others its life without a_ISO times a_ISO at its own equivalent load, loads kept."
)
BY_A_ISO = (  # for any cleanliness: κ does not depend on it
    "life.lubrication=a_ISO",
    "life.cleanliness=oil, in-line filter, -/17/14",
)
_STORED = "attributes/catalogue_life/ratings"


def table(reader: Reader) -> Table | str:
    """Ratings of ISO 281 and ISO 76, those of the case first."""
    known = found(reader)
    return known if isinstance(known, str) else _laid_out(reader, *known)


@once
def found(reader: Reader) -> tuple[dict[str, Any], str] | str:
    """Ratings with their place in the file, or why there are none."""
    stored = reader.attributes.get("catalogue_life")
    if stored:
        return stored["ratings"], _STORED
    catalogue = reader.result.family.catalogue
    if catalogue is None:
        return "ISO 281 and ISO 76 have no ratings for this kind of bearing."
    try:
        case, known = reader.case, catalogue()
        known.require_load(case)
        return known.ratings(case, _hours(reader)), "ratings"
    except ValueError as problem:  # a refused case, or a formula outside its range
        return f"No load ratings: {str(problem).splitlines()[0]}"


def _hours(reader: Reader) -> float:
    """Hours that a million revolutions take."""
    speed = abs(float(reader.blocks[reader.last].get("relative_speed", 0.0)))
    return 1e6 * 2 * pi / speed / 3600 if speed else inf


def at_other_temperatures(reader: Reader, sufficient: int | None = None) -> Iterator[Table]:
    """Viscosity ratio with warmer and colder oil, and lives where they have an a_ISO; by formulas."""
    if viscosity_ratio(reader) is None:
        return
    given = reader.attributes["case_si"]["lubricant"]["inlet_temperature"]
    known = found(reader)
    modified = not isinstance(known, str) and "a_ISO" in known[0]
    steps = [*_WARMER, *([] if sufficient is None else [sufficient + 273.15 - given])]
    rows = [row for step in sorted(set(steps)) if (row := _with_oil(reader, given, step, modified))]
    head, note = ["oil at the inlets", "viscosity ratio κ"], "By the formulas of ISO 281."
    if modified:
        head += ["a_ISO at P", "L10m, ISO 281 [10⁶ revolutions]"]
        note += _AT_P
    if rows and len(rows[0]) > len(head):
        head.append("modified life of this case [h]")
        note += _OF_CASE
    yield Table("Viscosity ratio at other oil temperatures", tuple(head), tuple(rows), note)


def _with_oil(reader: Reader, given: float, step: float, modified: bool) -> tuple[Cell, ...]:
    """A row with oil so much warmer [K]; empty where its data do not reach there."""
    asked = f"{given + step:.6g}"
    rated = with_oil_at(reader, asked, *(() if modified else BY_A_ISO))
    if rated is None or (modified and "a_ISO" not in rated):
        return ()
    oil = reader.units.number(given + step, "K", "degC", ".4g", "")
    mark = "" if step in _WARMER and step else " (this case)" if step == 0 else " (κ = 1)"
    label = f"{oil.text} {printed(oil.unit)}{mark}"
    place = f"ratings_at/{asked}"
    ratio = reader.units.number(rated["viscosity_ratio"], "", "", ".3g", f"{place}/viscosity_ratio")
    if not modified:
        return label, ratio
    factor = reader.units.number(rated["a_ISO"], "", "", ".3g", f"{place}/a_ISO")
    life = reader.units.number(rated["modified_Mrev"], "Mrev", "Mrev", ",.4g", f"{place}/modified_Mrev")
    hours = _own_hours(reader, asked, f"{given + step - 273.15:.6g} degC")
    return (label, ratio, factor, life) if hours is None else (label, ratio, factor, life, hours)


def _own_hours(reader: Reader, kelvin: str, written: str) -> Number | None:
    """Modified life of the case with oil of a temperature: as solved again, else with its loads kept."""
    own = own_life_at(reader, kelvin)
    if own is None:
        return None
    solved = assumed_effects.solved_again(reader, "lubricant.inlet_temperature", written)
    if solved is None:
        return reader.units.number(own * _hours(reader), "h", "h", ",.4g", f"own_life_at/{kelvin}")
    life = f"outputs/{reader.last}.modified_life [h]"
    hours = solved[0] * float(reader.result[life.partition("/")[2]].number)
    return reader.units.number(hours, "h", "h", ",.3g", f"times/{solved[1]}|{life}")


def _equivalent_load(reader: Reader) -> float | None:
    """Load [N] whose rating life is the reference life of rollers; None without one."""
    known, block = found(reader), reader.blocks.get(reader.last, {})
    reference = float(block.get("reference_life", inf)) / 1e6
    if isinstance(known, str) or not reader.of_rollers or not 0 < reference < inf:
        return None
    return known[0]["ratings_N"]["C_r"] * reference**-0.3


def own_life_at(reader: Reader, kelvin: str) -> float | None:
    """Modified life [10^6 revolutions] of the case with oil of a temperature, under its own loads.

    None where it has no reference life by ISO/TS 16281, or its modified life no a_ISO.
    """
    load, life = _equivalent_load(reader), (reader.attributes.get("life") or {}).get(reader.last) or {}
    of_oil = [factor["value"] for factor in life.get("factors", ()) if factor["name"] == "a_ISO"]
    rated = None if load is None else with_oil_at(reader, kelvin, f"operation.radial_load={load!r} N")
    if rated is None or not of_oil or "a_ISO" not in rated:
        return None
    return life["modified_Mrev"] / of_oil[0] * rated["a_ISO"]


def viscosity_ratio(reader: Reader) -> tuple[float, str] | None:
    """Viscosity ratio of the oil, with its place, also where the life does not use it; None without one."""
    known, catalogue = found(reader), reader.result.family.catalogue
    if isinstance(known, str) or catalogue is None:
        return None
    if "viscosity_ratio" in known[0]:
        return known[0]["viscosity_ratio"], f"{known[1]}/viscosity_ratio"
    try:
        kappa = catalogue().viscosity_ratio(reader.case_with(BY_A_ISO))
    except ValueError:  # no oil in the case, or one outside its data
        return None
    return None if kappa is None else (kappa, "viscosity_ratio")


def with_oil_at(reader: Reader, kelvin: str, *further: str) -> dict[str, Any] | None:
    """Ratings of the case with oil of a temperature; None where its data do not reach there."""
    assert reader.result.family.catalogue is not None
    try:
        case = reader.case_with([f"lubricant.inlet_temperature={kelvin} K", *further])
        return reader.result.family.catalogue().ratings(case, _hours(reader))
    except ValueError:
        return None


def _formula(reader: Reader, name: str) -> str:
    """Which formula gives a rating, with its dimensions."""
    bearing = reader.bearing
    if not reader.of_rollers:
        return f"formula of {_STANDARDS[name]}"
    size, length = (
        reader.units.number(bearing["roller"][key], "m", "mm", ".4g", "") for key in ("diameter", "length")
    )
    pitch = bearing["outer_raceway_diameter"] - bearing["roller"]["diameter"]
    of_rollers = f"Z = {bearing['rollers']}, D_we = {size.text}, L_we = {length.text}"
    row = reader.units.number(pitch, "m", "mm", ".4g", "")
    return f"formula of {_STANDARDS[name]}: {of_rollers}, D_pw = {row.text} {printed(row.unit)}, one row"


def _laid_out(reader: Reader, found: dict[str, Any], at: str) -> Table:
    def number(stored: str, people: str, *path: str) -> Number:
        value: Any = found
        for step in path:
            value = value[step]
        return reader.units.number(value, stored, people, ",.4g", "/".join([at, *path]))

    rows: list[tuple[Cell, ...]] = []
    for name in found["ratings_N"]:
        pair = [number("N", "kN", group, name) for group in ("ratings_N", "formulas_N")]
        source = f"the case (life.{_KEYS[name]})" if name in found["given"] else _formula(reader, name)
        rows.append((_NAMES[name], *pair, printed(pair[0].unit), source))
    axial = "equivalent_load" in found
    at_rest = ("equivalent_load", "P_0_N") if axial else ("load_N",)
    made = "of radial and axial load" if axial else "the radial load"
    for label, path in (("equivalent load P", ("load_N",)), ("equivalent static load P_0", at_rest)):
        load = number("N", "kN", *path)
        rows.append((label, load, "", printed(load.unit), made))
    rows.append(("static safety C_0/P_0", number("", "", "static_safety"), "", "", ""))
    rows.append(("L10 by C_r and P, ISO 281", number("Mrev", "Mrev", "life_Mrev"), "", "10⁶ revolutions", ""))
    if "a_ISO" in found:
        rows.append(("viscosity ratio κ", number("", "", "viscosity_ratio"), "", "", ""))
        rows.append(("life modification factor a_ISO at P", number("", "", "a_ISO"), "", "", ""))
    head = ("rating", "used", "by formula", "unit", "source")
    return Table("Ratings (ISO 281, ISO 76)", head, tuple(rows), _apart(found))


def _apart(found: dict[str, Any]) -> str:
    """A remark where the dynamic rating of the case is far from that by formula."""
    given, formula = found["ratings_N"]["C_r"], found["formulas_N"]["C_r"]
    if "C_r" not in found["given"] or not formula or abs(given / formula - 1) <= APART:
        return ""
    size = f"{abs(given / formula - 1):.0%} {'above' if given > formula else 'below'}"
    return (
        f"C_r of the case is {size} that by the formula of ISO 281 from the number and size of its rolling "
        "elements: these may not be the maker's, above all where they are assumed, and makers rate some "
        "bearings above the formula. The lives by ISO 281 and ISO/TS 16281 use C_r of the case."
    )
