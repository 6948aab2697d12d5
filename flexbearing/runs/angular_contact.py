"""From a case to a bearing with fast balls, and from its solution to the arrays of a result file."""

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

import quasidynamic as qd
from flexbearing.build import ball_rows, clearance, lubrication, out_of_round
from flexbearing.build.ball_fits import ball, groove
from flexbearing.case import BadCase, Head
from flexbearing.case.balls.angular_contact import AngularBearing, FastCase
from flexbearing.case.coupling import MethodsOfCoupling
from flexbearing.findings import Judged, declared, evaluate
from flexbearing.findings.running import GYROSCOPIC_MOMENT
from flexbearing.life import ball_lives, rated_bearing
from flexbearing.life.life_of_state import MREV, ReferenceLives
from flexbearing.program.shared_map import shared_map
from flexbearing.progress import Report
from flexbearing.quantities.angular_contact import LAYOUT
from flexbearing.quantities.quantity import row, taken
from flexbearing.runs import elastic_grooves, judged, neglect, not_round, probes, shoulders, subsurface, teeth
from flexbearing.runs.probes import Stresses
from quasidynamic import ImpossiblePart, NotSolved, OutOfRange
from quasidynamic.balance.balls.free_ball import OiledBalls
from quasidynamic.columns import kind_and_numbers
from quasidynamic.contact.film import lambda_ratio
from quasidynamic.note import Note, information, outside
from quasidynamic.outcome.angular_contact_state import RollingContact
from quasidynamic.outcome.rating_life import BALLS
from quasidynamic.outcome.worst_point_contact import WorstPointContact
from quasidynamic.parts.ball_cage import BallCage

if TYPE_CHECKING:
    from fem.solid.probes import Readings
    from flexbearing.case.balls.ring_room import Race
    from flexbearing.coupled.balls import CouplingRecord
    from flexbearing.rings.grooves import GroovePair


@dataclass(frozen=True)
class Solution:
    """A solved case."""

    case: FastCase
    state: qd.AngularContactState
    contact: RollingContact
    rolling: qd.FastRollingBalls | None  # balls whose contacts stick and slip; None in full sliding
    lives: ReferenceLives | None  # None at rest, without load, and where no rating is known
    unrolled: str = ""  # why stick and slip are not known, where the case requires them
    without_torque: str = ""  # why the torque of friction is not known, though a coefficient is
    probes: "Readings | str | None" = None  # or why there are none, though the case has some
    stresses: Stresses | None = None  # largest ones, or why there are none

    @property
    def worst(self) -> WorstPointContact:
        """The most pressed contact of each raceway."""
        return WorstPointContact.of(self.state.peak_pressures.T, *(axis.T for axis in self.state.semi_axes))

    @property
    def friction(self) -> qd.AngularContactState | qd.FastRollingBalls:
        """Notes about heat and torque of friction."""
        return self.state if self.rolling is None else self.rolling


STICK = "stick and slip, ball by ball"  # what is reported while it is found
OUT_OF_RANGE = "outside a law"  # how a solver ended
USUAL = MethodsOfCoupling()  # by which cases are solved side by side
Ended = Solution | NotSolved | BadCase  # or why there is no solution
Block = Literal["rigid", "flexible"]  # the rings between which there is a solution


def bearing(case: FastCase) -> qd.AngularContactBallBearing:
    """The bearing of a case; without the cam that only an elastic outer ring follows."""
    parts = case.bearing
    contact_angle, change = _angle_and_clearance(case)
    round_one = qd.AngularContactBearing(
        ball=ball(parts, case.materials.ball),
        inner=_groove(case, "inner"),
        outer=_groove(case, "outer"),
        balls=parts.balls,
        pitch_diameter=parts.pitch_diameter,
        contact_angle=contact_angle,
        first_ball_azimuth=parts.first_ball_azimuth,
    )
    round_one = replace(round_one, clearance=change, rows=ball_rows.rows(case, round_one))
    waves = out_of_round.approaches(case, round_one.azimuths)
    return qd.AngularContactBallBearing(
        bearing=round_one if waves is None else replace(round_one, approaches=tuple(waves)),
        control=case.operation.control,
        friction=case.friction.coefficient,
        spin=case.friction.spin,
        sticking=_sticking(case),
        interface_compliance=case.friction.interface_compliance or 0.0,
        lubrication=lubrication.ball_lubrication(case),
        cage=_cage(case),
    )


