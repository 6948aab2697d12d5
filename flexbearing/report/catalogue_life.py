"""The life of a case against that of a catalogue, as text."""

from collections.abc import Iterator, Sequence
from typing import Any

from rich.console import RenderableType
from rich.text import Text

from flexbearing.quantities.life_records import Ratings, Stage
from flexbearing.report.html.document import Table
from flexbearing.report.sections import listed, titled

_NAMES = {
    "C_r": "dynamic, C_r",
    "C_0r": "static, C_0r",
    "C_u": "fatigue limit, C_u",
}
TOLD = 0.01  # change of the life that is worth a sentence
_STANDARDS = {"C_r": "ISO 281", "C_0r": "ISO 76", "C_u": "ISO 281, from C_0r"}


def sections(found: dict[str, Any]) -> Iterator[RenderableType]:
    """Ratings, then every life from the catalogue's to that of the case with what lies between."""
    yield Text(found["title"], style="bold")
    yield from against_catalogue(found)


def against_catalogue(found: dict[str, Any] | None) -> Iterator[RenderableType]:
    """The same below the title of a page; nothing where it was not requested."""
    if found:
        yield from _ratings(Ratings(**found["ratings"]))
        yield from _way([Stage(**each) for each in found["stages"]])


def _ratings(found: Ratings) -> Iterator[RenderableType]:
    ratings: list[tuple[str, ...]] = []
    for name, words in _NAMES.items():
        source = (
            f"given by the case{scaled(found, name)}"
            if name in found.given
            else f"formula of {_STANDARDS[name]}"
        )
        used, formula = (_kilonewtons(values[name]) for values in (found.ratings_N, found.formulas_N))
        ratings.append((words, used, formula, source))
    yield from titled("", Table(("load rating [kN]", "used", "by formula", "source"), tuple(ratings)))
    rows = [
        *_loads(found),
        *_beyond(found),
        f"static safety s_0 = {found.static_safety:.3g}",
        f"basic rating life L10 = {_life(found.life_Mrev, found.life_h)}",
    ]
    if found.a_ISO and found.modified_Mrev and found.modified_h:  # all of them or none
        rows.append(
            f"modified rating life = {_life(found.modified_Mrev, found.modified_h)}, with a_ISO = "
            f"{found.a_ISO:.3g} at kappa = {found.viscosity_ratio:.3g}"
        )
    yield from listed("as a catalogue computes it", rows)


def scaled(found: Ratings, name: str) -> str:
    """What a given rating is multiplied by where settings change sizes of the file; empty elsewhere."""
    scale = found.scales.get(name, 1.0)
    return "" if scale == 1 else f", times {scale:.4g} by the formula"


def _loads(found: Ratings) -> Iterator[str]:
    """The load that rates the bearing, and how it is made of a radial and an axial one."""
    load, parts = found.load_N, found.equivalent_load
    over = f"C_r/P = {found.ratings_N['C_r'] / load:.4g}"
    if parts is None:
        yield f"radial load P = {_kilonewtons(load)} kN, {over}"
        return
    radial, axial, at_rest = (_kilonewtons(parts[name]) for name in ("F_r_N", "F_a_N", "P_0_N"))
    yield f"loads F_r = {radial} kN, F_a = {axial} kN, e = {parts['e']:.3g}"
    yield f"P = {parts['X']:.3g} F_r + {parts['Y']:.3g} F_a = {_kilonewtons(load)} kN, {over}"
    if parts["note"]:
        yield parts["note"]
    yield f"P_0 = {parts['X_0']:.3g} F_r + {parts['Y_0']:.3g} F_a = {at_rest} kN"


def _beyond(found: Ratings) -> Iterator[str]:
    """A load that ISO 281 leaves to the maker: above C_r/2, and for balls above C_0r."""
    ratings = found.ratings_N
    limits = {"C_r/2": ratings["C_r"] / 2} | ({"C_0r": ratings["C_0r"]} if found.equivalent_load else {})
    passed = " and ".join(name for name, limit in limits.items() if found.load_N > limit)
    if passed:
        yield f"P is above {passed}: ISO 281 leaves it to the maker whether its formula holds"


def _kilonewtons(force: float | None) -> str:
    return "-" if force is None else f"{force / 1e3:,.4g}"


def _life(turns: float, hours: float) -> str:
    return f"{turns:,.4g} Mrev, {hours:,.4g} h"


def _way(stages: Sequence[Stage]) -> Iterator[RenderableType]:
    lives: list[tuple[str, ...]] = []
    for stage in stages:
        factor = "" if stage.factor is None else f"{stage.factor:.4g}"
        lives.append((stage.name, factor, f"{stage.life_Mrev:,.4g}", f"{stage.life_h:,.4g}"))
    head = ("", "factor", "life [Mrev]", "life [h]")
    yield from titled("from the life of the catalogue to that of the case", Table(head, tuple(lives)))
    yield from listed("reasons of the factors that differ from 1 by more than 1 %", list(why(stages)))
    lines = [f"{stage.name}: {_options(stage.left_out_by)}" for stage in stages if stage.left_out_by]
    yield from listed("settings of `flexbearing run` that leave an influence out", lines)
    yield Text(
        "Each life contains the influences of its line and of those above. Settings for the first line:"
    )
    yield Text(f"  {_options(stages[0].settings)}\n")


def why(stages: Sequence[Stage]) -> Iterator[str]:
    """A sentence on each factor that differs from 1 by more than `TOLD`."""
    for stage in stages:
        if stage.meaning and stage.factor is not None and abs(stage.factor - 1) > TOLD:
            yield f"{stage.name}: {stage.meaning}"


def _options(settings: list[str]) -> str:
    return " ".join(f'--set "{setting}"' for setting in settings)
