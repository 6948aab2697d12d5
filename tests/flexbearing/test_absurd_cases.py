"""Cases that once ended in an internal error, in warnings of libraries or never; found by mutated cases."""

import pytest

import fem
import flexbearing.api
from fem.errors import NotSolved
from fem.mesh.axial_section import AxialSection
from fem.mesh.expense import LARGEST, require_affordable
from fem.mesh.section_mesh import meshed
from fem.raceway.harmonics import FEWEST, MOST, highest_harmonic, resolving
from flexbearing.__main__ import command
from flexbearing.case import BadCase
from flexbearing.case.declarations import declarations
from flexbearing.families import FAMILIES
from quasidynamic import ImpossiblePart, Material, OutOfRange, Roller, oil_at
from quasidynamic.parts.oil_curves import two_point_oil
from tests.flexbearing.noted import texts
from tests.mutated_cases import CONFIGS, based_on, written

PAPER, PLAIN, HARRIS = (CONFIGS / f"{name}.toml" for name in ("mao2016", "nu209", "harris218"))
FOUR_POINT = CONFIGS / "joshi2015_ex50.toml"
COARSE = ("outer.kind=rigid", "accuracy.slices=8", "accuracy.axial_shapes=2", "accuracy.element_order=3")


@pytest.mark.parametrize(
    ("case", "setting", "size"),
    [
        (FOUR_POINT, "materials.ball.youngs_modulus=5e-324 Pa", "1 to 1e+20 Pa"),
        (PLAIN, "operation.inner_speed=9223372036854775808 rpm", "1e-09 to 1e+06 rad/s"),
        (PLAIN, "operation.radial_load=1e300 N", "1e-09 to 1e+10 N"),
        (PLAIN, "bearing.clearance=1e-300 m", "1e-12 to 1000 m"),
        (HARRIS, "bearing.ball.diameter=5e-324 m", "1e-12 to 1000 m"),
        (PLAIN, "lubricant.viscosity=1e9 mPa s", "1e-07 to 10000 Pa s"),
    ],
    ids=lambda value: str(value).partition("=")[0] if "=" in str(value) else None,
)
def test_quantity_of_a_size_that_no_bearing_has_is_refused(case, setting, size):
    with pytest.raises(BadCase, match="is not of a size from") as problem:
        flexbearing.api.check(case, [setting])
    assert size in str(problem.value)


def test_every_example_and_default_of_a_quantity_has_a_size_that_is_allowed():
    for item in declarations(FAMILIES):
        if item.kind and not item.example.startswith("["):
            item.kind.to_si(item.example.strip('"'))


@pytest.mark.parametrize(
    ("case", "setting"),
    [
        (FOUR_POINT, "friction.coefficient=5e-324"),
        (FOUR_POINT, "bearing.inner.conformity=1e308"),
        (HARRIS, "bearing.inner.radius=11.115000001 mm"),
        (CONFIGS / "rivera2021_7008.toml", "bearing.inner.conformity=0.5000000000000001"),
        (PLAIN, "bearing.roller.length=0.00005 mm"),
        (PLAIN, "materials.roller.youngs_modulus=1 kPa"),
    ],
)
def test_value_that_leaves_the_range_of_numbers_is_refused(case, setting):
    with pytest.raises(BadCase, match="it must be"):
        flexbearing.api.check(case, [setting])


@pytest.mark.parametrize("length", [1e-6, 1.0])
def test_neither_a_disc_nor_a_wire_is_a_roller(length):
    steel = Material(youngs_modulus=207e9, poisson_ratio=0.3, density=7850)
    with pytest.raises(ImpossiblePart, match="neither a roller nor a needle"):
        Roller(diameter=10e-3, length=length, material=steel)


@pytest.mark.slow
def test_oil_that_is_nearly_solid_in_a_trial_state_raises_no_warning(tmp_path):
    """The start without contact friction tries slips and pressures at which the viscosity overflows."""
    settings = [
        "bearing.roller.profile=straight", "lubricant.pressure_viscosity=42.171 1/GPa",
        "lubricant.inlet_temperature=95.18 degC", "lubricant.oil_fraction=0.018205",
        "materials.roller.density=16741 kg/m^3",
    ]  # fmt: skip
    result = flexbearing.run(PLAIN, settings, output=tmp_path / "thick.h5")  # warnings are errors in tests
    assert result.attributes["status"] in ("converged", "not solved")


def test_contact_as_wide_as_the_ball_has_no_rolling_lines():
    result = flexbearing.run(CONFIGS / "rivera2021_7008.toml", [
        "operation.load.radial_z=3 MN"
    ])  # fmt: skip
    assert result.attributes["status"] == "converged"
    assert any("the load is far too high" in note for note in texts(result))


