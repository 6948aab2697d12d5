"""How results of a slow ball bearing are shown."""

from flexbearing.case.family import Entry
from flexbearing.report.family_report import Elements, FamilyReport

ELEMENTS = Elements(
    word="ball",
    azimuth="ball_azimuth",
    columns=("ball_azimuth", "contact_load", "contact_angle", "peak_pressure"),
    figures={
        "contact load": ("contact_load",),
        "contact angle": ("contact_angle",),
        "torque of a ball": ("ball_torque",),
    },
    contact_figures={
        "peak pressure": ("peak_pressure",),
        "semi-axis across rolling": ("semi_axis_across",),
        "semi-axis along rolling": ("semi_axis_along",),
    },
)
REPORT = FamilyReport(
    page=Entry("flexbearing.report.balls.four_point_page:page"),
    pictures=Entry("flexbearing.report.balls.four_point_figures:pictures"),
    elements=ELEMENTS,
    balls=Entry("flexbearing.report.balls.four_point_figures:balls"),
    short={"loads": "ball_loads"},
    drawings=Entry("flexbearing.report.drawing.of_case:of_slow_balls"),
)
