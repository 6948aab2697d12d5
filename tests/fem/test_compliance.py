"""What rollers feel of a flexible ring."""

from dataclasses import replace

import ngsolve as ngs
import numpy as np
import pytest
from pytest import approx

from fem import Elastic, MeshSize, Patches, SquirrelCage
from fem.assembly import roller_loads
from fem.assembly.elasticity import elastic_energy
from fem.assembly.factorisation import NotSolved, factorised, threads
from fem.mesh.solid import meshed
from tests.fem.condensed import as_solid
from tests.fem.test_parts import CAGE, SHAFT, STEEL

slow = pytest.mark.slow  # whole solids; those on half a pitch and on sections are checked against them

Z, M = 30, 3
ROLLERS = Patches(azimuths=2 * np.pi * np.arange(Z) / Z, length=5e-3, axial_modes=M, width=1e-3)
COARSE = MeshSize(order=2, size=4e-3, raceway_size=2.5e-3)
SMALL = SquirrelCage(
    raceway_diameter=20e-3, thickness=3e-3, width=6e-3, bars=3, bar_width=5e-3, bar_thickness=2e-3,
    bar_length=4e-3, flange_length=3e-3, elastic=STEEL,
)  # fmt: skip
SIX = replace(ROLLERS, azimuths=2 * np.pi * np.arange(6) / 6)


@pytest.fixture(scope="module")
def cage():
    return as_solid(CAGE, ROLLERS, COARSE)


@pytest.fixture(scope="module")
def small():
    return as_solid(SMALL, SIX, COARSE)


@pytest.fixture(scope="module")
def shaft():
    return as_solid(SHAFT, ROLLERS, MeshSize(order=2, size=6e-3, raceway_size=3e-3))


@pytest.fixture(scope="module")
def band():
    with threads(2):
        mesh = meshed(SMALL, 5e-3, MeshSize(order=3, size=4e-3, raceway_size=1.5e-3))
        space = ngs.VectorH1(mesh, order=3, dirichlet="clamped")
        return space, roller_loads.band(space, "raceway", roller_loads.HIGHEST_ORDER)


def rigid(space, *field):
    shift = ngs.GridFunction(space)
    shift.Set(ngs.CF(field))
    return shift.vec.FV().NumPy().copy()


@slow
def test_resultant_and_moment_of_every_load_are_exact(band):
    """Loads work on rigid motions as the roller's force and moment would."""
    space, raceway = band
    loads = roller_loads.roller_forces(raceway, ROLLERS).toarray().reshape(space.ndof, Z, M)
    phi = np.array(ROLLERS.azimuths)
    force_y, force_z = (np.tensordot(rigid(space, *e), loads, 1) for e in ((0, 1, 0), (0, 0, 1)))
    assert force_y[:, 0] == approx(np.sin(phi), abs=1e-8)
    assert force_z[:, 0] == approx(np.cos(phi), abs=1e-8)
    assert np.abs([force_y[:, 1:], force_z[:, 1:]]).max() < 1e-8
    # a tilt u_z = x [mm per mm]: F_1 = 2 M / l, so its moment is l/2
    tilt = np.tensordot(rigid(space, 0, 0, ngs.x), loads, 1)
    assert tilt[:, 1] == approx(2.5 * np.cos(phi), abs=1e-8)
    assert np.abs(tilt[:, [0, 2]]).max() < 1e-8


@slow
def test_loads_are_those_of_a_plain_linear_form(band):
    """The mixed point form against NGSolve's own assembly: it fails for quadrature above order 15."""
    space, raceway = band
    r, phi = ngs.sqrt(ngs.y**2 + ngs.z**2), 0.3
    arc = r * ngs.atan2(ngs.y * np.cos(phi) - ngs.z * np.sin(phi), ngs.y * np.sin(phi) + ngs.z * np.cos(phi))
    pressure = ngs.exp(-(arc**2) / 2) / np.sqrt(2 * np.pi) / 5  # [N/mm2], 1 mm wide, 5 mm long
    v = space.TestFunction().Trace()
    form = ngs.LinearForm(
        pressure * (np.sin(phi) * v[1] + np.cos(phi) * v[2])
        * ngs.ds(definedon=space.mesh.Boundaries("raceway"), bonus_intorder=12)
    )  # fmt: skip
    expected = form.Assemble().vec.FV().NumPy()
    found = roller_loads.roller_forces(raceway, replace(ROLLERS, azimuths=(phi,))).toarray()[:, 0]
    assert found == approx(expected, abs=1e-5 * np.abs(expected).max())


