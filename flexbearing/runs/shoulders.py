"""Notes on contacts that reach over the shoulders of races."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.note import Note, danger, outside
from quasidynamic.outcome.truncation import USUAL_SHOULDER


def reached_over(
    race: str, heights: NDArray, angles: NDArray, ball_diameter: float, shoulder: float | None
) -> tuple[Note, ...]:
    """What is left out of contacts above a shoulder, one of usual height unless given."""
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
        f"high: they reach up to {1e3 * heights.max():.4g} mm, {at}; "
        "that is neglected, as if the race continued"
    )
    return (danger("truncated-contact", text),)
