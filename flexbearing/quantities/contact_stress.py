"""Output quantities of the worst contacts of each raceway, alike for rollers and balls."""

from flexbearing.quantities.layout import Axis
from flexbearing.quantities.quantity import Quantity, SummaryValue
from flexbearing.quantities.reductions import RACES, largest
from flexbearing.quantities.units import MPA, UM, W_PER_MM2

_ASKED = "absent without outputs.subsurface_stresses"
_WORST = "below the largest contact pressure (inner, outer)"
OF_SLICES = "largest of the slices of a contact, mean over their width"
SUBSURFACE_AXES = (Axis("S1", "depth_below"), Axis("S2", "place_in_rolling_direction"))


# declarations read best as a table:
# fmt: off
def worst_contact(source: str, section: str = "") -> tuple[Quantity, ...]:
    """What every result contains of the most pressed contacts."""
    return (
        Quantity("contact_half_width", "b", "race", "m", "block",
            "half of the width, in the rolling direction, of the contact with the largest pressure (inner, "
            "outer); of rollers that of a line contact with this pressure",
            source=f"{source}.half_width", people=UM, summary=(  # balls show their semi-axes
                SummaryValue("contact_half_width_um", label="half-width" if section else "",
                             digits=",.1f" if section else "", parts=RACES, section=section),)),
        Quantity("orthogonal_shear_stress", "tau_0", "race", "Pa", "block",
            "amplitude of the orthogonal shear stress, half of the range that a place of the raceway meets "
            f"in passing, {_WORST}, without friction",
            source=f"{source}.orthogonal_shear", people=MPA, summary=(
                SummaryValue("orthogonal_shear_stress_MPa", label="orthogonal shear stress", digits=",.0f",
                             parts=RACES, section=section),)),
        Quantity("orthogonal_shear_depth", "z_0", "race", "m", "block",
            "depth of the orthogonal shear stress (inner, outer)", source=f"{source}.orthogonal_depth",
            people=UM, summary=(
                SummaryValue("orthogonal_shear_depth_um", label="  its depth", digits=",.1f", parts=RACES,
                             section=section),)),
        Quantity("pressure_safety", "s_p", "race", "1", "block",
            "static safety by the largest contact pressure (inner, outer): load of the contact that has the "
            "pressure of the static rating (ISO 76: 4000 MPa of rollers, 4200 MPa of balls) over its load",
            source=f"{source}.safety", infinite=True, summary=(
                SummaryValue("pressure_safety", label="static safety by pressure", digits=",.2f", parts=RACES,
                             section=section),)),
    )


def static_safety(part: str, load: str, *, optional: bool = False) -> tuple[Quantity, ...]:
    """The static safety of a bearing, by its equivalent load and by the load of its elements."""
    absent = "; absent where ISO 76 has no rating and the case gives none" if optional else ""
    return (
        Quantity("static_safety", "s_0", "", "1", "block",
            "static safety of the bearing, C_0/P_0 by ISO 76: life.static_rating, or its formula, over the "
            f"equivalent load of {load}; infinite without load{absent}", source=f"{part}.static_safety",
            infinite=True, optional=optional, summary=(
                SummaryValue("static_safety", label="static safety C_0/P_0", digits=",.2f"),)),
        Quantity("effective_static_safety", "S_0,eff", "", "1", "block",
            "static safety from the largest load Q of a ball, or of a roller as loaded as the most loaded "
            "slice, 5 C_0/(i Z cos(alpha) Q) as a public program states ISO 17956:2025, between washers "
            "C_0/(Z Q); infinite without load"
            f"{absent}", source=f"{part}.effective_static_safety", infinite=True, optional=optional, summary=(
                SummaryValue("effective_static_safety", label="effective static safety", digits=",.2f"),)),
    )


def friction_intensity(source: str, mean: str, absent: str = "") -> Quantity:
    """What published criteria of smearing limit, a mean over the width of a slice or over a contact."""
    return Quantity("friction_intensity", "", "race Z", "W/m^2", "block",
        f"frictional power intensity: traction times sliding speed per area, {mean} (inner, outer), 0 "
        f"without load; no limit is declared{absent and f'; {absent}'}", source=source, people=W_PER_MM2,
        optional=bool(absent), summary=(
            SummaryValue("largest_friction_intensity_W_per_mm2", largest,
                         "sliding power per area", ",.3g", parts=RACES),))


def subsurface(section: str = "") -> tuple[Quantity, ...]:
    """What is reported of the stresses below these contacts where a case requires them."""
    return (
        Quantity("von_mises_stress", "sigma_v", "race", "Pa", "block",
            f"largest von Mises stress {_WORST}; {_ASKED}", source="subsurface.largest", people=MPA,
            optional=True, summary=(
                SummaryValue("von_mises_stress_MPa", label="von Mises stress", digits=",.0f",
                             parts=RACES, section=section),)),
        Quantity("von_mises_depth", "", "race", "m", "block",
            f"depth of the largest von Mises stress (inner, outer); {_ASKED}",
            source="subsurface.largest_depth", people=UM, optional=True, summary=(
                SummaryValue("von_mises_depth_um", label="  its depth", digits=",.1f", parts=RACES,
                             section=section),)),
        Quantity("subsurface_friction", "mu", "race", "1", "block",
            "traction on the raceway over the load of these contacts, positive to +azimuth, which the "
            f"stresses below hold as sliding friction; 0 for balls; {_ASKED}", source="subsurface.friction",
            optional=True),
        Quantity("subsurface_position", "x", "race S2", "m", "block",
            "middles of the cells of these stresses along the rolling direction, 0 in the middle of the "
            f"contact; {_ASKED}", source="subsurface.positions", people=UM, optional=True),
        Quantity("subsurface_depth", "z", "race S1", "m", "block",
            f"middles of the cells below the surface; {_ASKED}", source="subsurface.depths", people=UM,
            optional=True),
        Quantity("subsurface_von_mises", "sigma_v", "race S1 S2", "Pa", "block",
            f"von Mises stress, {_WORST}, in the plane of rolling; {_ASKED}", source="subsurface.von_mises",
            people=MPA, optional=True),
        Quantity("subsurface_shear", "tau_xz", "race S1 S2", "Pa", "block",
            "orthogonal shear stress there, between the rolling direction, towards +azimuth, and the depth; "
            f"{_ASKED}", source="subsurface.shear", people=MPA, optional=True),
    )
# fmt: on
