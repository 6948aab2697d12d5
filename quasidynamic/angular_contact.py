"""The angular-contact ball bearing at speed."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Literal, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.angular_contact import AngularBalance, lubricated_races, race_contacts
from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves
from quasidynamic.balance.balls.ending_races import CutContacts, EndingRaces
from quasidynamic.balance.balls.race_control import PrescribedControl, RaceControl
from quasidynamic.balance.balls.rolling_ball import rolling_ball
from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.ellipse.point_contact import PointContact
from quasidynamic.contact.ellipse.rigid_slip import Spin
from quasidynamic.contact.half_space import ElasticPair, elastic_pair
from quasidynamic.contact.lubrication import BallLubrication
from quasidynamic.errors import ImpossiblePart, NotSolved, OutOfRange, require_positive
from quasidynamic.motion.ball_slip import BallContacts, steepest
from quasidynamic.motion.ball_speeds import Control
from quasidynamic.outcome.angular_contact_state import AngularContactState
from quasidynamic.outcome.fast_balls import FastRollingBalls
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing, RingOperation
from quasidynamic.parts.ball_cage import BallCage
from quasidynamic.solve.balls.cage_speed import motions_by_cage_speed
from quasidynamic.solve.balls.coulomb_control import CoulombControl, StickingContacts
from quasidynamic.solve.balls.refined_rolling import RefinedRolling, RollingModel, refined_kept_motion
from quasidynamic.solve.balls.ring_in_elastic_grooves import iterate_elastic, solve_elastic
from quasidynamic.solve.balls.ring_newton import SINGULAR, RingSolution
from quasidynamic.solve.balls.ring_on_balls import solve
from quasidynamic.solve.step_length import SolverOutcome

DIRECTIONS = ("along x", "along y", "along z", "about y", "about z")
BORNE = 0.05  # of a load: within which the part is known that shoulders bear
DIFFERENT = 1e-3  # of the speed of the rings: difference of the speeds of a cage in two motions
LEAST_SHARE = 1e-3  # of a motion without a force: component that is reported


@dataclass(frozen=True, kw_only=True)
class AngularContactBallBearing:
    """An angular-contact ball bearing between rigid rings, or between grooves that give way.

    What balls do follows from an assumption on which race controls their spin, or from the friction of their
    contacts: of dry ones with control "coulomb", of lubricated ones with "oil".

    >>> from quasidynamic.parts.ball import Ball, Groove
    >>> from quasidynamic.parts.material import Material
    >>> steel = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7800)
    >>> groove = Groove(conformity=11.63 / 22.23, material=steel)
    >>> ball = Ball(diameter=22.23e-3, material=steel)
    >>> bearing = AngularContactBearing(
    ...     ball=ball, inner=groove, outer=groove, balls=16, pitch_diameter=125.26e-3,
    ...     contact_angle=np.radians(40.0))
    >>> state = AngularContactBallBearing(bearing=bearing).solve(
    ...     RingOperation(load=(17800.0, 0.0, 0.0, 0.0, 0.0), inner_speed=10000 * np.pi / 30))
    >>> [round(float(angle), 1) for angle in np.degrees(state.contact_angles[:, 0])]
    [50.0, 31.3]
    """

    bearing: AngularContactBearing
    control: Literal["outer", "inner", "equal", "coulomb", "oil"] = "outer"  # the last two: friction decides
    friction: float | None = None  # [-] Coulomb coefficient of the contacts; no torque of friction without it
    spin: Spin = "centre"  # that makes slip across in contacts: of their middle as Jones, or of each point
    sticking: tuple[int, int] | None = None  # cells over each contact, for FASTSIM in the balance of friction
    interface_compliance: float = 0.0  # [m] elastic slip of an interface at mu p; assumed, none by theory
    lubrication: BallLubrication | None = None  # laws of the oil, with control "oil"
    cage: BallCage | None = None  # of balls in oil; without it nothing carries those that races do not press

    def __post_init__(self):
        if (self.control == "oil") != (self.lubrication is not None):
            raise ImpossiblePart(
                f'control = "{self.control}" with lubrication = {self.lubrication}: control = "oil" needs '
                "it, no other has any"
            )
        if self.cage is not None and self.control != "oil":
            raise ImpossiblePart(
                f'cage with control = "{self.control}": pockets push balls with control = "oil" alone'
            )
        if self.control == "coulomb" and self.friction is None:
            raise ImpossiblePart(
                'control = "coulomb" with friction = None: it needs a coefficient of friction'
            )
        if self.friction is not None:
            require_positive("friction", self.friction)
        if self.sticking is not None and self.control != "coulomb":
            raise ImpossiblePart(
                f'sticking = {self.sticking} with control = "{self.control}": contacts stick in the balance '
                'of control = "coulomb" alone'
            )
        if not 0.0 <= self.interface_compliance < np.inf:
            raise ImpossiblePart(
                f"interface_compliance = {self.interface_compliance!r} m must be finite, >= 0"
            )

    def solve(self, operation: RingOperation, grooves: ElasticGrooves | None = None) -> AngularContactState:
        """Balance of ring and balls, and of elastic grooves.

        Raises `NotSolved` with the outcome: nothing holds the ring, or no balance found.
        """
        state = self.solve_many([operation], grooves)[0]
        if isinstance(state, NotSolved):
            raise state
        return state

    def solve_many(
        self, operations: Sequence[RingOperation], grooves: ElasticGrooves | None = None
    ) -> list[AngularContactState | NotSolved]:
        """Balance at several operating points side by side; an error takes its place."""
        balance = self.equations(operations)
        if grooves is None:
            states = self.states(operations, balance, solve(balance))
        else:
            solution = solve_elastic(balance, grooves)
            states = self.states(operations, balance, solution.rings, solution.moved)
        return [self._named(each, at, grooves) for each, at in zip(states, operations, strict=True)]

    def _named(
        self, state: AngularContactState | NotSolved, operation: RingOperation, grooves: ElasticGrooves | None
    ) -> AngularContactState | NotSolved:
        """A state; an end on shoulders with the part of the load that they bear."""
        if isinstance(state, AngularContactState) or state.outcome is not SolverOutcome.OVER_SHOULDER:
            return state
        least, most = 0.0, 1.0
        while any(operation.load) and most - least > BORNE:
            part = (least + most) / 2
            balance = self.equations([replace(operation, load=tuple(part * each for each in operation.load))])
            rings = solve(balance) if grooves is None else solve_elastic(balance, grooves).rings
            borne = rings.outcomes[0] is SolverOutcome.CONVERGED
            least, most = (part, most) if borne else (least, part)
        borne = f"; they bear {least:.0%} to {most:.0%} of this load" if any(operation.load) else ""
        return NotSolved(f"{state}{borne}", state.outcome)

    def other_motions(self, state: AngularContactState) -> tuple[AngularContactState, ...]:
        """Stable steady motions of the same operation with other speeds of the cage, between rigid rings.

        A ring that is held under balls in a cage may have several, see `motions_by_cage_speed`; any other
        bearing has none here.
        """
        operation, control, oil = state.operation, self._race_control, state.oil
        caged = isinstance(control, CoulombControl) and control.in_one_cage
        if not caged or oil is None or operation.inner_speed == operation.outer_speed:
            return ()
        balance, others = self.equations([operation]), list[AngularContactState]()
        for solution in motions_by_cage_speed(balance, solve):
            (other,) = self.states([operation], balance, solution)
            if isinstance(other, NotSolved) or other.oil is None:
                continue
            apart = abs(other.oil.cage_speed[0] - oil.cage_speed[0])
            if apart > DIFFERENT * abs(operation.inner_speed - operation.outer_speed):
                others.append(other)
        return tuple(others)

    def iterate(
        self, operation: RingOperation, grooves: ElasticGrooves
    ) -> Iterator[tuple[AngularContactState, bool]]:
        """Newton iterates between elastic grooves, and whether they are in balance, as the last one is.

        Raises `NotSolved` as `solve`.
        """
        balance = self.equations([operation])
        for solution, last in iterate_elastic(balance, grooves):
            (state,) = self.states([operation], balance, solution.rings, solution.moved)
            if not isinstance(state, NotSolved):  # a place on the way may have no friction that is known
                yield state, last
            elif last:
                raise cast(NotSolved, self._named(state, operation, grooves))

    def states(
        self,
        operations: Sequence[RingOperation],
        balance: AngularBalance,
        solution: RingSolution,
        groove_displacements: NDArray | None = None,
    ) -> list[AngularContactState | NotSolved]:
        """What bearings do at operating points whose `equations` are solved; an error takes its place.

        Displacements of grooves (C, 2, Z, 2) [m] are None between rigid rings.
        """
        balls, ring = solution.forces(balance)
        kinematics, scale, control, heat = balls.kinematics, self._scale, self._race_control, None
        oiled, found = None, SolverOutcome.CONVERGED in solution.outcomes
        if found and isinstance(control, CoulombControl):  # lost balls have no friction
            given = balls.contacts, balance.speeds, balance.free_centrifugal
            oiled = None if control.oil is None else control.oiled(*given, kinematics.near)
            heat = control.heat(*given) if oiled is None else oiled.heat
        known = np.isfinite(kinematics.orbit if heat is None else kinematics.orbit + heat)
        solution = _of_known_motions(solution, known)
        states: list[AngularContactState | NotSolved] = []
        for case, operation in enumerate(operations):
            if solution.outcomes[case] is not SolverOutcome.CONVERGED:
                loose = _loose(ring.stiffness[case], balance.held[case])
                pressed = balls.contacts.loads if balls.cut is None else balls.cut.whole
                angle = steepest(balls.contacts.angles[:, case], pressed[:, case])
                lost = int((np.isfinite(balls.contacts.loads[:, case]).all(0) & ~known[case]).sum())
                states.append(_not_solved(operation, solution, case, loose, angle, lost))
                continue
            if self._too_wide(balls.contacts.loads[:, case]):
                states.append(
                    NotSolved(
                        f"load {operation.load}: contact ellipses would be nearly as wide as the ball and "
                        "have no friction that is known; the load is far too high",
                        SolverOutcome.OUT_OF_RANGE,
                    )
                )
                continue
            states.append(
                AngularContactState(
                    bearing=self.bearing,
                    operation=operation,
                    ring_displacement=solution.ring[case] / scale,
                    ring_load=ring.carried[case] * scale,
                    stiffness=ring.stiffness[case] * np.outer(scale, scale),
                    contact_angles=balls.contacts.angles[:, case],
                    loads=balls.contacts.loads[:, case],
                    tractions=kinematics.tractions[:, case],
                    orbital_speed=kinematics.orbit[case],
                    ball_speed=kinematics.spin[case],
                    attitude=kinematics.attitude[case],
                    yaw=kinematics.yaw[case],
                    centrifugal_force=kinematics.centrifugal[case],
                    gyroscopic_moment=kinematics.gyroscopic[case],
                    evaluations=int(solution.evaluations[case]),
                    friction=self.friction,
                    spin=self.spin,
                    sliding_heat=None if heat is None else heat[case],
                    oil=oiled and oiled.of_case(case),
                    sticking=self.sticking is not None,
                    imbalance=float(solution.imbalance[case]),
                    groove_displacement=None if groove_displacements is None else groove_displacements[case],
                    **_cut_off(balls.cut, solution.whole_ring, case, scale),
                )
            )
        return states

    def roll(
        self,
        state: AngularContactState,
        model: RollingModel,
        cells: tuple[int, int] = (40, 80),
        progress: Callable[[float], None] = lambda _: None,
        mapped: Callable[..., Iterable[RefinedRolling]] = map,
    ) -> FastRollingBalls:
        """Friction of contacts that stick and slip, loads and motion of the balance kept.

        With `sticking`, and FASTSIM on the same cells here, this is the friction of the balance itself.

        `cells` are those over each contact, along and across the rolling direction; `progress` takes the part
        of the balls that are solved, and `mapped` calls a function for each ball as `map` does, such as on
        several cores.
        Raises `OutOfRange` when friction is not known: no coefficient, or a contact as wide as the ball, see
        also `refined_kept_motion`; `NotSolved` when a contact is not solved.
        """
        if state.friction_heat is None:
            raise OutOfRange(
                "stick and slip: no coefficient of friction is given, or a contact is as wide as the surface "
                "it presses"
            )
        touching = _touching(state)
        refined = mapped(
            partial(_refined, self._pairs, self.interface_compliance, model, cells), list(touching.values())
        )
        rolled: list[RefinedRolling | None] = [None] * state.loads.shape[1]
        for done, (number, one) in enumerate(zip(touching, refined, strict=True), start=1):
            rolled[number] = one
            progress(done / len(touching))
        return FastRollingBalls(state, tuple(rolled))

    @cached_property
    def _pairs(self) -> tuple[ElasticPair, ElasticPair]:
        ball, inner, outer = self.bearing.ball, self.bearing.inner, self.bearing.outer
        return elastic_pair(ball.material, inner.material), elastic_pair(ball.material, outer.material)

    @cached_property
    def _contacts(self) -> tuple[PointContact, PointContact]:
        return race_contacts(self.bearing)

    @cached_property
    def _race_control(self) -> RaceControl:
        if self.lubrication is not None:
            races = lubricated_races(self.bearing, self._contacts, self.lubrication)
            return CoulombControl(self.bearing, self._contacts, 1.0, self.spin, oil=races, cage=self.cage)
        if self.control == "coulomb":
            friction, stick = cast(float, self.friction), None
            if self.sticking is not None:
                stick = StickingContacts(self._pairs, self.sticking, self.interface_compliance)
            return CoulombControl(self.bearing, self._contacts, friction, self.spin, stick)
        return PrescribedControl(self.bearing, cast(Control, self.control))

    def _too_wide(self, loads: NDArray) -> bool:
        """Whether friction is asked of contacts (2, Z) nearly as wide as the ball."""
        if not isinstance(self._race_control, CoulombControl):
            return False
        pairs = zip(self._contacts, loads, strict=True)
        return max(contact.semi_axes(load)[0].max() for contact, load in pairs) > self._race_control.widest

    @property
    def _scale(self) -> NDArray:
        """Lever that makes rotations lengths and moments forces (5)."""
        radius = self.bearing.inner_groove_radius
        return np.array([1.0, 1.0, 1.0, radius, radius])

    def equations(self, operations: Sequence[RingOperation]) -> AngularBalance:
        """Balance of ring and balls at operating points."""
        displacements = [operation.displacement for operation in operations]
        held = np.array([[value is not None for value in values] for values in displacements])
        place = np.array([[value or 0.0 for value in values] for values in displacements])
        speeds = np.array([[operation.inner_speed, operation.outer_speed] for operation in operations])
        return AngularBalance(
            bearing=self.bearing,
            contacts=self._contacts,
            control=self._race_control,
            load=np.array([operation.load for operation in operations]) / self._scale,
            held=held,
            place=place * self._scale,
            speeds=speeds.T[..., None],
            races=EndingRaces.of(self.bearing, self._contacts),
        )


class _Ball(NamedTuple):
    """One ball that touches both races, for itself."""

    contacts: BallContacts  # (1, 1, 2)
    ellipse: Ellipse
    load: NDArray
    motion: NDArray  # (4)


def _touching(state: AngularContactState) -> dict[int, _Ball]:
    """Balls that touch both races between rings that turn against each other, by their number."""
    if state.operation.inner_speed == state.operation.outer_speed:
        return {}
    balls = np.flatnonzero((state.loads > 0).all(0))
    motions, (contacts, ellipse), loads = state.motion(balls), state.touching(balls), state.loads[:, balls].T
    places = [np.array([place]) for place in range(len(balls))]
    return {
        int(balls[one[0]]): _Ball(contacts.taken(one), ellipse.taken(one), loads[one, None], motions[one[0]])
        for one in places
    }


def _refined(
    pairs: tuple[ElasticPair, ElasticPair],
    interface: float,
    model: RollingModel,
    cells: tuple[int, int],
    ball: _Ball,
) -> RefinedRolling:
    ball_on = partial(rolling_ball, ball.contacts, ball.ellipse, ball.load, pairs)
    return refined_kept_motion(
        lambda cells: ball_on(cells).with_interface(interface), model, cells, ball.motion
    )


def _loose(stiffness: NDArray, held: NDArray) -> list[str]:
    """Directions in which a free ring moves without a force."""
    free = np.flatnonzero(~held)
    _, sizes, moves = np.linalg.svd(np.nan_to_num(stiffness[np.ix_(free, free)]))
    loose = sizes <= SINGULAR * sizes.max(initial=0.0)
    shares = np.linalg.norm(moves[loose], axis=0)
    return [DIRECTIONS[free[place]] for place in np.flatnonzero(shares > LEAST_SHARE)]


def _cut_off(
    cut: CutContacts | None, whole_ring: NDArray | None, case: int, scale: NDArray
) -> dict[str, NDArray]:
    """What a state has beyond those of whole contacts; nothing where all are whole."""
    if cut is None or (cut.loads[:, case] == cut.whole[:, case]).all():
        return {}
    fields = {"whole_loads": cut.whole[:, case], "shoulder_forces": cut.aside[:, case]}
    return fields if whole_ring is None else fields | {"whole_displacement": whole_ring[case] / scale}


def _of_known_motions(solution: RingSolution, known: NDArray) -> RingSolution:
    """The solution, of which a case (C) in balance counts where the motion of every ball (C, Z) is known."""
    outcomes = [
        SolverOutcome.NOT_FINITE if outcome is SolverOutcome.CONVERGED and not known[case].all() else outcome
        for case, outcome in enumerate(solution.outcomes)
    ]
    return replace(solution, outcomes=outcomes)


def _not_solved(
    operation: RingOperation, solution: RingSolution, case: int, loose: list[str], angle: float, lost: int
) -> NotSolved:
    outcome, evaluations = solution.outcomes[case], solution.evaluations[case]
    where = f"load {operation.load}, inner ring {operation.inner_speed * 30 / np.pi:.5g} rpm"
    if outcome is SolverOutcome.UNDETERMINED:
        on_one_ball = loose in (["along y"], ["along z"])  # which lies in the direction of the load
        advice = "give an axial load, or displacements there"
        if on_one_ball:
            advice += ", or another azimuth of the balls, of which one carries all"
        elif operation.load[0]:
            advice = (
                "contact angles near 90 degrees carry no radial load: give a smaller bearing.contact_angle "
            )
            advice += "or bearing.clearance, or displacements there"
        return NotSolved(
            f"{where}: nothing holds the inner ring {', '.join(loose) or 'in any direction'}, its place is "
            f"undetermined; {advice}",
            outcome,
        )
    if outcome is SolverOutcome.TOO_SOFT:
        return NotSolved(
            f"{where}: no balance of ring and balls between these elastic grooves in {evaluations} "
            "evaluations by Newton's method and from stiffer grooves; between the softest that have one, "
            f"contact angles reach {np.degrees(angle):.1f} deg: where that is beyond the shoulders, balls "
            "climb over them as the rings give way, and there is no balance; give a smaller axial load or "
            "tilt, or stiffer rings",
            outcome,
        )
    if outcome is SolverOutcome.OVER_SHOULDER:
        return NotSolved(
            f"{where}: balls climb over the shoulders, which cut contacts off: whole ones would be in "
            f"balance, at contact angles of up to {np.degrees(angle):.1f} deg; no balance found as "
            f"shoulders close in on them, in {evaluations} evaluations; give a smaller axial load or "
            "tilt, or higher shoulders",
            outcome,
        )
    if lost:
        return NotSolved(
            f"{where}: no motion of {lost} balls found in which friction balances what else acts on them, in "
            f"{evaluations} evaluations of ring and balls; a heavier load or an axial displacement as "
            'preload would press them, and control = "outer" needs no friction',
            outcome,
        )
    if outcome is SolverOutcome.NOT_FINITE:
        return NotSolved(
            f"{where}: forces on ring and balls are not finite, as from a wrong unit of load, speed or size",
            outcome,
        )
    return NotSolved(
        f"{where}: no balance of ring and balls in {evaluations} evaluations by Newton's method and the "
        f"searches that follow it; {solution.imbalance[case]:.1e} of the largest force is left by the first; "
        "a heavier load or an axial displacement as preload would press the balls",
        outcome,
    )
