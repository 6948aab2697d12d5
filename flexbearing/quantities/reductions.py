"""From the arrays of a result to the numbers of its summary.

Those of roller bearings take arrays of one case or of many, whose axes come first: (..., Z) is (Z) or (C, Z).
"""

import numpy as np

LOADED = 3e-4  # of the largest load: a contact carries load above it
SAME_PLACE = 1e-9  # [rad] half the distance of rollers that have one azimuth
RACES = ("inner", "outer")
EXTENT = ("smallest", "largest")  # entries of a range
ROWS = ("row_1", "row_2")  # of rolling elements
YZ, XYZ, ABOUT_YZ = ("y", "z"), ("x", "y", "z"), ("about_y", "about_z")


def largest_of_all(values: np.ndarray) -> np.ndarray:
    """Largest of all of one case."""
    return values.max()


def largest(values: np.ndarray) -> np.ndarray:
    """Largest of values (..., Z)."""
    return values.max(axis=-1)


def largest_of_ends(values: np.ndarray) -> np.ndarray:
    """Largest of values (..., B, 2) at both ends of bars."""
    return values.max(axis=(-2, -1))


def largest_size(values: np.ndarray) -> np.ndarray:
    """Largest of values (..., Z), without their signs."""
    return np.abs(values).max(axis=-1)


