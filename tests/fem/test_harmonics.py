"""A raceway in harmonics gives its compliance for rollers anywhere."""

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from numpy.polynomial import legendre
from pytest import approx

from fem import Elastic, ImpossiblePart
from fem.assembly.factorisation import NotSolved
from fem.half_space.line_load import cubic_tail, curvature_tail, indentation, indentation_harmonics
from fem.raceway.harmonics import HarmonicCompliance, Responses, with_short_waves

STEEL = Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
UNIT = (1 - 0.28**2) / (np.pi * 203e9)  # [1/Pa]
R, L, M, N = 37.5e-3, 5e-3, 3, 40
SMOOTH = 1e-9 * np.array([[3.0, 0.2, -0.1], [0.2, 1.0, 0.0], [-0.1, 0.0, 0.5]])  # [m/N]


def raceway(remainder, bars=None):
    """A raceway that answers like a half-space with a remainder per harmonic (K, M, M) or (K, M, K, M)."""
    n = np.arange(-N, N + 1)
    half_space = indentation_harmonics(n, R, L, M, STEEL)
    response = remainder.astype(complex) if remainder.ndim == 4 else half_space + remainder
    if remainder.ndim == 4:
        response[n + N, :, n + N] += half_space
    return HarmonicCompliance(
        harmonics=n, response=response, radius=R, length=L, elastic=STEEL, bars=bars,
        unknowns=1, elements=1, seconds={},
    )  # fmt: skip


def falling(rate=0.3):
    return rate ** np.abs(np.arange(-N, N + 1))[:, None, None] * SMOOTH


def coupled(bars):
    """Like a ring on bars: local compliance b(phi) between all rollers, which turns n into n +- bars."""
    n = np.arange(-N, N + 1)
    step = n[:, None] - n
    link = np.where(step == 0, 1.0, np.where(np.abs(step) == bars, 0.2j * np.sign(step), 0.0))
    amount = 0.3 ** np.abs(n)
    pairs = (link * np.sqrt(np.outer(amount, amount)))[:, None, :, None] * SMOOTH[:, None, :]
    return np.ascontiguousarray(pairs)


@settings(max_examples=10)
@given(st.lists(st.floats(0.05, 1.0), min_size=2, max_size=6))
def test_sum_is_remainder_beside_a_line_and_half_space_between_lines(gaps):
    phi = np.cumsum(gaps)
    difference = phi[:, None] - phi
    n = np.arange(-N, N + 1)
    plain = np.einsum("ijk,kmp->imjp", np.cos(difference[..., None] * n), falling())
    for i, j in zip(*np.nonzero(difference), strict=True):
        plain[i, :, j] += indentation(difference[i, j], R, L, M, STEEL)
    assert raceway(falling()).at(phi).absolute == approx(plain, rel=0, abs=1e-7 * SMOOTH.max())


def test_curvature_needs_no_more_harmonics():
    """A remainder c/(n^2 - 1) + d/n^3 is summed to the end; at phi = 0 the former gives 3/2 c."""
    n = np.abs(np.arange(-N, N + 1)).astype(float)
    away = np.where(n > 1, n, 2.0)
    law = np.where(n > 1, 1 / (away**2 - 1), 0.0)
    flat = raceway(law[:, None, None] * SMOOTH)
    assert flat.at([0.3]).absolute[0, :, 0] == approx(1.5 * SMOOTH, rel=0, abs=1e-9 * SMOOTH.max())
    steep = raceway((law + np.where(n > 1, away**-3, 0.0))[:, None, None] * SMOOTH)
    zeta = 2 * (1.2020569031595942 - 1)
    assert steep.at([0.3]).absolute[0, :, 0] == approx(
        (1.5 + zeta) * SMOOTH, rel=1e-5, abs=1e-9 * SMOOTH.max()
    )


