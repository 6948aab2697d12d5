"""What an interface between the surfaces of rolling contacts adds to their theory."""

from collections.abc import Iterator

from quasidynamic.note import Note, information, outside


def unrolled(why: str) -> tuple[Note, ...]:
    """Note that no stick and slip is known, where a case requires it; empty: it is known, or not required."""
    words = f"friction torque: that of full sliding, above the real one; no stick and slip: {why}"
    return (outside("no-stick-and-slip", words),) if why else ()


def compliant(compliance: float | None) -> Iterator[Note]:
    """Note that an interface shears, by a compliance that was given."""
    if compliance is not None:
        yield information(
            "interface-compliance",
            f"stick and slip: with an interface that shears by {1e6 * compliance:.3g} um where the traction "
            "is friction times pressure, as given; elastic bodies alone have none",
        )
