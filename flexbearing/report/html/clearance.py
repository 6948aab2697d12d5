"""Operating clearance step by step, and what tolerances make of it."""

from flexbearing.outputs import outputs
from flexbearing.report.html.document import Cell, Number, Table
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import with_unit

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


def origin(reader: Reader) -> str:
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
        ("before mounting", "", reader.of_attribute("clearance/cold_m", "m", "um", ".1f"))
    ]
    for place, step in enumerate(found["steps"]):
        path = f"clearance/steps/{place}"
        change, after = (reader.of_attribute(f"{path}/{name}", "m", "um", form)
                         for name, form in (("change_m", "+.2f"), ("clearance_m", ".1f")))  # fmt: skip
        rows.append((step["name"], change, after))
    return Table(("step", with_unit("change", unit), with_unit("clearance", unit)), tuple(rows))


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
