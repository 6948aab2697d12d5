"""Notes on what ball bearings of both kinds are made of: shoulders of their races, materials."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.balls.mounting import MountedMaterials
from quasidynamic.contact.rolling.fastsim import TORQUE_EXCESS
from quasidynamic.note import Note, danger, information, outside
from quasidynamic.outcome.truncation import USUAL_SHOULDER

ON_EDGE = 0.5  # [-] share of its load below which the middle of any contact is cut off


def unusual(materials: MountedMaterials) -> tuple[Note, ...]:
    """What balls that are not of steel mean for rings of no material, and for the ratings."""
    if materials.steel_balls:
        return ()
    rings = " and ".join(materials.not_given)
    if not materials.ceramic:
        modulus = f"{materials.ball.youngs_modulus / 1e9:.4g} GPa"
        text = f"{rings}: {modulus} as the balls, as no material is given, which is no bearing steel"
        return (information("rings-as-balls", text),) if rings else ()
    steel = f"{rings}: 100Cr6, as no material is given and the balls are ceramic; " if rings else ""
    rated = (
        "given ratings of the file count as those of its balls; by formula C is that of steel balls, which "
        "hybrids need not reduce (DIN ISO 281 supplement 5), C_0 the load of 4200 MPa by Hertz (assumed: ISO "
        "20056-2 allows slightly more), and C_u goes with C_0 as that of steel balls (assumed)"
        if materials.hybrid
        else "there are no ratings by formulas, and no s_0, for these materials"
    )
    return (information("hybrid", f"{steel}{rated}"),)


def reached_over(
    race: str,
    heights: NDArray,
    angles: NDArray,
    ball_diameter: float,
    shoulder: float | None,
    carried: float,
) -> tuple[Note, ...]:
    """What shoulders cut off contacts, ones of usual height unless given.

    `carried` is the least share of a load that a cut contact carries.
    """
    over = heights > (USUAL_SHOULDER * ball_diameter if shoulder is None else shoulder)
    if not over.any():
        return ()
    at = f"at contact angles of up to {np.degrees(np.abs(angles[over]).max()):.1f} deg"
    if shoulder is None:
        text = (
            f"contacts reach {heights.max() / ball_diameter:.3g} ball diameters up the {race} race, {at}; "
            f"shoulders usually end at {USUAL_SHOULDER:g}; that contacts are cut off there is neglected"
        )
        return (outside("shoulder-not-given", text),)
    text = (
        f"{int(over.sum())} contacts are cut off on the shoulder of the {race} race, {1e3 * shoulder:.4g} mm "
        f"high: whole ellipses reach up to {1e3 * heights.max():.4g} mm, {at}; "
        f"{carrying(carried)}"
    )
    return (danger("truncated-contact", text),)


def carrying(share: float) -> str:
    """How much the most cut contact carries of the load of a whole one [-]; not a number: not known."""
    if np.isnan(share):
        return "that is neglected, as if the race continued"
    edge = "; it rides on the edge, whose pressure is higher than reported" if share < ON_EDGE else ""
    return f"the most cut one carries {share:.0%} of the load of a whole one at the same approach{edge}"


def unrolled(why: str) -> tuple[Note, ...]:
    """Note that no stick and slip is known, where a case requires it; empty: it is known, or not required."""
    words = f"friction torque: that of full sliding, above the real one; no stick and slip: {why}"
    return (outside("no-stick-and-slip", words),) if why else ()


def without_torque(why: str) -> tuple[Note, ...]:
    """Note that no torque of friction is known; empty: it is known, or not required."""
    return (outside("no-friction-torque", f"no friction torque and no heat: {why}"),) if why else ()


def by_springs(model: str, sticking: NDArray) -> str:
    """How far the torque of FASTSIM may be off, by the share of the contacts that sticks; else empty."""
    if model != "fastsim":
        return ""
    share = float(np.nanmean(sticking, where=sticking > 0)) if np.any(sticking > 0) else 0.0
    least, growing = TORQUE_EXCESS
    return (
        f"; fastsim is up to {least + growing * share:.1%} above kalker, as {share:.0%} of the contacts stick"
    )


def compliant(compliance: float | None) -> Iterator[Note]:
    """Note that an interface shears, by a compliance that was given."""
    if compliance is not None:
        yield information(
            "interface-compliance",
            f"stick and slip: with an interface that shears by {1e6 * compliance:.3g} um where the traction "
            "is friction times pressure, as given; elastic bodies alone have none",
        )
