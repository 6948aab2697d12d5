"""Other states of the same case: the ring held otherwise, equilibria, other positions of the rollers."""

from collections.abc import Iterator

from flexbearing.quantities import SummaryValue
from flexbearing.report.html import shaft_tilt
from flexbearing.report.html.document import Block, Cell, Table, Words
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed, with_unit
from flexbearing.report.rows import unit_of

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
)

_FURTHER = (
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


def blocks(reader: Reader) -> Iterator[Block]:
    """What the run found besides its answer; nothing where it looked for nothing."""
    yield from _tilt(reader)
    yield from _equilibria(reader)
    yield from _passage(reader)


def _tilt(reader: Reader) -> Iterator[Block]:
    """How the shaft holds the inner ring, and what the other way gives."""
    held = reader.attributes.get("tilt")
    if not held:
        return
    words = {"fixed": "The shaft holds the tilt of the inner ring", "free": "The inner ring is free to tilt"}
    choice = held["inner_ring"]
    sentences = (
        f'{words.get(choice, "The inner ring")} (operation.tilt = "{choice}")',
        shaft_tilt.clamps(reader),
    )
    yield Words((" ".join(f"{sentence}." for sentence in sentences if sentence),))
    if other := held.get("otherwise"):
        known = [form for form in (*_TILT, *_FURTHER) if form[0] in other]
        head = [with_unit(_words(name), reader.units.of(unit)) for name, _, unit, _ in known]
        cells = (reader.of_attribute(f"tilt/otherwise/{name}", *form) for name, *form in known)
        caption = "The other way to hold the ring, estimated by Newton steps"
        yield Table(caption, ("operation.tilt", *head), ((other["inner_ring"], *cells),))


def _equilibria(reader: Reader) -> Iterator[Block]:
    """Equilibria beside the computed one."""
    for block, found in (reader.attributes.get("equilibria") or {}).items():
        at = f"equilibria/{block}"
        paths = {"computed": f"{at}/computed"}
        paths |= {f"other {number + 1}": f"{at}/others/{number}" for number in range(len(found["others"]))}
        if "after_passing_pitches" in found:
            paths["after passing pitches"] = f"{at}/after_passing_pitches"
        head = [with_unit(_words(name), reader.units.of(unit)) for name, _, unit, _ in _FIGURES]
        rows = tuple(
            (words, *(reader.of_attribute(f"{path}/{name}", *form) for name, *form in _FIGURES))
            for words, path in paths.items()
        )
        yield Table(f"Several equilibria, between {found['raceways']}", ("equilibrium", *head), rows)


def _passage(reader: Reader) -> Iterator[Block]:
    """Smallest and largest of every number over a pitch of the rollers."""
    passed = reader.attributes.get("passage")
    if not passed:
        return
    rows = [row for entry in reader.layout.summary if entry.label for row in _range(reader, entry)]
    caption = f"Rollers passing a pitch: {len(passed['azimuth_deg'])} positions"
    head = ("quantity", "smallest", "at [°]", "largest", "at [°]", "unit")
    failed = sum(status != "converged" for status in passed["status"])
    note = f"{failed} positions were not solved." if failed else ""
    yield Table(caption, head, tuple(rows), note)
    if passed["mean_life_Mrev"] is not None:
        life = reader.of_attribute("passage/mean_life_Mrev", "Mrev", "Mrev", ",.4g")
        yield Table(
            "Life by equal damage of all positions",
            ("life", "10⁶ revolutions"),
            (("basic life L10, Lundberg and Palmgren", life),),
        )


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
