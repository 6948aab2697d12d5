"""Load distribution of a four-point contact ball bearing with elastic rings."""

from dataclasses import dataclass, replace
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves
from quasidynamic.balance.balls.elastic_rings import (
    ElasticRings,
    ElasticRingState,
    RigidRings,
    ring_levers,
)
from quasidynamic.balance.balls.four_contacts import ARMS_BY_SHAPE, BallsOnArches
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
    as_shoulders_close,
    balanced,
    require_held,
    resisted,
    what_balls_share,
)
from quasidynamic.solve.step_length import SolverOutcome

STEPS = 100  # rarely more than ten
HALVINGS = 30
DESCENT = 1e-3  # part of the linear fall of the forces out of balance that a step must bring
FURTHEST = float(np.radians(15.0))  # by which the angle of a contact may turn from rings to softer ones
LEAST_STEP = 2.0**-9  # of the compliance, by which softer rings are tried


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
    Newton's method from the rigid rings; where it finds nothing, or another balance, in which balls have
    climbed along their arcs, by ever softer rings.

    P (5) acts on the face of the inner ring, which moves as a rigid body: axial x, radial y and z [N],
    moments about y and z [N m]; the speed is that of the inner ring, the outer one at rest [rad/s].
    Grooves have two arcs for each ball, those of its diagonals side by side; the
    displacement is that of the face of the inner ring against that of the outer one.
    Raises `ImpossiblePart` when a load is not finite, or a groove does not fit the balls; `NotSolved` when
    nothing holds the ring, or where rings that become as soft as these lose their balance.

    Source
    ------
    Daidie, Chaib and Ghosn (2008), J. Mech. Des. 130, 082601, in the idea that groove centres follow the
    elastic rings; the equations are those of `ball_loads` with the shape of the rings as further unknowns,
    derived here.

    Valid
    -----
    As `ball_loads`; small displacement of the rings. The balance is stable, though there may be others.
    """
    ending = RigidRings.of(bearing, load, speed)
    rigid_rings = ending.of_whole_contacts
    _require_fit(bearing, grooves)
    rigid, count = balanced(rigid_rings)
    stiffness = rigid_rings.usual_stiffness(rigid.balls.forces.loads.max())
    begin = Begin(rigid.place, np.zeros(8 * bearing.balls), rigid.centres, rigid.balls)
    part, step = 0.0, 1.0
    while part < 1.0:
        softer = ElasticRings(rigid_rings, grooves.softened(part + step), stiffness)
        try:
            state, more = _balanced(softer, _at(softer, begin.place, begin.shape, begin.centres))
            _require_near(begin, state)
        except NotSolved as problem:
            step /= 4
            if step < LEAST_STEP:
                raise _too_soft(part) from problem
            continue
        begin, part = Begin(state.place, state.shape, state.centres, state.balls), part + step
        step, count = min(2 * step, 1.0 - part), count + more
    over = ending.contacts.over_shoulders(state.balls)
    if over > 0:
        softer = replace(softer, rigid=ending)
        state, more = as_shoulders_close(ending, over, state, partial(_balanced_from, softer))
        count += more
    return _shared(bearing, softer, state, count)


def _balanced_from(
    rings: ElasticRings, rigid: RigidRings, begin: ElasticRingState
) -> tuple[ElasticRingState, int]:
    """State between elastic rings with other shoulders, from another state."""
    closer = replace(rings, rigid=rigid)
    return _balanced(closer, _at(closer, begin.place, begin.shape, begin.centres))


class Begin(NamedTuple):
    """Where a search begins."""

    place: NDArray  # (5) [m]
    shape: NDArray  # (8 Z) [m]
    centres: NDArray  # (Z, 2) [m]
    balls: BallsOnArches


def _require_near(begin: Begin, state: ElasticRingState) -> None:
    """Raise `NotSolved` where a loaded contact is far along its arc: in another balance."""
    turned = np.abs(state.balls.angles - begin.balls.angles)[state.balls.forces.loads > 0]
    if turned.max(initial=0.0) > FURTHEST:
        raise NotSolved("balls climbed along their arcs", "not unique")


def _too_soft(part: float) -> NotSolved:
    return NotSolved(
        f"between elastic rings the balls lose their balance: it is stable up to {part:.1%} of the "
        "compliance of the rings; are rings, faces and load those of a bearing?",
        SolverOutcome.TOO_SOFT,
    )


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
    """Stable state in which balls, rings and load are in balance, and the number of evaluations.

    Raises `NotSolved` where Newton's method finds none.
    """
    evaluations, previous = 1, np.inf
    for _ in range(STEPS):
        imbalance = rings.imbalance(state)
        if imbalance < TOLERANCE or previous / 2 < imbalance < ROUNDED:
            require_held(state)
            if not rings.is_stable(state):
                raise NotSolved("contacts and rings together snap to another balance", "not unique")
            return state, evaluations
        state, trials = _next_state(rings, state)
        evaluations, previous = evaluations + trials, imbalance
    raise NotSolved(f"{rings.imbalance(state):.1e} of the largest force is out of balance", "iteration limit")


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
