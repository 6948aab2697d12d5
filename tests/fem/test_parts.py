"""Impossible parts cannot exist; the message names the parameter."""

from dataclasses import replace

import pytest

from fem import (
    ClampedFace,
    Elastic,
    Groove,
    ImpossiblePart,
    MeshSize,
    OuterRing,
    Patches,
    RingOnShaft,
    SquirrelCage,
)
from fem.mesh.solid import meshed

STEEL = Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
CAGE = SquirrelCage(
    raceway_diameter=75e-3, thickness=3.6e-3, width=10e-3, bars=24, bar_width=4e-3, bar_thickness=2.6e-3,
    bar_length=10.25e-3, flange_length=5e-3, elastic=STEEL,
)  # fmt: skip
SHAFT = RingOnShaft(
    raceway_diameter=65e-3, track_width=6e-3, rib_diameter=69.6e-3, bore=59.6e-3, width=12e-3,
    shaft_bore=51.6e-3, shaft_length=40e-3, ring=STEEL, shaft=STEEL,
)  # fmt: skip

BAD = [
    (CAGE, "thickness", -1e-3),
    (CAGE, "bars", 0),
    (CAGE, "bars", 100),
    (CAGE, "bar_width", 9.9e-3),
    (CAGE, "bar_thickness", 3.6e-3),
    (CAGE, "flange_length", float("nan")),
    (CAGE, "offset", 5e-3),
    (replace(CAGE, collar_thickness=5e-3), "collar_length", 0.2e-3),
    (replace(CAGE, collar_thickness=5e-3), "collar_length", 10.1e-3),
    (replace(CAGE, collar_thickness=5e-3, two_sided=True), "collar_length", 5.1e-3),
    (replace(CAGE, collar_length=2e-3, collar_thickness=5e-3), "collar_thickness", 3.5e-3),
    (replace(CAGE, collar_length=2e-3, collar_thickness=5e-3), "collar_thickness", 3.65e-3),
    (SHAFT, "bore", 66e-3),
    (SHAFT, "raceway_diameter", 70e-3),
    (SHAFT, "track_width", 13e-3),
    (SHAFT, "shaft_bore", 60e-3),
    (SHAFT, "width", 50e-3),
    (STEEL, "poisson_ratio", 0.5),
    (MeshSize(order=3, size=1e-3, raceway_size=1e-3), "order", 0),
]


@pytest.mark.parametrize(("part", "name", "value"), BAD, ids=lambda value: str(value)[:24])
def test_impossible_value_is_named(part, name, value):
    # Too many bars are reported as bars that are too wide: either would help.
    expected = "bar_width" if (name, value) == ("bars", 100) else name
    with pytest.raises(ImpossiblePart, match=expected):
        replace(part, **{name: value})


def test_a_groove_off_the_middle_of_a_narrow_ring_is_refused_with_the_width_of_the_ring():
    groove = Groove(radius=5e-3, centre_radius=35e-3)
    with pytest.raises(ImpossiblePart, match=r"width = 10 mm .* at least 12\.6 mm.* 2 mm off its middle"):
        OuterRing(
            raceway_diameter=76e-3, thickness=6e-3, width=10e-3, elastic=STEEL, support=ClampedFace(),
            groove=groove, offset=2e-3,
        )  # fmt: skip


def test_band_longer_than_the_track():
    ring = OuterRing(
        raceway_diameter=75e-3, thickness=3.6e-3, width=10e-3, elastic=STEEL, support=ClampedFace()
    )
    with pytest.raises(ImpossiblePart, match="track"):
        meshed(ring, 11e-3, MeshSize(order=1, size=5e-3, raceway_size=5e-3))


def test_patches_need_load_and_moment():
    with pytest.raises(ImpossiblePart, match="axial_modes"):
        Patches(azimuths=(0.0,), length=5e-3, axial_modes=1, width=1e-3)
