"""Every balance of rollers, ring and cage closes with what a result file holds, and with nothing else."""

import numpy as np
import pytest
from pytest import approx

import flexbearing
from tests.balances import FORCES, balances, largest_imbalance
from tests.cold_oil import PAPER

NU209 = PAPER.parent / "nu209.toml"
RIGID = ("outer.kind=rigid", "inner.kind=rigid", "operation.tilt=fixed")
FREE_CAGE = ("bearing.cage.centre=free", "bearing.cage.unbalance=20 um", "lubricant.churning_gap=0.5 mm")
INNER_GUIDED = ("bearing.cage.guidance=inner", "bearing.cage.land_diameter=65.4 mm", *FREE_CAGE)
FLANGED = (
    "bearing.flange.ring=outer",
    "bearing.flange.clearance=30 um",
    "bearing.flange.height=2 mm",
    "bearing.flange.roller_chamfer=0.4 mm",
    "bearing.flange.stiffness=100 N/um",
    "bearing.flange.friction=0.05",
)
RIBS = (
    "bearing.ribs.inner_height=1.5 mm",
    "bearing.ribs.outer_height=1.2 mm",
    "bearing.ribs.end_radius=500 mm",
    "bearing.ribs.friction=0.05",
)
CASES = {
    "ordinary": (NU209, ()),
    "thrust": (NU209, (*RIBS, "operation.axial_load=1 kN", "operation.misalignment=1 arcmin")),
    "thrust reversed, ring and cage free": (
        NU209,
        (*RIBS, "operation.axial_load=-1 kN", "operation.tilt=free", "operation.outer_speed=-500 rpm"),
    ),
    "fast": (PAPER, RIGID),
    "misaligned": (NU209, ("operation.misalignment=2 arcmin",)),
    "moment": (NU209, ("operation.tilt=free", "operation.moment=20 N m")),
    "two rows": (
        NU209,
        (
            "bearing.second_row.distance=25 mm",
            "bearing.second_row.clearance=8 um",
            "bearing.second_row.azimuth=6 deg",
            "operation.tilt=free",
            "operation.moment=40 N m",
            "operation.tilt_direction=75 deg",
        ),
    ),
    "two rows, misaligned": (
        NU209,
        ("bearing.second_row.distance=25 mm", "operation.misalignment=2 arcmin", *FLANGED),
    ),
    "slow and light": (NU209, ("operation.inner_speed=20 rpm", "operation.radial_load=50 N")),
    "free cage, churning": (PAPER, (*RIGID, *FREE_CAGE)),
    "free cage on the inner ring": (PAPER, (*RIGID, *INNER_GUIDED, "operation.outer_speed=-9000 rpm")),
    "load and gravity aside": (
        NU209,
        (
            "operation.load_direction=40 deg",
            "operation.gravity_direction=-70 deg",
            "operation.inner_speed=-900 rpm",
        ),
    ),
    "flanges": (NU209, ("operation.misalignment=2 arcmin", *FLANGED)),
}


SLOW = {"slow and light"}  # dear
PARAMS = [
    pytest.param(case, id=name, marks=pytest.mark.slow if name in SLOW else ())
    for name, case in CASES.items()
]


@pytest.fixture(scope="module", params=PARAMS)
def result(request, tmp_path_factory):
    path, settings = request.param
    return flexbearing.run(path, list(settings), output=tmp_path_factory.mktemp("balances") / "r.h5")


def guidance(result):
    return result.attributes["case_si"]["bearing"]["cage"]["guidance"]


@pytest.mark.sampled(2)
def test_every_balance_closes_with_the_forces_of_the_file(result):
    assert largest_imbalance(result.rigid, guidance(result)) < 1e-10


def test_power_put_in_by_the_rings_is_the_sum_of_the_losses(result):
    block, speeds = result.rigid, result.attributes["case_si"]["operation"]
    power = block["driving_torque"] * speeds["inner_speed"] + block["outer_torque"] * speeds["outer_speed"]
    assert power == approx(float(block["driving_power"]), rel=1e-12)
    losses = ("sliding", "rolling", "drag", "pocket", "land", "churning", "ribs", "transport")
    assert sum(float(block[f"loss_{cause}"]) for cause in losses) == approx(float(power), rel=1e-8)


def test_moments_of_the_loads_are_those_of_the_stored_slices(result):
    block = result.rigid
    width = np.diff(block["slice_position"]).mean()
    for side in ("inner", "outer"):
        moment = block[f"{side}_slice_load"] @ block["slice_position"] * width
        size = block[f"{side}_load"].max() * block["slice_position"][-1]
        assert block[f"{side}_load_moment"] == approx(moment, rel=0, abs=1e-10 * size)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", sorted(set(FORCES) - {"applied_load", "inner_load"}))
def test_a_force_that_is_left_out_opens_a_balance(name):
    """None of the stored forces is there for show."""
    state = flexbearing.run(PAPER, list(RIGID))
    block = dict(state.rigid)
    block[name] = 0 * block[name]
    assert largest_imbalance(block, guidance(state)) > 1e-7


def test_flexible_rings_leave_the_balances_closed():
    settings = ["outer.kind=ring", "outer.width=19 mm", "outer.thickness=5 mm", "outer.support=foundation",
                "outer.foundation_radial=100 N/mm^3", "accuracy.structure=beam",
                "operation.tilt=free"]  # fmt: skip
    result = flexbearing.run(NU209, settings)
    assert result.attributes["status"] == "converged"
    assert largest_imbalance(result.flexible, "rollers") < 1e-9
    assert set(balances(result.flexible, "rollers")) >= {"radial", "along the motion", "spin", "tilt", "ring"}
