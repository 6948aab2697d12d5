"""Keys of ball bearings that files of older versions use, with the axes of that time."""

AXES_CHANGED = "axes changed: x axial, z along the load, azimuth from z to y, see docs/reference/axes.md"
LOAD = {  # former keys, and what has taken their place
    "operation.load.radial_x": f"operation.load.radial_z; {AXES_CHANGED}",
    "operation.load.moment_x": f"operation.load.moment_z, with the opposite sign; {AXES_CHANGED}",
}
ONE_FRICTION = {
    "operation.friction": "friction.coefficient, one for every use",
    "rolling_lines.coefficient": "friction.coefficient, one for every use",
}
DISPLACEMENT = {
    "operation.displacement.radial_x": f"operation.displacement.radial_z; {AXES_CHANGED}",
    "operation.displacement.tilt_x": f"operation.displacement.tilt_z, with the opposite sign; {AXES_CHANGED}",
}
