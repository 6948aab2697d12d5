"""Stresses below the surfaces of rolling contacts, and of the bars of a squirrel cage."""

from functools import partial
from typing import TYPE_CHECKING

from numpy.typing import NDArray

from quasidynamic.note import Note, outside

if TYPE_CHECKING:
    from fem.squirrel_cage.bar_forces import NominalStresses
    from flexbearing.case.balls.angular_contact import FastCase
    from flexbearing.case.balls.four_point import FourPointCase
    from flexbearing.case.roller import Case
    from flexbearing.case.tapered import TaperedCase
    from flexbearing.coupled.states import EndStates
    from quasidynamic import CylindricalRollerBearing, TaperedRollerBearing
    from quasidynamic.outcome.subsurface import Subsurface
    from quasidynamic.outcome.worst_point_contact import WorstPointContact


def of_rollers(
    case: "Case | TaperedCase",
    bearing: "CylindricalRollerBearing | TaperedRollerBearing",
    pressure: NDArray,
    half_width: NDArray,
    friction: NDArray,
) -> "Subsurface | None":
    """Field below the most pressed slice of both raceways, under the traction of its roller as it slides."""
    if not case.outputs.subsurface_stresses:
        return None
    from quasidynamic.contact.line.slices import line_contact_stress
    from quasidynamic.outcome.subsurface import below

    stresses = [
        partial(line_contact_stress, poisson_ratio=ring.poisson_ratio, friction=share)
        for ring, share in zip((bearing.inner_ring, bearing.outer_ring), friction, strict=True)
    ]
    return below(stresses, pressure, half_width, friction)


def of_balls(case: "FastCase | FourPointCase", worst: "WorstPointContact") -> "Subsurface | None":
    """Field below the most pressed ellipse of both raceways, without friction; None where none is known."""
    if not case.outputs.subsurface_stresses or _too_long(worst):
        return None
    from quasidynamic.contact.ellipse.subsurface import ellipse_stress
    from quasidynamic.outcome.subsurface import below

    rings = (case.materials.ring("inner"), case.materials.ring("outer"))
    stresses = [
        partial(ellipse_stress, axis_ratio=ratio or 1.0, poisson_ratio=ring.poisson_ratio)  # 1: without load
        for ratio, ring in zip(worst.axis_ratio, rings, strict=True)
    ]
    return below(stresses, worst.pressure, worst.half_width)


def notes(case: "FastCase | FourPointCase", worst: "WorstPointContact") -> tuple[Note, ...]:
    """Why a case that requires stresses below its contacts has none."""
    if not case.outputs.subsurface_stresses or not _too_long(worst):
        return ()
    words = (
        f"no stresses below the contacts: an ellipse is {worst.axis_ratio.max():.3g} times as long along as "
        "across the rolling direction, allowed is 1"
    )
    return (outside("no-subsurface-stresses", words),)


def _too_long(worst: "WorstPointContact") -> bool:
    return bool((worst.axis_ratio > 1.0).any())


def nominal_stresses(case: "Case", end: "EndStates") -> "NominalStresses | None":
    """Section forces and nominal stresses of the bars, without a solve."""
    from flexbearing.build import ring_parts  # balls have none
    from flexbearing.coupling.raceway_pair import OUTWARD

    assert end.rings.outer is not None  # or there are no bars
    import fem
    from fem.raceway.bar_response import BarResponse
    from fem.squirrel_cage import bar_forces

    response = end.rings.outer.bar_response
    part = ring_parts.outer_part(case) if isinstance(response, BarResponse) else None
    if not isinstance(response, BarResponse) or not isinstance(part, fem.SquirrelCage):
        return None
    states, azimuths = end.states, end.states.balance.roller.bearing.azimuths
    return bar_forces.nominal_stresses(part, response, azimuths, OUTWARD[1] * states.forces[..., 1, :, :])
