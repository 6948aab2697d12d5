"""A plain outer ring on each of its supports."""

from dataclasses import replace
from itertools import product
from math import inf, nan

import ngsolve as ngs
import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx
from scipy.optimize import nnls

from fem import (
    Elastic,
    Foundation,
    Housing,
    ImpossiblePart,
    LineForce,
    LineSupports,
    MeshSize,
    OuterRing,
    PlanetGear,
    Resolution,
    RigidSeat,
)
from fem.assembly.elasticity import elastic_energy
from fem.assembly.factorisation import NotSolved, factorised, threads
from fem.errors import TooFewHarmonics
from fem.half_space.line_load import indentation_harmonics
from fem.mesh.solid import meshed
from fem.raceway.harmonics import TRUNCATED
from fem.section.planet_rim import PlanetRim
from fem.section.revolved_body import edge_modes
from fem.section.rigid_body_modes import body_of
from fem.section.ring_on_foundation import complementary
from fem.section.ring_on_lines import RingOnLines
from fem.section.unilateral_points import SupportPoints, bordered_inverse, pushing_points
from tests.fem.condensed import AxisymmetricLoad, by_harmonics, expansion_of, with_smeared_bars
from tests.fem.test_parts import STEEL

L, M = 5e-3, 2
FAIR = MeshSize(order=5, size=4e-3, raceway_size=1.5e-3)
COARSE = MeshSize(order=4, size=4e-3, raceway_size=2e-3)
ROLLERS = 0.1 + 2 * np.pi * np.arange(11) / 11
THREE = LineSupports(azimuths=tuple(np.radians([0, 120, 240])))
RADIAL = Foundation(axial=0.0, radial=1e12, tangential=0.0)
ALUMINIUM = Elastic(youngs_modulus=70e9, poisson_ratio=0.33)


def ring(support, **changes):
    sizes = {"raceway_diameter": 75e-3, "thickness": 3.6e-3, "width": 10e-3, "elastic": STEEL} | changes
    return OuterRing(**sizes, support=support)


def response(part, harmonics=20, mesh=COARSE):
    return by_harmonics(part, L, M, mesh, harmonics).response[harmonics:]


@pytest.fixture(scope="module")
def free():
    return by_harmonics(ring(THREE), L, 3, FAIR).ring


IMPOSSIBLE = [
    (lambda: LineSupports(azimuths=(0.0,)), r"along \(y, z\) = \(-?1, "),
    (lambda: LineSupports(azimuths=(np.pi / 2, -np.pi / 2)), r"along \(y, z\) = \(.*, -?1\)"),
    (lambda: LineSupports(azimuths=()), "azimuths"),
    (lambda: replace(THREE, stiffness=0.0), "stiffness"),
    (lambda: Foundation(axial=1e12, radial=0.0, tangential=0.0), "along y and z"),
    (lambda: Foundation(axial=-1.0, radial=1.0, tangential=0.0), "axial"),
    (lambda: Housing(thickness=0.0, width=1e-2, elastic=STEEL), "thickness"),
    (lambda: PlanetGear(forces=(LineForce(azimuth=0.0, radial=0.0, tangential=10.0),)), "turn about"),
    (lambda: LineForce(azimuth=nan, radial=0.0, tangential=0.0), "line force"),
    (lambda: by_harmonics(ring(replace(THREE, tilting=True)), L, 2, COARSE), "tilt about y and z"),
    (lambda: by_harmonics(ring(THREE), 11e-3, 2, COARSE), "track"),
    (lambda: with_smeared_bars(ring(THREE), L, 2, COARSE), "OuterRing is impossible as SMEARED"),
    (lambda: meshed(ring(RADIAL), L, COARSE), "Foundation"),
]


@pytest.mark.parametrize(("make", "named"), IMPOSSIBLE, ids=[named for _, named in IMPOSSIBLE])
def test_what_could_move_freely_or_cannot_be_is_named_before_solving(make, named):
    with pytest.raises(ImpossiblePart, match=named):
        make()


def test_stiff_springs_are_a_rigid_seat():
    stiff = Foundation(axial=1e19, radial=1e19, tangential=1e19)
    assert response(ring(stiff)) == approx(response(ring(RigidSeat())), rel=2e-4)


