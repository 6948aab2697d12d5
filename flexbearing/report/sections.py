"""Sections of the page below its table of numbers."""

from collections.abc import Iterable, Iterator
from typing import Any

from rich import box
from rich.console import RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from flexbearing.quantities.attributes import GRADES
from flexbearing.quantities.layout import Layout
from flexbearing.quantities.reductions import RACES
from flexbearing.quantities.roller import CONTACT, SKEW
from flexbearing.report.rows import label, rows, shown, value

_STRESSES = (  # column, name, format, name of its error
    ("Mises", "von_mises_MPa", ",.0f", "von_mises_error_MPa"),
    ("x", "x_mm", ".1f", ""),
    ("r", "radius_mm", ".1f", ""),
    ("deg", "azimuth_deg", ".1f", ""),
    ("tension", "tension_MPa", ",.0f", "tension_error_MPa"),
    ("compr.", "compression_MPa", ",.0f", "compression_error_MPa"),
    ("um", "displacement_um", ",.0f", ""),
)
_EQUILIBRIA = (  # column, name, format
    ("load [N]", "largest_inner_load_N", ",.1f"),
    ("loaded", "loaded_rollers", "d"),
    ("life [Mrev]", "life_L10_Mrev", ",.4g"),
    ("torque [N m]", "driving_torque_Nm", ".4g"),
    ("loss [W]", "power_loss_W", ",.4g"),
    ("slip [%]", "slip_percent", ".3g"),
)
AXES = ("x", "y", "z", "about y", "about z")


def listed(title: str, lines: list[str]) -> Iterator[RenderableType]:
    """A title with indented lines; nothing without lines."""
    if not lines:
        return
    yield Text(title, style="bold")
    for line in lines:
        yield Padding(Text(line), (0, 0, 0, 2), expand=False)
    yield Text("")


