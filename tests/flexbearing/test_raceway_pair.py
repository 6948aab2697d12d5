"""Two raceways side by side: deviations are counted from the mean place of each, translations apart."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from pytest import approx

from flexbearing.coupling import RacewayPair
from flexbearing.coupling.raceway_pair import OUTWARD, LinearPair, linear_answer, radial

AZIMUTHS = 2 * np.pi * np.arange(7) / 7 + 0.2
DRAW = np.random.default_rng(7).normal
FORCES = 1e3 * DRAW(size=(2, 7, 3))


@dataclass(frozen=True)
class Ring:
    """A raceway that answers linearly; `solved_in_full` keeps its tangent to itself."""

    absolute: NDArray
    translation: NDArray
    initial_deviation: NDArray
    initial_translation: NDArray
    solved_in_full: bool = False
    azimuths = AZIMUTHS
    rigid = False

    def answer(self, outward):
        return linear_answer(self, outward)

    def linearised(self, outward):
        return self

    def figures(self):
        return {}

    def moved(self, place):
        """The same ring on a support that gives way: its raceway and its mean place move alike."""
        by_force = 1e-8 * DRAW(size=(2, 7, 3))
        absolute, initial = self.absolute.copy(), self.initial_deviation.copy()
        absolute[:, 0] += radial(AZIMUTHS, by_force)
        initial[:, 0] += radial(AZIMUTHS, place)
        return Ring(
            absolute, self.translation + by_force, initial, self.initial_translation + place,
            self.solved_in_full,
        )  # fmt: skip


def ring(*, solved_in_full=False):
    return Ring(
        1e-9 * DRAW(size=(7, 3, 7, 3)), 1e-9 * DRAW(size=(2, 7, 3)), 1e-6 * DRAW(size=(7, 3)),
        1e-6 * DRAW(size=2), solved_in_full,
    )  # fmt: skip


def test_translation_of_a_raceway_is_no_deviation():
    for solved_in_full in (False, True):
        inner, outer = (ring(solved_in_full=solved_in_full) for _ in range(2))
        (expected, _), (deviation, _) = (
            RacewayPair(inner, outer).answer(FORCES),
            RacewayPair(*(part.moved(1e-3 * DRAW(size=2)) for part in (inner, outer))).answer(FORCES),
        )
        assert deviation == approx(expected, rel=0, abs=1e-9 * np.abs(expected).max() + 1e-15)


def test_raceway_in_full_answers_as_the_linear_one():
    inner, outer = ring(), ring()
    linear, _ = RacewayPair(inner, outer).answer(FORCES)
    in_full = (replace(part, solved_in_full=True) for part in (inner, outer))
    full, _ = RacewayPair(*in_full).answer(FORCES)
    assert full == approx(linear, rel=1e-9, abs=1e-15)


def test_translation_of_each_raceway_is_that_of_its_outward_forces_and_its_initial_one():
    inner, outer = ring(), ring()
    translation = LinearPair(inner, outer).translation(FORCES)
    for race, part in enumerate((inner, outer)):
        by_force = np.einsum("aij,ij->a", part.translation, OUTWARD[race] * FORCES[race])
        assert translation[race] == approx(part.initial_translation + by_force, rel=1e-12)
    assert LinearPair(None, outer).translation(FORCES)[0] == approx(0.0, abs=0.0)


def test_forces_of_rollers_push_the_inner_raceway_inwards_and_the_outer_one_outwards():
    soft = Ring(np.eye(21).reshape(7, 3, 7, 3), np.zeros((2, 7, 3)), np.zeros((7, 3)), np.zeros(2))
    deviation, _ = RacewayPair(soft, soft).answer(FORCES)
    assert deviation == approx(np.array([-FORCES[0], FORCES[1]]), rel=1e-12)