def _groove(case: FastCase, race: "Race") -> qd.Groove:
    """A groove that ends on its shoulders."""
    without_end = groove(case.bearing, race, case.materials.ring(race))
    radius, heights = (
        without_end.conformity * case.bearing.ball.diameter,
        getattr(case.bearing, race).shoulders,
    )
    high, low = (np.inf if height is None else float(np.arccos(1 - height / radius)) for height in heights)
    return replace(without_end, ends=(high, low))


def _cage(case: FastCase) -> BallCage | None:
    """The cage of a case, or none."""
    if (cage := case.bearing.cage) is None:
        return None
    land = ("land_diameter", "land_width", "land_clearance")
    return BallCage(
        guidance=cage.guidance,
        pocket_clearance=cage.pocket_clearance,
        pocket_friction=cage.pocket_friction,
        land_flow=cage.land_flow,
        **{name: getattr(cage, name) for name in land if getattr(cage, name) is not None},
    )


def _angle_and_clearance(case: FastCase) -> tuple[float, float]:
    """Contact angle before mounting, and what fits add to its clearance.

    A deep groove bearing has no angle but that of its clearance.
    """
    if isinstance(case.bearing, AngularBearing):
        change = clearance.operating(case) - case.stated_clearance
        return case.bearing.contact_angle, change
    return 0.0, clearance.operating(case)


def _sticking(case: FastCase) -> tuple[int, int] | None:
    """Cells of FASTSIM in the balance: half of those of the contacts, as it requires them again and again."""
    if case.operation.control != "coulomb" or case.friction.model == "full_sliding":
        return None
    along, across = case.friction.cells
    return along // 2, across // 2


def operation(case: FastCase) -> qd.RingOperation:
    """Load, displacement and speeds of a case."""
    places = case.operation.displacement.values
    return qd.RingOperation(
        load=case.operation.load.values,
        displacement=places if case.operation.preload is None else (_preload_place(case), *places[1:]),
        inner_speed=case.operation.inner_speed,
        outer_speed=case.operation.outer_speed,
    )


def _preload_place(case: FastCase) -> float:
    """Axial displacement at which a preload holds the ring [m]."""
    preload, unloaded = case.operation.preload, bearing(case).bearing
    assert preload  # or there is nothing to hold
    if preload.displacement is not None:
        return unloaded.touching_place + preload.displacement
    assert preload.force is not None  # checked on reading
    return qd.preloaded_place(unloaded, preload.force)


def build(case: FastCase) -> tuple[qd.AngularContactBallBearing, qd.RingOperation]:
    """Bearing and operation of a case; raises `ImpossiblePart` or `OutOfRange` where they cannot be.

    Raises `BadCase` when no such elastic ring can exist.
    """
    if not case.rigid:
        from flexbearing.rings import grooves  # finite elements are not described between rigid rings

        grooves.parts(case)
        if not set(case.operation.held) & {"displacement.radial_y", "displacement.radial_z"}:
            grooves.require_held(case, _radial(case))
    if case.outputs.probes:
        from flexbearing.build import groove_parts
        from flexbearing.build.probes import require_probes

        require_probes(case, groove_parts.groove_part, groove_parts.why_no_solid)
    return bearing(case), operation(case)


def solved(
    cases: Sequence[FastCase],
    report: Report,
    run: "CouplingRecord | None" = None,
    known: dict[Any, Any] | None = None,
) -> list[dict[Block, Ended]]:
    """Balance, pure rolling lines, and stick and slip where a case requires them; or why there is none.

    By the names of their blocks: between rigid rings, then between elastic ones where a case has them and
    there is a balance between rigid ones. Cases whose bearings are the same are balanced side by side, but
    for one whose iterations are stored. Grooves that are `known` are not condensed again.
    """
    models = [prepared(case) for case in cases]
    report.stage("fast balls between rigid rings", None)
    ended: list[dict[Block, Ended]] = [
        {"rigid": each} for each in _finished(cases, _balanced(cases, models), report)
    ]
    some = [k for k, each in enumerate(ended) if not cases[k].rigid and isinstance(each["rigid"], Solution)]
    if some:
        elastic, of_elastic = [cases[k] for k in some], [models[k] for k in some]
        states = between_elastic_rings(elastic, of_elastic, report, known, run)
        flexible = _finished(elastic, states, report)
        for k, each in zip(some, flexible, strict=True):
            ended[k]["flexible"] = each if isinstance(each, Exception) else _with_fields(each, report)
    return ended