def opening(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Dangers, each in a line of its own, then the title."""
    for note in numbers["notes"]:
        if note["grade"] == GRADES[0]:
            yield Text(f"DANGER: {note['text']}", style="bold red")
    yield Text(numbers["title"], style="bold")


def closing(numbers: dict[str, Any], ending: str) -> Iterator[RenderableType]:
    """Assumed and calibrated keys, notes that are no dangers, and in a line how the run ended."""
    yield from listed("assumed (not known, chosen)", numbers["assumed"])
    fitted = [f"{key}: {to}" for key, to in numbers["calibrated"].items()]
    yield from listed("fitted, so no validation", fitted)
    yield from noted(note for note in numbers["notes"] if note["grade"] != GRADES[0])
    converged = numbers["status"] == "converged"
    yield Text(ending, style="bold green" if converged else "bold red")


def noted(notes: Iterable[dict[str, str]]) -> Iterator[RenderableType]:
    """Notes by grade, the gravest first."""
    texts: dict[str, list[str]] = {grade: [] for grade in GRADES}
    for note in notes:
        texts[note["grade"]].append(note["text"])
    for grade, lines in texts.items():
        yield from listed(grade, lines)


def tilt(held: dict[str, Any] | None) -> Iterator[RenderableType]:
    """How the inner ring is held; nothing of a result that does not say it."""
    if held:
        yield Text(f"inner ring: {_tilting(held['inner_ring'])}{_otherwise(held.get('otherwise'))}\n")


def _tilting(choice: str) -> str:
    words = {"fixed": "its tilt is held", "free": "free to tilt"}.get(choice, "")
    return f'{words} (operation.tilt = "{choice}")'


def _otherwise(other: dict[str, Any] | None) -> str:
    """What the other way to hold the ring gives; nothing where it is not known."""
    if other is None:
        return ""
    moment = f", held by {other['ring_moment_Nm']:,.3g} N m" if other["inner_ring"] == "fixed" else ""
    load, life = f"{other['max_roller_load_N']:,.1f} N", f"{other['life_L10_Mrev']:,.2f} Mrev"
    choice = f'operation.tilt = "{other["inner_ring"]}"'
    return f"\n  with {choice} about {load} largest roller load and a life L10 of {life}{moment}"


def clearance_steps(clearance: dict[str, Any]) -> Iterator[RenderableType]:
    """How the operating clearance came about; nothing when the case states it, or the run did not end."""
    if not clearance.get("steps"):
        return
    yield Text("operating clearance, diametral, step by step", style="bold")
    table = right_aligned("", "change [um]", "after [um]")
    table.add_column("")
    table.add_row("cold", "", f"{clearance['cold_m'] * 1e6:.3f}", "before mounting")
    for step in clearance["steps"]:
        table.add_row(
            Text(step["name"]),
            f"{step['change_m'] * 1e6:+.3f}",
            f"{step['clearance_m'] * 1e6:.3f}",
            Text(step["explanation"]),
        )
    yield table
    fits = [f"{seat}: {clearance[f'{seat}_fit']}" for seat in ("shaft", "housing")]
    yield from listed("in operation", [clearance["verdict"], *fits])


def tolerances(clearance: dict[str, Any]) -> Iterator[RenderableType]:
    """What the classes of fits and clearance allow; nothing where the case names none."""
    found = clearance.get("tolerances")
    if not found:
        return
    yield Text(f'tolerances, diametral; computed at bearing.fits.at = "{found["at"]}"', style="bold")
    table = right_aligned("", "least [um]", "computed [um]", "greatest [um]")
    for row in found["classes"]:
        limits = (f"{row[name] * 1e6:.1f}" for name in ("least_m", "used_m", "greatest_m"))
        table.add_row(Text(f"{row['name']} {row['class']}"), *limits)
    if ends := found.get("ends"):
        across = (ends["tightest_m"], clearance["operating_m"], ends["loosest_m"])
        table.add_row("operating clearance", *(f"{value * 1e6:.1f}" for value in across))
    yield table


def life_factors(lives: dict[str, Any]) -> Iterator[RenderableType]:
    """Every factor between the basic and the modified life; nothing when none was requested."""
    if not lives:
        return
    yield Text("modified life", style="bold")
    table = right_aligned("", *lives)
    table.add_column("note")
    first, *_ = lives.values()
    table.add_row("basic life L10 [Mrev]", *(f"{life['basic_Mrev']:,.2f}" for life in lives.values()))
    for place, factor in enumerate(first["factors"]):
        values = [f"{life['factors'][place]['value']:.4g}" for life in lives.values()]
        table.add_row(Text(f"x {factor['name']}"), *values, Text(_notes(lives, place)))
    if all("modified_Mrev" in life for life in lives.values()):
        table.add_row("modified life [Mrev]", *(f"{life['modified_Mrev']:,.2f}" for life in lives.values()))
    yield table


def ordered_levels(choices: dict[str, Any], errors: dict[str, Any]) -> Iterator[RenderableType]:
    """Levels that were chosen for an accuracy, and why; nothing when none was ordered."""
    if not errors:
        return
    met = "estimated to be kept" if errors["met"] else "NOT kept"
    yield Text(f"accuracy of {100 * errors['target']:g} % of loads and life: {met}", style="bold")
    table = right_aligned("", "load +- [%]", "life +- [%]", "allowed [%]")
    table.add_column("level")
    for name, choice in choices.items():
        changes = [choice["changes"].get(output) for output in ("roller_load", "life")]
        percent = ["-" if change is None else f"{100 * change * choice['factor']:.2g}" for change in changes]
        level = choice["level"] + (" (fixed by the case)" if choice["fixed"] else "")
        table.add_row(Text(name), *percent, f"{100 * choice['allowed']:.2g}", Text(level))
    yield table
    unusable = [f"{level}: {why}" for choice in choices.values() for level, why in choice["unusable"].items()]
    yield from listed("levels not computed", unusable)


def matrices(block: dict[str, Any]) -> Iterator[RenderableType]:
    """Stiffness and compliance of the end state, as far as it has them."""
    titles = {
        "stiffness_matrix_SI": "tangent stiffness [N, m, rad]",
        "compliance_matrix_SI": "tangent compliance [m, rad, N]; infinite along x",
    }
    for name, title in titles.items():
        if block.get(name) is not None:
            yield from matrix(title, block[name])


def matrix(
    title: str, rows: list[list[float | None]], axes: tuple[str, ...] = AXES
) -> Iterator[RenderableType]:
    """A matrix with named axes."""
    yield Text(title, style="bold")
    table = right_aligned("", *axes)
    for axis, row in zip(axes, rows, strict=True):
        table.add_row(axis, *("-" if value is None else f"{value:.3e}" for value in row))
    yield table


def regimes(by_block: dict[str, Any]) -> Iterator[RenderableType]:
    """Lubrication regime of each raceway; nothing when the roughness is not known."""
    lines = [
        f"{name}: inner raceway {words['inner']}, outer raceway {words['outer']}"
        for name, words in by_block.items()
    ]
    return listed("lubrication regime, at the smallest film ratio", lines)


def equilibria(by_block: dict[str, Any] | None) -> Iterator[RenderableType]:
    """The computed equilibrium of each block beside others; nothing where no others were found."""
    for name, found in (by_block or {}).items():
        yield Text(f"several equilibria, {name}: between {found['raceways']}", style="bold")
        yield Text("largest roller load, loaded rollers, life L10, driving torque, power loss, cage slip")
        table = right_aligned("", *(column for column, _, _ in _EQUILIBRIA))
        rows = {"computed": found["computed"]}
        rows |= {f"other {number}": other for number, other in enumerate(found["others"], 1)}
        if "after_passing_pitches" in found:
            rows["passing pitches"] = found["after_passing_pitches"]
        for title, figures in rows.items():
            numbers = ((figures[key], digits) for _, key, digits in _EQUILIBRIA)
            table.add_row(title, *("-" if one is None else format(one, digits) for one, digits in numbers))
        yield table


def skew(layout: Layout, blocks: dict[str, Any]) -> Iterator[RenderableType]:
    """Skew of the rollers between flanges; nothing for a case without them."""
    skewed = {name: block for name, block in blocks.items() if block and block.get("skew")}
    if not skewed:
        return
    yield Text("roller skew between guide flanges; without effect on loads and speeds", style="bold")
    table = right_aligned("", *skewed)
    for entry in rows(layout, SKEW):
        table.add_row(Text(label(entry)), *(shown(entry, value(entry, block)) for block in skewed.values()))
    yield table


def contacts(layout: Layout, blocks: dict[str, Any]) -> Iterator[RenderableType]:
    """Where both raceways are pressed most, how widely, and what it does below their surface."""
    solved = {name: block for name, block in blocks.items() if block}
    if not solved or not rows(layout, CONTACT):
        return
    yield Text("most pressed contacts, with stresses below the surface", style="bold")
    table = right_aligned("", *(word for name in solved for word in (f"{name}: inner", "outer")))
    for entry in rows(layout, CONTACT):
        known = [block for block in solved.values() if block[entry.key] is not None]
        values = [shown(entry, value(entry, block, race)) for block in known for race in RACES]
        if known:
            table.add_row(Text(label(entry)), *values)
    yield table


def held(structure: dict[str, Any] | None) -> Iterator[RenderableType]:
    """Radial stiffness of what holds each raceway, with its error; nothing where that is unknown."""
    lines = []
    for name, figures in (structure or {}).items():
        stiffness = figures["support_stiffness_N_per_m"]
        error = figures.get("support_stiffness_error_N_per_m")
        if stiffness is not None:
            spread = "" if error is None else f" +- {1e-6 * error:,.2g}"
            lines.append(f"{name}: {1e-6 * stiffness:,.1f}{spread} kN/mm")
    yield from listed("radial stiffness of the supports alone", lines)


def stresses(parts: dict[str, Any] | None) -> Iterator[RenderableType]:
    """Largest stresses of each body with their errors, stiffness of supports; nothing without parts."""
    if not parts:
        return
    yield Text("largest stresses [MPa] away from loaded rollers and sharp edges", style="bold")
    yield Text(
        "von Mises and where [mm, deg]; tension, compression, with their errors; displacement anywhere [um]"
    )
    table = right_aligned("", *(column for column, *_ in _STRESSES))
    for name, part in parts.items():
        for body, most in part["bodies"].items():
            table.add_row(Text(f"{name}: {body}"), *_cells(most))
    yield table
    yield from listed("loads, cost; stiffness of the supports alone", _lines(parts))


_READINGS = {  # column of the table to its key
    "deg": ("azimuth_deg", ".1f"),
    "gauge": ("gauge_strain_um_per_m", ",.1f"),
    "+-": ("strain_error_um_per_m", ".2g"),
    "hoop": ("hoop_strain_um_per_m", ",.1f"),
    "axial": ("axial_strain_um_per_m", ",.1f"),
    "largest": ("largest_strain_um_per_m", ",.1f"),
    "smallest": ("smallest_strain_um_per_m", ",.1f"),
    "um": ("radial_displacement_um", ",.2f"),
}


def probes(found: dict[str, list[float]] | None) -> Iterator[RenderableType]:
    """What probes read; nothing without probes."""
    if not found:
        return
    yield Text(
        "probes: strains [um/m] along the gauge, hoop, axial, principal; outward displacement", style="bold"
    )
    table = right_aligned("", *_READINGS)
    for place in range(len(found["azimuth_deg"])):
        cells = (format(found[key][place], form) for key, form in _READINGS.values())
        table.add_row(Text(f"{place + 1}"), *cells)
    yield table


def _cells(most: dict[str, float]) -> Iterator[str]:
    """A row of the stresses of a body, with their errors."""
    for _, key, form, error in _STRESSES:
        yield format(most[key], form) + (f" ± {most[error]:,.0f}" if error else "")


def _lines(parts: dict[str, Any]) -> list[str]:
    lines = []
    for name, part in parts.items():
        support, left_out = part["support"], part["left_out"]
        without = f", without {left_out}" if left_out else ""
        lines += [
            f"{name}: under {part['loads']}{without}; {part['seconds']:.1f} s",
            f"{name}: {1e-3 * support['tilting_Nm_per_rad']:,.2f} "
            f"+- {1e-3 * support['tilting_error_Nm_per_rad']:,.2f} N m/mrad tilting, "
            f"{1e-6 * support['axial_N_per_m']:,.1f} +- {1e-6 * support['axial_error_N_per_m']:,.1f} "
            "kN/mm axial",
        ]
    return lines


def right_aligned(*columns: str) -> Table:
    """An empty table whose columns are aligned to the right, but for the first."""
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    for place, name in enumerate(columns):
        table.add_column(Text(name), justify="right" if place else "left", no_wrap=bool(place))
    return table


def _notes(lives: dict[str, Any], place: int) -> str:
    """What is said of a factor; once when every block says the same."""
    notes = {name: life["factors"][place]["note"] for name, life in lives.items()}
    if len(set(notes.values())) == 1:
        return next(iter(notes.values()))
    return "\n".join(f"{name}: {note}" for name, note in notes.items())
