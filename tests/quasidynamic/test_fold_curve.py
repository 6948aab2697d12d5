"""Folds over two parameters: a cusp, a closed curve, and solutions that do not fold."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import pytest
from pytest import approx

from quasidynamic.solve.fold_curve import (
    SAGITTA,
    CurveEnd,
    Response,
    fold_near,
    followed,
    search_together,
)


@dataclass(frozen=True)
class Toy:
    """One equation F(x; p, q) with its derivatives, in a square."""

    value: object
    by_state: object
    by_place: object
    reach: float = 2.0

    @property
    def weight(self):
        return np.ones(1)

    def response(self, states, places, directions, beside):
        x, (p, q) = states[:, 0], places.T
        value = self.value(x, p, q)
        by_place = np.stack(np.broadcast_arrays(*self.by_place(x, p, q), x), axis=1)[:, :2] @ directions
        solved, right = (slice(1, None), slice(1)) if beside else (slice(None), slice(None))
        slope = self.by_state(x, p, q)[solved, None]
        return Response(
            by_place=(by_place[right] / slope)[:, None],
            rest=value[right, None] / slope,
            balanced=abs(value[0]) < 1e-12,
        )

    def nearest(self, place):
        return np.clip(place, -self.reach, self.reach)


CUSP = Toy(lambda x, p, q: x**3 + q * x + p, lambda x, p, q: 3 * x**2 + q, lambda x, p, q: (1.0, x))
SPHERE = Toy(lambda x, p, q: x**2 + p**2 + q**2 - 1, lambda x, p, q: 2 * x, lambda x, p, q: (2 * p, 2 * q))
PLANE = Toy(lambda x, p, q: x - p - q, lambda x, p, q: 1 + 0 * x, lambda x, p, q: (-1.0, -1.0))
ROUNDED = 1e-3  # of the corner of a solution where a contact opens
CORNER = Toy(
    lambda x, p, q: p - x + 1.5 * (x + np.hypot(x, ROUNDED)),
    lambda x, p, q: 0.5 + 1.5 * x / np.hypot(x, ROUNDED),
    lambda x, p, q: (1.0, 0.0),
)
RIGHT = np.array([1.0, 0.0])


def found(*searches):
    """What searches find, all side by side."""
    return search_together(
        searches, lambda requests: [toy.response(*rest) for toy, *rest in requests], lambda: len(searches)
    )


@pytest.fixture(scope="module")
def cusp():
    (fold,) = found(fold_near(CUSP, np.array([1.0]), np.array([0.0, -1.0]), RIGHT))
    assert fold
    return fold, *found(followed(CUSP, fold))


def test_fold_on_a_line_is_where_solutions_turn_back(cusp):
    fold, _ = cusp
    assert fold.place == approx([2 / 3**1.5, -1.0], rel=0, abs=1e-9)
    assert fold.state == approx([3**-0.5], rel=0, abs=1e-7)


def test_sharp_fold_is_found_from_far():
    (fold,) = found(fold_near(CORNER, np.array([-0.5]), np.array([-0.5, 0.0]), RIGHT))
    assert fold
    assert fold.place == approx([-np.sqrt(2) * ROUNDED, 0.0], rel=0, abs=2e-7)


def test_curve_goes_around_the_cusp_to_both_edges(cusp):
    _, curve = cusp
    p, q = curve.places.T
    assert 4 * q**3 + 27 * p**2 == approx(np.zeros(len(p)), rel=0, abs=1e-8)
    assert curve.ends == (CurveEnd.RANGE_LEFT, CurveEnd.RANGE_LEFT)
    assert sorted(p[[0, -1]]) == approx([-((32 / 27) ** 0.5), (32 / 27) ** 0.5], rel=0, abs=1e-8)
    assert q[[0, -1]] == approx([-2.0, -2.0], rel=0, abs=1e-8)


def test_the_cusp_is_one_of_its_points(cusp):
    _, curve = cusp
    (place,) = (fold.place for fold in curve.folds if fold.cusp)
    assert place == approx([0.0, 0.0], rel=0, abs=1e-5)


def test_lines_between_points_are_near_the_curve(cusp):
    _, curve = cusp
    for one, other in pairwise(curve.places):
        p, q = (one + other) / 2
        assert abs(abs(p) - np.sqrt(-4 * min(q, 0.0) ** 3 / 27)) < 2 * SAGITTA


def test_closed_curve_ends_where_it_began():
    (fold,) = found(fold_near(SPHERE, np.array([0.9]), np.array([0.3, np.sqrt(0.1)]), RIGHT))
    assert fold
    assert np.hypot(*fold.place) == approx(1.0, rel=0, abs=1e-9)
    (curve,) = found(followed(SPHERE, fold))
    assert curve.ends == (CurveEnd.CLOSED, CurveEnd.CLOSED)
    assert np.hypot(*curve.places.T) == approx(np.ones(len(curve.places)), rel=0, abs=1e-8)
    turned = np.unwrap(np.arctan2(*curve.places.T[::-1]))
    assert abs(turned[-1] - turned[0]) == approx(2 * np.pi, rel=0, abs=1e-6)
    assert not any(fold.cusp for fold in curve.folds)


def test_solutions_that_do_not_fold_have_none():
    assert found(fold_near(PLANE, np.array([0.5]), np.array([0.5, 0.0]), RIGHT)) == [None]


def test_searches_are_answered_side_by_side_as_there_is_room():
    asked = []

    def answer(requests):
        asked.append(len(requests))
        return [toy.response(*rest) for toy, *rest in requests]

    searches = (fold_near(toy, np.array([0.9]), np.array([0.3, np.sqrt(0.1)]), RIGHT) for toy in 5 * [SPHERE])
    folds = search_together(searches, answer, lambda: 2)
    assert max(asked) == 2
    (alone,) = found(fold_near(SPHERE, np.array([0.9]), np.array([0.3, np.sqrt(0.1)]), RIGHT))
    assert [fold.place.tolist() for fold in folds] == 5 * [alone.place.tolist()]
