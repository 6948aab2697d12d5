"""The analytic Jacobian is the derivative of the residual, and the linear solve its inverse."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import RollerRow
from quasidynamic.columns import side_by_side
from quasidynamic.solve.rollers import bordered_system, elastic_system
from quasidynamic.solve.start import static_start
from tests.bearings import RIBS, eyring, paper_bearing

RIGID = (False, False)
ROWS = (RollerRow(axial=-5e-3), RollerRow(axial=4e-3, clearance=5e-6, azimuth=0.1))
CASES = {
    "regression": ({}, RIGID),
    "eyring": ({"traction": "eyring"}, RIGID),
    "eyring, below its limit": ({"limiting_ratio": 0.4, "eyring_stress": 5e6}, RIGID),
    "tilt free": ({"moment": 20.0}, RIGID),
    "misaligned, load sideways": ({"misalignment": 1e-3, "load_direction": 2.0}, RIGID),
    "tilt free, elastic": ({"moment": 20.0, "axial_modes": 4}, (True, True)),
    "elastic": ({"axial_modes": 3}, (True, True)),
    "elastic, with tilt": ({"axial_modes": 2}, (True, True)),
    "elastic, one mode": ({"axial_modes": 1}, (True, True)),
    "inner raceway elastic": ({"axial_modes": 3}, (True, RIGID)),
    "outer raceway elastic": ({"moment": 20.0, "axial_modes": 4}, (False, True)),
    "outer raceway elastic, one mode": ({"axial_modes": 1}, (False, True)),
    "no spin inertia": ({"spin_inertia": False}, RIGID),
    "churning, vortices": ({"churning_gap": 5e-4, "cage": {"land_flow": "vortices"}}, RIGID),
    "floating cage": ({"cage": {"free": True, "unbalance": 5e-5}}, RIGID),
    "floating cage on the inner ring, tilt free": (
        {"moment": 20.0, "cage": {"free": True, "guidance": "inner", "land_diameter": 65.4e-3}},
        RIGID,
    ),
    "starved": ({"inlet_length": 0.3}, RIGID),
    "unlike rows, tilt free": ({"rows": ROWS, "moment": 60.0, "tilt_direction": 1.0}, RIGID),
    "rows between elastic raceways": ({"rows": ROWS, "rollers": 9, "moment": 60.0}, (True, True)),
    "on ribs": ({"axial_load": 3000.0, "ribs": RIBS}, RIGID),
    "on ribs, tilt free, thrust reversed": (
        {"axial_load": -3000.0, "ribs": RIBS, "moment": 20.0, "cage": {"free": True}},
        RIGID,
    ),
    "on ribs, elastic": ({"axial_load": 3000.0, "ribs": RIBS, "axial_modes": 3}, (True, True)),
    "on ribs, inner raceway elastic": (
        {"axial_load": 3000.0, "ribs": RIBS, "moment": 20.0},
        (True, False),
    ),
    "on ribs, outer raceway elastic": ({"axial_load": 3000.0, "ribs": RIBS}, (False, True)),
    "backwards, inner guided": (
        {"speed": -2000.0, "cage": {"guidance": "inner", "land_diameter": 65.4e-3}},
        RIGID,
    ),
}


@pytest.fixture(scope="module", params=CASES.values(), ids=CASES.keys())
def state(request):
    """A balance, and scaled unknowns away from its equilibrium."""
    changes, elastic = request.param
    rng = np.random.default_rng(20161214)
    law = {name: changes[name] for name in ("limiting_ratio", "eyring_stress") if name in changes}
    rest = {name: value for name, value in changes.items() if name not in law}
    model = paper_bearing(**rest)
    if law:
        lubrication = replace(model.lubrication, traction=eyring(model.lubrication.oil, **law))
        model = replace(model, lubrication=lubrication)
    balance = model.balance(aligned=not any(elastic))
    if any(elastic):
        size = model.bearing.all_rollers * model.axial_modes
        root = rng.normal(size=(size, size)) * 3e-6
        compliances = zip((root @ root.T, 2 * root @ root.T), elastic, strict=True)
        inner, outer = (matrix if chosen else None for matrix, chosen in compliances)
        balance = replace(balance, compliance=(inner, outer))
    unknowns = static_start(balance)
    unknowns = unknowns * (1 + 0.01 * rng.normal(size=unknowns.shape))
    unknowns[:, balance.layout.displacements] += 0.3 * rng.normal(size=(1, len(balance.layout.displacements)))
    return balance, unknowns


@pytest.fixture(scope="module")
def differenced(state):
    """The Jacobian by central differences (N, N)."""
    balance, unknowns = state
    # Speeds are scaled by their nominal value, displacements and films by a micrometre.
    steps = np.full(balance.layout.size, 1e-8)
    steps[balance.layout.displacements] = 1e-5
    steps[balance.layout.field(-2)] = steps[balance.layout.field(-3)] = 1e-6
    copies = replace(balance, points=balance.points.take(np.zeros(len(steps), int)))
    ahead, behind = (copies.evaluate(unknowns + s * np.diag(steps)).residual for s in (1, -1))
    return ((ahead - behind) / (2 * steps[:, None])).T


def test_solve_inverts_the_difference_jacobian(state, differenced):
    """The matrix is never written down: its inverse times the differenced one must be the unit matrix."""
    balance, unknowns = state
    scale = np.abs(differenced).max(axis=1)
    system = balance.evaluate(unknowns)
    unit = bordered_system.solve(balance, system, differenced[None])[0]
    error = (unit - np.eye(balance.layout.size)).T
    # An error of the Jacobian, seen through its inverse, is put back into rows of size one.
    back = (differenced @ error.T) / scale[:, None]
    assert np.abs(back).max() < 1e-6


def test_product_is_that_of_the_difference_jacobian(state, differenced):
    balance, unknowns = state
    change = np.random.default_rng(7).normal(size=(1, balance.layout.size, 2))
    found = bordered_system.product(balance, balance.evaluate(unknowns), change)[0]
    expected = differenced @ change[0]
    assert found == approx(expected, rel=0, abs=1e-6 * np.abs(expected).max())


def test_shifted_solve_is_that_of_the_shifted_matrix(state, differenced):
    balance, unknowns = state
    system, shift = balance.evaluate(unknowns), bordered_system.Shift(3.0, 5.0, 7.0)
    right = np.random.default_rng(1).normal(size=(1, balance.layout.size, 2))
    found = bordered_system.solve(balance, system, right, shift)
    matrix = differenced.copy()
    spins = np.arange(balance.layout.size)[balance.layout.field(-1)]
    matrix[spins, spins] -= 3.0
    matrix[[0, 1, 4], [0, 1, 4]] -= [7.0, 7.0, 5.0]
    scale = np.abs(matrix).max(axis=1)[:, None] * np.abs(found[0]).max()
    assert (matrix @ found[0] - right[0]) / scale == approx(np.zeros(right[0].shape), abs=1e-6)


def test_elastic_raceways_are_solved_side_by_side_as_one_by_one():
    """Other rollers touch under other loads."""
    model = side_by_side([paper_bearing(axial_modes=3, load=load) for load in (300.0, 3e3, 3e4)])
    root = np.random.default_rng(5).normal(size=(90, 90)) * 3e-7
    matrix = root @ root.T
    together = replace(model.balance(3, aligned=False), compliance=(matrix, 2 * matrix))
    start = static_start(together)
    right = np.random.default_rng(1).normal(size=(3, together.layout.size, 2))
    found = bordered_system.solve(together, together.evaluate(start), right)
    for case in range(3):
        one = np.array([case])
        balance = together.take(one)
        alone = bordered_system.solve(balance, balance.evaluate(start[one]), right[one])
        assert found[one] == approx(alone, rel=0, abs=1e-9 * np.abs(alone).max())


def rings(own):
    """Three rings of five spins, the second one with these entries in the middle; its sides; its matrix."""
    rng = np.random.default_rng(3)
    middle, sides = rng.uniform(-4.0, -3.0, (3, 5)), rng.normal(size=(2, 3, 5))
    before, after = np.array([[0.5], [1.0], [1.0]]), np.array([[1.0], [0.0], [0.5]])
    middle[1] = own
    neighbour = np.roll(np.eye(5), 1, axis=0)
    matrix = [
        np.diag(m) + b * neighbour + a * neighbour.T for m, b, a in zip(middle, before, after, strict=True)
    ]
    return (middle, before, after, sides), np.array(matrix)


BY_LAPACK = pytest.mark.parametrize("many", [0, elastic_system.MANY], ids=["LAPACK", "full"])


@BY_LAPACK
def test_ring_of_spins_is_solved_case_by_case(many, monkeypatch):
    monkeypatch.setattr(elastic_system, "MANY", many)
    given, matrix = rings([-3.0, -2.0, -4.0, -2.0, -3.0])
    assert np.einsum("cij,rcj->rci", matrix, elastic_system.cyclic_tridiagonal(*given)) == approx(
        given[-1], rel=0, abs=1e-13
    )


@pytest.mark.parametrize(
    ("own", "many"),
    [(-np.ones(5), elastic_system.MANY), (-np.ones(5), 0), (np.array([0.0, -1, -1, -1, -1]), 0)],
    ids=["closed ring, full", "closed ring, LAPACK", "first spin of the open ring, LAPACK"],
)
def test_singular_ring_of_spins_is_no_number_and_spoils_no_other(own, many, monkeypatch):
    """The first only hands on its spin, so that it solves to any; warnings are errors here."""
    monkeypatch.setattr(elastic_system, "MANY", many)
    given, matrix = rings(own)
    found = elastic_system.cyclic_tridiagonal(*given)
    assert np.isnan(found[:, 1]).all()
    kept = [0, 2]
    back = np.einsum("cij,rcj->rci", matrix[kept], found[:, kept])
    assert back == approx(given[-1][:, kept], rel=0, abs=1e-13)
