"""The numbers of a result in the units people use, as its quantities declare them."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from flexbearing.quantities.layout import Layout
from flexbearing.quantities.quantity import SummaryValue

Arrays = Mapping[str, np.ndarray]


def summary(layout: Layout, attributes: Mapping[str, Any], blocks: Mapping[str, Arrays]) -> dict[str, Any]:
    """Numbers of a run as one object that JSON can hold."""
    head = {name: plain(attributes.get(name)) for name in layout.head}
    settings = {key: attributes["case_si"][table][name] for key, table, name in layout.case_keys}
    return head | {
        name: settings | block(values, layout) if values else None for name, values in blocks.items()
    }


def block(values: Arrays, layout: Layout) -> dict[str, Any]:
    """Summary of an end state; a key with a dot is in an object, which is None where all in it is."""
    numbers: dict[str, Any] = {}
    for entry in layout.summary:
        group, _, key = entry.key.rpartition(".")
        (numbers.setdefault(group, {}) if group else numbers)[key] = plain(number(entry, values))
    for key, value in numbers.items():
        if isinstance(value, dict) and all(item is None for item in value.values()):
            numbers[key] = None
    return numbers


def number(entry: SummaryValue, values: Arrays) -> Any:
    """A value of the summary, from the arrays of a block; None if one it needs is absent."""
    if any(name not in values for name in entry.of):
        return None
    value = entry.reduction(*(values[name] for name in entry.of))
    assert entry.unit is not None  # a layout fills it in
    if entry.unit.scale != 1 and not entry.in_si:
        value = value * entry.unit.scale
    return dict(zip(entry.parts, value, strict=True)) if entry.parts else value


def plain(value: Any) -> Any:
    """Python's own lists and numbers, None for what JSON cannot hold."""
    if isinstance(value, np.ndarray | np.generic):
        value = value.tolist()
    if isinstance(value, dict) or hasattr(value, "items"):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, float) and not np.isfinite(value):
        return None
    return value
