"""How results of ball bearings are shown: slow ones in four points, fast ones in two."""

from flexbearing.case.family import Entry
from flexbearing.report.family_report import Elements, FamilyReport

_CONTACTS = {
    "peak pressure": ("peak_pressure",),
    "semi-axis across rolling": ("semi_axis_across",),
    "semi-axis along rolling": ("semi_axis_along",),
}
_COLUMNS = ("ball_azimuth", "contact_load", "contact_angle", "peak_pressure")
_FIGURES = {"contact load": ("contact_load",), "contact angle": ("contact_angle",)}
_OF_SLOW = Elements(
    word="ball",
    azimuth="ball_azimuth",
    columns=_COLUMNS,
    figures={**_FIGURES, "torque of a ball": ("ball_torque",)},
    contact_figures=_CONTACTS,
)
_OF_FAST = Elements(
    word="ball",
    azimuth="ball_azimuth",
    columns=(*_COLUMNS, "orbital_speed", "ball_speed"),
    figures={
        **_FIGURES,
        "orbital speed": ("orbital_speed",),
        "gyroscopic moment": ("gyroscopic_moment",),
    },
    contact_figures=_CONTACTS,
)
_SHORT = {"loads": "ball_loads"}
FOUR_POINT = FamilyReport(
    page=Entry("flexbearing.report.balls.page:of_slow"),
    pictures=Entry("flexbearing.report.balls.four_point_figures:pictures"),
    elements=_OF_SLOW,
    balls=Entry("flexbearing.report.balls.four_point_figures:balls"),
    short=_SHORT,
    drawings=Entry("flexbearing.report.drawing.of_case:of_slow_balls"),
)
ANGULAR_CONTACT = FamilyReport(
    page=Entry("flexbearing.report.balls.page:of_fast"),
    pictures=Entry("flexbearing.report.balls.angular_contact_figures:pictures"),
    elements=_OF_FAST,
    balls=Entry("flexbearing.report.balls.angular_contact_figures:balls"),
    short=_SHORT,
    drawings=Entry("flexbearing.report.drawing.of_case:of_fast_balls"),
)
