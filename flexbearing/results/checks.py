"""What must hold of names and numbers before they are part of a result file."""

from collections.abc import Collection, Mapping
from difflib import get_close_matches
from typing import Any

import numpy as np

from flexbearing.quantities import Quantity
from flexbearing.quantities.layout import FIXED, Layout

Sizes = Mapping[str, int]  # symbol of an axis to its size


class NotInLayout(ValueError):
    """Something was to be written, or requested, that the layout does not know."""


def require_same_names(names: Mapping[str, object], known: Mapping[str, object], where: str) -> None:
    """Raise unless `names` holds exactly the names of the layout; optional ones may be missing.

    Raises `NotInLayout` naming what is unknown, with the nearest known name, or what is missing.
    """
    for name in names:
        if name not in known:
            near = get_close_matches(name, known, n=1)
            hint = f" Did you mean {near[0]!r}?" if near else ""
            raise NotInLayout(f"{where}: {name!r} is not in the layout of a result file.{hint}")
    required = [name for name, entry in known.items() if not getattr(entry, "optional", False)]
    if missing := [name for name in required if name not in names]:
        raise NotInLayout(f"{where}: {', '.join(missing)} missing; the layout requires every name.")


def fitted(entry: Quantity, array: np.ndarray, sizes: Sizes, where: str) -> Sizes:
    """Sizes of the axes after `array` took its place; the first array of a file decides.

    Raises `NotInLayout` for a shape that does not fit.
    """
    new = dict(zip(entry.shape, array.shape, strict=False))
    numbers = {axis: len(FIXED[axis].entries) for axis in entry.shape if axis in FIXED}
    allowed = tuple({**new, **numbers, **sizes}.get(axis) for axis in entry.shape)
    if array.shape != allowed:
        settled = ", ".join(f"{axis} = {size}" for axis, size in {**numbers, **sizes}.items())
        raise NotInLayout(
            f"{where}: {entry.name} has shape {array.shape}; "
            f"the layout requires ({', '.join(entry.shape)}){' with ' + settled if settled else ''}."
        )
    return {**sizes, **{axis: size for axis, size in new.items() if axis not in FIXED}}


def require_finite(entry: Quantity, array: np.ndarray, where: str) -> None:
    """Raise when an array that claims to be a solution holds infinities or NaN.

    Raises `NotInLayout` naming the dataset and how many of its numbers are not finite.
    """
    if np.isfinite(array).all():
        return
    lost, endless = np.isnan(array) & (not entry.gaps), np.isinf(array) & (not entry.infinite)
    bad = int(np.count_nonzero(lost | endless))
    if bad:
        raise NotInLayout(
            f"{where}: {entry.name} holds {bad} of {array.size} numbers that are not finite; "
            "a converged block holds only finite ones. Store it with converged=False."
        )


def require_true_ending(
    attributes: Mapping[str, Any],
    layout: Layout,
    solved: Collection[str],
    iterations: int,
    unsolved: Collection[str] = (),
) -> None:
    """Raise when what a file says of its ending is not what it holds.

    Raises `NotInLayout` for another number of iterations, or a converged run without all its solutions.
    """
    stored = 0 if attributes.get("left_out") == "iterations" else attributes["iterations"]
    if stored != iterations:
        raise NotInLayout(f"iterations = {attributes['iterations']}, but {iterations} were written.")
    missing = [*(name for name in layout.blocks if name not in (*solved, *unsolved)), *unsolved]
    if attributes["status"] == "converged" and missing:
        raise NotInLayout(f"status = 'converged', but no converged block {' or '.join(missing)} was written.")
