"""Elastic rings: largest stresses of every body, translation on their supports."""

from flexbearing.report.html.document import Cell, Table
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed, with_unit

_STRESSES = (
    ("von_mises_MPa", "MPa", ",.0f"), ("von_mises_error_MPa", "MPa", ",.0f"), ("tension_MPa", "MPa", ",.0f"),
    ("compression_MPa", "MPa", ",.0f"), ("x_mm", "mm", ".1f"), ("radius_mm", "mm", ".1f"),
    ("azimuth_deg", "deg", ".1f"),
)  # fmt: skip


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
