"""Bodies of revolution on their axial section, by harmonics: rings, shafts, smeared cages, bolted rings.

Line supports and tooth forces on a ring belong here; fits that open or slide are in `fem.joint`.
"""
