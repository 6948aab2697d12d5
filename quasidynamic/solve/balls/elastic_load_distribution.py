"""Load distribution of a four-point contact ball bearing with elastic rings."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves
from quasidynamic.balance.balls.elastic_rings import (
    ElasticRings,
    ElasticRingState,
    RigidRings,
    ring_levers,
)
from quasidynamic.balance.balls.four_contacts import ARMS_BY_SHAPE
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.motion.ball_slip import INNER, OUTER
from quasidynamic.parts.ball import FourPointBearing
from quasidynamic.solve.balls.balls_on_arches import ball_step, balls_in_balance
from quasidynamic.solve.balls.load_distribution import (
    BALL_SHARE,
    ROUNDED,
    STIFFENING,
    TOLERANCE,
    BallLoads,
    balanced,
    require_held,
    resisted,
    what_balls_share,
)

STEPS = 100  # rarely more than ten from the rigid rings
HALVINGS = 30
DESCENT = 1e-3  # part of the linear fall of the forces out of balance that a step must bring


@dataclass(frozen=True)
class ElasticBallLoads(BallLoads):
    """How the balls share a load between elastic rings."""

    groove_shape: NDArray  # (Z, 2, 2, 2) [m] displacement of each groove, axial to its own side and radial

    @property
    def deflection(self) -> NDArray:
        """By how much opposite groove centres came closer (Z, 2, 2) [m], axial and radial."""
        return self.groove_shape[..., OUTER, :] - self.groove_shape[..., INNER, :]


def elastic_ball_loads(
    bearing: FourPointBearing, load: NDArray, grooves: ElasticGrooves, speed: float = 0.0
) -> ElasticBallLoads:
    r"""Load of every contact under five loads on the inner ring, between elastic rings.

    .. math:: v = v_0 + B a + s,\quad s = C(\alpha) F(v),\quad B^T F(v) = P

    with the places v of the grooves at each ball, the place a of the inner ring, the load P and the forces F
    on the races, of balls that find their own place between them, see `FourContacts`; the compliance C
    follows the contact angles. Without inertia it is a stationary point of the energy of contacts and rings.
    Newton's method from the rigid rings.

    P (5) acts on the face of the inner ring, which moves as a rigid body: axial x, radial y and z [N],
    moments about y and z [N m]; the speed is that of the inner ring, the outer one at rest [rad/s].
    Grooves have two arcs for each ball, those of its diagonals side by side; the
    displacement is that of the face of the inner ring against that of the outer one.
    Raises `ImpossiblePart` when a load is not finite, or a groove does not fit the balls; `NotSolved` when
    nothing holds the ring, no balance is found, or it may not be the only one.

    Source
    ------
    Daidie, Chaib and Ghosn (2008), J. Mech. Des. 130, 082601, in the idea that groove centres follow the
    elastic rings; the equations are those of `ball_loads` with the shape of the rings as further unknowns,
    derived here.

    Valid
    -----
    As `ball_loads`; small displacement of the rings. The balance is a stable one, though there may be others.
    """
    rigid_rings = RigidRings.of(bearing, load, speed)
    _require_fit(bearing, grooves)
    rigid, count = balanced(rigid_rings)
    rings = ElasticRings(rigid_rings, grooves, rigid_rings.usual_stiffness(rigid.balls.forces.loads.max()))
    state, more = _balanced(rings, _at(rings, rigid.place, np.zeros(8 * bearing.balls), rigid.centres))
    lowest = rings.lowest_eigenvalue(state)
    if not lowest > 0:
        raise NotSolved(
            "contacts and rings together do not give way to every force: the balance that was found may be "
            f"one of several; the lowest eigenvalue is {lowest:.2g}; is the compliance that of these rings?",
            "not unique",
        )
    return _shared(bearing, rings, state, count + more)


def elastic_ball_loads_near(
    bearing: FourPointBearing,
    load: NDArray,
    grooves: ElasticGrooves,
    near: ElasticBallLoads,
    speed: float = 0.0,
) -> ElasticBallLoads:
    """`elastic_ball_loads` of a bearing and a load that differ little from those of known ones.

    One step of Newton's method: exact to first order in the difference.

    Raises `NotSolved` where nothing resists some motion of the ring.
    """
    rigid = RigidRings.of(bearing, load, speed)
    rings = ElasticRings(rigid, grooves, rigid.usual_stiffness(near.loads.max()))
    state = _at(rings, near.displacement * ring_levers(bearing), near.groove_shape.ravel(), near.centres)
    carried = rigid.contacts.carried(state.forces)
    place = resisted(carried[:, :5], state.excess - carried[:, 5])
    moved = _moved(rings, state, state.place + place, state.shape + rings.step(state, place))
    return _shared(bearing, rings, moved, 2)


def _require_fit(bearing: FourPointBearing, grooves: ElasticGrooves) -> None:
    for name, groove in zip(grooves._fields, grooves, strict=True):
        if groove is not None and len(groove.compliance) != 2 * bearing.balls:
            raise ImpossiblePart(
                f"the {name} groove has {len(groove.compliance)} contacts, {2 * bearing.balls} are needed"
            )


def _shared(
    bearing: FourPointBearing, rings: ElasticRings, state: ElasticRingState, evaluations: int
) -> ElasticBallLoads:
    each = what_balls_share(bearing, state, rings.stiffness(state))
    return ElasticBallLoads(
        **each,
        imbalance=rings.imbalance(state),
        iterations=evaluations,
        groove_shape=state.shape.reshape(-1, 2, 2, 2),
    )


def _at(
    rings: ElasticRings, place: NDArray, shape: NDArray, near: NDArray, share: float = 0.0
) -> ElasticRingState:
    """Rings at a place and of a shape, the balls in balance but for a share of the largest force."""
    contacts, moved = rings.rigid.contacts, shape.reshape(-1, 2, 2, 2)
    centres, balls = balls_in_balance(contacts, place, moved, near, rings.rigid.largest_load, share)
    return rings.at(place, shape, centres, balls, ball_step(contacts, balls))


def _moved(
    rings: ElasticRings, state: ElasticRingState, place: NDArray, shape: NDArray, share: float = 0.0
) -> ElasticRingState:
    """State at a place and of a shape that are reached from another state."""
    arms = rings.rigid.contacts.arms_by_place @ (place - state.place)
    arms += ARMS_BY_SHAPE * (shape - state.shape).reshape(-1, 8)
    moves = state.moves + (state.balls.following @ arms[..., None])[..., 0]
    return _at(rings, place, shape, state.centres + moves, share)


def _balanced(rings: ElasticRings, state: ElasticRingState) -> tuple[ElasticRingState, int]:
    """State in which balls, rings and load are in balance, and the number of evaluations."""
    evaluations, previous = 1, np.inf
    for _ in range(STEPS):
        imbalance = rings.imbalance(state)
        if imbalance < TOLERANCE or previous / 2 < imbalance < ROUNDED:
            require_held(state)
            return state, evaluations
        state, trials = _next_state(rings, state)
        evaluations, previous = evaluations + trials, imbalance
    raise NotSolved(
        f"the elastic rings found no balance in {evaluations} evaluations: {rings.imbalance(state):.1e} of "
        f"the largest force is left, allowed {ROUNDED:.0e}; loads over the pitch radius {rings.rigid.load} N",
        "iteration limit",
    )


def _next_state(rings: ElasticRings, state: ElasticRingState) -> tuple[ElasticRingState, int]:
    """A step of Newton's method, halved until less is out of balance."""
    place, shape = _newton_step(rings, state)
    size, share = rings.size(state), BALL_SHARE * rings.imbalance(state)
    for halvings in range(HALVINGS):
        part = 0.5**halvings
        trial = _moved(rings, state, state.place + part * place, state.shape + part * shape, share)
        if rings.size(trial) <= (1 - DESCENT * part) * size:
            break
    return trial, halvings + 1


def _newton_step(rings: ElasticRings, state: ElasticRingState) -> tuple[NDArray, NDArray]:
    """Newton's changes of place (5) and shape (4 Z) [m].

    A direction in which hardly anything resists is stiffened as long as forces are out of balance.
    """
    carried = rings.rigid.contacts.carried(state.forces)
    tangent = carried[:, :5]
    stiffer = STIFFENING * min(rings.imbalance(state), 1.0) * max(tangent.trace(), rings.usual_stiffness)
    place = np.linalg.solve(tangent + stiffer * np.eye(5), state.excess - carried[:, 5])
    return place, rings.step(state, place)
