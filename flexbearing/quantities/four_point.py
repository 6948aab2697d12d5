"""Output quantities of a slow ball bearing of two or four contact points.

The page of a result shows its rows in the order of declaration, those of two races in a table of their own.
"""

from dataclasses import replace

import numpy as np

from flexbearing.quantities.attributes import HEAD
from flexbearing.quantities.ball_clearance import CLEARANCE_ATTRIBUTE
from flexbearing.quantities.contact_stress import SUBSURFACE_AXES, subsurface, worst_contact
from flexbearing.quantities.coupling import STRESSES
from flexbearing.quantities.layout import Axis, Layout
from flexbearing.quantities.life_records import LIFE_ATTRIBUTE, RULE_ATTRIBUTE
from flexbearing.quantities.probes import PROBE_AXIS, PROBES
from flexbearing.quantities.quantity import Quantity, SummaryValue, Unit
from flexbearing.quantities.reductions import (
    ABOUT_YZ,
    EXTENT,
    RACES,
    XYZ,
    at_inner_race,
    displacements,
    finite_range,
    largest_of_all,
    loaded,
    tilts,
)
from flexbearing.quantities.stiffness import RADIAL_STIFFNESSES
from flexbearing.quantities.units import COUNT, DEG, KN, MM, MPA, MRAD, MREV, RPM, UM

RING = "ring"  # section of the page
TORQUE_PARTS = ("spin", "roll", "hysteresis", "total")
_UNDRIVEN = "NaN for a ball that is not pressed on both rings"
_UNRATED = "absent without load, where contact loads are given, and where ISO 281 has no rating"
_GIVEN = "absent when contact loads are given"
_ORDER = "x, y, z, about y, about z; these about the point of the axis in the plane of the ball centres"


def _largest_of_races(values: np.ndarray) -> np.ndarray:
    return values.max((0, 1))


def _torques(spin: np.ndarray, roll: np.ndarray, hysteresis: np.ndarray) -> np.ndarray:
    """Parts of the torque of each ball on the inner ring (4, Z), in the order of `TORQUE_PARTS`."""
    return np.array([spin[:, 0], roll[:, 0], hysteresis, spin[:, 0] + roll[:, 0] + hysteresis])


def _ball_of_largest_torque(*torques: np.ndarray) -> np.ndarray:
    parts = _torques(*torques)
    return parts[:, parts[-1].argmax()]


_OF_PARTS = ("spin_torque", "roll_torque", "hysteresis_torque")

