"""What a catalogue page and an application give of a bearing, by the letters of catalogues.

Only words are here: the command line shows them without loading the model of a case.
"""

from collections.abc import Collection
from dataclasses import dataclass

MODELS = (".rexs", ".rexsj", ".rexsz", ".rexs.xml", ".rexs.json", ".rexs.zip")  # endings of gearbox models


@dataclass(frozen=True)
class Entry:
    """A number or a choice that a user gives."""

    option: str
    meaning: str
    letter: str = ""  # of catalogues, which is an option as well
    quantity: str = ""  # of `flexbearing.case.quantity`; none of a whole number or a choice
    key: str = ""  # of the case that lists what may be chosen
    example: str = ""  # of a number

    @property
    def placeholder(self) -> str:
        """What stands for its value in a list of options."""
        return self.quantity.upper() or ("NAME" if self.key else "N")


ENTRIES = {
    "bore": Entry("--bore", "bore", "-d", "Length", example="50 mm"),
    "outside": Entry("--outside", "outside diameter", "-D", "Length", example="90 mm"),
    "width": Entry("--width", "width", "-B", "Length", example="20 mm"),
    "inner_raceway": Entry(
        "--inner-raceway", "diameter of the inner raceway", "-F", "Length", example="59.5 mm"
    ),
    "outer_raceway": Entry(
        "--outer-raceway", "diameter of the outer raceway", "-E", "Length", example="81.5 mm"
    ),
    "pitch_diameter": Entry(
        "--pitch-diameter",
        "diameter of the circle of inclined rollers",
        "--Dpw",
        "Length",
        example="53.5 mm",
    ),
    "angle": Entry(
        "--contact-angle",
        "nominal contact angle, of a cup or barrels by tan = e/1.5",
        "",
        "Angle",
        example="40 deg",
    ),
    "elements": Entry("--elements", "number of rollers or balls, of each row", "-Z", example="16"),
    "diameter": Entry("--diameter", "diameter of the rollers or balls", "--Dw", "Length", example="11 mm"),
    "length": Entry("--length", "effective length of the rollers", "--lw", "Length", example="11.2 mm"),
    "dynamic_rating": Entry(
        "--dynamic-rating", "maker's dynamic load rating", "-C", "Force", example="73.5 kN"
    ),
    "static_rating": Entry(
        "--static-rating", "maker's static load rating", "--C0", "Force", example="69.5 kN"
    ),
    "fatigue_limit": Entry(
        "--fatigue-limit", "maker's fatigue load limit", "--Cu", "Force", example="8.8 kN"
    ),
    "clearance_class": Entry(
        "--clearance-class", "clearance class of ISO 5753", key="bearing.clearance_class"
    ),
    "shaft": Entry("--shaft", "tolerance class of the shaft, ISO 286", key="bearing.fits.shaft"),
    "housing": Entry(
        "--housing", "tolerance class of the housing, ISO 286", key="bearing.fits.housing.tolerance_class"
    ),
    "clearance": Entry(
        "--clearance", "operating diametral clearance, instead of classes", "", "Length", example="30 um"
    ),
    "material": Entry("--material", "material of rollers or balls and of rings", key="materials.inner_ring"),
    "balls": Entry("--balls", "material of the balls, such as Si3N4 of hybrids", key="materials.ball"),
    "oil": Entry("--oil", "oil by name", key="lubricant.oil"),
    "temperature": Entry("--temperature", "temperature of the oil", "", "Temperature", example="70 degC"),
    "cleanliness": Entry("--cleanliness", "cleanliness of the oil by ISO 281", key="life.cleanliness"),
    "load": Entry("--load", "radial load", "", "Force", example="5 kN"),
    "axial": Entry("--axial-load", "axial load", "", "Force", example="3 kN"),
    "speed": Entry("--speed", "speed of the inner ring", "", "Speed", example="3000 rpm"),
    "outer_speed": Entry("--outer-speed", "speed of the outer ring", "", "Speed", example="500 rpm"),
}


