"""Rows of a duty cycle whose oil is too thin for a_ISO: the least value of its formula counts."""

from collections.abc import Mapping
from typing import Any

from flexbearing.case import Head
from flexbearing.families import FAMILIES
from flexbearing.studies.table.duty import BASIC, MODIFIED
from quasidynamic.outcome.life_factors import LEAST_VISCOSITY_RATIO

LEAST_FACTOR = 0.1  # a_ISO of rollers and of balls at kappa = 0.1, at any load


def too_thin(case: Any) -> str:
    """Why a case has no a_ISO where its viscosity ratio is too small; empty where it has one."""
    catalogue = FAMILIES[case.kind].catalogue
    kappa = catalogue().viscosity_ratio(case) if catalogue else None
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
