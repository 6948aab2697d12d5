"""Profiles of rollers and raceways: drop over the place along the roller, magnified."""

from collections.abc import Mapping
from math import exp, sqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.report.drawing.sheet import Drawing, Sheet
from flexbearing.report.drawing.words import AXES, ELEMENT, INNER, OUTER, Words

BODY = {"bearing.roller": ELEMENT, "bearing.inner_raceway": INNER, "bearing.outer_raceway": OUTER}
TALL, GAP, SOLID = 0.3, 0.16, 0.06  # of a drop, between profiles, below the drop, over the roller's length
END = 0.99  # of half the length, up to which drops without bound are drawn
AMPLITUDE = sqrt(1 - exp(-1))  # 2x/l where the logarithmic profile has dropped by A [-]
ROUND = (1, 2, 5)
APART = 0.075  # of marks of the ruler, over the roller's length: room for their words
MEANING = {
    "logarithmic": "logarithmic: A ln 1/(1 - (2x/l)²), with A, the drop, at 0.795 of half the length l.",
    "iso16281": "iso16281: logarithmic, A = 0.00035 bearing.roller.diameter at 0.795 of half the length.",
    "lundberg": "lundberg: logarithmic, A = 2 Q/(π l E') at 0.795 of half the length, Q the design_load.",
    "johns_gohar": "johns_gohar: logarithmic with an end, for Q, the design_load.",
    "fujiwara_kawase": "fujiwara_kawase: K₁ load_factor, K₂ crowned_share of each half, z_m end_drop.",
    "points": "points: monotone between the points.",
    "crowned": "crowned: one circle around mid-roller, with corners beside the straight middle.",
    "tangent_crowned": "tangent_crowned: circles that touch the straight middle.",
}


def profiles(words: Words, drops: Mapping[str, tuple[NDArray, NDArray]]) -> Drawing:
    """Draw the profiles that are not straight, one above the other."""
    sheet, length = Sheet("profile", words), words.value("bearing.roller.length")
    highest = {table: _highest(*line) for table, line in drops.items()}
    magnified = _below(TALL * length / max(highest.values()))
    top = 0.0
    for table, (places, drop) in drops.items():
        seen = drop <= highest[table]
        _body(sheet, table, (places[seen], top - magnified * drop[seen]), length)
        _ruler(sheet, top, magnified, highest[table], length)
        _label(sheet, table, (places, drop), (top, magnified))
        top -= magnified * highest[table] + (SOLID + GAP) * length
    sheet.length("bearing.roller.length", -length / 2, length / 2, top + GAP * length)
    sheet.notes.append(
        f"Drop from the straight generatrix (dash-dotted) into the body, magnified {magnified:g} times."
    )
    tables = [words.value(f"{table}.profile") for table in drops]
    sheet.notes.extend(MEANING[name] for name in dict.fromkeys(tables))
    if not all(np.isfinite(drop).all() for _, drop in drops.values()):
        sheet.notes.append(f"A drop without bound at the end is drawn up to {END:g} of half the length.")
    names = ", ".join(f"{table}.profile = {name}" for table, name in zip(drops, tables, strict=True))
    return sheet.drawn(
        f"Profiles along a roller, drop magnified {magnified:g} times; {names}.",
        f"Drop of the profiles over the place along a roller, magnified; {names}.",
    )


def _highest(places: NDArray, drop: NDArray) -> float:
    """Largest drop that is drawn [m]."""
    if np.isfinite(drop).all():
        return float(drop.max())
    return float(np.max(drop[np.abs(places) <= END * places.max()]))


def _below(wanted: float) -> float:
    """The largest of 1, 2, 5, 10, ... that is not above a number."""
    ten = 10.0 ** np.floor(np.log10(wanted))
    return float(ten * max(step for step in ROUND if step * ten <= wanted * (1 + 1e-9)))


def _body(sheet: Sheet, table: str, line: tuple[NDArray, NDArray], length: float) -> None:
    """Body below its generatrix, and the straight generatrix."""
    outline, bottom = np.stack(line, axis=1), float(line[1].min()) - SOLID * length
    straight = float(line[1].max())
    ends = [
        (length / 2, outline[-1, 1]),
        (length / 2, bottom),
        (-length / 2, bottom),
        (-length / 2, outline[0, 1]),
    ]
    sheet.area([*outline, *ends], fc=BODY[table], lw=0.4, ec="0.5")
    level = 0.4 * straight + 0.6 * bottom
    sheet.line([(0.0, level), (0.12 * length, level)], ec=AXES, arrowstyle="->", lw=0.8)
    sheet.line([(0.0, level - 0.01 * length), (0.0, level + 0.01 * length)], ec=AXES, lw=0.8)
    sheet.word("+x, from mid-roller", (0.13 * length, level), color=AXES, bbox=None, ha="left")
    sheet.line(outline, table.replace(".", "-"), lw=1.2)
    sheet.line([(-0.53 * length, straight), (0.6 * length, straight)], ec="0.4", lw=0.4, ls=(0, (8, 2, 1, 2)))


def _ruler(sheet: Sheet, top: float, magnified: float, highest: float, length: float) -> None:
    """Round drops on the right of a profile."""
    step = _below(max(highest / 2, 2.5 * APART * length / magnified))  # at least APART
    x = 0.53 * length
    marks = np.arange(0.0, highest * (1 + 1e-9), step)
    if len(marks) == 1:
        marks = np.array([highest])
    sheet.line([(x, top), (x, top - magnified * highest)], lw=0.5)
    for mark in marks:
        y = top - magnified * mark
        sheet.line([(x, y), (x + 0.015 * length, y)], lw=0.5)
        sheet.word(f"{1e6 * mark:.3g} µm", (x + 0.025 * length, y), ha="left")
    sheet.line([(x, top), (x + 0.16 * length, top)], ec="none")  # room for the words


def _label(sheet: Sheet, table: str, line: tuple[NDArray, NDArray], place: tuple[float, float]) -> None:
    """Keys of a profile where they can be seen."""
    (places, drop), (top, magnified), words = line, place, sheet.words
    end, profile = float(places.max()), words.value(f"{table}.profile")

    def at(part: float) -> tuple[float, float]:
        """A place of the profile, by 2x/l."""
        dropped = float(np.interp(part * end, places, drop))
        return part * end, top - magnified * dropped

    sheet.label(f"{table}.profile", at(0.0))
    straight: Any = words.value(f"{table}.straight_length")
    if straight:
        sheet.length(f"{table}.straight_length", -straight / 2, straight / 2, top)
    sheet.label(f"{table}.crown_radius", at((1 + (straight or 0.0) / (2 * end)) / 2), "R ")
    sheet.height(f"{table}.drop", top, at(-AMPLITUDE)[1], -AMPLITUDE * end)
    for name in ("design_load", "load_factor"):
        sheet.label(f"{table}.{name}", at(AMPLITUDE))
    share: Any = words.value(f"{table}.crowned_share")
    if share:
        sheet.length(f"{table}.crowned_share", (1 - share) * end, end, at(1 - share)[1])
    sheet.height(f"{table}.end_drop", top, at(-1.0)[1], -end)
    if profile == "points":
        for name in ("points_file", "point_positions", "point_drops"):
            sheet.label(f"{table}.{name}", at(0.9))
