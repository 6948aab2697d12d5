"""By which rules lives are computed, with the editions of standards, in words."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from flexbearing.case.balls.angular_contact import FastCase
    from flexbearing.case.balls.four_point import FourPointCase
    from flexbearing.case.ratings import Life
    from flexbearing.case.roller import Case
    from flexbearing.case.tapered import TaperedCase

BY_LOADS, RADIAL, AXIAL = "ISO/TS 16281:2008", "C_r of ISO 281:2007", "C_a of ISO 281:2007, thrust bearings"
GIVEN, A_ISO, A_1 = "a given rating", "a_ISO of ISO 281:2007, once for the bearing", "a_1 of ISO 281:2007"
A_ISO_OF_PARTS = "a_ISO of ISO 281:2007 for each of its {}, by formulas of a public program"
BY_DAMAGE, GUIDELINE = "oscillation by the damage of each arc", "oscillation by NREL DG03:2009"


def of_rollers(case: "Case") -> str:
    """Rules of a roller bearing: that of `life_L10`, then those of further lives where the case has them."""
    life = case.life
    further = *_of_capacity(life), *_factors(life.lubrication, life.reliability, _modification(life))
    return "; ".join(("Lundberg and Palmgren (1952)", *further))


def _of_capacity(life: "Life") -> Iterator[str]:
    rated = GIVEN if life.dynamic_rating else RADIAL
    if life.loads == "rating":
        yield f"(C_r/P)^({life.load_exponent}) of ISO 281:2007, {rated}"
    elif life.capacity == "iso281":
        yield f"{BY_LOADS}, {rated}{', edge stress' if life.edge_stress else ''}"


def of_elements(case: "FastCase | TaperedCase") -> str:
    """Rules of a bearing with fast balls or tapered rollers."""
    life, exponent = case.life, "(10/3)" if case.kind.endswith("roller") else "3"
    rated = GIVEN if life.dynamic_rating else AXIAL if case.kind == "thrust_roller" else RADIAL
    of_rating = [f"(C_r/P)^{exponent} of ISO 281:2007, {rated}"] if life.loads == "rating" else []
    further = _factors(life.lubrication, life.reliability, _modification(life))
    return "; ".join([f"{BY_LOADS}, {rated}", *of_rating, *further])


def of_arcs(case: "FourPointCase", *, thrust: bool) -> str:
    """Rules of a four-point bearing, rated as a thrust bearing or as a radial one."""
    rules = [f"{BY_LOADS} for each arc, {GIVEN if case.life.dynamic_rating else AXIAL if thrust else RADIAL}"]
    if case.operation.oscillation is not None:
        rules.append(GUIDELINE if case.life.oscillation == "DG03" else BY_DAMAGE)
    return "; ".join([*rules, *_factors(None, case.life.reliability)])


def _modification(life: Any) -> str:
    """What has an a_ISO of its own; under one load of a catalogue the bearing alone."""
    return "bearing" if life.loads == "rating" else life.modification


def _factors(
    lubrication: str | None, reliability: float | None, modification: str = "bearing"
) -> Iterator[str]:
    if lubrication == "film":
        yield "film factor of STLE"
    elif lubrication:
        yield A_ISO if modification == "bearing" else A_ISO_OF_PARTS.format(modification)
    if reliability is not None:
        yield A_1