def between_elastic_rings(
    cases: Sequence[FastCase],
    built: Sequence[Any],
    report: Report,
    known: dict[Any, Any] | None = None,
    run: "CouplingRecord | None" = None,
) -> list[Any]:
    """States of `prepared` cases between their elastic rings, or why there are none.

    Grooves are those that are `known` by what decides them, to which others are added.
    """
    rings = _grooves(cases, built, report, {} if known is None else known)
    report.stage("fast balls between elastic rings", None)
    models = [_preloaded(*each) for each in zip(cases, built, rings, strict=True)]
    return _balanced(cases, models, rings, run)


def _with_fields(solution: Solution, report: Report) -> Solution:
    """A solution between elastic rings with the stresses and strains of these that its case requires."""
    outputs = solution.case.outputs
    if outputs.probes is None and not outputs.stresses:
        return solution
    from flexbearing.runs import groove_fields  # with finite elements

    report.stage(probes.STAGE, None)
    return replace(
        solution,
        probes=groove_fields.readings(solution.case, solution.state) if outputs.probes else None,
        stresses=groove_fields.stresses(solution.case, solution.state) if outputs.stresses else None,
    )


def on_cam(case: FastCase, model: qd.AngularContactBallBearing) -> qd.AngularContactBallBearing:
    """A bearing whose inner ring a cam shapes; as it is where there is none."""
    if case.inner.kind != "cam":
        return model
    waves = np.array(model.bearing.approaches or 0.0)
    both = out_of_round.approaches_on_cam(case, model.bearing.azimuths) + waves
    return replace(model, bearing=replace(model.bearing, approaches=tuple(both)))


def _preloaded(case: FastCase, built: Any, rings: Any) -> Any:
    """Bearing and operation, the ring held where the force of a preload brings it between elastic rings."""
    if isinstance(built, Exception) or isinstance(rings, Exception):
        return built
    rest, (model, loaded) = preload_at_rest(case), built
    if rest is None:
        return on_cam(case, model), loaded
    state = named(case, partial(_coupled, case, model, rest, rings))
    if isinstance(state, Exception):
        return state
    return model, held_at(loaded, float(state.ring_displacement[0]))


def preload_at_rest(case: FastCase) -> qd.RingOperation | None:
    """A preload force at rest, which brings elastic rings to the place where it holds them; None without."""
    preload = case.operation.preload
    if preload is None or preload.force is None or case.rigid:
        return None
    return qd.RingOperation(load=(preload.force, 0.0, 0.0, 0.0, 0.0))


def held_at(operation: qd.RingOperation, place: float) -> qd.RingOperation:
    """The same operation, the ring held at an axial displacement [m]."""
    return replace(operation, displacement=(place, *operation.displacement[1:]))


def _finished(cases: Sequence[FastCase], states: Sequence[Any], report: Report) -> list[Ended]:
    return [
        state
        if isinstance(state, NotSolved | BadCase)
        else named(case, partial(_rolled, case, state, partial(report.stage, STICK)))
        for case, state in zip(cases, states, strict=True)
    ]


def _grooves(
    cases: Sequence[FastCase], built: Sequence[Any], report: Report, known: dict[Any, Any]
) -> list[Any]:
    """Elastic grooves of cases, one object for all that have the same; or why there are none."""
    from flexbearing.rings import grooves  # finite elements are not described between rigid rings

    grooves_of_cases = []
    for case, each in zip(cases, built, strict=True):
        if isinstance(each, Exception):
            grooves_of_cases.append(each)
            continue
        azimuths = each[0].bearing.azimuths
        key = named(case, partial(grooves.parts, case))
        if not isinstance(key, Exception):
            key = key, grooves.fit_of(case), azimuths.tobytes()
        if key not in known:
            pair = partial(grooves.groove_pair, case, azimuths, report)
            known[key] = key if isinstance(key, Exception) else named(case, pair)
        grooves_of_cases.append(known[key])
    return grooves_of_cases


def named(case: Head, solve: Callable[[], Any]) -> Any:
    """What a case gives, or the error that says why it gives nothing."""
    try:
        return solve()
    except NotSolved as failure:
        return failure
    except OutOfRange as problem:  # under its loads; what is built is without them
        return NotSolved(str(problem), OUT_OF_RANGE)
    except ImpossiblePart as problem:
        return BadCase(f"{case.source.path}: {problem}")


