"""What a reader of the results must know besides the numbers."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.build import clearance, ring_parts
from flexbearing.build.lubrication import oil, oil_name
from flexbearing.case.roller import Case
from flexbearing.findings.running import PRESSED_ENDS
from flexbearing.runs import several, skew, teeth
from flexbearing.runs.not_round import turning
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic import Equilibrium, NotSolved, OutOfRange
from quasidynamic.note import Note, danger, information, outside
from quasidynamic.outcome.sliced_peak import CORNER_DECADE, SlicedPeak, corner_rise, sliced_peak
from quasidynamic.outcome.validity import validity

LARGE_SHARE = 0.5  # of the losses: worth a word (assumed)
ALONE = 0.01  # of the largest line force: below it the other lines only keep the ring from rolling away
MILLIMETRE, GIGAPASCAL = 1e-3, 1e9
RACEWAYS = ("inner", "outer")


def of_case(case: Case) -> tuple[Note, ...]:
    """What can be said before anything is solved."""
    notes, operation = oil(case).notes, case.operation
    pin = operation.radial_load * np.exp(1j * operation.load_direction)
    couple = operation.moment * np.exp(1j * (operation.load_direction + operation.tilt_direction))
    if case.lubricant.traction == "4109":
        notes += (
            outside(
                "traction-data",
                "traction: the 4109 regression was measured on point contacts; line contacts are outside it",
            ),
            outside("traction-data", f"traction: the 4109 regression is used with {oil_name(case)}"),
        )
    return (
        notes
        + _overlap(case)
        + tuple(teeth.notes(case.outer, pin, "operation.radial_load"))
        + (tuple(teeth.notes_on_couple(case.outer, couple, case.seat[0])) if operation.free_tilt else ())
        + _turning_waves(case)
        + clearance.notes(case)
        + ring_parts.notes(case)
    )


def _overlap(case: Case) -> tuple[Note, ...]:
    """Say so when the cage has no room between the rings."""
    if not (overlap := case.cage_within_ribs):
        return ()
    words = (
        f"dimensions overlap: {overlap}: such a bearing cannot be built, one of them is wrong; loads and "
        "life do not depend on it, drag and friction of the cage do"
    )
    return (outside("overlapping-dimensions", words),)


def _turning_waves(case: Case) -> tuple[Note, ...]:
    """Say so when a raceway that is not round turns."""
    form, operation = case.bearing.form_error, case.operation
    speeds = {"inner": operation.inner_speed, "outer": operation.outer_speed}
    return tuple(
        turning(race, f"bearing.form_error.{race}.crest")
        for race, speed in speeds.items()
        if form and getattr(form, race) and speed
    )


def of_solution(rows: SolvedRows) -> tuple[Note, ...]:
    """What a single solved case adds to its findings: ranges of laws that it leaves, what to weigh."""
    (case,), (state,), (skewed,) = rows.cases, rows.each, rows.skew
    return (
        *validity(state),
        *_information(case, state),
        *(skew.notes(skewed, state, state.minimum_film) if skewed else ()),
        *rows.rated[0].notes,
        *rows.life_errors.notes(0),
        *rows.notes_of_whole[0],
    )


def of_others(rows: SolvedRows, place: int, *, search: bool = False) -> tuple[Note, ...]:
    """Other equilibria of a case that likely has some: those that are found, or that nobody searched."""
    if not search:
        words = "several equilibria are likely; others than the computed one were not searched"
        return (danger(several.CODE, words),)
    found = rows.other_equilibria(place)
    return (found.note(),) if found else ()


def of_structure(figures: Mapping[str, Any]) -> tuple[Note, ...]:
    """What the supports of the outer ring say at the end state."""
    lines = figures.get("outer", {}).get("lines")
    if lines is None:
        return ()
    *_, second, largest = sorted(abs(force) for force in lines["force_N"])
    if second > ALONE * largest:
        return ()
    azimuth = lines["azimuth_deg"][[abs(force) for force in lines["force_N"]].index(largest)]
    words = (
        f"outer ring: the line at {azimuth:.1f} deg alone carries the load; lines on both sides of the load "
        "would hold the ring where it is"
    )
    return (information("ring-on-one-line", words),)


def _information(case: Case, state: Equilibrium) -> Iterator[Note]:
    cage, losses = state.balance.roller.bearing.cage, state.losses
    if state.pocket_displacement is not None:
        touching = int((np.abs(state.pocket_displacement) > cage.pocket_clearance).sum())
        if touching:
            yield information(
                "pocket-walls", f"cage pockets: {touching} rollers touch the wall of their pocket"
            )
    if losses.drag > LARGE_SHARE * losses.total:
        key = "lubricant.oil_fraction"
        how = ", assumed" * (key in case.assumed) + ", fitted" * (key in case.calibrated)
        yield information(
            "drag-loss",
            f"losses: {losses.drag / losses.total:.0%} are drag of the oil-air mixture on the rollers, "
            f"which grows with the share of oil in it, {case.lubricant.oil_fraction:g}{how}",
            {key: ""},
        )


def of_sliced_peak(rows: SolvedRows) -> tuple[Note, ...]:
    """What must be said of the peak pressure of a solved state besides the finding on pressed ends."""
    (case,), (state,), found = rows.cases, rows.each, []
    rise = corner_rise(state)
    if rise > CORNER_DECADE:
        found.append(_corner(rise))
    if case.bearing.contact == "slices" and rows.sliced_peak_error[0] <= PRESSED_ENDS.limit:
        found += _checked(state, None if rows.edge_stress is None else rows.edge_stress[0])
    return tuple(found)


def _checked(state: Equilibrium, edge_stress: NDArray | None) -> list[Note]:
    """What the whole contact says of the largest slice."""
    try:
        return list(_of_slices(state, sliced_peak(state, edge_stress)))
    except (NotSolved, OutOfRange) as problem:
        return [outside("sliced-peak", f"peak pressure of slices: it could not be checked: {problem}")]


def _corner(rise: float) -> Note:
    return outside(
        "profile-corner",
        "peak pressure: circular ends meet a straight middle with a corner, where pressure has a weak peak "
        f"without bound: cells ten times finer raise it by {rise:.0%} of the largest; tangent crowning has "
        "no corner",
        {"bearing.roller.profile": "tangent_crowned"},
    )


def _told(state: Equilibrium, peak: SlicedPeak) -> tuple[str, str]:
    """Pressure of the slices and the contact they belong to."""
    azimuth = np.degrees(state.balance.roller.bearing.azimuths[peak.roller])
    contact = f"the roller at {azimuth:.4g} deg on the {RACEWAYS[peak.race]} raceway"
    return f"peak pressure: {peak.pressure / GIGAPASCAL:.3g} GPa of the slices", contact


def _of_slices(state: Equilibrium, peak: SlicedPeak) -> Iterator[Note]:
    if peak.holds:
        return
    sliced, contact = _told(state, peak)
    if peak.at_end:
        yield outside(
            "sharp-roller-end",
            f"{sliced} leave out that {contact} touches up to an end, where a sharp end has pressure without "
            "bound; a profile that keeps the ends apart, or the shape of the end as a part of the profile, "
            "has a peak",
        )
        return
    instead = {"life.edge_stress": "false"} if peak.edge_stress else {}  # which is meant for the life
    place = peak.whole.positions[peak.whole.largest_along.argmax()]
    yield outside(
        "sliced-peak",
        f"{sliced} is {abs(peak.error):.0%} {'below' if peak.error < 0 else 'above'} the "
        f"{peak.whole.peak_pressure / GIGAPASCAL:.3g} GPa that {contact} has as a whole, "
        f"{abs(place) / MILLIMETRE:.3g} mm from its middle: slices neglect their neighbours and the ends",
        {"bearing.contact": "half_space", **instead},
    )
