"""Residuals and derivatives of cases that left Newton's method at different iterates, as one."""

from typing import Any

import numpy as np
from numpy.typing import NDArray


class NotAlike(ValueError):
    """Arrays that cannot be joined, as only one of them depends on the case."""


def overlaid(under: Any, over: Any, cases: NDArray) -> Any:
    """Nested named tuples of arrays of many cases, those of some cases taken from others.

    The axis of the cases is that along which both differ in length; arrays of one shape are those of every
    case.

    >>> overlaid(np.zeros((2, 3)), np.ones((2, 1)), np.array([2])).tolist()
    [[0.0, 0.0, 1.0], [0.0, 0.0, 1.0]]

    Raises
    ------
    NotAlike
        where there is no such axis
    """
    if isinstance(under, tuple):
        return type(under)(*(overlaid(*pair, cases) for pair in zip(under, over, strict=True)))
    if under.shape == over.shape:
        return under
    axes = np.flatnonzero(np.not_equal(under.shape, over.shape)) if under.ndim == over.ndim else ()
    if len(axes) != 1 or over.shape[axes[0]] != len(cases):
        raise NotAlike(f"shapes {under.shape} and {over.shape}")
    joined = under.copy()
    joined[(*[slice(None)] * axes[0], cases)] = over
    return joined
