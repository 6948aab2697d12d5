"""Waves of a raceway that is not round, the same in every family of bearings."""

from typing import Self

from pydantic import model_validator

from flexbearing.case.quantity import Angle, Length, Section, impossible, key

MOST = 100  # further waves of a raceway
FINEST = 10_000  # of them around the circumference


class Waves(Section):
    """Waves of a raceway around its circumference, the same all along it; several add up."""

    waves: int = key(
        "number of waves around the circumference: a mean belongs to bearing.clearance, a single wave to the "
        "place of the ring",
        example=2,
        ge=2,
        le=FINEST,
    )
    amplitude: Length = key(
        "half of the height from valley to crest; positive where the crest is closer "
        "to the rollers or balls, at either raceway",
        example="10 um",
    )
    crest: Angle = key("azimuth of a crest, from z towards y, at the moment that is solved", "0 deg")
    further_waves: tuple[int, ...] = key(
        "numbers of further waves, which add up", (), example=[3, 5], strict=False, max_length=MOST
    )
    further_amplitudes: tuple[Length, ...] = key(
        "their amplitudes", (), example=["4 um", "-2 um"], strict=False, max_length=MOST
    )
    further_crests: tuple[Angle, ...] = key(
        "azimuth of a crest of each; 0 deg where left out",
        (),
        example=["20 deg", "0 deg"],
        strict=False,
        max_length=MOST,
    )

    @property
    def numbers(self) -> tuple[int, ...]:
        """Of all waves."""
        return (self.waves, *self.further_waves)

    @property
    def amplitudes(self) -> tuple[float, ...]:
        """Of all waves [m]."""
        return (self.amplitude, *self.further_amplitudes)

    @property
    def crests(self) -> tuple[float, ...]:
        """Azimuth of a crest of every wave [rad]."""
        return (self.crest, *(self.further_crests or (0.0,) * len(self.further_waves)))

    @model_validator(mode="after")
    def _one_of_each(self) -> Self:
        if not all(2 <= number <= FINEST for number in self.further_waves):
            raise impossible("further_waves", f"whole numbers from 2 to {FINEST}")
        count = len(self.further_waves)
        if len(self.further_amplitudes) != count:
            raise impossible("further_amplitudes", f"as many numbers as further_waves, {count}")
        if len(self.further_crests) not in (0, count):
            raise impossible("further_crests", f"as many numbers as further_waves, {count}, or left out")
        return self


class FormErrors(Section):
    """Raceways that are not round."""

    inner: Waves | None = key("form error of the inner raceway", None)
    outer: Waves | None = key("form error of the outer raceway", None)
