"""The numbers of a slow ball bearing in the units people use."""

from typing import Any

import numpy as np

from flexbearing.quantities.attributes import HEAD
from flexbearing.quantities.reductions import LOADED
from flexbearing.report.summary_values import both_races, plain
from flexbearing.results import Result

PARTS = ("spin", "roll", "hysteresis", "total")  # of the torque


def summary(result: Result) -> dict[str, Any]:
    """Numbers of a run as one object that JSON can hold.

    Parameters
    ----------
    result : Result
        of a slow bearing of two or four contact points

    Returns
    -------
    dict
        status, texts, and the blocks ``rigid`` and ``flexible``; a name carries its unit. None stands for a
        number that is not finite, for one that the case does not ask for, and for a block that was never
        solved, as ``flexible`` between rigid rings. Ball data are (balls, diagonals) where nothing else is
        said; torques are those of the inner ring.
    """
    head = {name: plain(result.attributes[name]) for name in HEAD}
    blocks = {"rigid": result.rigid, "flexible": result.flexible}
    shown = {name: plain(_block(result, values)) if values else None for name, values in blocks.items()}
    return {"kind": result.kind, **head, **shown}


def _block(result: Result, values: Any) -> dict[str, Any]:
    return _loads(values) | _torques(result, values) | _motion(values) | _ring(values)


def _loads(values: Any) -> dict[str, Any]:
    load, angle = values["contact_load"], np.degrees(values["contact_angle"])
    loaded = load > LOADED
    return {
        "balls": len(load),
        "loaded_balls": int(loaded.any((1, 2)).sum()),
        "loaded_contacts": int(loaded.sum()),
        "max_contact_load_N": load.max(),
        "max_contact_loads_N": load.max((0, 2)),  # of each diagonal
        "contact_angle_range_deg": _range(angle[loaded]),
        "peak_pressure_MPa": both_races(1e-6 * values["peak_pressure"].max((0, 1))),
        "semi_axis_across_mm": both_races(1e3 * values["semi_axis_across"].max((0, 1))),
        "semi_axis_along_mm": both_races(1e3 * values["semi_axis_along"].max((0, 1))),
        "ball_azimuths_deg": np.degrees(values["ball_azimuth"]),
        "contact_loads_N": load[..., 0],
        "contact_angles_deg": angle[..., 0],
    }


def _torques(result: Result, values: Any) -> dict[str, Any]:
    """Torque of the bearing and of its balls, in parts; the heaviest ball is that of the largest torque."""
    hysteresis = values["hysteresis_torque"]
    spin, roll = values["spin_torque"][:, 0], values["roll_torque"][:, 0]
    parts = np.array([spin, roll, hysteresis, spin + roll + hysteresis])
    heaviest = parts[-1].argmax()
    circumferential = values["circumferential_torque"][:, 0].sum() + hysteresis.sum()
    return {
        "torque_formula": result.attributes["case_si"]["friction"]["torque"],
        "torque_Nm": both_races(values["torque"]),
        "torque_parts_Nm": dict(zip(PARTS, parts.sum(1), strict=True)),
        "mean_ball_torque_parts_Nm": dict(zip(PARTS, parts.mean(1), strict=True)),
        "largest_ball_torque_parts_Nm": dict(zip(PARTS, parts[:, heaviest], strict=True)),
        "circumferential_torque_Nm": circumferential,
        "ball_torques_Nm": values["ball_torque"][:, 0],
        "power_loss_W": values["power_loss"],
    }


def _motion(values: Any) -> dict[str, Any]:
    return {
        "ball_speed_ratios": values["ball_speed_ratio"],
        "ball_speed_ratio_range": _range(values["ball_speed_ratio"]),
        "ball_attitudes_deg": np.degrees(values["ball_attitude"]),
        "ball_attitude_range_deg": _range(np.degrees(values["ball_attitude"])),
        "max_ball_imbalance": values["ball_imbalance"].max(),
    }


def _ring(values: Any) -> dict[str, Any]:
    """Ring under load; None when the contact loads are given."""
    if "ring_displacement" not in values:
        names = ("ring_displacement_um", "ring_tilt_mrad", "stiffness_matrix_SI", "largest_ring_yield_um")
        return dict.fromkeys(names)
    deflection = values.get("ring_yield")
    return {
        "largest_ring_yield_um": None if deflection is None else 1e6 * np.hypot(*deflection.T).max(),
        "ring_displacement_um": 1e6 * values["ring_displacement"][:3],
        "ring_tilt_mrad": 1e3 * values["ring_displacement"][3:],
        "stiffness_matrix_SI": values["stiffness_matrix"],
    }


def _range(values: np.ndarray) -> np.ndarray:
    """Smallest and largest of the finite values (2); NaN without any."""
    finite = values[np.isfinite(values)]
    return np.array([finite.min(), finite.max()]) if finite.size else np.full(2, np.nan)
