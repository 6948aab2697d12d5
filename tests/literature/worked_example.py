"""A printed number of a worked example, and how it is computed here."""

from collections.abc import Callable
from dataclasses import dataclass

from pytest import approx


@dataclass(frozen=True)
class WorkedExample:
    name: str
    printed: float
    ours: Callable[[], float]
    share: float  # how far the printed number may be off, by its digits or by the factors it is made of
    unit: str = ""

    def check(self):
        assert self.ours() == approx(self.printed, rel=self.share)


def hours(life, speed):
    """Of a life [10^6 revolutions] at a speed [1/min]."""
    return life * 1e6 / 60 / speed
