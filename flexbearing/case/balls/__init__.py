"""The case files of ball bearings: four-point, angular contact and deep groove."""
