"""From a case to a slow ball bearing, and from its solution to the arrays of a result file."""

from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

import quasidynamic as qd
from flexbearing.build import clearance
from flexbearing.build.ball_fits import ball, groove
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.findings import Judged, declared, evaluate
from flexbearing.life import four_point_lives
from flexbearing.life.life_of_state import MREV
from flexbearing.program.shared_map import shared_map
from flexbearing.progress import Report
from flexbearing.quantities.four_point import LAYOUT
from flexbearing.quantities.quantity import row, taken
from flexbearing.rings import grooves
from flexbearing.runs import elastic_grooves, judged, neglect, probes, shoulders, subsurface
from flexbearing.runs.angular_contact import STICK
from flexbearing.runs.probes import Stresses
from quasidynamic import OutOfRange
from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves
from quasidynamic.balance.balls.four_contacts import SIDE_OF_DIAGONAL
from quasidynamic.four_point import FourPointEquilibrium
from quasidynamic.note import Note, danger, information, outside
from quasidynamic.outcome.oscillation import rolled_way
from quasidynamic.outcome.rating_life import BALLS
from quasidynamic.outcome.worst_point_contact import WorstPointContact
from quasidynamic.solve.balls.elastic_load_distribution import ElasticBallLoads
from quasidynamic.solve.balls.load_distribution import BallLoads

if TYPE_CHECKING:
    from fem.solid.probes import Readings

FEWEST = 3  # balls of a ring; a single one has the same pitch circle
NOTABLE = 0.01  # of the torque: change by another reading of the spin that is reported
SIGN = np.array([1.0, -1.0])  # of the torques on inner and outer ring


@dataclass(frozen=True)
class Solution:
    """A solved case."""

    case: FourPointCase
    balls: qd.SlidingBalls
    distribution: BallLoads | None  # None when contact loads are given
    full_sliding: qd.SlidingBalls | None = None  # before parts of their contacts stick; None where none do
    unrolled: str = ""  # why stick and slip are not known, where the case requires them

    @property
    def worst(self) -> WorstPointContact:
        """The most pressed contact of each raceway."""
        each = self.balls.peak_pressure, self.balls.ellipse.across, self.balls.ellipse.along
        return WorstPointContact.of(*(values.reshape(-1, 2) for values in each))

    @cached_property
    def lives(self) -> four_point_lives.FourPointLives | None:
        """Lives under these loads; None where there is none."""
        return four_point_lives.lives(self.case, self.balls)

    @property
    def bearing(self) -> qd.FourPointBearing:
        """The bearing as it is mounted."""
        return bearing(self.case).bearing

    @property
    def azimuths(self) -> NDArray:
        """Places of the balls (Z) [rad]."""
        return np.array(self.case.azimuths)

    @cached_property
    def probes(self) -> "Readings | str | None":
        """What probes read of elastic rings, or why they read nothing; None without any."""
        if self.case.outputs.probes is None or not isinstance(self.distribution, ElasticBallLoads):
            return None
        from flexbearing.runs import groove_fields  # with finite elements

        return groove_fields.readings(self.case, self.distribution)

    @cached_property
    def stresses(self) -> Stresses | None:
        """Largest stresses of elastic rings, or why there are none; None where the case requires none."""
        if not self.case.outputs.stresses or not isinstance(self.distribution, ElasticBallLoads):
            return None
        from flexbearing.runs import groove_fields  # with finite elements

        return groove_fields.stresses(self.case, self.distribution)

    @property
    def ball_motion(self) -> NDArray:
        """Angular velocities (Z, 3) [rad/s] at the speed of the case, which is right-handed about -x."""
        return -self.balls.sliding.motion * self.case.operation.speed

    @property
    def ball_torque(self) -> NDArray:
        """Torque of each ball on both rings (Z, 2) [N m] by the formula of the case."""
        torques = self.balls.torques
        sliding = torques.total if self.case.friction.torque == "exact" else torques.circumferential
        return sliding + SIGN * self.balls.hysteresis[:, None]

    @property
    def torque(self) -> NDArray:
        """Torque of all balls on both rings (2) [N m]."""
        return self.ball_torque.sum(0)

    @property
    def power_loss(self) -> float:
        """Heat of friction and hysteresis at the speed of the case [W]."""
        return self.balls.torque * self.case.operation.speed

    @property
    def rolling(self) -> qd.RollingBalls | None:
        """Balls whose contacts stick and slip; None in full sliding."""
        return self.balls if isinstance(self.balls, qd.RollingBalls) else None

    @property
    def ball_turn(self) -> NDArray | None:
        """Turn of each ball about the rolling direction (Z) [rad/s] at the speed of the case."""
        return None if self.rolling is None else -self.rolling.turn * self.case.operation.speed

    @property
    def ring_load(self) -> NDArray | None:
        """Load on the inner ring (5) [N, N m]; None when contact loads are given."""
        return None if self.distribution is None else np.array(self.case.operation.load.values)

    @property
    def ring_deflection(self) -> NDArray | None:
        """Approach of opposite groove centres by elastic rings (Z, G, 2) [m]; None between rigid ones."""
        if not isinstance(self.distribution, ElasticBallLoads):
            return None
        return self.distribution.deflection[..., ::-1] * np.stack([[1, 1], SIDE_OF_DIAGONAL], axis=1)


