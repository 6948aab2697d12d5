"""Other states of the same case: the ring held otherwise, equilibria, other positions of the rollers."""

from collections.abc import Iterator

from flexbearing.quantities import SummaryValue
from flexbearing.report.html.document import Cell, Table
from flexbearing.report.html.reader import Reader, unit_of
from flexbearing.report.html.units import printed, with_unit

_FIGURES = (  # name, stored unit, unit of the metric page, format
    ("largest_inner_load_N", "N", "N", ",.1f"),
    ("loaded_rollers", "", "", "d"),
    ("life_L10_Mrev", "Mrev", "Mrev", ",.4g"),
    ("driving_torque_Nm", "N m", "N m", ".4g"),
    ("power_loss_W", "W", "W", ",.4g"),
    ("slip_percent", "%", "%", ".3g"),
)
_TILT = (
    ("max_roller_load_N", "N", "N", ",.1f"),
    ("life_L10_Mrev", "Mrev", "Mrev", ",.4g"),
    ("ring_moment_Nm", "N m", "N m", ".3g"),
    ("peak_pressure_MPa", "MPa", "MPa", ",.4g"),
    ("nominal_bar_stress_MPa", "MPa", "MPa", ",.4g"),
    *(
        (f"{which}stiffness_{axis}_N_per_m", "N/m", "kN/mm", ",.4g")
        for which in ("", "total_")
        for axis in "yz"
    ),
)

_INNER = "largest roller load"
_WORDS = {
    "largest_inner_load_N": _INNER, "max_roller_load_N": _INNER, "loaded_rollers": "loaded rollers",
    "ring_moment_Nm": "moment on the ring", "life_L10_Mrev": "basic life L10",
    "peak_pressure_MPa": "peak pressure", "nominal_bar_stress_MPa": "nominal stress of the bars",
    "stiffness_y_N_per_m": "stiffness of the bearing alone along y",
    "stiffness_z_N_per_m": "the same along z",
    "total_stiffness_y_N_per_m": "stiffness with supports along y",
    "total_stiffness_z_N_per_m": "the same along z",
}  # fmt: skip


def held(reader: Reader) -> Table | None:
    """What the other way to hold the inner ring gives; None where it was not estimated."""
    other = (reader.attributes.get("tilt") or {}).get("otherwise")
    if not other:
        return None
    known = [form for form in _TILT if form[0] in other]
    rows = tuple(
        (_words(name), number, printed(number.unit))
        for name, *form in known
        for number in (reader.of_attribute(f"tilt/otherwise/{name}", *form),)
    )
    return Table(("quantity", "value", "unit"), rows)


def equilibria(reader: Reader) -> Table | None:
    """Equilibria beside the computed one; None where none were found."""
    rows: list[tuple[Cell, ...]] = []
    for block, found in (reader.attributes.get("equilibria") or {}).items():
        at = f"equilibria/{block}"
        paths = {"computed": f"{at}/computed"}
        paths |= {f"other {number + 1}": f"{at}/others/{number}" for number in range(len(found["others"]))}
        if "after_passing_pitches" in found:
            paths["after passing pitches"] = f"{at}/after_passing_pitches"
        for words, path in paths.items():
            cells = (reader.of_attribute(f"{path}/{name}", *form) for name, *form in _FIGURES)
            rows.append((f"{words}, {block}", *cells))
    head = [with_unit(_words(name), reader.units.of(unit)) for name, _, unit, _ in _FIGURES]
    return Table(("equilibrium", *head), tuple(rows)) if rows else None


def passage(reader: Reader) -> Table | None:
    """Smallest and largest of every number over a pitch of the rollers; None for one position."""
    passed = reader.attributes.get("passage")
    if not passed:
        return None
    rows = [row for entry in reader.layout.summary if entry.label for row in _range(reader, entry)]
    if passed["mean_life_Mrev"] is not None:
        life = reader.of_attribute("passage/mean_life_Mrev", "Mrev", "Mrev", ",.4g")
        rows.append(("basic life L10 by equal damage of all positions", life, "", "", "", "Mrev"))
    return Table(("quantity", "smallest", "at [°]", "largest", "at [°]", "unit"), tuple(rows))


def _range(reader: Reader, entry: SummaryValue) -> Iterator[tuple[Cell, ...]]:
    """A row for each number of an entry that changes."""
    values, unit = reader.attributes["passage"]["values"], unit_of(entry).name
    stored = reader.layout[entry.of[0]].unit if entry.in_si else unit
    for part in entry.parts or ("",):
        key = f"{entry.key}.{part}" if part else entry.key
        column = values.get(key, [])
        known = [place for place, number in enumerate(column) if number is not None]
        if len({column[place] for place in known}) < 2:
            continue
        ends = min(known, key=column.__getitem__), max(known, key=column.__getitem__)
        cells: list[Cell] = []
        for place in ends:
            cells.append(reader.of_attribute(f"passage/values/{key}/{place}", stored, unit, entry.digits))
            cells.append(reader.of_attribute(f"passage/azimuth_deg/{place}", "deg", "deg", ".4g"))
        yield reader.label(entry) + (f", {part}" if part else ""), *cells, printed(reader.units.of(unit))


def _words(name: str) -> str:
    """Words of a name without its unit: "driving torque"."""
    return _WORDS.get(name) or name.rpartition("_")[0].replace("_", " ")
