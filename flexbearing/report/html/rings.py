"""Stiffness: what holds each ring, and the matrix over five directions."""

from typing import Any

import numpy as np

from flexbearing.outputs import outputs
from flexbearing.report.html.document import Cell, Number, Table
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import NOTHING, printed, with_unit

SHEARED = 1e-4  # of the bearing's force: what radial springs leave to tangential ones
PULL = {True: "push and pull", False: "push only"}  # what springs can do
_ZERO = 1e-10  # of the diagonal: what rounding leaves of nothing
_FORCES = ("force along x", "force along y", "force along z", "moment about y", "moment about z")
_BY = ("along x", "along y", "along z", "about y", "about z")
_UNITS = (("N/m", "kN/mm"), ("N/rad", "kN/rad"), ("N m/m", "kN m/m"), ("N m/rad", "kN m/rad"))
_SUPPORT = "support_stiffness_N_per_m"


def supported(reader: Reader) -> bool:
    """Whether a ring is on a support that gives way."""
    block = reader.blocks[reader.last]
    if "stiffness" not in block and "total_stiffness" in block:  # no springs in series
        return True
    structure = reader.attributes.get("structure") or {}
    return len(reader.blocks) > 1 and any(figures.get(_SUPPORT) is not None for figures in structure.values())


def supports(reader: Reader) -> Table | None:
    """Stiffness of what holds each ring, alone, with its error and the size of its mesh."""
    rows: list[tuple[Cell, ...]] = []
    for part, figures in (reader.attributes.get("structure") or {}).items():
        path = f"structure/{part}"
        cells = [
            NOTHING if figures.get(name) is None else
            reader.of_attribute(f"{path}/{name}", "N/m", "kN/mm", ",.4g")
            for name in (_SUPPORT, "support_stiffness_error_N_per_m")
        ]  # fmt: skip
        rows.append((part, *cells, reader.of_attribute(f"{path}/unknowns", "", "", ",d")))
    unit = reader.units.of("kN/mm")
    head = ("ring", with_unit("support alone", unit), with_unit("its error", unit), "unknowns")
    return Table(head, tuple(rows)) if rows else None


def _outer(reader: Reader, kind: str) -> dict[str, Any]:
    """Lines or foundation that hold the outer ring; empty where it is held otherwise."""
    return ((reader.attributes.get("structure") or {}).get("outer") or {}).get(kind) or {}


def lines(reader: Reader) -> Table | None:
    """Forces of lines that hold the outer ring."""
    if not (known := _outer(reader, "lines")):
        return None
    rows: list[tuple[Cell, ...]] = []
    for place, carries in enumerate(known["carries"]):
        azimuth, force = (
            reader.of_attribute(f"structure/outer/lines/{name}/{place}", unit, unit, form)
            for name, unit, form in (("azimuth_deg", "deg", ".1f"), ("force_N", "N", ",.1f"))
        )
        state = ("pushes" if known["force_N"][place] > 0 else "pulls") if carries else "lifted off"
        rows.append((azimuth, force, state))
    force = with_unit("force", reader.units.of("N"))
    return Table(("line [°]", force, PULL[known["pull"]]), tuple(rows))


def foundation(reader: Reader) -> Table | None:
    """Pressure of springs around the outer ring."""
    if not (known := _outer(reader, "foundation")):
        return None
    pulled = known["least_pressure_MPa"] < 0
    arcs = ", ".join(f"{begin:.0f} to {end % 360:.0f}" for begin, end in known["touching_deg"])
    shown = {
        "largest pressure": ("largest_pressure_MPa", "MPa", ".3g"),
        "at azimuth": ("azimuth_deg", "deg", ".0f"), "at x": ("x_mm", "mm", ".1f"),
        f"share of the surface that is {'pulled' if pulled else 'lifted off'}": ("open_share", "1", ".0f"),
    } | ({"largest pull": ("least_pressure_MPa", "MPa", ".3g")} if pulled else {})  # fmt: skip
    rows: list[tuple[Cell, ...]] = [
        ("springs", PULL[known["pull"]], ""),
        ("push at azimuths", arcs or "none", "°"),
    ]
    for words, (name, unit, form) in shown.items():
        shown_in = "%" if unit == "1" else unit
        number = reader.of_attribute(f"structure/outer/foundation/{name}", unit, shown_in, form)
        rows.append((words, number, printed(number.unit)))
    return Table(("quantity", "value", "unit"), tuple(rows))