def prepared(case: FastCase) -> Any:
    """Bearing and operation of a case, or why there are none."""
    return named(case, lambda: (bearing(case), operation(case)))


def _balanced(
    cases: Sequence[FastCase],
    built: Sequence[Any],
    grooves: Sequence[Any] | None = None,
    run: "CouplingRecord | None" = None,
) -> list[Any]:
    """States of the bearings that could be built, those of the same bearing and grooves side by side.

    Alone is what is stored by a run, or has rings that are no part of one linear system.
    """
    rings = grooves or [None] * len(cases)
    states, alike = list(built), defaultdict[Any, list[int]](list)
    for place, (case, each, ring) in enumerate(zip(cases, built, rings, strict=True)):
        if isinstance(each, Exception) or isinstance(ring, Exception):
            states[place] = each if isinstance(each, Exception) else ring
        elif ring and (run or ring.elastic is None or case.coupling != USUAL):
            states[place] = named(case, partial(_coupled, case, *each, ring, run))
        else:
            kind, numbers = kind_and_numbers(each[0])
            alike[kind, *numbers, id(ring)].append(place)
    for places in alike.values():
        model, operations, ring = built[places[0]][0], [built[k][1] for k in places], rings[places[0]]
        elastic = ring and ring.elastic
        try:
            states_of_model = model.solve_many(operations, elastic)
        except OutOfRange:  # of one of them, which says so by itself
            each = zip(places, operations, strict=True)
            states_of_model = [named(cases[k], partial(model.solve, at, elastic)) for k, at in each]
        for place, state in zip(places, states_of_model, strict=True):
            again = partial(_coupled, cases[place], *built[place], ring)  # by other methods than newton
            states[place] = named(cases[place], again) if ring and isinstance(state, NotSolved) else state
    return states


def _coupled(
    case: FastCase,
    model: qd.AngularContactBallBearing,
    operation: qd.RingOperation,
    rings: "GroovePair",
    run: "CouplingRecord | None" = None,
) -> qd.AngularContactState:
    from flexbearing.coupled import balls  # with finite elements

    return balls.equilibrium(case.coupling, model, operation, rings, run)


def _rolled(case: FastCase, state: qd.AngularContactState, progress: Callable[[float], None]) -> Solution:
    """A balance with the friction of the case; that of full sliding where no stick and slip is known."""
    if case.friction.model == "full_sliding":
        return followed(case, state)
    if case.operation.inner_speed == case.operation.outer_speed:
        return replace(followed(case, state), unrolled="the bearing does not turn")
    along, across = case.friction.cells
    try:
        with shared_map() as mapped:
            rolling = bearing(case).roll(state, case.friction.model, (along, across), progress, mapped)
    except OutOfRange as why:
        return replace(followed(case, state), unrolled=str(why))
    return followed(case, state, rolling)


def followed(
    case: FastCase, state: qd.AngularContactState, rolling: qd.FastRollingBalls | None = None
) -> Solution:
    """A balance with all that follows from it; without a torque where the friction of balls finds none."""
    lines, without_torque = case.rolling_lines, ""
    try:
        _ = state.friction_heat
    except NotSolved as why:
        state, without_torque = replace(state, friction=None), str(why)
    contact = state.rolling_contact(spin=lines.spin, friction=lines.net_force)
    return Solution(
        case, state, contact, rolling, ball_lives.lives(case, state), without_torque=without_torque
    )


def block(solution: Solution) -> dict[str, NDArray]:
    """Quantities of the solution."""
    case, state, contact = solution.case, solution.state, solution.contact
    lines = _lines(case, state, contact) if len(contact.balls) else None
    free = {"yaw": state.yaw} if case.operation.by_friction else None
    parts = {
        "worst": solution.worst,
        "subsurface": subsurface.of_balls(case, solution.worst),
        "state": state,
        "friction": solution.friction,
        "rolling": solution.rolling,
        "fields": _fields(solution),
        "lines": lines,
        "free": free,
        "oil": _oil(case, state),
        "probes": None if isinstance(solution.probes, str) else solution.probes,
        "life": solution.lives,
        "rated": {
            "static_safety": ball_lives.safety(case, state),
            "effective_static_safety": ball_lives.effective_safety(case, state),
            "unloading_force": (
                qd.unloading_force(state.bearing) if state.groove_displacement is None else None
            ),
        },
    }
    return row(taken(LAYOUT.quantities, {name: [part] for name, part in parts.items()}), 0)


