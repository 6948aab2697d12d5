"""An inner ring held on its shaft by pressure with friction."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx

from fem import Elastic, ImpossiblePart, MeshSize, Resolution
from fem.assembly.factorisation import NotSolved
from fem.joint.face_condensation import ContactFace, condense_body
from fem.joint.fitted_ring import BORE, SHOULDER, FitGrid, FittedBodies, FittedRing, condense_fitted
from fem.joint.loaded_fit import loaded
from fem.joint.preloaded_fit import Fit, preloaded
from fem.mesh.axial_section import AxialSection
from fem.section.revolved_body import assembled, edge_modes
from tests.fem.condensed import by_harmonics
from tests.fem.test_parts import SHAFT, STEEL

HOT = Elastic(youngs_modulus=179e9, poisson_ratio=0.281)
SEAT = replace(SHAFT, shaft=HOT)
PLAIN = FittedRing(seat=SEAT)
STEPPED = FittedRing(seat=SEAT, shoulder_diameter=64e-3)
L, M = 5e-3, 3
COARSE = MeshSize(order=3, size=8e-3, raceway_size=2e-3)
SMALL = FitGrid(bore_points=5, shoulder_points=3, harmonics=12)
BAND = Resolution(length=L, axial_modes=M, mesh_size=COARSE)
SPEED = 38000 * 2 * np.pi / 60
ROLLERS = 0.05 + 2 * np.pi * np.arange(30) / 30
TIGHT = Fit(interference=40e-6, friction=0.1)


def loads(total, loaded_half=1.0, seed=0):
    """Rollers that press on one side, with a bit of the other shapes."""
    F = np.zeros((ROLLERS.size, M))
    F[:, 0] = -(np.maximum(np.cos(ROLLERS) - np.cos(loaded_half), 0) ** 1.1)
    F *= total / np.abs(F[:, 0] @ np.exp(1j * ROLLERS))
    shapes = np.random.default_rng(seed).uniform(-0.2, 0.2, (ROLLERS.size, 2))
    return np.column_stack([F[:, 0], shapes * F[:, :1]])


def tube(inner, outer, width, material, seat):
    half = width / 2
    edges = ("seat", None) if seat == "inside" else ("raceway", "seat")
    names = edges if seat == "outside" else ("seat", "raceway")
    return AxialSection(material, (
        (-half, inner, "far"), (half, inner, names[0]), (half, outer, None), (-half, outer, names[1]),
    ))  # fmt: skip


@cache
def condensed(part):
    return condense_fitted(part, BAND, SMALL)


@pytest.fixture(scope="module")
def bodies():
    return condensed(PLAIN)


@pytest.fixture(scope="module")
def stepped():
    return condensed(STEPPED)


@pytest.fixture(scope="module")
def thin():
    """Tubes 25.8/29.8/32.5 mm of 1 mm width, nearly in plane stress, on nothing."""
    faces = (ContactFace(edge="seat", component=1, sign=1.0, points=4),)
    mesh = MeshSize(order=3, size=2e-3, raceway_size=2e-3)
    ring = assembled([tube(29.8e-3, 32.5e-3, 1e-3, "ring", "inside")], {"ring": STEEL}, mesh)
    shaft = assembled([tube(25.8e-3, 29.8e-3, 1e-3, "shaft", "outside")], {"shaft": HOT}, mesh)
    return FittedBodies(
        part=PLAIN, resolution=replace(BAND, length=1e-3), seconds={},
        ring=condense_body(ring, faces, 3, (edge_modes(ring, "raceway", 1), 3)),
        mate=condense_body(shaft, faces, 3),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("speed", "pressure", "growth"),
    [(0.0, 6.8701e6, 84.4135e-6), (SPEED, 5.6810e6, 100.6791e-6)],
    ids=["standstill", "38000 rpm"],
)
def test_hot_shaft_presses_as_lame_says(thin, speed, pressure, growth):
    """Closed form in plane stress: shaft at 230, ring at 220 from 20 degC; radial interference 19.6084 um."""
    fit = preloaded(thin, Fit(
        interference=0.0, friction=0.1, speed=speed, densities=(7850.0, 8240.0),
        thermal_strains=(11.2e-6 * 200, 13.8e-6 * 210),
    ))  # fmt: skip
    assert fit.mean_pressure == approx(pressure, rel=1e-3)
    assert fit.expansion[0] == approx(growth, rel=1e-4)


def test_loose_ring_grows_alone(thin):
    """The shaft grows less with speed: 18.27572 um outside the ring; 72.8000 um by 200 K."""
    fit = preloaded(thin, Fit(interference=0.0, friction=0.1, speed=SPEED, densities=(7850.0, 8240.0)))
    assert not fit.force.any()
    assert fit.gap == approx(3.394e-6, rel=1e-3)
    assert fit.expansion[0] == approx(18.27572e-6, rel=1e-4)
    warm = preloaded(thin, Fit(interference=-1e-3, friction=0.1, thermal_strains=(11.2e-6 * 200, 0.0)))
    assert warm.expansion[0] == approx(72.8e-6, rel=1e-9)


def test_cold_interference_is_diametral(thin):
    """19.6084 um radial make 6.8701 MPa."""
    fit = preloaded(thin, Fit(interference=2 * 19.6084e-6, friction=0.1))
    assert fit.mean_pressure == approx(6.8701e6, rel=1e-3)


def resultants(found, forces):
    """Forces (x, y, z) and moments (x, y, z) on the ring, with the largest of what adds up."""
    interface, w = found.interface, 2 * np.pi / found.interface.azimuths.size
    phi, x, r = interface.azimuths[:, None], interface.points.x, interface.points.radius
    p, t = found.pressure * interface.points.weight * w, found.traction * interface.points.weight[:, None] * w
    bore = interface.points.face == BORE
    axial, radial = np.where(bore, t[..., 0], -p), np.where(bore, p, t[..., 0])
    radius = SEAT.raceway_diameter / 2
    push = forces[:, 0]
    lever = L / 2 * forces[:, 1] / np.where(push, push, 1.0)  # the second shape is a moment of l/2
    parts = (phi, x, r, axial, radial, t[..., 1]), (ROLLERS, lever, radius, 0.0, push, 0.0)
    total, size = np.zeros(6), 0.0
    for phi, x, r, fx, fr, ft in parts:
        fy, fz = fr * np.sin(phi) + ft * np.cos(phi), fr * np.cos(phi) - ft * np.sin(phi)
        y, z = r * np.sin(phi), r * np.cos(phi)
        vector = (fx + 0 * fy, fy, fz, y * fz - z * fy, z * fx - x * fz, x * fy - y * fx)
        total += [np.sum(v) for v in vector]
        size += np.abs(fr).sum()
    return total, size


@pytest.mark.parametrize(
    ("fit", "shoulder"),
    [
        (TIGHT, False),
        (replace(TIGHT, interference=-10e-6), False),
        (replace(TIGHT, friction=0.0), False),
        (replace(TIGHT, bonded=True), False),
        (TIGHT, True),
        (replace(TIGHT, friction=0.0), True),
    ],
    ids=["fit", "loose", "frictionless", "bonded", "shoulder", "frictionless shoulder"],
)
def test_ring_is_in_balance(bodies, stepped, fit, shoulder):
    forces = loads(20e3)
    found = loaded(preloaded(stepped if shoulder else bodies, fit), ROLLERS, forces)
    total, size = resultants(found, forces)
    assert total == approx(np.zeros(6), abs=1e-10 * size)


def test_nut_pushes_the_ring_on_the_shoulder(stepped):
    forces = loads(5e3)
    for friction in (0.0, 0.1):
        fit = preloaded(stepped, replace(TIGHT, friction=friction, clamping=2e3))
        shoulder = fit.bodies.ring.points.face == SHOULDER
        assert 2 * np.pi * fit.force[shoulder].sum() == approx(2e3, rel=1e-9)
        total, size = resultants(loaded(fit, ROLLERS, forces), forces)
        assert total == approx(np.array([-2e3, 0, 0, 0, 0, 0]), abs=1e-9 * size)


def test_bonded_raceway_is_that_of_the_bonded_part(bodies):
    """Coarse faces leave 1 %; with finer ones see below."""
    exact = by_harmonics(SEAT, L, M, COARSE)
    found = preloaded(bodies, replace(TIGHT, bonded=True)).closed
    low = np.abs(exact.harmonics) <= 3
    assert found.response[low] == approx(exact.response[low], rel=0, abs=0.01 * exact.response.max())
    translation = exact.at(ROLLERS).translation
    assert found.at(ROLLERS).translation == approx(translation, rel=0, abs=0.01 * translation.max())


@pytest.mark.slow
def test_sticking_fit_is_the_bonded_part():
    """The same elements; large interference, so that no point opens."""
    mesh = MeshSize(order=5, size=6e-3, raceway_size=1.25e-3)
    fine = condense_fitted(PLAIN, replace(BAND, mesh_size=mesh), FitGrid(bore_points=16, harmonics=64))
    exact = by_harmonics(SEAT, L, M, mesh).at(ROLLERS)
    forces = loads(1e3)
    found = loaded(preloaded(fine, Fit(interference=50e-6, friction=1e3)), ROLLERS, forces)
    assert found.opened == found.slipping == 0
    deviation = np.tensordot(exact.absolute, forces, 2)
    assert found.deviation == approx(deviation, rel=0, abs=1e-3 * np.abs(deviation).max())
    assert found.tangent.absolute == approx(exact.absolute, rel=0, abs=1e-3 * exact.absolute.max())
    assert found.tangent.support_stiffness == approx(exact.support_stiffness, rel=1e-3)


def test_fit_that_never_slips_is_bonded(bodies):
    forces = loads(500.0)
    stuck = loaded(preloaded(bodies, replace(TIGHT, friction=1e3)), ROLLERS, forces)
    glued = loaded(preloaded(bodies, replace(TIGHT, bonded=True)), ROLLERS, forces)
    assert stuck.opened == stuck.slipping == 0
    assert stuck.deviation == approx(glued.deviation, rel=1e-9, abs=1e-15)
    assert stuck.traction == approx(glued.traction, rel=1e-9, abs=1e-3)


def test_hardly_any_friction_is_none(bodies):
    forces = loads(20e3)
    free = loaded(preloaded(bodies, replace(TIGHT, friction=0.0)), ROLLERS, forces)
    slight = loaded(preloaded(bodies, replace(TIGHT, friction=1e-7)), ROLLERS, forces)
    assert slight.deviation == approx(free.deviation, rel=0, abs=1e-6 * np.abs(free.deviation).max())
    assert slight.pressure == approx(free.pressure, rel=0, abs=1e-5 * free.pressure.max())


def test_more_friction_makes_a_stiffer_seat(bodies):
    forces = loads(5e3)
    found = [
        loaded(preloaded(bodies, replace(TIGHT, friction=mu)), ROLLERS, forces) for mu in (0, 0.1, 0.5, 1e3)
    ]
    assert np.all(np.diff([np.sum(f.deviation * forces) for f in found]) < 0)  # work of the rollers
    slipping = [f.slipping for f in found[1:]]
    assert slipping[0] > slipping[1] > slipping[2] == 0


@pytest.mark.parametrize("interference", [40e-6, -10e-6], ids=["tight", "loose"])
def test_tangent_is_the_slope(bodies, interference):
    fit, forces = preloaded(bodies, replace(TIGHT, interference=interference)), loads(10e3)
    here = loaded(fit, ROLLERS, forces)
    change = np.random.default_rng(2).normal(size=forces.shape)  # [N]
    up, down = (loaded(fit, ROLLERS, forces + s * change, here.contact.jump) for s in (1e-2, -1e-2))
    slope = np.tensordot(here.tangent.absolute, change, 2)
    assert (up.deviation - down.deviation) / 2e-2 == approx(slope, rel=0, abs=1e-6 * np.abs(slope).max())
    slope = np.tensordot(here.tangent.translation, change, 2)
    assert (up.translation - down.translation) / 2e-2 == approx(slope, rel=0, abs=1e-6 * np.abs(slope).max())


ANY_FIT = given(
    st.floats(-20e-6, 50e-6), st.just(0.0) | st.floats(100.0, 20e3), st.just(0.0) | st.floats(1e-3, 1.0),
    st.floats(0.3, 1.5), st.booleans(), st.integers(0, 9),
)  # fmt: skip


def obeys_contact_and_friction(interference, total, friction, half, shoulder, seed):
    fit = preloaded(
        condensed(STEPPED if shoulder else PLAIN), Fit(interference=interference, friction=friction)
    )
    if interference <= 0 and total == 0:
        with pytest.raises(NotSolved, match="nothing holds"):
            loaded(fit, ROLLERS, loads(total, half, seed))
        return
    found = loaded(fit, ROLLERS, loads(total, half, seed))
    p, t = found.pressure, np.linalg.norm(found.traction, axis=-1)
    tiny, length = 1e-8 * (p.max() or 1.0), 1e-8 * np.abs(found.contact.jump).max() + 1e-15
    assert p.min() >= -tiny
    assert found.gap.min() >= -length
    assert np.all((p <= tiny) | (found.gap <= length))
    assert np.all(t <= friction * p + tiny)
    moved = (np.linalg.norm(found.slip, axis=-1) > length) & (p > tiny)
    assert t[moved] == approx(friction * p[moved], rel=1e-6, abs=tiny)
    assert np.sum(found.slip * found.traction, axis=-1)[moved] == approx(
        -(np.linalg.norm(found.slip, axis=-1) * t)[moved], rel=1e-6, abs=tiny * length
    )


@settings(max_examples=12)
@ANY_FIT
def test_any_fit_obeys_contact_and_friction(interference, total, friction, half, shoulder, seed):
    obeys_contact_and_friction(interference, total, friction, half, shoulder, seed)


@pytest.mark.long
@settings(max_examples=200)
@ANY_FIT
def test_many_fits_obey_contact_and_friction(interference, total, friction, half, shoulder, seed):
    obeys_contact_and_friction(interference, total, friction, half, shoulder, seed)


def test_loose_ring_without_load_has_no_place(bodies):
    fit = preloaded(bodies, replace(TIGHT, interference=-10e-6))
    balanced = np.zeros((ROLLERS.size, M))
    balanced[[0, 15], 0] = -1e3
    for forces in (0 * balanced, balanced):
        with pytest.raises(NotSolved, match="nothing holds"):
            loaded(fit, ROLLERS, forces)


def test_warm_start_gives_the_same(bodies):
    fit = preloaded(bodies, TIGHT)
    first = loaded(fit, ROLLERS, loads(10e3))
    cold, warm = loaded(fit, ROLLERS, loads(11e3)), loaded(fit, ROLLERS, loads(11e3), first.contact.jump)
    assert warm.steps < cold.steps
    assert warm.deviation == approx(cold.deviation, rel=1e-8, abs=1e-15)


def test_impossible_fits_are_refused(bodies):
    with pytest.raises(ImpossiblePart, match="shoulder_diameter"):
        replace(STEPPED, shoulder_diameter=59e-3)
    with pytest.raises(ImpossiblePart, match="friction"):
        Fit(interference=0.0, friction=-0.1)
    with pytest.raises(ImpossiblePart, match="shoulder"):
        preloaded(bodies, replace(TIGHT, clamping=1e3))
    with pytest.raises(ImpossiblePart, match="track"):
        condense_fitted(PLAIN, replace(BAND, length=9e-3), SMALL)
