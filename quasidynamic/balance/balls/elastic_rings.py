"""Balance of a four-point contact ball bearing with elastic rings."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves, GrooveShape, shape_of
from quasidynamic.balance.balls.four_contacts import (
    ARMS_BY_BALL,
    ARMS_BY_SHAPE,
    BallsOnArches,
    FourContacts,
)
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.parts.ball import FourPointBearing


class RigidRingState(NamedTuple):
    """Forces on the inner ring at one place of it; moments and tilts are taken over the pitch radius."""

    place: NDArray  # (5) [m]
    centres: NDArray  # (Z, 2) [m] of the balls
    balls: BallsOnArches
    moves: NDArray  # (Z, 2) [m] that balls still have to make
    excess: NDArray  # (5) load less what the balls carry, after these moves [N]
    stiffness: NDArray  # (5, 5) [N/m]


def ring_levers(bearing: FourPointBearing) -> NDArray:
    """Over which moments become forces, and tilts displacements (5) [-, m]."""
    pitch = bearing.pitch_diameter / 2
    return np.array([1.0, 1.0, 1.0, pitch, pitch])


@dataclass(frozen=True)
class RigidRings:
    """Two rigid rings with balls between them."""

    contacts: FourContacts
    load: NDArray  # (5) [N] moments over the pitch radius

    @classmethod
    def of(cls, bearing: FourPointBearing, load: NDArray, speed: float = 0.0) -> "RigidRings":
        """Build from a bearing, a load [N, N m] and the speed of the inner ring [rad/s].

        Raises `ImpossiblePart` for a load that is not five finite numbers; `NotSolved` when neither load nor
        interference holds the ring.
        """
        load = np.asarray(load, dtype=float)
        if load.shape != (5,) or not np.isfinite(load).all():
            raise ImpossiblePart(f"load = {load} must be five finite numbers: Fx, Fy, Fz, My, Mz")
        if not load.any() and bearing.clearance >= 0.0:
            raise NotSolved(
                f"no load, and a clearance of {bearing.clearance * 1e6:g} um: nothing holds the ring, its "
                "position is undetermined; give a load or an interference (negative clearance)",
                "undetermined",
            )
        return cls(FourContacts.of(bearing, speed), load / ring_levers(bearing))

    def at(self, place: NDArray, centres: NDArray, balls: BallsOnArches, moves: NDArray) -> RigidRingState:
        """State of the ring at a place with balls that are in balance after small moves (Z, 2) [m]."""
        by_place = self.contacts.arms_by_place
        tangent = self.contacts.carried(balls.force_slopes @ (balls.arms_by_grooves @ by_place))
        excess = self.load - self.contacts.carried(balls.after(moves))
        return RigidRingState(place, centres, balls, moves, excess, tangent)

    @property
    def of_whole_contacts(self) -> "RigidRings":
        """The same without shoulders."""
        return replace(self, contacts=self.contacts.of_whole_contacts)

    def withdrawn(self, angle: float) -> "RigidRings":
        """The same with arches that end further out by an angle [rad]."""
        return replace(self, contacts=self.contacts.withdrawn(angle))

    def at_speed(self, speed: float) -> "RigidRings":
        """The same at another speed of the inner ring [rad/s]."""
        return replace(self, contacts=replace(self.contacts, speed=speed))

    @property
    def largest_load(self) -> float:
        """Largest load on the ring [N]."""
        return float(np.abs(self.load).max())

    def imbalance(self, state: RigidRingState) -> float:
        """Largest unbalanced force over the largest force [-]."""
        left = max(np.abs(state.excess).max(), np.abs(state.balls.excess).max())
        return float(left / max(self.largest_load, state.balls.forces.loads.max()))

    def usual_stiffness(self, largest: float = 0.0) -> float:
        """Stiffness of a diagonal under the largest load, or the largest force [N] on a contact [N/m]."""
        force = max(largest, self.largest_load)
        return 1.5 * self.contacts.in_series ** (2 / 3) * force ** (1 / 3)

    def first_place(self) -> NDArray:
        """Ring (5) pushed along its load to where about one ball would carry it: rather too far."""
        size, contacts = self.largest_load, self.contacts
        if size == 0.0:
            return np.zeros(5)
        direction, start = self.load / np.linalg.norm(self.load), contacts.distances[0]
        moves = np.linalg.norm(contacts.moves @ direction, axis=1).max()
        distance = np.hypot(*start)
        gap = max(contacts.reach.sum() - distance, 0.0)
        squeeze = (size / contacts.in_series) ** (2 / 3)
        return direction * (gap + squeeze) / (moves * start.min() / distance)


class ElasticRingState(NamedTuple):
    """Forces on rings and balls at one place of the inner ring and one shape of the rings."""

    place: NDArray  # (5) [m]
    shape: NDArray  # (8 Z) [m] displacements of the groove centres by forces
    centres: NDArray  # (Z, 2) [m] of the balls
    balls: BallsOnArches
    moves: NDArray  # (Z, 2) [m] that balls still have to make
    excess: NDArray  # (5) load less what the balls carry, after these moves [N]
    misfit: NDArray  # (8 Z) shape less what the forces make of it [m]
    softness: NDArray  # (8 Z, L) [-] change of the misfit by the shape at loaded contacts, less one
    forces: NDArray  # (Z, 8, 6) [N/m, N] change of the forces by the place, and by the misfit once it closes
    shapes: NDArray  # (8 Z, 6) [-, m] and that of the shape


@dataclass(frozen=True)
class ElasticRings:
    """Two elastic rings with balls between them."""

    rigid: RigidRings  # the same rings without their elasticity
    grooves: ElasticGrooves  # two arcs each, a ball's contacts side by side
    usual_stiffness: float  # [N/m] that weighs a misfit against forces

    def at(
        self, place: NDArray, shape: NDArray, centres: NDArray, balls: BallsOnArches, moves: NDArray
    ) -> ElasticRingState:
        """State of the rings at a place and of a shape, with balls that are in balance after small moves."""
        contacts, by_grooves = self.rigid.contacts, balls.arms_by_grooves
        excess, by_place = self.rigid.load - contacts.carried(balls.after(moves)), contacts.arms_by_place
        given = ShapeByArms.of(self.grooves, balls)
        arms = np.concatenate([by_grooves @ by_place, ARMS_BY_BALL @ moves[..., None]], axis=-1)
        columns = given.after(arms)
        misfit = shape - given.made.ravel() - columns[:, 5]
        columns[:, 5] = -misfit
        softness = given.softness(by_grooves)
        shapes = given.closed(softness, columns)
        moved = ARMS_BY_SHAPE[:, None] * shapes.reshape(-1, 8, 6)
        moved[..., :5] += by_place
        forces = balls.force_slopes @ (by_grooves @ moved)
        return ElasticRingState(place, shape, centres, balls, moves, excess, misfit, softness, forces, shapes)

    def imbalance(self, state: ElasticRingState) -> float:
        """Largest force that balance or the shape of the rings requires, over the largest force [-]."""
        largest = max(self.rigid.largest_load, state.balls.forces.loads.max())
        left = np.abs(state.excess).max(), np.abs(state.balls.excess).max(), self._misfit_forces(state).max()
        return float(max(left) / largest)

    def size(self, state: ElasticRingState) -> float:
        """Length of all that is out of balance [N]."""
        return float(np.hypot(np.linalg.norm(state.excess), np.linalg.norm(self._misfit_forces(state))))

    def _misfit_forces(self, state: ElasticRingState) -> NDArray:
        return self.usual_stiffness * np.abs(state.misfit)

    def stiffness(self, state: ElasticRingState) -> NDArray:
        """Tangent stiffness (5, 5) [N/m]: load over the place of the inner face."""
        return self.rigid.contacts.carried(state.forces[..., :5])

    def step(self, state: ElasticRingState, place: NDArray) -> NDArray:
        """Change of the shape (8 Z) [m] that closes the misfit while the ring moves (5) [m]."""
        return state.shapes @ np.append(place, 1.0)

    def is_stable(self, state: ElasticRingState) -> bool:
        """Whether every eigenvalue of the softness plus one is above zero; else contacts and rings snap.

        They are where those of the symmetric part are, which takes a twentieth of the time to find.
        """
        softness = state.softness[_loaded(state.balls)]  # others make no shape
        try:
            np.linalg.cholesky(np.eye(len(softness)) + (softness + softness.T) / 2)
        except np.linalg.LinAlgError:
            return 1.0 + float(np.linalg.eigvals(softness).real.min(initial=0.0)) > 0
        return True


def _loaded(balls: BallsOnArches) -> NDArray:
    """Which displacements of the grooves (8 Z) are those of loaded contacts."""
    return np.repeat(balls.forces.loads.ravel() > 0, 2)


class ShapeByArms(NamedTuple):
    """Shape of both rings under the forces of balls, and how it changes with the arms of their contacts."""

    made: NDArray  # (Z, 2, 2, 2) [m]
    grooves: tuple[GrooveShape | None, ...]  # of the inner and the outer race
    pressing: NDArray  # (Z, 2, 2, 3, 8) [N/m, rad/m] force and angle of each contact by the arms
    turn: NDArray  # (Z, 2, 2, 2) [rad/m] angle of each contact by its own arm
    reading: NDArray  # (Z, 2, 2, 2) [m/rad] shape at each contact by its angle, as another place is displaced
    loaded: NDArray  # (8 Z) whether a displacement is that of a loaded contact

    @classmethod
    def of(cls, grooves: ElasticGrooves, balls: BallsOnArches) -> "ShapeByArms":
        """Build from both grooves and the balls between them."""
        angles, forces, turn = balls.angles, balls.forces.on_races, balls.turn
        by_arms, each = np.zeros((len(turn), 4, 4, 2)), np.arange(4)
        by_arms[:, each, each] = turn.reshape(-1, 4, 2)
        slopes = balls.force_slopes.reshape(-1, 2, 2, 2, 8)
        pressing = np.concatenate([slopes, by_arms.reshape(-1, 2, 2, 1, 8)], axis=-2)
        made, reading, shapes = np.zeros_like(turn), np.zeros_like(turn), []
        for race, groove in enumerate(grooves):
            vectors = (forces[..., race, 0] + 1j * forces[..., race, 1]).ravel()
            shape = groove and shape_of(groove, angles[..., race].ravel(), vectors)
            shapes.append(shape)
            if shape:
                made[:, :, race] = shape.moved.reshape(-1, 2, 2)
                reading[:, :, race] = shape.by_reading.reshape(-1, 2, 2)
        return cls(made, tuple(shapes), pressing, turn, reading, _loaded(balls))

    def after(self, arms: NDArray) -> NDArray:
        """Change of the shape (8 Z, m) [m] by changes of the arms (Z, 8, m) [m]."""
        pressed = self.pressing @ arms[:, None, None]  # (Z, 2, 2, 3, m)
        change = self.reading[..., None] * pressed[..., 2:, :]
        for race, shape in enumerate(self.grooves):
            if shape:
                loaded = pressed[:, :, race].reshape(-1, 3, arms.shape[-1])[shape.loaded]
                made = np.tensordot(shape.by_contact, loaded, axes=((0, 1), (0, 1)))
                change[:, :, race] += made.reshape(len(arms), 2, 2, -1)
        return change.reshape(-1, arms.shape[-1])

    def softness(self, by_grooves: NDArray) -> NDArray:
        """Change of the misfit (8 Z, L) [-] by the L displacements of loaded contacts, less one."""
        loaded = self.loaded.reshape(-1, 8)
        count, most = len(loaded), loaded.sum(1).max()
        first = np.argsort(~loaded, axis=1, kind="stable")[:, :most]  # of the arms of each ball
        chosen = np.take_along_axis(loaded, first, 1)
        arms = np.take_along_axis(by_grooves * ARMS_BY_SHAPE, first[:, None], 2)
        pressed = self.pressing @ arms[:, None, None]  # (Z, 2, 2, 3, most)
        softness = np.zeros((chosen.sum(), count, 2, 2, 2))
        for race, shape in enumerate(self.grooves):
            if shape:
                change = shape.after(pressed[:, :, race].reshape(2 * count, 3, most))
                both = change.reshape(count, 2, most, count, 2, 2).sum(1)
                softness[:, :, :, race] = -both[chosen]
        return softness.reshape(len(softness), 8 * count).T

    def closed(self, softness: NDArray, columns: NDArray) -> NDArray:
        """Changes of the shape (8 Z, m) that make up for columns (8 Z, m) [m].

        The displacement of a contact without load changes only the place where it is read itself.
        """
        found, loaded = columns.copy(), self.loaded
        found[loaded] = np.linalg.solve(np.eye(softness.shape[1]) + softness[loaded], columns[loaded])
        found[~loaded] -= softness[~loaded] @ found[loaded]
        own, turn = found.reshape(-1, 2, found.shape[1]), ARMS_BY_SHAPE.reshape(2, 2, 2) * self.turn
        turned = np.where(loaded[::2, None], 0.0, turn.reshape(-1, 2))  # (1 - reading turned) x = own
        reading = self.reading.reshape(-1, 2)
        angles = (turned[:, None] @ own) / (1 - (turned * reading).sum(1)[:, None, None])
        return (own + reading[..., None] * angles).reshape(found.shape)