def _oil(case: FastCase, state: qd.AngularContactState) -> dict[str, Any] | None:
    """What the oil does to the balls; None where it does not move them."""
    if (oil := state.oil) is None:
        return None
    rough = lubrication.roughness(case)
    return oil._asdict() | {
        "ring_torques": oil.ring_torque.sum(1),
        "losses": {
            "sliding": oil.sliding_heat.sum(),
            "rolling": oil.rolling_heat.sum(),
            "drag": oil.drag_heat.sum(),
            "churning": oil.churning_heat.sum(),
        },
        "cage": _in_cage(case, oil, state),
        "mean_ball_slip": oil.slip[state.guided].mean() if state.guided.any() else None,
        "film_ratio": None if rough is None else lambda_ratio(oil.film, rough[:, None]),
    }


def _in_cage(case: FastCase, oil: OiledBalls, state: qd.AngularContactState) -> dict[str, Any] | None:
    """What the cage does to the balls; None without one."""
    if (cage := case.bearing.cage) is None:
        return None
    outer, speed = case.operation.outer_speed, float(oil.cage_speed[0])
    rolling = (state.orbital_speed - outer) / (1 - oil.slip)  # of balls that do not slip
    driving = rolling[state.guided].mean() if state.guided.any() else None
    return {
        "speed": speed,
        "slip": None if not driving else 1 - (speed - outer) / driving,
        "force": oil.pocket_force,
        "torque": oil.pocket_torque,
        "displacement": oil.pocket_displacement,
        "share": oil.pocket_displacement / cage.pocket_clearance,
        "land_torque": oil.land_torque.sum(),
        "losses": {"pocket": oil.pocket_heat.sum(), "land": oil.land_heat.sum()},
    }


def _fields(solution: Solution) -> dict[str, NDArray] | None:
    """Cells of both contacts of the ball that carries most; None in full sliding, or where none rolls."""
    rolling = solution.rolling
    if rolling is None or all(ball is None for ball in rolling.rolled):
        return None
    ball = int(np.where(solution.state.on_inner, solution.state.loads.sum(0), 0.0).argmax())
    fields = [rolling.field(ball, race) for race in range(2)]
    return {"ball": np.array(ball)} | {name: np.stack([each[name] for each in fields]) for name in fields[0]}


def _lines(case: FastCase, state: qd.AngularContactState, contact: RollingContact) -> dict[str, NDArray]:
    """Pure rolling lines; not a number for balls without any."""

    def spread(values: NDArray) -> NDArray:
        whole = np.full((2, state.loads.shape[1], *values.shape[2:]), np.nan)
        whole[:, contact.balls] = values
        return whole

    position = np.linspace(-1.0, 1.0, case.rolling_lines.points)
    integral = contact.spin_torques(case.friction.coefficient)
    by_lines = contact.spin_torques(case.friction.coefficient, "lines")
    weight = np.sin(state.contact_angles[:, contact.balls])
    return {
        "line_parameter": spread(contact.parameter),
        "net_friction": spread(contact.net_force),
        "first_line": spread(contact.lines.first),
        "second_line": spread(contact.lines.second),
        "line_count": spread(contact.lines.count),
        "spin_torque": spread(integral),
        "spin_torque_by_lines": spread(by_lines),
        "spin_friction": (weight * integral).sum(),
        "spin_friction_by_lines": (weight * by_lines).sum(),
        "slip_position": position,
        "slip_profile": spread(contact.slip_velocity(position)),
    }


