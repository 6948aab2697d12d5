"""The bearing families: the only place where they are listed.

Nothing of a family is imported before it is used.
"""

from flexbearing.case.family import Family, entry

_ROLLER = Family(
    kind="cylindrical_roller",
    case=entry("flexbearing.case.roller:Case"),
    build=entry("flexbearing.runs.validate_roller:build"),
    opening=entry("flexbearing.runs.roller:opening"),
    solve=entry("flexbearing.runs.roller:solve"),
    layout=entry("flexbearing.quantities.roller:LAYOUT"),
    look=entry("flexbearing.report.roller_look:LOOK"),
    initial_state=entry("flexbearing.coupled.initial_state:initial_state"),
)
_FOUR_POINT = Family(
    kind="four_point_ball",
    case=entry("flexbearing.case.balls.four_point:FourPointCase"),
    build=entry("flexbearing.runs.four_point:bearing"),
    opening=entry("flexbearing.runs.ball:opening"),
    solve=entry("flexbearing.runs.ball:solve_four_point"),
    layout=entry("flexbearing.results.ball_layout:FOUR_POINT_LAYOUT"),
    look=entry("flexbearing.report.ball_look:FOUR_POINT"),
)
_ANGULAR = Family(
    kind="angular_contact_ball",
    case=entry("flexbearing.case.balls.angular_contact:AngularCase"),
    build=entry("flexbearing.runs.angular_contact:build"),
    opening=entry("flexbearing.runs.ball:opening"),
    solve=entry("flexbearing.runs.ball:solve_angular"),
    layout=entry("flexbearing.results.ball_layout:ANGULAR_LAYOUT"),
    look=entry("flexbearing.report.ball_look:ANGULAR"),
)

FAMILIES = {family.kind: family for family in (_ROLLER, _FOUR_POINT, _ANGULAR)}