def carried(reader: Reader) -> Table | None:
    """Radial forces of the bearing on the outer ring, and what holds them."""
    kind = next((kind for kind in ("lines", "foundation") if _outer(reader, kind)), "")
    if not kind:
        return None
    known = _outer(reader, kind)
    pressed, holding = np.array(known["rollers_N"]), np.array(known["resultant_N"])
    rows: list[tuple[Cell, ...]] = [
        (words, *(reader.of_attribute(f"structure/outer/{kind}/{name}/{axis}", "N", "N", ",.1f")
                  for axis in range(2)))
        for words, name in (("of the bearing", "rollers_N"), ("held by radial springs", "resultant_N"))
    ]  # fmt: skip
    if np.hypot(*(pressed - holding)) > SHEARED * np.hypot(*pressed):
        rows.append(("the rest", "by tangential springs", ""))
    unit = reader.units.of("N")
    return Table(("force", with_unit("along y", unit), with_unit("along z", unit)), tuple(rows))


def solids(reader: Reader) -> Table | None:
    """Loads and cost of the solids whose stresses are known, and the stiffness of their supports alone."""
    stiffness = {
        "tilting": ("tilting_Nm_per_rad", "tilting_error_Nm_per_rad", "N m/rad", "kN m/rad"),
        "axial": ("axial_N_per_m", "axial_error_N_per_m", "N/m", "kN/mm"),
    }
    rows: list[tuple[Cell, ...]] = []
    for part, known in (reader.attributes.get("stresses") or {}).items():
        loads = ", without ".join(filter(None, (known["loads"], known["left_out"])))
        seconds = reader.of_attribute(f"stresses/{part}/seconds", "s", "s", ",.1f")
        rows.append((part, loads, seconds, *(
            reader.of_attribute(f"stresses/{part}/support/{name}", stored, people, ",.4g")
            if "support" in known else ""
            for *names, stored, people in stiffness.values() for name in names
        )))  # fmt: skip
    head = (
        with_unit(words, reader.units.of(people)) for name, (*_, people) in stiffness.items()
        for words in (name, "±")
    )  # fmt: skip
    return Table(("part", "loads", "time [s]", *head), tuple(rows)) if rows else None


def matrix(reader: Reader) -> Table | None:
    """The matrix of the last end state, with a unit for each of its four parts."""
    if "stiffness_matrix" not in reader.blocks.get(reader.last, {}):
        return None
    rows: list[tuple[Cell, ...]] = [
        (force, *(entry(reader, row, column) for column in range(5))) for row, force in enumerate(_FORCES)
    ]
    return Table(("load", *_BY), tuple(rows))


def units(reader: Reader) -> list[str]:
    """Units of the four parts of the matrix: forces, then moments, by displacements and by rotations."""
    return [reader.units.of(people) for _, people in _UNITS]


def entry(reader: Reader, row: int, column: int) -> Number:
    """An entry of the matrix of the last end state; what rounding leaves of nothing is printed as zero."""
    matrix = reader.blocks[reader.last]["stiffness_matrix"]
    stored, people = _UNITS[2 * (row > 2) + (column > 2)]
    value, scale = float(matrix[row, column]), np.sqrt(abs(matrix[row, row] * matrix[column, column]))
    digits = ".0f" if abs(value) <= _ZERO * scale else ".4g"
    place = f"{reader.last}/stiffness_matrix/{row}/{column}"
    return reader.units.number(value, stored, people, digits, place)


_STRESSES = (  # column, name, unit, format
    ("von Mises", "von_mises_MPa", "MPa", ",.0f"), ("±", "von_mises_error_MPa", "MPa", ",.0f"),
    ("tension", "tension_MPa", "MPa", ",.0f"), ("±", "tension_error_MPa", "MPa", ",.0f"),
    ("compr.", "compression_MPa", "MPa", ",.0f"), ("±", "compression_error_MPa", "MPa", ",.0f"),
    ("moved", "displacement_um", "um", ",.0f"), ("x", "x_mm", "mm", ".1f"), ("r", "radius_mm", "mm", ".1f"),
    ("at", "azimuth_deg", "deg", ".1f"),
)  # fmt: skip

_READINGS = {  # quantities of probes, and their headings
    "probe_azimuth": "azimuth",
    "probe_gauge_strain": "along the gauge",
    "probe_strain_error": "±",
    "probe_hoop_strain": "hoop",
    "probe_axial_strain": "axial",
    "probe_largest_strain": "largest",
    "probe_smallest_strain": "smallest",
    "probe_radial_displacement": "outward",
}


