"""What holds the rings, from the case file to the loads."""

from pathlib import Path

import numpy as np
import pytest
from pytest import approx

from flexbearing.case import BadCase, read
from flexbearing.compute import one

PAPER = Path(__file__).parents[2] / "configs" / "mao2016.toml"
RING = ["inner.kind=rigid", "outer.kind=ring", "accuracy.element_order=3"]
SUPPORTS = {
    "seat": [],
    "foundation": ["outer.foundation_radial=100 N/mm^3"],
    "housing": ["outer.housing_thickness=10 mm", "outer.housing_width=12 mm"],
    "lines": ['outer.line_azimuths=["60 deg", "180 deg", "300 deg"]'],
    "planet": [
        'outer.tooth_azimuths=["90 deg", "270 deg"]',
        'outer.tooth_radial=["0 N", "0 N"]',
        'outer.tooth_tangential=["9800 N", "-9800 N"]',
    ],
}


def with_support(name):
    return [*RING, f"outer.support={name}", *SUPPORTS[name]]


@pytest.mark.parametrize("name", SUPPORTS)
def test_every_support_is_computed(name, tmp_path):
    result = one.run(PAPER, tmp_path / "r.h5", with_support(name))
    assert result.attributes["status"] == "converged"
    assert np.abs(result.flexible["outer_deviation"]).max() > 1e-7
    carried = result.flexible["inner_load"] @ np.cos(result.flexible["roller_azimuth"])
    assert carried == approx(result.rigid["inner_load"] @ np.cos(result.rigid["roller_azimuth"]), rel=0.01)


def test_tooth_forces_bend_a_planet_before_rollers_do(tmp_path):
    """The rim ovalises: it opens between the teeth, which spreads the load over more rollers."""
    result = one.run(PAPER, tmp_path / "r.h5", with_support("planet"))
    assert (result.flexible["inner_load"] > 1).sum() > (result.rigid["inner_load"] > 1).sum()
    assert result.attributes["structure"]["outer"]["support_stiffness_N_per_m"] is None


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        (["outer.support=housing"], "housing_thickness"),
        (["outer.support=lines"], "line_azimuths"),
        (["outer.support=planet"], "tooth_azimuths"),
        (["outer.support=planet", 'outer.tooth_azimuths=["90 deg"]'], "as many"),
        (["outer.support=foundation"], "or nothing holds the ring"),
        (["outer.kind=step"], "file"),
        (["outer.kind=step", "outer.file=x.step"], "can move freely"),
    ],
)
def test_supports_that_hold_nothing_are_refused(settings, told):
    with pytest.raises(BadCase, match=told):
        read(PAPER, [*RING, *settings])


def test_ring_that_can_roll_between_two_lines_is_refused_before_it_is_solved(tmp_path):
    lines = ["outer.support=lines", 'outer.line_azimuths=["0 deg", "180 deg"]']
    with pytest.raises(BadCase, match="can still move along"):
        one.run(PAPER, tmp_path / "r.h5", [*RING, *lines])


@pytest.mark.slow
def test_inner_ring_in_its_fit_yields_more_than_a_bonded_one(tmp_path):
    loads = {}
    for fit in ("bonded", "friction", "frictionless"):
        result = one.run(PAPER, tmp_path / f"{fit}.h5", ["outer.kind=rigid", f"inner.fit={fit}"])
        assert result.attributes["status"] == "converged"
        loads[fit] = result.flexible
    stiffness = {fit: float(block["total_stiffness"]) for fit, block in loads.items()}
    assert stiffness["bonded"] > stiffness["friction"] > stiffness["frictionless"]
    stuck = one.run(
        PAPER, tmp_path / "stuck.h5",
        ["outer.kind=rigid", "inner.fit=friction", "inner.fit_friction=10", "inner.interference=40 um"],
    )  # fmt: skip
    assert stuck.flexible["total_stiffness"] == approx(stiffness["bonded"], rel=0.02)
    told = stuck.attributes["structure"]["inner"]["fit"]
    assert told["open_share"] == 0.0
    assert told["slipping_share"] < 0.01
