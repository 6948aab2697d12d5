"""The one table of what stands in the result file of a roller bearing."""

from dataclasses import dataclass
from typing import Literal

FORMAT = 5

Place = Literal["state", "iteration", "block"]


@dataclass(frozen=True)
class Dataset:
    """One dataset of the file."""

    name: str
    axes: str  # Z rollers or balls, K slices, N unknowns, or a number, by spaces; empty for a scalar
    unit: str  # SI
    place: Place  # "state": in iterations and blocks; else only there
    meaning: str  # with its sign
    optional: bool = False  # absent where the case does not give what it needs
    infinite: bool = False  # may hold infinities also in a solution
    gaps: bool = False  # may hold NaN also in a solution, where its meaning says so

    @property
    def shape(self) -> tuple[str, ...]:
        """Axes one by one, ``("Z", "K")``."""
        return tuple(self.axes.split())


_BENDING = "positive outward, without local indentation and rigid translation"
_FLANGED = "absent without [bearing.flange]"

# a table reads best as a table:
# fmt: off
TABLE = (
    Dataset("inner_load", "Z", "N", "state", "load of the inner contact, >= 0"),
    Dataset("outer_load", "Z", "N", "state", "load of the outer contact, >= 0"),
    Dataset("inner_slice_load", "Z K", "N/m", "state", "load per length of the inner contact, >= 0"),
    Dataset("outer_slice_load", "Z K", "N/m", "state", "load per length of the outer contact, >= 0"),
    Dataset("inner_deviation", "Z K", "m", "state",
            f"radial displacement of the inner raceway at the roller, {_BENDING}"),
    Dataset("outer_deviation", "Z K", "m", "state",
            f"radial displacement of the outer raceway at the roller, {_BENDING}"),
    Dataset("roller_tilt", "Z", "rad", "state", "slope of the roller axis, positive: +x end further out"),
    Dataset("roller_speed", "Z", "rad/s", "state",
            "spin relative to the cage frame, positive when it rolls forwards on the inner ring"),
    Dataset("inner_film", "Z", "m", "state", "film thickness of the inner contact, 0 without load"),
    Dataset("outer_film", "Z", "m", "state", "film thickness of the outer contact, 0 without load"),
    Dataset("inner_sliding", "Z", "m/s", "state",
            "speed of the inner raceway over the roller surface, positive to +azimuth"),
    Dataset("outer_sliding", "Z", "m/s", "state",
            "speed of the outer raceway over the roller surface, positive to +azimuth"),
    Dataset("inner_traction", "Z", "N", "state",
            "traction of the inner raceway on the roller, positive to +azimuth"),
    Dataset("outer_traction", "Z", "N", "state",
            "traction of the outer raceway on the roller, positive to +azimuth"),
    Dataset("cage_force", "Z", "N", "state", "force of the cage on the roller, positive to +azimuth"),
    Dataset("cage_speed", "", "rad/s", "state", "speed of the cage, positive to +azimuth"),
    Dataset("cage_slip", "", "1", "state",
            "1 - cage speed / cage speed in pure rolling, positive: the cage lags behind"),
    Dataset("ring_displacement", "2", "m", "state", "displacement of the inner ring (y, z)"),
    Dataset("ring_tilt", "2", "rad", "state", "slopes of the inner ring axis (dz/dx, dy/dx)"),

    Dataset("load_change", "", "1", "iteration", "largest change of a roller load / largest load"),
    Dataset("mismatch", "", "1", "iteration",
            "what the structure answers less the deviation that the bearing was given / largest deviation; "
            "0 where both are one system"),
    Dataset("residual", "", "1", "iteration", "largest unbalanced force / applied load"),
    Dataset("seconds", "", "s", "iteration", "time that the iteration took"),

    Dataset("roller_azimuth", "Z", "rad", "block",
            "place of the roller, 0 on the z axis, positive towards y"),
    Dataset("slice_position", "K", "m", "block", "axial place of the slice's middle, 0 at mid-roller"),
    Dataset("life_L10", "", "rev", "block", "rating life of both raceways together, 90 % survival"),
    Dataset("stiffness", "", "N/m", "block",
            "radial tangent stiffness between raceways freed of their translation"),
    Dataset("total_stiffness", "", "N/m", "block",
            "radial tangent stiffness from base to shaft ends, supports included"),
    Dataset("support_translation", "2 2", "m", "block",
            "rigid translation of the raceway on its support, (inner, outer) by (y, z)"),
    Dataset("driving_torque", "", "N m", "block",
            "torque that keeps the inner ring turning, positive to +azimuth"),
    Dataset("ring_moment", "2", "N m", "block",
            "moment on the inner ring, one for each slope of ring_tilt: applied (free) or reaction (held)"),
    Dataset("peak_pressure", "2", "Pa", "block", "largest contact pressure (inner, outer)"),
    Dataset("minimum_film", "2", "m", "block", "smallest film of a loaded contact (inner, outer)"),
    Dataset("unknowns", "N", "m, rad, rad/s", "block",
            "where a neighbouring case may start: ring displacement (y, z) and slopes, cage speed less that "
            "of pure rolling; then, Z each, approach and tilt approach of the rollers at the outer raceway, "
            "inner film, outer film, spin less that of pure rolling; then Legendre coefficients of the "
            "outward deviations of the inner and the outer raceway, roller by roller"),
    Dataset("inner_film_ratio", "Z", "1", "block",
            "film over composite roughness of the inner contact, 0 without load; absent without roughness",
            optional=True),
    Dataset("outer_film_ratio", "Z", "1", "block",
            "film over composite roughness of the outer contact, 0 without load; absent without roughness",
            optional=True),
    Dataset("cage_offset", "2", "m", "block",
            "centre of a free cage from that of its guiding ring (y, z); absent when it is held",
            optional=True),
    Dataset("pocket_displacement", "Z", "m", "block",
            "roller from the centre of its pocket, positive to +azimuth; absent without pocket clearance",
            optional=True),
    Dataset("load_direction", "", "rad", "block", "azimuth that the radial load points to"),
    Dataset("stiffness_matrix", "5 5", "N/m, N/rad, N m/m, N m/rad", "block",
            "tangent stiffness from base to shaft ends, supports included, x, y, z, about y, about z "
            "(right-handed: about y is -dz/dx, about z is dy/dx); zero along x"),
    Dataset("compliance_matrix", "5 5", "m/N, m/(N m), rad/N, rad/(N m)", "block",
            "its inverse; infinite along x, where a bearing without flanges carries nothing", infinite=True),
    Dataset("loss_sliding", "", "W", "block", "power lost by sliding of the raceways on the rollers"),
    Dataset("loss_rolling", "", "W", "block", "power lost by the shear of the inlets"),
    Dataset("loss_drag", "", "W", "block", "power lost by drag of the mixture on the orbiting rollers"),
    Dataset("loss_pocket", "", "W", "block", "power lost by friction of the rollers in the pockets"),
    Dataset("loss_land", "", "W", "block", "power lost at the guiding land of the cage"),
    Dataset("loss_churning", "", "W", "block", "power lost by churning around the spinning rollers"),
    Dataset("loss_transport", "", "W", "block",
            "no heat: what the differences of the roller spins from azimuth to azimuth leave, an error of "
            "the discretisation; may be negative"),
    Dataset("driving_power", "", "W", "block", "power that the rings put in, the sum of all losses"),
    Dataset("modified_life", "", "rev", "block",
            "life after every factor of [life], see the attribute life; absent when nothing modifies it",
            optional=True),

    Dataset("roller_skew", "Z", "rad", "block",
            "turn of the roller about its radial axis, positive: +x end leads towards +azimuth; "
            f"{_FLANGED}", optional=True),
    Dataset("skew_moment", "Z", "N m", "block",
            f"moment of tractions and inlet shears towards positive skew; {_FLANGED}", optional=True),
    Dataset("roller_thrust", "Z", "N", "block",
            f"axial traction of both raceways on the skewed roller, positive to +x; {_FLANGED}",
            optional=True),
    Dataset("flange_force", "2 Z", "N", "block",
            f"force of the flange at the -x and at the +x end on the roller, >= 0; {_FLANGED}",
            optional=True),
    Dataset("flange_power", "", "W", "block",
            "heat of the friction at the flanges, comes on top of the driving power; "
            f"{_FLANGED}", optional=True),
    Dataset("skew_power", "", "W", "block",
            "heat of the axial sliding of skewed rollers on the raceways, comes on top of the driving power; "
            f"{_FLANGED}", optional=True),
    Dataset("touching_skew", "", "rad", "block",
            f"skew at which a roller meets both flanges; {_FLANGED}", optional=True),
    Dataset("skew_gap", "", "m", "block",
            "largest change of the gap at a roller's end by skew, which the loads do not know of; "
            f"{_FLANGED}", optional=True),
    Dataset("skew_load_shift", "", "m", "block",
            "largest shift between outer and inner load of a roller that axial tractions and flange forces "
            f"ask for, which the tilt does not know of; {_FLANGED}", optional=True),
    Dataset("skew_traction_change", "", "1", "block",
            "largest change of a traction by skew at the same sliding / largest traction, which the speeds "
            f"do not know of; {_FLANGED}", optional=True),
)
# fmt: on


