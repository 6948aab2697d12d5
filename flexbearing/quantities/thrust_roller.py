"""Output quantities of a roller thrust bearing: those of inclined rollers that it has."""

from dataclasses import replace

from flexbearing.quantities import tapered
from flexbearing.quantities.quantity import SummaryValue, Unit

_ABSENT = {  # of ribs, of a second row, of radial loads and of elastic rings
    "roller_row", "row_load", "unloading_force", "inner_deflection", "outer_deflection", "loss_rib",
    "axial_load_limit", "axial_load_factor", "induced_thrust", "cone_angle",
}  # fmt: skip


def _quantities():
    """Those of inclined rollers with the words of washers."""
    for each in tapered.QUANTITIES:
        if each.name in _ABSENT or each.name.startswith("rib_"):
            continue
        changed = each
        if each.name == "stiffness_matrix":
            along = (
                SummaryValue("stiffness_xx_N_per_m", lambda k: k[..., 0, 0], unit=Unit("N/m")),
                SummaryValue("stiffness_tilt_Nm_per_rad", lambda k: k[..., 3, 3], unit=Unit("N m/rad")),
            )
            changed = replace(each, summary=(*along, each.summary[-1]))
        if each.name == "driving_power":
            total = each.summary[0]
            assert total.of
            of = tuple(name for name in total.of if name not in _ABSENT)
            changed = replace(each, summary=(replace(total, of=of), *each.summary[1:]))
        yield changed


LAYOUT = replace(
    tapered.LAYOUT,
    conventions="""\
Directions: x axial, an axial load > 0 presses the shaft washer, the inner ring, on the rollers and these on
the housing washer, the outer ring; azimuth from z towards y, left-handed about +x; rotations about y and z
are right-handed.
""",
    quantities=tuple(_quantities()),
    main=("max_roller_load", "life_L10", "peak_pressure.inner", "stiffness_xx"),
    weighed=(
        ("max_roller_load", "largest load"),
        ("peak_pressure.inner", "peak pressure"),
        ("stiffness_xx", "stiffness"),
    ),
    further_blocks=(),
)
