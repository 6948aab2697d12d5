"""A full solve of the solids in every iteration, against the same solids condensed once."""

import numpy as np
import pytest
from pytest import approx

import fem
import flexbearing
from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.coupled.coupled import BearingPartner
from flexbearing.coupling import RULES, PartnerFailed, RacewayPair, StoppingCriterion, fixed_point, newton
from flexbearing.rings.full_solve import FullSolveRaceway
from flexbearing.rings.raceways import CondensedRaceway, RigidRaceway
from tests.bearings import paper_bearing
from tests.fem.condensed import as_solid
from tests.places import CONFIGS

PAPER = CONFIGS / "mao2016.toml"
FULL = ["coupling.structure=full", "coupling.method=iqn-ils"]
RING = ["inner.kind=rigid", "outer.kind=ring", "outer.thickness=3.6 mm"]
COARSE = [
    "bearing.rollers=12", "accuracy.slices=4", "accuracy.axial_shapes=2", "accuracy.element_order=2",
    "accuracy.mesh_size=12 mm", "accuracy.raceway_mesh_size=4 mm", "accuracy.patch_width=1.5 mm",
    "accuracy.threads=1",
]  # fmt: skip

STEEL = fem.Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
BEARING = paper_bearing(rollers=11, slices=4, axial_modes=2, load=6000.0, azimuth=0.1)
MESH = fem.MeshSize(order=2, size=12e-3, raceway_size=4e-3)
# Three bars and eleven rollers, or a ring and uneven ones, share no symmetry that condensing could even out.
CAGE = fem.SquirrelCage(
    raceway_diameter=75e-3, elastic=STEEL, thickness=3.6e-3, width=10e-3, bars=3, bar_width=20e-3,
    bar_thickness=2.6e-3, bar_length=10.25e-3, flange_length=5e-3,
)  # fmt: skip
PLAIN = fem.OuterRing(
    raceway_diameter=40e-3, elastic=STEEL, thickness=3e-3, width=8e-3, support=fem.ClampedFace()
)


@pytest.fixture(scope="module")
def solids():
    """Two raceways as they are solved, and as they are condensed; the first stands for an inner one."""
    from fem.solid.factored_solid import factored
    from fem.solid.full_solve import FullSolve

    azimuths = BEARING.bearing.azimuths
    uneven = azimuths + 0.1 * np.random.default_rng(5).random(azimuths.size)
    found = []
    for part, places in ((PLAIN, uneven), (CAGE, azimuths)):
        patches = fem.Patches(azimuths=tuple(places), length=5e-3, axial_modes=2, width=1.5e-3)
        solved = FullSolve(solid=factored(part, patches, MESH, 1))
        found.append((solved, as_solid(part, patches, MESH, 1)))
    inner, outer = found
    return inner, outer


def full(solved, name="ring"):
    return FullSolveRaceway(name, solved)


@pytest.mark.slow
def test_full_solve_answers_as_the_condensed_operator(solids):
    (inner, condensed_inner), (outer, condensed_outer) = solids
    forces = 1e3 * np.random.default_rng(1).normal(size=(2, 11, 2))
    solved = RacewayPair(full(inner), full(outer))
    once = RacewayPair(CondensedRaceway(condensed_inner), CondensedRaceway(condensed_outer))
    (expected, known), (found, unknown) = once.answer(forces), solved.answer(forces)
    assert known is not None
    assert unknown is None  # a tangent costs as much as many answers
    assert found == approx(expected, rel=0, abs=1e-9 * np.abs(expected).max())
    moved = np.array([full(inner).answer(-forces[0])[1], full(outer).answer(forces[1])[1]])
    assert moved == approx(once.linearised(forces).translation(forces), rel=1e-9)


@pytest.mark.slow
def test_solids_condensed_at_the_end_are_those_condensed_at_once(solids):
    for solved, once in solids:
        again = solved.condensed()
        assert again.absolute == approx(once.absolute, rel=0, abs=1e-12 * np.abs(once.absolute).max())
        assert again.support_stiffness == approx(once.support_stiffness, rel=1e-12)
        assert (again.unknowns, again.elements) == (once.unknowns, once.elements)


@pytest.mark.slow
def test_coupled_loads_are_those_of_the_condensed_operator(solids):
    _, (solved, once) = solids
    partner, rigid = BearingPartner(BEARING), BEARING.solve()
    criterion, inner = StoppingCriterion(tolerance=1e-10, limit=100), RigidRaceway(BEARING.bearing.azimuths)
    *_, expected = newton(partner, RacewayPair(inner, CondensedRaceway(once)), rigid, criterion)
    assert np.abs(expected.state.forces - rigid.forces).max() > 100  # [N]: the cage matters
    for method in ("iqn-ils", "aitken"):
        *_, last = fixed_point(partner, RacewayPair(inner, full(solved)), rigid, criterion, RULES[method])
        assert last.status == "converged"
        largest = expected.state.forces.max()
        assert last.state.forces == approx(expected.state.forces, rel=0, abs=1e-8 * largest)