@dataclass(frozen=True)
class Like:
    """A kind of bearing that a case can be written for."""

    kind: str  # of the case
    needed: tuple[str, ...]
    two_of: tuple[str, ...]  # any two of them do; what lacks is estimated
    further: tuple[str, ...]  # taken where they are given
    instead: tuple[str, ...] = ()  # that have no place beside a stated clearance

    @property
    def taken(self) -> tuple[str, ...]:
        """Names of all entries, in their order."""
        names = {*self.needed, *self.two_of, *self.further}
        return tuple(name for name in ENTRIES if name in names)

    def has_use(self, name: str, given: Collection[str]) -> bool:
        """Whether an entry still has a use beside those that are given."""
        if name in self.two_of:
            return name not in given and len(self._known(given)) < 2
        beside = self.instead if name == "clearance" else ("clearance",) * (name in self.instead)
        return not {name, *beside} & {*given}

    def must_be_given(self, name: str, given: Collection[str]) -> bool:
        """Whether an entry must be given: of raceways what lacks is estimated, one load of two is enough."""
        by_thrust = name == "load" and "axial" in given and "axial" in self.taken
        return name in self.needed and name not in given and not by_thrust

    def _known(self, given: Collection[str]) -> list[str]:
        return [each for each in self.two_of if each in given]


_RATINGS = ("dynamic_rating", "static_rating", "fatigue_limit")
_OIL = ("oil", "temperature", "cleanliness")
_RACEWAYS = ("inner_raceway", "outer_raceway", "diameter")
_SIZE = ("bore", "outside", "width")
_ROLLERS = (
    *_RATINGS, "elements", "length", "clearance_class", "shaft", "clearance", "material", *_OIL,
)  # fmt: skip
_ROLLING = ("elements", "diameter", "length", "material")
_MOUNTED = ("clearance_class", "shaft", "housing")
_BALLS = (*_RATINGS, "elements", "diameter", "material", "balls")
_CYLINDERS = Like(
    "cylindrical_roller",
    (*_SIZE, "load", "speed"),
    _RACEWAYS,
    (*_ROLLERS, "housing", "outer_speed"),
    _MOUNTED,
)
LIKES = {
    "cylindrical_roller": _CYLINDERS,
    "needle_roller": _CYLINDERS,  # with machined rings, which ISO 281 rates alike
    "squirrel_cage": Like("cylindrical_roller", (*_SIZE, "load", "speed"), _RACEWAYS, _ROLLERS, _MOUNTED),
    "deep_groove_ball": Like(
        "deep_groove_ball",
        (*_SIZE, "load", "speed"),
        (),
        (*_BALLS, *_MOUNTED, *_OIL, "clearance", "axial", "outer_speed"),
        _MOUNTED,
    ),
    "angular_contact_ball": Like(
        "angular_contact_ball",
        (*_SIZE, "angle", "axial", "speed"),
        (),
        (*_BALLS, *_OIL, "shaft", "housing", "load", "outer_speed"),
    ),
    "tapered_roller": Like(
        "tapered_roller",
        (*_SIZE, "angle", "axial", "speed"),
        (),
        (*_RATINGS, "pitch_diameter", *_ROLLING, *_OIL, "shaft", "housing", "load", "outer_speed"),
    ),
    "thrust_roller": Like(
        "thrust_roller",
        (*_SIZE, "axial", "speed"),
        (),
        (*_RATINGS, "pitch_diameter", *_ROLLING, *_OIL, "outer_speed"),
    ),
    "spherical_roller": Like(
        "spherical_roller",
        (*_SIZE, "angle", "load", "speed"),
        (),
        (*_RATINGS, "pitch_diameter", *_ROLLING, *_OIL, "clearance", "axial", "outer_speed"),
    ),
    "four_point_ball": Like(  # there are no load ratings of two contacts on a ring
        "four_point_ball",
        (*_SIZE, "axial", "speed"),
        (),
        ("elements", "diameter", "material", "balls", "angle", "load"),
    ),
}
