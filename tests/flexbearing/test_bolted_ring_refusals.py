"""What a case file may not say of bolted rings, and how it is told."""

import pytest

from flexbearing import explain
from flexbearing.api import check, read_case
from flexbearing.case import BadCase
from tests.places import CONFIGS

SLEWING = CONFIGS / "slewing_bolted.toml"


def test_example_is_possible():
    check(SLEWING)


def test_rings_are_rigid_unless_they_are_described():
    for file, kind in ((SLEWING.with_name("joshi2015_fourpoint.toml"), "rigid"), (SLEWING, "bolted")):
        rings = read_case(file, ()).rings
        assert rings.inner.kind == rings.outer.kind == kind
    assert "rings.outer.face_distance" in explain("rings")


@pytest.mark.parametrize(
    ("settings", "place", "allowed"),
    [
        (["rings.outer.outside_diameter=1930 mm"], "[rings.outer] outside_diameter", "above 1935"),
        (["rings.inner.bore=1870 mm"], "[rings.inner] bore", "below 1864"),
        (["rings.inner.face_distance=10 mm"], "[rings.inner] face_distance", "half the width of the groove"),
        (["rings.outer.width=55 mm"], "[rings.outer] width", "reaches the other face"),
        (["rings.outer.face=up"], "[rings.outer] face", '"+x" or "-x"'),
        (["rings.outer.face=+z"], "[rings.outer] face", 'is now "+x" (axes changed'),
        (["rings.outer.groove_end=40 deg"], "[rings.outer] groove_end", "above bearing.contact_angle"),
        (["rings.outer.kind=free"], "[rings.outer] kind", '"rigid" or "bolted"'),
        (["rings.outer.face_stiffness=5 N/mm^3"], "[rings.outer] face_shear_stiffness is missing", "springs"),
        (["rings.patch_width=0 mm"], "[rings] patch_width", "above 0 m"),
        (["rings.patch_width=9 mm"], "[rings] patch_width", "at most 4.686 mm, 0.4 of half an arc that ends"),
        (["rings.stations=4"], "stations", "an odd number"),
        (["rings.outer.bore=2 m"], "[rings.outer] bore", "not a key"),
        (
            ["operation.mode=contact_loads", 'operation.contact_loads=["5 kN"]'],
            "[operation] mode", '"ring_load" beside elastic rings',
        ),
    ],
)  # fmt: skip
def test_impossible_ring_is_refused(settings, place, allowed):
    with pytest.raises(BadCase) as problem:
        read_case(SLEWING, settings)
    message = str(problem.value)
    assert place in message
    assert allowed in message
    assert len(message.splitlines()) == 1


def test_patches_too_narrow_for_all_harmonics_are_refused():
    check(SLEWING, ["rings.patch_width=0.3484 mm"])
    with pytest.raises(BadCase, match=r'\[rings\] patch_width = "0.34 mm" cannot be; .* at least 0.3423 mm'):
        check(SLEWING, ["rings.patch_width=0.34 mm"])


def test_described_ring_is_described_completely(tmp_path):
    file = tmp_path / "broken.toml"
    file.write_text(SLEWING.read_text().replace('face = "-x"\n', "").replace('    "rings.outer.width",', ""))
    with pytest.raises(BadCase, match=r'\[rings\.outer\] face is missing: kind = "bolted" needs it'):
        read_case(file, ())
