"""Which laws of film, traction, rolling and drag a bearing runs under."""

from collections.abc import Callable
from dataclasses import dataclass

from quasidynamic.contact.film import ELLIPTIC_FORMULAS, FORMULAS, EllipticFormula, FilmFormula
from quasidynamic.contact.traction import (
    Regression4109,
    RollingShear,
    TractionLaw,
    biboulet_houpert,
    ellipse_shear,
)
from quasidynamic.errors import ImpossiblePart, require_positive
from quasidynamic.parts.oil_properties import Lubricant


@dataclass(frozen=True, kw_only=True)
class LubricantLaws:
    """An oil, and what is assumed of it around rollers and balls alike."""

    oil: Lubricant
    oil_fraction: float  # [-] volume share of oil in the mixture around the rollers or balls
    traction: Callable[..., TractionLaw] = Regression4109  # called with radius, modulus, length, oil
    rolling: Callable[..., RollingShear] = biboulet_houpert
    inlet_heating: bool = True
    inlet_length: float | None = None  # [-] of the formula of starvation; None: flooded
    drag_coefficient: float | None = None  # [-] across the mixture; None: by Reynolds number
    churning_gap: float | None = None  # [m] around what spins; None: no churning torque

    def __post_init__(self):
        if not 0.0 <= self.oil_fraction <= 1.0:
            raise ImpossiblePart(f"oil_fraction = {self.oil_fraction} must be in [0, 1]")
        for name in ("inlet_length", "drag_coefficient", "churning_gap"):
            if getattr(self, name) is not None:
                require_positive(name, getattr(self, name))


@dataclass(frozen=True, kw_only=True)
class Lubrication(LubricantLaws):
    """An oil between rollers and raceways."""

    film: FilmFormula = FORMULAS["dowson"]


@dataclass(frozen=True, kw_only=True)
class BallLubrication(LubricantLaws):
    """An oil between balls and raceways."""

    rolling: Callable[..., RollingShear] = ellipse_shear
    film: EllipticFormula = ELLIPTIC_FORMULAS["hamrock_dowson"]