def test_housing_of_the_same_steel_makes_a_thicker_ring():
    inside = Housing(thickness=2.4e-3, width=10e-3, elastic=STEEL, support=RADIAL)
    one = response(ring(RADIAL, thickness=6e-3))
    assert response(ring(inside)) == approx(one, rel=0, abs=1e-4 * one.max())


@pytest.mark.slow
def test_softer_and_narrower_housings_yield_more():
    stiff, soft, narrow = (
        response(ring(Housing(thickness=4e-3, width=width, elastic=elastic)), 10)
        for width, elastic in ((14e-3, STEEL), (14e-3, ALUMINIUM), (7e-3, ALUMINIUM))
    )
    assert np.linalg.eigvalsh(soft - stiff).min() > 0
    assert np.linalg.eigvalsh(narrow - soft).min() > 0


def test_springs_that_do_not_hold_the_ring_along_its_axis_are_enough():
    """They are the limit of ever softer axial and tangential ones."""
    limit = replace(RADIAL, axial=1e4, tangential=1e4)
    assert response(ring(RADIAL)) == approx(response(ring(limit)), rel=1e-6)


def test_free_ring_is_one_on_soft_springs_without_its_rigid_motion(free):
    """Loads like cos(phi): the third shape of the raceway, when its first two are held."""
    soft = body_of(
        ring(Foundation(axial=1e8, radial=1e8, tangential=1e8)), Resolution(length=L, mesh_size=FAIR)
    )
    where = ngs.ds(definedon=soft.space.mesh.Boundaries("foundation"))
    G = np.column_stack([
        edge_modes(soft, "raceway", 3), edge_modes(soft, "foundation", 2),
        soft.load(soft.space.TestFunction()[2] * where) / 10.0,
    ])  # fmt: skip
    held = G.T @ soft.stiffness.solve(1, G) / (2 * np.pi)
    left = held[2] - held[2, :2] @ np.linalg.solve(held[:2, :2], held[:2])
    raceway = free.raceway.response[free.raceway.harmonics == 1][0]
    found = np.concatenate([raceway[2], free.radial[1, 2], free.tangential[1, 2:]])
    assert found == approx(left, rel=1e-3, abs=1e-4 * np.abs(left).max())
    assert np.abs(left[[2, 3, 5]]).min() > 1e-2 * np.abs(left).max()


@settings(max_examples=10)
@given(st.lists(st.floats(-1e3, 1e3), min_size=4, max_size=4))
def test_lines_balance_the_rollers(free, forces):
    """Force and moment about y and z."""
    phi, F = np.array([0.3, 4.0]), np.zeros((2, 3))
    F[:, :2] = np.reshape(forces, (2, 2))
    support = replace(THREE, azimuths=(0.0, 1.0, 2.5, 4.0), stiffness=1e8)
    p = RingOnLines(free, support).line_forces(phi, F)
    psi, large = np.array(support.azimuths), 1e-9 * (1 + np.abs(F).max())
    for wave in (np.sin, np.cos):
        assert p.sum(axis=1) @ wave(psi) == approx(F[:, 0] @ wave(phi), rel=0, abs=large)
        moment = 10e-3 / 6 * (p[:, 1] - p[:, 0]) @ wave(psi)
        assert moment == approx(L / 2 * F[:, 1] @ wave(phi), rel=0, abs=large)


def test_soft_lines_carry_a_ring_that_hardly_bends(free):
    """K lines of stiffness k, evenly spaced: K k / 2 in every direction, tilt held by k l^2/12 each."""
    lines = tuple(2 * np.pi * np.arange(6) / 6)
    found = RingOnLines(free, LineSupports(azimuths=lines, stiffness=1e4)).at(ROLLERS)
    assert found.support_stiffness == approx(3e4, rel=1e-3)
    assert found.translation[1, :, 0] == approx(np.cos(ROLLERS) / 3e4, rel=0, abs=1e-3 / 3e4)
    tilt = found.absolute[0, 1, 0, 1] / (L / 2) ** 2
    assert 1 / tilt == approx(6 * 1e4 * 10e-3**2 / 24, rel=1e-3)