def test_short_waves_of_another_source_are_part_of_the_sum():
    """A remainder that falls slowly and then ends: harmonics above 20 are known to themselves alone."""
    n, resolved = np.arange(-N, N + 1), 20
    amount = np.where(np.abs(n) <= 28, 0.5, 0.0)  # flat, which no extrapolation from 20 on could end
    whole = raceway(amount[:, None, None] * SMOOTH)
    near = np.abs(n) <= resolved
    cut = replace(
        whole,
        harmonics=n[near],
        response=whole.response[near],
        short_waves=whole.response[N + resolved + 1 :],
    )
    phi = np.array([0.1, 0.5, 2.0])
    assert cut.at(phi).absolute == approx(whole.at(phi).absolute, rel=0, abs=1e-12 * SMOOTH.max())
    assert cut.truncation == approx(whole.truncation, abs=1e-12)


def test_short_waves_replace_what_elements_answer_to_them():
    """Coupling to the waves that are resolved stays, that among short waves goes."""
    bars, resolved = 12, 20
    response = raceway(coupled(bars), bars).response
    waves = np.arange(1.0, 31.0)[:, None, None] * np.eye(M)
    changed = with_short_waves(Responses(response, 1, 1), resolved, waves)
    n = np.arange(-N, N + 1)
    short = np.abs(n) > resolved
    kept = ~(short[:, None] & short)
    assert np.array_equal(np.moveaxis(changed.response, 2, 1)[kept], np.moveaxis(response, 2, 1)[kept])
    for k in np.flatnonzero(short):
        assert np.array_equal(changed.response[k, :, k], waves[abs(n[k]) - resolved - 1])
        assert not changed.response[k, :, short & (np.arange(n.size) != k)].any()
    assert np.array_equal(changed.short_waves, waves[N - resolved :])


@pytest.mark.parametrize("phi", [0.0, 0.3, -2.0])
def test_tails_are_sums(phi):
    n = np.arange(N + 1, 200001)
    assert curvature_tail(phi, N) == approx(np.sum(2 * np.cos(n * phi) / (n**2 - 1.0)), abs=1e-5)
    assert cubic_tail(phi, N) == approx(np.sum(2 * np.cos(n * phi) / n**3.0), abs=0.005 / N**2)


@pytest.mark.slow
def test_half_space_has_its_harmonics():
    """1/|n| times the mean square of the pattern far out; and their sum is the indentation again."""
    n = np.arange(-1000, 1001)
    h = indentation_harmonics(n, R, L, M, STEEL)
    assert np.diag(h[-1]) * 1000 / UNIT == approx((2 * np.arange(M) + 1) / L, rel=0.03)
    for phi in (0.4, 2.9):
        damped = np.exp(-((n / 300) ** 2)) * np.cos(n * phi)
        expected = indentation(phi, R, L, M, STEEL)
        assert np.tensordot(damped, h, 1) == approx(expected, rel=0, abs=2e-4 * expected[0, 0])


def test_indentation_far_from_the_line_by_brute_force():
    """Where the recurrence of the near kernel would lose all digits: eight shapes, three lengths away."""
    chord, shapes = 3 * L, 8
    phi = 2 * np.arcsin(chord / (2 * R))
    x, w = legendre.leggauss(30)
    a = legendre.legvander(x, shapes - 1) * (np.arange(shapes) + 0.5)
    distance = np.hypot(chord, (x[:, None] - x) * L / 2)
    brute = UNIT * np.einsum("pm,qn,p,q,pq->mn", a, a, w, w, 1 / distance)
    assert indentation(phi, R, L, shapes, STEEL) == approx(brute, rel=0, abs=1e-12 * brute.max())


def test_full_matrix_of_harmonics_is_the_same_body_of_revolution():
    phi = np.array([0.1, 0.5, 2.0, 4.0])
    diagonal = np.zeros((2 * N + 1, M, 2 * N + 1, M))
    own = np.arange(2 * N + 1)
    diagonal[own, :, own] = falling()
    compact, full = raceway(falling()).at(phi), raceway(diagonal).at(phi)
    assert full.absolute == approx(compact.absolute, rel=0, abs=1e-13 * SMOOTH.max())
    assert full.translation == approx(compact.translation, rel=0, abs=1e-13 * SMOOTH.max())
    assert full.support_stiffness == approx(compact.support_stiffness, rel=1e-12)


