"""Output quantities of a cylindrical roller bearing.

The page of a result shows its rows in the order of declaration.
"""

from flexbearing.quantities import roller_records as records
from flexbearing.quantities.attributes import HEAD, Attribute
from flexbearing.quantities.contact_stress import (
    OF_SLICES,
    SUBSURFACE_AXES,
    friction_intensity,
    static_safety,
    subsurface,
    worst_contact,
)
from flexbearing.quantities.coupling import (
    ATTEMPTS,
    CHOICES,
    ERROR_ESTIMATE,
    ITERATIONS,
    METHOD,
    STRESSES,
    STRUCTURE,
)
from flexbearing.quantities.layout import Axis, Layout
from flexbearing.quantities.life_records import CATALOGUE_ATTRIBUTE, LIFE_ATTRIBUTE, RULE_ATTRIBUTE
from flexbearing.quantities.probes import PROBE_AXIS, PROBES
from flexbearing.quantities.quantity import Quantity, SummaryValue, Unit
from flexbearing.quantities.reductions import (
    RACES,
    ROWS,
    YZ,
    across,
    along,
    azimuth_of_largest,
    largest,
    largest_at_mid_roller,
    largest_at_roller_ends,
    largest_of_ends,
    largest_size,
    length,
    loaded_arc_in_degrees,
    loaded_rollers,
    loaded_share_at_largest,
    place_of_largest,
    smallest_above_zero,
    stacked,
    total,
    touching_both,
)
from flexbearing.quantities.stiffness import RADIAL_STIFFNESSES, TOTAL_STIFFNESSES
from flexbearing.quantities.units import (
    COUNT,
    DEG,
    KN_PER_MM,
    MM,
    MPA,
    MRAD,
    MREV,
    PERCENT,
    RPM,
    UM,
)

_DEVIATION = "positive outward, without form error, local indentation and rigid translation"
_DEVIATIONS = ("inner_deviation", "outer_deviation")
_FLANGED = "absent without [bearing.flange]"
_THRUST = "absent without operation.axial_load"
_NOT_IN_SERIES = "absent where bearing and supports in series are not total_stiffness within 2 %"
_NO_BARS = "absent without bars"
_ONE_ROW = "absent of one row"
_NO_ROUGHNESS = "absent without roughness"
_PRESSURE = (
    "by Hertz, with the edge stress factor where life.edge_stress is on; that of half-spaces for the "
    'most loaded roller with bearing.contact = "half_space"'
)
_SLICED = 'absent without bearing.contact = "half_space"'
LOSSES = ("sliding", "rolling", "drag", "pocket", "land", "churning", "ribs", "transport")
SKEW = "skew"  # section of the page
RIBS = "ribs"  # section of the page
CONTACT = "contact"  # section of the page
_PRESSURES = ("inner_pressure", "outer_pressure")

CAGE_SLIP = Quantity(
    "cage_slip", "s", "", "1", "state",
    "1 - cage speed / cage speed in pure rolling, positive: the cage lags behind", people=PERCENT,
    summary=(SummaryValue("cage_slip_percent", label="cage slip", digits=".2f",
                          error="cage_slip", error_relative=False),),
)  # fmt: skip