def bearing(case: FourPointCase) -> qd.FourPointBallBearing:
    """The bearing of a case; raises `BadCase` when one of its rings cannot be."""
    parts, materials = case.bearing, case.materials
    grooves.parts(case)
    if case.outputs.probes:
        from flexbearing.build import groove_parts
        from flexbearing.build.probes import require_probes

        require_probes(case, groove_parts.groove_part, groove_parts.why_no_solid)
    angle, free_way = _mounted(case)
    return qd.FourPointBallBearing(
        bearing=qd.FourPointBearing(
            ball=ball(parts, materials.ball),
            inner=groove(parts, "inner", materials.ring("inner")),
            outer=groove(parts, "outer", materials.ring("outer")),
            balls=parts.balls or FEWEST,
            pitch_diameter=parts.pitch_diameter,
            contact_angle=angle,
            clearance=free_way,
            groove_ends=(_groove_end(case, "inner"), _groove_end(case, "outer")),
            outer_arches=parts.outer_arches,
            first_ball_azimuth=parts.first_ball_azimuth,
        ),
        friction=_friction(case),
        hysteresis_loss=case.friction.hysteresis_loss,
        spin=case.friction.spin,
        contact_pressure=case.friction.contact_pressure,
        interface_compliance=case.friction.interface_compliance or 0.0,
    )


def _mounted(case: FourPointCase) -> tuple[float, float]:
    """Contact angle without load [rad] and free way along a diagonal [m], after mounting.

    Fits move opposite groove centres towards or from each other radially.
    """
    own = case.bearing
    if own.fits is None:
        return own.contact_angle, own.clearance
    axial = (own.centre_distance - own.clearance) * np.sin(own.contact_angle)
    radial = own.centre_distance - clearance.operating(case) / 2
    return float(np.arctan2(axial, radial)), float(own.centre_distance - np.hypot(axial, radial))


def _groove_end(case: FourPointCase, name: str) -> float:
    """Contact angle of the shoulder of a ring [rad], infinite where none is given."""
    ring, shoulder = getattr(case.rings, name), getattr(case.bearing, name).shoulder
    if ring.kind != "rigid":
        return ring.groove_end
    return np.inf if shoulder is None else case.arches(name).end_at(shoulder)


def _friction(case: FourPointCase) -> qd.FrictionCurve:
    friction = case.friction
    if friction.coefficient is not None:
        return qd.constant_friction(friction.coefficient)
    assert friction.pressures is not None  # checked on reading
    assert friction.coefficients is not None
    return qd.FrictionCurve(pressures=friction.pressures, coefficients=friction.coefficients)