def test_rotation_by_one_bar_changes_nothing_but_half_a_bar_does():
    bars, phi = 12, np.array([0.03, 0.5, 2.0])
    cage = raceway(coupled(bars), bars)
    here, there = cage.at(phi), cage.at(phi + 2 * np.pi / bars)
    assert there.absolute == approx(here.absolute, rel=0, abs=1e-12 * SMOOTH.max())
    between = cage.at(phi + np.pi / bars)
    assert np.abs(between.absolute - here.absolute).max() > 1e-3 * SMOOTH.max()


def test_bars_are_where_they_are():
    """The modulation of the own term is 2 Re(sum of 0.2 i e^{i bars phi}): minus a sine, not plus."""
    bars = 12
    own = raceway(coupled(bars), bars).at([np.pi / 2 / bars]).absolute[0, 0, 0, 0]
    mean = raceway(coupled(bars), bars).at([0.0]).absolute[0, 0, 0, 0]
    n = np.arange(-N, N - bars + 1)
    overlap = np.sum(np.sqrt(0.3 ** np.abs(n) * 0.3 ** np.abs(n + bars))) * SMOOTH[0, 0]
    assert own - mean == approx(-0.4 * overlap, rel=1e-9)


def test_translation_is_the_first_harmonic_of_the_answer():
    """t = 1/pi times the integral of w_0 (sin, cos), from rollers all around."""
    cage = raceway(coupled(12), 12)
    around = 0.37 + 2 * np.pi * np.arange(97) / 97
    found = cage.at(around)
    loaded = found.absolute[:, 0, 5].copy()  # the answer at all others; the own one is not on the same curve
    n = np.arange(-N, N + 1)
    loaded[5] += np.sum(indentation_harmonics(n, R, L, M, STEEL)[:, 0], axis=0)
    half_space = np.array([indentation(phi - around[5], R, L, M, STEEL)[0] for phi in np.delete(around, 5)])
    smooth = np.delete(loaded, 5, axis=0) - half_space
    first = np.array([found.absolute[5, 0, 5], *smooth])
    order = np.concatenate([[around[5]], np.delete(around, 5)])
    h1 = indentation_harmonics(np.array([1]), R, L, M, STEEL)[0, 0]
    for row, wave in enumerate((np.sin, np.cos)):
        expected = 2 / 97 * wave(order) @ first + 2 * h1 * wave(around[5])
        assert found.translation[row, 5] == approx(expected, rel=0, abs=1e-6 * SMOOTH.max())


def test_support_stiffness_is_resultant_over_translation():
    """Forces like cos(phi) on very many rollers against the translation they cause."""
    count = 121
    phi = 2 * np.pi * np.arange(count) / count
    found = raceway(falling()).at(phi)
    moved = found.translation[1, :, 0] @ np.cos(phi)
    assert np.sum(np.cos(phi) ** 2) / moved == approx(found.support_stiffness, rel=1e-9)


def test_too_few_harmonics_are_refused():
    slow = 1 / np.maximum(np.abs(np.arange(-N, N + 1)), 1.0)
    with pytest.raises(NotSolved, match="take more harmonics"):
        raceway(slow[:, None, None] * SMOOTH).at([0.0])


def test_two_rollers_at_one_place_are_refused():
    with pytest.raises(ImpossiblePart, match="different"):
        raceway(falling()).at([0.1, 2.0, 0.1 + 2 * np.pi])


def test_impossible_arrays_are_named():
    right = raceway(falling())
    with pytest.raises(ImpossiblePart, match="in order"):
        replace(right, harmonics=right.harmonics + 1)
    with pytest.raises(ImpossiblePart, match="shape"):
        replace(right, response=right.response[:, :, :2])


def test_known_rings_never_load_the_finite_elements():
    """A run whose rings are in the cache needs no NGSolve, which takes longer to load than such a run."""
    program = "import sys, fem.raceway.harmonics; sys.exit('ngsolve' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0
