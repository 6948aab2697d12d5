"""How results of a fast angular-contact ball bearing are shown."""

from flexbearing.case.family import Entry
from flexbearing.report.family_report import Elements, FamilyReport

ELEMENTS = Elements(
    word="ball",
    azimuth="ball_azimuth",
    columns=("ball_azimuth", "contact_load", "contact_angle", "peak_pressure", "orbital_speed", "ball_speed"),
    figures={
        "contact load": ("contact_load",),
        "contact angle": ("contact_angle",),
        "orbital speed": ("orbital_speed",),
        "gyroscopic moment": ("gyroscopic_moment",),
    },
    contact_figures={
        "peak pressure": ("peak_pressure",),
        "semi-axis across rolling": ("semi_axis_across",),
        "semi-axis along rolling": ("semi_axis_along",),
    },
)
REPORT = FamilyReport(
    page=Entry("flexbearing.report.balls.angular_contact_page:page"),
    pictures=Entry("flexbearing.report.balls.angular_contact_figures:pictures"),
    elements=ELEMENTS,
    balls=Entry("flexbearing.report.balls.angular_contact_figures:balls"),
    short={"loads": "ball_loads"},
    drawings=Entry("flexbearing.report.drawing.of_case:of_fast_balls"),
)
