"""Units that people read in tables and pictures, from values in SI units."""

import numpy as np

from flexbearing.quantities.quantity import Unit

COUNT = Unit("")
PERCENT = Unit("%", 100)
DEG = Unit("deg", 180 / np.pi)
MRAD = Unit("mrad", 1e3)
W_PER_MM2 = Unit("W/mm^2", 1e-6)
UM = Unit("um", 1e6)
MM = Unit("mm", 1e3)
KN = Unit("kN", 1e-3)
UM_PER_M = Unit("um/m", 1e6)
RPM = Unit("rpm", 30 / np.pi)
MPA = Unit("MPa", 1e-6)
KN_PER_MM = Unit("kN/mm", 1e-6)
MREV = Unit("Mrev", 1e-6)