def largest_at_mid_roller(*values: np.ndarray) -> np.ndarray:
    """Largest size at mid-roller of values (..., Z, K) at equal slices, linear between their middles."""
    each = [
        (array[..., (array.shape[-1] - 1) // 2] + array[..., array.shape[-1] // 2]) / 2 for array in values
    ]
    return largest_size(np.concatenate(each, axis=-1))


def largest_at_roller_ends(*values: np.ndarray) -> np.ndarray:
    """Largest size at both ends of the rollers of values (..., Z, K), linear over the last equal slices."""
    rows = np.concatenate(values, axis=-2)
    ends = [rows[..., end] + (rows[..., end] - rows[..., inwards]) / 2 for end, inwards in ((0, 1), (-1, -2))]
    return largest_size(np.concatenate(ends, axis=-1))


def length(values: np.ndarray) -> np.ndarray:
    """Length of vectors (..., 2)."""
    return np.hypot(values[..., 0], values[..., 1])


def finite_range(values: np.ndarray) -> np.ndarray:
    """Smallest and largest of the finite values of one case (2); NaN without any."""
    finite = values[np.isfinite(values)]
    return np.array([finite.min(), finite.max()]) if finite.size else np.full(2, np.nan)


def smallest_above_zero(*rows: np.ndarray) -> np.ndarray:
    """Smallest of each row (..., Z) without the unloaded contacts, which are zero; NaN without any other."""
    values = stacked(*rows)
    smallest = np.where(values == 0.0, np.inf, values).min(axis=-1)
    return np.where(np.isinf(smallest), np.nan, smallest)


def _largest_place(pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Roller and slice (...) with the largest of pressures (..., Z, K)."""
    flat = pressure.reshape(*pressure.shape[:-2], -1)
    roller, slice_ = np.divmod(flat.argmax(axis=-1), pressure.shape[-1])
    return roller, slice_


def _entry(values: np.ndarray, place: np.ndarray) -> np.ndarray:
    """Entries (...) of values (n) or (..., n) at places (...)."""
    each = np.broadcast_to(values, (*place.shape, values.shape[-1]))
    return np.take_along_axis(each, place[..., None], axis=-1)[..., 0]


def azimuth_of_largest(inner: np.ndarray, outer: np.ndarray, azimuth: np.ndarray) -> np.ndarray:
    """Azimuths (..., 2) between -pi and pi of the rollers with the largest of pressures (..., Z, K)."""
    found = [_entry(azimuth, _largest_place(pressure)[0]) for pressure in (inner, outer)]
    return np.pi - (np.pi - np.stack(found, axis=-1)) % (2 * np.pi)


def place_of_largest(inner: np.ndarray, outer: np.ndarray, position: np.ndarray) -> np.ndarray:
    """Places (..., 2) along the rollers of the largest of pressures (..., Z, K)."""
    return np.stack([_entry(position, _largest_place(each)[1]) for each in (inner, outer)], axis=-1)


def loaded_share_at_largest(inner: np.ndarray, outer: np.ndarray) -> np.ndarray:
    """Share of the slices (..., 2) that carry load, of the rollers with the largest of pressures (..., Z, K).

    The load of a slice goes with the square of its pressure.
    """
    shares = []
    for pressure in (inner, outer):
        roller = _largest_place(pressure)[0][..., None, None]
        along = np.take_along_axis(pressure, roller, axis=-2)[..., 0, :]
        shares.append((along**2 > LOADED * along.max(axis=-1, keepdims=True) ** 2).mean(axis=-1))
    return np.stack(shares, axis=-1)


def loaded(load: np.ndarray) -> np.ndarray:
    """Which contacts carry load (...), of the loads of all of them in one case [N], >= 0."""
    return load > LOADED * load.max()


def loaded_rollers(load: np.ndarray) -> np.ndarray:
    """Count the rollers that carry load."""
    count, known = _loaded(load).sum(axis=-1), np.isfinite(load).all(axis=-1)
    return count if known.all() else np.where(known, count, np.nan)


def loaded_arc(azimuth: np.ndarray, load: np.ndarray) -> np.ndarray:
    """Span the smallest arc that holds every loaded roller of all rows, from the first to the last."""
    turn, rollers = 2 * np.pi, load.shape[-1]
    place = np.broadcast_to(azimuth % turn, load.shape)
    order = np.argsort(place, axis=-1)
    place, is_loaded = (np.take_along_axis(array, order, axis=-1) for array in (place, _loaded(load)))
    for step in (1, -1):  # rollers of two rows at one azimuth hold the same place
        beside = np.abs(np.sin((place - np.roll(place, step, axis=-1)) / 2)) < SAME_PLACE
        is_loaded = np.logical_or(is_loaded, np.logical_and(beside, np.roll(is_loaded, step, axis=-1)))
    # the arc is what the widest gap between neighbours leaves of the circle; twice around, so that every
    # roller has one before it
    around = [np.where(is_loaded, place + start, -turn) for start in (0.0, turn)]
    last = np.maximum.accumulate(np.concatenate(around, axis=-1), axis=-1)[..., rollers - 1 : -1]
    gap = np.where(is_loaded, around[1] - last, 0.0).max(axis=-1)
    count = is_loaded.sum(axis=-1)
    arc = np.where(count == rollers, turn, np.where(count < 2, 0.0, turn - gap))
    return np.where(np.isfinite(load).all(axis=-1), arc, np.nan)


def loaded_arc_in_degrees(azimuth: np.ndarray, load: np.ndarray) -> np.ndarray:
    """The loaded arc (...) [deg], without digits that come from rounding."""
    return np.degrees(loaded_arc(azimuth, load)).round(9)


def _loaded(load: np.ndarray) -> np.ndarray:
    """Which rollers of each case carry load (..., Z)."""
    return load > LOADED * load.max(axis=-1, keepdims=True)


def along(displacement: np.ndarray, azimuth: np.ndarray) -> np.ndarray:
    """Component of displacements (..., 2) along y and z towards azimuths (...)."""
    return displacement[..., 0] * np.sin(azimuth) + displacement[..., 1] * np.cos(azimuth)


def across(displacement: np.ndarray, azimuth: np.ndarray) -> np.ndarray:
    """Component of displacements (..., 2) along y and z a quarter turn ahead of azimuths (...)."""
    return displacement[..., 0] * np.cos(azimuth) - displacement[..., 1] * np.sin(azimuth)


def total(*values: np.ndarray) -> np.ndarray:
    """Sum (...) of all."""
    return np.sum(values, axis=0)


def stacked(*rows: np.ndarray) -> np.ndarray:
    """Arrays (..., Z) as rows of one array."""
    return np.stack(rows, axis=-2)


def touching_both(forces: np.ndarray) -> np.ndarray:
    """Count the rollers with a force at both ends, from the forces (..., 2, Z) at either end."""
    return (forces > 0).all(axis=-2).sum(axis=-1)


def entry(matrix: np.ndarray, row: int, column: int) -> np.ndarray:
    """Force on one axis per displacement along another, of matrices (..., n, n)."""
    return matrix[..., row, column]


def at_inner_race(values: np.ndarray) -> np.ndarray:
    """Values at the inner race, where races are the last axis."""
    return values[..., 0]


def displacements(values: np.ndarray) -> np.ndarray:
    """The first three of five: displacements or forces along x, y, z."""
    return values[..., :3]


def tilts(values: np.ndarray) -> np.ndarray:
    """The last two of five: tilts or moments about y and z."""
    return values[..., 3:]