def translations(reader: Reader) -> Table | None:
    """Rigid translation of both raceways on what holds them."""
    if "support_translation" not in reader.blocks.get(reader.last, {}):
        return None
    rows: list[tuple[Cell, ...]] = []
    for row, race in enumerate(("inner", "outer")):
        cells = (reader.element(reader.last, "support_translation", row, axis) for axis in range(2))
        rows.append((f"{race} raceway", *cells))
    unit = reader.units.of(reader.layout["support_translation"].unit_for_people.name)
    return Table(("translation", *(with_unit(f"along {axis}", unit) for axis in "yz")), tuple(rows))


def stresses(reader: Reader) -> Table | None:
    """Largest stresses of every body, von Mises with its place; their limits are on the first page."""
    rows: list[tuple[Cell, ...]] = []
    for part, found in (reader.attributes.get("stresses") or {}).items():
        for body in found["bodies"]:
            path = f"stresses/{part}/bodies/{body}"
            numbers = (reader.of_attribute(f"{path}/{name}", unit, unit, form)
                       for _, name, unit, form in _STRESSES)  # fmt: skip
            rows.append((f"{part}: {body}", *numbers))
    head = (
        words if words == "±" else with_unit(words, reader.units.of(unit)) for words, _, unit, _ in _STRESSES
    )
    return Table(("body", *head), tuple(rows)) if rows else None


def probes(reader: Reader) -> Table | None:
    """Strains and radial displacement that probes read."""
    block = reader.blocks.get(reader.last, {})
    if "probe_azimuth" not in block:
        return None
    units = (reader.units.of(reader.layout[name].unit_for_people.name) for name in _READINGS)
    head = [with_unit(words, unit) for words, unit in zip(_READINGS.values(), units, strict=True)]
    rows = (
        (f"{place + 1}", *(reader.element(reader.last, name, place) for name in _READINGS))
        for place in range(len(block["probe_azimuth"]))
    )
    return Table(("probe", *head), tuple(rows))


DIAGONAL = "diagonal_clearance"
TIGHT = "tolerances/ends/tightest_m"  # path of the least clearance within the tolerances
_KINDS = {
    "clearance": "clearance before mounting,", "shaft": "interference on the shaft,",
    "housing": "interference in the housing,",
}  # fmt: skip


def along_diagonal(reader: Reader) -> Number | None:
    """Free way of a ball between four contacts; None for other bearings."""
    declared = next((each for each in outputs(reader.layout) if each.name == DIAGONAL), None)
    block = reader.blocks.get(reader.last, ())
    if declared is None or not all(each in block for each in declared.declared.of):
        return None
    return reader.scalar(declared)


def clearance_origin(reader: Reader) -> str:
    """Where a stated clearance comes from."""
    if "bearing.clearance" in reader.attributes["calibrated"]:
        return "fitted"
    return "assumed" if "bearing.clearance" in reader.attributes["assumed"] else "given by the case"


def steps(reader: Reader) -> Table | None:
    """From the clearance before mounting to that of the result; None where the case states it."""
    found = reader.attributes.get("clearance") or {}
    if not found.get("steps"):
        return None
    unit = reader.units.of("um")
    rows: list[tuple[Cell, ...]] = [
        ("before mounting", "", reader.of_attribute("clearance/cold_m", "m", "um", ".1f"), "")
    ]
    for place, step in enumerate(found["steps"]):
        path = f"clearance/steps/{place}"
        change, after = (reader.of_attribute(f"{path}/{name}", "m", "um", form)
                         for name, form in (("change_m", "+.2f"), ("clearance_m", ".1f")))  # fmt: skip
        rows.append((step["name"], change, after, step["explanation"]))
    return Table(("step", with_unit("change", unit), with_unit("clearance", unit), ""), tuple(rows))


def tolerances(reader: Reader) -> Table | None:
    """Least and greatest by the classes, and the clearance that they leave; None without classes."""
    found = (reader.attributes.get("clearance") or {}).get("tolerances")
    if not found:
        return None
    rows: list[tuple[Cell, ...]] = []
    for place, each in enumerate(found["classes"]):
        path = f"clearance/tolerances/classes/{place}"
        limits = (reader.of_attribute(f"{path}/{name}", "m", "um", ".1f")
                  for name in ("least_m", "used_m", "greatest_m"))  # fmt: skip
        rows.append((f"{_KINDS[each['name']]} {each['class']}", *limits))
    if "ends" in found:
        paths = (TIGHT, "operating_m", "tolerances/ends/loosest_m")
        ends = (reader.of_attribute(f"clearance/{path}", "m", "um", ".1f") for path in paths)
        rows.append((reader.clearance_words, *ends))
    unit = reader.units.of("um")
    return Table(
        ("class", *(with_unit(word, unit) for word in ("least", "computed", "greatest"))), tuple(rows)
    )