def test_solve_that_fails_has_the_name_of_its_ring():
    from fem.errors import NotSolved

    class Torn:
        def answer(self, forces):
            raise NotSolved("relative residual 1")

    with pytest.raises(PartnerFailed, match="outer ring: relative residual 1"):
        full(Torn(), "outer ring").answer(np.zeros((3, 2)))


@pytest.mark.slow
def test_run_solves_the_whole_ring_in_every_iteration():
    found = flexbearing.run(PAPER, [*RING, *COARSE, *FULL])
    assert found.attributes["status"] == "converged"
    assert list(found.attributes["attempts"]) == ["iqn-ils"]
    assert found.attributes["structure"]["outer"]["unknowns"] > 1000
    flexible = found.flexible
    assert np.abs(flexible["outer_deviation"]).max() > 1e-6
    assert flexible["total_stiffness"] < flexible["stiffness"]
    tried = [*RING, *COARSE, *FULL, "coupling.max_iterations=2"]
    stopped = flexbearing.run(PAPER, tried)
    assert list(stopped.attributes["attempts"]) == ["iqn-ils", "aitken", "relaxed"]


def test_stiffness_does_not_depend_on_the_method():
    """Also where raceways stood still while the bearing was solved, they yield to a change of the load."""
    ring = [*RING, "accuracy.structure=beam", "accuracy.slices=8"]
    by_newton, alternated = (
        flexbearing.run(PAPER, [*ring, f"coupling.method={method}"]) for method in ("newton", "iqn-ils")
    )
    for name in ("stiffness", "total_stiffness"):
        assert alternated.flexible[name] == approx(by_newton.flexible[name], rel=1e-5)
    assert by_newton.flexible["stiffness"] < by_newton.rigid["stiffness"]


REFUSED = {
    "newton": (["coupling.method=newton"], r"\[coupling\] method .*needs the compliance of the rings"),
    "sections": (["accuracy.structure=harmonics"], r"\[accuracy\] structure.*uses the whole solids"),
    "beam": (["accuracy.structure=beam"], r"\[accuracy\] structure.*uses the whole solids"),
    "target": (["accuracy.target=1 %"], r"\[accuracy\] target.*condensed rings"),
    "fit": (["inner.kind=ring_on_shaft", "inner.fit=frictionless"], r"\[inner\] fit.*only a bonded ring"),
    "springs": (["outer.support=foundation", "outer.foundation_radial=1 N/mm^3"], r"\[outer\] support"),
    "lines": (
        ["outer.support=lines", 'outer.line_azimuths=["0 deg", "120 deg", "240 deg"]'],
        r"\[outer\] support.*have no solid",
    ),
    "planet": (
        [
            "outer.support=planet", 'outer.tooth_azimuths=["90 deg"]', 'outer.tooth_radial=["0 N"]',
            'outer.tooth_tangential=["1 N"]',
        ],
        r"\[outer\] support.*have no solid",
    ),
    "clearance": (
        [
            "outer.support=housing", "outer.housing_thickness=10 mm", "outer.housing_width=12 mm",
            "bearing.fits.housing.interference=-10 um", "operation.temperatures.housing=218 degC",
        ],
        r"\[bearing.fits\] housing.*only a bonded ring",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("settings", "told"), REFUSED.values(), ids=REFUSED.keys())
def test_what_has_no_full_solve_is_refused_on_reading(settings, told):
    with pytest.raises(BadCase, match=told):
        read_case(PAPER, [*RING, *FULL, *settings])


def test_solids_may_be_asked_for_by_name():
    assert read_case(PAPER, [*RING, *FULL, "accuracy.structure=solid"])


@pytest.mark.slow
def test_condensing_evens_out_what_the_mesh_breaks_of_a_symmetry():
    """Where rollers and ring share one, both answers differ by an error of the mesh, which falls."""
    from fem.solid.factored_solid import factored
    from fem.solid.full_solve import FullSolve

    azimuths = 2 * np.pi * np.arange(10) / 10
    patches = fem.Patches(azimuths=tuple(azimuths), length=5e-3, axial_modes=2, width=1.2e-3)
    forces, gaps = np.random.default_rng(1).normal(size=(10, 2)), []
    for order, size, raceway_size in ((2, 5e-3, 3e-3), (3, 3e-3, 2e-3)):
        mesh = fem.MeshSize(order=order, size=size, raceway_size=raceway_size)
        solved = FullSolve(solid=factored(PLAIN, patches, mesh, 1))
        expected = np.tensordot(solved.condensed().absolute, forces, axes=2)
        gaps.append(np.abs(solved.answer(forces)[0] - expected).max() / np.abs(expected).max())
    assert 0.01 < gaps[0] < 0.1
    assert gaps[1] < 0.1 * gaps[0]
