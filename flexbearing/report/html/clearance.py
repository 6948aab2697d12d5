"""Operating clearance step by step, and what tolerances make of it."""

from collections.abc import Iterator
from math import floor
from typing import Any

from flexbearing.outputs import outputs
from flexbearing.report.html import assumed_effects
from flexbearing.report.html.check import text_of
from flexbearing.report.html.document import Block, Cell, Figure, Items, Number, Table, Words
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed, units_in_words, with_unit

DIAGONAL = "diagonal_clearance"

_EQUALLY_WARM = (
    "The case gives no [operation.temperatures], so all parts are equally warm and heat changes nothing. A "
    "shaft and an inner ring warmer than the housing leave less clearance than computed here."
)
_KINDS = {
    "clearance": "clearance before mounting,", "shaft": "interference on the shaft,",
    "housing": "interference in the housing,",
}  # fmt: skip
_SIGNS = (
    "Interference: positive where the shaft is larger than the bore, or the outside of the bearing larger "
    "than the housing, so that the ring is tight; negative is a loose fit. Clearance: negative is a preload."
)
_WARMTH = (
    "Warmer than the outer ring, beyond the temperatures of the case; rollers half way between them, "
    "expansion of the inner ring times the pitch diameter; rounded down. From there on the bearing is "
    "preloaded."
)
_DIAMETRAL = (
    "All clearances are diametral: the play of the inner ring across the bearing, twice the radial one; "
    "negative is a preload."
)
TIGHT = "tolerances/ends/tightest_m"  # path of the least clearance within the tolerances
EXPANDED = "[operation.temperatures] change the sizes of rollers, raceways and supports, not this clearance."
SMALLEST = 5e-10  # [m] smaller changes are zeros in the table

_LOOSE = (
    "The play of an open fit is in no clearance here, and the ring is held all round all the same: its seat "
    "must guide it."
)


def blocks(reader: Reader) -> Iterator[Block]:
    """Steps with a figure, tolerances; a sentence where the case states the clearance."""
    found = reader.attributes.get("clearance")
    if not found:
        return
    if words := which(reader):
        yield Items("Which clearance", words)
    if not found["steps"]:
        yield from (_stated(reader),) if along_diagonal(reader) is None else ()
        yield from _used_up(reader, found)
        return
    yield _steps(reader, found)
    if any(abs(step["change_m"]) >= SMALLEST for step in found["steps"]):
        yield _drawn(reader, found)
    else:
        yield Words(("Not drawn: no step changes the clearance.",))
    if not reader.attributes["case_si"]["operation"].get("temperatures"):
        yield Words((_EQUALLY_WARM,))
    fits = [f"{seat}: {found[f'{seat}_fit']}" for seat in ("shaft", "housing")]
    warm = reader.attributes["case_si"]["operation"].get("temperatures")
    verdict = (found["verdict"],) if warm else ()
    loose = (_LOOSE,) if any("fit open" in each for each in fits) else ()
    yield Items("Fits in operation" if warm else "Fits, all parts equally warm",
                tuple(map(units_in_words, (*verdict, *fits, *loose))))  # fmt: skip
    if "tolerances" in found:
        yield _tolerances(reader, found)
        yield from assumed_effects.at_ends(reader)
    yield from _used_up(reader, found)


def along_diagonal(reader: Reader) -> Number | None:
    """Free way of a ball between four contacts; None for other bearings."""
    declared = next((each for each in outputs(reader.layout) if each.name == DIAGONAL), None)
    block = reader.blocks.get(reader.last, ())
    if declared is None or not all(each in block for each in declared.declared.of):
        return None
    return reader.scalar(declared)


def which(reader: Reader) -> tuple[str, ...]:
    """Clearance before mounting, mounted, in operation, a line each with its number; empty without one."""
    found = reader.attributes.get("clearance") or {}
    if found.get("operating_m") is None:
        return ()
    used = _micrometres(reader, found["operating_m"])
    if (way := along_diagonal(reader)) is not None:
        return (
            f"Free way of a ball along a diagonal, both contacts together: {text_of(way)}. Between "
            f"the bottoms of the grooves, which it never touches: {used}.",
        )
    if not found["steps"]:
        return (
            _DIAMETRAL,
            "Before mounting, as in a catalogue, and mounted at rest: not in the case. [bearing.fits] with a "
            "clearance before mounting, in place of bearing.clearance, computes both.",
            f"In operation, warm and turning: {used} ({origin(reader)}). All results use it."
            + _expanded(reader),
        )
    bands = {each["name"]: each for each in found.get("tolerances", {}).get("classes", ())}
    of_class = f", class {bands['clearance']['class']}" if "clearance" in bands else ""
    lines = [
        _DIAMETRAL,
        f"Before mounting, as in a catalogue: {_micrometres(reader, found['cold_m'])}{of_class}.",
    ]
    if mounted := [step for step in found["steps"] if step["name"].endswith("fit")]:
        by = ", ".join(f"{step['name']} {_micrometres(reader, step['change_m'], '+.1f')}" for step in mounted)
        after = _micrometres(reader, mounted[-1]["clearance_m"])
        lines.append(f"Mounted at rest, parts equally warm: {after} ({by}).")
    if reader.attributes["case_si"]["operation"].get("temperatures"):
        lines.append(f"In operation, warm and turning: {used}. All results use it.")
    else:
        lines.append(f"Mounted and turning, parts equally warm: {used}. All results use it.")
        lines.append(
            "In operation: not known, as the case gives no temperatures; a warm inner ring leaves less."
        )
    if "ends" in found.get("tolerances", {}):
        ends = (
            _micrometres(reader, found["tolerances"]["ends"][f"{end}_m"]) for end in ("tightest", "loosest")
        )
        lines.append(f"Tolerances of clearance and fits leave {' to '.join(ends)} of it.")
    return tuple(lines)


