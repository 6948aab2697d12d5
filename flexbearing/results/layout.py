"""Datasets of ball bearings, until these are declared as quantities."""

from typing import Any

from flexbearing.quantities.attributes import FORMAT
from flexbearing.quantities.quantity import Place, Quantity

__all__ = ["FORMAT", "Dataset"]


def Dataset(name: str, axes: str, unit: str, place: Place, meaning: str, **further: Any) -> Quantity:  # noqa: N802
    """A quantity without a symbol."""
    return Quantity(name, "", axes, unit, place, meaning, **further)
