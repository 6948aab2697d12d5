"""How results of ball bearings are shown: slow ones in four points, fast ones in two."""

from flexbearing.report.balls import angular_contact_figures, four_point_figures
from flexbearing.report.balls.page import of_fast, of_slow
from flexbearing.report.drawing.of_case import of_fast_balls, of_slow_balls
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
    of_slow,
    four_point_figures.pictures,
    elements=_OF_SLOW,
    balls=four_point_figures.balls,
    short=_SHORT,
    drawings=of_slow_balls,
)
ANGULAR_CONTACT = FamilyReport(
    of_fast,
    angular_contact_figures.pictures,
    elements=_OF_FAST,
    balls=angular_contact_figures.balls,
    short=_SHORT,
    drawings=of_fast_balls,
)