@dataclass(frozen=True)
class Layout:
    """Datasets and blocks in the result file of one bearing family."""

    table: tuple[Dataset, ...]
    blocks: tuple[str, ...]  # that a converged run has
    axes: str  # what the symbols of the axes and the directions mean
    further: tuple[str, ...] = ()  # blocks that only some cases have

    def datasets(self, place: Literal["iteration", "block"]) -> dict[str, Dataset]:
        """Datasets of an iteration or of a block, by name."""
        return datasets(place, self.table)


def datasets(place: Literal["iteration", "block"], table: tuple[Dataset, ...] = TABLE) -> dict[str, Dataset]:
    """Datasets of an iteration or of a block, by name.

    Parameters
    ----------
    place : "iteration" or "block"
        the group that is asked for
    table : tuple of Dataset
        of the kind of bearing

    Returns
    -------
    dict
        name to :class:`Dataset`, in the order of the table
    """
    return {entry.name: entry for entry in table if entry.place in ("state", place)}


ROLLER = Layout(
    TABLE,
    ("rigid", "flexible"),
    """\
Axes: Z rollers, K slices along a roller, N unknowns. Directions: x axial, z along the load unless
`operation.load_direction` turns the load; azimuth from z towards y, which is the way a positive speed turns.
A pair is (inner, outer) or (y, z) as stated.
""",
)
