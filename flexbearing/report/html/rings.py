"""Elastic rings: largest stresses of every body, readings of probes, translation on their supports."""

from flexbearing.report.html.document import Cell, Table
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed, with_unit

_STRESSES = (
    ("von_mises_MPa", "MPa", ",.0f"), ("von_mises_error_MPa", "MPa", ",.0f"), ("tension_MPa", "MPa", ",.0f"),
    ("compression_MPa", "MPa", ",.0f"), ("x_mm", "mm", ".1f"), ("radius_mm", "mm", ".1f"),
    ("azimuth_deg", "deg", ".1f"),
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
    """Largest stresses of every body; their limits are on the first page."""
    rows: list[tuple[Cell, ...]] = []
    for part, found in (reader.attributes.get("stresses") or {}).items():
        for body in found["bodies"]:
            path = f"stresses/{part}/bodies/{body}"
            numbers = (reader.of_attribute(f"{path}/{name}", unit, unit, form)
                       for name, unit, form in _STRESSES)  # fmt: skip
            rows.append((f"{part}: {body}", *numbers))
    stress, length = (printed(reader.units.of(unit)) for unit in ("MPa", "mm"))
    head = ("body", f"von Mises [{stress}]", f"± [{stress}]", f"tension [{stress}]", f"pressure [{stress}]",
            f"at x [{length}]", f"radius [{length}]", "azimuth [°]")  # fmt: skip
    return Table(head, tuple(rows)) if rows else None


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
