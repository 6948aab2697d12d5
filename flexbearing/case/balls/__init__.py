"""The case files of ball bearings: four-point and angular contact."""