def judge(solution: Solution) -> tuple[Judged, ...]:
    """The solution against the limits of ball bearings."""
    case, state, operation = solution.case, solution.state, solution.case.operation
    speed, lives = operation.inner_speed - operation.outer_speed, solution.lives
    radial = not isinstance(case.bearing, AngularBearing)  # not adjusted axially
    own = ball_lives.rated(case)
    values = {
        **judged.pressures(state.peak_pressures.max(axis=1), BALLS),
        **neglect.of_fast_balls(solution),
        **_places(case, state),
        "static_safety": ball_lives.safety(case, state),
        "viscosity_ratio": own.known_kappa,
        "force_of_motions": _force_of_motions(case, state),
        "least_stiffness": judged.least_stiffness(state.stiffness[None, 1:3, 1:3]),
        "rated_viscosity_ratio": own.rated_kappa,
        "clearance": judged.clearances(clearance.record(case)) if radial else None,
        **rated_bearing.rating_ratios([own.given]),
        **rated_bearing.rating_changes([own.given]),
    }
    if not operation.by_friction:  # there balls turn where friction does not hold them
        values |= {"needed_friction": state.needed_friction.max(), "friction": case.friction.coefficient}
    values |= probes.values(case, solution.stresses)
    if lives is not None:
        life = lives.basic if lives.modified is None else lives.modified
        values |= {
            "load": {"by the loads of the balls": own.reference_load(lives.basic / MREV)},
            "dynamic_rating": own.rows_rating * own.dynamic,
            "static_rating": own.static_or_none,
            **judged.lives(life / MREV, speed, [case.life.required]),
        }
    return evaluate(declared.OF_BALLS, values)


def _force_of_motions(case: FastCase, state: qd.AngularContactState) -> float | None:
    """Range of the axial forces of all stable motions over the largest; of a held ring with a cage alone."""
    held = state.operation.displacement[0] is not None
    if case.bearing.cage is None or not held or state.groove_displacement is not None:
        return None
    motions = (state, *bearing(case).other_motions(state))
    forces = np.array([motion.ring_load[0] for motion in motions])
    return float(np.ptp(forces) / np.abs(forces).max()) if forces.any() else None


def _radial(case: FastCase) -> complex:
    """Load along z + i y [N]."""
    return complex(case.operation.load.radial_z, case.operation.load.radial_y)


def _places(case: FastCase, state: qd.AngularContactState) -> dict[str, Any]:
    """Angle of the most loaded ball, and how high contacts reach on races whose end is not given."""
    of_design = isinstance(case.bearing, AngularBearing) and bool(state.loads.any())
    ball = int(state.loads.sum(axis=0).argmax())
    heights = {
        race: height.max() / case.bearing.ball.diameter
        for name, race, height in zip(("inner", "outer"), judged.RACES, state.needed_shoulders, strict=True)
        if getattr(case.bearing, name).shoulder is None
    }
    return {
        "contact_height": heights,
        "loaded_angle": state.contact_angles[:, ball].min() if of_design else None,
    }


def notes(solution: Solution, found: Iterable[Judged]) -> tuple[Note, ...]:
    """What a user must know of the solution, judged by findings before."""
    case, state, of_findings = solution.case, solution.state, judged.notes(found)
    held = [note for note in of_findings if note.code == GYROSCOPIC_MOMENT.code]
    lines: tuple[Note, ...] = tuple(note for note in of_findings if note not in held)
    if state.groove_displacement is not None:
        lines += elastic_grooves.notes(case, state.contact_angles, state.loads, state.semi_axes[0])
    lines += not_round.notes(case)
    lines += tuple(teeth.notes(case.outer, _radial(case), "operation.load"))
    if case.outer.kind == "matrix":
        from flexbearing.build import reduced_bodies  # with readers of other programs' files

        lines += reduced_bodies.notes(case)
    lifted = int((~state.on_inner).sum())
    if lifted:
        lines += (
            information("idle-balls", f"{lifted} of {len(state.on_inner)} balls do not touch the inner race"),
        )
    lines += _on_shoulders(case, state)
    unguided = int((state.on_inner & ~state.guided).sum())
    if unguided:
        far = "" if case.operation.by_friction else " or too far round"
        lines += (
            outside(
                "unguided-balls",
                f"{unguided} balls are loaded too lightly on the inner race{far} for both races to guide "
                "them: their orbit, spin and tractions are estimates",
            ),
        )
    return (
        lines
        + shoulders.unusual(case.materials)
        + clearance.notes(case)
        + _preload(case, state)
        + _lineless(solution)
        + (*held, *_lying(case, state))
        + _stick(case, solution)
        + shoulders.unrolled(solution.unrolled)
        + shoulders.without_torque(solution.without_torque)
        + probes.notes(solution.probes, solution.stresses)
        + subsurface.notes(case, solution.worst)
        + ball_lives.notes(case)
    )


