"""How far a key may be from its value: where no source gives it, in one realistic step, and as a lever."""

from collections.abc import Callable
from dataclasses import dataclass
from fnmatch import fnmatchcase
from math import inf, pi

THUMB = "rule of thumb"
Range = Callable[[float], tuple[float, ...]]  # of a value in SI units
Interval = Callable[[float], tuple[float, float]]


def times(*factors: float) -> Range:
    """A range by factors of the value."""
    return lambda value: tuple(factor * value for factor in factors)


def plus(*steps: float) -> Range:
    """A range by steps from the value, in SI units."""
    return lambda value: tuple(value + step for step in steps)


def instead(*others: float) -> Range:
    """A range of other values, in SI units."""
    return lambda _: others


def within(factor: float) -> Interval:
    """From a part of the value to as many times the value."""
    return lambda value: (min(value / factor, value * factor), max(value / factor, value * factor))


def about(distance: float, least: float = -inf) -> Interval:
    """So far to either side of the value, in SI units."""
    return lambda value: (max(value - distance, least), value + distance)


@dataclass(frozen=True)
class KeyRange:
    """What is realistic for the keys of a pattern."""

    keys: str  # a pattern
    plausible: Range  # other values, where no source gives it
    source: str  # of these
    step: float = 0.1  # realistic change of a value that is known: a share of it, or in SI units
    absolute: bool = False  # whether the step is in SI units
    lever: Interval | None = None  # values between which a goal is searched; None: nobody designs it

    def step_of(self, value: float, unit: str) -> float:
        """Realistic step of a value, in SI units; of zero by the unit."""
        if self.absolute:
            return self.step
        return self.step * abs(value) or FROM_ZERO.get(unit, (self.step,))[0]

    def interval(self, value: float, unit: str) -> tuple[float, float] | None:
        """Values between which a goal is searched; of zero some steps to either side."""
        if self.lever is None:
            return None
        if value == 0 and not self.absolute:
            return about(MOST_STEPS * self.step_of(value, unit))(value)
        return self.lever(value)


def _temperature(keys: str, spread: float, *, lever: bool = True) -> KeyRange:
    return KeyRange(keys, plus(-spread, spread), THUMB, 5.0, True, about(60.0, 250.0) if lever else None)