@slow
def test_translation_of_a_rigid_band_is_read_exactly(band):
    space, raceway = band
    read = roller_loads.translation_forces(raceway)
    assert rigid(space, 0, 1, 0) @ read == approx((1, 0), abs=1e-9)
    assert rigid(space, 0, 0, 1) @ read == approx((0, 1), abs=1e-9)


@slow
def test_compliance_is_symmetric(cage, shaft):
    for raceway in (cage, shaft):
        assert raceway.absolute == approx(raceway.absolute.transpose(2, 3, 0, 1), abs=1e-15)


@slow
def test_deviation_has_no_rigid_translation(cage):
    """Under a load like cos(phi) nearly all is translation: what remains cannot hold much of it."""
    phi = cage.azimuths
    loads = np.zeros((Z, M))
    loads[:, 0] = np.cos(phi)
    deviation = np.tensordot(cage.relative, loads, 2)[:, 0]
    moved = np.tensordot(cage.translation, loads, 2)
    assert moved[0] == approx(0.0, abs=1e-3 * moved[1])
    assert abs(2 / Z * deviation @ np.cos(phi)) < 0.05 * moved[1]


@slow
def test_support_stiffness_is_load_over_translation(cage):
    """The paper's geometry: a plain prototype found 139 kN/mm, an independent order-4 model 158 kN/mm."""
    assert 130e6 < cage.support_stiffness < 200e6


@slow
def test_compliance_is_inverse_to_the_modulus(small):
    soft = Elastic(youngs_modulus=STEEL.youngs_modulus / 10, poisson_ratio=0.28)
    softer = as_solid(replace(SMALL, elastic=soft), SIX, COARSE)
    assert softer.absolute == approx(10 * small.absolute, rel=1e-8, abs=1e-8 * np.abs(softer.absolute).max())


@slow
def test_symmetry_changes_nothing_but_the_noise_of_the_mesh(small):
    """Rollers at odd azimuths have no symmetry: every one is solved, the common ones must agree."""
    some = as_solid(SMALL, replace(SIX, azimuths=tuple(small.azimuths[[0, 1, 3]])), COARSE)
    here = np.ix_([0, 1, 3], range(M), [0, 1, 3], range(M))
    assert some.absolute == approx(small.absolute[here], abs=0.01 * small.absolute.max())


@pytest.mark.long
def test_own_term_does_not_depend_on_the_width_of_the_patch():
    """The half-space takes the indentation out again, whatever patch made it: 1 % for a factor of two."""
    mesh = MeshSize(order=3, size=4e-3, raceway_size=2e-3)
    wide, narrow = (
        as_solid(CAGE, replace(ROLLERS, width=w), mesh).absolute[0, 0, 0, 0] for w in (1e-3, 0.5e-3)
    )
    assert wide == approx(narrow, rel=0.01)


@slow
def test_wrong_answer_of_the_direct_solver_is_noticed():
    """It hands back numbers in any case: here those of another material."""
    with threads(2):
        mesh = meshed(SMALL, 5e-3, COARSE)
        space = ngs.VectorH1(mesh, order=1, dirichlet="clamped")
        right = factorised(space, elastic_energy(mesh, SMALL.materials))
        other = Elastic(youngs_modulus=203e9, poisson_ratio=0.3)
        wrong = factorised(space, elastic_energy(mesh, dict.fromkeys(SMALL.materials, other)))
        load = rigid(space, 0, 0, 1)
        right.solve(load)
        with pytest.raises(NotSolved, match="residual"):
            replace(right, inverse=wrong.inverse).solve(load)


@slow
def test_patch_too_narrow_for_the_mesh_is_refused():
    with pytest.raises(NotSolved, match="width"):
        as_solid(SMALL, replace(SIX, width=5e-5), COARSE)
