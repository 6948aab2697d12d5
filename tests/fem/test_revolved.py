"""Bodies of revolution by harmonics on their axial section."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from fem import ClampedFace, Elastic, ImpossiblePart, MeshSize, OuterRing, Patches
from fem.assembly.factorisation import NotSolved
from fem.assembly.harmonic_stiffness import answers, compliances
from fem.half_space.load_patch import half_space
from fem.mesh.axial_section import AxialSection, sections
from fem.section import expansion, revolved_body
from fem.section.revolved_body import Springs
from tests.fem.condensed import as_solid, by_harmonics
from tests.fem.test_parts import CAGE, SHAFT, STEEL

RING = OuterRing(raceway_diameter=75e-3, thickness=3.6e-3, width=10e-3, elastic=STEEL, support=ClampedFace())
L = 5e-3
ROLLERS = 2 * np.pi * np.arange(30) / 30
FAIR = MeshSize(order=5, size=6e-3, raceway_size=1.25e-3)
COARSE = MeshSize(order=4, size=4e-3, raceway_size=2e-3)
GLIDING = Springs(axial=1e20, radial=0.0, tangential=0.0)  # [N/m^3], as good as plane strain


def tube(inner, outer, width, material="ring", inside="inside", outside="outside"):
    """A plain section with named edges."""
    half = width / 2
    corners = (-half, inner, "left"), (half, inner, inside), (half, outer, "right"), (-half, outer, outside)
    return AxialSection(material, corners)


def held(sections, materials, mesh, **springs):
    return revolved_body.assembled(sections, materials, mesh, springs)


@pytest.fixture(scope="module")
def ring():
    return by_harmonics(RING, L, 3, FAIR)


@pytest.fixture(scope="module")
def shaft():
    return by_harmonics(SHAFT, L, 3, MeshSize(order=4, size=8e-3, raceway_size=1.25e-3))


@pytest.mark.parametrize(
    ("n", "inner", "outer_plane_stress"),
    [(2, -32.56987e-6, -35.33664e-6), (3, -4.618103e-6, -5.010069e-6), (4, -1.328627e-6, -1.441608e-6)],
)
def test_ring_in_plane_strain_is_the_exact_one(n, inner, outer_plane_stress):
    """Michell's solution: 37.5/41.1 mm, inward pressure 0.1 cos(n phi) MPa outside, E 203 GPa, nu 0.28."""
    body = held([tube(37.5e-3, 41.1e-3, 2e-3)], RING.materials, FAIR, left=GLIDING, right=GLIDING)
    pressure = revolved_body.edge_modes(body, "outside", 1)
    u = body.stiffness.solve(n, -0.1e6 * 2e-3 * 41.1e-3 * pressure)
    assert (revolved_body.edge_modes(body, "inside", 1).T @ u).item() == approx(inner, rel=1e-6)
    # a free ring of small width is nearly in plane stress
    thin = held([tube(37.5e-3, 41.1e-3, 0.5e-3)], RING.materials, FAIR, left=Springs(1.0, 0.0, 0.0))
    pressure = revolved_body.edge_modes(thin, "outside", 1)
    u = thin.stiffness.solve(n, -0.1e6 * 0.5e-3 * 41.1e-3 * pressure)
    assert (pressure.T @ u).item() == approx(outer_plane_stress, rel=1e-4)


def test_solid_shaft_in_plane_strain_is_the_exact_one():
    """Michell's solution of a full disc, u = -(kappa + 3) p b / (12 G), pressure p cos(2 phi) = 0.1 MPa."""
    b, nu = 29.8e-3, STEEL.poisson_ratio
    (shaft,) = [body for body in sections(replace(SHAFT, shaft_bore=0.0), L) if body.material == "shaft"]
    least = min(radius for _, radius, _ in shaft.corners)
    body = held([tube(least, b, 2e-3)], RING.materials, FAIR, left=GLIDING, right=GLIDING)
    pressure = revolved_body.edge_modes(body, "outside", 1)
    u = body.stiffness.solve(2, -0.1e6 * 2e-3 * b * pressure)
    shear = STEEL.youngs_modulus / (2 * (1 + nu))
    exact = -(3 - 4 * nu + 3) * 0.1e6 * b / (12 * shear)
    assert (pressure.T @ u).item() == approx(exact, rel=2e-4)


