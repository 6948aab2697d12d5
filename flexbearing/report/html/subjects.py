"""Numbers of the summary by subject: every end state side by side, with error and change."""

from collections.abc import Iterator

from flexbearing.quantities import SummaryValue
from flexbearing.quantities.four_point import TORQUE_PARTS
from flexbearing.report.html.document import Cell, Number, Table
from flexbearing.report.html.reader import Reader, places
from flexbearing.report.html.units import NOTHING, printed, with_unit

SUBJECTS = {  # name in the template: beginnings of keys of the summary
    "loads": (
        "max_roller", "max_outer_load", "loaded_rollers", "loaded_arc", "balls_on", "contact_load",
        "contact_angle",
    ),
    "pressures": ("peak_pressure_MPa", "minimum_film", "minimum_lambda"),
    "stiffnesses": (
        "stiffness", "total_stiffness", "support_stiffness", "displacement", "ring_", "radial_clearance",
        "free_contact",
    ),
    "friction": ("cage_s", "orbital_speed", "driving", "power_loss", "friction_torque", "max_pocket"),
}  # fmt: skip
ELSEWHERE = ("life", "raceway_life", "reference_life", "modified_life")  # table of lives
FIRST_PAGE = ("static_safety", "nominal_bar_stress_MPa")  # limits alike in every end state
ERROR, CHANGE = "error [%]", "rigid to flexible [%]"


def tables(reader: Reader) -> dict[str, Table]:
    """A table for each subject, and "further" with all that belongs to none."""
    rows: dict[str, list[tuple[Cell, ...]]] = {name: [] for name in (*SUBJECTS, "further")}
    judged = {record.quantity for record in reader.findings}
    for entry in (each for each in reader.layout.summary if each.label):
        alone = entry.key == "peak_pressure_MPa" and len(reader.blocks) == 1 and "contact_pressure" in judged
        if not (alone or entry.key in FIRST_PAGE or entry.key.startswith(ELSEWHERE)):
            subject = next((name for name, keys in SUBJECTS.items() if entry.key.startswith(keys)), "further")
            rows[subject].extend(_rows(reader, entry))
    return {name: _table(reader, found) for name, found in rows.items()}


def numbers(reader: Reader, *sections: str) -> Table:
    """A table of every number in sections of the summary."""
    entries = (entry for entry in reader.layout.summary if entry.label and entry.section in sections)
    return _table(reader, [row for entry in entries for row in _rows(reader, entry)])


def regimes(reader: Reader) -> Table:
    """Lubrication regime of each raceway in each end state; without rows where the roughness is not known."""
    known = reader.attributes.get("regimes") or {}
    rows = (
        (block, words["inner"], words["outer"]) for block, words in known.items() if block in reader.blocks
    )
    return Table(("lubrication", "inner raceway", "outer raceway"), tuple(rows))


def torque_parts(reader: Reader) -> Table | None:
    """Causes of the torque of slow balls; None of other bearings."""
    known = reader.summary.get(reader.last) or {}
    if "torque_formula" not in known:
        return None
    columns = {"torque_parts_Nm": "all balls", "mean_ball_torque_parts_Nm": "mean ball",
               "largest_ball_torque_parts_Nm": "most loaded ball"}  # fmt: skip
    rows: list[tuple[Cell, ...]] = [
        (part, *(_torque(reader, column, part) for column in columns)) for part in TORQUE_PARTS
    ]
    rows.append(("total, circumferential", _torque(reader, "circumferential_torque_Nm"), "", ""))
    unit = reader.units.of("N m")
    return Table(("torque", *(with_unit(words, unit) for words in columns.values())), tuple(rows))


def _torque(reader: Reader, *place: str) -> Number:
    value = reader.summary[reader.last]
    for step in place:
        value = value[step]
    return reader.units.number(value, "N m", "N m", ".5g", "/".join(("summary", reader.last, *place)))


def _of_supports(entry: SummaryValue) -> bool:
    """Whether a row counts elastic rings and supports: between rigid rings it would repeat another."""
    return entry.of == ("total_stiffness",)


def _table(reader: Reader, rows: list[tuple[Cell, ...]]) -> Table:
    """The rows without columns that are empty."""
    head = ["quantity", *reader.blocks, "unit", ERROR, *([CHANGE] if len(reader.blocks) > 1 else [])]
    kept = [place for place in range(len(head)) if head[place] not in (ERROR, CHANGE)
            or any(row[place] for row in rows)]  # fmt: skip
    return Table(tuple(head[place] for place in kept),
                 tuple(tuple(row[place] for place in kept) for row in rows))  # fmt: skip


def _rows(reader: Reader, entry: SummaryValue) -> Iterator[tuple[Cell, ...]]:
    """A row for each number of an entry; none where no end state has an optional one."""
    compared = len(reader.blocks) > 1
    if _of_supports(entry) and not compared:
        return
    for words, steps in places(entry):
        numbers = [reader.declared(entry, block, *steps) for block in reader.blocks]
        optional = any(reader.layout[name].optional for name in entry.of)
        if all(number.text == NOTHING for number in numbers) and (optional or not numbers):
            continue
        shown: list[Cell] = [
            NOTHING if compared and _of_supports(entry) and block == "rigid" else number
            for block, number in zip(reader.blocks, numbers, strict=True)
        ]
        row: list[Cell] = [
            _label(reader, entry, words),
            *shown,
            printed(numbers[-1].unit),
            error(reader, entry),
        ]
        if compared:
            rounding = not numbers[0].text.strip("-0.,")
            both = entry.compared and NOTHING not in shown and not rounding
            row.append(reader.change(numbers[0].of, numbers[-1].of) if both else "")
        yield tuple(row)


def _label(reader: Reader, entry: SummaryValue, words: str) -> str:
    """Label of an entry, or of one of its numbers, which names its own axis."""
    label = reader.label(entry)
    return f"{label}, {words.replace('_', ' ')}" if words else label


def error(reader: Reader, entry: SummaryValue) -> Number | str:
    """Estimated numerical error of an output in percent; empty where none was estimated."""
    path = reader.error_path(entry.error)
    if not path:
        return ""
    if entry.error == "total_stiffness" and path.startswith("slice_error") and len(reader.blocks) > 1:
        return _with_supports(reader)
    if entry.error == "driving_torque" and _power(reader):
        return _of_torque(reader, path)
    return reader.of_attribute(path, "1", "%", ".2g")


def _with_supports(reader: Reader) -> Number:
    """Of the stiffness by slices, and by the meshes of the supports by their share of the compliance."""
    whole = reader.summary[reader.last]["total_stiffness_N_per_m"]
    found = reader.attributes["slice_error"]["total_stiffness"]
    for figures in (reader.attributes.get("structure") or {}).values():
        stiffness, known = (figures.get(f"support_stiffness{end}_N_per_m") for end in ("", "_error"))
        if stiffness and known is not None:
            found += known / stiffness * whole / stiffness
    return reader.units.number(100 * found, "%", "%", ".2g", f"with_supports_error/{reader.last}")


def _power(reader: Reader) -> float:
    block = reader.blocks[reader.last]
    return float(block.get("driving_power", 0.0)) if "loss_transport" in block else 0.0


def _of_torque(reader: Reader, path: str) -> Number:
    """Of the torque by its grid, and by power that no cause explains."""
    found = float(reader.attributes[path.partition("/")[0]]["driving_torque"])
    found += abs(float(reader.blocks[reader.last]["loss_transport"]) / _power(reader))
    return reader.units.number(100 * found, "%", "%", ".2g", f"torque_error/{reader.last}/{path}")
