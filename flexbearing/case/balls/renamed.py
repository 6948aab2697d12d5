"""Keys of ball bearings that files of older versions use, with the axes of that time."""

AXES_CHANGED = "axes changed: x axial, z along the load, azimuth from z to y, see docs/reference/axes.md"
RENAMED = {  # former keys of ball bearings, and what has taken their place
    "operation.load.radial_x": "operation.load.radial_z",
    "operation.load.moment_x": "operation.load.moment_z, with the opposite sign",
    "operation.displacement.radial_x": "operation.displacement.radial_z",
    "operation.displacement.tilt_x": "operation.displacement.tilt_z, with the opposite sign",
}
