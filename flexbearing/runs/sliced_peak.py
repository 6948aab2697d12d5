"""Where the peak pressure of slices is not that of the contact."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexbearing.findings.running import PRESSED_ENDS
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic import Equilibrium, NotSolved, OutOfRange
from quasidynamic.note import Note, outside
from quasidynamic.outcome.sliced_peak import CORNER_DECADE, corner_rise

if TYPE_CHECKING:
    from quasidynamic.outcome.sliced_peak import SlicedPeak

MILLIMETRE, GIGAPASCAL = 1e-3, 1e9
RACEWAYS = ("inner", "outer")


def notes(rows: SolvedRows) -> tuple[Note, ...]:
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
    from quasidynamic.outcome import sliced_peak  # brings Fourier transforms

    try:
        return list(_of_slices(state, sliced_peak.sliced_peak(state, edge_stress)))
    except (NotSolved, OutOfRange) as problem:
        return [outside("sliced-peak", f"peak pressure of slices: it could not be checked: {problem}")]


def _corner(rise: float) -> Note:
    return outside(
        "profile-corner",
        "peak pressure: circular ends meet a straight middle with a corner, where pressure has a weak peak "
        f"without bound: cells ten times finer raise it by {rise:.0%} of the largest; profile = "
        '"tangent_crowned" has no corner',
    )


def _told(state: Equilibrium, peak: "SlicedPeak") -> tuple[str, str]:
    """Pressure of the slices and the contact they belong to."""
    azimuth = np.degrees(state.balance.roller.bearing.azimuths[peak.roller])
    contact = f"the roller at {azimuth:.4g} deg on the {RACEWAYS[peak.race]} raceway"
    return f"peak pressure: {peak.pressure / GIGAPASCAL:.3g} GPa of the slices", contact


def _of_slices(state: Equilibrium, peak: "SlicedPeak") -> Iterator[Note]:
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
    instead = " instead of life.edge_stress, which is meant for the life" if peak.edge_stress else ""
    place = peak.whole.positions[peak.whole.largest_along.argmax()]
    yield outside(
        "sliced-peak",
        f"{sliced} is {abs(peak.error):.0%} {'below' if peak.error < 0 else 'above'} the "
        f"{peak.whole.peak_pressure / GIGAPASCAL:.3g} GPa that {contact} has as a whole, "
        f"{abs(place) / MILLIMETRE:.3g} mm from its middle: slices neglect their neighbours and the "
        f'ends; bearing.contact = "half_space"{instead}',
    )
