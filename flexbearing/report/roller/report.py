"""How results of a cylindrical roller bearing are shown."""

from flexbearing.case.family import Entry
from flexbearing.report.family_report import Elements, FamilyReport

ELEMENTS = Elements(
    word="roller",
    azimuth="roller_azimuth",
    columns=(
        "roller_azimuth",
        "inner_load",
        "outer_load",
        "inner_film",
        "outer_film",
        "inner_film_ratio",
        "outer_film_ratio",
        "roller_tilt",
        "roller_slip",
        "cage_force",
        "roller_skew",
    ),
    figures={
        "contact load": ("inner_load", "outer_load"),
        "slip of the rollers": ("roller_slip",),
        "tilt of the rollers": ("roller_tilt",),
        "pocket force": ("cage_force",),
    },
    contact_figures={
        "film thickness": ("inner_film", "outer_film"),
        "film ratio": ("inner_film_ratio", "outer_film_ratio"),
    },
    maps={
        "inner_pressure": ("Contact pressure at the inner raceway", "MPa"),
        "outer_pressure": ("Contact pressure at the outer raceway", "MPa"),
    },
)
SHORT = {"loads": "roller_loads", "pressure": "pressure_along", "deviation": "raceway_deviation"}
REPORT = FamilyReport(
    page=Entry("flexbearing.report.roller.page:page"),
    pictures=Entry("flexbearing.report.roller.figures:pictures"),
    elements=ELEMENTS,
    deformed=True,
    short=SHORT,
    drawings=Entry("flexbearing.report.drawing.of_case:of_rollers"),
)
