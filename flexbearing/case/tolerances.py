"""Tolerance classes of bearings and their seats, and clearance classes, as the standards tabulate them.

Deviations are those of ISO 286-2 as the SKF catalogue Rolling bearings (2018), section B.6, tables 11 to 21,
prints them with the fits they result in; of seats over 250 mm those of isofits 1.0 (MIT licence), and n6, p6
and r6 of small shafts those of JIS B 0401. Tolerances of bore and outside diameter are those of the Normal
class (ISO 492), clearances those of cylindrical roller bearings with cylindrical bore (ISO 5753-1), both from
the same catalogue; those of deep groove ball bearings (ISO 5753-1) are printed in NTN, Ball and Roller
Bearings, pages A-58 and A-59, and by two other makers alike up to bores of 100 mm. Formulas rounded give
other values here and there, so every value is tabulated. A step is over the limit before it, up to and
including its own.
"""

from bisect import bisect_left
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, get_args

from flexbearing.case.quantity import impossible, needed

ClearanceClass = Literal["C2", "CN", "C3", "C4"]
ShaftClass = Literal[
    "f5", "f6", "g5", "g6", "h5", "h6", "j5", "j6", "js5", "js6", "js7", "k5", "k6", "m5", "m6", "n5", "n6",
    "p6", "p7", "r6", "r7",
]  # fmt: skip
HousingClass = Literal[
    "F7", "G6", "G7", "H6", "H7", "H8", "J6", "J7", "JS6", "JS7", "K6", "K7", "M6", "M7", "N6", "N7", "P6",
    "P7",
]  # fmt: skip
Place = Literal["loosest", "mean", "tightest"]  # within the tolerances

CLEARANCE, SHAFT, HOUSING = (  # keys of classes
    "bearing.clearance_class",
    "bearing.fits.shaft",
    "bearing.fits.housing.tolerance_class",
)
MM, UM = 1e-3, 1e-6
SMALLEST = 6.0  # [mm] every table begins over it
LARGEST = {"shaft": 250.0, "housing": 400.0}  # [mm] up to which printed values were found
PRINTED_OVER = {"p7": 50.0, "r7": 80.0}  # [mm] below which the catalogue prints none

_STEPS = (10, 18, 30, 50, 80, 120, 180, 250, 315, 400)  # [mm] nominal sizes
_SHORT_STEPS = (10, 18, 30, 50, 65, 80, 100, 120, 140, 160, 180, 200, 225, 250)  # [mm] of the letter r
_GRADES = {  # [um] standard tolerances IT
    5: (6, 8, 9, 11, 13, 15, 18, 20, 23, 25),
    6: (9, 11, 13, 16, 19, 22, 25, 29, 32, 36),
    7: (15, 18, 21, 25, 30, 35, 40, 46, 52, 57),
    8: (22, 27, 33, 39, 46, 54, 63, 72, 81, 89),
}
_UPPER = {  # [um] upper limit deviations, of a letter or of a class
    "f": (-13, -16, -20, -25, -30, -36, -43, -50),
    "g": (-5, -6, -7, -9, -10, -12, -14, -15),
    "h": (0, 0, 0, 0, 0, 0, 0, 0),
    "j5": (4, 5, 5, 6, 6, 6, 7, 7),
    "j6": (7, 8, 9, 11, 12, 13, 14, 16),
    "J6": (5, 6, 8, 10, 13, 16, 18, 22, 25, 29),
    "J7": (8, 10, 12, 14, 18, 22, 26, 30, 36, 39),
    "K6": (2, 2, 2, 3, 4, 4, 4, 5, 5, 7),
    "K7": (5, 6, 6, 7, 9, 10, 12, 13, 16, 17),
    "M6": (-3, -4, -4, -4, -5, -6, -8, -8, -9, -10),
    "M7": (0, 0, 0, 0, 0, 0, 0, 0, 0, 0),
    "N6": (-7, -9, -11, -12, -14, -16, -20, -22, -25, -26),
    "N7": (-4, -5, -7, -8, -9, -10, -12, -14, -14, -16),
    "P6": (-12, -15, -18, -21, -26, -30, -36, -41, -47, -51),
    "P7": (-9, -11, -14, -17, -21, -24, -28, -33, -36, -41),
}
_LOWER = {  # [um] lower limit deviations of a letter
    "k": (1, 1, 2, 2, 2, 3, 3, 4),
    "m": (6, 7, 8, 9, 11, 13, 15, 17),
    "n": (10, 12, 15, 17, 20, 23, 27, 31),
    "p": (15, 18, 22, 26, 32, 37, 43, 50),
    "F": (13, 16, 20, 25, 30, 36, 43, 50, 56, 62),
    "G": (5, 6, 7, 9, 10, 12, 14, 15, 17, 18),
    "H": (0, 0, 0, 0, 0, 0, 0, 0, 0, 0),
}
_LOWER_R = (19, 23, 28, 34, 41, 43, 51, 54, 63, 65, 68, 77, 80, 84)  # [um]

