"""Every run says how far its resolution may put the life off."""

import pytest
from pytest import approx

import flexbearing
from flexbearing.report.output import text
from tests.flexbearing.noted import codes
from tests.places import CONFIGS

PLAIN = CONFIGS / "nu209.toml"
FINE = ["accuracy.slices=320", "accuracy.axial_shapes=6", "accuracy.raceway_mesh_size=2 mm"]
STRAIGHT = ["bearing.roller.profile=straight"]
LOGARITHMIC = ["bearing.roller.profile=logarithmic", "bearing.roller.drop=2.5 um"]
TILTED = ["operation.misalignment=4 arcmin"]


def ring(millimetres):
    return [
        "outer.kind=ring",
        f"outer.thickness={millimetres} mm",
        "outer.width=19 mm",
        "outer.support=side",
        "operation.tilt=fixed",
    ]


def error_and_truth(folder, *settings):
    usual = flexbearing.run(PLAIN, [*settings], output=folder / "usual.h5")
    fine = flexbearing.run(PLAIN, [*settings, *FINE], output=folder / "fine.h5")
    truth = float(usual.flexible["life_L10"] / fine.flexible["life_L10"]) - 1
    return usual, float(usual.flexible["life_error"]), abs(truth)


@pytest.mark.slow
def test_thin_ring_with_carrying_edges_says_that_its_life_is_wrong(tmp_path):
    result, error, truth = error_and_truth(tmp_path, *ring(1.5), *STRAIGHT, *TILTED)
    assert truth > 0.15
    assert truth < error < 1.5 * truth
    assert "life-resolution" in codes(result, "outside validity")
    assert result.summary()["flexible"]["life_error_percent"] == approx(100 * error)
    assert "its numerical error, estimated" in " ".join(text(result).split())


@pytest.mark.slow
def test_thick_ring_is_resolved_and_not_told(tmp_path):
    result, error, truth = error_and_truth(tmp_path, *ring(6), *STRAIGHT, *TILTED)
    assert truth < error < 0.01
    assert "life-resolution" not in codes(result)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("profile", "tilt", "load"),
    [(STRAIGHT, TILTED, 5), (STRAIGHT, [], 20), (LOGARITHMIC, TILTED, 20), (LOGARITHMIC, [], 5)],
    ids=["straight, tilted", "straight, 20 kN", "logarithmic, tilted, 20 kN", "logarithmic"],
)  # every pair of two of them
@pytest.mark.parametrize("thickness", [1.5, 3, 6])
def test_error_is_not_below_the_truth(tmp_path, thickness, profile, tilt, load):
    settings = *ring(thickness), *profile, *tilt, f"operation.radial_load={load} kN"
    _, error, truth = error_and_truth(tmp_path, *settings)
    assert truth < error + 0.003
    assert error < 5 * truth + 0.01


def test_a_target_has_its_own_estimate():
    result = flexbearing.run(PLAIN, ["accuracy.target=1 %"])
    assert "life_error" not in result.rigid
    assert result.summary()["rigid"]["life_error_percent"] is None
