"""What is wanted of a design: an output that is made best, and outputs that stay within bounds."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexbearing.optimise.schema import Search
from flexbearing.optimise.variables import Variable
from flexbearing.outputs.value import conversion
from flexbearing.studies.table.duty import Cycles
from quasidynamic.outcome.load_spectrum import mean_speed

OUTSIDE_LOG = "is not above zero, which a logarithmic scale needs; set scale = linear"


class NotPositive(ValueError):
    """An output that has no logarithm."""


@dataclass(frozen=True)
class Numbers:
    """Outputs of a design in each of its R rows, with or without their derivatives by K variables."""

    values: Mapping[str, NDArray]  # (R) by the texts of outputs, in their units
    slopes: Mapping[str, NDArray] | None = None  # (R, K) by shares of the ranges of the variables


@dataclass(frozen=True)
class Terms:
    """A quantity in each of T rows or duty cycles, and its derivatives by K variables."""

    values: NDArray  # (T)
    slopes: NDArray  # (T, K); NaN where they are not requested


@dataclass(frozen=True)
class Measure:
    """An output as it is reported: of every row, or cumulated over the rows of a duty cycle."""

    name: str
    text: str  # of the output that rows hold
    unit: str
    cycles: Cycles | None = None  # that cumulate it, of B times N rows; None: every row counts

    def terms(self, numbers: Numbers) -> Terms:
        """The measure of a design, in its unit."""
        values = numbers.values[self.text]
        slopes = np.full((len(values), 1), np.nan) if numbers.slopes is None else numbers.slopes[self.text]
        return Terms(values, slopes) if self.cycles is None else self._cumulated(values, slopes)

    def _cumulated(self, lives: NDArray, slopes: NDArray) -> Terms:
        """Lives [Mrev] of all rows (B N) to those of the cycles (B), L = 1 / sum_i phi_i / L_i."""
        assert self.cycles is not None
        shares = self.cycles.shares_of_revolutions
        lives, slopes = lives.reshape(shares.shape), slopes.reshape(*shares.shape, -1)
        life = 1 / (shares / lives).sum(axis=1)
        by_variables = life[:, None] ** 2 * ((shares / lives**2)[..., None] * slopes).sum(axis=1)
        way, speed = conversion("Mrev", self.unit, turning=True), np.ones(len(life))
        if way.per_speed:
            speed = mean_speed(self.cycles.shares_of_time, self.cycles.speed)
        factor = way.factor / speed
        return Terms(life * factor, by_variables * factor[:, None])


@dataclass(frozen=True)
class Goal:
    """What is made as large, or as small, as it can be."""

    measure: Measure
    sign: float  # 1: large is good; -1: small is good
    worst: bool  # of the terms; else their mean
    logarithmic: bool = True
    size: float = 1.0  # of a linear one, by which it is scaled

    def value(self, terms: Terms) -> float:
        """The number that is reported, in the unit of the measure."""
        if not self.worst:
            return float(terms.values.mean())
        return float(self.sign * (self.sign * terms.values).min())

    def merits(self, numbers: Numbers) -> Terms:
        """What is made large: one term, or of the worst every one of T, its smallest.

        Raises `NotPositive` for the logarithm of an output that is not above zero.
        """
        terms = self.measure.terms(numbers)
        if not self.worst:
            terms = Terms(terms.values.mean(keepdims=True), terms.slopes.mean(axis=0, keepdims=True))
        if not self.logarithmic:
            return Terms(self.sign * terms.values / self.size, self.sign * terms.slopes / self.size)
        if np.any(terms.values <= 0):
            raise NotPositive(
                f"{self.measure.name} = {terms.values.min():g} {self.measure.unit} {OUTSIDE_LOG}"
            )
        return Terms(self.sign * np.log(terms.values), self.sign * terms.slopes / terms.values[:, None])


@dataclass(frozen=True)
class Bound:
    """A measure that stays on one side of a value in every term."""

    measure: Measure
    value: float  # in the unit of the measure
    upper: bool

    @property
    def words(self) -> str:
        """As the file has it."""
        unit = "" if self.measure.unit == "1" else f" {self.measure.unit}"
        return f"{self.measure.name} {'<=' if self.upper else '>='} {self.value:g}{unit}"

    @property
    def size(self) -> float:
        """By which the distance from the bound is scaled."""
        return abs(self.value) or 1.0

    def margins(self, numbers: Numbers) -> Terms:
        """Distance of each term from the bound over its size, positive inside."""
        terms, sign = self.measure.terms(numbers), -1.0 if self.upper else 1.0
        return Terms(sign * (terms.values - self.value) / self.size, sign * terms.slopes / self.size)


@dataclass(frozen=True)
class DesignProblem:
    """What is searched: variables, what is made best of them, and within which bounds."""

    variables: tuple[Variable, ...]  # K of them
    settings: Search  # how the best is searched
    goal: Goal
    bounds: tuple[Bound, ...]
