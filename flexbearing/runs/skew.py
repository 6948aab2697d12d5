"""Skew of the rollers of a case whose ring has guide flanges."""

import numpy as np
from numpy.typing import ArrayLike

from flexbearing.build import roller_bearing
from flexbearing.case.roller import Case
from quasidynamic import Equilibrium
from quasidynamic.balance.rollers.skew import RunningRollers
from quasidynamic.note import Note, outside
from quasidynamic.outcome.skew import Skew, skewed

GAP = 1e-7  # [m] change of the gap at a roller's end that is worth a note, unless the film is thinner
SHIFT = 0.01  # of the roller's length, between inner and outer load
SHARE = 0.1  # of the tractions
POWER = 0.01  # of the driving power


def at(case: Case, state: Equilibrium) -> Skew | None:
    """Skew of the rollers at an equilibrium; None for a case without flanges."""
    flange = roller_bearing.flange(case)
    if flange is None:
        return None
    balance, points = state.balance.roller, state.balance.points
    ring = points.inner_speed if flange.ring == "inner" else points.outer_speed
    running = RunningRollers(
        slice_load=state.rollers.contact.slice_load[:, 0],
        sliding=state.sliding,
        entrainment=state.entrainment,
        film=state.film,
        rolling_shear=state.rolling_shear,
        spin=state.roller_speed,
        ring_speed=float(ring[0, 0]) - state.cage_speed,
    )
    return skewed(running, balance.raceways, balance.bearing, flange)


def notes(skew: Skew, state: Equilibrium, minimum_film: ArrayLike) -> tuple[Note, ...]:
    """Effects of the skew that the equilibrium neglects, where they are not small against films (2) [m]."""
    films = np.asarray(minimum_film)
    smallest_gap = min(GAP, *films[films > 0])
    length = skew.balance.bearing.roller.length
    power = float(skew.flange_power.sum() + skew.axial_sliding_power.sum())
    left_out = {
        f"changes the gap at the ends of the rollers by up to {skew.end_gap * 1e6:.3f} um": (
            skew.end_gap > smallest_gap
        ),
        f"shifts loads by up to {skew.load_shift * 1e3:.3f} mm along the rollers": (
            skew.load_shift > SHIFT * length
        ),
        f"changes tractions by up to {100 * skew.traction_change:.0f} % of the largest": (
            skew.traction_change > SHARE
        ),
        f"costs {power:.3g} W at flanges and raceways in addition to {state.driving_power:.4g} W": (
            power > POWER * abs(state.driving_power)
        ),
    }
    beginning = "skew: its effect on loads and speeds is neglected, though it"
    return tuple(
        outside("skew", f"{beginning} {effect}")
        for effect, worth_telling in left_out.items()
        if worth_telling
    )