@pytest.mark.slow
def test_many_soft_lines_are_an_elastic_foundation(free):
    count, stiffness = 60, 3e5
    per_area = count * stiffness / (2 * np.pi * 41.1e-3 * 10e-3)
    lines = LineSupports(azimuths=tuple(2 * np.pi * np.arange(count) / count), stiffness=stiffness)
    some = ROLLERS[:4]
    found = RingOnLines(free, lines).at(some)
    springs = by_harmonics(ring(replace(RADIAL, radial=per_area)), L, 3, FAIR).at(some)
    assert found.absolute == approx(springs.absolute, rel=0, abs=5e-4 * springs.absolute.max())
    assert found.translation == approx(springs.translation, rel=0, abs=5e-4 * springs.translation.max())


def test_compliance_on_lines_is_symmetric_and_stiff_lines_are_rigid(free):
    rigid, stiff = (RingOnLines(free, replace(THREE, stiffness=k)).at(ROLLERS).absolute for k in (inf, 1e15))
    assert rigid == approx(rigid.transpose(2, 3, 0, 1), rel=0, abs=1e-12 * rigid.max())
    assert stiff == approx(rigid, rel=0, abs=1e-5 * rigid.max())


def test_crowned_lines_hold_a_ring_that_is_not_tilted(free):
    """One axial shape: a load that is even along x needs no moment of the lines."""
    even = replace(
        free, raceway=replace(free.raceway, response=free.raceway.response[:, :1, :1]),
        radial=free.radial[:, :1], tangential=free.tangential[:, :1], reading=free.reading[[0, -2, -1]],
    )  # fmt: skip
    crowned, straight = (
        RingOnLines(even, replace(THREE, tilting=tilting)).line_forces([0.4], np.array([[1.0]])).sum(axis=1)
        for tilting in (True, False)
    )
    assert crowned == approx(straight, rel=0, abs=1e-9)


@st.composite
def points_with_load(draw):
    """Up to five points around a body, and a load that some of them may hold by pushing."""
    count = draw(st.integers(3, 5))
    seed = draw(st.integers(0, 2**32 - 1))
    chance = np.random.default_rng(seed)
    phi = chance.uniform(0, 2 * np.pi, count)
    half = chance.normal(size=(count, count))
    psi = chance.uniform(0, 2 * np.pi, 2)
    normals, loads = (np.stack([np.sin(a), np.cos(a)], axis=1) for a in (phi, psi))
    points = SupportPoints(
        azimuths=phi, compliance=1e-9 * (half @ half.T + 0.3 * np.eye(count)), motions=normals,
        loads=1e-9 * chance.normal(size=(count, 2)), load_motions=loads,
    )  # fmt: skip
    return points, chance.uniform(0, 1e3, 2)


def obeys(points, load, touching):
    """Whether these points push and all others are free; None where they let the body go."""
    try:
        inverse = bordered_inverse(points, touching)
    except NotSolved:
        return None
    X = np.concatenate([points.loads[touching] @ load, points.load_motions.T @ load])
    p, a = np.split(inverse @ X, [np.count_nonzero(touching)])
    gap = points.compliance[:, touching] @ p - points.loads @ load + points.motions @ a
    return p.min() > 0 and gap[~touching].min(initial=inf) > 0


@settings(max_examples=60)
@given(points_with_load())
def test_points_that_push_are_those_of_a_search_through_all(case):
    points, load = case
    sets = [np.array(s) for s in product([False, True], repeat=len(points.azimuths)) if any(s)]
    right = [s for s in sets if obeys(points, load, s)]
    if right:
        assert len(right) == 1
        assert pushing_points(points, load).tolist() == right[0].tolist()
    else:
        with pytest.raises(NotSolved, match=r"lift off|can still move|no set"):
            pushing_points(points, load)