def solved(
    case: FourPointCase,
    rings: ElasticGrooves | None = None,
    progress: Callable[[float], None] = lambda _: None,
    near: Solution | None = None,
    start: BallLoads | None = None,
) -> Solution:
    """Loads and motion of the balls between rigid rings, or between elastic ones.

    The part of the balls whose stick and slip is found goes to `progress`. From a solution in full sliding
    that is `near`, one step of Newton's method is made, which is exact to first order. The search for the
    loads begins at a `start`, where there is one, and from rigid rings between elastic ones.
    """
    model = bearing(case)
    motion = None if near is None else near.balls.sliding.motion
    if case.operation.mode == "ring_load":
        load = case.operation.load
        known = FourPointEquilibrium(near.distribution, near.balls) if near and near.distribution else None
        equilibrium = model.solve(
            qd.RingLoad(
                axial=load.axial,
                radial_y=load.radial_y,
                radial_z=load.radial_z,
                moment_y=load.moment_y,
                moment_z=load.moment_z,
            ),
            rings,
            known,
            case.operation.speed,
            start,
        )
        return _rolled(case, model, (equilibrium.balls, equilibrium.distribution), progress)
    loads = np.array(case.operation.contact_loads)
    shape = (case.balls, len(loads), 2)
    angle = np.full(shape, _mounted(case)[0])
    return _rolled(
        case, model, (model.slide(angle, np.broadcast_to(loads[:, None], shape), motion), None), progress
    )


@dataclass
class Known:
    """What cases leave to those after them: elastic rings, and loads between rigid ones."""

    rings: dict[Any, ElasticGrooves | None] = field(default_factory=dict)  # by what decides them
    loads: BallLoads | None = None  # where a search begins


def blocks(
    case: FourPointCase, report: Report, *, rigid: bool = True, known: Known | None = None
) -> Iterator[tuple[Literal["rigid", "flexible"], Solution]]:
    """Yield the solution between rigid rings, then that between elastic ones where the case has them.

    Beside elastic rings rigid ones may be left out. What is `known` of other cases is added to.
    """
    progress, shared = partial(report.stage, STICK), Known() if known is None else known
    if rigid or case.rigid:
        report.stage("slow balls between rigid rings", None)
        near = shared.loads if shared.loads and len(shared.loads.loads) == case.balls else None
        found = solved(case, progress=progress, start=near)
        shared.loads = found.distribution
        yield "rigid", found
    if not case.rigid:
        key = grooves.parts(case), case.balls
        if key not in shared.rings:
            shared.rings[key] = elastic_rings(case, report)
        report.stage("slow balls between elastic rings", None)
        flexible = solved(case, shared.rings[key], progress)
        if case.outputs.probes or case.outputs.stresses:
            report.stage(probes.STAGE, None)
        yield "flexible", flexible


def elastic_rings(case: FourPointCase, report: Report) -> ElasticGrooves | None:
    """Elastic rings of a case under its balls; None between rigid ones.

    Raises `NotSolved` where they are not found.
    """
    return grooves.elastic_grooves(case, np.array(case.azimuths), report)


def _rolled(
    case: FourPointCase,
    model: qd.FourPointBallBearing,
    sliding: tuple[qd.SlidingBalls, BallLoads | None],
    progress: Callable[[float], None],
) -> Solution:
    """Solution with the friction of the case, from full sliding."""
    balls, distribution = sliding
    if case.friction.model == "full_sliding":
        return Solution(case, balls, distribution)
    along, across = case.friction.cells
    try:
        with shared_map() as mapped:
            rolled = model.roll(balls, case.friction.model, (along, across), progress, mapped)
    except OutOfRange as why:
        return Solution(case, balls, distribution, unrolled=str(why))
    return Solution(case, rolled, distribution, balls)


def block(solution: Solution, names: Collection[str] | None = None) -> dict[str, NDArray]:
    """Quantities of the solution, all or some by name; what no one needs is not computed."""
    parts: dict[str, Callable[[], Any]] = {
        "worst": lambda: solution.worst,
        "subsurface": lambda: subsurface.of_balls(solution.case, solution.worst),
        "solution": lambda: solution,
        "balls": lambda: solution.balls,
        "ring": lambda: solution.distribution,
        "life": lambda: solution.lives,
        "probes": lambda: None if isinstance(solution.probes, str) else solution.probes,
        "rolling": lambda: solution.rolling,
        "fields": lambda: _fields(solution.case, solution.balls),
    }
    wanted = [each for each in LAYOUT.quantities if names is None or each.name in names]
    needed = {str(each.path[0]) for each in wanted}
    return row(taken(wanted, {name: [part()] for name, part in parts.items() if name in needed}), 0)