# declarations read best as a table:
# fmt: off
QUANTITIES = (
    # loads
    Quantity("inner_load", "Q_i", "Z", "N", "state", "load of the inner contact, >= 0",
        source="state.loads.0", summary=(
            SummaryValue("max_roller_load_N", largest, "largest roller load, inner", ",.1f",
                         error="roller_load"),
            SummaryValue("roller_loads_N"),
        )),
    Quantity("outer_load", "Q_o", "Z", "N", "state", "load of the outer contact, >= 0",
        source="state.loads.1", summary=(
            SummaryValue("max_outer_load_N", largest, "largest roller load, outer", ",.1f",
                         error="roller_load"),
            SummaryValue("outer_loads_N"),
        )),
    Quantity("inner_slice_load", "q_i", "Z K", "N/m", "state",
        "load per length of the inner contact, >= 0", source="state.slice_loads.0"),
    Quantity("outer_slice_load", "q_o", "Z K", "N/m", "state",
        "load per length of the outer contact, >= 0", source="state.slice_loads.1"),
    Quantity("roller_azimuth", "phi", "Z", "rad", "block",
        "place of the roller, 0 on the z axis, positive towards y", source="state.azimuths", people=DEG,
        summary=(
            SummaryValue("loaded_rollers", loaded_rollers, "loaded rollers", "d", of=("inner_load",),
                         unit=COUNT),
            SummaryValue("loaded_arc_deg", loaded_arc_in_degrees, "loaded arc", ".0f",
                         of=("roller_azimuth", "inner_load"), unit=Unit("deg")),
            SummaryValue("roller_azimuths_deg"),
        )),
    Quantity("roller_row", "", "Z", "1", "block", f"number of the row of the roller, from 0; {_ONE_ROW}",
        source="state.roller_row", optional=True),
    Quantity("roller_station", "x", "Z", "m", "block",
        f"axial place of mid-roller from the middle between the rows; {_ONE_ROW}",
        source="state.roller_station", people=MM, optional=True),
    Quantity("row_load", "", "row transverse", "N", "block",
        f"radial force that each row takes for the inner ring (y, z); {_ONE_ROW}", source="state.row_load",
        optional=True, summary=(
            SummaryValue("row_load_N", length, "radial force", ",.1f", entries=ROWS),)),
    Quantity("row_load_factor", "K_gamma", "", "1", "block",
        "largest radial force of a row over an even share of the radial load; not a number without one; "
        f"{_ONE_ROW}", source="state.row_load_factor", optional=True, gaps=True,
        summary=(SummaryValue("row_load_factor", label="most loaded row over an even share", digits=".3f"),)),
    Quantity("row_loss", "", "row", "W", "block",
        f"power lost at the raceways of each row, by sliding and in the inlets; {_ONE_ROW}",
        source="state.row_loss", optional=True,
        summary=(SummaryValue("row_loss_W", label="power lost at the raceways", digits=",.2f",
                              entries=ROWS),)),
    Quantity("slice_position", "x", "K", "m", "block",
        "axial place of the slice's middle, 0 at mid-roller", source="state.slice_positions", people=MM),

    # life
    Quantity("life_L10", "L_10", "", "rev", "block",
        "life of both raceways together from the loads of all slices and the capacities of Lundberg and "
        "Palmgren, 90 % survival; not the basic rating life of ISO 281", source="rows.basic_life",
        people=MREV,
        summary=(SummaryValue("life_L10_Mrev", label="life L10", digits=",.2f", error="life",
                              speed="relative_speed"),)),
    Quantity("life_error", "", "", "1", "block",
        "estimated numerical error of the life by slices and axial shapes / life; absent with "
        "accuracy.target, which has another estimate, and where nothing could be estimated",
        source="rows.life_error", people=PERCENT,
        optional=True, summary=(
            SummaryValue("life_error_percent", label="  its numerical error, estimated",
                         digits=".2g", compared=False),)),
    Quantity("raceway_life", "L_10,i, L_10,o", "race", "rev", "block",
        "rating life of each raceway alone (inner, outer), 90 % survival", source="rows.raceway_life",
        people=MREV, infinite=True,
        summary=(SummaryValue("raceway_life_Mrev", label="life of each raceway", digits=",.2f", parts=RACES,
                              speed="relative_speed"),)),
    Quantity("reference_life", "L_10r", "", "rev", "block",
        "reference life by ISO/TS 16281: C_r of the maker or of ISO 281, with the edge stress where "
        'life.edge_stress is on, 90 % survival; absent without life.capacity = "iso281"',
        source="life.reference", people=MREV, optional=True,
        summary=(SummaryValue("reference_life_Mrev", label="reference life L10r, ISO/TS 16281",
                              digits=",.2f", speed="relative_speed"),)),
    Quantity("modified_life", "L_nm", "", "rev", "block",
        "life after every factor of [life], see the attribute life; absent when nothing modifies it",
        source="life.modified", people=MREV, optional=True,
        summary=(SummaryValue("modified_life_Mrev", label="modified life", digits=",.2f",
                              speed="relative_speed"),)),
    Quantity("relative_speed", "", "", "rad/s", "block",
        "speed of the inner ring less that of the outer ring, by which revolutions become hours",
        source="rows.relative_speed", people=RPM),

    # stiffness and place of the ring
    Quantity("stiffness", "k", "", "N/m", "block",
        "radial tangent stiffness between raceways without the mean translation of the rings on their "
        f"supports; {_NOT_IN_SERIES}",
        source="end.stiffness", optional=True, people=KN_PER_MM,
        summary=(SummaryValue("stiffness_N_per_m", label="stiffness of the bearing", digits=",.1f",
                              in_si=True, error="stiffness"),)),
    Quantity("total_stiffness", "k_t", "", "N/m", "block",
        "radial tangent stiffness from base to shaft ends, supports included",
        source="end.with_supports.radial_stiffness", people=KN_PER_MM,
        summary=(SummaryValue("total_stiffness_N_per_m", label="stiffness with supports", digits=",.1f",
                              in_si=True, error="total_stiffness"),)),
    Quantity("radial_stiffness", "", "radial_force transverse", "N/m", "block",
        "radial tangent stiffness between raceways without the mean translation of the rings on their "
        "supports, forces along y and z by displacements along y and z; the tilt follows, or stays "
        f"where operation.tilt holds it; {_NOT_IN_SERIES}",
        source="end.radial_matrix", optional=True, people=KN_PER_MM),
    Quantity("total_radial_stiffness", "", "radial_force transverse", "N/m", "block",
        "radial tangent stiffness from base to shaft ends, supports included, forces along y and z by "
        "displacements along y and z; the tilt follows, or stays where operation.tilt holds it",
        source="end.with_supports.radial_matrix", people=KN_PER_MM, summary=TOTAL_STIFFNESSES),
    Quantity("support_stiffness", "", "", "N/m", "block",
        "radial stiffness of the support of the outer ring, such as the bars of a squirrel cage; absent "
        f"where the outer raceway is rigid, or its support, and {_NOT_IN_SERIES}",
        source="end.support_stiffness", optional=True, people=KN_PER_MM,
        summary=(SummaryValue("support_stiffness_N_per_m", in_si=True),)),
    Quantity("outer_mass", "", "", "kg", "block",
        "mass of the outer ring, of a squirrel cage with bars and flange, without fillets; absent where the "
        "outer raceway is rigid, and of a drawn part",
        source="rows.outer_mass", optional=True, people=Unit("g", 1e3),
        summary=(SummaryValue("outer_mass_g", compared=False),)),
    Quantity("support_stiffness_ratio", "", "", "1", "block",
        "support_stiffness of the outer ring over stiffness of the bearing; absent where the outer raceway "
        f"is rigid, or its support, and {_NOT_IN_SERIES}",
        source="end.support_stiffness_ratio", optional=True,
        summary=(SummaryValue("support_stiffness_ratio", label="stiffness of outer support / of bearing",
                              digits=".3f"),)),
    Quantity("stiffness_matrix", "K", "force displacement", "N/m, N/rad, N m/m, N m/rad", "block",
        "tangent stiffness from base to shaft ends, supports included, x, y, z, about y, about z "
        "(right-handed: about y is -dz/dx, about z is dy/dx); an entry holds all other displacements and "
        "tilts; zero along x",
        source="end.with_supports.stiffness",
        summary=(
            *RADIAL_STIFFNESSES,
            SummaryValue("stiffness_matrix_SI"),
        )),
    Quantity("compliance_matrix", "K^-1", "displacement force", "m/N, m/(N m), rad/N, rad/(N m)", "block",
        "its inverse; infinite along x, which it leaves out also of rings on ribs, see axial_stiffness",
        infinite=True, source="end.with_supports.compliance",
        summary=(SummaryValue("compliance_matrix_SI"),)),
    Quantity("load_direction", "", "", "rad", "block", "azimuth that the radial load points to", people=DEG),
    Quantity("ring_displacement", "delta", "transverse", "m", "state",
        "displacement (y, z) of the inner ring against the outer one at mid-roller, from the concentric "
        "place, positive along the axes: half the clearance is in it, translation of raceways on elastic "
        "supports (support_translation) is not", people=UM, summary=(
            SummaryValue("displacement_along_load_um", along, "ring displacement along load", ".2f",
                         of=("ring_displacement", "load_direction")),
            SummaryValue("displacement_across_load_um", across, "ring displacement across load", ".2f",
                         of=("ring_displacement", "load_direction")),
            SummaryValue("ring_displacement_um", entries=YZ),
        )),
    Quantity("ring_tilt", "", "slope", "rad", "state", "slopes of the inner ring axis (dz/dx, dy/dx)",
        people=MRAD),
    Quantity("ring_moment", "", "slope", "N m", "block",
        "moment on the inner ring, one for each slope of ring_tilt: applied (free) or reaction (held)"),
    Quantity("support_translation", "", "race transverse", "m", "block",
        "rigid translation of the raceway on its support, (inner, outer) by (y, z)",
        source="end.support_translation", people=UM),
    Quantity("inner_deviation", "w_i", "Z K", "m", "state",
        f"radial displacement of the inner raceway at the roller, {_DEVIATION}",
        source="state.deviation_along_rollers.0", people=UM,
        summary=(
            SummaryValue("mid_roller_deviation_um", largest_at_mid_roller,
                         "raceway deviation, mid-roller", ".2f", of=_DEVIATIONS),
            SummaryValue("roller_end_deviation_um", largest_at_roller_ends,
                         "raceway deviation, roller ends", ".2f", of=_DEVIATIONS),
        )),
    Quantity("outer_deviation", "w_o", "Z K", "m", "state",
        f"radial displacement of the outer raceway at the roller, {_DEVIATION}",
        source="state.deviation_along_rollers.1", people=UM),
    Quantity("roller_tilt", "", "Z", "rad", "state",
        "slope of the roller axis, positive: +x end further out", people=MRAD),

    # motion
    CAGE_SLIP,
    Quantity("cage_speed", "omega_c", "", "rad/s", "state", "speed of the cage, positive to +azimuth",
        people=RPM, summary=(SummaryValue("cage_speed_rpm", label="cage speed", digits=",.0f"),)),
    Quantity("cage_force", "F_c", "Z", "N", "state", "force of the cage on the roller, positive to +azimuth",
        summary=(SummaryValue("max_pocket_force_N", largest_size, "largest pocket force", ",.2f"),)),
    Quantity("cage_offset", "", "transverse", "m", "block",
        "centre of a free cage from that of its guiding ring (y, z); absent when it is held",
        people=UM, optional=True,
        summary=(SummaryValue("cage_offset_um", length, "offset of the cage centre", ",.1f"),)),
    Quantity("pocket_displacement", "", "Z", "m", "block",
        "roller from the centre of its pocket, positive to +azimuth; absent without pocket clearance",
        people=UM, optional=True,
        summary=(SummaryValue("max_pocket_displacement_um", largest_size, "largest pocket displacement",
                              ",.1f"),)),
    Quantity("roller_speed", "w", "Z", "rad/s", "state",
        "spin relative to the cage frame, positive when it rolls forwards on the inner ring", people=RPM),
    Quantity("roller_slip", "", "Z", "1", "block",
        "1 - spin of the roller / spin in pure rolling, positive: it lags behind, 1: it does not spin",
        people=PERCENT),
    Quantity("inner_sliding", "u_i", "Z", "m/s", "state",
        "speed of the inner raceway over the roller surface, positive to +azimuth", source="state.sliding.0"),
    Quantity("outer_sliding", "u_o", "Z", "m/s", "state",
        "speed of the outer raceway over the roller surface, positive to +azimuth", source="state.sliding.1"),
    Quantity("inner_traction", "T_i", "Z", "N", "state",
        "traction of the inner raceway on the roller, positive to +azimuth", source="state.traction.0"),
    Quantity("outer_traction", "T_o", "Z", "N", "state",
        "traction of the outer raceway on the roller, positive to +azimuth", source="state.traction.1"),
    friction_intensity("state.friction_intensity", f"{OF_SLICES}, skew left out"),
    Quantity("inner_inlet_shear", "S_i", "Z", "N", "block",
        "shear of the inner inlet on the roller, positive to +azimuth; the same acts on the raceway",
        source="state.acting.inlet_shear.0"),
    Quantity("outer_inlet_shear", "S_o", "Z", "N", "block",
        "shear of the outer inlet on the roller, positive to +azimuth; the same acts on the raceway",
        source="state.acting.inlet_shear.1"),
    Quantity("inner_inlet_pressure", "P_i", "Z", "N", "block",
        "pressure of the inner inlet through the roller's centre, positive to +azimuth",
        source="state.acting.inlet_pressure.0"),
    Quantity("outer_inlet_pressure", "P_o", "Z", "N", "block",
        "pressure of the outer inlet through the roller's centre, positive to +azimuth",
        source="state.acting.inlet_pressure.1"),
    Quantity("inner_load_moment", "M_i", "Z", "N m", "block",
        "moment of the inner load about mid-roller, positive: more of it at +x",
        source="state.acting.load_moment.0"),
    Quantity("outer_load_moment", "M_o", "Z", "N m", "block",
        "moment of the outer load about mid-roller, positive: more of it at +x",
        source="state.acting.load_moment.1"),
    Quantity("roller_drag", "F_g", "Z", "N", "block",
        "force of the oil-air mixture on the roller, positive to +azimuth", source="state.acting.drag"),
    Quantity("centrifugal_force", "F_z", "Z", "N", "block", "centrifugal force of the roller, outwards",
        source="state.acting.centrifugal"),
    Quantity("roller_weight", "G", "part Z", "N", "block",
        "weight of the roller, its parts outwards and to +azimuth", source="state.acting.weight"),
    Quantity("pocket_friction", "F_p", "part Z", "N", "block",
        "friction of the pocket on the roller: outwards; at its surface against the spin, signed like it",
        source="state.acting.pocket_friction"),
    Quantity("churning_torque", "M_c", "Z", "N m", "block",
        "torque of the oil-air mixture between roller and cage against the spin, signed like it",
        source="state.acting.churning"),
    Quantity("transport_torque", "M_J", "Z", "N m", "block",
        "torque that the change of spin around the bearing takes from the roller", source="state.transport"),
    Quantity("land_torque", "M_l", "", "N m", "block", "torque of the guiding land on the cage"),
    Quantity("land_force", "F_l", "transverse", "N", "block",
        "force of the guiding land on a free cage (y, z); absent when it is held", source="state.acting.land",
        optional=True),
    Quantity("cage_body_force", "", "transverse", "N", "block",
        "weight of a free cage and force of its unbalance (y, z); absent when it is held",
        source="state.acting.cage_body", optional=True),
    Quantity("applied_load", "F", "transverse", "N", "block", "radial load on the inner ring (y, z)"),
    Quantity("balance_radii", "r", "circle", "m", "block",
        "inner raceway, centres of the rollers, outer raceway: radii by which the forces turn",
        source="state.acting.radii", people=MM),
    Quantity("outer_torque", "", "", "N m", "block",
        "torque that keeps the outer ring turning or holds it, positive to +azimuth"),
    Quantity("driving_torque", "", "", "N m", "block",
        "torque that keeps the inner ring turning, positive to +azimuth",
        summary=(SummaryValue("driving_torque_Nm", label="driving torque", digits=".4f",
                              error="driving_torque"),)),

    # contacts
    Quantity("peak_pressure", "p", "race", "Pa", "block",
        "largest contact pressure (inner, outer), by slices as bearing.contact says or of the whole roller",
        source="rows.peak_pressure", people=MPA,
        summary=(
            SummaryValue("peak_pressure_MPa", label="peak pressure", digits=",.0f", parts=RACES,
                         error="peak_pressure"),
            SummaryValue("peak_pressure_azimuth_deg", azimuth_of_largest, "azimuth of peak pressure", ".1f",
                         of=(*_PRESSURES, "roller_azimuth"), unit=DEG, compared=False, parts=RACES,
                         section=CONTACT),
            SummaryValue("peak_pressure_position_mm", place_of_largest, "axial place of peak", ".3f",
                         of=(*_PRESSURES, "slice_position"), unit=MM, compared=False, parts=RACES,
                         section=CONTACT),
            SummaryValue("loaded_length_percent", loaded_share_at_largest, "loaded share of that roller",
                         ".0f", of=_PRESSURES, unit=PERCENT, parts=RACES, section=CONTACT),
        )),
    Quantity("inner_pressure", "p_i", "Z K", "Pa", "block", f"largest pressure of each slice of the inner "
        f"contact, >= 0; {_PRESSURE}", source="rows.slice_pressure.0", people=MPA),
    Quantity("outer_pressure", "p_o", "Z K", "Pa", "block", f"largest pressure of each slice of the outer "
        f"contact, >= 0; {_PRESSURE}", source="rows.slice_pressure.1", people=MPA),
    *worst_contact("rows.worst", CONTACT),
    *subsurface(CONTACT),
    *static_safety("rows", "the radial load"),
    Quantity("inner_film", "h_i", "Z", "m", "state", "film thickness of the inner contact, 0 without load",
        source="state.loaded_film.0", people=UM),
    Quantity("outer_film", "h_o", "Z", "m", "state", "film thickness of the outer contact, 0 without load",
        source="state.loaded_film.1", people=UM),
    Quantity("minimum_film", "h", "race", "m", "block", "smallest film of a loaded contact (inner, outer)",
        people=UM,
        summary=(SummaryValue("minimum_film_um", label="smallest film", digits=".3f", parts=RACES),)),
    Quantity("inner_film_ratio", "Lambda_i", "Z", "1", "block",
        f"film over composite roughness of the inner contact, 0 without load; {_NO_ROUGHNESS}",
        source="rows.film_ratio.0", optional=True,
        summary=(
            SummaryValue("minimum_lambda", smallest_above_zero, "smallest film ratio", ".2f", parts=RACES,
                         of=("inner_film_ratio", "outer_film_ratio")),
            SummaryValue("lambda_ratios", stacked, parts=RACES, of=("inner_film_ratio", "outer_film_ratio")),
        )),
    Quantity("outer_film_ratio", "Lambda_o", "Z", "1", "block",
        f"film over composite roughness of the outer contact, 0 without load; {_NO_ROUGHNESS}",
        source="rows.film_ratio.1", optional=True),

    # the most loaded roller as a whole
    Quantity("whole_roller", "", "", "1", "block",
        f"number of the roller, from 0, whose contacts were solved on half-spaces; {_SLICED}",
        source="whole.number", optional=True),
    Quantity("whole_roller_position", "y", "Y", "m", "block",
        f"axial place of the cells' middles, 0 at mid-roller; {_SLICED}", source="whole.positions",
        people=MM, optional=True),
    Quantity("whole_roller_across", "x", "race X", "m", "block",
        f"place of the cells' middles along the rolling direction, 0 in the middle; {_SLICED}",
        source="whole.across", people=MM, optional=True),
    Quantity("whole_roller_pressure", "p", "race X Y", "Pa", "block",
        f"pressure of the cells, >= 0; {_SLICED}", source="whole.pressure", people=MPA, optional=True),
    Quantity("whole_roller_line_load", "q", "race Y", "N/m", "block",
        f"load per length along the roller, >= 0; {_SLICED}", source="whole.line_load", optional=True),
    Quantity("whole_roller_tilt", "t", "race", "rad", "block",
        "tilt of the roller against the raceway on half-spaces, that of its slices or, where the ring tilts "
        f"freely, the one that its moment causes, positive: +x end pressed in; {_SLICED}",
        source="whole.tilt", people=MRAD, optional=True),
    Quantity("peak_pressure_error", "", "race", "Pa", "block",
        "estimated discretisation error of the whole roller's peak pressure: its change with cells of twice "
        f"the size; at a sharp end there is no limit; {_SLICED}", source="whole.pressure_error", people=MPA,
        optional=True,
        summary=(SummaryValue("peak_pressure_error_MPa", label="  its error, estimated", digits=",.1f",
                              parts=RACES, compared=False),)),
    Quantity("sliced_peak_pressure", "", "race", "Pa", "block",
        f"largest pressure that slices alone have, each a line contact; {_SLICED}",
        source="whole.state.peak_pressure", people=MPA, optional=True,
        summary=(SummaryValue("sliced_peak_pressure_MPa", label="  by slices alone", digits=",.0f",
                              parts=RACES),)),
    Quantity("sliced_life", "", "", "rev", "block", f"rating life that slices alone give; {_SLICED}",
        source="whole.sliced_life", people=MREV, optional=True,
        summary=(SummaryValue("sliced_life_Mrev", label="life L10 by slices alone", digits=",.2f"),)),

    # bars of a squirrel cage
    Quantity("bar_azimuth", "", "B", "rad", "block",
        "middle of the bar, 0 on the z axis, positive towards y; of bars at both ends those at +x "
        f"come first; {_NO_BARS}",
        source="rows.bar_azimuths", people=DEG, optional=True),
    Quantity("bar_axial_force", "N", "B", "N", "block",
        f"axial force of the bar, tension positive; {_NO_BARS}", source="bars.forces.axial", optional=True),
    Quantity("bar_radial_moment", "M_n", "B bar_end", "N m", "block",
        "moment that bends the bar radially, at its ends (ring, flange), positive: tension outside; "
        f"{_NO_BARS}", source="bars.forces.radial_moment", optional=True),
    Quantity("bar_tangential_moment", "M_t", "B bar_end", "N m", "block",
        "moment that bends the bar tangentially, at its ends (ring, flange), positive: tension at larger "
        f"azimuth; {_NO_BARS}", source="bars.forces.tangential_moment", optional=True),
    Quantity("bar_torque", "T", "B", "N m", "block",
        "torque in the bar, of the part towards the flange on that towards the ring, positive about +x; "
        f"{_NO_BARS}", source="bars.forces.torque", optional=True),
    Quantity("nominal_bar_stress", "sigma", "B bar_end", "Pa", "block",
        "largest nominal normal stress at the ends of the bar (ring, flange) by magnitude, from axial force "
        f"and moments, without the stress concentration of its feet; {_NO_BARS}",
        source="bars.forces.stress", people=MPA, optional=True,
        summary=(SummaryValue("nominal_bar_stress_MPa", largest_of_ends, "largest nominal bar stress",
                              ",.0f"),)),
    Quantity("nominal_bar_stress_error", "", "", "Pa", "block",
        f"estimated discretisation error of the largest nominal bar stress; {_NO_BARS}", source="bars.error",
        people=MPA, optional=True,
        summary=(SummaryValue("nominal_bar_stress_error_MPa", label="  its error, estimated",
                              digits=",.1f"),)),
    Quantity("bar_torsion_stress", "tau", "B", "Pa", "block",
        "nominal shear stress of the torque, in the middle of the longer side of the bar; "
        f"{_NO_BARS}", source="bars.forces.torsion_stress", people=MPA, optional=True,
        summary=(SummaryValue("bar_torsion_stress_MPa", largest, "largest torsion stress of a bar",
                              ",.0f"),)),

    *PROBES,

    # power
    Quantity("loss_sliding", "", "", "W", "block", "power lost by sliding of the raceways on the rollers",
        source="losses.sliding",
        summary=(SummaryValue("power_loss_W.sliding", label="power lost by sliding", digits=",.2f"),)),
    Quantity("loss_rolling", "", "", "W", "block",
        "power lost by hydrodynamic rolling friction of the oil film, the shear in its inlets",
        source="losses.rolling",
        summary=(SummaryValue("power_loss_W.rolling", label="  rolling friction of the oil film",
                              digits=",.2f"),)),
    Quantity("loss_drag", "", "", "W", "block", "power lost by drag of the mixture on the orbiting rollers",
        source="losses.drag",
        summary=(SummaryValue("power_loss_W.drag", label="  drag of the mixture", digits=",.2f"),)),
    Quantity("loss_pocket", "", "", "W", "block", "power lost by friction of the rollers in the pockets",
        source="losses.pocket",
        summary=(SummaryValue("power_loss_W.pocket", label="  pocket friction", digits=",.2f"),)),
    Quantity("loss_land", "", "", "W", "block", "power lost at the guiding land of the cage",
        source="losses.land",
        summary=(SummaryValue("power_loss_W.land", label="  cage land", digits=",.2f"),)),
    Quantity("loss_churning", "", "", "W", "block", "power lost by churning around the spinning rollers",
        source="losses.churning",
        summary=(SummaryValue("power_loss_W.churning", label="  churning", digits=",.2f"),)),
    Quantity("loss_ribs", "", "", "W", "block",
        "power lost by friction of the rollers' ends on ribs that thrust presses; skew between guide flanges "
        "has its own, flange_power", source="losses.ribs",
        summary=(SummaryValue("power_loss_W.ribs", label="  ribs", digits=",.2f"),)),
    Quantity("loss_transport", "", "", "W", "block",
        "discretisation residual, no loss: what the differences of the roller spins from azimuth to azimuth "
        "leave; may be negative", source="losses.transport",
        summary=(
            SummaryValue("power_loss_W.transport", label="  discretisation residual", digits=",.2f",
                         compared=False),
            SummaryValue("power_loss_W.total", total, "  total", ",.2f",
                         of=tuple(f"loss_{cause}" for cause in LOSSES)),
        )),
    Quantity("driving_power", "", "", "W", "block",
        "power that the rings put in: the sum of all losses and of the discretisation residual",
        summary=(SummaryValue("driving_power_W", label="driving power", digits=",.2f"),)),

    # thrust on ribs
    Quantity("axial_load", "F_a", "", "N", "block", f"axial load on the inner ring, along x; {_THRUST}",
        source="state.axial_load", optional=True),
    Quantity("ring_shift", "x", "", "m", "block",
        "displacement of the inner ring along x by which ribs and rollers give way, without the play of the "
        f"rollers between the ribs; {_THRUST}", source="state.ring_shift", people=UM, optional=True,
        summary=(SummaryValue("ribs.ring_shift_um", label="axial displacement of the ring", digits=".2f",
                              section=RIBS),)),
    Quantity("axial_stiffness", "k_x", "", "N/m", "block",
        f"axial tangent stiffness of the ring on ribs and rollers; {_THRUST}", source="state.axial_stiffness",
        people=KN_PER_MM, optional=True,
        summary=(SummaryValue("ribs.axial_stiffness_N_per_m", label="axial stiffness", digits=",.1f",
                              in_si=True, section=RIBS),)),
    Quantity("rib_thrust", "P", "Z", "N", "block",
        "force of the rib of the inner ring on the roller, positive along x; the same acts on the rib "
        f"of the outer ring; {_THRUST}", source="state.rib_thrust", optional=True,
        summary=(
            SummaryValue("ribs.max_rib_load_N", largest_size, "largest rib load", ",.1f", section=RIBS),
            SummaryValue("ribs.rib_thrusts_N"),
        )),
    Quantity("rib_pressure", "p_f", "race Z", "Pa", "block",
        f"peak pressure of the roller's end on the rib of each ring; {_THRUST}", source="state.rib_pressure",
        people=MPA, optional=True,
        summary=(SummaryValue("ribs.rib_pressure_MPa", largest, "largest rib pressure", ",.0f", parts=RACES,
                              section=RIBS),)),
    Quantity("rib_sliding", "u_f", "race Z", "m/s", "block",
        f"speed of the rib of each ring over the roller's end, positive to +azimuth; {_THRUST}",
        source="state.rib_sliding", optional=True,
        summary=(SummaryValue("ribs.rib_sliding_m_per_s", largest_size, "fastest sliding on a rib", ".3g",
                              parts=RACES, section=RIBS),)),
    Quantity("rib_friction", "F_f", "race Z", "N", "block",
        f"friction of the rib of each ring on the roller's end, positive to +azimuth; {_THRUST}",
        source="state.rib_friction", optional=True),
    Quantity("rib_radii", "r_f", "race", "m", "block",
        f"distance of the rib contact of each ring from the axis of the bearing; {_THRUST}",
        source="state.rib_radii", people=MM, optional=True),

    # skew between guide flanges
    Quantity("roller_skew", "psi", "Z", "rad", "block",
        "turn of the roller about its radial axis, positive: +x end leads towards +azimuth; "
        f"{_FLANGED}", source="skew.angle", people=MRAD, optional=True,
        summary=(
            SummaryValue("skew.max_skew_mrad", largest_size, "largest skew", ".4f", section=SKEW),
            SummaryValue("skew.roller_skew_mrad"),
        )),
    Quantity("touching_skew", "psi_0", "", "rad", "block",
        f"skew at which a roller meets both flanges; {_FLANGED}", source="skew.balance.touching",
        people=MRAD, optional=True,
        summary=(SummaryValue("skew.touching_skew_mrad", label="skew that touches both flanges",
                              digits=".4f", section=SKEW),)),
    Quantity("skew_moment", "M_T", "Z", "N m", "block",
        f"moment of tractions and inlet shears towards positive skew; {_FLANGED}",
        source="skew.moments.traction", optional=True, summary=(SummaryValue("skew.skew_moments_Nm"),)),
    Quantity("roller_thrust", "F_x", "Z", "N", "block",
        f"axial traction of both raceways on the skewed roller, positive to +x; {_FLANGED}",
        source="skew.axial_traction.thrust", optional=True, summary=(SummaryValue("skew.roller_thrusts_N"),)),
    Quantity("flange_force", "N", "roller_end Z", "N", "block",
        f"force of the flange at the -x and at the +x end on the roller, >= 0; {_FLANGED}",
        source="skew.flange_forces", optional=True,
        summary=(
            SummaryValue("skew.rollers_on_both_flanges", touching_both, "rollers on both flanges", "d",
                         unit=COUNT, section=SKEW),
            SummaryValue("skew.max_flange_force_N", largest_of_ends, "largest flange force", ".4g",
                         section=SKEW),
            SummaryValue("skew.flange_forces_N"),
        )),
    Quantity("flange_power", "", "", "W", "block",
        f"heat of the friction at the flanges, comes on top of the driving power; {_FLANGED}",
        source="skew.flange_power.sum", optional=True,
        summary=(SummaryValue("skew.flange_power_W", label="friction at the flanges", digits=".4g",
                              section=SKEW),)),
    Quantity("skew_power", "", "", "W", "block",
        "heat of the axial sliding of skewed rollers on the raceways, comes on top of the driving power; "
        f"{_FLANGED}", source="skew.axial_sliding_power.sum", optional=True,
        summary=(SummaryValue("skew.sideways_power_W", label="axial sliding on the raceways", digits=".4g",
                              section=SKEW),)),
    Quantity("skew_gap", "", "", "m", "block",
        f"largest change of the gap at a roller's end by skew, neglected in the loads; {_FLANGED}",
        source="skew.end_gap", people=UM, optional=True,
        summary=(SummaryValue("skew.end_gap_um", label="left out: gap at the roller ends", digits=".4f",
                              section=SKEW),)),
    Quantity("skew_load_shift", "", "", "m", "block",
        "largest shift between outer and inner load of a roller that axial tractions and flange forces "
        f"cause, which is neglected in the tilt; {_FLANGED}", source="skew.load_shift", people=MM,
        optional=True,
        summary=(SummaryValue("skew.load_shift_mm", label="left out: shift of the loads", digits=".4f",
                              section=SKEW),)),
    Quantity("skew_traction_change", "", "", "1", "block",
        "largest change of a traction by skew at the same sliding / largest traction, neglected in the "
        f"speeds; {_FLANGED}", source="skew.traction_change", people=PERCENT, optional=True,
        summary=(SummaryValue("skew.traction_change_percent", label="left out: change of tractions",
                              digits=".3g", section=SKEW),)),

    # iterations of the coupling
    *ITERATIONS,
    Quantity("unknowns", "", "N", "m, rad, rad/s", "block",
        "where a similar case may start: ring displacement (y, z) and slopes, cage speed less that "
        "of pure rolling; then, Z each, approach and tilt approach of the rollers at the outer raceway, "
        "inner film, outer film, spin less that of pure rolling; then Legendre coefficients of the "
        "outward deviations of the inner and the outer raceway, roller by roller", source="rows.unknowns"),
)
# fmt: on

