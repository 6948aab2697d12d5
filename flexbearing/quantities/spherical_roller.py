"""Output quantities of a spherical roller bearing: those of inclined rollers that it has."""

from dataclasses import replace

from flexbearing.quantities import tapered

_ABSENT = (
    "unloading_force",
    "inner_deflection",
    "outer_deflection",
    "film_ratio",
    "induced_thrust",
    "cone_angle",
)

LAYOUT = replace(
    tapered.LAYOUT,
    conventions="""\
Directions: x axial, z along the load; rows along growing x; azimuth from z towards y, left-handed about +x;
rotations about y and z are right-handed. Small end of a roller: that at the side face of the bearing.
""",
    quantities=tuple(
        each
        for each in tapered.QUANTITIES
        if each.name not in _ABSENT and not each.source.startswith(("friction.", "rib."))
    ),
    main=("max_roller_load", "life_L10", "peak_pressure.inner", "stiffness_zz"),
    further_blocks=(),
)
