"""Output quantities of fast ball bearings, angular contact or deep groove.

The page of a result shows its rows in the order of declaration, those of two races in a table of their own.
"""

from dataclasses import replace

import numpy as np

from flexbearing.quantities.attributes import HEAD
from flexbearing.quantities.ball_clearance import CLEARANCE_ATTRIBUTE
from flexbearing.quantities.contact_stress import (
    SUBSURFACE_AXES,
    friction_intensity,
    static_safety,
    subsurface,
    worst_contact,
)
from flexbearing.quantities.coupling import (
    ATTEMPTS,
    BALL_LOAD,
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
    ABOUT_YZ,
    EXTENT,
    RACES,
    ROWS,
    XYZ,
    displacements,
    finite_range,
    largest_size,
    tilts,
)
from flexbearing.quantities.stiffness import RADIAL_STIFFNESSES
from flexbearing.quantities.units import COUNT, DEG, MM, MPA, MRAD, MREV, PERCENT, RPM, UM, W_PER_MM2

STIFFNESSES = ("stiffness_xx", "stiffness_yy", "stiffness_zz")  # whose errors are estimated
DRY_TORQUE = "friction torque (dry, no cage, unless in the case)"
RING = "ring"  # section of the page
_APART = "NaN for a ball without lines, as one that does not touch both races"
_FRICTION = "absent where a contact is as wide as the surface it presses"
_SLIDING = "absent in full sliding"
_IN_OIL = "absent but with control oil"
_CAGED = "absent without bearing.cage"
LOSSES = {
    "sliding": "sliding in the contacts",
    "rolling": "hydrodynamic rolling friction of the oil film",
    "drag": "drag of the mixture on the orbiting balls",
    "churning": "churning around the spinning balls",
}
CAGE_LOSSES = {
    "pocket": "friction and films of the balls in the pockets",
    "land": "the guiding land of the cage",
}
_UNRATED = "absent at rest, and where ISO 281 has no rating and the case gives none"
_CELLS = "of the ball that carries most on both races; absent in full sliding"
_ORDER = "x, y, z, about y, about z; about the point of the axis in the plane of the inner groove centres"


def _range_of_races(values: np.ndarray) -> np.ndarray:
    return np.array([finite_range(race) for race in values])


def _largest_of_races(values: np.ndarray) -> np.ndarray:
    return values.max(1)


def _estimated(stiffness: SummaryValue) -> SummaryValue:
    """A stiffness with its error, where one is estimated."""
    name = stiffness.key.removesuffix("_N_per_m")
    return replace(stiffness, error=name if name in STIFFNESSES else "")


_ONE_ROW = "absent of one row"
_OF_RINGS = "by elastic rings alone, the indentation of the contacts left out; absent between rigid rings"
# declarations read best as a table:

