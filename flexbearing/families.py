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
    report=entry("flexbearing.report.roller.report:REPORT"),
    initial_state=entry("flexbearing.coupled.initial_state:initial_state"),
)
_FOUR_POINT = Family(
    kind="four_point_ball",
    case=entry("flexbearing.case.balls.four_point:FourPointCase"),
    build=entry("flexbearing.runs.four_point:bearing"),
    opening=entry("flexbearing.runs.ball:opening"),
    solve=entry("flexbearing.runs.ball:solve_four_point"),
    layout=entry("flexbearing.quantities.four_point:LAYOUT"),
    report=entry("flexbearing.report.balls.four_point_report:REPORT"),
)
_ANGULAR = Family(
    kind="angular_contact_ball",
    case=entry("flexbearing.case.balls.angular_contact:AngularCase"),
    build=entry("flexbearing.runs.angular_contact:build"),
    opening=entry("flexbearing.runs.ball:opening"),
    solve=entry("flexbearing.runs.ball:solve_angular"),
    layout=entry("flexbearing.quantities.angular_contact:LAYOUT"),
    report=entry("flexbearing.report.balls.angular_contact_report:REPORT"),
)

FAMILIES = {family.kind: family for family in (_ROLLER, _FOUR_POINT, _ANGULAR)}
