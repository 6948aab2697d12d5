"""Newton alone brings ordinary bearings and rings to an equilibrium, also those that it once did not."""

from pathlib import Path

import numpy as np
import pytest
from pytest import approx
from threadpoolctl import threadpool_limits

import flexbearing
from tests.random_coupled import design

PLAIN = Path(__file__).parents[2] / "configs" / "nu209.toml"
ALONE = ["coupling.method=newton", "coupling.fallback=false"]
RING = [
    "outer.kind=ring", "outer.thickness=5 mm", "outer.width=19 mm", "outer.support=foundation",
    "outer.bilateral=true", "operation.tilt=fixed", "accuracy.element_order=3",
]  # fmt: skip
HEAVY = ["operation.radial_load=20 kN", "operation.inner_speed=100 rpm"]
FAST = ["operation.radial_load=8 kN", "operation.inner_speed=3000 rpm"]
STIFFER = ["outer.foundation_radial=100 N/mm^3", *HEAVY]
SOFTER = ["outer.foundation_radial=10 N/mm^3", *FAST]


@pytest.mark.parametrize("foundation", [SOFTER, STIFFER], ids=["10 N/mm3, 8 kN", "100 N/mm3, 20 kN"])
def test_newton_alone_solves_a_ring_on_a_foundation(foundation, tmp_path):
    result = flexbearing.run(PLAIN, tmp_path / "ring.h5", [*RING, *foundation, *ALONE])
    assert result.attributes["status"] == "converged"
    assert list(result.attributes["attempts"]) == ["newton"]
    other = ["coupling.method=iqn-ils", "coupling.fallback=false"]
    alternated = flexbearing.run(PLAIN, tmp_path / "again.h5", [*RING, *foundation, *other])
    load = result.flexible["inner_load"]
    assert load == approx(alternated.flexible["inner_load"], abs=1e-6 * load.max())


@pytest.mark.slow
@pytest.mark.parametrize("slope", ["0 arcmin", "3 arcmin"])
@pytest.mark.parametrize(("width", "length"), [(5, 10), (5, 20), (10, 20)])
def test_newton_alone_solves_a_thin_cage_on_three_bars(width, length, slope, tmp_path):
    """The oil is so stiff that slips of 1e-11 decide: those of one roller are far from balance at another."""
    settings = [
        "outer.kind=squirrel_cage", "outer.thickness=1.2 mm", "outer.width=19 mm", "outer.bars=3",
        f"outer.bar_width={width} mm", "outer.bar_thickness=0.8 mm", f"outer.bar_length={length} mm",
        "outer.flange_length=5 mm", "accuracy.element_order=2", "operation.tilt=fixed",
        "operation.radial_load=20 kN", f"operation.misalignment={slope}",
    ]  # fmt: skip
    result = flexbearing.run(PLAIN, tmp_path / "cage.h5", [*settings, *ALONE])
    assert result.attributes["status"] == "converged"
    assert result.attributes["iterations"] <= 25  # 13 to 19
    assert not np.array_equal(result.flexible["outer_load"], result.rigid["outer_load"])


@pytest.mark.slow
@pytest.mark.parametrize("number", range(40, 60))
def test_random_bearing_ends_with_a_word_and_a_complete_file(number, tmp_path):
    """The designs are those of `benchmarks/random_coupled.py`."""
    chosen = design(14, number)
    case = Path(__file__).parents[2] / chosen.case
    with threadpool_limits(limits=1, user_api="blas"):
        result = flexbearing.run(case, tmp_path / "design.h5", chosen.settings)
    assert result.attributes["status"] == "converged"
    assert list(result.attributes["attempts"]) == ["newton"]
    assert not np.array_equal(result.flexible["outer_load"], result.rigid["outer_load"])
