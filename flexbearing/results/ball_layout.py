"""The tables of what stands in the result file of a ball bearing."""

from flexbearing.quantities.layout import Layout
from flexbearing.results.layout import Dataset

_UNDRIVEN = "NaN for a ball that is not pressed on both rings"
_APART = "NaN for a ball that does not touch both races"
_PER_STIFFNESS = "N/m, N/rad, N m/m, N m/rad"
_RING = "x, y, z, about y, about z"
_ACROSS = "semi-axis across the rolling direction, 0 without load"
_ALONG = "semi-axis along the rolling direction, 0 without load"

# tables read best as tables:
# fmt: off
FOUR_POINT = (
    Dataset("ball_azimuth", "Z", "rad", "block", "place of the ball, 0 on the z axis, positive towards y"),
    Dataset("contact_load", "Z G 2", "N", "block", "normal load, >= 0"),
    Dataset("contact_angle", "Z G 2", "rad", "block", "contact angle from the radial plane"),
    Dataset("peak_pressure", "Z G 2", "Pa", "block", "largest pressure, 0 without load"),
    Dataset("semi_axis_across", "Z G 2", "m", "block", _ACROSS),
    Dataset("semi_axis_along", "Z G 2", "m", "block", _ALONG),
    Dataset("friction_coefficient", "Z G 2", "1", "block", "Coulomb friction at the peak pressure"),
    Dataset("ball_motion", "Z 3", "rad/s", "block",
            "angular velocity of the outer ring about x, of the ball about x and about the radial direction, "
            "right-handed (rings that turn towards growing azimuth turn about -x), seen from the orbiting "
            f"ball centre; {_UNDRIVEN}", gaps=True),
    Dataset("ball_speed_ratio", "Z", "1", "block",
            f"speed of the ball over that of the inner ring, seen from the orbiting ball centre; {_UNDRIVEN}",
            gaps=True),
    Dataset("ball_attitude", "Z", "rad", "block",
            f"angle of the ball's speed from that of the inner ring, pi where axes are parallel; {_UNDRIVEN}",
            gaps=True),
    Dataset("spin_torque", "Z 2", "N m", "block",
            "torque on the ring by the moments about the contact normals, (inner, outer)"),
    Dataset("roll_torque", "Z 2", "N m", "block",
            "torque on the ring by the forces along the rolling direction, (inner, outer)"),
    Dataset("circumferential_torque", "Z 2", "N m", "block",
            "torque on the ring by the tractions along the rolling direction alone, (inner, outer)"),
    Dataset("hysteresis_torque", "Z", "N m", "block",
            "torque of elastic hysteresis, the same on both rings, >= 0"),
    Dataset("ball_torque", "Z 2", "N m", "block",
            "torque of the ball by the formula of friction.torque, hysteresis included, (inner, outer)"),
    Dataset("torque", "2", "N m", "block", "torque of all balls on the rings, (inner, outer)"),
    Dataset("power_loss", "", "W", "block", "heat of friction and hysteresis at the speed of the case"),
    Dataset("ball_imbalance", "Z", "1", "block",
            "power that is left unbalanced over the power of friction, of each ball"),
    Dataset("ring_load", "5", "N, N m", "block",
            f"load on the inner ring ({_RING}); absent when contact loads are given", optional=True),
    Dataset("ring_displacement", "5", "m, rad", "block",
            f"displacement of the inner ring ({_RING}), of its bolted face when it is elastic; absent when "
            "contact loads are given", optional=True),
    Dataset("ring_yield", "Z G 2", "m", "block",
            "by how much both rings let opposite groove centres come closer, (outward, along x), the "
            "indentation of the contacts left out; absent between rigid rings", optional=True),
    Dataset("stiffness_matrix", "5 5", _PER_STIFFNESS, "block",
            f"tangent stiffness of the rings without friction ({_RING}); absent when contact loads are given",
            optional=True),
    Dataset("ring_imbalance", "", "1", "block",
            "unbalanced force on the inner ring over the largest force; absent when contact loads are given",
            optional=True),
    Dataset("field_ball", "F", "1", "block", "numbers, from 0, of the balls of the fields below"),
    Dataset("field_across", "F G 2 P P", "m", "block",
            "places in the contact across the rolling direction; 0 without load"),
    Dataset("field_along", "F G 2 P P", "m", "block",
            "places in the contact along the rolling direction; 0 without load"),
    Dataset("slip_along", "F G 2 P P", "m/s", "block",
            "slip along the rolling direction, ball minus race; 0 without load"),
    Dataset("slip_across", "F G 2 P P", "m/s", "block",
            "slip across the rolling direction, ball minus race; 0 without load"),
    Dataset("shear_along", "F G 2 P P", "Pa", "block",
            "shear stress on the ball along the rolling direction; 0 outside the contact"),
    Dataset("shear_across", "F G 2 P P", "Pa", "block",
            "shear stress on the ball across the rolling direction; 0 outside the contact"),
)

