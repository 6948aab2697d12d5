"""Symmetry spares solves and changes nothing."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

from fem.raceway.symmetry import completed, permutations, representatives


def rollers(count, first=0.0):
    return first + 2 * np.pi * np.arange(count) / count


def invented(azimuths, bars, shapes=2):
    """A symmetric compliance with the symmetry of the bars, or of revolution."""
    d = azimuths[:, None] - azimuths
    here = np.ones_like(azimuths) if bars is None else 1 + 0.3 * np.cos(bars * azimuths)
    plane = here[:, None] * here * (np.cos(d) + 0.2 * np.cos(2 * d) + 3.0)
    return np.einsum("ij,mn->imjn", plane, 1 + np.eye(shapes))


@pytest.mark.parametrize(
    ("count", "bars", "first", "solves"),
    [(30, None, 0.0, 1), (30, None, 0.1, 1), (30, 24, 0.0, 3), (30, 30, 0.0, 1), (7, 24, 0.0, 4),
     (30, 24, 0.01, 5)],
)  # fmt: skip
def test_number_of_solves(count, bars, first, solves):
    assert representatives(permutations(rollers(count, first), bars)).size == solves


@given(st.integers(1, 16), st.one_of(st.none(), st.integers(1, 24)), st.sampled_from([0.0, 0.1, np.pi / 24]))
def test_completed_matrix_is_the_whole_one(count, bars, first):
    azimuths = rollers(count, first)
    whole = invented(azimuths, bars)
    renumbered = permutations(azimuths, bars)
    solved = representatives(renumbered)
    assert completed(whole[:, :, solved], solved, renumbered) == approx(whole, rel=1e-9)
