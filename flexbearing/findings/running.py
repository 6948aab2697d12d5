"""Limits of life, lubrication, clearance and alignment."""

from math import pi

from flexbearing.findings.finding import DANGER, OUTSIDE, USUAL, Finding

SHORT_LIFE = Finding(
    code="short-life", label="life after all factors", quantity="life",
    at_least=3600.0, grade=DANGER, source="an hour, limit of this program", unit="s", shown="h",
    meaning="the bearing fails at once", action="take a larger bearing, a lower load or speed",
)  # fmt: skip
VISCOSITY_RATIO = Finding(
    code="viscosity-ratio", label="viscosity ratio κ", quantity="viscosity_ratio",
    at_least=1.0, grade=USUAL, source="usual; ISO 281 rates from 0.1", noted=False,
    meaning="surfaces touch through the film",
    action="take an oil {share:.2g} times as viscous, or cool it; else use EP/AW additives",
)  # fmt: skip
FILM_RATIO = Finding(
    code="film-ratio", label="smallest film ratio Λ", quantity="film_ratio",
    at_least=1.0, times="mixed_film_ratio", grade=USUAL, source="asperities carry below", noted=False,
    meaning="asperities carry most of the load",
    action="take smoother raceways, a more viscous or a cooler oil",
)  # fmt: skip
FULL_FILM = 3.0  # film ratio from which surfaces hardly ever touch: no limit, for the words of reports
GYROSCOPIC_MOMENT = Finding(
    code="gyroscopic-moment", label="friction needed to hold the gyroscopic moments",
    quantity="needed_friction", at_most=1.0, times="friction", grade=OUTSIDE, source="friction.coefficient",
    meaning="in reality balls would turn about the rolling direction",
    action='set operation.control = "coulomb", which lets the balls turn',
)  # fmt: skip
CLEARANCE = Finding(
    code="preload", label="diametral clearance", quantity="clearance",
    at_least=0.0, grade=USUAL, source="else preload", unit="m", shown="um", noted=False,
    meaning="the bearing is preloaded",
    action="take looser fits, a larger clearance class or a cooler inner ring",
)  # fmt: skip
RACEWAY_SLOPE = Finding(
    code="raceway-slope", label="slope between the raceways at the most loaded roller",
    quantity="raceway_slope", at_most=4 / 60 * pi / 180, grade=USUAL, unit="rad", shown="mrad", noted=False,
    source="4 arcmin, rule of thumb: range of the edge stress of ISO/TS 16281; that of the maker counts",
    meaning="the ends of rollers are pressed", action="take a stiffer shaft, or align the seats",
)  # fmt: skip
PRESSED_ENDS = Finding(
    code="pressed-end", label="error of the peak pressure of slices", quantity="sliced_peak_error",
    at_most=0.09, grade=OUTSIDE, source="calibrated against half-spaces",
    unit="1", shown="%", of_capacity=False,
    meaning="slices miss the pressure at pressed ends and corners, and life.edge_stress is not made for it",
    action='set bearing.contact = "half_space", or take a profile that relieves the ends',
)  # fmt: skip
