"""Output quantities of a tapered roller bearing; the page of a result shows rows in this order."""

import numpy as np
from numpy.typing import NDArray

from flexbearing.quantities.attributes import HEAD
from flexbearing.quantities.ball_clearance import CLEARANCE_ATTRIBUTE
from flexbearing.quantities.contact_stress import (
    OF_SLICES,
    SUBSURFACE_AXES,
    friction_intensity,
    static_safety,
    subsurface,
    worst_contact,
)
from flexbearing.quantities.layout import Axis, Layout
from flexbearing.quantities.life_records import CATALOGUE_ATTRIBUTE, LIFE_ATTRIBUTE, RULE_ATTRIBUTE
from flexbearing.quantities.quantity import Quantity, SummaryValue, Unit
from flexbearing.quantities.reductions import (
    ABOUT_YZ,
    RACES,
    ROWS,
    XYZ,
    azimuth_of_largest,
    displacements,
    largest,
    largest_of_all,
    largest_size,
    loaded_arc_in_degrees,
    loaded_rollers,
    place_of_largest,
    smallest_above_zero,
    tilts,
    total,
)
from flexbearing.quantities.stiffness import RADIAL_STIFFNESSES
from flexbearing.quantities.units import COUNT, DEG, MM, MPA, MRAD, MREV, PERCENT, RPM, UM

RING, CONTACT = "ring", "contact"  # sections of the page
_ORDER = "x, y, z, about y, about z; these about the point of the axis in the plane of the roller centres"
_ONE_ROW = "absent of one row"
_UNRATED = "absent at rest, without load, and where ISO 281 has no rating and the case gives none"
_PRESSURES = ("inner_pressure", "outer_pressure")
_NO_FRICTION = "absent without outputs.friction"
_NO_RIB = "absent without bearing.rib"
LOSSES = (  # causes, words, sources
    ("sliding", "sliding of the raceways on the rollers", "friction.sliding_heat.sum"),
    ("rolling", "rolling friction of the oil film", "friction.rolling_heat.sum"),
    ("rib", "friction of the rib", "friction.rib_heat.sum"),
    ("drag", "drag of the mixture on the orbiting rollers", "friction.drag_heat.sum"),
    ("pocket", "friction of the rollers in the pockets", "friction.pocket_heat.sum"),
    ("land", "the guiding land of the cage", "friction.land_heat.sum"),
    ("churning", "churning around the spinning rollers", "friction.churning_heat.sum"),
)
_SLICES = "from the small end of the rollers to the large one"


def _least_films(*films: NDArray) -> NDArray:
    """Least film of each contact (..., 2) of all loaded slices (..., Z, K)."""
    return smallest_above_zero(*(film.reshape(*film.shape[:-2], -1) for film in films))