# declarations read best as a table:
# fmt: off
QUANTITIES = (
    # loads
    Quantity("contact_load", "Q", "Z G race", "N", "block", "normal load, >= 0",
        source="balls.load", summary=(
        SummaryValue("balls", len, "balls", "d", unit=COUNT),
        SummaryValue("loaded_balls", lambda load: int(loaded(load).any((1, 2)).sum()),
            "balls that carry load", "d", unit=COUNT),
        SummaryValue("loaded_contacts", lambda load: int(loaded(load).sum()),
            "contacts that carry load", "d", unit=COUNT),
        SummaryValue("max_contact_load_N", largest_of_all, "largest contact load", ",.1f"),
        SummaryValue("max_contact_loads_N", lambda load: load.max((0, 2))),
        SummaryValue("contact_loads_N", at_inner_race),
    )),
    Quantity("ball_azimuth", "phi", "Z", "rad", "block",
        "place of the ball, 0 on the z axis, positive towards y", source="solution.azimuths", people=DEG,
        summary=(SummaryValue("ball_azimuths_deg"),)),
    Quantity("contact_angle", "alpha", "Z G race", "rad", "block", "contact angle from the radial plane",
        source="balls.contacts.angle", people=DEG, summary=(
            SummaryValue("contact_angle_range_deg", lambda angle, load: finite_range(angle[loaded(load)]),
                "contact angle", ".2f", of=("contact_angle", "contact_load"), entries=EXTENT),
            SummaryValue("contact_angles_deg", at_inner_race),
        )),
    Quantity("section_force", "S", "Z G race", "N", "block",
        "force along the groove section by friction and by shoulders that cut contacts off, of the inner "
        "race on the ball, of the ball on the outer one, towards growing contact angle; not of given loads",
        source="ring.section_forces", optional=True),
    Quantity("peak_pressure", "p", "Z G race", "Pa", "block",
        "largest pressure, 0 without load; that of a cell where it is computed",
        source="balls.peak_pressure", people=MPA, summary=(
            SummaryValue("peak_pressure_MPa", _largest_of_races, "peak pressure", ",.0f", parts=RACES),
        )),
    Quantity("semi_axis_across", "a", "Z G race", "m", "block",
        "semi-axis across the rolling direction, 0 without load", source="balls.ellipse.across", people=MM,
        summary=(SummaryValue("semi_axis_across_mm", _largest_of_races, "largest semi-axis across rolling",
            ".4f", parts=RACES),)),
    Quantity("semi_axis_along", "b", "Z G race", "m", "block",
        "semi-axis along the rolling direction, 0 without load", source="balls.ellipse.along", people=MM,
        summary=(SummaryValue("semi_axis_along_mm", _largest_of_races, "largest semi-axis along rolling",
            ".4f", parts=RACES),)),
    *worst_contact("worst"),
    *subsurface(),
    Quantity("friction_coefficient", "mu", "Z G race", "1", "block", "Coulomb friction at the peak pressure",
        source="balls.friction"),
    Quantity("centrifugal_force", "F_c", "Z", "N", "block", f"force of the orbit, outwards; {_GIVEN}",
        source="ring.centrifugal", optional=True, summary=(
            SummaryValue("centrifugal_force_range_N", finite_range, "centrifugal force", ".3f",
                entries=EXTENT),)),
    Quantity("gyroscopic_moment", "M_g", "Z", "N m", "block",
        "moment that turns the ball's axis with the orbit, positive where the first diagonal carries; "
        f"{_GIVEN}", source="ring.gyroscopic", optional=True, people=Unit("mN m", 1e3), summary=(
            SummaryValue("gyroscopic_moment_range_Nm", finite_range, "gyroscopic moment", ".4f",
                in_si=True, entries=EXTENT),)),

    # motion
    Quantity("ball_motion", "Omega_o, omega_x, omega_r", "Z turning", "rad/s", "block",
        "angular velocity of the outer ring about x, of the ball about x and about the radial direction, "
        "right-handed (rings that turn towards growing azimuth turn about -x), seen from the orbiting "
        f"ball centre; {_UNDRIVEN}", source="solution.ball_motion", people=RPM, gaps=True),
    Quantity("ball_speed_ratio", "", "Z", "1", "block",
        f"speed of the ball over that of the inner ring, seen from the orbiting ball centre; {_UNDRIVEN}",
        source="balls.ball_speed", gaps=True, summary=(
            SummaryValue("ball_speed_ratio_range", finite_range, "ball speed over ring speed", ".2f",
                entries=EXTENT),
            SummaryValue("ball_speed_ratios"),
        )),
    Quantity("ball_attitude", "", "Z", "rad", "block",
        f"angle of the ball's speed from that of the inner ring, pi where axes are parallel; {_UNDRIVEN}",
        source="balls.axis_angle", people=DEG, gaps=True, summary=(
            SummaryValue("ball_attitude_range_deg", finite_range, "angle of the ball's axis", ".1f",
                entries=EXTENT),
            SummaryValue("ball_attitudes_deg"),
        )),
    Quantity("ball_turn", "omega_t", "Z", "rad/s", "block",
        "turn of the ball about the rolling direction, counted as that about x; NaN for a ball that is not "
        "pressed on both rings; absent in full sliding, where it is zero",
        source="solution.ball_turn", gaps=True, optional=True),
    Quantity("stick_share", "", "Z G race", "1", "block",
        "part of the cells in contact that stick; absent in full sliding", source="rolling.stick_share",
        optional=True, summary=(SummaryValue("largest_stick_share", largest_of_all,
            "largest part of a contact that sticks", ".3f"),)),
    Quantity("ball_imbalance", "", "Z", "1", "block",
        "power that is left unbalanced over the power of friction, of each ball",
        source="balls.sliding.imbalance", summary=(SummaryValue("max_ball_imbalance", largest_of_all),)),

    # torque
    Quantity("torque", "T", "race", "N m", "block", "torque of all balls on the rings, (inner, outer)",
        source="solution.torque",
        summary=(SummaryValue("torque_Nm", label="friction torque", digits=".5g", parts=RACES),)),
    Quantity("grid_error", "", "Z", "N m", "block",
        "error of the torque of the ball by the cells, from its changes with half and a quarter of them; "
        "absent in full sliding", source="rolling.grid_error", optional=True, summary=(
            SummaryValue("torque_grid_error_Nm", lambda error: error.sum(),
                "error of the torque by the cells", ".2g"),)),
    Quantity("spin_torque", "", "Z race", "N m", "block",
        "torque on the ring by the moments about the contact normals, (inner, outer)",
        source="balls.torques.spin", summary=(
            SummaryValue("torque_parts_Nm", lambda *torques: _torques(*torques).sum(1),
                of=_OF_PARTS, parts=TORQUE_PARTS),
            SummaryValue("mean_ball_torque_parts_Nm", lambda *torques: _torques(*torques).mean(1),
                of=_OF_PARTS, parts=TORQUE_PARTS),
            SummaryValue("largest_ball_torque_parts_Nm", _ball_of_largest_torque, of=_OF_PARTS,
                parts=TORQUE_PARTS),
        )),
    Quantity("roll_torque", "", "Z race", "N m", "block",
        "torque on the ring by the forces along the rolling direction, (inner, outer)",
        source="balls.torques.roll"),
    Quantity("circumferential_torque", "", "Z race", "N m", "block",
        "torque on the ring by the tractions along the rolling direction alone, (inner, outer)",
        source="balls.torques.circumferential",
        summary=(SummaryValue("circumferential_torque_Nm",
            lambda torque, hysteresis: torque[:, 0].sum() + hysteresis.sum(),
            of=("circumferential_torque", "hysteresis_torque")),)),
    Quantity("hysteresis_torque", "", "Z", "N m", "block",
        "torque of elastic hysteresis, the same on both rings, >= 0", source="balls.hysteresis"),
    Quantity("ball_torque", "", "Z race", "N m", "block",
        "torque of the ball by the formula of friction.torque, hysteresis included, (inner, outer)",
        source="solution.ball_torque", summary=(SummaryValue("ball_torques_Nm", at_inner_race),)),
    Quantity("power_loss", "", "", "W", "block", "heat of friction and hysteresis at the speed of the case",
        source="solution.power_loss",
        summary=(SummaryValue("power_loss_W", label="power loss", digits=".4g"),)),

    # life
    Quantity("life_L10", "L_10r", "", "rev", "block",
        "reference rating life of all arcs together by ISO/TS 16281, 90 % survival, in revolutions that the "
        f"rings go against each other, to and fro together; {_UNRATED}",
        source="life.basic", people=MREV, optional=True,
        summary=(SummaryValue("life_L10_Mrev", label="reference life L10r, ISO/TS 16281", digits=",.4g",
                              speed="relative_speed"),)),
    Quantity("raceway_life", "L_10,i, L_10,o", "race", "rev", "block",
        f"the same of both arcs of each ring (inner, outer); {_UNRATED}", source="life.raceways",
        people=MREV, optional=True, infinite=True,
        summary=(SummaryValue("raceway_life_Mrev", label="life L10", digits=",.4g", parts=RACES,
            speed="relative_speed"),)),
    Quantity("arc_life", "", "G race", "rev", "block",
        f"the same of each arc alone; {_UNRATED}", source="life.arcs", people=MREV, optional=True,
        infinite=True, summary=(SummaryValue("arc_lives_Mrev"),)),
    Quantity("modified_life", "L_nm", "", "rev", "block",
        "life with the reliability of the case, see the attribute life; absent when it requires none",
        source="life.modified", people=MREV, optional=True,
        summary=(SummaryValue("modified_life_Mrev", label="modified life", digits=",.4g",
            speed="relative_speed"),)),
    Quantity("oscillations", "", "", "1", "block",
        "oscillations of the reference life, each there and back; absent where rings turn on",
        source="life.oscillations", optional=True,
        summary=(SummaryValue("oscillations", label="oscillations of the reference life", digits=",.4g"),)),
    Quantity("dynamic_rating", "C_a, C_r", "", "N", "block",
        "dynamic rating of one diagonal that the life is computed with, axial or radial by the attribute "
        f"life_rule; {_UNRATED}", source="life.rating", people=KN, optional=True,
        summary=(SummaryValue("dynamic_rating_kN", label="dynamic rating of a diagonal", digits=",.4g"),)),
    Quantity("relative_speed", "", "", "rad/s", "block",
        "speed of the inner ring less that of the outer ring, by which revolutions become hours; the mean "
        f"of its amount where rings oscillate; {_UNRATED}", source="life.relative_speed", people=RPM,
        optional=True),

    # rings
    Quantity("free_contact_angle", "alpha_0", "", "rad", "block",
        "contact angle of the diagonals without load, after mounting",
        source="solution.bearing.contact_angle", people=DEG,
        summary=(SummaryValue("free_contact_angle_deg", label="free contact angle", digits=".2f"),)),
    Quantity("diagonal_clearance", "", "", "m", "block",
        "free way of a ball along a diagonal, after mounting; negative is an interference",
        source="solution.bearing.clearance", people=UM,
        summary=(SummaryValue("diagonal_clearance_um", label="clearance along a diagonal", digits=".2f"),)),
    Quantity("end_play", "", "", "m", "block",
        "axial clearance: way of the inner ring from balls that just touch on one diagonal to the other, of "
        "rigid rings; zero with an interference",
        source="solution.bearing.end_play", people=UM,
        summary=(SummaryValue("end_play_um", label="end play", digits=".2f"),)),
    Quantity("ring_load", "P", "force", "N, N m", "block", f"load on the inner ring ({_ORDER}); {_GIVEN}",
        source="solution.ring_load", optional=True),
    Quantity("ring_displacement", "delta", "displacement", "m, rad", "block",
        f"displacement of the inner ring ({_ORDER}), of its bolted face when it is elastic; {_GIVEN}",
        source="ring.displacement", optional=True, summary=(
            SummaryValue("ring_displacement_um", displacements, "displacement", ".3f", unit=UM,
                entries=XYZ,
                section=RING),
            SummaryValue("ring_tilt_mrad", tilts, "tilt", ".4f", unit=MRAD,
                section=RING, entries=ABOUT_YZ),
        )),
    Quantity("ring_yield", "s", "Z G race", "m", "block",
        "elastic deflection: by how much both rings let opposite groove centres come closer, (outward, along "
        "x), the indentation of the contacts left out; absent between rigid rings",
        source="solution.ring_deflection", people=UM, optional=True,
        summary=(SummaryValue("largest_ring_yield_um", lambda approach: np.hypot(*approach.T).max(),
            "largest deflection of the rings", ".2f", section="compared"),)),
    Quantity("stiffness_matrix", "K", "force displacement", "N/m, N/rad, N m/m, N m/rad", "block",
        f"tangent stiffness of the rings without friction ({_ORDER}); {_GIVEN}", source="ring.stiffness",
        optional=True, summary=(*RADIAL_STIFFNESSES, SummaryValue("stiffness_matrix_SI"))),
    Quantity("ring_imbalance", "", "", "1", "block",
        f"unbalanced force on the inner ring over the largest force; {_GIVEN}", source="ring.imbalance",
        optional=True),

    # fields over the contacts of chosen balls
    Quantity("field_ball", "", "F", "1", "block", "numbers, from 0, of the balls of the fields below",
        source="fields.balls"),
    Quantity("field_across", "x", "F G race P1 P2", "m", "block",
        "centres of the cells across the rolling direction; 0 without load", source="fields.x", people=MM),
    Quantity("field_along", "y", "F G race P1 P2", "m", "block",
        "centres of the cells along the rolling direction; 0 without load", source="fields.y", people=MM),
    Quantity("slip_along", "v_t", "F G race P1 P2", "m/s", "block",
        "slip along the rolling direction, ball minus race; 0 without load", source="fields.slip_along"),
    Quantity("slip_across", "v_1", "F G race P1 P2", "m/s", "block",
        "slip across the rolling direction, ball minus race; 0 without load", source="fields.slip_across"),
    Quantity("shear_along", "tau_t", "F G race P1 P2", "Pa", "block",
        "shear stress on the ball along the rolling direction; 0 outside the contact",
        source="fields.shear_along", people=MPA),
    Quantity("shear_across", "tau_1", "F G race P1 P2", "Pa", "block",
        "shear stress on the ball across the rolling direction; 0 outside the contact",
        source="fields.shear_across", people=MPA),
    Quantity("field_pressure", "p", "F G race P1 P2", "Pa", "block",
        "pressure, mean of each cell; 0 outside the contact", source="fields.pressure", people=MPA),
    Quantity("field_stick", "", "F G race P1 P2", "1", "block",
        "1 where the surfaces stick, else 0, as everywhere in full sliding", source="fields.stick"),
    *PROBES,
)
# fmt: on