_BORE_TOLERANCES = (8, 8, 10, 12, 15, 20, 25, 30)  # [um] below nominal
_OUTSIDE_STEPS = (18, 30, 50, 80, 120, 150, 180, 250, 315, 400)  # [mm]
_OUTSIDE_TOLERANCES = (8, 9, 11, 13, 15, 18, 25, 30, 35, 40)  # [um] below nominal

_CLEARANCE_STEPS = (24, 30, 40, 50, 65, 80, 100, 120, 140, 160, 180, 200, 225, 250)  # [mm] bore
_CLEARANCES = {  # [um] least, greatest
    "C2": (
        (0, 25), (0, 25), (5, 30), (5, 35), (10, 40), (10, 45), (15, 50), (15, 55), (15, 60), (20, 70),
        (25, 75), (35, 90), (45, 105), (45, 110),
    ),
    "CN": (
        (20, 45), (20, 45), (25, 50), (30, 60), (40, 70), (40, 75), (50, 85), (50, 90), (60, 105), (70, 120),
        (75, 125), (90, 145), (105, 165), (110, 175),
    ),
    "C3": (
        (35, 60), (35, 60), (45, 70), (50, 80), (60, 90), (65, 100), (75, 110), (85, 125), (100, 145),
        (115, 165), (120, 170), (140, 195), (160, 220), (170, 235),
    ),
    "C4": (
        (50, 75), (50, 75), (60, 85), (70, 100), (80, 110), (90, 125), (105, 140), (125, 165), (145, 190),
        (165, 215), (170, 220), (195, 250), (220, 280), (235, 300),
    ),
}  # fmt: skip


_BALL_CLEARANCE_STEPS = (10, 18, 24, 30, 40, 50, 65, 80, 100, 120, 140, 160, 180, 200, 225, 250)  # [mm] bore
_BALL_CLEARANCES = {  # [um] least, greatest, of deep groove ball bearings
    "C2": (
        (0, 7), (0, 9), (0, 10), (1, 11), (1, 11), (1, 11), (1, 15), (1, 15), (1, 18), (2, 20), (2, 23),
        (2, 23), (2, 25), (2, 30), (2, 35), (2, 40),
    ),
    "CN": (
        (2, 13), (3, 18), (5, 20), (5, 20), (6, 20), (6, 23), (8, 28), (10, 30), (12, 36), (15, 41), (18, 48),
        (18, 53), (20, 61), (25, 71), (25, 85), (30, 95),
    ),
    "C3": (
        (8, 23), (11, 25), (13, 28), (13, 28), (15, 33), (18, 36), (23, 43), (25, 51), (30, 58), (36, 66),
        (41, 81), (46, 91), (53, 102), (63, 117), (75, 140), (85, 160),
    ),
    "C4": (
        (14, 29), (18, 33), (20, 36), (23, 41), (28, 46), (30, 51), (38, 61), (46, 71), (53, 84), (61, 97),
        (71, 114), (81, 130), (91, 147), (107, 163), (125, 195), (145, 225),
    ),
}  # fmt: skip
_CLEARANCES_OF = {
    "cylindrical rollers": (_CLEARANCE_STEPS, _CLEARANCES),
    "deep groove balls": (_BALL_CLEARANCE_STEPS, _BALL_CLEARANCES),
}


