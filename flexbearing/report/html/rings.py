"""Elastic rings: their deformation, supports, and stresses against yield."""

from collections.abc import Iterator

from flexbearing.report.html.document import Block, Cell, Table, Words
from flexbearing.report.html.figures import around, deformed
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import NOTHING, printed, with_unit


def blocks(reader: Reader) -> Iterator[Block]:
    """Deformed raceways, stiffness of what holds them, stresses."""
    structure = reader.attributes.get("structure")
    if not structure:
        if "structure" in reader.attributes:
            yield Words(("Rings, shaft and housing are rigid in this case.",))
        return
    if figure := deformed(reader):
        yield figure
    if "bar_azimuth" in reader.blocks.get("flexible", {}):
        names = ("bar_axial_force",)
        if figure := around(reader, "axial force of the bars", names, "bar_azimuth"):
            yield figure
    yield _supports(reader)
    if "support_translation" in reader.blocks.get(reader.last, {}):
        yield _translations(reader)
    if reader.attributes.get("stresses"):
        yield _stresses(reader)
    else:
        yield Words((
            "Stresses of the rings were not computed: `outputs.stresses = true` in the case stores their "
            "largest values, `flexbearing export OUT.h5 --to vtu` computes them for this result.",
        ))  # fmt: skip


def _supports(reader: Reader) -> Table:
    rows: list[tuple[Cell, ...]] = []
    for part, figures in reader.attributes["structure"].items():
        cells = [
            reader.of_attribute(f"structure/{part}/{name}", "N/m", "kN/mm", ",.4g")
            if figures.get(name) is not None
            else NOTHING
            for name in ("support_stiffness_N_per_m", "support_stiffness_error_N_per_m")
        ]
        counts = (
            reader.of_attribute(f"structure/{part}/{name}", "", "", ",d") for name in ("unknowns", "elements")
        )
        rows.append((part, *cells, *counts))
    unit = reader.units.of("kN/mm")
    words = (with_unit(word, unit) for word in ("radial stiffness of its support", "its error, estimated"))
    head = ("part", *words, "unknowns", "elements")
    return Table("Finite elements of the flexible parts", head, tuple(rows))


def _translations(reader: Reader) -> Table:
    """Rigid translation of both raceways on what holds them."""
    rows: list[tuple[Cell, ...]] = []
    for row, race in enumerate(("inner", "outer")):
        cells = (reader.element(reader.last, "support_translation", row, axis) for axis in range(2))
        rows.append((f"{race} raceway", *cells))
    unit = reader.units.of(reader.layout["support_translation"].unit_for_people.name)
    head = ("of", *(with_unit(f"along {axis}", unit) for axis in "yz"))
    return Table("Rigid translation of the raceways on their supports", head, tuple(rows))


def _stresses(reader: Reader) -> Table:
    """Largest stresses of every body; their limits are in the table of limits."""
    rows: list[tuple[Cell, ...]] = []
    for part, found in reader.attributes["stresses"].items():
        for body in found["bodies"]:
            path = f"stresses/{part}/bodies/{body}"
            numbers = (
                reader.of_attribute(f"{path}/{name}", stored, stored, digits)
                for name, stored, digits in (
                    ("von_mises_MPa", "MPa", ",.0f"), ("von_mises_error_MPa", "MPa", ",.0f"),
                    ("tension_MPa", "MPa", ",.0f"), ("compression_MPa", "MPa", ",.0f"),
                    ("x_mm", "mm", ".1f"), ("radius_mm", "mm", ".1f"), ("azimuth_deg", "deg", ".1f"),
                )
            )  # fmt: skip
            rows.append((f"{part}: {body}", *numbers))
    stress, length = (printed(reader.units.of(unit)) for unit in ("MPa", "mm"))
    head = ("body", f"von Mises [{stress}]", f"± [{stress}]", f"tension [{stress}]", f"pressure [{stress}]",
            f"at x [{length}]", f"radius [{length}]", "azimuth [°]")  # fmt: skip
    return Table("Largest stresses, away from loaded rollers and sharp edges", head, tuple(rows))