@pytest.mark.slow
def test_solid_shaft_is_the_limit_of_ever_smaller_bores():
    """What a bore takes from the stiffness falls with its square."""
    mesh = MeshSize(order=4, size=8e-3, raceway_size=1.25e-3)
    ring = [by_harmonics(replace(SHAFT, shaft_bore=d), L, 2, mesh, 20) for d in (0.0, 8e-3, 4e-3)]
    solid, wide, narrow = (parts.at(ROLLERS).support_stiffness for parts in ring)
    assert 0 < solid - narrow < 0.4 * (solid - wide)
    assert solid == approx(narrow, rel=1e-2)


@pytest.mark.slow
def test_ring_without_ribs_is_a_plain_tube_on_its_shaft():
    nu = replace(SHAFT, rib_diameter=None, track_width=SHAFT.width)
    ring, _ = sections(nu, L)
    assert {radius for _, radius, _ in ring.corners} == {nu.bore / 2, nu.raceway_diameter / 2}
    assert nu.track == nu.width
    mesh = MeshSize(order=4, size=8e-3, raceway_size=1.25e-3)
    plain, ribbed = (by_harmonics(part, L, 2, mesh, 20).at(ROLLERS).absolute for part in (nu, SHAFT))
    assert plain[0, 0, 0, 0] > ribbed[0, 0, 0, 0]  # ribs stiffen
    with pytest.raises(ImpossiblePart, match="track_width"):
        replace(SHAFT, rib_diameter=None)


@pytest.mark.parametrize(
    ("inner", "outer", "elastic", "density", "grown"),
    [
        (29.8e-3, 32.5e-3, STEEL, 7850.0, (18.72190e-6, 18.27572e-6)),
        (25.8e-3, 29.8e-3, Elastic(youngs_modulus=179e9, poisson_ratio=0.281), 8240.0, (None, 15.3279e-6)),
    ],
    ids=["ring", "shaft"],
)
def test_short_ring_grows_with_speed_as_in_plane_stress(inner, outer, elastic, density, grown):
    """Closed form for 38000 rpm, free ring."""
    springs = Springs(axial=1.0, radial=0.0, tangential=1.0)
    body = held([tube(inner, outer, 1e-3)], {"ring": elastic}, COARSE, left=springs)
    load = expansion.rotation(body, {"ring": density}, 38000 * 2 * np.pi / 60)
    for edge, expected in zip(("inside", "outside"), grown, strict=True):
        if expected is not None:
            assert expansion.radial_expansion(body, load, edge)[0] == approx(expected, rel=5e-4)


def lame_fit(a, b, c, inner, outer, strains):
    """Outer growth of two bonded tubes a < b < c in plane strain, each with a free expansion."""

    def plane_strain(m, e):
        nu = m.poisson_ratio
        return m.youngs_modulus / (1 - nu**2), nu / (1 - nu), (1 + nu) * e

    (E1, n1, e1), (E2, n2, e2) = plane_strain(inner, strains[0]), plane_strain(outer, strains[1])
    yields = b / E1 * ((b**2 + a**2) / (b**2 - a**2) - n1) + b / E2 * ((c**2 + b**2) / (c**2 - b**2) + n2)
    p = (e1 - e2) * b / yields
    return e2 * c + 2 * p * b**2 * c / E2 / (c**2 - b**2)


def test_hot_shaft_widens_its_ring_as_lame_says():
    """25.8/29.8/32.5 mm, shaft at 230, ring at 220 degC, no axial strain."""
    inner, strains = Elastic(youngs_modulus=179e9, poisson_ratio=0.281), (13.8e-6 * 210, 11.2e-6 * 200)
    body = held(
        [tube(25.8e-3, 29.8e-3, 4e-3, "shaft", outside="seat"), tube(29.8e-3, 32.5e-3, 4e-3, inside="seat")],
        {"shaft": inner, "ring": STEEL}, COARSE,
        left=replace(GLIDING, tangential=1.0), right=GLIDING,
    )  # fmt: skip
    load = expansion.heating(body, {"shaft": strains[0], "ring": strains[1]})
    expected = lame_fit(25.8e-3, 29.8e-3, 32.5e-3, inner, STEEL, strains)
    assert expansion.radial_expansion(body, load, "outside", 3) == approx(
        [expected, 0, 0], abs=1e-6 * expected
    )


