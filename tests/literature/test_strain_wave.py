"""Loads of 23 balls between an elliptic cam and a thin ring, against a planar beam of another program.

Source: an independent program, a planar beam (R 28.3815 mm, 2 mm by 8 mm, E I 1.0987 N m^2) around balls
of 4.763 mm on a pitch circle of 50 mm, conformities 0.52, no clearance, contacts in series; linear, and
nonlinear with finite rotations (Fourier, 40 harmonics, contact along the normal of the deformed ring). Loads
[N] of balls 0, 1, 2, 3, 4, 9, 10 and 11 from the major axis.
"""

import numpy as np
import pytest
from pytest import approx

import quasidynamic as qd
from flexbearing.api import read_case
from flexbearing.build.out_of_round import approaches_on_cam
from flexbearing.runs.not_round import LARGE
from quasidynamic.balance.balls.elastic_grooves import ElasticGroove, ElasticGrooves
from tests.deep_groove import STEEL

CASE = "configs/strain_wave.toml"
BALLS = [0, 1, 2, 3, 4, 9, 10, 11]
AZIMUTHS = 2 * np.pi * np.arange(23) / 23
RADIUS, BENDING, AREA, YOUNG = 28.3815e-3, 1.0987, 16e-6, 206e9
LINEAR = {
    0.1: [20.2, 19.1, 14.3, 2.7, 0, 8.9, 17.3, 20.0],
    0.2: [40.3, 38.3, 29.6, 6.2, 0, 19.1, 35.1, 39.9],
    0.4: [80.5, 76.6, 60.7, 14.0, 0, 41.0, 70.5, 79.6],
}
NONLINEAR = {
    (0.1, "cosine"): [20.3, 19.3, 15.1, 4.6, 0, 11.1, 17.8, 20.0],
    (0.2, "cosine"): [41.7, 39.7, 32.9, 17.3, 0, 26.6, 37.1, 41.2],
    (0.4, "cosine"): [110.1, 106.4, 93.6, 69.4, 37.8, 82.9, 101.3, 109.2],
    (0.1, "ellipse"): [20.7, 19.4, 14.3, 2.9, 0, 9.0, 17.4, 20.4],
    (0.2, "ellipse"): [42.2, 39.3, 29.2, 7.2, 0, 20.0, 35.2, 41.4],
    (0.4, "ellipse"): [89.3, 81.2, 59.1, 21.0, 0, 43.5, 71.5, 87.0],
    (0.1, "length_kept"): [20.1, 19.3, 14.9, 3.2, 0, 9.7, 17.7, 20.0],
    (0.2, "length_kept"): [39.9, 38.9, 32.2, 8.6, 0, 23.1, 36.6, 39.6],
    (0.4, "length_kept"): [79.8, 79.3, 71.5, 25.5, 0, 58.2, 76.7, 79.3],
}


def beam():
    """The ring as a planar beam, which only gives way radially, on springs of 10 kN/m."""
    apart = AZIMUTHS[:, None] - AZIMUTHS
    n = np.arange(2, 400)[:, None, None]
    bending = (np.cos(n * apart) / (n**2 - 1) ** 2).sum(0) * RADIUS**3 / (np.pi * BENDING)
    radial = bending + RADIUS / (2 * np.pi * YOUNG * AREA) + np.cos(apart) / 1e4
    angles = np.array([-0.3, 0.0, 0.3])
    return ElasticGroove(angles, np.einsum("ij,k,l->ikjl", radial, np.cos(angles), np.cos(angles)))


def loads(approaches):
    groove = qd.Groove(conformity=0.52, material=STEEL)
    bearing = qd.AngularContactBearing(
        ball=qd.Ball(diameter=4.763e-3, material=STEEL), inner=groove, outer=groove, balls=23,
        pitch_diameter=50e-3, contact_angle=0.0, approaches=tuple(approaches),
    )  # fmt: skip
    held = qd.RingOperation(load=(0,) * 5, displacement=(0.0,) * 5, inner_speed=0.0)
    state = qd.AngularContactBallBearing(bearing=bearing).solve(held, ElasticGrooves(None, beam()))
    return state.loads[1][BALLS]


@pytest.mark.parametrize("amplitude", LINEAR)
def test_linear_loads_on_a_beam(amplitude):
    found = loads(1e-3 * amplitude * np.cos(2 * AZIMUTHS))
    assert found == approx(LINEAR[amplitude], abs=0.15)


@pytest.mark.parametrize(("amplitude", "curve"), NONLINEAR)
def test_the_stated_error_covers_large_deflection(amplitude, curve):
    """Without the length of the ring in the shape, a cosine of 0.4 mm would be 27 % off."""
    case = read_case(CASE, {"inner.cam_amplitude": f"{amplitude} mm", "inner.cam_curve": curve})
    found, wanted = loads(approaches_on_cam(case, AZIMUTHS)).max(), max(NONLINEAR[amplitude, curve])
    error = LARGE * 1e-3 * amplitude / 25e-3
    assert found == approx(wanted, rel=error)
    assert found == approx(wanted, rel=0.03) or (amplitude, curve) == (0.4, "cosine")
