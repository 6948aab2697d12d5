"""Profile of a roller, or of a raceway along the rollers."""

from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.quantity import Force, Length, Section, impossible, key, require

MOST = 10_000  # points
CIRCULAR = ("crowned", "tangent_crowned")
DESIGNED = ("lundberg", "johns_gohar", "fujiwara_kawase")
NEEDS = {  # what a profile cannot do without; that of points is either a file or lists
    "crowned": ("straight_length", "crown_radius"),
    "tangent_crowned": ("straight_length", "crown_radius"),
    "logarithmic": ("drop",),
    "lundberg": ("design_load",),
    "johns_gohar": ("design_load",),
    "fujiwara_kawase": ("design_load", "load_factor", "crowned_share", "end_drop"),
}
SHAPES = (  # keys of some profiles
    "straight_length", "crown_radius", "drop", "design_load", "load_factor", "crowned_share", "end_drop",
    "points_file", "point_positions", "point_drops",
)  # fmt: skip
_BY_THREE, _BY_POINTS = {"profile": ("fujiwara_kawase",)}, {"profile": ("points",)}


class Generatrix(Section):
    """Drop of a roller or a raceway along the roller; those of both add up."""

    profile: Literal[
        "straight", "crowned", "tangent_crowned", "logarithmic", "iso16281", "lundberg", "johns_gohar",
        "fujiwara_kawase", "points",
    ] = key(
        "shape of the generatrix: crowned, ends on one circle around mid-roller; tangent_crowned, circular "
        "ends that touch the straight middle; logarithmic, of any drop; iso16281, logarithmic with A = "
        "0.00035 roller diameters; lundberg and johns_gohar, logarithmic for a design load; "
        "fujiwara_kawase, the same with three parameters; points, monotone through points",
        "straight",
    )  # fmt: skip
    straight_length: Length | None = key(
        "length of the straight middle of a crowned profile", None, ge=0, only={"profile": CIRCULAR}
    )
    crown_radius: Length | None = key(
        "radius of the ends' generatrix of a crowned profile",
        None,
        example="600 mm",
        gt=0,
        only={"profile": CIRCULAR},
    )
    drop: Length | None = key(
        "amplitude A of the logarithmic profile A ln 1/(1 - (2x/l)^2)",
        None,
        example="1.75 um",
        gt=0,
        only={"profile": ("logarithmic",)},
    )
    design_load: Force | None = key(
        "load Q of one roller that the profile is made for, A = 2 Q/(pi l E'); that of rollers with modulus "
        "and width of the inner contact",
        None,
        example="4 kN",
        gt=0,
        only={"profile": DESIGNED},
    )
    load_factor: float | None = key(
        "K_1, which multiplies the design load", None, example=1.5, ge=1e-3, le=1000, only=_BY_THREE
    )
    crowned_share: float | None = key(
        "K_2, crowned share of each half of the length", None, example=0.6, ge=1e-3, le=1, only=_BY_THREE
    )
    end_drop: Length | None = key(
        "z_m, drop at the end of the length", None, example="20 um", gt=0, only=_BY_THREE
    )
    points_file: str | None = key(
        'CSV file with a column of positions and one of drops, headed such as "position [mm],drop [um]", '
        "relative to the case file; or lists instead",
        None,
        example="profile.csv",
        only=_BY_POINTS,
    )
    point_positions: tuple[Length, ...] | None = key(
        "places along the roller, growing from one end to the other, or from mid-roller, 0, to one end "
        "where both halves are alike",
        None,
        example=["0 mm", "3 mm", "4.8 mm"],
        strict=False,
        max_length=MOST,
        only=_BY_POINTS,
    )
    point_drops: tuple[Length, ...] | None = key(
        "drop at each of them, the least one 0",
        None,
        example=["0 um", "1 um", "12 um"],
        strict=False,
        max_length=MOST,
        only=_BY_POINTS,
    )

    @model_validator(mode="after")
    def _profile_is_complete(self) -> Self:
        choice = f'profile = "{self.profile}"'
        require(self, NEEDS.get(self.profile, ()), choice)
        if self.profile == "points":
            lists = self.point_positions, self.point_drops
            if self.points_file is None:
                require(self, ("point_positions", "point_drops"), f"{choice} without points_file")
            elif lists != (None, None):
                name = "point_positions" if self.point_positions is not None else "point_drops"
                raise impossible(name, "left out where points_file gives the points")
        return self

    def beyond(self, length: float) -> tuple[str, str] | None:
        """The key that does not fit a roller of some length [m], and what it must be; None where all do."""
        if self.profile not in CIRCULAR:
            return None
        assert self.straight_length is not None  # checked above
        assert self.crown_radius is not None
        if self.straight_length > length:
            return "straight_length", "at most bearing.roller.length"
        if self.crown_radius <= (length if self.profile == "crowned" else length - self.straight_length) / 2:
            ends = "" if self.profile == "crowned" else " without the straight middle"
            return "crown_radius", f"more than half of bearing.roller.length{ends}"
        return None