# fmt: off
QUANTITIES = (
    # contacts
    Quantity("contact_load", "Q", "race Z", "N", "state", "normal load, >= 0", source="state.loads", summary=(
        SummaryValue("balls", lambda load: load.shape[1], "balls", "d", unit=COUNT),
        SummaryValue("balls_on_both_races", lambda load: int((load > 0).all(0).sum()),
            "balls on both races", "d", unit=COUNT),
        SummaryValue("contact_load_range_N", _range_of_races, "contact load", ",.1f", parts=RACES,
            entries=EXTENT, error=BALL_LOAD, error_of=EXTENT[1:]),
        SummaryValue("contact_loads_N", parts=RACES),
    )),
    Quantity("ball_azimuth", "phi", "Z", "rad", "block",
        "place of the ball, 0 on the z axis, positive towards y", source="state.bearing.azimuths", people=DEG,
        summary=(SummaryValue("ball_azimuths_deg"),)),
    Quantity("ball_row", "", "Z", "1", "block", f"number of the row of the ball, from 0; {_ONE_ROW}",
        source="state.ball_row", optional=True),
    Quantity("contact_angle", "alpha", "race Z", "rad", "state",
        "contact angle from the radial plane, positive towards the shoulder that the load presses in its row",
        source="state.contact_angles", people=DEG, summary=(
            SummaryValue("contact_angle_range_deg", _range_of_races, "contact angle", ".2f", parts=RACES,
                entries=EXTENT),
            SummaryValue("contact_angles_deg", parts=RACES),
        )),
    Quantity("peak_pressure", "p", "race Z", "Pa", "block", "largest pressure, 0 without load",
        source="state.peak_pressures", people=MPA, summary=(
            SummaryValue("peak_pressure_MPa", _largest_of_races, "peak pressure", ",.0f", parts=RACES),
        )),
    Quantity("semi_axis_across", "a", "race Z", "m", "block",
        "semi-axis across the rolling direction, 0 without load", source="state.semi_axes.0", people=MM,
        summary=(SummaryValue("semi_axis_across_mm", _largest_of_races, "largest semi-axis across rolling",
            ".4f", parts=RACES),)),
    Quantity("semi_axis_along", "b", "race Z", "m", "block",
        "semi-axis along the rolling direction, 0 without load", source="state.semi_axes.1", people=MM,
        summary=(SummaryValue("semi_axis_along_mm", _largest_of_races, "largest semi-axis along rolling",
            ".4f", parts=RACES),)),
    *worst_contact("worst"),
    *subsurface(),
    *static_safety("rated", "the load on the ring, preload with it", optional=True),
    Quantity("traction", "T", "race Z", "N", "block",
        "friction along the groove section, which holds the gyroscopic moment", source="state.tractions"),
    Quantity("shoulder_force", "S", "race Z", "N", "block",
        "force along the groove section of contacts that a shoulder cuts off, positive as traction",
        source="state.shoulder_forces", optional=True),
    Quantity("needed_friction", "", "race Z", "1", "block", "that traction over the load, 0 without load",
        summary=(SummaryValue("needed_friction", _largest_of_races,
            "friction for the gyroscopic moment", ".4f", parts=RACES),)),

    # motion
    Quantity("orbital_speed", "omega_m", "Z", "rad/s", "block",
        "speed of the ball centre about the shaft, positive to +azimuth", people=RPM,
        summary=(SummaryValue("orbital_speed_range_rpm", finite_range, "orbital speed", ",.0f",
            entries=EXTENT),)),
    Quantity("ball_speed", "omega_R", "Z", "rad/s", "block",
        "speed of the ball about its axis, in the orbiting frame", people=RPM,
        summary=(SummaryValue("ball_speed_range_rpm", finite_range, "ball speed", ",.0f", entries=EXTENT),)),
    Quantity("ball_attitude", "beta", "Z", "rad", "block",
        "angle of the ball's axis to the shaft, signed like contact angles", source="state.attitude",
        people=DEG,
        summary=(SummaryValue("ball_attitude_range_deg", finite_range, "angle of the ball's axis", ".2f",
            entries=EXTENT),)),
    Quantity("ball_yaw", "psi", "Z", "rad", "block",
        "angle of the ball's axis out of the plane of the section, positive: -x end leads towards "
        "+azimuth; absent but with control coulomb, zero by assumption", source="free.yaw", people=DEG,
        optional=True,
        summary=(SummaryValue("ball_yaw_range_deg", finite_range, "yaw of the ball's axis", ".3f",
            entries=EXTENT),)),
    Quantity("centrifugal_force", "F_c", "Z", "N", "block", "force of the orbit, outwards",
        summary=(SummaryValue("centrifugal_force_range_N", finite_range, "centrifugal force", ".3f",
            entries=EXTENT),)),
    Quantity("gyroscopic_moment", "M_g", "Z", "N m", "block",
        "moment that turns the ball's axis with the orbit", people=Unit("mN m", 1e3),
        summary=(SummaryValue("gyroscopic_moment_range_Nm", finite_range, "gyroscopic moment", ".4f",
            in_si=True, entries=EXTENT),)),
    Quantity("friction_torque", "", "", "N m", "block", "torque between the rings, all heat over their "
        "speed: by Coulomb friction in dry contacts, cage and oil not counted, by friction.model; with "
        f"control oil by its tractions, rolling friction, drag, churning and the cage; {_FRICTION}",
        source="friction.friction_torque", optional=True,
        summary=(SummaryValue("friction_torque_Nm", label=DRY_TORQUE, digits=".4g"),)),
    Quantity("friction_heat", "Phi", "Z", "W", "block",
        f"heat of friction of both contacts, with control oil by all its causes; {_FRICTION}",
        source="friction.friction_heat", optional=True,
        summary=(SummaryValue("friction_heat_range_W", finite_range, "heat of friction of a ball", ".4g",
            entries=EXTENT),)),
    Quantity("grid_error", "", "Z", "N m", "block",
        "error of the friction torque by the cells, part of the ball, from its changes with half and a "
        f"quarter of them; {_SLIDING}", source="rolling.grid_error", optional=True, summary=(
            SummaryValue("torque_grid_error_Nm", lambda error: error.sum(),
                "error of the friction torque by the cells", ".2g"),)),
    Quantity("stick_share", "", "race Z", "1", "block",
        f"part of the cells in contact that stick; {_SLIDING}", source="rolling.stick_share", optional=True,
        summary=(SummaryValue("largest_stick_share", _largest_of_races,
            "largest part of a contact that sticks", ".3f", parts=RACES),)),
    Quantity("unbalanced_moment", "", "Z", "1", "block",
        "moment on the ball by which stick changes the friction of the balance, over that of the largest "
        f"friction forces about the ball centre; {_SLIDING}", source="rolling.unbalanced_moment",
        optional=True, summary=(SummaryValue("largest_unbalanced_moment", lambda moment: moment.max(),
            "moment on a ball that stick leaves unbalanced", ".2g"),)),
    Quantity("unbalanced_force", "", "Z", "1", "block",
        "force on the ball along the orbit, towards growing azimuth, by which stick changes the friction of "
        f"the balance, over the largest friction forces; {_SLIDING}", source="rolling.unbalanced_force",
        optional=True, summary=(SummaryValue("largest_unbalanced_force", lambda force: abs(force).max(),
            "force along the orbit that stick leaves unbalanced", ".2g"),)),
    Quantity("unbalanced_section_force", "", "Z", "1", "block",
        "force on the ball in its section plane by which stick changes the friction of the balance, over the "
        f"largest friction forces; {_SLIDING}", source="rolling.unbalanced_section_force",
        optional=True, summary=(SummaryValue("largest_unbalanced_section_force", lambda force: force.max(),
            "force in the section plane that stick leaves unbalanced", ".2g"),)),

    # oil
    Quantity("ring_torque", "T_i, T_o", "race", "N m", "block",
        f"torque that turns each ring (inner, outer) against its balls, positive to +azimuth; {_IN_OIL}",
        source="oil.ring_torques", optional=True,
        summary=(SummaryValue("ring_torque_Nm", label="torque of the ring", digits=".4g", parts=RACES),)),
    *(
        Quantity(f"loss_{cause}", "", "", "W", "block", f"power lost by {words}; {_IN_OIL}",
            source=f"oil.losses.{cause}", optional=True,
            summary=(SummaryValue(f"power_loss_W.{cause}", label=f"power lost by {words}", digits=",.3g"),))
        for cause, words in LOSSES.items()
    ),
    # cage
    Quantity("cage_speed", "omega_c", "", "rad/s", "block",
        f"speed of the cage, positive to +azimuth; {_CAGED}", source="oil.cage.speed", people=RPM,
        optional=True,
        summary=(SummaryValue("cage_speed_rpm", label="cage speed", digits=",.0f"),)),
    Quantity("cage_slip", "s_c", "", "1", "block",
        "1 - cage speed / mean orbital speed of guided balls if they did not slip, both against the outer "
        f"ring; absent where there are none, and {_CAGED}",
        source="oil.cage.slip", people=PERCENT, optional=True,
        summary=(SummaryValue("cage_slip_percent", label="cage slip", digits=".2f"),)),
    Quantity("cage_force", "F_p", "Z", "N", "block",
        f"force of the cage on the ball, positive to +azimuth; {_CAGED}", source="oil.cage.force",
        optional=True,
        summary=(SummaryValue("max_pocket_force_N", largest_size, "largest pocket force", ",.2f"),)),
    Quantity("pocket_torque", "", "Z", "N m", "block",
        f"torque of that force and of the friction in the pocket on the ball about the shaft; {_CAGED}",
        source="oil.cage.torque", optional=True),
    Quantity("pocket_displacement", "z", "Z", "m", "block",
        f"ball from the centre of its pocket, positive to +azimuth; {_CAGED}",
        source="oil.cage.displacement", people=UM, optional=True,
        summary=(SummaryValue("max_pocket_displacement_um", largest_size, "largest pocket displacement",
            ",.1f"),)),
    Quantity("pocket_share", "", "Z", "1", "block",
        f"that displacement over bearing.cage.pocket_clearance; beyond 1 the ball presses the wall; {_CAGED}",
        source="oil.cage.share", optional=True,
        summary=(SummaryValue("max_pocket_share", largest_size, "largest part of the pocket clearance",
            ".3f"),)),
    Quantity("land_torque", "M_l", "", "N m", "block",
        f"torque of the guiding land on the cage, positive to +azimuth; {_CAGED}",
        source="oil.cage.land_torque", optional=True,
        summary=(SummaryValue("land_torque_Nm", label="torque of the land on the cage", digits=".4g"),)),
    *(
        Quantity(f"loss_{cause}", "", "", "W", "block", f"power lost by {words}; {_CAGED}",
            source=f"oil.cage.losses.{cause}", optional=True,
            summary=(SummaryValue(f"power_loss_W.{cause}", label=f"power lost by {words}", digits=",.3g"),))
        for cause, words in CAGE_LOSSES.items()
    ),
    Quantity("mean_ball_slip", "s", "", "1", "block",
        "mean of ball_slip over the balls that both races guide, as they drive a cage; absent where there "
        f"are none, and {_IN_OIL}", source="oil.mean_ball_slip", people=PERCENT, optional=True,
        summary=(SummaryValue("mean_ball_slip_percent", label="mean slip of the balls", digits=".2f"),)),
    Quantity("ball_slip", "", "Z", "1", "block",
        "1 - orbital speed / that without slip in the middle of both contacts, with the same axis, both "
        f"against the outer ring; positive: the ball lags behind; {_IN_OIL}",
        source="oil.slip", people=PERCENT, optional=True,
        summary=(SummaryValue("ball_slip_range_percent", finite_range, "slip of a ball", ".2f",
            entries=EXTENT),)),
    Quantity("film", "h", "race Z", "m", "block", f"film thickness by lubricant.film; {_IN_OIL}",
        source="oil.film", people=UM, optional=True,
        summary=(SummaryValue("film_range_um", _range_of_races, "film", ".3f", parts=RACES,
            entries=EXTENT),)),
    Quantity("film_ratio", "Lambda", "race Z", "1", "block",
        "film over composite roughness; absent without bearing.roughness", source="oil.film_ratio",
        optional=True,
        summary=(SummaryValue("film_ratio_range", _range_of_races, "film ratio", ".2f", parts=RACES,
            entries=EXTENT),)),
    Quantity("entrainment", "u", "race Z", "m/s", "block",
        f"mean surface speed through the middle of the contact, >= 0; {_IN_OIL}", source="oil.entrainment",
        optional=True),
    Quantity("sliding_heat", "", "race Z", "W", "block", f"heat of the slip in the contact; {_IN_OIL}",
        source="oil.sliding_heat", optional=True),
    Quantity("spin_to_roll", "", "race Z", "1", "block",
        f"spin over roll of the ball against the race; {_IN_OIL}", source="oil.spin_to_roll", optional=True,
        summary=(SummaryValue("largest_spin_to_roll", lambda ratio: np.abs(ratio).max(1),
            "largest spin over roll", ".3f", parts=RACES),)),
    Quantity("sliding_power", "p V", "race Z", "W/m^2", "block",
        f"pressure times slip, mean over the contact; {_IN_OIL}", source="oil.sliding_power",
        people=W_PER_MM2, optional=True,
        summary=(SummaryValue("largest_sliding_power_W_per_mm2", _largest_of_races,
            "largest pressure times slip", ",.0f", parts=RACES),)),
    friction_intensity("oil.friction_intensity", "mean over the contact", _IN_OIL),

    # life
    Quantity("life_L10", "L_10r", "", "rev", "block",
        f"reference rating life of both raceways together by ISO/TS 16281, 90 % survival; {_UNRATED}",
        source="life.basic", people=MREV, optional=True,
        summary=(SummaryValue("life_L10_Mrev", label="reference life L10r, ISO/TS 16281", digits=",.4g",
                              error="life", speed="relative_speed"),)),
    Quantity("raceway_life", "L_10,i, L_10,o", "race", "rev", "block",
        f"the same of each raceway alone (inner, outer); {_UNRATED}", source="life.raceways",
        people=MREV, optional=True, infinite=True,
        summary=(SummaryValue("raceway_life_Mrev", label="life L10", digits=",.4g", parts=RACES,
            speed="relative_speed"),)),
    Quantity("modified_life", "L_nmr", "", "rev", "block",
        "life after every factor of [life], see the attribute life; absent when nothing modifies it",
        source="life.modified", people=MREV, optional=True,
        summary=(SummaryValue("modified_life_Mrev", label="modified life", digits=",.4g",
            speed="relative_speed"),)),
    Quantity("relative_speed", "", "", "rad/s", "block",
        "speed of the inner ring less that of the outer ring, by which revolutions become hours; absent in "
        "results of older versions", source="state.operation.relative_speed", people=RPM, optional=True),

    # ring
    Quantity("free_contact_angle", "alpha_0", "", "rad", "block",
        "contact angle at which balls just touch both races under an axial load, by the clearance",
        source="state.bearing.free_contact_angle", people=DEG,
        summary=(SummaryValue("free_contact_angle_deg", label="free contact angle", digits=".2f"),)),
    Quantity("radial_clearance", "P_d", "", "m", "block",
        "radial clearance in operation, as a change of diameter; of an angular-contact bearing that of its "
        "free contact angle, 2 A (1 - cos(alpha_0)); negative is an interference",
        source="state.bearing.radial_clearance", people=UM,
        summary=(SummaryValue("radial_clearance_um", label="radial clearance", digits=".2f"),)),
    Quantity("end_play", "", "", "m", "block",
        "axial clearance: way of the inner ring between the places where balls just touch on either side, "
        "2 A sin(alpha_0), of rigid rings; zero with an interference; absent of one row with an angle, "
        "whose shoulders are on one side",
        source="state.bearing.end_play", people=UM, optional=True,
        summary=(SummaryValue("end_play_um", label="end play", digits=".2f"),)),
    Quantity("row_load", "", "row row_force", "N", "block",
        f"what each row carries for the inner ring (x, y, z); {_ONE_ROW}", source="state.row_load",
        optional=True, summary=(
            SummaryValue("row_axial_force_N", lambda forces: forces[:, 0], "axial force", ",.1f",
                entries=ROWS, section=RING),
            SummaryValue("row_radial_force_N", lambda forces: np.hypot(forces[:, 1], forces[:, 2]),
                "radial force", ",.1f", entries=ROWS, section=RING),
        )),
    Quantity("unloading_force", "", "", "N", "block",
        "axial load that takes the load off a row which another presses, at rest and by it alone, of rigid "
        "rings; zero with play between them; absent without rows against each other",
        source="rated.unloading_force", optional=True,
        summary=(SummaryValue("unloading_force_N", label="axial load that unloads a row", digits=",.1f"),)),
    Quantity("ring_load", "P", "force", "N, N m", "block",
        f"what the balls carry for the inner ring ({_ORDER}): load or reaction",
        summary=(
            SummaryValue("ring_load_N", displacements, "load or reaction", ",.1f", unit=Unit("N"),
                entries=XYZ, section=RING),
            SummaryValue("ring_moment_Nm", tilts, "moment or reaction", ",.3f",
                unit=Unit("N m"), section=RING, entries=ABOUT_YZ),
        )),
    Quantity("ring_displacement", "delta", "displacement", "m, rad", "state",
        f"displacement of the inner ring ({_ORDER})", summary=(
            SummaryValue("ring_displacement_um", displacements, "displacement", ".3f", unit=UM,
                entries=XYZ,
                section=RING),
            SummaryValue("ring_tilt_mrad", tilts, "tilt", ".4f", unit=MRAD,
                section=RING, entries=ABOUT_YZ),
        )),
    Quantity("stiffness_matrix", "K", "force displacement", "N/m, N/rad, N m/m, N m/rad", "block",
        f"load on the inner ring by its displacement ({_ORDER}), balls in balance", source="state.stiffness",
        summary=(*map(_estimated, RADIAL_STIFFNESSES), SummaryValue("stiffness_matrix_SI"))),

    Quantity("groove_displacement", "w_r", "race Z", "m", "state",
        f"outward displacement of the grooves under the balls; {_OF_RINGS}",
        source="state.groove_radial", people=UM, optional=True,
        summary=(SummaryValue("groove_displacement_um", lambda moved: np.abs(moved).max(1),
            "largest radial displacement of the grooves", ".2f", parts=RACES, section="compared"),)),
    Quantity("groove_axial_displacement", "w_x", "race Z", "m", "state",
        f"displacement of the grooves under the balls along x; {_OF_RINGS}",
        source="state.groove_axial", people=UM, optional=True),

    *PROBES,

    # pure rolling lines
    Quantity("line_parameter", "E", "race Z", "1", "block",
        f"E of the pure rolling lines, c1 + c2 = -E; {_APART}", source="lines.line_parameter",
        optional=True, gaps=True,
        summary=(SummaryValue("line_parameter_range", _range_of_races, "E of the pure rolling lines", ".3f",
            parts=RACES, entries=EXTENT),)),
    Quantity("net_friction", "e", "race Z", "1", "block",
        f"e, friction in the rolling direction over coefficient times load; {_APART}",
        source="lines.net_friction", optional=True, gaps=True),
    Quantity("first_line", "c_1", "race Z", "1", "block",
        "c1, place over the semi-axis, positive towards smaller contact angles; at or below -1 it "
        f"lies outside the contact; {_APART}", source="lines.first_line", optional=True, gaps=True, summary=(
            SummaryValue("first_line_range", _range_of_races, "c1, first pure rolling line", ".3f",
                parts=RACES, entries=EXTENT),
            SummaryValue("first_lines", parts=RACES),
        )),
    Quantity("second_line", "c_2", "race Z", "1", "block",
        "c2 > c1, place over the semi-axis, positive towards smaller contact angles; at or above 1 it lies "
        f"outside the contact; {_APART}",
        source="lines.second_line", optional=True, gaps=True, summary=(
            SummaryValue("second_line_range", _range_of_races, "c2, second pure rolling line", ".3f",
                parts=RACES, entries=EXTENT),
            SummaryValue("second_lines", parts=RACES),
        )),
    Quantity("line_count", "", "race Z", "1", "block", f"lines inside the contact, 1 or 2; {_APART}",
        source="lines.line_count", optional=True, gaps=True, summary=(
            SummaryValue("balls_with_one_line", lambda count: (count == 1).sum(1), "balls with one line",
                "d", parts=RACES),
            SummaryValue("balls_with_two_lines", lambda count: (count == 2).sum(1), "balls with two lines",
                "d", parts=RACES),
            SummaryValue("line_counts", parts=RACES),
        )),
    Quantity("spin_torque", "M_s", "race Z", "N m", "block",
        "friction torque about the contact normal, integrated over the contact, of the sign of E; "
        f"{_APART}",
        source="lines.spin_torque", optional=True, gaps=True),
    Quantity("spin_torque_by_lines", "", "race Z", "N m", "block",
        f"the same from c1 and c2 alone, as for a narrow contact; {_APART}",
        source="lines.spin_torque_by_lines", optional=True, gaps=True),
    Quantity("spin_friction", "", "", "N m", "block",
        "sum of spin_torque times the sine of the contact angle over the contacts of both races, Eq. (24) of "
        "Rivera, Tong and Hong (2021); not the torque between the rings, which is friction_torque",
        source="lines.spin_friction", optional=True,
        summary=(SummaryValue("spin_friction_Nm", label="sum of spin torques, Rivera Eq. (24)",
            digits=".4g"),)),
    Quantity("spin_friction_by_lines", "", "", "N m", "block", "the same of spin_torque_by_lines",
        source="lines.spin_friction_by_lines", optional=True,
        summary=(SummaryValue("spin_friction_by_lines_Nm", label="  by the pure rolling lines",
            digits=".4g"),)),
    Quantity("slip_position", "x/a", "P", "1", "block",
        "place across the contact over the semi-axis, positive towards smaller contact angles: towards the "
        "bottom of the grooves where these are above zero",
        source="lines.slip_position", optional=True),
    Quantity("slip_profile", "v_t", "race Z P", "m/s", "block",
        f"slip in the rolling direction, ball minus race, across the middle of the contact; {_APART}",
        source="lines.slip_profile", people=Unit("mm/s", 1e3), optional=True, gaps=True,
        summary=(SummaryValue("largest_slip_mm_per_s", lambda slip: np.nanmax(np.abs(slip), axis=(1, 2)),
            "largest slip across the middle", ",.1f", parts=RACES),)),

    # fields over the contacts of one ball
    Quantity("field_ball", "", "", "1", "block", f"number, from 0, {_CELLS}", source="fields.ball",
        optional=True),
    Quantity("field_across", "x", "race P1 P2", "m", "block",
        f"places in the contact across the rolling direction, {_CELLS}", source="fields.x", people=MM,
        optional=True),
    Quantity("field_along", "y", "race P1 P2", "m", "block",
        f"places in the contact along the rolling direction, {_CELLS}", source="fields.y", people=MM,
        optional=True),
    Quantity("slip_along", "v_t", "race P1 P2", "m/s", "block",
        f"slip along the rolling direction, ball minus race, {_CELLS}", source="fields.slip_along",
        optional=True),
    Quantity("slip_across", "v_1", "race P1 P2", "m/s", "block",
        f"slip across the rolling direction, ball minus race, {_CELLS}", source="fields.slip_across",
        optional=True),
    Quantity("shear_along", "tau_t", "race P1 P2", "Pa", "block",
        f"shear stress on the ball along the rolling direction, {_CELLS}", source="fields.shear_along",
        people=MPA, optional=True),
    Quantity("shear_across", "tau_1", "race P1 P2", "Pa", "block",
        f"shear stress on the ball across the rolling direction, {_CELLS}", source="fields.shear_across",
        people=MPA, optional=True),
    Quantity("field_pressure", "p", "race P1 P2", "Pa", "block", f"pressure, mean of each cell, {_CELLS}",
        source="fields.pressure", people=MPA, optional=True),
    Quantity("field_stick", "", "race P1 P2", "1", "block", f"1 where the surfaces stick, else 0, {_CELLS}",
        source="fields.stick", optional=True),

    *ITERATIONS,
)
# fmt: on

