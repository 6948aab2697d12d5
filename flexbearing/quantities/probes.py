"""Output quantities of probes on elastic rings, alike for rollers and balls."""

from flexbearing.quantities.layout import Axis
from flexbearing.quantities.quantity import Quantity, SummaryValue, Unit
from flexbearing.quantities.units import DEG, UM, UM_PER_M

_NO_PROBES = "absent without [outputs.probes]"
PROBE_AXIS = Axis("J", "probe", coordinate="probe_azimuth")


def _reading(name: str, symbol: str, meaning: str, people: Unit, source: str = "") -> Quantity:
    """What every probe reads."""
    unit = people.name.replace("/", "_per_")
    return Quantity(
        f"probe_{name}", symbol, "J", "m" if people is UM else "1", "block",
        f"{meaning}, mean along the gauge; {_NO_PROBES}", source=f"probes.{source or name}", people=people,
        optional=True, summary=(SummaryValue(f"probes.{name}_{unit}"),),
    )  # fmt: skip


# fmt: off
PROBES = (
    Quantity("probe_azimuth", "", "J", "rad", "block",
        f"middle of the probe, 0 on the z axis, positive towards y; {_NO_PROBES}", source="probes.azimuth",
        people=DEG, optional=True, summary=(SummaryValue("probes.azimuth_deg"),)),
    _reading("radial_displacement", "u_r", "displacement of the ring, positive outward", UM,
        "displacement.1"),
    _reading("tangential_displacement", "u_t", "displacement of the ring, positive to +azimuth", UM,
        "displacement.2"),
    _reading("axial_displacement", "u_x", "displacement of the ring, positive to +x", UM,
        "displacement.0"),
    _reading("gauge_strain", "epsilon", "strain along the gauge by stress, without free expansion", UM_PER_M),
    _reading("hoop_strain", "epsilon_t", "strain along the circumference", UM_PER_M, "strain.2"),
    _reading("axial_strain", "epsilon_x", "strain along the axis", UM_PER_M, "strain.0"),
    _reading("radial_strain", "epsilon_r", "strain along the radius", UM_PER_M, "strain.1"),
    _reading("largest_strain", "epsilon_1", "larger principal strain in the surface", UM_PER_M,
        "principal_strains.0"),
    _reading("smallest_strain", "epsilon_2", "smaller principal strain in the surface", UM_PER_M,
        "principal_strains.1"),
    _reading("strain_error", "", "estimated discretisation error of the strains", UM_PER_M),
)
# fmt: on