class Untabulated(ValueError):
    """A size for which no printed value was found; the message says for which there are some."""


@dataclass(frozen=True)
class Band:
    """What a tolerance allows."""

    least: float  # [m]
    greatest: float  # [m]

    @property
    def mean(self) -> float:
        """Middle of the band [m]."""
        return (self.least + self.greatest) / 2

    def tight(self, place: Place) -> float:
        """Value of an interference at a place within the tolerances [m]."""
        return {"loosest": self.least, "mean": self.mean, "tightest": self.greatest}[place]

    def open(self, place: Place) -> float:
        """Value of a clearance at a place within the tolerances [m]."""
        return {"loosest": self.greatest, "mean": self.mean, "tightest": self.least}[place]


def initial_clearance(
    name: ClearanceClass,
    bore: float,
    of: Literal["cylindrical rollers", "deep groove balls"] = "cylindrical rollers",
) -> Band:
    """Radial internal clearance of a bearing before mounting, as a change of diameter."""
    size = _size(bore, LARGEST["shaft"])
    steps, clearances = _CLEARANCES_OF[of]
    least, greatest = clearances[name][bisect_left(steps, size)]
    return Band(least * UM, greatest * UM)


def shaft_interference(name: ShaftClass, bore: float) -> Band:
    r"""Interference of a shaft and a bearing of the Normal tolerance class, negative is a loose fit.

    .. math:: ei - 0 \le \Delta \le es + t_{\Delta dmp}
    """
    size = _size(bore, LARGEST["shaft"], PRINTED_OVER.get(name, SMALLEST))
    lower, upper = _deviations(name, size)
    return Band(lower * UM, (upper + _BORE_TOLERANCES[bisect_left(_STEPS, size)]) * UM)


def housing_interference(name: HousingClass, outside: float) -> Band:
    r"""Interference of a bearing of the Normal tolerance class and its housing, negative is a loose fit.

    .. math:: -t_{\Delta Dmp} - ES \le \Delta \le 0 - EI
    """
    size = _size(outside, LARGEST["housing"])
    lower, upper = _deviations(name, size)
    return Band(-(upper + _OUTSIDE_TOLERANCES[bisect_left(_OUTSIDE_STEPS, size)]) * UM, -lower * UM)


def deviations(name: ShaftClass | HousingClass, diameter: float) -> Band:
    """Limit deviations of a shaft or a housing bore from the nominal diameter."""
    largest = LARGEST["shaft" if name in get_args(ShaftClass) else "housing"]
    lower, upper = _deviations(name, _size(diameter, largest, PRINTED_OVER.get(name, SMALLEST)))
    return Band(lower * UM, upper * UM)


def tabulated(
    path: str, name: str, table: Callable[[float], Band], diameter: float | None, owner: str
) -> Band:
    """Band of a class that a case names.

    Raises `PydanticCustomError` where the diameter is missing, or none of the printed tables has it.
    """
    if diameter is None:
        raise needed([owner], path)
    try:
        return table(diameter)
    except Untabulated as problem:
        given = f"{owner} = {diameter * 1e3:.6g} mm"
        allowed = f"left out for {given}: {name} is tabulated {problem}; give the value"
        raise impossible(path, allowed) from None


def _size(diameter: float, largest: float, over: float = SMALLEST) -> float:
    """Nominal diameter [mm], free of the rounding of sums, such as that of a raceway and two thicknesses."""
    size = round(diameter / MM, 6)
    if not over < size <= largest:
        raise Untabulated(f"over {over:g} mm up to {largest:g} mm")
    return size


def _deviations(name: str, size: float) -> tuple[float, float]:
    """Lower and upper limit deviation [um] at a nominal size [mm]."""
    letter, grade, step = name[:-1], int(name[-1]), bisect_left(_STEPS, size)
    tolerance = _GRADES[grade][step]
    if letter in ("js", "JS"):
        return -tolerance / 2, tolerance / 2
    if upper := _UPPER.get(name) or _UPPER.get(letter):
        return upper[step] - tolerance, upper[step]
    lower = _LOWER_R[bisect_left(_SHORT_STEPS, size)] if letter == "r" else _LOWER[letter][step]
    return lower, lower + tolerance
