"""Unknowns eliminated by nested dissection, against plain dense algebra."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx
from scipy import sparse

from fem.assembly.factorisation import NotSolved
from fem.assembly.static_condensation import eliminate, owners


def chain(seed, cells):
    """A box of invented elements with 8 nodes each, and their stiffness."""
    rng = np.random.default_rng(seed)
    nodes = np.arange(np.prod(np.array(cells) + 1)).reshape(np.array(cells) + 1)
    elements, centres = [], []
    K = np.zeros((nodes.size, nodes.size))
    for cell in np.ndindex(*cells):
        i, j, k = cell
        element = nodes[i : i + 2, j : j + 2, k : k + 2].ravel()
        root = rng.standard_normal((8, 8))
        K[np.ix_(element, element)] += root @ root.T + np.eye(8)
        elements.append(element)
        centres.append(cell)
    return K, elements, np.array(centres, dtype=float)


@settings(max_examples=12, deadline=None)
@given(st.integers(0, 1000), st.tuples(st.integers(1, 9), st.integers(1, 3), st.integers(1, 3)), st.data())
def test_schur_complement_is_the_dense_one(seed, cells, data):
    K, elements, centres = chain(seed, cells)
    numbers = st.lists(st.integers(0, len(K) - 1), min_size=1, max_size=len(K) - 1, unique=True)
    kept = np.array(data.draw(numbers))
    held = np.array([k for k in data.draw(numbers) if k not in kept][: len(K) // 4], dtype=int)
    gone = np.setdiff1d(np.arange(len(K)), np.append(kept, held))
    owner = owners(elements, centres, len(K))
    owner[kept] = owner[held] = 0
    loads = np.random.default_rng(seed).standard_normal((len(K), 2))
    loads[gone[: gone.size // 2]] = 0.0
    found = eliminate(sparse.csr_array(K), loads, owner, kept)
    bordered = np.block([[K, -loads], [-loads.T, np.zeros((2, 2))]])
    stays = np.append(kept, len(K) + np.arange(2))
    answer = np.linalg.solve(K[np.ix_(gone, gone)], bordered[np.ix_(gone, stays)])
    dense = bordered[np.ix_(stays, stays)] - bordered[np.ix_(stays, gone)] @ answer
    assert found.schur == approx(dense, rel=0, abs=1e-10 * np.abs(K).max())
    u = found.interior(np.eye(stays.size))
    assert u[gone] == approx(-answer, rel=0, abs=1e-9 * np.abs(answer).max(initial=1.0))
    assert u[kept] == approx(np.eye(stays.size)[: kept.size], abs=0)
    assert not u[held].any()


def test_floating_body_is_noticed():
    K, elements, centres = chain(0, (3, 1, 1))
    K[0, 0] = -1.0
    owner = owners(elements, centres, len(K))
    owner[-1] = 0
    with pytest.raises(NotSolved, match="nothing holds the body"):
        eliminate(sparse.csr_array(K), np.zeros((len(K), 0)), owner, np.array([len(K) - 1]))


def test_an_unknown_belongs_to_the_smallest_group_around_it():
    _, elements, centres = chain(0, (40, 1, 1))
    owner = owners(elements, centres, 41 * 4)
    assert owner.min() == 1  # the cut through the middle of the chain
    assert np.count_nonzero(owner == 1) == 4  # one face
    assert owner[0] > 1
    assert owners(elements, centres, 41 * 4 + 1)[-1] == 0
