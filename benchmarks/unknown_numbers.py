"""How much numbers matter that no drawing and no catalogue has: `python -m benchmarks.unknown_numbers`.

Each is set to both ends of what is usual, one at a time, in three bearings, one of them under a light load as
well. Writes docs/images/unknown_numbers.csv and .png and fills the table of docs/howto/unknown-numbers.md.
With `--page` page and picture are made from the stored table.
"""

import argparse
import csv
from collections.abc import Iterator
from dataclasses import astuple, dataclass, fields
from math import isfinite

from benchmarks.machine import describe
from benchmarks.page import DOCS, fill
from flexbearing import run
from flexbearing.report.figure import BLUE, ORANGE

CSV, PNG = DOCS / "images" / "unknown_numbers.csv", DOCS / "images" / "unknown_numbers.png"
PAGE = DOCS / "howto" / "unknown-numbers.md"

Ends = dict[str, tuple[str, ...]]  # settings by how the value is called
OIL = "lubricant.oil_fraction"
LAND = ("bearing.cage.guidance=outer", "bearing.cage.land_diameter=80.5 mm", "bearing.cage.land_width=3 mm")
ROUGH, MIXED = "bearing.roughness", "lubricant.mixed.boundary_friction"


def rough(roller: str, raceways: str) -> tuple[str, ...]:
    """Rq of the surfaces, which matters where film and asperities share the load."""
    return (
        f"{ROUGH}.roller={roller} um", f"{ROUGH}.inner_raceway={raceways} um",
        f"{ROUGH}.outer_raceway={raceways} um", f"{MIXED}=0.1",
    )  # fmt: skip


def single(key: str, *values: str) -> Ends:
    """Both ends of one key."""
    return {value: (f"{key}={value}",) for value in values}


COMMON = {
    "pocket friction": single("bearing.cage.pocket_friction", "0.02", "0.1"),
    "roughness Rq, rollers / raceways": {
        "0.025 / 0.05 um": rough("0.025", "0.05"),
        "0.1 / 0.2 um": rough("0.1", "0.2"),
    },
}
CATALOGUE = {
    OIL: single(OIL, "0.005", "0.1"),
    **COMMON,
    "crowning, drop A": {
        f"{drop} um": ("bearing.roller.profile=logarithmic", f"bearing.roller.drop={drop} um")
        for drop in ("1.92", "7.7")
    },
    "clearance within CN and its fits": single("bearing.fits.at", "tightest", "loosest"),
    "clearance class": single("bearing.clearance_class", "C2", "C4"),
    "limiting shear stress over pressure": single("lubricant.limiting_ratio", "0.035", "0.088"),
    "cage on a land, clearance": {
        f"{gap} mm": (*LAND, f"bearing.cage.land_clearance={gap} mm") for gap in ("0.2", "0.6")
    },
    "oil temperature": single("lubricant.inlet_temperature", "60 degC", "80 degC"),
}


@dataclass(frozen=True)
class Bearing:
    """A case and the numbers that are changed in it."""

    title: str
    case: str
    settings: tuple[str, ...]
    numbers: dict[str, Ends]


BEARINGS = (
    Bearing("NU 210 from its catalogue, 5 kN", "configs/catalogue/nu210.toml", (), CATALOGUE),
    Bearing(
        "the same, 100 N at 6000 rpm", "configs/catalogue/nu210.toml",
        ("operation.radial_load=100 N", "operation.inner_speed=6000 rpm"), CATALOGUE,
    ),
    Bearing(
        "NU 209 with fits and rough surfaces, 4.45 kN", "configs/nu209_fits.toml", (),
        {
            OIL: single(OIL, "0.005", "0.1"),
            **COMMON,
            "boundary friction": single(MIXED, "0.05", "0.15"),
            "crowning, drop A": single("bearing.roller.drop", "1.75 um", "7 um"),
            "clearance before mounting": single("bearing.fits.cold_clearance", "40 um", "80 um"),
            "limiting shear stress over pressure": single("lubricant.limiting_ratio", "0.035", "0.088"),
            "gap around the rollers": single("lubricant.churning_gap", "0.5 mm", "2 mm"),
            "oil temperature": single("lubricant.inlet_temperature", "60 degC", "80 degC"),
        },
    ),
    Bearing(
        "Mao (2016), flexible rings, 38 000 rpm", "configs/mao2016.toml", (),
        {
            OIL: single(OIL, "0.03", "0.5"),
            **COMMON,
            "crowning, drop A": single("bearing.roller.drop", "0.875 um", "3.5 um"),
            "clearance in operation": single("bearing.clearance", "50 um", "100 um"),
            "traction: limiting stress, Eyring": {
                ratio: ("lubricant.traction=eyring", f"lubricant.limiting_ratio={ratio}")
                for ratio in ("0.035", "0.088")
            },
            "cage land clearance": single("bearing.cage.land_clearance", "0.2 mm", "0.8 mm"),
            "oil temperature": single("lubricant.inlet_temperature", "210 degC", "230 degC"),
        },
    ),
)  # fmt: skip
NAMES = {OIL: "oil fraction"}
OUTPUTS = "life", "slip", "stiffness", "torque"
LEAST = {"life": 5.0, "slip": 0.5, "stiffness": 5.0, "torque": 5.0}  # [%] smaller changes do not fill a panel