_ATTRIBUTES = (
    METHOD,
    ATTEMPTS,
    Attribute(
        "started_from",
        "text",
        "result of a similar case whose flexible end state the coupling started from, or rigid raceways "
        "where that failed; absent where no start was given, or nothing was solved",
        optional=True,
    ),
    Attribute(
        "tilt",
        "json",
        "how the shaft holds the inner ring, as operation.tilt: fixed or free; where a ring is flexible "
        "also, otherwise, what the other one would give, estimated by Newton steps from the end state",
        form=records.TILT,
    ),
    Attribute(
        "clearance",
        "json",
        "operating clearance, with the steps that led to it when it was computed",
        form=records.CLEARANCE,
    ),
    LIFE_ATTRIBUTE,
    RULE_ATTRIBUTE,
    CATALOGUE_ATTRIBUTE,
    Attribute(
        "regimes", "json", "lubrication regime of inner and outer raceway; by block", form=records.REGIMES
    ),
    Attribute(
        "equilibria",
        "json",
        "where a block is one of several equilibria: its figures, those of the other stable ones that were "
        "found, and of the one that rollers reach which move on by whole pitches; by block, absent where no "
        "others were found",
        optional=True,
        form=records.EQUILIBRIA,
    ),
    STRUCTURE,
    STRESSES,
    Attribute(
        "passage",
        "json",
        "the numbers of the summary at every position of the rollers within a pitch, by the azimuth of the "
        "first roller, and the life by equal damage of all; absent without operation.roller_positions",
        optional=True,
        form=records.PASSAGE,
    ),
    CHOICES,
    ERROR_ESTIMATE,
    Attribute(
        "slice_error",
        "json",
        "estimated numerical errors of the flexible block by the slices alone: 1.6 times the largest change "
        "with the greater numbers of slices, over the values but for the cage slip; meshes and axial shapes "
        "stay; absent with a target, where no file is written, and where it was not estimated",
        optional=True,
        form=records.SLICE_ERROR,
    ),
)

