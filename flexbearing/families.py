"""The bearing families: the only place where they are listed.

Nothing of a family is imported before it is used.
"""

from dataclasses import replace

from flexbearing.case.family import Entry, Family

_CARD = Entry("flexbearing.report.card:of_result")
_ROLLER = Family(
    kind="cylindrical_roller",
    case=Entry("flexbearing.case.roller:Case"),
    build=Entry("flexbearing.build.roller_bearing:build"),
    opening=Entry("flexbearing.runs.roller:opening"),
    solve=Entry("flexbearing.runs.roller:solve"),
    rows=Entry("flexbearing.runs.rows:answers"),
    levels=Entry("flexbearing.accuracy.trials:ROLLERS"),
    ahead=Entry("flexbearing.rings.raceways:outer_ring_ahead"),
    layout=Entry("flexbearing.quantities.roller:LAYOUT"),
    report=Entry("flexbearing.report.family_report:REPORT"),
    card=_CARD,
    profiles=Entry("flexbearing.build.profiles:drawn"),
    initial_state=Entry("flexbearing.coupled.states:initial_state"),
    neighbouring_state=Entry("flexbearing.coupled.states:neighbouring_state"),
    catalogue=Entry("flexbearing.life.roller_influences:CATALOGUE"),
    sensitivities=Entry("flexbearing.derivatives.rollers:sensitivities"),
)
_FOUR_POINT = Family(
    kind="four_point_ball",
    case=Entry("flexbearing.case.balls.four_point:FourPointCase"),
    build=Entry("flexbearing.runs.four_point:bearing"),
    opening=Entry("flexbearing.runs.ball:opening"),
    solve=Entry("flexbearing.runs.ball:solve_four_point"),
    rows=Entry("flexbearing.runs.ball:four_point_answers"),
    layout=Entry("flexbearing.quantities.four_point:LAYOUT"),
    report=Entry("flexbearing.report.family_report:FOUR_POINT"),
    card=_CARD,
    sensitivities=Entry("flexbearing.derivatives.slow_balls:sensitivities"),
)
_ANGULAR = Family(
    kind="angular_contact_ball",
    case=Entry("flexbearing.case.balls.angular_contact:AngularCase"),
    build=Entry("flexbearing.runs.angular_contact:build"),
    opening=Entry("flexbearing.runs.ball:opening"),
    solve=Entry("flexbearing.runs.ball:solve_angular"),
    levels=Entry("flexbearing.runs.ball_levels:BALLS"),
    rows=Entry("flexbearing.runs.ball:angular_answers"),
    layout=Entry("flexbearing.quantities.angular_contact:LAYOUT"),
    report=Entry("flexbearing.report.family_report:ANGULAR_CONTACT"),
    card=_CARD,
    catalogue=Entry("flexbearing.life.ball_influences:CATALOGUE"),
    sensitivities=Entry("flexbearing.derivatives.balls:sensitivities"),
)
_DEEP_GROOVE = replace(  # an angular-contact bearing whose contact angle comes from its clearance
    _ANGULAR, kind="deep_groove_ball", case=Entry("flexbearing.case.balls.deep_groove:DeepGrooveCase")
)
_TAPERED = Family(
    kind="tapered_roller",
    case=Entry("flexbearing.case.tapered:TaperedCase"),
    build=Entry("flexbearing.runs.tapered:build"),
    opening=Entry("flexbearing.runs.tapered:opening"),
    solve=Entry("flexbearing.runs.tapered:solve"),
    rows=Entry("flexbearing.runs.tapered:answers"),
    layout=Entry("flexbearing.quantities.tapered:LAYOUT"),
    sensitivities=Entry("flexbearing.derivatives.tapered:sensitivities"),
    report=Entry("flexbearing.report.family_report:TAPERED"),
    card=_CARD,
    profiles=Entry("flexbearing.build.profiles:drawn"),
    catalogue=Entry("flexbearing.life.tapered_influences:CATALOGUE"),
)
_THRUST = replace(  # inclined rollers of 90 degrees; the catalogue's comparison is that of radial ratings
    _TAPERED,
    kind="thrust_roller",
    case=Entry("flexbearing.case.tapered.thrust_case:ThrustCase"),
    layout=Entry("flexbearing.quantities.thrust_roller:LAYOUT"),
    report=Entry("flexbearing.report.family_report:THRUST"),
    catalogue=None,
)
_SPHERICAL = replace(  # two rows of inclined barrels
    _TAPERED,
    kind="spherical_roller",
    case=Entry("flexbearing.case.tapered.spherical_case:SphericalCase"),
    layout=Entry("flexbearing.quantities.spherical_roller:LAYOUT"),
    report=Entry("flexbearing.report.family_report:SPHERICAL"),
    profiles=None,
    catalogue=Entry("flexbearing.life.tapered_influences:SPHERICAL"),
)

FAMILIES = {
    family.kind: family
    for family in (_ROLLER, _FOUR_POINT, _ANGULAR, _DEEP_GROOVE, _TAPERED, _THRUST, _SPHERICAL)
}