@dataclass(frozen=True)
class Row:
    """A bearing with one number at one end, or as it stands."""

    bearing: str
    number: str  # empty: as the case stands
    value: str
    status: str
    life: float  # [Mrev] modified where the case modifies it
    slip: float  # [-] of the cage
    stiffness: float  # [N/m] radial, from base to shaft ends
    torque: float  # [N m] of the inner ring
    message: str


def solved(bearing: Bearing, number: str, value: str, settings: tuple[str, ...]) -> Row:
    """Run the case with these settings."""
    result = run(bearing.case, (*bearing.settings, *settings))
    status, state = str(result.attributes["status"]), result.flexible
    life = slip = stiffness = torque = float("nan")
    message = str(result.attributes["message"])
    if status == "converged":
        life = float(state["modified_life"] if "modified_life" in state else state["life_L10"]) / 1e6
        slip, message = float(state["cage_slip"]), ""
        stiffness, torque = float(state["total_stiffness"]), float(state["driving_torque"])
    return Row(bearing.title, number, value, status, life, slip, stiffness, torque, message)


def computed() -> Iterator[Row]:
    """All rows, bearing by bearing."""
    for bearing in BEARINGS:
        yield solved(bearing, "", "", ())
        for number, ends in bearing.numbers.items():
            for value, settings in ends.items():
                yield solved(bearing, NAMES.get(number, number), value, settings)


def stored() -> list[Row]:
    """Rows of the last run."""
    with CSV.open(newline="", encoding="utf-8") as file:
        return [
            Row(
                row["bearing"], row["number"], row["value"], row["status"], float(row["life"]),
                float(row["slip"]), float(row["stiffness"]), float(row["torque"]), row["message"],
            )
            for row in csv.DictReader(file)
        ]  # fmt: skip


def store(rows: list[Row]) -> None:
    with CSV.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(f.name for f in fields(Row))
        writer.writerows(
            [f"{cell:.6g}" if isinstance(cell, float) else cell for cell in astuple(row)] for row in rows
        )


@dataclass(frozen=True)
class Effect:
    """What one number does: life, stiffness and torque over those of the case, slip [%], at both ends."""

    number: str
    values: tuple[str, str]
    life: tuple[float, float]
    slip: tuple[float, float]
    stiffness: tuple[float, float]
    torque: tuple[float, float]


def effects(rows: list[Row]) -> dict[str, tuple[Row, list[Effect]]]:
    """Case as it stands and effects, by bearing."""
    found: dict[str, tuple[Row, list[Effect]]] = {}
    for title in dict.fromkeys(row.bearing for row in rows):
        base, *others = (row for row in rows if row.bearing == title)
        pairs = zip(others[::2], others[1::2], strict=True)
        found[title] = base, [_effect(base, low, high) for low, high in pairs]
    return found


def _effect(base: Row, low: Row, high: Row) -> Effect:
    return Effect(
        low.number, (low.value, high.value), (low.life / base.life, high.life / base.life),
        (100 * low.slip, 100 * high.slip),
        (low.stiffness / base.stiffness, high.stiffness / base.stiffness),
        (low.torque / base.torque, high.torque / base.torque),
    )  # fmt: skip


