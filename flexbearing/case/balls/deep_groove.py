"""A deep groove ball bearing, as a case."""

from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.balls.angular_contact import FastBearing, FastCase
from flexbearing.case.balls.parts import PLACES
from flexbearing.case.fits import BY_CLASS, Fits
from flexbearing.case.head import KIND
from flexbearing.case.quantity import GIVEN, Length, impossible, key, needed
from flexbearing.case.tolerances import CLEARANCE, Band, ClearanceClass, Place, initial_clearance, tabulated


class DeepGrooveFits(Fits):
    """How the rings are mounted; they count as plain rings up to their raceways."""

    cold_clearance: Length | None = key(
        "radial internal clearance before mounting, as a change of diameter; or by bearing.clearance_class",
        None,
        example="13 um",
    )
    at: Place = key(
        "where the classes of fits and clearance are taken: in the middle of their tolerances, or at the "
        "ends that leave most or least clearance",
        "mean",
        only=({CLEARANCE: GIVEN}, *BY_CLASS),
    )


class DeepGrooveBearing(FastBearing):
    """The bearing."""

    clearance: Length | None = key(
        "radial internal clearance in operation, as a change of diameter, from which the contact angle "
        "under axial load follows; negative is an interference of balls and races; instead of "
        "bearing.fits.cold_clearance or bearing.clearance_class",
        None,
        example="15 um",
    )
    clearance_class: ClearanceClass | None = key(
        "class of the clearance before mounting by ISO 5753, bores over 6 mm up to 250 mm; the operating "
        "clearance then follows from [bearing.fits]",
        None,
        example="C3",
    )
    fits: DeepGrooveFits | None = key(
        "how the rings are mounted, which changes the clearance; with cold_clearance or a clearance_class",
        None,
    )

    @property
    def bands(self) -> dict[str, Band]:
        """Key of each class that is given, to what it allows [m]."""
        if (name := self.clearance_class) is None:
            return super().bands
        assert self.fits  # checked on reading
        band = tabulated(
            CLEARANCE,
            name,
            lambda bore: initial_clearance(name, bore, "deep groove balls"),
            self.fits.bore,
            "bearing.fits.bore",
        )
        return {CLEARANCE: band, **super().bands}

    @property
    def stated_clearance(self) -> float:
        """Radial clearance before mounting, or in operation where no fits are given [m]."""
        if self.clearance is not None:
            return self.clearance
        assert self.fits  # checked on reading
        if self.fits.cold_clearance is not None:
            return self.fits.cold_clearance
        return self.bands[CLEARANCE].open(self.fits.at)

    @model_validator(mode="after")
    def _one_clearance(self) -> Self:
        cold = None if self.fits is None else self.fits.cold_clearance
        ways = {"clearance": self.clearance, "clearance_class": self.clearance_class}
        ways["fits.cold_clearance"] = cold
        stated = [name for name, value in ways.items() if value is not None]
        if not stated and self.fits is not None:
            raise needed(["fits.cold_clearance"], "[bearing.fits] without bearing.clearance_class")
        if not stated:
            raise needed(["clearance"], "a bearing without [bearing.fits] cold_clearance or clearance_class")
        if len(stated) > 1:
            raise impossible(stated[0], f"left out where {stated[1]} is given; give one of the two")
        if self.clearance is not None and self.fits is not None:
            allowed = "left out beside [bearing.fits], which changes a cold_clearance or a clearance_class"
            raise impossible("clearance", allowed)
        if self.clearance_class is not None and self.fits is None:
            raise needed(["fits"], "bearing.clearance_class")
        return self

    @model_validator(mode="after")
    def _clearance_is_small(self) -> Self:
        stated, most = self.clearance, 2 * self.centre_distance
        if stated is None and self.fits:
            stated = self.fits.cold_clearance
        if stated is not None and abs(stated) >= most:
            name = "clearance" if self.fits is None else "fits.cold_clearance"
            raise impossible(name, f"of a size below {most * 1e6:.4g} um, at which balls pass the grooves")
        return self


class DeepGrooveCase(FastCase):
    """A deep groove ball bearing, at rest or at speed."""

    hints = PLACES

    kind: Literal["deep_groove_ball"] = key(KIND)
    bearing: DeepGrooveBearing = key("the bearing")
