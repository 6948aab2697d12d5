"""The numbers of a result in the units people use."""

from typing import Any

import numpy as np

from flexbearing.results import Result

LOADED = 1.0  # [N] a roller carries load above this

_RPM = 30.0 / np.pi  # rad/s to rpm
HEAD = (  # root attributes that the summary of every kind repeats
    "status",
    "iterations",
    "wall_time_s",
    "title",
    "ending",
    "message",
    "assumed",
    "calibrated",
    "notes",
)
_OF_ROLLERS = ("method", "clearance", "life", "regimes")
CAUSES = ("sliding", "rolling", "drag", "pocket", "land", "churning", "transport")  # of power loss


def summary(result: Result) -> dict[str, Any]:
    """Numbers of a run as one object that JSON can hold.

    Parameters
    ----------
    result : Result
        what the run left behind

    Returns
    -------
    dict
        status, iterations, texts, clearance, life factors, regimes, stresses, choices and estimated
        errors of an accuracy that was ordered, and the blocks ``rigid`` and ``flexible``; a name carries
        its unit. None stands for a number that is not finite, for one that the case does not ask for, and
        for a block that was never solved.
    """
    head = {name: plain(result.attributes[name]) for name in HEAD + _OF_ROLLERS}
    for name in ("stresses", "choices", "error_estimate"):
        head[name] = plain(result.attributes.get(name))
    blocks = {"rigid": result.rigid, "flexible": result.flexible}
    return {**head, **{name: plain(_block(values)) if values else None for name, values in blocks.items()}}


def loaded_rollers(load: np.ndarray) -> float:
    """Count the rollers that carry load.

    Parameters
    ----------
    load : array (Z)
        load of the inner contacts [N], >= 0

    Returns
    -------
    int
        rollers above 1 N; NaN when a load is not finite
    """
    return int(np.count_nonzero(load > LOADED)) if np.isfinite(load).all() else np.nan


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
    loaded = np.sort(azimuth[load > LOADED] % (2 * np.pi))
    if loaded.size == load.size:
        return 2 * np.pi
    if loaded.size < 2:
        return 0.0
    # the arc is what the widest gap between neighbours leaves of the circle
    gaps = np.diff(loaded, append=loaded[0] + 2 * np.pi)
    return 2 * np.pi - float(gaps.max())


def _block(values: Any) -> dict[str, Any]:
    return (
        _loads(values)
        | _motion(values)
        | _contacts(values)
        | _power(values)
        | _stiffness(values)
        | _skew(values)
    )


def _loads(values: Any) -> dict[str, Any]:
    load, azimuth = values["inner_load"], values["roller_azimuth"]
    deviation = np.array([values["inner_deviation"], values["outer_deviation"]])
    return {
        "max_roller_load_N": load.max(),
        "max_outer_load_N": values["outer_load"].max(),
        "loaded_rollers": loaded_rollers(load),
        "loaded_arc_deg": np.degrees(loaded_arc(azimuth, load)).round(9),
        "roller_azimuths_deg": np.degrees(azimuth),
        "roller_loads_N": load,
        "outer_loads_N": values["outer_load"],
        "max_pocket_force_N": np.abs(values["cage_force"]).max(),
        "max_raceway_deviation_um": 1e6 * np.abs(deviation).max(),
        "life_L10_Mrev": 1e-6 * values["life_L10"],
        "modified_life_Mrev": 1e-6 * values["modified_life"] if "modified_life" in values else None,
    }


def _motion(values: Any) -> dict[str, Any]:
    (y, z), azimuth = values["ring_displacement"], values["load_direction"]
    return {
        "cage_slip_percent": 100 * values["cage_slip"],
        "cage_speed_rpm": _RPM * values["cage_speed"],
        "cage_offset_um": 1e6 * np.hypot(*values["cage_offset"]) if "cage_offset" in values else None,
        "max_pocket_displacement_um": (
            1e6 * np.abs(values["pocket_displacement"]).max() if "pocket_displacement" in values else None
        ),
        "ring_displacement_um": 1e6 * values["ring_displacement"],
        "displacement_along_load_um": 1e6 * (y * np.sin(azimuth) + z * np.cos(azimuth)),
        "displacement_across_load_um": 1e6 * (y * np.cos(azimuth) - z * np.sin(azimuth)),
    }


def _contacts(values: Any) -> dict[str, Any]:
    found = {
        "peak_pressure_MPa": both_races(1e-6 * values["peak_pressure"]),
        "minimum_film_um": both_races(1e6 * values["minimum_film"]),
        "lambda_ratios": None,
        "minimum_lambda": None,
    }
    if "inner_film_ratio" in values:
        ratios = np.array([values["inner_film_ratio"], values["outer_film_ratio"]])
        found["lambda_ratios"] = both_races(ratios)
        found["minimum_lambda"] = both_races(_smallest_above_zero(ratios))
    return found


def _power(values: Any) -> dict[str, Any]:
    """Losses by cause; `transport` is what the differences between neighbouring rollers leave, no heat."""
    losses = {cause: values[f"loss_{cause}"] for cause in CAUSES}
    return {
        "driving_torque_Nm": values["driving_torque"],
        "driving_power_W": values["driving_power"],
        "power_loss_W": {**losses, "total": np.sum(list(losses.values()))},
    }


def _skew(values: Any) -> dict[str, Any]:
    """Skew of the rollers; None for a case without flanges."""
    if "roller_skew" not in values:
        return {"skew": None}
    return {
        "skew": {
            "roller_skew_mrad": 1e3 * values["roller_skew"],
            "max_skew_mrad": 1e3 * np.abs(values["roller_skew"]).max(),
            "touching_skew_mrad": 1e3 * values["touching_skew"],
            "rollers_on_both_flanges": np.count_nonzero((values["flange_force"] > 0).all(axis=0)),
            "skew_moments_Nm": values["skew_moment"],
            "roller_thrusts_N": values["roller_thrust"],
            "flange_forces_N": values["flange_force"],
            "max_flange_force_N": values["flange_force"].max(),
            "flange_power_W": values["flange_power"],
            "sideways_power_W": values["skew_power"],
            "end_gap_um": 1e6 * values["skew_gap"],
            "load_shift_mm": 1e3 * values["skew_load_shift"],
            "traction_change_percent": 100 * values["skew_traction_change"],
        }
    }


def _stiffness(values: Any) -> dict[str, Any]:
    return {
        "stiffness_N_per_m": values["stiffness"],
        "total_stiffness_N_per_m": values["total_stiffness"],
        "stiffness_matrix_SI": values["stiffness_matrix"],
        "compliance_matrix_SI": values["compliance_matrix"],
    }


def _smallest_above_zero(ratios: np.ndarray) -> np.ndarray:
    """Smallest of each row without the unloaded contacts, which are zero; NaN without any other."""
    smallest = np.where(ratios == 0.0, np.inf, ratios).min(axis=1)
    return np.where(np.isinf(smallest), np.nan, smallest)


def both_races(pair: Any) -> dict[str, Any]:
    """Name the values of both races."""
    inner, outer = pair
    return {"inner": inner, "outer": outer}


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