def test_lines_that_only_push_let_go(free):
    """The load draws the ring longer, away from lines at its sides; it is one on two lines."""
    around = tuple(np.radians([-40, 40, 100, 260]))
    pushing = RingOnLines(free, LineSupports(azimuths=around, pushing=True))
    phi, F = np.array([0.05, 3.0]), np.array([[1000.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    p = pushing.line_forces(phi, F)
    assert p.min() == 0
    assert np.all(p[:2] > 0)
    assert np.all(p[2:] == 0)
    two = RingOnLines(free, LineSupports(azimuths=around[:2]))
    assert p[:2] == approx(two.line_forces(phi, F), rel=1e-9)
    assert pushing.at(phi, F).absolute == approx(two.at(phi).absolute, rel=1e-9)


def test_lines_that_only_push_may_touch_at_one_end(free):
    """A moment larger than the force times a sixth of the width tips the ring off one end of a line."""
    around = tuple(2 * np.pi * np.arange(12) / 12)
    pushing = RingOnLines(free, LineSupports(azimuths=around, pushing=True, stiffness=1e8))
    F = np.array([[500.0, 300.0, 0.0], [500.0, -300.0, 0.0]])
    p = pushing.line_forces([0.1, 3.3], F)
    assert p.min() == 0
    assert np.any((p[:, 0] == 0) & (p[:, 1] > 0))


def test_lines_that_cannot_hold_a_load_by_pushing_are_refused(free):
    pushing = RingOnLines(free, LineSupports(azimuths=(-0.7, 0.7), pushing=True))
    with pytest.raises(NotSolved, match="lift off"):
        pushing.at([3.0], np.array([[100.0, 0.0, 0.0]]))
    with pytest.raises(ImpossiblePart, match="roller forces"):
        pushing.at([3.0])
    assert np.isfinite(pushing.at([3.0], np.zeros((1, 3))).absolute).all()


PULLED = PlanetGear(
    forces=(
        LineForce(azimuth=np.pi / 2, radial=-200.0, tangential=-500.0),
        LineForce(azimuth=-np.pi / 2, radial=-200.0, tangential=500.0),
    )
)  # both teeth push along +z


def test_tooth_forces_bend_the_rim_but_do_not_move_it(free):
    around = 2 * np.pi * np.arange(720) / 720
    bent = PlanetRim(free, PULLED).at(around[::180])
    assert bent.initial_deviation.shape == (4, 3)
    assert not bent.translation.any()
    assert bent.support_stiffness == inf
    psi, radial, tangential = np.array([(f.azimuth, f.radial, f.tangential) for f in PULLED.forces]).T
    w = free.under_radial(around, psi)[..., 0] @ radial + free.under_tangential(around, psi) @ tangential
    assert np.abs(w).max() > 1e-6
    for wave in (np.sin, np.cos):
        assert np.abs(wave(around) @ w[:, :2]).max() < 1e-9 * np.abs(w).max() * 720
    assert w[::180] == approx(bent.initial_deviation, rel=1e-12, abs=1e-18)
    mirrored = w[(-np.arange(720)) % 720]  # left to right
    assert mirrored == approx(w, rel=0, abs=1e-9 * np.abs(w).max())


def test_cold_and_warm_free_rings_differ_by_their_size():
    soft = Foundation(axial=0.0, radial=1e3, tangential=0.0)
    housing = Housing(thickness=3e-3, width=8e-3, elastic=STEEL, support=soft)
    for support in (PlanetGear(forces=()), soft, housing):
        load = AxisymmetricLoad(thermal_strains=dict.fromkeys(ring(support).materials, 1e-3))
        assert expansion_of(ring(support), L, 2, COARSE, load) == approx([37.5e-6, 0], rel=1e-6, abs=1e-12)


def test_free_ring_grows_with_speed_as_in_plane_stress():
    """29.8/32.5 mm at 38000 rpm: 18.72190 um inside."""
    fast = AxisymmetricLoad(densities={"ring": 7850.0}, speed=38000 * 2 * np.pi / 60)
    narrow = ring(PlanetGear(forces=()), raceway_diameter=59.6e-3, thickness=2.7e-3, width=1e-3)
    assert expansion_of(narrow, 1e-3, 1, COARSE, fast) == approx([18.72190e-6], rel=5e-4)


def test_warm_ring_in_a_stiff_cold_bore_grows_inwards():
    """Lame in plane stress: u = A r + B/r with no motion outside, no stress inside."""
    a, b, nu, e = 37.5e-3, 41.1e-3, 0.28, 1e-3
    B = -(1 + nu) * e / ((1 + nu) / b**2 + (1 - nu) / a**2)
    bore = Foundation(axial=0.0, radial=1e19, tangential=0.0)
    found = expansion_of(
        ring(bore, width=0.5e-3), 0.5e-3, 1, COARSE, AxisymmetricLoad(thermal_strains={"ring": e})
    )
    assert found == approx([B * (1 / a - a / b**2)], rel=1e-3)
    assert found < 0


def solid_response(part, harmonics, mesh, length):
    """W_n[0, 0] and W_n[1, 1] by tetrahedra under pressures like cos(n phi), springs as in the weak form."""
    springs = part.support if isinstance(part.support, Foundation) else None
    drawn = meshed(replace(part, support=RigidSeat()), length, mesh)
    r = ngs.sqrt(ngs.y**2 + ngs.z**2)
    axial, radial, tangential = (ngs.CF(c) for c in ((1, 0, 0), (0, ngs.y, ngs.z), (0, ngs.z, -ngs.y)))
    with threads(1):
        space = ngs.VectorH1(drawn, order=mesh.order, dirichlet="" if springs else "clamped")
        elastic, v = elastic_energy(drawn, part.materials), space.TestFunction().Trace()

        def energy(u, v):
            if not springs:
                return elastic(u, v)
            pairs = (springs.axial, axial), (springs.radial, radial / r), (springs.tangential, tangential / r)
            per_area = (1e-6 * k * (u.Trace() * e) * (v.Trace() * e) for k, e in pairs)  # [N/m] per mm^2
            return sum((work * ngs.ds("clamped") for work in per_area), elastic(u, v))

        stiffness = factorised(space, energy)
        answers = []
        for n, m in product(harmonics, (0, 1)):
            shape = (2 * m + 1) / (1e3 * length) * (1.0 if m == 0 else 2e-3 * ngs.x / length)
            wave = 2 * ngs.cos(n * ngs.atan2(ngs.y, ngs.z)) / (1e3 * np.pi * part.raceway_diameter)
            form = shape * wave * (v * radial / r) * ngs.ds("raceway", bonus_intorder=4)
            load = ngs.LinearForm(form).Assemble().vec.FV().NumPy()
            answers.append(load @ stiffness.solve(load) / 2)
    return np.reshape(answers, (-1, 2))


@pytest.mark.slow
@pytest.mark.parametrize(
    "support", [RigidSeat(), RADIAL, Foundation(axial=1e11, radial=1e12, tangential=3e11)],
    ids=["seat", "radial", "springs"],
)  # fmt: skip
def test_tetrahedra_agree(support):
    part, harmonics = ring(support), [1, 2, 5]
    mesh = MeshSize(order=4, size=5e-3, raceway_size=2e-3)
    solid = solid_response(part, harmonics, mesh, part.width)
    raceway = by_harmonics(part, part.width, 2, MeshSize(order=6, size=3e-3, raceway_size=1e-3), 80)
    found = np.real(np.einsum("nmm->nm", raceway.response[80 + np.array(harmonics)]))
    assert solid == approx(found, rel=3e-3)


def under(rollers, forces):
    """Deviations from the ground [m] under roller forces (Z, M) [N], by the tangent there."""
    return np.tensordot(rollers.near(forces).absolute, forces, 2)


def on_springs(stiffness=1e11, tangential=0.0):
    springs = Foundation(axial=0.0, radial=stiffness, tangential=tangential, pushing=True)
    return by_harmonics(ring(springs), L, M, COARSE).under_rollers(ROLLERS)


PRESSED = np.column_stack([800 * np.maximum(np.cos(ROLLERS - 0.4), 0) ** 1.2, 60 * np.sin(ROLLERS)])
ONE_SIDED = {
    "lines": lambda free: RingOnLines(free, replace(THREE, pushing=True)).under_rollers(ROLLERS),
    "soft lines": lambda free: RingOnLines(
        free, LineSupports(azimuths=tuple(np.radians([-80, 10, 50, 150])), stiffness=3e7, pushing=True)
    ).under_rollers(ROLLERS),
    "springs": lambda free: on_springs(),
    "springs with shear": lambda free: on_springs(3e10, 1e10),
}  # fmt: skip


@pytest.mark.sampled(2)
@pytest.mark.parametrize("make", ONE_SIDED.values(), ids=ONE_SIDED.keys())
def test_tangent_on_one_sided_supports_is_that_of_differences(free, make):
    rollers = make(free).with_axial_modes(M)
    chance = np.random.default_rng(3)
    step = chance.normal(size=PRESSED.shape)
    tangent = rollers.near(PRESSED)
    size = 1e-3  # N: no point opens or closes between both
    forward, backward = under(rollers, PRESSED + size * step), under(rollers, PRESSED - size * step)
    change = np.tensordot(tangent.absolute, step, 2)
    assert (forward - backward) / (2 * size) == approx(change, rel=0, abs=1e-5 * np.abs(change).max())
    assert tangent.absolute == approx(tangent.absolute.transpose(2, 3, 0, 1), rel=0, abs=1e-11)
    moved = np.tensordot(tangent.translation, PRESSED, 2)
    waves = np.stack([np.sin(ROLLERS), np.cos(ROLLERS)])
    assert np.tensordot(tangent.relative, PRESSED, 2)[:, 0] == approx(
        under(rollers, PRESSED)[:, 0] - moved @ waves, rel=0, abs=1e-12
    )


@pytest.mark.sampled(2)
@pytest.mark.parametrize("make", ONE_SIDED.values(), ids=ONE_SIDED.keys())
def test_answer_on_one_sided_supports_is_continuous_where_they_open(free, make):
    """From one load to another, of which the supports touch elsewhere: no jump, and no answer to no load."""
    rollers = make(free).with_axial_modes(M)
    turned = np.roll(PRESSED, 4, axis=0)
    largest = []
    for count in (40, 80):
        along = [(1 - s) * PRESSED + s * turned for s in np.linspace(0, 1, count + 1)]
        path = [np.tensordot(rollers.near(forces).relative, forces, 2)[:, 0] for forces in along]
        largest.append(np.abs(np.diff(path, axis=0)).max())
    assert largest[1] < 0.6 * largest[0]  # half of it where the answer is smooth, all of it where it jumps


def test_springs_that_only_push_balance_the_rollers():
    """Force along y and z, moment about both."""
    rollers = on_springs()
    force = rollers.pressure(PRESSED) * rollers.area
    assert force.min() == 0 < force.max()
    for wave in (np.sin, np.cos):
        around, at_rollers = wave(rollers.around)[:, None], wave(ROLLERS)
        large = 1e-6 * force.sum()
        assert (force * around).sum() == approx(at_rollers @ PRESSED[:, 0], rel=0, abs=large)
        moment = (force * rollers.x * around).sum()
        assert moment == approx(L / 2 * at_rollers @ PRESSED[:, 1], rel=0, abs=large * L)


def test_springs_pull_only_where_they_may():
    """Springs that pull are the foundation that is not one-sided, and share its whole answer."""
    rollers = on_springs()
    both = replace(rollers, pushing=False)
    linear = by_harmonics(ring(replace(RADIAL, radial=1e11)), L, M, COARSE).at(ROLLERS)
    assert both.near(PRESSED).absolute == approx(linear.absolute, rel=0, abs=1e-6 * linear.absolute.max())
    assert both.pressure(PRESSED).min() < 0
    assert np.abs(under(rollers, PRESSED)).max() > 1.2 * np.abs(under(both, PRESSED)).max()
    assert rollers.near(0 * PRESSED).absolute == approx(linear.absolute, rel=0, abs=1e-12)


def test_ring_may_rest_on_a_single_line_under_a_load_straight_at_it(free):
    """Another line touches without a force: no motion is left, and nothing of the answer depends on it."""
    rollers = RingOnLines(free, replace(THREE, pushing=True)).under_rollers(np.array([0.5, -0.5, 3.0]))
    F = np.array([[500.0, 0.0, 0.0], [500.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    force = rollers.line_forces(F)
    assert force.sum(axis=1) == approx([1000 * np.cos(0.5), 0, 0], rel=1e-9, abs=1e-6)
    assert np.count_nonzero(rollers.touching(F)) > 2
    tilted = F + np.array([[1e-3, 0, 0], [0, 0, 0], [0, 0, 0]])
    assert rollers.line_forces(tilted).sum(axis=1) == approx(force.sum(axis=1), rel=0, abs=3e-3)
    relative = [np.tensordot(rollers.near(forces).relative, forces, 2) for forces in (F, tilted)]
    assert relative[1] == approx(relative[0], rel=0, abs=1e-5 * np.abs(relative[0]).max())


@settings(max_examples=60)
@given(st.integers(1, 12), st.integers(0, 2**32 - 1))
def test_complementarity_is_solved_for_any_positive_definite_matrix(size, seed):
    chance = np.random.default_rng(seed)
    half = chance.normal(size=(size, size))
    matrix, constant = half @ half.T + 0.01 * np.eye(size), chance.normal(size=size)
    positive, y = complementary(matrix, constant)
    t = np.where(positive, np.linalg.lstsq(matrix, y - constant, rcond=None)[0], 0.0)
    assert matrix @ t + constant == approx(y, rel=0, abs=1e-8)
    assert t.min() >= -1e-9
    assert y.min() >= -1e-9


def test_lines_too_close_together_are_refused_whether_they_pull_or_not(free):
    """A line has no width: the ring between two of them would have to be squeezed."""
    for pushing in (True, False):
        lines = LineSupports(azimuths=tuple(np.radians([0, 1, 120, 240])), pushing=pushing)
        with pytest.raises(ImpossiblePart, match="supports 1 deg apart"):
            RingOnLines(free, lines).under_rollers(ROLLERS)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("tangential", [0.0, 1e10])
def test_answer_on_springs_is_that_of_non_negative_least_squares(tangential):
    """Forces t >= 0 that take away what open springs pull make t (K^-1 - S) t / 2 + t u least."""
    rollers = on_springs(3e10, tangential)
    root = np.sqrt(rollers.springs)
    released = (1 + 1e-9) * np.eye(root.size) - root[:, None] * rollers.face * root
    factor = np.linalg.cholesky(released + 1e-12 * np.eye(root.size))
    free = rollers.through @ PRESSED.ravel()
    t = root * nnls(factor.T, -np.linalg.solve(factor, root * free))[0]
    assert np.array_equal(t > 0, rollers.open_points(PRESSED))
    moved = np.tensordot(rollers.closed.absolute, PRESSED, 2).ravel() - rollers.through.T @ t
    assert under(rollers, PRESSED).ravel() == approx(moved, rel=0, abs=1e-5 * np.abs(moved).max())
    shift = np.tensordot(rollers.closed.translation, PRESSED, 2) - rollers.shifted.T @ t
    found = np.tensordot(rollers.near(PRESSED).translation, PRESSED, 2)
    assert found == approx(shift, rel=0, abs=1e-5 * np.abs(shift).max())


WIDE = 80e-3  # of a band as long as the radius is large


@pytest.mark.parametrize(
    "support",
    [
        pytest.param(RigidSeat(), id="seat"),
        pytest.param(LineSupports(azimuths=(0.0, 2.0, 4.0)), id="lines", marks=pytest.mark.slow),
    ],
)
def test_harmonics_are_added_until_they_are_enough(support):
    """On elements that resolve them: a quarter of a long roller is far too coarse for a thin ring."""
    ring = OuterRing(raceway_diameter=160e-3, thickness=2.4e-3, width=90e-3, elastic=STEEL, support=support)
    coarse = MeshSize(order=5, size=96e-3, raceway_size=20e-3)

    def own(harmonics=None, mesh=coarse):
        found = by_harmonics(ring, WIDE, M, mesh, harmonics)
        raceway = found.ring.raceway if isinstance(found, RingOnLines) else found
        return raceway.harmonics[-1], raceway.absolute(np.array([0.0, 0.1]))

    last, compliance = own()
    assert last > 12
    _, exact = own(2 * last, replace(coarse, raceway_size=20e-3 * 12 / (2 * last)))
    half_space = indentation_harmonics(np.arange(-last, last + 1), 80e-3, WIDE, M, STEEL).sum(axis=0).max()
    assert compliance == approx(exact, rel=0, abs=TRUNCATED * (np.abs(exact).max() + half_space))
    with pytest.raises(TooFewHarmonics, match="take more harmonics"):
        own(12)
