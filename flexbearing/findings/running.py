"""Limits of life, lubrication, clearance and alignment."""

from dataclasses import replace
from math import pi

from flexbearing.findings.finding import DANGER, OUTSIDE, USUAL, Finding

SHORT_LIFE = Finding(
    code="short-life", label="life after all factors", quantity="life",
    at_least=3600.0, grade=DANGER, source="an hour, limit of this program", unit="s", shown="h",
    meaning="the bearing fails at once", action="take a larger bearing, a lower load or speed",
)  # fmt: skip
REQUIRED_LIFE = Finding(
    code="required-life", label="life against the required one", quantity="life_to_reach",
    at_least=1.0, times="required_life", grade=DANGER, source="required life of the case",
    unit="s", shown="h",
    meaning="the required life is not reached",
    action="take a bearing with a longer life, a lower load, a cleaner, cooler or more viscous oil",
)  # fmt: skip
LIMITING_SPEED = Finding(
    code="limiting-speed", label="largest speed", quantity="speed",
    at_most=1.0, times="limiting_speed", grade=DANGER, source="limiting speed of the maker",
    unit="rad/s", shown="rpm",
    meaning="beyond what cage, seals and balance of the bearing are made for",
    action="take a smaller bearing, another cage or open sides, or ask the maker",
)  # fmt: skip
REFERENCE_SPEED = replace(
    LIMITING_SPEED,
    code="reference-speed",
    times="reference_speed",
    grade=USUAL,
    source="reference speed of the maker, ISO 15312",
    meaning="warmer than at the thermal reference conditions unless load, oil or cooling differ from them",
    action="take a smaller bearing, less or thinner oil, cooling, or compute its heat",
)
VISCOSITY_RATIO = Finding(
    code="viscosity-ratio", label="viscosity ratio κ", quantity="viscosity_ratio",
    at_least=1.0, grade=USUAL, source="usual; ISO 281 rates from 0.1", noted=False,
    meaning="surfaces touch through the film",
    action="take an oil {share:.2g} times as viscous, or cool it; else use EP/AW additives",
)  # fmt: skip
NO_MODIFIED_LIFE = "no-modified-life"  # code of notes on a life that is left out
RATED_VISCOSITY_RATIO = Finding(
    code=NO_MODIFIED_LIFE, label="viscosity ratio of a_ISO", quantity="rated_viscosity_ratio",
    at_least=0.1, grade=OUTSIDE, source="ISO 281 (2007)",
    meaning="no a_ISO holds there, the modified life is left out",
    action="take an oil {share:.2g} times as viscous, or cool it",
    of_model=True,
)  # fmt: skip
FILM_RATIO = Finding(
    code="film-ratio", label="smallest film ratio Λ", quantity="film_ratio",
    at_least=1.0, times="mixed_film_ratio", grade=USUAL, source="asperities carry below", noted=False,
    meaning="asperities carry most of the load",
    action="take smoother raceways, a more viscous or a cooler oil",
)  # fmt: skip
SMALL_OSCILLATION = Finding(
    code="small-oscillation", label="way of an oscillation over the width of the contacts",
    quantity="rolled_widths", at_least=1.0, grade=OUTSIDE,
    source="below it no place is rolled over; Hertz, rolling",
    meaning="raceways wear by fretting (false brinelling), which no life contains",
    action="turn the bearing further from time to time, with a grease for small oscillations",
)  # fmt: skip
GYROSCOPIC_MOMENT = Finding(
    code="gyroscopic-moment", label="friction needed to hold the gyroscopic moments",
    quantity="needed_friction", at_most=1.0, times="friction", grade=OUTSIDE,
    source="friction coefficient of the case",
    meaning="in reality balls would turn about the rolling direction",
    action="compute how far the balls turn", keys=(("operation.control", "coulomb"),),
)  # fmt: skip
GYROSCOPIC_SLIP = replace(
    GYROSCOPIC_MOMENT,
    code="gyroscopic-slip",
    quantity="held_friction",
    meaning="in reality balls turn about the rolling direction: torque and angles are estimates",
    action="raise the load or lower the speed",
    keys=(),
)
SEVERAL_MOTIONS = Finding(
    code="several-equilibria", label="difference of the axial forces of the stable motions at this place",
    quantity="force_of_motions", at_most=0.01, grade=DANGER, source="assumed", unit="1", shown="%",
    meaning="balls and cage of a held ring run fast or slow, by what was before; the computed motion is one",
    action="give the axial load in place of the displacement, or a larger preload",
    of_model=True,
)  # fmt: skip
STIFFNESS_IN_SERIES = Finding(
    code="stiffness-not-in-series", label="bearing and supports in series, off the stiffness with supports",
    quantity="series_error", at_most=0.02, grade=OUTSIDE, source="limit of this program", shown="%",
    meaning="supports bend the rings by the loads of the bearing, these are no two springs: the stiffness of "
    "bearing and supports alone is left out",
    action="use the stiffness with supports, or the matrix, without supports in the rotor model",
    of_model=True,
)  # fmt: skip
LEAST_STIFFNESS = Finding(
    code="no-positive-stiffness", label="smallest radial stiffness", quantity="least_stiffness",
    at_least=0.0, grade=OUTSIDE, source="a stable support", unit="N/m", shown="kN/mm",
    meaning="the tangent at this state pushes the ring away: a rotor on it is not stable",
    action="take the stiffness over a range of displacements, or another clearance or load",
    of_model=True,
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
    at_most=0.095, grade=OUTSIDE, source="calibrated against half-spaces",
    unit="1", shown="%", of_model=True,
    meaning="slices miss the pressure at pressed ends and corners, which the edge stress factor is not for",
    action="compute whole contacts, or take a profile that relieves the ends",
    keys=(("bearing.contact", "half_space"),),
)  # fmt: skip
CUT_ELLIPSE = Finding(
    code="contact-at-roller-end", label="pressure at the ends of rollers over the largest one",
    quantity="end_pressure", at_most=0.745, grade=OUTSIDE, unit="1", of_model=True,
    source="there the ellipse is 1.5 times as long as the roller: edge loading of Lundberg and Palmgren",
    meaning="the roller ends inside its contact: the pressure at its edge is larger than slices have",
    action="take a smaller osculation, longer rollers or a lower load",
)  # fmt: skip
RIB_CONTACT = Finding(
    code="rib-contact", label="reach of the rib contact on the roller's end, over its radius",
    quantity="rib_reach", at_most=1.0, grade=OUTSIDE, source="there the end is chamfered", of_model=True,
    meaning="the end of the roller presses its edge into the rib: pressure and heat are larger",
    action="take a rib angle closer to the axis of the rollers, or a lower load",
)  # fmt: skip
PEAK_AT_ENDS = {PRESSED_ENDS.code, "sharp-roller-end", "sliced-peak"}  # notes: slices do not have the peak
