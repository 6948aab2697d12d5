"""The section [outputs] of every kind of bearing, of those with a rating life, and with probes on rings."""

from functools import partial
from typing import Literal, NamedTuple, Self

from pydantic import model_validator

from flexbearing.case.quantity import Angle, Length, Section, impossible, key

MOST = 200  # probes of a case


class ContactOutputs(Section):
    """What is computed beside the solution."""

    subsurface_stresses: bool = key(
        "whether the von Mises and the orthogonal shear stress below the most pressed contact of each "
        "raceway are stored, as a field in the plane of rolling with the largest value and its depth",
        False,
    )
    assumed_effects: bool = key(
        "whether lives and main outputs are stored with other values of every assumed or fitted key, at the "
        "ends of the tolerance classes, and with other rules of the life and the other tilt: some two "
        "further solutions for each key",
        False,
    )


class LifeOutputs(ContactOutputs):
    """What is computed beside the solution."""

    catalogue_life: bool = key(
        "whether the way from the life of a catalogue to that of the case is stored, as `flexbearing life` "
        "prints it: a further solution for each of its lines",
        False,
    )


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
        "axial places x, 0 in the middle of the rollers or of the groove",
        ("0 mm",),
        example=["0 mm", "12 mm"],
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


class SolidOutputs(Section):
    """What is computed of rings whose solids are known."""

    stresses: bool = key(
        "whether the largest stresses of the flexible parts at the end state are stored, and of roller "
        "bearings the stiffness of their supports, for which a full solid of each part costs seconds",
        False,
    )

    probes: Probes | None = key(
        "strain gauges and displacement sensors on the flexible parts: each list has one entry for all "
        "probes, or one for each",
        None,
    )


class RingOutputs(SolidOutputs, LifeOutputs):
    """What is computed beside the solution."""


class BoltedOutputs(SolidOutputs, ContactOutputs):
    """What is computed beside the solution."""