TWO_DEG, RIB = pi / 90, pi / 900
MOST_STEPS = 20  # to either side of zero
_ANY = within(3.0)
_FIFTH = times(0.8, 1.25), f"a fifth less, a quarter more: {THUMB}"
_CLEARANCE = {"step": 5e-6, "absolute": True, "lever": about(1e-4)}
_CN = times(0.7, 1.3), "spread of class CN about its middle, ISO 5753-1"
# fmt: off
RANGES: tuple[KeyRange, ...] = (  # of keys that hold numbers, the first that fits
    KeyRange("bearing.clearance", *_CN, **_CLEARANCE),
    KeyRange("bearing.fits.cold_clearance", *_CN, **_CLEARANCE),
    KeyRange("bearing.*_osculation", instead(0.95, 0.985), THUMB, 0.005, True, about(0.025)),
    KeyRange("bearing.fits.*", *_FIFTH),
    KeyRange(
        "operation.temperatures.reference", plus(-5.0, 5.0), f"ISO 1 sets 20 degC; 5 K: {THUMB}", 5.0, True,
    ),
    _temperature("operation.temperatures.*", 10.0),
    _temperature("lubricant.inlet_temperature", 20.0),
    KeyRange("lubricant.viscosity", *_FIFTH, lever=_ANY),
    KeyRange("lubricant.limiting_ratio", instead(0.03, 0.08), THUMB),
    KeyRange("lubricant.oil_fraction", times(0.5, 2.0), THUMB, lever=within(10.0)),
    KeyRange("lubricant.*", *_FIFTH),
    KeyRange("bearing.cage.pocket_friction", instead(0.02, 0.1), THUMB),
    KeyRange("bearing.cage.thickness", times(0.6, 1.4), THUMB, lever=_ANY),
    KeyRange("bearing.cage.land_diameter", times(0.995, 1.005), THUMB, 0.005),
    KeyRange("bearing.cage.*", times(0.5, 2.0), THUMB, lever=_ANY),
    KeyRange("bearing.roller.drop", times(0.5, 2.0), THUMB, lever=within(10.0)),
    KeyRange("bearing.*.conformity", plus(-0.005, 0.005), THUMB, 0.005, True, about(0.05, 0.501)),
    KeyRange("bearing.*.radius", *_FIFTH, 0.01, lever=within(1.1)),
    KeyRange("bearing.balls", plus(-1, 1), "one less, one more"),
    KeyRange("bearing.roller.length", times(0.9, 1.1), f"10 %: {THUMB}", lever=_ANY),
    KeyRange("bearing.outer_raceway_diameter", times(0.995, 1.005), f"0.5 %: {THUMB}", 0.005, lever=_ANY),
    KeyRange(
        "bearing.contact_angle", plus(-TWO_DEG, TWO_DEG), f"2 deg: {THUMB}", TWO_DEG, True, about(0.35, 0.0),
    ),
    KeyRange("bearing.cup_angle", plus(-RIB, RIB), f"0.2 deg: {THUMB}", RIB, True, about(RIB, 0.0)),
    KeyRange("bearing.cone_angle", plus(-RIB, RIB), f"0.2 deg: {THUMB}", RIB, True, about(RIB, 0.0)),
    KeyRange("bearing.rib.angle", plus(-RIB, RIB), f"0.2 deg: {THUMB}", RIB, True, about(RIB, 0.0)),
    KeyRange("bearing.rib.end_radius", times(0.95, 1.03), f"0.9 to 0.98 of the apex distance: {THUMB}", 0.03),
    KeyRange("bearing.rib.friction", instead(0.02, 0.1), THUMB),
    KeyRange("bearing.first_roller_azimuth", *_FIFTH, pi / 90, True),
    KeyRange("bearing.roughness.*", times(0.5, 2.0), THUMB, lever=within(10.0)),
    KeyRange("friction.coefficient", times(0.5, 1.5), THUMB),
    KeyRange("materials.*.youngs_modulus", times(0.97, 1.03), f"3 %: {THUMB}", 0.03),
    KeyRange("materials.*.poisson_ratio", plus(-0.02, 0.02), THUMB, 0.02, True),
    KeyRange("materials.*.density", times(0.98, 1.02), f"2 %: {THUMB}", 0.02),
    KeyRange("materials.*", *_FIFTH),
    KeyRange("operation.misalignment", *_FIFTH, 3e-4, True, about(3e-3)),
    KeyRange("operation.load_direction", *_FIFTH, pi / 36, True),
    KeyRange("operation.gravity", *_FIFTH),
    KeyRange("outer.bars", times(0.5, 1.5), THUMB),
    KeyRange("outer.flange_length", times(0.5, 2.0), THUMB, lever=_ANY),
    KeyRange("inner.track_width", times(0.9, 1.1), THUMB, lever=_ANY),
    KeyRange("life.reliability", *_FIFTH, 0.01, True, lambda _: (0.9, 0.9995)),
    KeyRange("*", *_FIFTH, lever=_ANY),
)
# fmt: on
FROM_ZERO = {  # step of keys that are zero, by their unit, in SI and in words
    "m": (5e-6, "5 um"),
    "rad": (pi / 10800, "1 arcmin"),
    "rad/s": (pi / 30, "1 rpm"),
    "N": (10.0, "10 N"),
    "N m": (0.1, "0.1 N m"),
}  # fmt: skip
GRADED = (  # keys whose choices are steps
    "life.cleanliness", "lubricant.oil", "bearing.clearance_class", "bearing.fits.shaft",
    "bearing.fits.housing.tolerance_class", "bearing.roller.profile", "bearing.rollers", "bearing.balls",
)  # fmt: skip


def range_of(path: str) -> KeyRange:
    """What is realistic for a key."""
    return next(each for each in RANGES if fnmatchcase(path, each.keys))
