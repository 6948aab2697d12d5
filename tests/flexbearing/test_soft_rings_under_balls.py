"""Random designs between soft rings: light balls on the walls of their grooves, and a limit point."""

import numpy as np
import pytest
from pytest import approx

import flexbearing

FOUR_POINTS = "configs/joshi2015_fourpoint.toml", [
    "bearing.ball.diameter=3.2632 mm", "bearing.pitch_diameter=23.4495 mm", "bearing.balls=13",
    "bearing.inner.radius=", "bearing.inner.conformity=0.5112", "bearing.outer.radius=",
    "bearing.outer.conformity=0.5285", "bearing.contact_angle=47.76 deg", "bearing.clearance=2.719 um",
    "operation.load.axial=598.37 N", "operation.load.radial_y=0 N", "operation.load.radial_z=1476.4 N",
    "operation.load.moment_y=5.8774 N m", "operation.load.moment_z=0 N m", "rings.inner.kind=bolted",
    "rings.inner.face=+x", "rings.inner.bore=19.3838 mm", "rings.inner.width=8.2094 mm",
    "rings.inner.face_distance=3.0839 mm",
]  # fmt: skip
RADIAL = "configs/6209.toml", [
    "bearing.ball.diameter=30.6203 mm", "bearing.pitch_diameter=207.9354 mm", "bearing.balls=16",
    "bearing.inner.radius=", "bearing.inner.conformity=0.5261", "bearing.outer.radius=",
    "bearing.outer.conformity=0.5249", "bearing.outer.shoulder=7.4378 mm",
    "bearing.inner.shoulder=7.4378 mm", "bearing.first_ball_azimuth=328.68 deg",
    "operation.inner_speed=51.0 rpm", "operation.load.axial=19808 N",
    "operation.load.radial_z=2.1102e+05 N", "bearing.clearance=30.249 um", "outer.thickness=1.3627 mm",
    "outer.width=40.5262 mm", "outer.kind=ring", "outer.support=foundation",
    "outer.foundation_radial=32.25 N/mm^3", "outer.foundation_tangential=1484 N/mm^3",
    "outer.foundation_axial=6064 N/mm^3",
]  # fmt: skip
CAGE = "configs/harris218.toml", [
    "bearing.ball.diameter=16.8727 mm", "bearing.pitch_diameter=141.2903 mm", "bearing.balls=13",
    "bearing.inner.radius=", "bearing.inner.conformity=0.5107", "bearing.outer.radius=",
    "bearing.outer.conformity=0.5263", "bearing.outer.shoulder=4.9357 mm",
    "bearing.inner.shoulder=4.9357 mm", "bearing.first_ball_azimuth=199.52 deg",
    "operation.inner_speed=237.9 rpm", "operation.load.axial=58806 N", "operation.load.radial_z=51896 N",
    "bearing.contact_angle=13.42 deg", "operation.displacement.tilt_y=", "operation.displacement.tilt_z=",
    "outer.thickness=4.6129 mm", "outer.width=27.9739 mm", "outer.kind=squirrel_cage", "outer.bars=39",
    "outer.bar_width=4.5526 mm", "outer.bar_thickness=4.2602 mm", "outer.bar_length=50.1730 mm",
    "outer.flange_length=8.3922 mm",
]  # fmt: skip


def test_a_contact_that_only_inertia_presses_at_90_degrees_is_no_load_far_too_high():
    found = flexbearing.run(*FOUR_POINTS)
    assert found.attributes["status"] == "converged"
    angles, loads = np.degrees(found.flexible["contact_angle"]), found.flexible["contact_load"]
    steep = (np.abs(angles) > 89.9) & (loads > 0)
    assert 0 < loads[steep].max() < 1e-3 * loads.max()


@pytest.mark.slow
def test_light_balls_on_the_walls_of_their_grooves_do_not_hide_a_balance():
    """Of whole contacts: balls of 0.1 N beside others of 50 kN stopped the search as "too soft"."""
    found = flexbearing.run(RADIAL[0], [*RADIAL[1], "coupling.fallback=false"])
    assert found.attributes["ending"] == "over the shoulder"
    assert "whole ones would be in balance" in found.attributes["message"]


def test_rings_beyond_a_limit_point_have_no_balance_by_any_method():
    """The square of the determinant falls in a straight line to zero at 0.674256 of the compliance.

    Contact angles are 73.8 degrees there, beyond shoulders of 64; by smaller steps than those of the program.
    """
    found = flexbearing.run(*CAGE)
    assert (found.attributes["ending"], [*found.attributes["attempts"]]) == ("too soft", ["newton"])
    angle = float(found.attributes["message"].split("angles reach ")[1].split(" deg")[0])
    assert angle == approx(73.8, abs=0.2)
