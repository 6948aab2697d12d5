"""The operating clearance of a case: stated, or computed from its fits."""

from importlib import import_module
from typing import TYPE_CHECKING, Any, Protocol, Self

from flexbearing.case.tolerances import CLEARANCE, HOUSING, SHAFT, Band, Place
from quasidynamic.note import Note, information

if TYPE_CHECKING:
    from quasidynamic.clearance import OperatingClearance

ROLLERS = "cylindrical_roller"  # the kind of bearing whose fits may be those of finite elements
OF_ROLLERS = {ROLLERS: "fits", "tapered_roller": "tapered_fits"}  # modules that compute them


class Case(Protocol):
    """What cases of rollers and of fast balls have in common; the former load nothing of the latter."""

    @property
    def kind(self) -> str:
        """Family of the bearing."""
        ...

    @property
    def bearing(self) -> Any:
        """The bearing, with its mounting."""
        ...

    @property
    def operation(self) -> Any:
        """Loads, speeds and temperatures."""
        ...

    @property
    def bands(self) -> dict[str, Band]:
        """Key of each class of clearance and fits, to what it allows [m]."""
        ...

    @property
    def place(self) -> Place:
        """Where classes are taken within their tolerances."""
        ...

    @property
    def stated_clearance(self) -> float:
        """The clearance that the case gives, operating or before mounting [m]."""
        ...

    @property
    def shaft_interference(self) -> float:
        """Diametral interference of shaft and inner ring, cold [m]."""
        ...

    @property
    def housing_interference(self) -> float | None:
        """Diametral interference of outer ring and housing, cold [m]."""
        ...

    def within_tolerances(self, place: Place) -> Self:
        """The same case with its classes taken at another place within their tolerances."""
        ...


def operating(case: Case) -> float:
    """Operating diametral clearance [m], negative is a preload."""
    chain = computed(case)
    return case.stated_clearance if chain is None else chain.clearance


def computed(case: Case) -> "OperatingClearance | None":
    """Steps from the cold to the operating clearance; None when the case states the latter."""
    if case.bearing.mounting is None:
        return None
    module = OF_ROLLERS.get(case.kind, "ball_fits")
    return import_module(f"flexbearing.build.{module}").from_fits(case)


def record(case: Case) -> dict[str, Any]:
    """The clearance and how it came about, for the result file; lengths are diametral."""
    chain = computed(case)
    if chain is None:
        return {"operating_m": operating(case), "steps": [], **_of_classes(case)}
    return {
        "operating_m": chain.clearance,
        "cold_m": chain.cold,
        "steps": [
            {
                "name": step.name,
                "change_m": step.change,
                "clearance_m": step.clearance,
                "explanation": step.explanation,
            }
            for step in chain.steps
        ],
        "shaft_fit": chain.shaft_seat.words,
        "housing_fit": chain.housing_seat.words if chain.housing_seat else "free ring, no housing",
        "verdict": chain.verdict,
        **_of_classes(case),
    }


def _of_classes(case: Case) -> dict[str, Any]:
    """Tolerance bands of the classes that the case names, and the clearance at both ends; empty without."""
    if not case.bands:
        return {}
    bearing = case.bearing
    fits: Any = bearing.fits
    values = {  # of the classes that are given
        CLEARANCE: lambda: ("clearance", bearing.clearance_class, case.stated_clearance),
        SHAFT: lambda: ("shaft", fits.shaft, case.shaft_interference),
        HOUSING: lambda: ("housing", fits.housing.tolerance_class, case.housing_interference),
    }
    classes = []
    for path, band in case.bands.items():
        of, name, used = values[path]()
        limits = {"least_m": band.least, "greatest_m": band.greatest}
        classes.append({"name": of, "class": name, "used_m": used, **limits})
    tolerances: dict[str, Any] = {"at": case.place, "classes": classes}
    if bearing.mounting:
        ends = {"loosest_m": _at_end(case, "loosest"), "tightest_m": _at_end(case, "tightest")}
        tolerances["ends"] = ends
    return {"tolerances": tolerances}


def _at_end(case: Case, place: Place) -> float:
    """Operating clearance at an end of the tolerances [m]; the chain alone is computed, no bearing."""
    return operating(case.within_tolerances(place))


def notes(case: Case) -> tuple[Note, ...]:
    """Say so when the bearing runs under preload, and between which clearances its classes leave it."""
    elements = "rollers" if case.kind == ROLLERS else "balls"
    clearance, within = operating(case), ()
    if case.bands and case.bearing.mounting:
        within = (_tolerance_note(case, clearance),)
    if clearance >= 0.0:
        return within
    return (
        information(
            "preload",
            f"clearance: the bearing is preloaded, its {elements} interfere by "
            f"{-clearance * 1e6:.1f} um diametral",
        ),
        *within,
    )


def _state(case: Case) -> str:
    """Of what bearing the computed clearance is: without temperatures not of a warm one."""
    return "in operation" if case.operation.temperatures else "mounted and turning, all parts equally warm"


def _tolerance_note(case: Case, clearance: float) -> Note:
    loosest, tightest = _at_end(case, "loosest"), _at_end(case, "tightest")
    words = (
        f"clearance: the tolerances of the fits leave {tightest * 1e6:.1f} to {loosest * 1e6:.1f} um "
        f'{_state(case)}; computed with {clearance * 1e6:.1f} um, bearing.fits.at = "{case.place}"'
    )
    return information("fit-tolerances", words + (", and preload at the tight end" if tightest < 0 else ""))
