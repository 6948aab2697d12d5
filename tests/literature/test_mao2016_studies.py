"""Mao, Wang and Zhang (2016): the studies of their figures, and what turns the life over the thickness."""

from collections.abc import Sequence

import pytest
from pytest import approx

import flexbearing
from flexbearing import __main__ as program
from tests.places import CONFIGS

STUDIES = sorted((CONFIGS / "studies").glob("mao2016_*.toml"))
THIN, THICK = "2.9 mm", "5.1 mm"
QUICK = {"accuracy.structure": "smeared", "inner.kind": "rigid"}
ELASTIC = {"inner.kind": "ring_on_shaft"}


@pytest.mark.parametrize(
    "file",
    [
        pytest.param(file, marks=pytest.mark.slow) if file.stem == "mao2016_tolerances" else file
        for file in STUDIES
    ],
    ids=[file.stem for file in STUDIES],
)
def test_every_variant_of_the_studies_can_be_computed(file, capsys):
    assert program.command(["study", str(file), "--check"]) == 0
    assert "all of them can be computed" in capsys.readouterr().out


def ratios(settings: dict, thicknesses: Sequence[str] = (THIN, THICK)) -> list[float]:
    """Flexible over rigid life at some thicknesses of the outer ring."""
    found = []
    for thickness in thicknesses:
        case = {"outer.thickness": thickness, **QUICK, **settings}
        summary = flexbearing.run(CONFIGS / "mao2016.toml", case).summary()
        found.append(summary["flexible"]["life_L10_Mrev"] / summary["rigid"]["life_L10_Mrev"])
    return found


@pytest.mark.slow
def test_life_rises_with_the_thickness_where_the_tilt_is_held():
    """1.05 and 1.36 as measured; independent programs found 1.06 and 1.36."""
    thin, thick = ratios({"operation.tilt": "fixed", "accuracy.structure": "harmonics", **ELASTIC})
    assert (thin, thick) == (approx(1.06, abs=0.03), approx(1.36, abs=0.03))


@pytest.mark.slow
def test_life_hardly_depends_on_the_thickness_where_the_tilt_is_free():
    """2.36 and 2.37 on half a pitch, 2.41 and 2.42 with an elastic inner ring; independent programs: 2.38."""
    thin, thick = ratios({"operation.tilt": "free"})
    assert thin == approx(2.36, abs=0.04)
    assert thick == approx(thin, rel=0.02)


@pytest.mark.slow
@pytest.mark.parametrize(
    "change",
    [
        pytest.param(lambda t: {"outer.bar_thickness": f"{t - 1:.3g} mm"}, marks=pytest.mark.slow),
        lambda t: {"outer.bar_length": "5 mm"},
        pytest.param(lambda t: {"outer.bar_ends": "both"}, marks=pytest.mark.slow),
        lambda t: {"bearing.clearance": f"{75.5 - 5 * (t - 3.6):.6g} um"},
    ],
    ids=["bars that thicken", "bars of 5 mm", "bars at both ends", "clearance that shrinks"],
)
def test_life_falls_with_the_thickness(change):
    """By 3 to 5 % on half a pitch (`docs/howto/paper-figures.md`)."""
    (thin,), (thick,) = (ratios(change(t), (f"{t} mm",)) for t in (2.9, 5.1))
    assert 0.92 * thin < thick < 0.98 * thin


@pytest.mark.slow
def test_tilt_does_not_matter_with_bars_at_both_ends():
    """A ring that is held alike at both ends does not cone."""
    free, held = (
        ratios({"outer.bar_ends": "both", "operation.tilt": tilt}, (THIN,)) for tilt in ("free", "fixed")
    )
    assert held == approx(free, rel=1e-3)
