"""The numbers of a fast angular-contact ball bearing in the units people use."""

from typing import Any

import numpy as np

from flexbearing.quantities.attributes import HEAD
from flexbearing.report.summary_values import both_races, plain
from flexbearing.results import Result

_RPM = 30.0 / np.pi  # rad/s to rpm
LINES = (  # known only where pure rolling lines exist
    "line_parameter_range",
    "first_line_range",
    "second_line_range",
    "balls_with_one_line",
    "balls_with_two_lines",
    "first_lines",
    "second_lines",
    "line_counts",
    "spin_friction_Nm",
    "spin_friction_by_lines_Nm",
    "largest_slip_mm_per_s",
)


def summary(result: Result) -> dict[str, Any]:
    """Numbers of a run as one object that JSON can hold.

    Parameters
    ----------
    result : Result
        of an angular-contact ball bearing

    Returns
    -------
    dict
        status, texts, and the block ``rigid``; a name carries its unit. None stands for a number that is not
        finite or does not exist, and for a block that was never solved. Ball data are by race, then by ball.
    """
    head = {name: plain(result.attributes[name]) for name in HEAD}
    block = plain(_block(result.rigid)) if result.rigid else None
    return {"kind": result.kind, **head, "rigid": block, "flexible": None}


def _block(values: Any) -> dict[str, Any]:
    return _loads(values) | _motion(values) | _ring(values) | _lines(values)


def _loads(values: Any) -> dict[str, Any]:
    load, angle = values["contact_load"], np.degrees(values["contact_angle"])
    return {
        "balls": load.shape[1],
        "balls_on_both_races": int((load > 0).all(0).sum()),
        "contact_load_range_N": _ranges(load),
        "contact_angle_range_deg": _ranges(angle),
        "peak_pressure_MPa": both_races(1e-6 * values["peak_pressure"].max(1)),
        "needed_friction": both_races(values["needed_friction"].max(1)),
        "semi_axis_across_mm": both_races(1e3 * values["semi_axis_across"].max(1)),
        "semi_axis_along_mm": both_races(1e3 * values["semi_axis_along"].max(1)),
        "ball_azimuths_deg": np.degrees(values["ball_azimuth"]),
        "contact_loads_N": both_races(load),
        "contact_angles_deg": both_races(angle),
    }


def _motion(values: Any) -> dict[str, Any]:
    return {
        "orbital_speed_range_rpm": _range(_RPM * values["orbital_speed"]),
        "ball_speed_range_rpm": _range(_RPM * values["ball_speed"]),
        "ball_attitude_range_deg": _range(np.degrees(values["ball_attitude"])),
        "ball_yaw_range_deg": _range(np.degrees(values["ball_yaw"])),
        "centrifugal_force_range_N": _range(values["centrifugal_force"]),
        "gyroscopic_moment_range_Nm": _range(values["gyroscopic_moment"]),
        "friction_torque_Nm": values.get("friction_torque"),
        "friction_heat_range_W": _range(values["friction_heat"]) if "friction_heat" in values else None,
    }


def _ring(values: Any) -> dict[str, Any]:
    return {
        "ring_load_N": values["ring_load"][:3],
        "ring_moment_Nm": values["ring_load"][3:],
        "ring_displacement_um": 1e6 * values["ring_displacement"][:3],
        "ring_tilt_mrad": 1e3 * values["ring_displacement"][3:],
        "stiffness_matrix_SI": values["stiffness_matrix"],
    }


def _lines(values: Any) -> dict[str, Any]:
    if "line_count" not in values:
        return dict.fromkeys(LINES)
    count = values["line_count"]
    return {
        "line_parameter_range": _ranges(values["line_parameter"]),
        "first_line_range": _ranges(values["first_line"]),
        "second_line_range": _ranges(values["second_line"]),
        "balls_with_one_line": both_races((count == 1).sum(1)),
        "balls_with_two_lines": both_races((count == 2).sum(1)),
        "first_lines": both_races(values["first_line"]),
        "second_lines": both_races(values["second_line"]),
        "line_counts": both_races(count),
        "spin_friction_Nm": values["spin_friction"],
        "spin_friction_by_lines_Nm": values["spin_friction_by_lines"],
        "largest_slip_mm_per_s": both_races(1e3 * np.nanmax(np.abs(values["slip_profile"]), axis=(1, 2))),
    }


def _ranges(pair: np.ndarray) -> dict[str, Any]:
    """Smallest and largest of each race."""
    return both_races([_range(values) for values in pair])


def _range(values: np.ndarray) -> np.ndarray:
    """Smallest and largest of the finite values (2)."""
    finite = values[np.isfinite(values)]
    return np.array([finite.min(), finite.max()])
