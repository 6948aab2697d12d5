"""Keys of ball bearings that files of older versions use, with the axes of that time, or that people miss."""

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
AS_CLEARANCE = {
    f"bearing.{name}": "An interference of balls and races is a negative bearing.clearance."
    for name in ("preload", "interference")
}
PLACES = {  # what people look for in [bearing], and where it is
    "bearing.preload": "A preload is in [operation.preload]: force or displacement; that of springs is "
    "operation.load.axial. An interference of balls and races is a negative bearing.clearance.",
    "bearing.interference": "An interference of balls and races is a negative bearing.clearance, of deep "
    "groove and four-point bearings.",
}
NO_CLASSES = {  # what people look for, and what to do instead
    "bearing.clearance_class": 'Classes of clearance are offered for kind = "cylindrical_roller" and '
    '"deep_groove_ball": for other ball bearings there is no printed table here.',
}