def _expanded(reader: Reader) -> str:
    """What temperatures do beside a clearance that is stated; empty without them."""
    given = reader.of_rollers and reader.attributes["case_si"]["operation"].get("temperatures")
    return f" {EXPANDED}" if given else ""


def _micrometres(reader: Reader, length: float, digits: str = ".1f") -> str:
    number = reader.units.number(length, "m", "um", digits, "")
    return f"{number.text} {printed(number.unit)}"


def origin(reader: Reader) -> str:
    """Where a stated clearance comes from."""
    fitted = reader.attributes["calibrated"].get("bearing.clearance")
    if fitted:
        return "fitted, see Inputs"
    return "assumed" if "bearing.clearance" in reader.attributes["assumed"] else "given by the case"


def _used_up(reader: Reader, found: dict[str, Any]) -> Iterator[Table]:
    """By how much warmer an inner ring takes all clearance, where the case has what that takes."""
    ends = {"as computed": "operating_m"}
    if "ends" in found.get("tolerances", {}):
        ends["tight end of the tolerances"] = TIGHT
    rows: list[tuple[Cell, ...]] = []
    for label, path in ends.items():
        limit = reader.of_attribute(f"clearance/{path}", "m", "um", ".1f")
        if (difference := warmth(reader, path)) is not None:
            number = reader.units.number(difference, "K", "K", ",d", f"warmth/clearance/{path}")
            rows.append((label, limit, number))
    if rows:
        head = ("clearance", with_unit("diametral", reader.units.of("um")), "inner ring warmer by [K]")
        yield Table("Temperature difference that takes all clearance", head, tuple(rows), _WARMTH)


def warmth(reader: Reader, path: str) -> int | None:
    """Whole kelvins by which an inner ring may be warmer than the outer one, at a clearance of the result.

    None where nothing is left, and for bearings without rollers or expansion.
    """
    case, found = reader.attributes["case_si"], reader.attributes["clearance"]
    expansion = (case.get("materials", {}).get("inner_ring") or {}).get("expansion")
    if not reader.of_rollers or not expansion:
        return None
    bearing, value = case["bearing"], found
    for step in path.split("/"):
        value = value[step]
    pitch = bearing["outer_raceway_diameter"] - bearing["roller"]["diameter"]
    return floor(value / expansion / pitch) if value > 0 else None


def _stated(reader: Reader) -> Table:
    unit = reader.units.of("um")
    row = ("operating clearance, diametral", reader.of_attribute("clearance/operating_m", "m", "um", ".4g"))
    return Table("Clearance", ("quantity", with_unit("value", unit)), (row,))


def _steps(reader: Reader, found: dict[str, Any]) -> Table:
    unit = reader.units.of("um")
    rows: list[tuple[Cell, ...]] = [
        ("before mounting", "", reader.of_attribute("clearance/cold_m", "m", "um", ".1f"), "")
    ]
    for place, step in enumerate(found["steps"]):
        path = f"clearance/steps/{place}"
        change, after = (reader.of_attribute(f"{path}/{name}", "m", "um", form)
                         for name, form in (("change_m", "+.2f"), ("clearance_m", ".1f")))  # fmt: skip
        rows.append((step["name"], change, after, units_in_words(step["explanation"])))
    head = ("step", with_unit("change", unit), with_unit("after it", unit), "explanation")
    return Table(
        f"From the clearance before mounting to the {reader.clearance_words}, diametral", head, tuple(rows)
    )


def _drawn(reader: Reader, found: dict[str, Any]) -> Figure:
    steps = [step for step in found["steps"] if abs(step["change_m"]) >= SMALLEST]
    after = [found["cold_m"], *(step["clearance_m"] for step in steps)]
    names = ["before mounting", *(step["name"] for step in steps)]
    unit = reader.units.of("um")
    values = [float(f"{reader.units.value(value, 'm', 'um'):.6g}") for value in after]
    trace = {
        "type": "bar", "x": names, "y": values,
        "marker": {"color": "#0072B2"}, "hovertemplate": "%{x}: %{y}<extra></extra>",
    }  # fmt: skip
    layout = {"yaxis": {"title": {"text": with_unit("clearance", unit)}}, "xaxis": {"tickangle": -30}}
    caption = "Diametral clearance before mounting and after every step that changes it; negative: preload."
    return Figure(
        "clearance-steps",
        caption,
        (trace,),
        layout,
    )


def _tolerances(reader: Reader, found: dict[str, Any]) -> Table:
    unit = reader.units.of("um")
    rows: list[tuple[Cell, ...]] = []
    for place, each in enumerate(found["tolerances"]["classes"]):
        path = f"clearance/tolerances/classes/{place}"
        limits = (
            reader.of_attribute(f"{path}/{name}", "m", "um", ".1f")
            for name in ("least_m", "used_m", "greatest_m")
        )
        rows.append((f"{_KINDS[each['name']]} {each['class']}", *limits))
    if "ends" in found["tolerances"]:
        paths = ("tolerances/ends/tightest_m", "operating_m", "tolerances/ends/loosest_m")
        ends = (reader.of_attribute(f"clearance/{path}", "m", "um", ".1f") for path in paths)
        rows.append((reader.clearance_words, *ends))
    head = ("class", *(with_unit(word, unit) for word in ("least", "computed", "greatest")))
    return Table(
        f'Tolerances, diametral, computed at bearing.fits.at = "{found["tolerances"]["at"]}"',
        head,
        tuple(rows),
        _SIGNS,
    )
