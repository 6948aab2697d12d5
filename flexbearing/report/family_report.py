"""How results of one bearing family are shown."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from flexbearing.case.family import Entry
from flexbearing.outputs import AbsentOutput
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from flexbearing.report.balls.contact_fields import DrawnBall
    from flexbearing.report.drawing import Drawing
    from flexbearing.report.drawing.words import Words


@dataclass(frozen=True)
class Plots:
    """Pictures as functions without arguments; `dir` names them."""

    pictures: Callable[[], Mapping[str, Figure | str]]  # by names of files; or why one would be empty
    short: Mapping[str, str]  # names to those of files

    def __dir__(self) -> list[str]:
        return sorted({*self.short, *self.pictures()})

    def __getattr__(self, name: str) -> Callable[[], Figure]:
        if name.startswith("_"):
            raise AttributeError(name)

        def plot() -> Figure:
            drawn = self.pictures()
            figure = drawn.get(self.short.get(name, name), "is no picture of this result")
            if isinstance(figure, str):
                raise AbsentOutput(f"plot.{name}: {figure}; there are {', '.join(dir(self))}.")
            return figure

        return plot


@dataclass(frozen=True)
class Elements:
    """Which quantities of rolling elements a report shows; those that a result lacks are left out."""

    word: str  # "roller"
    azimuth: str  # quantity of their places
    columns: tuple[str, ...]  # of the table with a row for each
    figures: dict[str, tuple[str, ...]]  # over the azimuth: title to quantities of one unit
    contact_figures: dict[str, tuple[str, ...]]  # the same, of films and pressures
    maps: dict[str, tuple[str, str]] = field(default_factory=dict)  # quantities of slices: title, unit


@dataclass(frozen=True)
class FamilyReport:
    """Pictures of a result, as an `Entry` each: the card of a result loads none."""

    # by names of files; or why one would be empty
    pictures: Callable[[], Callable[[Result], Mapping[str, Figure | str]]]
    drawings: Callable[[], Callable[[Words], Iterator[Drawing]]]  # to scale, of a case
    elements: Elements | None = None  # rolling elements that a report shows one by one
    deformed: bool = False  # whether deformed rings can be drawn
    balls: Callable[[], Callable[[Result], tuple[DrawnBall, ...]]] | None = None  # whose cells a result holds
    short: Mapping[str, str] = field(default_factory=dict)  # names of pictures in notebooks to those of files

    def plots(self, result: Result) -> Plots:
        """Pictures of a result as functions."""
        return Plots(lambda: self.pictures()(result), self.short)


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
    pictures=Entry("flexbearing.report.roller.figures:pictures"),
    elements=ELEMENTS,
    deformed=True,
    short=SHORT,
    drawings=Entry("flexbearing.report.drawing.of_case:of_rollers"),
)


_CONTACTS = {
    "peak pressure": ("peak_pressure",),
    "semi-axis across rolling": ("semi_axis_across",),
    "semi-axis along rolling": ("semi_axis_along",),
}
_COLUMNS = ("ball_azimuth", "contact_load", "contact_angle", "peak_pressure")
_FIGURES = {"contact load": ("contact_load",), "contact angle": ("contact_angle",)}


def _of_balls(columns: tuple[str, ...], figures: dict[str, tuple[str, ...]], drawings: str) -> FamilyReport:
    """How results of slow or fast balls are shown, with what they have beside loads and angles."""
    return FamilyReport(
        pictures=Entry("flexbearing.report.balls.figures:pictures"),
        elements=Elements(
            word="ball",
            azimuth="ball_azimuth",
            columns=(*_COLUMNS, *columns),
            figures=_FIGURES | figures,
            contact_figures=_CONTACTS,
        ),
        balls=Entry("flexbearing.report.balls.figures:balls"),
        short={"loads": "ball_loads"},
        drawings=Entry(f"flexbearing.report.drawing.of_case:{drawings}"),
    )


FOUR_POINT = _of_balls((), {"torque of a ball": ("ball_torque",)}, "of_slow_balls")
ANGULAR_CONTACT = _of_balls(
    ("orbital_speed", "ball_speed"),
    {"orbital speed": ("orbital_speed",), "gyroscopic moment": ("gyroscopic_moment",)},
    "of_fast_balls",
)
TAPERED = FamilyReport(
    pictures=Entry("flexbearing.report.roller.figures:tapered_pictures"),
    drawings=Entry("flexbearing.report.drawing.of_case:of_tapered_rollers"),
    elements=Elements(
        word="roller",
        azimuth="roller_azimuth",
        columns=("roller_azimuth", "inner_load", "outer_load", "rib_load", "rib_pressure", "roller_tilt"),
        figures={
            "contact load": ("inner_load", "outer_load"),
            "rib load": ("rib_load",),
            "tilt of the rollers": ("roller_tilt",),
        },
        contact_figures={"rib pressure": ("rib_pressure",)},
        maps=ELEMENTS.maps,
    ),
    short={"loads": "roller_loads", "pressure": "pressure_along"},
)
THRUST = replace(TAPERED, drawings=Entry("flexbearing.report.drawing.of_case:of_thrust_rollers"))
SPHERICAL = replace(TAPERED, drawings=Entry("flexbearing.report.drawing.of_case:of_spherical_rollers"))
