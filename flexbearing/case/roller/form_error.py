"""The section [bearing.form_error]: raceways that are not round."""

from typing import Annotated, Any, Self

from pydantic import BeforeValidator, model_validator

from flexbearing.case.quantity import Angle, Length, Section, impossible, key

MOST = 100  # waves of a raceway
FINEST = 10_000  # of them around the circumference


def _listed(value: Any) -> Any:
    """A list, also of one wave that is written without brackets."""
    return value if isinstance(value, list | tuple) else [value]


OneOrMore = BeforeValidator(_listed)


class Waves(Section):
    """Waves of a raceway around its circumference, the same all along the rollers; several add up."""

    waves: Annotated[tuple[int, ...], OneOrMore] = key(
        "number of waves around the circumference, 2 or more: a mean belongs to bearing.clearance, a single "
        "wave to the place of the ring; one number or a list, and so the others",
        example=[2, 5],
        strict=False,
        max_length=MOST,
    )
    amplitude: Annotated[tuple[Length, ...], OneOrMore] = key(
        "half of the height from valley to crest; positive where the raceway stands out of its ring at "
        "the crest, nearer to the rollers, inner as outer",
        example=["10 um", "2 um"],
        strict=False,
        max_length=MOST,
    )
    crest: Annotated[tuple[Angle, ...], OneOrMore] = key(
        "azimuth of a crest of each, from z towards y, at the moment that is solved; 0 deg where left out",
        (),
        example=["0 deg", "30 deg"],
        strict=False,
        max_length=MOST,
    )

    @property
    def crests(self) -> tuple[float, ...]:
        """Azimuth of a crest of every wave [rad]."""
        return self.crest or (0.0,) * len(self.waves)

    @model_validator(mode="after")
    def _one_of_each(self) -> Self:
        if not self.waves or not all(2 <= number <= FINEST for number in self.waves):
            raise impossible("waves", f"whole numbers from 2 to {FINEST}, one or more")
        for name in ("amplitude", "crest"):
            if len(getattr(self, name)) not in (len(self.waves), 0 if name == "crest" else None):
                raise impossible(name, f"as many numbers as waves, {len(self.waves)}")
        return self


class FormError(Section):
    """Form errors of both raceways."""

    inner: Waves | None = key("form error of the inner raceway", None)
    outer: Waves | None = key("form error of the outer raceway", None)