ANGULAR = (
    Dataset("ball_azimuth", "Z", "rad", "block", "place of the ball, 0 on the z axis, positive towards y"),
    Dataset("contact_load", "2 Z", "N", "block", "normal load, >= 0"),
    Dataset("contact_angle", "2 Z", "rad", "block", "contact angle from the radial plane"),
    Dataset("traction", "2 Z", "N", "block",
            "friction along the groove section, which holds the gyroscopic moment"),
    Dataset("needed_friction", "2 Z", "1", "block", "that traction over the load, 0 without load"),
    Dataset("peak_pressure", "2 Z", "Pa", "block", "largest pressure, 0 without load"),
    Dataset("semi_axis_across", "2 Z", "m", "block", _ACROSS),
    Dataset("semi_axis_along", "2 Z", "m", "block", _ALONG),
    Dataset("orbital_speed", "Z", "rad/s", "block",
            "speed of the ball centre about the shaft, positive to +azimuth"),
    Dataset("ball_speed", "Z", "rad/s", "block", "speed of the ball about its axis, in the orbiting frame"),
    Dataset("ball_attitude", "Z", "rad", "block",
            "angle of the ball's axis to the shaft, signed like contact angles"),
    Dataset("ball_yaw", "Z", "rad", "block",
            "angle of the ball's axis out of the plane of the section, positive: -x end leads towards "
            "+azimuth; 0 but with control coulomb"),
    Dataset("centrifugal_force", "Z", "N", "block", "force of the orbit, outwards"),
    Dataset("gyroscopic_moment", "Z", "N m", "block", "moment that turns the ball's axis with the orbit"),
    Dataset("ring_load", "5", "N, N m", "block",
            f"what the balls carry for the inner ring ({_RING}): load or reaction"),
    Dataset("ring_displacement", "5", "m, rad", "block", f"displacement of the inner ring ({_RING})"),
    Dataset("stiffness_matrix", "5 5", _PER_STIFFNESS, "block",
            f"load on the inner ring by its displacement ({_RING}), balls in balance"),
    Dataset("friction_heat", "Z", "W", "block",
            "heat of friction of both contacts; with control coulomb", optional=True),
    Dataset("friction_torque", "", "N m", "block",
            "torque between the rings by that friction; with control coulomb", optional=True),
    Dataset("line_parameter", "2 Z", "1", "block", f"E of the pure rolling lines, c1 + c2 = -E; {_APART}",
            optional=True, gaps=True),
    Dataset("net_friction", "2 Z", "1", "block",
            f"e, friction in the rolling direction over coefficient times load; {_APART}",
            optional=True, gaps=True),
    Dataset("first_line", "2 Z", "1", "block",
            "c1, place over the semi-axis, positive towards the bottom of the grooves; at or below -1 it "
            f"lies outside the contact; {_APART}", optional=True, gaps=True),
    Dataset("second_line", "2 Z", "1", "block",
            f"c2, place over the semi-axis, positive towards the bottom of the grooves; {_APART}",
            optional=True, gaps=True),
    Dataset("line_count", "2 Z", "1", "block", f"lines inside the contact, 1 or 2; {_APART}",
            optional=True, gaps=True),
    Dataset("spin_torque", "2 Z", "N m", "block",
            f"friction torque about the contact normal, integrated over the contact; {_APART}",
            optional=True, gaps=True),
    Dataset("spin_torque_by_lines", "2 Z", "N m", "block",
            f"the same from c1 and c2 alone, as for a narrow contact; {_APART}", optional=True, gaps=True),
    Dataset("spin_friction", "", "N m", "block",
            "sum of spin_torque times the sine of the contact angle over all contacts, Eq. (24) of Rivera, "
            "Tong and Hong (2021)", optional=True),
    Dataset("spin_friction_by_lines", "", "N m", "block", "the same of spin_torque_by_lines", optional=True),
    Dataset("slip_position", "P", "1", "block",
            "place across the contact over the semi-axis, positive towards the bottom of the grooves",
            optional=True),
    Dataset("slip_profile", "2 Z P", "m/s", "block",
            f"slip in the rolling direction, ball minus race, across the middle of the contact; {_APART}",
            optional=True, gaps=True),
)
# fmt: on

FOUR_POINT_LAYOUT = Layout(
    conventions="""\
Axes: Z balls, G diagonals (one or two; the first leans outwards to positive x), 2 races (inner, outer),
F balls and P points of the fields. Directions: x axial, z along the load, azimuth from z towards y.
Torques are what must be put in so that the inner ring runs ahead: positive there, negative at the outer ring.
""",
    quantities=FOUR_POINT,
    blocks=("rigid",),
    further_blocks=("flexible",),
)
ANGULAR_LAYOUT = Layout(
    conventions="""\
Axes: 2 races (inner, outer), Z balls, P points of the slip profile. Directions: x axial, towards the side to
which the inner ring pushes the balls, z along the load; azimuth from z towards y, which is the way a positive
speed turns.
""",
    quantities=ANGULAR,
    blocks=("rigid",),
)
