"""How results of a slow ball bearing are shown."""

from flexbearing.report.balls.four_point_figures import balls, pictures
from flexbearing.report.balls.four_point_page import page
from flexbearing.report.drawing.of_case import of_slow_balls
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
    page, pictures, elements=ELEMENTS, balls=balls, short={"loads": "ball_loads"}, drawings=of_slow_balls
)