def tables(rows: list[Row]) -> dict[str, str]:
    """One Markdown table of all bearings."""
    lines = ["| number | from, to | life, times | cage slip [%] | stiffness, times | torque, times |"]
    lines.append("|---|---|---|---|---|---|")
    for title, (base, some) in effects(rows).items():
        lines.append(f"| **{title}** | as it stands | 1 | {_percent(100 * base.slip)} | 1 | 1 |")
        for one in (one for one in some if _matters(one, 100 * base.slip)):
            cells = [
                ", ".join(one.values), _pair(one.life), ", ".join(map(_percent, one.slip)),
                _pair(one.stiffness), _pair(one.torque),
            ]  # fmt: skip
            lines.append(f"| {one.number} | " + " | ".join(cells) + " |")
    return {"sensitivity": "\n".join(lines)}


def _matters(one: Effect, slip: float) -> bool:
    """Whether an output changes by more than the least that a panel of the picture shows."""
    return any(abs(change) > LEAST[name] for name in OUTPUTS for change in _changes(one, name, slip))


def _pair(values: tuple[float, float]) -> str:
    return ", ".join(f"{value:.3g}" if isfinite(value) else "no answer" for value in values)


def _percent(value: float) -> str:
    """Slips are told to 0.001 %: less is below what they matter."""
    return f"{value:.3f}".rstrip("0").rstrip(".").replace("-0", "0") if abs(value) < 0.001 else f"{value:.3g}"


def draw(rows: list[Row]) -> None:
    """A tornado for each bearing and output, numbers that matter most on top."""
    from matplotlib.figure import Figure

    from flexbearing.report.picture import plain_grid

    found = effects(rows)
    counts = [len(some) for _, some in found.values()]
    figure = Figure(figsize=(13, 1.2 + 0.33 * (sum(counts) + 2 * len(counts))), layout="constrained")
    panels = figure.subplots(len(found), 4, height_ratios=[count + 2 for count in counts])
    for row, (title, (base, some)) in zip(panels, found.items(), strict=True):
        ordered = sorted(some, key=lambda one, some=some: _weight(one, some))
        row[0].set_title(title, fontsize=10, loc="left", fontweight="bold")
        for axes, name in zip(row, OUTPUTS, strict=True):
            middle = 100 * base.slip if name == "slip" else 0.0
            for place, one in enumerate(ordered):
                ends = zip(_changes(one, name, middle), (0.17, -0.17), (BLUE, ORANGE), strict=True)
                for change, shift, colour in ends:
                    axes.barh(place + shift, change, left=middle, height=0.34, color=colour)
            axes.axvline(middle, color="0.3", linewidth=0.8)
            low, high = axes.get_xlim()
            axes.set_xlim(min(low, middle - LEAST[name]), max(high, middle + LEAST[name]))
            axes.set_yticks(range(len(ordered)), [_label(one) for one in ordered] if name == "life" else [])
            axes.tick_params(labelsize=8)
            axes.set_xlabel("cage slip [%]" if name == "slip" else f"change of {name} [%]", fontsize=8.5)
            plain_grid(axes)
    handles = panels[0, 0].patches[:2]
    figure.legend(handles, ["first value", "second value"], loc="outside lower center", ncols=2)
    figure.savefig(PNG, dpi=110)


def _changes(one: Effect, name: str, middle: float) -> list[float]:
    """Changes at both ends [%], of the slip in its own percent."""
    ends = getattr(one, name)
    return [end - middle if name == "slip" else 100 * (end - 1) for end in ends]


def _label(one: Effect) -> str:
    return f"{one.number}: {one.values[0]}, {one.values[1]}"


def _weight(one: Effect, some: list[Effect]) -> float:
    """Sum over the outputs: span of this number over the largest span, where that one matters."""
    spans = {
        name: [abs(each[0] - each[1]) for each in (_changes(e, name, 0.0) for e in some)] for name in OUTPUTS
    }
    return sum(spans[name][some.index(one)] / max(*spans[name], LEAST[name]) for name in OUTPUTS)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--page", action="store_true", help="from the stored table")
    asked = parser.parse_args()
    print(describe())
    if not asked.page:
        rows = []
        for row in computed():
            rows.append(row)
            print(row, flush=True)
        store(rows)
    draw(stored())
    fill(PAGE, tables(stored()))


if __name__ == "__main__":
    main()
