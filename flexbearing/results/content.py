"""What is in a result file, apart from how HDF5 stores it."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from hashlib import sha256
from typing import Any

import numpy as np
from numpy.typing import NDArray

DIGEST, MEANINGS = "digest", "meanings"  # root attributes that are no part of a result


@dataclass(frozen=True)
class Content:
    """Root attributes and arrays of a file."""

    attributes: Mapping[str, Any]  # texts, lists of texts, whole numbers and numbers; without the digest
    arrays: Mapping[str, NDArray]  # of float64, "rigid/inner_load" in a group and "roller", a scale
    units: Mapping[str, str]  # of each array; empty for a scale that is a length and has no numbers
    axes: Mapping[str, tuple[str, ...]]  # scales along each array; none of a scale


def digest(content: Content) -> str:
    """SHA-256 over everything in a file.

    Of the bytes of a JSON text without spaces, keys sorted, ASCII alone, followed by the arrays in the order
    of their sorted names, each as little-endian float64, row by row. The text holds `attributes` (floats as
    hexadecimal texts), `shapes`, `units` and `axes`.
    """
    head = {
        "attributes": {name: _exact(value) for name, value in content.attributes.items()},
        "shapes": {name: array.shape for name, array in content.arrays.items()},
        "units": dict(content.units),
        "axes": dict(content.axes),
    }
    hashed = sha256(json.dumps(head, sort_keys=True, separators=(",", ":")).encode())
    for name in sorted(content.arrays):
        hashed.update(np.ascontiguousarray(content.arrays[name], dtype="<f8").tobytes())
    return hashed.hexdigest()


def _exact(value: Any) -> Any:
    return float(value).hex() if isinstance(value, float) else value
