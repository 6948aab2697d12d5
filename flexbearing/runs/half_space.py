"""The most loaded roller of a case on half-spaces, where the case requires it."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from flexbearing.case.roller import Case
from quasidynamic import Equilibrium, NotSolved, OutOfRange
from quasidynamic.note import Note, information, outside

if TYPE_CHECKING:
    from quasidynamic.outcome.whole_roller import WholeRoller

MICROMETRE, GIGAPASCAL = 1e-6, 1e9
RACEWAYS = ("inner", "outer")
RESOLVED = 0.02  # of the peak pressure: an estimated error that is worth a word (assumed)


def most_loaded(case: Case, state: Equilibrium) -> "tuple[WholeRoller | None, tuple[Note, ...]]":
    """Whole roller of a solved state, with what must be said of it."""
    if case.bearing.contact != "half_space":
        return None, ()
    from quasidynamic.outcome.whole_roller import whole_roller  # brings Fourier transforms

    try:
        whole = whole_roller(state)
    except (NotSolved, OutOfRange) as problem:
        reason = f"peak pressure and life are those of the slices, half-spaces were not solved: {problem}"
        return None, (outside("no-whole-roller", reason),)
    return whole, tuple(_notes(state, whole))


def _kept(state: Equilibrium) -> str:
    """What a whole roller has of its slices besides the load."""
    return "moments" if state.balance.points.free_tilt[0, 0] else "tilts"


def _notes(state: Equilibrium, whole: "WholeRoller") -> Iterator[Note]:
    pressure = whole.peak_pressure / state.peak_pressure - 1
    azimuth = np.degrees(state.balance.roller.bearing.azimuths[whole.number])
    yield information(
        "whole-roller",
        f"most loaded roller, at {azimuth:.4g} deg: solved on half-spaces; peak pressures {pressure[0]:+.1%} "
        f"(inner) and {pressure[1]:+.1%} (outer), life {whole.life / state.life - 1:+.1%} against slices "
        f"alone; loads and {_kept(state)} are those of the slices, free end faces and flanges are left out",
    )
    yield from _sharp_end(state, whole)
    share = np.where(whole.peak_at_ends, 0.0, whole.pressure_error / whole.peak_pressure).max()
    if share > RESOLVED:
        yield outside(
            "whole-roller-resolution",
            f"peak pressure: numerical error of about {share:.0%}, of cells on the most loaded roller whose "
            "pressure rises close to an end",
        )


def _sharp_end(state: Equilibrium, whole: "WholeRoller") -> Iterator[Note]:
    """What must be said where a contact reaches an end of the roller."""
    if not whole.at_ends:
        return
    rest = "the life depends on the number of slices; a profile that keeps the ends apart has none of it"
    slices = {"accuracy.slices": ""}
    if not whole.peak_at_ends.any():
        yield outside(
            "sharp-roller-end",
            "the contact of the most loaded roller reaches an end of it, where a sharp end has pressure "
            f"without bound; on these cells the largest is elsewhere, but {rest}",
            slices,
        )
        return
    cell = state.balance.roller.bearing.roller.length / len(whole.positions)
    pairs = zip(RACEWAYS, whole.peak_pressure, whole.coarser_peak_pressure, whole.peak_at_ends, strict=True)
    places = " and ".join(
        f"{race} {fine / GIGAPASCAL:.3g} GPa, on cells of twice the size {coarse / GIGAPASCAL:.3g} GPa"
        for race, fine, coarse, at_end in pairs
        if at_end
    )
    yield outside(
        "sharp-roller-end",
        "peak pressure: not usable; the largest pressure of the most loaded roller is in the "
        f"cells at an end without relief left, where it has no bound: {places}. It is the mean of a cell of "
        f"{cell / MICROMETRE:.3g} um along the roller, and overstated as free end faces are softer; {rest}",
        slices,
    )
