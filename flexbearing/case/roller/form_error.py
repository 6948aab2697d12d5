"""The section [bearing.form_error]: raceways that are not round, rollers that are not alike."""

from flexbearing.case.quantity import Length, Section, key
from flexbearing.case.raceway_waves import Waves

MOST_ROLLERS = 1000


class FormError(Section):
    """Form errors of both raceways, and of the rollers."""

    inner: Waves | None = key("form error of the inner raceway", None)
    outer: Waves | None = key("form error of the outer raceway", None)
    roller_diameters: tuple[Length, ...] = key(
        "by how much the diameter of each roller is above bearing.roller.diameter, one after the other "
        "from bearing.first_roller_azimuth on; rollers are alike where left out",
        (),
        example=["0.5 um", "-0.2 um", "0 um"],
        strict=False,
        max_length=MOST_ROLLERS,
    )
