"""Cases of fast balls whose outer ring is drawn: 6209 in a plain ring, and on a foot."""

import shutil

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import check, read_case
from flexbearing.case import BadCase
from flexbearing.case.balls.ring_room import elastic_groove
from flexbearing.derivatives.balls import sensitivities
from tests.drawn_grooves import counterbored, named, on_a_foot, ring, tube, written

SHOULDER = {"bearing.outer.shoulder": "2.2 mm"}
COARSE = {"accuracy.stations": 5, "accuracy.patch_width": "1.2 mm", "operation.inner_speed": "0 rpm"}
DRAWN = SHOULDER | {"outer.kind": "step", "outer.file": "ring.step", "outer.clamps": ["back"]}
FOOT = DRAWN | COARSE | {"outer.file": "foot.step", "outer.clamps": ["foot"]}
SECTION = SHOULDER | {"outer.kind": "ring", "outer.thickness": "3.65 mm", "outer.width": "19 mm"}


@pytest.fixture(scope="module")
def case(tmp_path_factory):
    """A case file beside drawings."""
    folder = tmp_path_factory.mktemp("drawn")
    for name, shape in {"ring": ring(), "foot": on_a_foot(), "bore": named(tube(38.85, 42.5))}.items():
        (folder / f"{name}.step").write_bytes(written(shape))
    return shutil.copy("configs/6209.toml", folder)


def differing(one, other):
    loads = [each.flexible["contact_load"] for each in (one, other)]
    return np.abs(loads[0] - loads[1]).max() / loads[1].max()


@pytest.mark.slow
def test_a_drawn_ring_loads_its_balls_as_that_of_a_section(case):
    """With patches and elements by default: 0.05 % of the largest load, and 0.1 um of the ring's place."""
    stressed = {"outputs.stresses": True}
    section, drawn = (flexbearing.run(case, each | stressed) for each in (SECTION, DRAWN))
    assert differing(drawn, section) < 2e-3
    assert np.abs(section.flexible["contact_load"] - section.rigid["contact_load"]).max() > 100.0  # N
    places = [each.flexible["ring_displacement"][:3] for each in (drawn, section)]
    assert places[0] == approx(places[1], abs=2e-7)
    of_drawn, of_section = (
        each.attributes["stresses"]["outer"]["bodies"]["ring"] for each in (drawn, section)
    )
    for most in ("von_mises", "tension"):
        found, exact = of_drawn[f"{most}_MPa"], of_section[f"{most}_MPa"]
        assert abs(found - exact) < of_drawn[f"{most}_error_MPa"] < 0.25 * exact


@pytest.mark.slow
def test_a_ring_on_a_foot(case):
    """Balance, mirror symmetry, and that it gives way more where it is further from its foot."""
    below = flexbearing.run(case, FOOT | {"operation.load.radial_z": "-8.9 kN"})
    beside = flexbearing.run(
        case, FOOT | {"operation.load.radial_z": "0 N", "operation.load.radial_y": "8.9 kN"}
    )
    above = flexbearing.run(case, FOOT)
    azimuths = 2 * np.pi * np.arange(9) / 9
    for result, load in ((above, [0, 8900]), (below, [0, -8900]), (beside, [8900, 0])):
        for loads, angles in zip(
            result.flexible["contact_load"], result.flexible["contact_angle"], strict=True
        ):
            pushes = loads * np.cos(angles) * np.array([np.sin(azimuths), np.cos(azimuths)])
            assert pushes.sum(axis=1) == approx(load, abs=1e-9 * 8900)
    for result in (above, below):
        loads = result.flexible["contact_load"]
        assert loads[:, 1:] == approx(loads[:, :0:-1], abs=1e-3 * loads.max())
    away = [each.flexible["ring_displacement"][2] for each in (above, below)]
    assert away[0] > -2 * away[1] > 0  # held on the side of its foot


@pytest.mark.slow
def test_derivatives_by_what_meshes_the_ring_anew_are_left_out(case):
    keys = ["operation.load.radial_z", "bearing.first_ball_azimuth", "bearing.outer.radius"]
    table = sensitivities(read_case(case, DRAWN | COARSE), ["contact_load_range.inner.largest"], keys)
    assert [key.path for key in table.keys] == keys[:1]
    assert dict(table.left_out)[keys[1]].startswith("it meshes a drawn ring anew")
    near = [flexbearing.run(case, DRAWN | COARSE | {keys[0]: f"{load} N"}) for load in (8890, 8910)]
    change = np.diff([each.flexible["contact_load"][0].max() for each in near]) / 20
    assert 1e-3 * table.slopes[0, 0] == approx(change[0], rel=1e-4)  # per kN


def test_a_low_shoulder_is_drawn_at_the_open_side(tmp_path):
    """As angular contact bearings have it; without its height the groove reaches as far to both."""
    file = shutil.copy("configs/harris218.toml", tmp_path)
    heights = {"bearing.outer.shoulder": "5 mm", "bearing.outer.open_shoulder": "0.8 mm"}
    arc, land = elastic_groove(read_case(file, heights), "outer")
    shape = counterbored(arc, land, arc.bottom(1) - 0.8e-3)
    (tmp_path / "ring.step").write_bytes(written(shape))
    drawn = {"outer.kind": "step", "outer.file": "ring.step", "outer.clamps": ["back"]} | heights
    check(file, drawn)
    for wrong in ({"bearing.outer.open_shoulder": None}, {"outer.axis": "-x"}):
        with pytest.raises(BadCase, match="reaches from x = "):
            check(file, drawn | wrong)
    with pytest.raises(BadCase, match="it must be above 0 mm for"):
        check(file, drawn | {"bearing.outer.open_shoulder": "0 mm"})


BAD = {
    "no groove": ({"outer.file": "bore.step"}, "arcs of those that are drawn: none"),
    "no such face": ({"outer.clamps": ["foot"]}, 'has no face named "foot"'),
    "nothing held": ({"outer.clamps": None}, "one face or more"),
    "no shoulder": ({"bearing.outer.shoulder": None}, "shoulder is missing"),
    "low shoulder": ({"bearing.outer.shoulder": "3 mm"}, "reaches from x = -4.9"),
    "it turns": ({"operation.outer_speed": "10 rpm"}, "outer.clamps do not move"),
    "a target": ({"accuracy.target": "1 %"}, "whose elements have no levels"),
    "a probe": ({"outputs.probes.azimuths": ["0 deg"]}, "surfaces of a drawn solid are not known"),
    "a width": ({"outer.width": "19 mm"}, "is not used"),
}


@pytest.mark.parametrize("name", BAD)
def test_drawings_and_keys_that_cannot_be_are_refused(case, name):
    changes, words = BAD[name]
    with pytest.raises(BadCase, match=words):
        check(case, DRAWN | changes)
