"""Rollers that given forces press between two rigid rings, with films that thin under their loads."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.rigid_rings import Stations
from quasidynamic.contact.line import LoadLaw, Slices

FilmOf = Callable[
    [NDArray, NDArray], tuple[NDArray, NDArray]
]  # (2, n) [m], [m/N] by loads (2, n) of rollers (n)

ROLLER_STEPS = 30  # rarely more than ten; a roller that hardly anything presses takes most
UPHILL = 0.5  # of the slope at the start of a step, by which the energy may rise at its end
FILM_STEPS = 60  # rarely more than three
NEAR_ENOUGH = 1e-4  # lengths, of a roller's last step
FILM_DIGITS = 1e-6  # lengths
SLOW = 0.5  # of the last misfit: a step that leaves more may go to and fro for ever
FORCE_DIGITS = 1e-8  # of a roller's largest force
LONGEST_STEP = 50.0  # lengths, of a roller in a step
SINGULAR = 1e-12  # of the product of two stiffnesses: a determinant that is rounding


class OutOfWork(Exception):
    """Rollers do not come to rest within the evaluations of their contacts that they are given."""


@dataclass
class ContactWork:
    """Evaluations of the contacts of all rollers that are left."""

    left: float = np.inf

    def counted(self, film_of: FilmOf) -> FilmOf:
        """The films, each evaluation of which counts.

        Raises `OutOfWork` at one too many.
        """

        def counted(load: NDArray, rollers: NDArray) -> tuple[NDArray, NDArray]:
            self.left -= 1
            if self.left < 0:
                raise OutOfWork
            return film_of(load, rollers)

        return counted


class Contacts(NamedTuple):
    """Forces at both raceways of Z rollers, by approaches that count the film as a gap that closes."""

    force: NDArray  # (2, M, Z) [N]
    stiffness: NDArray  # (2, M, M, Z) [N/m]
    film: NDArray  # (2, Z) [m]
    approach: NDArray  # (2, Z) elastic [m]
    closed: NDArray  # (2, Z) elastic approach less the film [m]
    rate: NDArray  # (2, Z) of the elastic approach over that [-]


class PressedState(NamedTuple):
    """Rollers at rest at one place of the inner ring."""

    place: NDArray  # (2, M) y, z and half the length times dy/dx, dz/dx [m]
    outer: NDArray  # (M, Z) approach and tilt at the outer raceway less its film [m]
    contacts: Contacts
    excess: NDArray  # (2, M) load on the ring less what the rollers carry [N]
    stiffness: NDArray  # (2, M, 2, M) [N/m] of the ring on its rollers


@dataclass(frozen=True, kw_only=True)
class PressedRollers:
    """Z rollers between rigid rings; the energy of their contacts is convex, films included."""

    law: LoadLaw
    slices: Slices
    drop: NDArray  # (K, 2, 1) drop of rollers and raceways [m]
    normal: NDArray  # (Z, 2) y, z of the outward radius at each roller
    film_of: FilmOf
    thickest: NDArray  # (2, Z) films without load [m]
    outward: NDArray  # (Z) force that presses each roller outwards [N]
    gap: float | NDArray  # radial clearance, one or that at every roller (Z) [m]
    load: NDArray  # (2, M) on the ring: force along y, z and moment over half the length [N]
    length: float  # [m] usual size of a displacement
    stations: Stations

    def at(self, place: NDArray, outer: NDArray, near: Contacts | None = None) -> PressedState:
        """Put every roller at rest, from `outer`, with the ring at a place; contacts nearby save time."""
        room = self.stations.at_rollers(self.normal @ place).T.copy()
        room[0] -= self.gap
        outer, contacts = self._at_rest(room, outer, near)
        carried = self.normal.T @ self.stations.about_middle(contacts.force[0].T)
        of_rollers = _in_series(*contacts.stiffness).transpose(2, 0, 1)
        in_series = self.stations.stiffness_about_middle(of_rollers).transpose(1, 2, 0)
        squares = np.einsum("zi,zk,abz->iakb", self.normal, self.normal, in_series)
        return PressedState(place, outer, contacts, self.load - carried, squares)

    def _at_rest(self, room: NDArray, outer: NDArray, near: Contacts | None) -> tuple[NDArray, Contacts]:
        """Newton's method on every roller by itself: steps that run far past its lowest energy are cut."""
        contacts = self._contacts(room - outer, outer, near)
        damping, weight = np.ones(outer.shape[1]), np.abs(self.outward)
        for _ in range(ROLLER_STEPS):
            pull = self._unbalanced(contacts)
            step = _solved(contacts.stiffness.sum(0), -pull)
            step *= damping / np.maximum(np.abs(step).max(0) / (LONGEST_STEP * self.length), 1.0)
            trial = outer + step
            after = self._contacts(room - trial, trial, contacts)
            taken = (self._unbalanced(after) * step).sum(0) <= -UPHILL * (pull * step).sum(0)
            outer = np.where(taken, trial, outer)
            contacts = Contacts(
                *(np.where(taken, new, old) for new, old in zip(after, contacts, strict=True))
            )
            damping = np.where(taken, 1.0, damping / 3)
            still = np.abs(step).max(0) > NEAR_ENOUGH * self.length
            enough = FORCE_DIGITS * (contacts.force[:, 0].max(0) + weight)
            if not (still & (np.abs(self._unbalanced(contacts)).max(0) > enough)).any():
                break
        return outer, contacts

    def _unbalanced(self, contacts: Contacts) -> NDArray:
        """Slope of the energy (M, Z) [N] by approach and tilt at the outer raceway."""
        pull = contacts.force[1] - contacts.force[0]
        pull[0] -= self.outward
        return pull

    def _contacts(self, inner: NDArray, outer: NDArray, near: Contacts | None) -> Contacts:
        """Contacts at approaches (M, Z) less their films: elastic approach = that + film(load)."""
        closed = np.array([inner, outer])
        approach = self._elastic_approach(closed, near)
        force, stiffness = self._elastic(approach, closed)
        film, slope = self.film_of(force[:, 0], np.arange(force.shape[-1]))
        steeper = 1 - slope * stiffness[:, 0, 0]
        if self.slices.axial_modes > 1:  # at the same closed approach a tilt changes load and film
            cross = stiffness[:, 0, 1] / steeper
            stiffness[:, 1, 1] += stiffness[:, 0, 1] * cross * slope
            stiffness[:, 0, 1] = stiffness[:, 1, 0] = cross
        stiffness[:, 0, 0] /= steeper
        return Contacts(force, stiffness, film, approach, closed[:, 0], np.reciprocal(steeper))

    def _elastic_approach(self, closed: NDArray, near: Contacts | None) -> NDArray:
        """Elastic approaches (2, Z) where film and load agree, by Newton's method within bounds."""
        low, high = closed[:, 0].copy(), closed[:, 0] + self.thickest
        guess = high if near is None else near.approach + near.rate * (low - near.closed)
        approach, last = np.clip(guess, low, high), np.full(low.shape, np.inf)
        left = np.arange(low.shape[1])
        for _ in range(FILM_STEPS):
            here = approach[:, left]
            force, stiffness = self._elastic(here, closed[..., left])
            film, slope = self.film_of(force[:, 0], left)
            excess = here - film - closed[:, 0, left]
            low[:, left] = np.where(excess < 0, here, low[:, left])
            high[:, left] = np.where(excess > 0, here, high[:, left])
            newton = here - excess / (1 - slope * stiffness[:, 0, 0])
            halved = (newton < low[:, left]) | (newton > high[:, left])
            halved |= np.abs(excess) > SLOW * last[:, left]
            far = np.abs(excess) >= FILM_DIGITS * self.length
            approach[:, left] = np.where(far & halved, (low[:, left] + high[:, left]) / 2, newton)
            last[:, left] = np.abs(excess)
            left = left[far.any(axis=0)]
            if not len(left):
                break
        return approach

    def _elastic(self, approach: NDArray, closed: NDArray) -> tuple[NDArray, NDArray]:
        """Forces (2, M, Z) [N] and stiffnesses (2, M, M, Z) [N/m] at elastic approaches (2, Z) [m]."""
        modes, slices = np.concatenate([approach[None], closed[:, 1:].swapaxes(0, 1)]), self.slices
        line_load, slope = self.law(slices.spread(modes) - self.drop)
        return slices.summed(line_load).swapaxes(0, 1), slices.paired(slope).transpose(2, 0, 1, 3)


def _solved(matrix: NDArray, side: NDArray) -> NDArray:
    """Solutions (M, Z) of Z symmetric systems (M, M, Z), M one or two."""
    if len(matrix) == 1:
        return side / matrix[0]
    (a, b), (_, d) = matrix
    return np.array([d * side[0] - b * side[1], a * side[1] - b * side[0]]) / _determinant(matrix)


def _determinant(matrix: NDArray) -> NDArray:
    (a, b), (c, d) = matrix
    return np.maximum(a * d - b * c, SINGULAR * a * d + np.finfo(float).tiny)


def _in_series(inner: NDArray, outer: NDArray) -> NDArray:
    """Stiffness (M, M, Z) of both raceways one behind the other."""
    both = inner + outer
    if len(both) == 1:
        return inner * outer / both
    adjugate = np.array([[both[1, 1], -both[0, 1]], [-both[1, 0], both[0, 0]]])
    return np.einsum("abz,bcz,cdz->adz", inner, adjugate / _determinant(both), outer)