LAYOUT = Layout(
    conventions="""\
Directions: x axial, z along the load, azimuth from z towards y, left-handed about +x; rotations about y
and z are right-handed. There are one or two diagonals; the first runs outwards to positive x.
Torques are what must be put in so that the inner ring runs ahead: positive there, negative at the outer ring.
""",
    axes=(
        Axis("Z", "ball", coordinate="ball_azimuth"),
        Axis("G", "diagonal"),
        Axis("F", "chosen_ball", coordinate="field_ball"),
        Axis("P1", "across"),
        Axis("P2", "along"),
        *SUBSURFACE_AXES,
        PROBE_AXIS,
    ),
    quantities=QUANTITIES,
    main=("max_contact_load", "loaded_balls", "peak_pressure.inner", "torque.inner", "power_loss"),
    weighed=(
        ("max_contact_load", "largest load"),
        ("peak_pressure.inner", "peak pressure"),
        ("stiffness_zz", "stiffness"),
        ("torque.inner", "torque"),
    ),
    blocks=("rigid",),
    further_blocks=("flexible",),
    further_attributes=(
        CLEARANCE_ATTRIBUTE,
        replace(LIFE_ATTRIBUTE, optional=True),
        RULE_ATTRIBUTE,
        STRESSES,
    ),
    head=("kind", *HEAD, "clearance", "life", "life_rule", "stresses"),
    case_keys=(
        ("torque_formula", "friction", "torque"),
        ("friction_model", "friction", "model"),
        ("friction_spin", "friction", "spin"),
    ),
)
