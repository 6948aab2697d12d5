"""From the arrays of a result to the numbers of its summary."""

import numpy as np

LOADED = 3e-4  # of the largest load: a contact carries load above it
RACES = ("inner", "outer")
EXTENT = ("smallest", "largest")  # entries of a range
YZ, XYZ, ABOUT_YZ = ("y", "z"), ("x", "y", "z"), ("about_y", "about_z")


def largest(values: np.ndarray) -> np.ndarray:
    """Largest of all."""
    return values.max()


def largest_size(*values: np.ndarray) -> np.ndarray:
    """Largest of all, without their signs."""
    return np.abs(values).max()


def largest_at_mid_roller(position: np.ndarray, *values: np.ndarray) -> float:
    """Largest size at mid-roller of values (Z, K) at slices with middles (K), linear between them."""
    return max(abs(float(np.interp(0.0, position, row))) for rows in values for row in rows)


def largest_at_roller_ends(*values: np.ndarray) -> np.ndarray:
    """Largest size at both ends of the rollers of values (Z, K), linear over the last of K equal slices."""
    rows = np.concatenate(values)
    ends = [rows[:, end] + (rows[:, end] - rows[:, inwards]) / 2 for end, inwards in ((0, 1), (-1, -2))]
    return np.abs(ends).max()


def length(values: np.ndarray) -> np.ndarray:
    """Length of a vector (2)."""
    return np.hypot(*values)


def finite_range(values: np.ndarray) -> np.ndarray:
    """Smallest and largest of the finite values (2); NaN without any."""
    finite = values[np.isfinite(values)]
    return np.array([finite.min(), finite.max()]) if finite.size else np.full(2, np.nan)


def smallest_above_zero(*rows: np.ndarray) -> np.ndarray:
    """Smallest of each row without the unloaded contacts, which are zero; NaN without any other."""
    values = np.array(rows)
    smallest = np.where(values == 0.0, np.inf, values).min(axis=1)
    return np.where(np.isinf(smallest), np.nan, smallest)


def loaded(load: np.ndarray) -> np.ndarray:
    """Which contacts carry load (...), of the loads of all of them [N], >= 0."""
    return load > LOADED * load.max()


def loaded_rollers(load: np.ndarray) -> float:
    """Count the rollers that carry load.

    Parameters
    ----------
    load : array (Z)
        load of the inner contacts [N], >= 0

    Returns
    -------
    int
        rollers above `LOADED`; NaN when a load is not finite
    """
    return int(np.count_nonzero(loaded(load))) if np.isfinite(load).all() else np.nan


def loaded_arc(azimuth: np.ndarray, load: np.ndarray) -> float:
    """Span the smallest arc that holds every loaded roller, from the first to the last.

    Parameters
    ----------
    azimuth : array (Z)
        places of the rollers [rad], in any order and on any branch
    load : array (Z)
        load of the inner contacts [N], >= 0

    Returns
    -------
    float
        arc [rad]; 2 pi when every roller is loaded, 0 for fewer than two; NaN when a load is not finite
    """
    if not np.isfinite(load).all():
        return np.nan
    places = np.sort(azimuth[loaded(load)] % (2 * np.pi))
    if places.size == load.size:
        return 2 * np.pi
    if places.size < 2:
        return 0.0
    # the arc is what the widest gap between neighbours leaves of the circle
    gaps = np.diff(places, append=places[0] + 2 * np.pi)
    return 2 * np.pi - float(gaps.max())


def loaded_arc_in_degrees(azimuth: np.ndarray, load: np.ndarray) -> float:
    """The loaded arc [deg], without digits that come from rounding."""
    return np.degrees(loaded_arc(azimuth, load)).round(9)


def along(displacement: np.ndarray, azimuth: np.ndarray) -> np.ndarray:
    """Component of a displacement (y, z) towards an azimuth."""
    y, z = displacement
    return y * np.sin(azimuth) + z * np.cos(azimuth)


def across(displacement: np.ndarray, azimuth: np.ndarray) -> np.ndarray:
    """Component of a displacement (y, z) a quarter turn ahead of an azimuth."""
    y, z = displacement
    return y * np.cos(azimuth) - z * np.sin(azimuth)


def total(*values: np.ndarray) -> np.ndarray:
    """Sum of all."""
    return np.sum(values)


def stacked(*rows: np.ndarray) -> np.ndarray:
    """Arrays of one shape as rows of one array."""
    return np.array(rows)


def touching_both(forces: np.ndarray) -> int:
    """Count the rollers with a force at both ends, from the forces (2, Z) at either end."""
    return int(np.count_nonzero((forces > 0).all(axis=0)))


def at_inner_race(values: np.ndarray) -> np.ndarray:
    """Values at the inner race, where races are the last axis."""
    return values[..., 0]


def displacements(values: np.ndarray) -> np.ndarray:
    """The first three of five: displacements or forces along x, y, z."""
    return values[:3]


def tilts(values: np.ndarray) -> np.ndarray:
    """The last two of five: tilts or moments about y and z."""
    return values[3:]
