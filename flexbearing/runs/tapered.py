"""Tapered roller bearings, from cases to result files and to rows of a table."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from flexbearing.build import lubrication, tapered_bearing, tapered_fits
from flexbearing.case import BadCase
from flexbearing.case.tapered import TaperedCase
from flexbearing.findings import Judged, declared, evaluate, records
from flexbearing.life import life_rules, rated_bearing, tapered_lives
from flexbearing.life.life_of_state import MREV, ReferenceLives
from flexbearing.life.tapered_lives import LoadsRated
from flexbearing.outputs import requested
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.progress import Logged, Report
from flexbearing.quantities.layout import Layout
from flexbearing.quantities.quantity import row, taken
from flexbearing.quantities.spherical_roller import LAYOUT as OF_SPHERICAL
from flexbearing.quantities.tapered import LAYOUT
from flexbearing.quantities.thrust_roller import LAYOUT as OF_THRUST
from flexbearing.results import Recorder
from flexbearing.runs import judged, subsurface
from flexbearing.runs.answer import BAD_INPUT, CONVERGED, Answer, row_findings
from quasidynamic import (
    ImpossiblePart,
    NotSolved,
    OutOfRange,
    RingOperation,
    TaperedLoads,
    TaperedRollerBearing,
    tapered_loads,
)
from quasidynamic.note import Note, graded, information
from quasidynamic.outcome.neglected import weight_share
from quasidynamic.outcome.rating_life import ROLLERS
from quasidynamic.outcome.worst_line_contact import WorstLineContact
from quasidynamic.tapered_friction import TaperedFriction

NOT_SOLVED = "not solved"
LAYOUTS: dict[str, Layout] = {
    "tapered_roller": LAYOUT, "thrust_roller": OF_THRUST, "spherical_roller": OF_SPHERICAL
}  # fmt: skip
WORDS = {"tapered_roller": "tapered rollers", "thrust_roller": "rollers", "spherical_roller": "barrels"}


@dataclass(frozen=True)
class Solution:
    """A solved case."""

    case: TaperedCase
    loads: TaperedLoads
    rated: LoadsRated
    lives: ReferenceLives | None

    @cached_property
    def friction(self) -> TaperedFriction | None:
        """Films and friction; None without outputs.friction."""
        if not self.case.outputs.friction:
            return None
        laws = lubrication.lubrication(self.case)
        cage, rib = tapered_bearing.cage(self.case), tapered_bearing.rib_friction(self.case)
        return TaperedFriction(self.loads, laws, rib, cage)

    @property
    def film_ratio(self) -> NDArray | None:
        """Least film over the composite roughness of each contact (2, Z) [-], 0 without load."""
        rough = lubrication.roughness(self.case)
        if self.friction is None or rough is None:
            return None
        film = self.friction.loaded_film
        least = np.where(film > 0, film, np.inf).min(-1)
        return np.where(np.isfinite(least), least, 0.0) / rough[:, None]

    @property
    def row_load(self) -> NDArray | None:
        """What each of two rows carries (2, 3) [N]; None of one."""
        return None if self.case.bearing.pair is None else self.loads.row_load

    @cached_property
    def rib_heat(self) -> NDArray:
        r"""Heat of each roller's end on the rib (Z) [W].

        .. math:: \Phi_f = \mu\, Q_f\, |v_f|

        Source
        ------
        Coulomb friction at the speed of pure rolling; with friction in the speeds that of `TaperedFriction`.
        """
        if self.friction is not None:
            return self.friction.rib_heat
        sliding = abs(self.loads.speeds.rib_sliding)
        return tapered_bearing.rib_friction(self.case) * self.loads.rib_loads * sliding

    @cached_property
    def worst(self) -> WorstLineContact:
        """The most pressed slice of each raceway."""
        loads = self.loads
        flat = loads.pressures.reshape(2, -1)
        places = flat.argmax(axis=1)
        radii = [loads.reduced_radius(race)[place % loads.slices.count] for race, place in enumerate(places)]
        return WorstLineContact.under(flat.max(axis=1), np.array(radii), loads.moduli)


def build(case: TaperedCase) -> tuple[TaperedRollerBearing, RingOperation]:
    """Bearing and operation; raises `ImpossiblePart` or `BadCase` where they, or elastic rings, cannot be.

    Raises `OutOfRange` beyond the data of the oil of films.
    """
    if case.outputs.friction:
        lubrication.lubrication(case)
    if not case.rigid:
        from flexbearing.rings.cones import parts  # with what describes finite elements

        parts(case)
    return tapered_bearing.build(case)


def opening(case: TaperedCase) -> dict[str, object]:
    """Root attributes that are known before anything is solved."""
    return {"notes": [], "life": {}}


RIGID: tuple[None, None] = (None, None)
Block = Literal["rigid", "flexible"]


def raceways(case: TaperedCase, report: Report) -> Any:
    """Compliance of both raceways of a case; raises `NotSolved` where the finite elements find none."""
    if case.rigid:
        return RIGID
    from flexbearing.rings import cones  # with finite elements

    return cones.raceways(case, tapered_bearing.bearing(case).azimuths, report)


def solved(case: TaperedCase, raceways: Any = RIGID) -> Solution:
    """Balance of rollers and inner ring of a case between raceways; raises `NotSolved` without one."""
    loads = tapered_loads(*tapered_bearing.build(case), case.accuracy.slices, raceways)
    return Solution(case, loads, tapered_lives.loads_rated(case, loads), tapered_lives.lives(case, loads))


def solutions(case: TaperedCase, report: Report) -> Iterator[tuple[Block, Solution]]:
    """Yield the solution between rigid rings, then that between elastic ones where the case has them."""
    rollers = WORDS[case.kind]
    report.stage(f"{rollers} between rigid rings", None)
    yield "rigid", solved(case)
    if not case.rigid:
        shapes = raceways(case, report)
        report.stage(f"{rollers} between elastic rings", None)
        yield "flexible", solved(case, shapes)


def solve(case: TaperedCase, record: Recorder, report: Report) -> dict[str, object]:
    """Write the solution of a case; returns the root attributes that say how it ended.

    Raises `BadCase` when no such bearing can exist.
    """
    name, solution = "", None
    try:
        for name, solution in solutions(case, report):
            record.block(name, block(solution))
    except NotSolved as failure:
        return _ending(NOT_SOLVED, str(failure), str(failure.outcome))
    except (ImpossiblePart, OutOfRange) as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem
    assert solution  # of rigid rings, at least
    found = judge(solution)
    words = (
        f"ring and rollers in balance to {solution.loads.solution.imbalance:.1e} of the largest force after "
        f"{solution.loads.solution.evaluations} evaluations of all rollers"
    )
    life = solution.lives and solution.lives.of_state
    rule = {"life_rule": life_rules.of_elements(case)} if solution.lives else {}
    fitted = tapered_fits.record(case)
    return {
        **_ending("converged", words, "converged"),
        "notes": [note.record() for note in graded(notes(solution, found))],
        "findings": [*map(vars, records(found))],
        "life": {name: life.record()} if life else {},
        **rule,
        **({"clearance": fitted} if fitted else {}),
    }


def _ending(status: str, message: str, ending: str) -> dict[str, Any]:
    return {"status": status, "message": message, "ending": ending, "iterations": 0}


def block(solution: Solution) -> dict[str, NDArray]:
    """Quantities of the solution."""
    loads, worst = solution.loads, solution.worst
    parts = {
        "subsurface": subsurface.of_rollers(
            solution.case, loads.bearing, worst.pressure, worst.half_width, np.zeros(2)
        ),
        "solution": solution,
        "loads": loads,
        "rib": solution if solution.case.bearing.rib else None,
        "rated": solution.rated,
        "life": solution.lives,
        "worst": worst,
        "friction": solution.friction,
    }
    return row(
        taken(LAYOUTS[solution.case.kind].quantities, {name: [part] for name, part in parts.items()}), 0
    )


def judge(solution: Solution) -> tuple[Judged, ...]:
    """The solution against the limits of roller bearings."""
    case, loads, rated, lives = solution.case, solution.loads, solution.rated, solution.lives
    own = tapered_lives.rated(case)
    letters = rated_bearing.THRUST_LETTERS if case.kind == "thrust_roller" else rated_bearing.LETTERS
    values: dict[str, Any] = {
        **judged.pressures(solution.worst.pressure, ROLLERS),
        "static_safety": rated.static_safety,
        "viscosity_ratio": own.known_kappa,
        "rated_viscosity_ratio": own.rated_kappa,
        "least_stiffness": judged.least_stiffness(loads.stiffness[None, 1:3, 1:3]),
        "neglected": _neglected(solution),
        "end_pressure": _end_pressure(loads),
        "rib_reach": loads.rib_reach.max() / (loads.bearing.roller.diameter / 2),
        **rated_bearing.rating_ratios([own.given], letters),
        **rated_bearing.rating_changes([own.given], letters),
    }
    if lives is not None:
        life = lives.basic if lives.modified is None else lives.modified
        values |= {
            "load": {"by the loads of the rollers": own.reference_load(lives.basic / MREV)},
            "dynamic_rating": rated.dynamic,
            **judged.lives(life / MREV, loads.operation.relative_speed, [case.life.required]),
        }
    known = {
        "tapered_roller": declared.OF_TAPERED,
        "thrust_roller": declared.OF_THRUST_ROLLERS,
        "spherical_roller": declared.OF_SPHERICAL_ROLLERS,
    }
    return evaluate(known[case.kind], values)


def _end_pressure(loads: TaperedLoads) -> float:
    """Pressure at the ends of rollers over the largest one of their raceway [-]."""
    peak = loads.pressures.max(axis=(1, 2))
    return float((loads.pressures[..., [0, -1]].max(axis=(1, 2)) / np.where(peak > 0, peak, 1.0)).max())


def _neglected(solution: Solution) -> dict[str, float]:
    """What the balance of the rollers leaves out and is known, over the largest load [-]."""
    loads, largest = solution.loads, float(solution.loads.loads.max())
    if not largest:
        return {}
    rib = tapered_bearing.rib_friction(solution.case) * float(loads.rib_loads.max())
    friction = solution.friction
    raceways = {} if friction is None else {
        "friction of the raceways": float(np.abs(friction.traction).max() / largest)
    }  # fmt: skip
    return {
        "weight of the rollers": float(weight_share(loads.bearing.roller.mass, largest)),
        "friction of the rib": rib / largest,
        **raceways,
    }


def notes(solution: Solution, found: Sequence[Judged]) -> tuple[Note, ...]:
    """What a user must know of the solution, judged by findings before."""
    without = "friction of the raceways, oil film and cage are left out of loads"
    inertia = "centrifugal forces and gyroscopic moments of pure rolling are in them"
    if solution.case.bearing.rib is None:
        inertia = "gyroscopic moments and centrifugal forces across rollers are in them, in pure rolling"
    if solution.friction is None:
        words = f"rollers roll without slip at mid-contact: {without} and speeds; {inertia}"
    else:
        words = f"{without}, which have no part of the slip; {inertia}"
    left_out = information("rollers-in-pure-rolling", words)
    of_oil = () if solution.friction is None else solution.friction.lubrication.oil.notes
    rated = tapered_lives.rated(solution.case).notes
    return (
        *judged.notes(found),
        left_out,
        *tapered_fits.notes(solution.case),
        *dict.fromkeys((*rated, *of_oil)),
    )


# -- rows of a table -------------------------------------------------------------------------------


def answers(cases: Sequence[TaperedCase], texts: Sequence[str], *_: Any, **__: Any) -> list[Answer]:
    """Outputs of cases, see `flexbearing.runs.rows.answers`; each is solved alone."""
    with linear_algebra_alone():
        return [_answer(case, texts) for case in cases]


def _answer(case: TaperedCase, texts: Sequence[str]) -> Answer:
    blocks: dict[str, Any] = {}
    solution = None
    try:
        for name, solution in solutions(case, Logged()):
            blocks[name] = block(solution)
    except NotSolved as failure:
        of_rigid = [text for text in texts if text.startswith("rigid.")] if blocks else []
        return Answer(NOT_SOLVED, str(failure), _numbers(case, blocks, of_rigid))
    except (BadCase, ImpossiblePart, OutOfRange) as problem:
        return Answer(BAD_INPUT, str(problem), {})
    assert solution  # of rigid rings, at least
    numbers = _numbers(case, blocks, texts)
    judgement = judge(solution)
    return Answer(CONVERGED, "", numbers, row_findings(records(judgement), notes(solution, judgement)))


def _numbers(case: TaperedCase, blocks: dict[str, Any], texts: Sequence[str]) -> dict[str, float]:
    return {text: requested(LAYOUTS[case.kind], text).number(blocks) for text in texts}
