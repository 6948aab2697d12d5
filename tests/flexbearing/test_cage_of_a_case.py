"""A free cage, pocket clearance and several equilibria, from the case file to the summary."""

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.case import BadCase
from tests.flexbearing.noted import texts
from tests.flexbearing.test_followed_map import FALLING
from tests.places import CONFIGS

PAPER = CONFIGS / "mao2016.toml"
RIGID = ["outer.kind=rigid", "inner.kind=rigid"]
FREE = [
    "bearing.cage.centre=free",
    "bearing.cage.unbalance=20 um",
    "bearing.cage.unbalance_azimuth=90 deg",
    "bearing.cage.pocket_clearance=0.1 mm",
]


def test_free_cage_reaches_the_summary():
    result = flexbearing.run(PAPER, RIGID + FREE)
    block = result.summary()["rigid"]
    assert block["cage_offset_um"] == approx(200, rel=0.01)  # pressed through nearly all of its clearance
    values = result.rigid
    assert np.hypot(*values["cage_offset"]) == approx(1e-6 * block["cage_offset_um"])
    assert values["pocket_displacement"].shape == (30,)
    told = " ".join(texts(result))
    assert "eccentricity ratio" in told
    away = np.abs(values["pocket_displacement"])
    touching = (away > 0.1e-3).sum()
    assert 0 < touching < (away > 0.05e-3).sum()
    assert f"cage pockets: {touching} rollers touch the wall of their pocket" in told


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        (["bearing.cage.guidance=rollers", "bearing.cage.centre=free"], "only a land carries a free one"),
        (["bearing.cage.unbalance=20 um"], r"unbalance = .* belongs to bearing\.cage\.centre"),
        (["bearing.cage.pocket_clearance=0 mm"], "pocket_clearance"),
        (
            ["bearing.cage.guidance=inner", "bearing.cage.land_diameter=200 mm"],
            r'land_diameter = "200 mm" cannot be; it must be 64.92 to 70 mm for guidance = "inner"',
        ),
        (["bearing.cage.guidance=inner"], r'land_diameter = "74.6 mm" cannot be.*for guidance = "inner"'),
        (
            ["bearing.cage.land_diameter=65.4 mm"],
            r"land_diameter .* 70 to 75 mm.* pitch circle and the outer raceway",
        ),
    ],
)
def test_cages_that_make_no_sense(settings, told):
    with pytest.raises(BadCase, match=told):
        read_case(PAPER, settings)


@pytest.mark.slow
def test_several_equilibria_by_a_falling_traction_curve_are_told():
    result = flexbearing.run(PAPER, [*RIGID, *FALLING, "operation.radial_load=2870 N"])
    (note,) = [note for note in result.attributes["notes"] if note["code"] == "several-equilibria"]
    assert note["grade"] == "danger"
    found = result.attributes["equilibria"]["rigid"]
    slips = sorted(state["slip_percent"] for state in (found["computed"], *found["others"]))
    assert slips[0] == approx(0.3262, rel=1e-3, abs=0)
    assert slips[-1] > 30  # [%]
    alone = flexbearing.run(PAPER, [*RIGID, *FALLING, "operation.radial_load=20 kN"])
    assert "equilibria" not in alone.attributes
    assert not any("several equilibria" in text for text in texts(alone))