def _on_shoulders(case: FastCase, state: qd.AngularContactState) -> tuple[Note, ...]:
    """Contacts that reach over shoulders, and what that changes."""
    lines: tuple[Note, ...] = ()
    for race, name in enumerate(("inner", "outer")):
        angles, high_and_low = state.contact_angles[race], getattr(case.bearing, name).shoulders
        for low, height in enumerate(dict.fromkeys(high_and_low)):  # one pass where both are alike
            there = (angles < 0) == low if high_and_low[0] != high_and_low[1] else np.full(len(angles), True)
            reached = np.where(there, state.needed_shoulders[race], 0.0)
            least = float(state.carried_shares[race].min(where=there, initial=1.0))
            lines += shoulders.reached_over(name, reached, angles, case.bearing.ball.diameter, height, least)
    if state.whole_displacement is not None:
        moved = 1e6 * (state.ring_displacement - state.whole_displacement)
        lines += (
            information(
                "cut-contact-displacement",
                "cut contacts: against whole ones the inner ring is displaced by "
                f"{moved[0]:+.2f}, {moved[1]:+.2f}, {moved[2]:+.2f} um along x, y, z",
            ),
        )
    return lines


def _preload(case: FastCase, state: qd.AngularContactState) -> tuple[Note, ...]:
    """Where a preload holds the ring, and what becomes of its force in operation."""
    if case.operation.preload is None:
        return ()
    place, force = state.operation.displacement[0], case.operation.preload.force
    rest = "" if force is None else f", where {force:.5g} N hold it at rest,"
    return (
        information(
            "preload",
            f"preload: the ring is held axially at {1e6 * (place or 0.0):.3f} um{rest} and carries "
            f"{state.ring_load[0]:.5g} N in operation",
        ),
    )


def _stick(case: FastCase, solution: Solution) -> tuple[Note, ...]:
    """What stick makes of the friction torque, how exact it is, and what it leaves unbalanced."""
    rolling, torque, state = solution.rolling, solution.state.friction_torque, solution.state
    if rolling is None or not torque:
        return ()
    along, across = case.friction.cells
    balance = f"FASTSIM on {along // 2} by {across // 2} cells" if state.sticking else "full sliding"
    return (
        information(
            "stick-and-slip",
            f"friction torque: {case.friction.model} on {along} by {across} cells a contact, within "
            f"{rolling.grid_error.sum():.2g} N m of finer ones; "
            f"{100 * (rolling.friction_torque / torque - 1):+.1f} % against {balance} with the same spin, of "
            f"{torque:.5g} N m{shoulders.by_springs(case.friction.model, rolling.stick_share)}",
            {"friction.spin": case.friction.spin},
        ),
        information(
            "kept-motion",
            f"friction torque: loads and motion of the balls are those of {balance}; what "
            f"{case.friction.model} changes in the friction is not balanced, on a ball a moment of up to "
            f"{rolling.unbalanced_moment.max():.1%}, a force along the orbit of up to "
            f"{np.abs(rolling.unbalanced_force).max():.1%} and one in its section plane of up to "
            f"{rolling.unbalanced_section_force.max():.1%} of the most that friction can hold",
        ),
        *shoulders.compliant(case.friction.interface_compliance),
    )


def _lineless(solution: Solution) -> tuple[Note, ...]:
    """Balls that touch both races and have no pure rolling lines, and why."""
    contact, count = solution.contact, solution.state.loads.shape[1]
    if not (solution.state.loads > 0).all(0).any():
        return (information("no-rolling-lines", "no pure rolling lines: no ball touches both races"),)
    high = (
        "contacts as wide as the surface they press, nor is there a friction torque: the load is far too high"
    )
    sliding = "their friction moments about the spin axis do not balance, they slide on one race"
    reasons = (
        (len(contact.wide), high, {}),
        (len(contact.sliding), sliding, {"rolling_lines.net_force": "balanced"}),
    )
    return tuple(
        information("no-rolling-lines", f"no pure rolling lines of {balls} of {count} balls: {reason}", keys)
        for balls, reason, keys in reasons
        if balls
    )


def _lying(case: FastCase, state: qd.AngularContactState) -> tuple[Note, ...]:
    """Balls that friction does not hold against their gyroscopic moment, and how they turn."""
    lying = state.on_inner & ~state.upright
    if not case.operation.by_friction or not lying.any():
        return ()
    return (
        information(
            "gyroscopic-moment",
            f"gyroscopic moment: friction does not hold the axes of {int(lying.sum())} balls, which turn "
            f"towards the shaft, down to {np.degrees(np.abs(state.attitude[lying]).min()):.1f} deg",
        ),
    )