def test_stiff_ring_on_springs_only_translates():
    """A load like cos(phi) of unit resultant moves it by 1 / (k 2 pi R l)."""
    stiff = Elastic(youngs_modulus=1e15, poisson_ratio=0.28)
    springs = Springs(axial=1e12, radial=1e12, tangential=1e12)
    body = held([tube(37.5e-3, 41.1e-3, 5e-3)], {"ring": stiff}, COARSE, outside=springs)
    inside = revolved_body.edge_modes(body, "inside", 1)
    W = inside.T @ body.stiffness.solve(1, inside) / (2 * np.pi)
    assert 2 * W.item() == approx(1 / (1e12 * 2 * np.pi * 41.1e-3 * 5e-3), rel=3e-4)


def test_floating_ring_is_noticed():
    body = held([tube(37.5e-3, 41.1e-3, 5e-3)], RING.materials, COARSE)
    with pytest.raises(NotSolved, match="held"):
        body.stiffness.solve(1, revolved_body.edge_modes(body, "inside", 2))


def test_pinched_free_ring_is_that_of_two_other_codes():
    """82.2/75 x 10 mm, two opposite line loads of 1 kN outside, bore at mid-width: 1.15124, -1.04936 mm."""
    springs = Springs(axial=1.0, radial=0.0, tangential=1.0)
    body = held([tube(37.5e-3, 41.1e-3, 10e-3)], RING.materials, FAIR, left=springs)
    outside, inside = (
        revolved_body.edge_modes(body, "outside", 1),
        revolved_body.edge_modes(body, "inside", 7),
    )
    middle = np.array([1, 0, -1 / 2, 0, 3 / 8, 0, -5 / 16])  # L_m(0)
    n = np.arange(0, 50, 2)
    found = np.array([middle @ inside.T @ body.stiffness.solve(int(k), outside)[:, 0] for k in n]) / (
        2 * np.pi
    )
    diameter = 2 * np.where(n == 0, 2, 4) * found * 1e6  # [mm/kN]
    assert diameter.sum() == approx(1.15124, rel=2e-5)
    assert diameter @ np.cos(n * np.pi / 2) == approx(-1.04936, rel=2e-5)


def test_small_space_holds_all_harmonics():
    body = held(sections(RING, L), RING.materials, COARSE)
    loads = revolved_body.edge_modes(body, "raceway", 3)
    found, some = compliances(body.stiffness, loads, 60), [4, 6, 9, 14, 22, 33, 50, 55]
    exact = np.array([loads.T @ body.stiffness.solve(n, loads) for n in some])
    assert found[some] == approx(exact, rel=0, abs=1e-6 * found[0].max())
    assert found[some, 0, 0] == approx(exact[:, 0, 0], rel=2e-5)


def test_more_answers_than_free_unknowns_are_those_of_single_solves():
    """Linear elements on a clamped ring: harmonics ask for more directions than it has."""
    body = held(sections(RING, L), RING.materials, MeshSize(order=1, size=12e-3, raceway_size=6e-3))
    loads = revolved_body.edge_modes(body, "raceway", 12)
    solved = answers(body.stiffness, loads, 60)
    assert solved.basis.shape[1] == (~body.stiffness.clamped).sum()
    for n in (0, 17, 60):
        assert solved.basis @ solved.factors[n] == approx(body.stiffness.solve(n, loads), rel=1e-6, abs=1e-18)


@pytest.mark.slow
def test_response_is_symmetric_and_positive(ring, shaft):
    """Betti, and work is never gained; with any number of waves."""
    for raceway in (ring, shaft):
        assert raceway.response == approx(raceway.response.transpose(0, 2, 1), rel=0, abs=1e-18)
        assert np.linalg.eigvalsh(raceway.response).min() > 0


def test_rollers_may_stand_anywhere(ring):
    here, turned = ring.at(ROLLERS), ring.at(ROLLERS + 0.1)
    assert turned.absolute == approx(here.absolute, rel=0, abs=1e-12 * here.absolute.max())
    some = ring.at(ROLLERS[[3, 7, 8]])
    picked = np.ix_([3, 7, 8], range(3), [3, 7, 8], range(3))
    assert some.absolute == approx(here.absolute[picked], rel=0, abs=1e-12 * here.absolute.max())


