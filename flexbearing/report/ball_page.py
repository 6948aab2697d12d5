"""The summaries of ball bearings, laid out as pages."""

from collections.abc import Iterator
from typing import Any

from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from flexbearing.report.four_point_compared import beside
from flexbearing.report.four_point_tables import PARTS
from flexbearing.report.sections import closing, matrix, right_aligned

_AXES = ("x", "y", "z", "about y", "about z")

# label, key in the block, format; one column for each race
_RACES_FOUR_POINT = (
    ("peak pressure [MPa]", "peak_pressure_MPa", ",.0f"),
    ("largest semi-axis across rolling [mm]", "semi_axis_across_mm", ".4f"),
    ("largest semi-axis along rolling [mm]", "semi_axis_along_mm", ".4f"),
    ("torque of the bearing [N m]", "torque_Nm", ".5g"),
)
_RACES_ANGULAR = (
    ("contact load [N]", "contact_load_range_N", ",.1f"),
    ("contact angle [deg]", "contact_angle_range_deg", ".2f"),
    ("peak pressure [MPa]", "peak_pressure_MPa", ",.0f"),
    ("largest semi-axis across rolling [mm]", "semi_axis_across_mm", ".4f"),
    ("largest semi-axis along rolling [mm]", "semi_axis_along_mm", ".4f"),
    ("friction that holds the gyroscopic moment", "needed_friction", ".4f"),
    ("E of the pure rolling lines", "line_parameter_range", ".3f"),
    ("c1, first pure rolling line", "first_line_range", ".3f"),
    ("c2, second pure rolling line", "second_line_range", ".3f"),
    ("balls with one line", "balls_with_one_line", "d"),
    ("balls with two lines", "balls_with_two_lines", "d"),
    ("largest slip across the middle [mm/s]", "largest_slip_mm_per_s", ",.1f"),
)
_ROWS_FOUR_POINT = (
    ("balls", "balls", "d"),
    ("balls that carry load", "loaded_balls", "d"),
    ("contacts that carry load", "loaded_contacts", "d"),
    ("largest contact load [N]", "max_contact_load_N", ",.1f"),
    ("contact angle [deg]", "contact_angle_range_deg", ".2f"),
    ("ball speed over ring speed", "ball_speed_ratio_range", ".2f"),
    ("angle of the ball's axis [deg]", "ball_attitude_range_deg", ".1f"),
    ("power loss [W]", "power_loss_W", ".4g"),
)
_ROWS_ANGULAR = (
    ("balls", "balls", "d"),
    ("balls on both races", "balls_on_both_races", "d"),
    ("orbital speed [rpm]", "orbital_speed_range_rpm", ",.0f"),
    ("ball speed [rpm]", "ball_speed_range_rpm", ",.0f"),
    ("angle of the ball's axis [deg]", "ball_attitude_range_deg", ".2f"),
    ("yaw of the ball's axis [deg]", "ball_yaw_range_deg", ".3f"),
    ("centrifugal force [N]", "centrifugal_force_range_N", ".3f"),
    ("gyroscopic moment [mN m]", "gyroscopic_moment_range_Nm", ".4f"),
    ("friction torque [N m]", "friction_torque_Nm", ".4g"),
    ("heat of friction of a ball [W]", "friction_heat_range_W", ".4g"),
    ("spin torque on the shaft [N m]", "spin_friction_Nm", ".4g"),
    ("  by the pure rolling lines [N m]", "spin_friction_by_lines_Nm", ".4g"),
)
_SCALES = {"gyroscopic_moment_range_Nm": 1e3}
_ONLY_BESIDE = {"ball_yaw_range_deg": "friction_torque_Nm"}  # zero by assumption unless friction decides
_RING = (
    ("displacement x, y, z [um]", "ring_displacement_um", ".3f"),
    ("turn about y, z [mrad]", "ring_tilt_mrad", ".4f"),
)


def four_point_page(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Loads, torque in parts, ring, assumed keys, notes, and how the run ended.

    Elastic rings are compared with rigid ones; then come the numbers of the elastic ones.
    """
    yield Text(numbers["title"], style="bold")
    if numbers["flexible"]:
        yield beside(numbers)
        yield Text("between the elastic rings", "bold")
    if block := numbers["flexible"] or numbers["rigid"]:
        yield _values(block, _ROWS_FOUR_POINT)
        yield _races(block, _RACES_FOUR_POINT)
        yield Text(
            f"torque in parts [N m]; that of the bearing by the {block['torque_formula']} formula", "bold"
        )
        yield _torque_parts(block)
        yield from _ring(block)
    yield from closing(numbers, _ending(numbers))


def angular_page(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Loads, motion, rolling lines, ring, assumed keys, notes, and how the run ended."""
    yield Text(numbers["title"], style="bold")
    if block := numbers["rigid"]:
        yield _values(block, _ROWS_ANGULAR)
        yield _races(block, _RACES_ANGULAR)
        yield from _ring(block)
    yield from closing(numbers, _ending(numbers))


def _values(block: dict[str, Any], rows: tuple[tuple[str, str, str], ...]) -> Table:
    table = right_aligned("", "value")
    for label, key, form in rows:
        if block[key] is not None and block[_ONLY_BESIDE.get(key, key)] is not None:
            table.add_row(Text(label), _shown(block[key], form, _SCALES.get(key, 1)))
    return table


def _races(block: dict[str, Any], rows: tuple[tuple[str, str, str], ...]) -> Table:
    table = right_aligned("", "inner", "outer")
    for label, key, form in rows:
        if block[key] is not None:
            table.add_row(Text(label), *(_shown(block[key][race], form) for race in ("inner", "outer")))
    return table


def _torque_parts(block: dict[str, Any]) -> Table:
    table = right_aligned("", "all balls", "mean ball", "heaviest ball")
    columns = ("torque_parts_Nm", "mean_ball_torque_parts_Nm", "largest_ball_torque_parts_Nm")
    for part in PARTS:
        table.add_row(part, *(_shown(block[column][part], ".5g") for column in columns))
    table.add_row("total, circumferential", _shown(block["circumferential_torque_Nm"], ".5g"), "", "")
    return table


def _ring(block: dict[str, Any]) -> Iterator[RenderableType]:
    """The inner ring; nothing when contact loads are given."""
    if block["ring_displacement_um"] is None:
        return
    table = right_aligned("inner ring", "")
    for label, key, form in _RING:
        table.add_row(Text(label), ", ".join(_formatted(value, form) for value in block[key]))
    yield table
    yield from matrix("tangent stiffness [N, m, rad]", block["stiffness_matrix_SI"], _AXES)


def _shown(value: Any, form: str, scale: float = 1) -> str:
    """A number, or a range in which both ends are told apart only when they differ as shown."""
    if not isinstance(value, list):
        return "-" if value is None else _formatted(value * scale, form)
    first, last = (_shown(end, form, scale) for end in value)
    return first if first == last else f"{first} to {last}"


def _formatted(value: float, form: str) -> str:
    """A number without the sign of a zero that rounding leaves."""
    return format(value, form if form == "d" else f"z{form}")


def _ending(numbers: dict[str, Any]) -> str:
    seconds = f"{numbers['wall_time_s']:.1f} s"
    if numbers["status"] == "converged":
        return f"converged: {numbers['message']}, {seconds}"
    return f"NOT CONVERGED: {numbers['status']} ({numbers['ending']}), {seconds}: {numbers['message']}"