def _fields(case: FourPointCase, balls: qd.SlidingBalls) -> dict[str, NDArray | None]:
    """Pressure, slip, shear and stick over every contact of the chosen balls."""
    chosen = case.fields.balls or (int(balls.load.sum((1, 2)).argmax()),)
    diagonals, points, speed = balls.load.shape[1], case.fields.points, case.operation.speed
    scales = {"x": 1.0, "y": 1.0, "slip_along": speed, "slip_across": speed}
    scales |= dict.fromkeys(("shear_along", "shear_across", "pressure", "stick"), 1.0)
    shape = case.friction.cells[::-1] if isinstance(balls, qd.RollingBalls) else (points, points)
    fields = {name: np.zeros((len(chosen), diagonals, 2, *shape)) for name in scales}
    for place in np.ndindex(len(chosen), diagonals, 2):
        contact = (chosen[place[0]], place[1], place[2])
        if balls.load[contact] > 0 and balls.sliding.driven[contact[0]]:
            field = balls.field(*contact, points)
            for name, scale in scales.items():
                fields[name][place] = scale * field[name]
    return {"balls": np.array(chosen), **fields}


def _heights(solution: Solution) -> dict[str, float]:
    """How high contacts reach over the ball diameter, on rigid races whose end is not given."""
    case, balls = solution.case, solution.balls
    arches = {race: case.arches(name) for race, name in enumerate(("inner", "outer"))}
    open_races = [race for race, name in enumerate(("inner", "outer")) if np.isinf(_groove_end(case, name))]
    return {
        judged.RACES[race]: balls.needed_shoulders(race, arches[race].radius, arches[race].aside).max()
        / case.bearing.ball.diameter
        for race in open_races
    }


def _fatigue(solution: Solution) -> dict[str, object]:
    """Lives with the load and the way that they belong to."""
    lives, balls = solution.lives, solution.balls
    if lives is None:
        return {}
    values: dict[str, object] = {
        "load": {"by the loads of the balls": lives.equivalent},
        "dynamic_rating": lives.rating,
        **judged.lives(lives.longest / MREV, lives.relative_speed, [solution.case.life.required]),
    }
    if lives.oscillation is not None:
        ratio = four_point_lives.row(solution.case).diameter_ratio
        way = rolled_way(lives.oscillation, solution.case.bearing.pitch_diameter, ratio)
        values["rolled_widths"] = way / (2 * balls.ellipse.along.max())
    return values


def judge(solution: Solution, *, in_row: bool = False) -> tuple[Judged, ...]:
    """The solution against the limits of ball bearings; `in_row`: where only dangers are reported."""
    largest = solution.balls.peak_pressure.max(axis=(0, 1))
    neglected = neglect.danger_of_slow_balls if in_row else neglect.of_slow_balls
    values = {
        **judged.pressures(largest, BALLS),
        **neglected(solution),
        **neglect.friction_of_moments(solution),
        "contact_height": _heights(solution),
        **_fatigue(solution),
    }
    if solution.distribution is not None:
        values["least_stiffness"] = judged.least_stiffness(solution.distribution.stiffness[None, 1:3, 1:3])
    values |= probes.values(solution.case, solution.stresses)
    return evaluate(declared.OF_SLOW_BALLS, values)


def notes(solution: Solution, found: Iterable[Judged], *, in_row: bool = False) -> tuple[Note, ...]:
    """What a user must know of the solution, judged by findings before; rows do not report the torque."""
    case, balls = solution.case, solution.balls
    lines = (*judged.notes(found), *balls.notes, *shoulders.unusual(case.materials), *clearance.notes(case))
    lines += four_point_lives.notes(case)
    if solution.distribution is None:
        lines += (
            information(
                "given-loads",
                "contact loads are given: every ball carries them, at the contact angle without load",
            ),
        )
    if solution.ring_deflection is not None:
        contacts = balls.contacts.angle, balls.load, balls.ellipse.across
        lines += elastic_grooves.notes(case, *(np.moveaxis(each, -1, 0) for each in contacts))
    lines += _on_shoulders(case, balls) + shoulders.unrolled(solution.unrolled)
    lines += subsurface.notes(case, solution.worst) + probes.notes(solution.probes, solution.stresses)
    idle = int((~balls.driven).sum())
    if idle:
        words = f"{idle} of {len(balls.load)} balls are not pressed on both rings: they make no torque"
        lines += (information("idle-balls", words),)
    if in_row:
        return lines
    lines += _local_spin(balls) if solution.rolling is None else _stick(solution, solution.rolling)
    if case.friction.torque == "circumferential":
        share = 100 * (balls.torques.circumferential.sum(0) / balls.torques.total.sum(0) - 1)
        lines += (
            information(
                "torque-formula",
                "torque: the circumferential formula leaves out the moment of lateral slip: "
                f"{share[0]:+.2f} % at the inner and {share[1]:+.2f} % at the outer ring against the exact "
                "one",
            ),
        )
    return lines