LAYOUT = Layout(
    conventions="""\
Directions: x axial, towards the side to which the inner ring pushes the balls, z along the load; azimuth from
z towards y, which is the way a positive speed turns: left-handed about +x. Rotations about y and z are
right-handed.
""",
    axes=(
        Axis("Z", "ball", coordinate="ball_azimuth"),
        Axis("P", "point", coordinate="slip_position"),
        Axis("P1", "across"),
        Axis("P2", "along"),
        PROBE_AXIS,
        *SUBSURFACE_AXES,
    ),
    quantities=QUANTITIES,
    main=(
        "balls_on_both_races",
        "contact_load_range.outer.largest",
        "peak_pressure.inner",
        "contact_angle_range.inner.largest",
        "orbital_speed_range.smallest",
    ),
    weighed=(
        ("contact_load_range.outer.largest", "largest load"),
        ("peak_pressure.inner", "peak pressure"),
        ("stiffness_zz", "stiffness"),
        ("friction_torque", "torque"),
    ),
    blocks=("rigid",),
    further_blocks=("flexible",),
    further_attributes=(
        CLEARANCE_ATTRIBUTE,
        replace(LIFE_ATTRIBUTE, optional=True),
        RULE_ATTRIBUTE,
        CATALOGUE_ATTRIBUTE,
        *(replace(attribute, optional=True) for attribute in (METHOD, ATTEMPTS, STRUCTURE)),
        STRESSES,
        CHOICES,
        ERROR_ESTIMATE,
    ),
    head=(
        "kind",
        *HEAD,
        "method",
        "clearance",
        "life",
        "life_rule",
        "catalogue_life",
        "structure",
        "stresses",
        "choices",
        "error_estimate",
    ),
    case_keys=(("friction_model", "friction", "model"), ("friction_spin", "friction", "spin")),
)