# declarations read best as a table:
# fmt: off
QUANTITIES = (
    # loads
    Quantity("inner_load", "Q_i", "Z", "N", "block", "load of the inner contact, >= 0",
        source="loads.loads.0", summary=(
            SummaryValue("max_roller_load_N", largest, "largest roller load, inner", ",.1f"),
            SummaryValue("roller_loads_N"),
        )),
    Quantity("outer_load", "Q_o", "Z", "N", "block", "load of the outer contact, >= 0",
        source="loads.loads.1", summary=(
            SummaryValue("max_outer_load_N", largest, "largest roller load, outer", ",.1f"),
            SummaryValue("outer_loads_N"),
        )),
    Quantity("inner_slice_load", "q_i", "Z K", "N/m", "block",
        f"load per length of the inner contact, >= 0, {_SLICES}", source="loads.slice_loads.0"),
    Quantity("outer_slice_load", "q_o", "Z K", "N/m", "block",
        f"load per length of the outer contact, >= 0, {_SLICES}", source="loads.slice_loads.1"),
    Quantity("roller_azimuth", "phi", "Z", "rad", "block",
        "place of the roller, 0 on the z axis, positive towards y", source="loads.bearing.azimuths",
        people=DEG, summary=(
            SummaryValue("loaded_rollers", loaded_rollers, "loaded rollers", "d", of=("inner_load",),
                         unit=COUNT),
            SummaryValue("loaded_arc_deg", loaded_arc_in_degrees, "loaded arc", ".0f",
                         of=("roller_azimuth", "inner_load"), unit=Unit("deg")),
            SummaryValue("roller_azimuths_deg"),
        )),
    Quantity("roller_row", "", "Z", "1", "block", f"number of the row of the roller, from 0; {_ONE_ROW}",
        source="loads.roller_row", optional=True),
    Quantity("row_load", "", "row row_force", "N", "block",
        f"what each row carries for the inner ring (x, y, z); {_ONE_ROW}", source="solution.row_load",
        optional=True, summary=(
            SummaryValue("row_axial_force_N", lambda forces: forces[:, 0], "axial force", ",.1f",
                entries=ROWS, section=RING),
            SummaryValue("row_radial_force_N", lambda forces: np.hypot(forces[:, 1], forces[:, 2]),
                "radial force", ",.1f", entries=ROWS, section=RING),
        )),
    Quantity("unloading_force", "", "", "N", "block",
        "axial load that takes the load off a row which another presses, at rest and by it alone; zero with "
        "play between them; absent without rows against each other", source="rated.unloading_force",
        optional=True,
        summary=(SummaryValue("unloading_force_N", label="axial load that unloads a row", digits=",.1f"),)),
    Quantity("slice_position", "s", "K", "m", "block",
        "place of the slice's middle along the contact, 0 in its middle, positive to the large or outer end",
        source="loads.slices.centres", people=MM),

    Quantity("inner_deflection", "w_i", "Z K", "m", "block",
        f"displacement of an elastic inner raceway along its normal, away from the rollers, {_SLICES}; "
        "absent of a rigid ring", source="loads.deflection.0", people=UM, optional=True),
    Quantity("outer_deflection", "w_o", "Z K", "m", "block",
        f"displacement of an elastic outer raceway along its normal, away from the rollers, {_SLICES}; "
        "absent of a rigid ring", source="loads.deflection.1", people=UM, optional=True, summary=(
            SummaryValue("max_outer_deflection_um", lambda way: way.max((-2, -1)),
                "largest displacement of the outer raceway", ".2f"),)),

    # rib
    Quantity("rib_load", "Q_f", "Z", "N", "block",
        f"load of the roller's large end on the rib, >= 0; {_NO_RIB}", source="rib.loads.rib_loads",
        optional=True, summary=(
            SummaryValue("max_rib_load_N", largest, "largest rib load", ",.1f"),
            SummaryValue("rib_loads_N"),
        )),
    Quantity("rib_pressure", "p_f", "Z", "Pa", "block",
        f"peak pressure of the spherical end on the flat rib, 0 without load; {_NO_RIB}",
        source="rib.loads.rib_pressures", optional=True, people=MPA, summary=(
            SummaryValue("max_rib_pressure_MPa", largest, "largest rib pressure", ",.0f"),)),
    Quantity("rib_sliding", "v_f", "", "m/s", "block",
        "speed of the rib over the roller's end in their contact, positive to +azimuth, rollers in pure "
        f"rolling; {_NO_RIB}", source="rib.loads.speeds.rib_sliding", optional=True, summary=(
            SummaryValue("rib_sliding_m_per_s", label="sliding on the rib", digits=".3f"),)),
    Quantity("rib_radius", "r_f", "", "m", "block",
        f"distance of the rib contacts from the bearing axis; {_NO_RIB}",
        source="rib.loads.bearing.rib_radius", optional=True, people=MM),
    Quantity("rib_contact_depth", "b", "", "m", "block",
        f"distance of the rib contact from the roller's axis, positive towards the bearing axis; {_NO_RIB}",
        source="rib.loads.bearing.rib.depth", optional=True, people=MM, summary=(
            SummaryValue("rib_contact_depth_mm", label="rib contact below roller's axis", digits=".3f"),)),
    Quantity("rib_heat", "", "Z", "W", "block",
        f"heat of the Coulomb friction of the end on the rib; {_NO_RIB}", source="rib.rib_heat",
        optional=True, summary=(
            SummaryValue("rib_heat_W", lambda heat: heat.sum(-1), "heat of the ribs", ",.3g"),)),

    # film and friction
    Quantity("inner_film", "h_i", "Z K", "m", "block",
        f"film of the inner contact by the load of each slice, 0 without load, {_SLICES}; {_NO_FRICTION}",
        source="friction.loaded_film.0", people=UM, optional=True),
    Quantity("outer_film", "h_o", "Z K", "m", "block",
        f"film of the outer contact by the load of each slice, 0 without load, {_SLICES}; {_NO_FRICTION}",
        source="friction.loaded_film.1", people=UM, optional=True, summary=(
            SummaryValue("minimum_film_um", _least_films, "smallest film", ".3f", parts=RACES,
                of=("inner_film", "outer_film")),)),
    Quantity("film_ratio", "Lambda", "race Z", "1", "block",
        "least film of each roller over the composite roughness (inner, outer), 0 without load; "
        f"{_NO_FRICTION}, or bearing.roughness", source="solution.film_ratio", optional=True, summary=(
            SummaryValue("minimum_lambda", lambda ratios: smallest_above_zero(*np.moveaxis(ratios, -2, 0)),
                 "smallest film ratio", ".2f", parts=RACES),)),
    Quantity("cage_slip", "s", "", "1", "block",
        "1 - cage speed / cage_speed, positive: the cage lags behind; of two rows the larger one; "
        f"{_NO_FRICTION}, and where cage_speed is zero", source="friction.cage_slip", people=PERCENT,
        optional=True, summary=(SummaryValue("cage_slip_percent", label="cage slip", digits=".3f"),)),
    Quantity("cage_force", "F_c", "Z", "N", "block",
        f"force of the cage on the roller, positive to +azimuth; {_NO_FRICTION}",
        source="friction.state.pocket_force", optional=True, summary=(
            SummaryValue("max_pocket_force_N", largest_size, "largest pocket force", ",.2f"),)),
    Quantity("roller_slip", "", "Z", "1", "block",
        "1 - spin of the roller / spin in pure rolling, positive: it lags behind, 1: it does not spin; "
        f"{_NO_FRICTION}", source="friction.roller_slip", people=PERCENT, optional=True),
    Quantity("inner_traction", "T_i", "Z", "N", "block",
        f"traction of the inner raceway on the roller, positive to +azimuth; {_NO_FRICTION}",
        source="friction.traction.0", optional=True),
    Quantity("outer_traction", "T_o", "Z", "N", "block",
        f"traction of the outer raceway on the roller, positive to +azimuth; {_NO_FRICTION}",
        source="friction.traction.1", optional=True),
    friction_intensity("friction.friction_intensity", OF_SLICES, _NO_FRICTION),
    *(
        Quantity(f"loss_{cause}", "", "", "W", "block", f"power lost by {words}; {_NO_FRICTION}",
            source=source, optional=True,
            summary=(SummaryValue(f"power_loss_W.{cause}", label=f"power lost by {words}", digits=",.2f"),))
        for cause, words, source in LOSSES
    ),
    Quantity("loss_transport", "", "", "W", "block",
        "discretisation residual, no loss: what the differences of the roller spins from azimuth to azimuth "
        f"leave; may be negative; {_NO_FRICTION}", source="friction.transport.sum", optional=True, summary=(
            SummaryValue("power_loss_W.transport", label="discretisation residual", digits=",.2f",
                         compared=False),)),
    Quantity("driving_power", "", "", "W", "block",
        f"power that the rings put in: the sum of all losses and of that residual; {_NO_FRICTION}",
        source="friction.power", optional=True, summary=(
            SummaryValue("power_loss_W.total", total, "power lost, all of it", ",.2f",
                of=(*(f"loss_{cause}" for cause, *_ in LOSSES), "loss_transport")),
            SummaryValue("driving_power_W", label="driving power", digits=",.2f"))),
    Quantity("ring_torque", "M_i, M_o", "race", "N m", "block",
        "torque that keeps each ring (inner, outer) turning or holds it, positive along the motion of the "
        f"cage; {_NO_FRICTION}", source="friction.torque", optional=True, summary=(
            SummaryValue("ring_torque_Nm", label="friction torque", digits=".4f", parts=RACES),)),

    # life
    Quantity("life_L10", "L_10r", "", "rev", "block",
        "reference rating life of both raceways together by ISO/TS 16281 from the loads of all slices, ribs "
        f"left out, 90 % survival; {_UNRATED}", source="life.basic", people=MREV, optional=True,
        summary=(SummaryValue("life_L10_Mrev", label="reference life L10r, ISO/TS 16281", digits=",.4g",
                              speed="relative_speed"),)),
    Quantity("raceway_life", "L_10,i, L_10,o", "race", "rev", "block",
        f"the same of each raceway alone (inner, outer); {_UNRATED}", source="life.raceways",
        people=MREV, optional=True, infinite=True,
        summary=(SummaryValue("raceway_life_Mrev", label="life L10", digits=",.4g", parts=RACES,
                              speed="relative_speed"),)),
    Quantity("modified_life", "L_nmr", "", "rev", "block",
        "life L10r after every factor of [life], see the attribute life; absent when nothing modifies it",
        source="life.modified", people=MREV, optional=True,
        summary=(SummaryValue("modified_life_Mrev", label="modified life", digits=",.4g",
                              speed="relative_speed"),)),
    Quantity("relative_speed", "", "", "rad/s", "block",
        "speed of the inner ring less that of the outer ring, by which revolutions become hours",
        source="loads.operation.relative_speed", people=RPM),
    Quantity("dynamic_rating", "C", "", "N", "block",
        "basic dynamic load rating, of thrust bearings axial: life.dynamic_rating, or that of ISO 281; "
        "absent where neither is", source="rated.dynamic", optional=True, summary=(
            SummaryValue("dynamic_rating_N", label="dynamic rating C", digits=",.0f"),)),
    Quantity("equivalent_load", "P", "", "N", "block",
        "dynamic equivalent load of ISO 281, X F_r + Y F_a of what the rollers carry",
        source="rated.equivalent", summary=(
            SummaryValue("equivalent_load_N", label="equivalent load P", digits=",.1f"),)),
    Quantity("axial_load_limit", "e", "", "1", "block",
        "F_a/F_r up to which an axial load does not count, 1.5 tan(alpha)", source="rated.limit", summary=(
            SummaryValue("axial_load_limit", label="e", digits=".4f"),)),
    Quantity("axial_load_factor", "Y", "", "1", "block",
        "factor of axial loads above e, 0.4 cot(alpha), 0.67 cot(alpha) of rows against each other",
        source="rated.factor", summary=(SummaryValue("axial_load_factor", label="Y", digits=".4f"),)),
    Quantity("induced_thrust", "", "", "N", "block",
        "axial force that the radial load makes in a bearing without play, F_r/(2 Y), which the other "
        "bearing of a shaft must carry", source="rated.induced", optional=True,
        summary=(
            SummaryValue("induced_thrust_N", label="induced thrust F_r/(2 Y)", digits=",.1f"),)),
    *static_safety("rated", "the load on the ring", optional=True),

    # contacts
    Quantity("peak_pressure", "p", "race", "Pa", "block",
        "largest contact pressure of a slice (inner, outer)", source="worst.pressure", people=MPA, summary=(
            SummaryValue("peak_pressure_MPa", label="peak pressure", digits=",.0f", parts=RACES),
            SummaryValue("peak_pressure_azimuth_deg", azimuth_of_largest, "azimuth of peak pressure", ".1f",
                         of=(*_PRESSURES, "roller_azimuth"), unit=DEG, compared=False, parts=RACES,
                         section=CONTACT),
            SummaryValue("peak_pressure_position_mm", place_of_largest, "place of peak along contact", ".3f",
                         of=(*_PRESSURES, "slice_position"), unit=MM, compared=False, parts=RACES,
                         section=CONTACT),
        )),
    Quantity("inner_pressure", "p_i", "Z K", "Pa", "block",
        f"peak pressure of each slice of the inner contact by Hertz, {_SLICES}",
        source="loads.pressures.0", people=MPA),
    Quantity("outer_pressure", "p_o", "Z K", "Pa", "block",
        f"peak pressure of each slice of the outer contact by Hertz, {_SLICES}",
        source="loads.pressures.1", people=MPA),
    *worst_contact("worst", CONTACT),
    *subsurface(CONTACT),

    # motion
    Quantity("cage_speed", "omega_c", "", "rad/s", "block",
        "speed of the rollers about the bearing axis in pure rolling, positive to +azimuth; see cage_slip",
        source="loads.speeds.orbit", people=RPM,
        summary=(SummaryValue("cage_speed_rpm", label="cage speed in pure rolling", digits=",.0f"),)),
    Quantity("roller_speed", "omega_r", "", "rad/s", "block",
        "spin of a roller against the cage in pure rolling, positive when it rolls forwards on the inner "
        "ring", source="loads.speeds.spin", people=RPM),
    Quantity("centrifugal_force", "F_c", "", "N", "block", "centrifugal force of a roller, outwards",
        source="loads.speeds.centrifugal_force", summary=(
            SummaryValue("centrifugal_force_N", label="centrifugal force of a roller", digits=",.2f"),)),
    Quantity("gyroscopic_moment", "M_g", "", "N m", "block",
        "moment on a roller by the turn of its axis with the orbit, positive: lifts its large end",
        source="loads.speeds.gyroscopic_moment", summary=(
            SummaryValue("gyroscopic_moment_Nm", label="gyroscopic moment of a roller", digits=".4g"),)),

    # ring
    Quantity("cone_angle", "alpha_i", "", "rad", "block", "angle of the inner raceway from the axis",
        source="loads.bearing.cone_angle", people=DEG,
        summary=(SummaryValue("cone_angle_deg", label="angle of the inner raceway", digits=".4f"),)),
    Quantity("ring_load", "F", "force", "N, N m", "block",
        f"what the rollers carry for the inner ring ({_ORDER}): load or reaction", source="loads.load",
        summary=(
            SummaryValue("ring_load_N", displacements, "load or reaction", ",.1f", unit=Unit("N"),
                entries=XYZ, section=RING),
            SummaryValue("ring_moment_Nm", tilts, "moment or reaction", ",.3f", unit=Unit("N m"),
                section=RING, entries=ABOUT_YZ),
        )),
    Quantity("ring_displacement", "delta", "displacement", "m, rad", "block",
        f"displacement of the inner ring ({_ORDER}), 0 where rollers and raceways just touch",
        source="loads.displacement", summary=(
            SummaryValue("ring_displacement_um", displacements, "displacement", ".3f", unit=UM,
                entries=XYZ, section=RING),
            SummaryValue("ring_tilt_mrad", tilts, "tilt", ".4f", unit=MRAD, section=RING,
                entries=ABOUT_YZ),
        )),
    Quantity("roller_tilt", "", "Z", "rad", "block",
        "turn of the roller in the plane of the axis, positive: large end further out",
        source="loads.roller_tilt", people=MRAD),
    Quantity("stiffness_matrix", "K", "force displacement", "N/m, N/rad, N m/m, N m/rad", "block",
        f"tangent stiffness of the inner ring, rollers in balance ({_ORDER}); an entry holds all other "
        "displacements and tilts", source="loads.stiffness", summary=(
            SummaryValue("stiffness_xx_N_per_m", lambda matrix: matrix[..., 0, 0], unit=Unit("N/m")),
            *RADIAL_STIFFNESSES, SummaryValue("stiffness_matrix_SI"))),
    Quantity("imbalance", "", "", "1", "block",
        "unbalanced force on the inner ring over the largest force", source="loads.solution.imbalance",
        summary=(SummaryValue("max_imbalance", largest_of_all),)),
)
# fmt: on

LAYOUT = Layout(
    conventions="""\
Directions: x axial, into the cup: an axial load > 0 presses the inner ring into it; z along the load,
azimuth from z towards y, left-handed about +x; rotations about y and z are right-handed.
""",
    axes=(
        Axis("Z", "roller", coordinate="roller_azimuth"),
        Axis("K", "slice", coordinate="slice_position"),
        *SUBSURFACE_AXES,
    ),
    quantities=QUANTITIES,
    main=("max_roller_load", "life_L10", "peak_pressure.inner", "max_rib_load", "rib_heat"),
    weighed=(
        ("max_roller_load", "largest load"),
        ("peak_pressure.inner", "peak pressure"),
        ("stiffness_zz", "stiffness"),
    ),
    blocks=("rigid",),
    further_blocks=("flexible",),
    further_attributes=(CLEARANCE_ATTRIBUTE, LIFE_ATTRIBUTE, RULE_ATTRIBUTE, CATALOGUE_ATTRIBUTE),
    head=("kind", *HEAD, "life", "life_rule", "catalogue_life"),
)