def _stick(solution: Solution, balls: qd.RollingBalls) -> tuple[Note, ...]:
    """What stick makes of the torque, and how exact it is."""
    assert solution.full_sliding is not None  # of balls that stick and slip
    friction, sliding = solution.case.friction, solution.full_sliding.torque
    share = balls.torque / sliding - 1
    (along, across), computed = friction.cells, friction.contact_pressure != "hertz"
    same = "the same spin" + (" and the pressure of Hertz" if computed else "")
    lines = (
        information(
            "stick-and-slip",
            f"torque: {friction.model} on {along} by {across} cells a contact, within "
            f"{balls.grid_error.sum():.2g} N m of finer ones; {100 * share:+.1f} % against full sliding with "
            f"{same}, of {sliding:.5g} N m"
            f"{shoulders.by_springs(friction.model, balls.stick_share)}",
            {"friction.spin": friction.spin},
        ),
    )
    lines += (*shoulders.compliant(friction.interface_compliance),)
    return lines + (_computed(friction.contact_pressure, balls) if computed else ())


def _computed(pressure: str, balls: qd.RollingBalls) -> tuple[Note, ...]:
    """What a computed pressure is, and which contacts shoulders cut."""
    lines = (
        information(
            "computed-pressure",
            "contact pressure: computed on the true arcs; loads, contact angles, the coefficient of friction "
            "and the hysteresis are those of ellipses",
            {"friction.contact_pressure": pressure},
        ),
    )
    if not balls.cut.any():
        return lines
    peak = balls.peak_pressure[balls.cut].max() / 1e6
    inner, outer = (int(number) for number in balls.cut.sum((0, 1)))
    return (
        *lines,
        outside(
            "cut-contact",
            f"shoulders cut {inner} contacts of the inner and {outer} of the outer ring: their pressure, of "
            f"up to {peak:,.0f} MPa on the cells, is computed with that end, "
            "as if the edge were as stiff as the middle",
        ),
    )


def _local_spin(balls: qd.SlidingBalls) -> tuple[Note, ...]:
    """How much torque the spin of the centre leaves out."""
    if balls.ellipse.spin == "local" or not balls.torque:
        return ()
    change = balls.torque_with("local") / balls.torque - 1
    if abs(change) < NOTABLE:
        return ()
    return (
        information(
            "spin-of-centre",
            "torque: with the local spin of each point of the contacts instead of that of their centres it "
            f"would be {100 * change:+.1f} %",
            {"friction.spin": "local"},
        ),
    )


def _on_shoulders(case: FourPointCase, balls: qd.SlidingBalls) -> tuple[Note, ...]:
    """Contacts that reach over the arches of their rings."""
    lines: tuple[Note, ...] = ()
    for race, name in enumerate(("inner", "outer")):
        if case.friction.contact_pressure != "hertz" and np.isfinite(_groove_end(case, name)):
            continue  # the pressure ends there, see `_computed`
        ring, arches, diameter = getattr(case.rings, name), case.arches(name), case.bearing.ball.diameter
        known = case.operation.contact_loads is None  # given loads follow from no approach
        least = float(balls.carried_shares[..., race].min()) if known else np.nan
        if ring.kind == "rigid":
            heights = balls.needed_shoulders(race, arches.radius, arches.aside)
            angles, shoulder = balls.contacts.angle[..., race], getattr(case.bearing, name).shoulder
            lines += shoulders.reached_over(name, heights, angles, diameter, shoulder, least)
            continue
        over = int(balls.truncated(race, arches.radius, ring.groove_end).sum())
        if over:
            lines += (
                danger(
                    "truncated-contact",
                    f"{over} contacts of the {name} ring are cut off on its shoulders at "
                    f"{np.degrees(ring.groove_end):.1f} deg; {shoulders.carrying(least)}",
                ),
            )
    return lines
