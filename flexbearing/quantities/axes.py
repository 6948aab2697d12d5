"""The axes of output arrays, with the names by which programs that read result files know them."""

from dataclasses import dataclass

from flexbearing.quantities.reductions import RACES, XYZ, YZ


@dataclass(frozen=True)
class Axis:
    """An axis of arrays."""

    symbol: str  # in `Quantity.axes`
    name: str  # of the dimension: "roller"
    entries: tuple[str, ...] = ()  # what stands along it; empty where the case decides how many there are
    coordinate: str = ""  # quantity of a block with the places along it, "roller_azimuth"


_DIRECTIONS = (*XYZ, "about y", "about z")
FIXED = {  # of every kind of bearing, by symbol
    name: Axis(name, name, entries)
    for name, entries in {
        "race": RACES,
        "transverse": YZ,
        "slope": ("dz/dx", "dy/dx"),
        "radial_force": YZ,
        "force": _DIRECTIONS,
        "displacement": _DIRECTIONS,
        "part": ("outwards", "along"),
        "bar_end": ("ring", "flange"),
        "roller_end": ("-x", "+x"),
        "circle": ("inner raceway", "roller centres", "outer raceway"),
        "turning": ("outer ring", "ball about x", "ball about radius"),
    }.items()
}
ITERATION = Axis("iteration", "iteration")
