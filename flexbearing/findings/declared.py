"""Which findings a bearing of a kind is judged by, in the order of their notes."""

from flexbearing.findings.finding import Finding
from flexbearing.findings.load_limits import (
    CONTACT_PRESSURE,
    HEAVY_LOAD,
    LIGHT_LOAD_OF_BALLS,
    LIGHT_LOAD_OF_ROLLERS,
    LOAD_ABOVE_STATIC_RATING,
    RATINGS,
    RIBS,
    STATIC_SAFETY,
    USUAL_STATIC_SAFETY,
    YIELD_STRESS,
)
from flexbearing.findings.neglected import (
    CONTACT_HEIGHT,
    MUCH_NEGLECTED,
    NEGLECTED,
    REVERSED_THRUST,
)
from flexbearing.findings.running import (
    CLEARANCE,
    CUT_ELLIPSE,
    FILM_RATIO,
    GYROSCOPIC_MOMENT,
    GYROSCOPIC_SLIP,
    LEAST_STIFFNESS,
    LIMITING_SPEED,
    PRESSED_ENDS,
    RACEWAY_SLOPE,
    RATED_VISCOSITY_RATIO,
    REFERENCE_SPEED,
    REQUIRED_LIFE,
    RIB_CONTACT,
    SEVERAL_MOTIONS,
    SHORT_LIFE,
    SMALL_OSCILLATION,
    STIFFNESS_IN_SERIES,
    VISCOSITY_RATIO,
)

OF_ROLLERS = (
    CONTACT_PRESSURE,
    STATIC_SAFETY,
    USUAL_STATIC_SAFETY,
    SHORT_LIFE,
    REQUIRED_LIFE,
    YIELD_STRESS,
    HEAVY_LOAD,
    LIGHT_LOAD_OF_ROLLERS,
    VISCOSITY_RATIO,
    RATED_VISCOSITY_RATIO,
    FILM_RATIO,
    CLEARANCE,
    RACEWAY_SLOPE,
    PRESSED_ENDS,
    *RIBS,
    *RATINGS,
    STIFFNESS_IN_SERIES,
    LEAST_STIFFNESS,
    MUCH_NEGLECTED,
    NEGLECTED,
)
OF_BALLS = (
    CONTACT_PRESSURE,
    HEAVY_LOAD,
    LOAD_ABOVE_STATIC_RATING,
    LIGHT_LOAD_OF_BALLS,
    SHORT_LIFE,
    REQUIRED_LIFE,
    YIELD_STRESS,
    STATIC_SAFETY,
    GYROSCOPIC_MOMENT,
    SEVERAL_MOTIONS,
    VISCOSITY_RATIO,
    RATED_VISCOSITY_RATIO,
    CLEARANCE,
    *RATINGS,
    LEAST_STIFFNESS,
    MUCH_NEGLECTED,
    NEGLECTED,
    REVERSED_THRUST,
    CONTACT_HEIGHT,
)
OF_TAPERED = (
    CONTACT_PRESSURE,
    STATIC_SAFETY,
    USUAL_STATIC_SAFETY,
    SHORT_LIFE,
    REQUIRED_LIFE,
    HEAVY_LOAD,
    LIGHT_LOAD_OF_ROLLERS,
    VISCOSITY_RATIO,
    RATED_VISCOSITY_RATIO,
    RIB_CONTACT,
    *RATINGS,
    LEAST_STIFFNESS,
    MUCH_NEGLECTED,
    NEGLECTED,
)
OF_THRUST_ROLLERS = tuple(  # which makers give another least load; washers hold no ring along y and z
    each for each in OF_TAPERED if each not in (LIGHT_LOAD_OF_ROLLERS, RIB_CONTACT, LEAST_STIFFNESS)
)
OF_SPHERICAL_ROLLERS = (*(each for each in OF_TAPERED if each is not RIB_CONTACT), CUT_ELLIPSE)
OF_SLOW_BALLS = (  # which need no load against skidding
    *(finding for finding in OF_BALLS if finding is not LIGHT_LOAD_OF_BALLS),
    GYROSCOPIC_SLIP,
    SMALL_OSCILLATION,
)
OF_SPEEDS = (LIMITING_SPEED, REFERENCE_SPEED)  # of a maker's table, which a selection judges
DECLARED = tuple(
    dict.fromkeys((*OF_ROLLERS, *OF_BALLS, *OF_SLOW_BALLS, *OF_TAPERED, *OF_SPHERICAL_ROLLERS, *OF_SPEEDS))
)


def of_selection(rollers: bool) -> tuple[Finding, ...]:
    """What a catalogue's ratings are judged by: life, static safety, loads, speeds."""
    by_ratings = {REQUIRED_LIFE, STATIC_SAFETY, USUAL_STATIC_SAFETY, HEAVY_LOAD, LOAD_ABOVE_STATIC_RATING}
    light = {LIGHT_LOAD_OF_ROLLERS, LIGHT_LOAD_OF_BALLS}
    of_kind = OF_ROLLERS if rollers else OF_BALLS
    return (*(each for each in of_kind if each in by_ratings | light), *OF_SPEEDS)


def is_declared(code: str, grade: str) -> bool:
    """Whether a stored code with its grade is of a finding of this program."""
    return any((each.code, each.grade) == (code, grade) for each in DECLARED)


def of_code(code: str, grade: str) -> Finding:
    """What is declared of a stored record; of several with one code and grade, words are alike."""
    return next(each for each in DECLARED if (each.code, each.grade) == (code, grade))
