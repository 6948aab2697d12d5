"""What stands in a result file, apart from how HDF5 stores it."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from hashlib import sha256
from typing import Any

import numpy as np
from numpy.typing import NDArray

DIGEST = "digest"  # root attribute


@dataclass(frozen=True)
class Content:
    """Root attributes and arrays of a file."""

    attributes: Mapping[str, Any]  # texts, lists of texts, whole numbers and numbers; without the digest
    arrays: Mapping[str, NDArray]  # of float64, by group and name, "rigid/inner_load"
    texts: Mapping[str, Mapping[str, str]]  # unit, axes and meaning of each array


def digest(content: Content) -> str:
    """SHA-256 over everything in a file.

    Of the bytes of a JSON text without spaces, keys sorted, ASCII alone, followed by the arrays in the order
    of their sorted names, each as little-endian float64, row by row. The text holds `attributes` (floats as
    hexadecimal texts), `shapes` and `texts`.

    Parameters
    ----------
    content : Content
        of a file

    Returns
    -------
    str
        64 hexadecimal characters
    """
    head = {
        "attributes": {name: _exact(value) for name, value in content.attributes.items()},
        "shapes": {name: array.shape for name, array in content.arrays.items()},
        "texts": {name: dict(texts) for name, texts in content.texts.items()},
    }
    hashed = sha256(json.dumps(head, sort_keys=True, separators=(",", ":")).encode())
    for name in sorted(content.arrays):
        hashed.update(np.ascontiguousarray(content.arrays[name], dtype="<f8").tobytes())
    return hashed.hexdigest()


def _exact(value: Any) -> Any:
    return float(value).hex() if isinstance(value, float) else value