def test_neighbours_of_a_ring_with_one_clamped_face(ring):
    """Finer, order 7, 200 harmonics: C00 .. C03 2.8903, 1.2120, 0.0933, -0.0894 nm/N.

    Tetrahedra of order 4, 429 090 unknowns, 0.5 mm patches: 2.8527, 1.2159, 0.0959, -0.0884, where harmonics
    damped by the same Gaussian give 2.8558, 1.2204, 0.0968, -0.0887.
    """
    found = ring.at(ROLLERS)
    assert 1e9 * found.absolute[0, 0, :4, 0] == approx([2.8903, 1.2120, 0.0933, -0.0894], rel=0, abs=1e-3)
    assert found.support_stiffness == approx(2.54928e9, rel=1e-4)


FEW, MANY = (FAIR, 75), (MeshSize(order=6, size=4e-3, raceway_size=0.8e-3), 140)


@pytest.mark.slow
@pytest.mark.parametrize("part", [RING, SHAFT], ids=["ring", "shaft"])
def test_own_compliance_does_not_depend_on_mesh_or_harmonics(part):
    few, many = (by_harmonics(part, L, 3, *wishes).at(ROLLERS) for wishes in (FEW, MANY))
    assert few.absolute == approx(many.absolute, rel=0, abs=1.5e-3 * many.absolute.max())
    assert few.absolute[0, 0, 0, 0] == approx(many.absolute[0, 0, 0, 0], rel=7e-4)
    assert few.support_stiffness == approx(many.support_stiffness, rel=2e-4)


@pytest.mark.parametrize(
    "part",
    [
        pytest.param(replace(RING, offset=-2e-3), id="ring, raceway aside", marks=pytest.mark.slow),
        pytest.param(RING, id="ring", marks=pytest.mark.long),
        pytest.param(SHAFT, id="shaft", marks=pytest.mark.long),
    ],
)
def test_tetrahedra_agree(part):
    """The same Gaussian on both; its fixed direction costs (width/R)^2, sharp edges 1 % of the stiffness."""
    width, patches = 0.7e-3, Patches(azimuths=tuple(ROLLERS), length=L, axial_modes=3, width=0.7e-3)
    tetrahedra = as_solid(part, patches, MeshSize(order=3, size=4e-3, raceway_size=1e-3))
    raceway = by_harmonics(part, L, 3, MeshSize(order=6, size=3e-3, raceway_size=0.8e-3), 140)
    n = raceway.harmonics
    damped = raceway.response * np.exp(-((n * width / raceway.radius) ** 2))[:, None, None]
    turn = np.exp(1j * np.outer(ROLLERS, n))
    full = np.einsum("ik,kmp,jk->imjp", turn, damped, turn.conj(), optimize=True).real
    own = np.arange(ROLLERS.size)
    full[own, :, own] -= half_space(patches, part.materials["ring"])
    error = np.abs(full - tetrahedra.absolute) / full.max()
    # their own terms are the small rest of raw ones ten times as large, which the solid mesh holds to 0.2 %
    assert error[own, :, own].max() < 0.025
    error[own, :, own] = 0.0
    assert error.max() < 0.01
    at = raceway.at(ROLLERS)
    assert at.translation == approx(tetrahedra.translation, rel=0, abs=0.015 * at.translation.max())
    assert at.support_stiffness == approx(tetrahedra.support_stiffness, rel=0.015)


def test_more_harmonics_than_the_mesh_holds_are_refused():
    with pytest.raises(NotSolved, match="smaller elements"):
        by_harmonics(RING, L, 3, COARSE, 200)


def test_what_is_not_a_body_of_revolution_is_refused():
    with pytest.raises(ImpossiblePart, match="SquirrelCage"):
        sections(CAGE, L)


def test_band_longer_than_the_track_is_refused():
    with pytest.raises(ImpossiblePart, match="track"):
        by_harmonics(RING, 11e-3, 3, COARSE)


def test_unknown_edge_is_named():
    with pytest.raises(ImpossiblePart, match="hub"):
        held([tube(37.5e-3, 41.1e-3, 5e-3)], RING.materials, COARSE, hub=GLIDING)


def test_edge_that_is_no_cylinder_is_refused():
    body = held([tube(37.5e-3, 41.1e-3, 5e-3)], RING.materials, COARSE)
    with pytest.raises(ImpossiblePart, match="cylinder"):
        revolved_body.edge_modes(body, "left", 1)
