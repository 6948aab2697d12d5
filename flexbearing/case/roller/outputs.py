"""The section [outputs] of roller bearings, with its probes."""

from functools import partial
from typing import Literal, NamedTuple, Self

from pydantic import model_validator

from flexbearing.case.outputs import LifeOutputs
from flexbearing.case.quantity import Angle, Length, Section, impossible, key

MOST = 200  # probes of a case


class Row(NamedTuple):
    """One of the probes."""

    azimuth: float  # [rad]
    part: str
    place: float  # [m]
    surface: str
    depth: float  # [m]
    gauge_angle: float  # [rad]
    gauge_length: float  # [m]


_listed = partial(key, strict=False, max_length=MOST)  # an entry for every probe, or one for all


class Probes(Section):
    """Places on the rings where strain and displacement are read, one after the other."""

    azimuths: tuple[Angle, ...] = _listed(
        "azimuths of the probes, from z towards y", example=["0 deg", "90 deg"], min_length=1
    )
    parts: tuple[Literal["outer", "inner"], ...] = _listed(
        "on what carries which raceway", ("outer",), example=["outer"]
    )
    places: tuple[Length, ...] = _listed(
        "axial places x, 0 in the middle of the rollers", ("0 mm",), example=["0 mm", "12 mm"]
    )
    surfaces: tuple[Literal["outside", "inside"], ...] = _listed(
        "on the outermost or on the innermost surface of ring, housing, shaft, bar or flange at that place",
        ("outside",),
        example=["inside"],
    )
    depths: tuple[Length, ...] = _listed("radial depths below that surface", ("0 mm",), example=["0.5 mm"])
    gauge_angles: tuple[Angle, ...] = _listed(
        "angles of the gauges to the circumference, positive where the end at larger azimuth is at larger x; "
        "three probes at one place are a rosette",
        ("0 deg",),
        example=["0 deg", "45 deg", "90 deg"],
    )
    gauge_lengths: tuple[Length, ...] = _listed(
        "lengths of the gauges, along which every reading is a mean; 0 reads a point",
        ("0 mm",),
        example=["3 mm"],
    )

    @model_validator(mode="after")
    def _one_for_each(self) -> Self:
        count = len(self.azimuths)
        for name in type(self).model_fields:
            if len(getattr(self, name)) not in (1, count):
                raise impossible(name, f"1 entry, or {count} as azimuths has")
        for name in ("depths", "gauge_lengths"):
            if min(getattr(self, name)) < 0:
                raise impossible(name, "at least 0 mm each")
        return self

    @property
    def rows(self) -> tuple[Row, ...]:
        """The probes one by one."""
        count, lists = len(self.azimuths), (getattr(self, name) for name in type(self).model_fields)
        columns = (values if len(values) == count else values * count for values in lists)
        return tuple(Row(*row) for row in zip(*columns, strict=True))


class Outputs(LifeOutputs):
    """What is computed beside the solution."""

    stresses: bool = key(
        "whether the largest stresses of the flexible parts at the end state, and the stiffness of their "
        "supports, are stored: a full solid for each part costs seconds",
        False,
    )
    probes: Probes | None = key(
        "strain gauges and displacement sensors on the flexible parts: each list has one entry for all "
        "probes, or one for each",
        None,
    )
