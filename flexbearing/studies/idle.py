"""Rows of a duty cycle that are time without damage: standstill, and no load."""

from collections.abc import Mapping
from hashlib import sha256
from typing import Any

from flexbearing.build import clearance
from flexbearing.case import Head
from flexbearing.case.declarations import by_path
from flexbearing.case.variants import Variants
from flexbearing.families import FAMILIES
from flexbearing.studies.plan import Variant
from flexbearing.studies.plan.task import LENGTH, Idle, Values
from flexbearing.studies.table.duty import BASIC, MODIFIED, is_load
from quasidynamic import ImpossiblePart, OutOfRange
from quasidynamic.outcome.life_factors import LEAST_VISCOSITY_RATIO

SPEEDS = "operation.inner_speed", "operation.outer_speed"
STANDSTILL = "standstill: time without damage"
NO_LOAD = "no load: time without damage"


def idle(read: Variants, values: Values) -> Variant | None:
    """The row without damage that some values make; None where it must be computed.

    Cases of rows at standstill, or have no load to be rated by, cannot be read: speeds and loads are then
    taken from the row, everything else from the case without them.

    Raises `BadCase` where the case without them cannot be read.
    """
    own = {
        key: value
        for key, value in zip(read.keys, values, strict=True)
        if value is not None and (key in SPEEDS or is_load(key))
    }
    if SPEEDS[1] not in own and not any(map(_is_zero, own.values())):
        return None
    case: Any = read.case(
        tuple(None if key in own else value for key, value in zip(read.keys, values, strict=True))
    )
    try:
        own = {key: by_path(type(case))[key].reader(value) for key, value in own.items()}
    except ValueError:
        return None  # what is wrong is reported of the whole row
    inner, outer = (own.get(key, getattr(case.operation, key.partition(".")[2])) for key in SPEEDS)
    if why := STANDSTILL if inner == outer else NO_LOAD * _is_unloaded(case, own):
        identity = sha256(f"{why} {inner - outer}".encode()).hexdigest()[:LENGTH]
        in_si = (own.get(key, known) for key, known in zip(read.keys, read.in_si(case), strict=True))
        return Variant(values, identity, in_si=tuple(in_si), idle=Idle(why, inner - outer))
    return None


def _is_zero(written: Any) -> bool:
    """Whether a quantity in the words of a case file is 0, in any unit."""
    return (
        isinstance(written, str)
        and written.lstrip(" +-").startswith(("0", ".", ","))
        and not any(digit in written.partition(" ")[0].lower().partition("e")[0] for digit in "123456789")
    )


def _is_unloaded(case: Any, own: dict[str, Any]) -> bool:
    """Whether nothing presses the rolling elements: no load, no preload, no tilt that takes the clearance."""
    operation = case.operation
    if case.kind == clearance.ROLLERS:
        loads = {"operation.radial_load": operation.radial_load, "operation.moment": operation.moment}
    else:
        loads = {
            f"operation.load.{name}": getattr(operation.load, name)
            for name in type(operation.load).model_fields
        }
        if operation.is_pressed:
            return False
    if any((loads | own)[key] for key in loads):
        return False
    if case.life.loads == "rating":
        return True
    pair = getattr(case.bearing, "pair", None)
    if pair is not None and (pair.preload or (pair.offset or 0.0) > 0):
        return False
    try:
        if case.kind in ("tapered_roller", "thrust_roller", "spherical_roller"):
            from flexbearing.build.tapered_bearing import bearing

            apart = case.bearing.radial_clearance >= 0 and bearing(case).rows[0].closer <= 0
            return apart or not case.bearing.opposed  # nothing presses a free ring on its rollers
        tilted = (
            abs(operation.model_copy(update={"radial_load": 0.0}).slope) * case.bearing.roller.length
            if case.kind == clearance.ROLLERS
            else 0.0
        )
        return clearance.operating(case) >= tilted
    except (ImpossiblePart, OutOfRange):
        return False


LEAST_FACTOR = 0.1  # a_ISO of rollers and of balls at kappa = 0.1, at any load


def too_thin(case: Any) -> str:
    """Why a case has no a_ISO where its viscosity ratio is too small; empty where it has one."""
    catalogue = FAMILIES[case.kind].catalogue
    kappa = catalogue().rated(case).rated_kappa if catalogue else None
    if kappa is None or kappa >= LEAST_VISCOSITY_RATIO:
        return ""
    return f"kappa {kappa:.3g} is below {LEAST_VISCOSITY_RATIO}: bounded by a_ISO = {LEAST_FACTOR}, its least"


def without_factor(case: Any) -> Head:
    """The case without a_ISO."""
    life = case.life.model_copy(update={"lubrication": None, "cleanliness": None})
    return case.model_copy(update={"life": life})


def bounded(values: Mapping[str, float]) -> dict[str, float]:
    """Numbers of a row that was computed without a_ISO, its modified life with the least one."""
    rated = {text: number for text, number in values.items() if "modified_life" not in text}
    if (life := values.get(MODIFIED, values.get(BASIC))) is not None:
        rated[MODIFIED] = LEAST_FACTOR * life
    return rated