@pytest.mark.slow
def test_ring_whose_fit_needs_more_harmonics_is_solved(tmp_path):
    """The usual number of harmonics in a fit left every method without a solution."""
    code = command([
        "run", str(PAPER), "-o", str(tmp_path / "fit.h5"),
        *(word for setting in (
            *COARSE, "inner.fit=frictionless", "bearing.fits.shaft_interference=60 um",
            "bearing.roller.diameter=6.7165 mm",
            "accuracy.threads=1", 'operation.temperatures.shaft_along.at=["-20 mm", "20 mm"]',
            'operation.temperatures.shaft_along.temperatures=["220 degC", "240 degC"]',
        ) for word in ("--set", setting)),
    ])  # fmt: skip
    assert code == 0
    assert flexbearing.read(tmp_path / "fit.h5").attributes["status"] == "converged"


@pytest.mark.parametrize("key", ["mesh_size", "raceway_mesh_size"])
def test_mesh_of_far_too_many_elements_is_refused_before_it_is_made(key):
    settings = ["inner.kind=rigid", "outer.kind=ring", f"accuracy.{key}=1 um"]
    result = flexbearing.run(PAPER, settings)
    assert result.attributes["status"] == "not solved"
    assert "unknowns on the axial section; allowed are" in result.attributes["message"]


def test_solid_of_far_too_many_elements_is_refused_before_it_is_made():
    settings = ["inner.kind=rigid", "outer.kind=ring", "accuracy.structure=solid", "accuracy.mesh_size=50 um"]
    result = flexbearing.run(PAPER, settings)
    assert result.attributes["status"] == "not solved"
    assert "unknowns in the solid; allowed are" in result.attributes["message"]


@pytest.mark.slow
def test_estimate_of_unknowns_is_near_what_the_mesh_has():
    corners = (0.0, 0.1, None), (0.05, 0.1, "raceway"), (0.05, 0.12, None), (0.0, 0.12, None)
    body, size = AxialSection("ring", corners), fem.MeshSize(order=3, size=0.5e-3, raceway_size=0.5e-3)
    estimate = require_affordable(2, [(1e-3, 0.14)], body.loaded, size)
    elements = meshed([body], size).ne
    assert body.loaded == pytest.approx(0.05)
    assert estimate == pytest.approx(elements * 1.5 * 9, rel=0.5)
    assert LARGEST[2] > estimate


def test_the_least_harmonics_are_taken_and_resolved_on_any_mesh():
    mesh = fem.MeshSize(order=2, size=12e-3, raceway_size=4.0)
    assert highest_harmonic(37e-3, 2e-3, mesh) == FEWEST
    finer = resolving(fem.Resolution(length=2e-3, mesh_size=mesh), 37e-3, FEWEST)
    assert highest_harmonic(37e-3, 2e-3, finer.mesh, FEWEST) == FEWEST


def test_harmonics_have_an_upper_limit():
    mesh = fem.MeshSize(order=5, size=1e-4, raceway_size=1e-4)
    with pytest.raises(NotSolved, match=f"allowed are {MOST} or fewer: a larger patch"):
        highest_harmonic(50.0, 1e-4, mesh)


def test_coefficients_of_friction_are_not_next_to_nothing(tmp_path):
    curve = "friction.coefficient=", 'friction.pressures=["1 GPa"]', "friction.coefficients=[1e-300]"
    (tmp_path / "slippery.toml").write_text(written(based_on("joshi2015_qj309", curve)))
    with pytest.raises(BadCase, match="at least 1e-6 and at most 1"):
        flexbearing.api.check(tmp_path / "slippery.toml")


@pytest.mark.parametrize(
    ("viscosities", "alphas", "name"),
    [
        (((372.47, 68e-6), (373.15, 8.5e-6)), ((313.15, 20e-9),), "viscosity"),
        (((313.15, 68e-6), (373.15, 8.5e-6)), ((313.15, 20e-9), (313.16, 15e-9)), "pressure_viscosity"),
    ],
    ids=["viscosity", "pressure-viscosity"],
)
def test_points_of_a_data_sheet_that_lie_together_are_told(viscosities, alphas, name):
    oil = two_point_oil(
        "sheet", viscosities=viscosities, density=880.0, pressure_viscosities=alphas, conductivity=0.13,
        source="nowhere",
    )  # fmt: skip
    with pytest.raises(OutOfRange, match=f" {name} = .* must lie apart"):
        oil_at(oil, 343.15 if name == "viscosity" else 303.15)


def test_sizes_stand_in_explain():
    assert "size     1e-12 to 1000 m" in flexbearing.api.explain("bearing.clearance")