LAYOUT = Layout(
    conventions="""\
Directions: x axial, z at azimuth 0, y at 90 degrees; the radial load acts along z where
operation.load_direction is 0, its default. Azimuths grow from z towards y, the way a positive speed turns:
left-handed about +x. Rotations about y and z are right-handed.
""",
    axes=(
        Axis("Z", "roller", coordinate="roller_azimuth"),
        Axis("K", "slice", coordinate="slice_position"),
        Axis("B", "bar", coordinate="bar_azimuth"),
        PROBE_AXIS,
        Axis("X", "place_across"),
        Axis("Y", "place_along", coordinate="whole_roller_position"),
        Axis("N", "unknown"),
        *SUBSURFACE_AXES,
    ),
    quantities=QUANTITIES,
    main=("max_roller_load", "life_L10", "total_stiffness", "cage_slip", "driving_torque"),
    weighed=(
        ("max_roller_load", "largest load"),
        ("total_stiffness", "stiffness"),
        ("stiffness", "bearing stiffness"),
        ("cage_slip", "cage slip"),
        ("driving_torque", "torque"),
        ("nominal_bar_stress", "bar stress"),
    ),
    weighed_in_results=(("total_stiffness_yy", "stiffness along y"),),
    blocks=("rigid", "flexible"),
    further_attributes=_ATTRIBUTES,
    head=(
        *HEAD,
        "method",
        "tilt",
        "clearance",
        "life",
        "life_rule",
        "catalogue_life",
        "regimes",
        "equilibria",
        "structure",
        "stresses",
        "passage",
        "choices",
        "error_estimate",
        "slice_error",
    ),
)
