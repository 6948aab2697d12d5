"""What an interface between the surfaces of rolling contacts adds to their theory."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.rolling.fastsim import TORQUE_EXCESS
from quasidynamic.note import Note, information, outside


def unrolled(why: str) -> tuple[Note, ...]:
    """Note that no stick and slip is known, where a case requires it; empty: it is known, or not required."""
    words = f"friction torque: that of full sliding, above the real one; no stick and slip: {why}"
    return (outside("no-stick-and-slip", words),) if why else ()


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
