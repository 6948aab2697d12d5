"""What an interface between the surfaces of rolling contacts adds to their theory."""

from collections.abc import Iterator

from quasidynamic.note import Note, information


def compliant(compliance: float | None) -> Iterator[Note]:
    """Note that an interface shears, by a compliance that was given."""
    if compliance is not None:
        yield information(
            "interface-compliance",
            f"stick and slip: with an interface that shears by {1e6 * compliance:.3g} um where the traction "
            "is friction times pressure, as given; elastic bodies alone have none",
        )
