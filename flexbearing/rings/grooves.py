"""Elastic rings with grooves of a case, meshed and condensed, or taken from the cache."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import fem
from fem.condense import HARMONICS, SMEARED, SOLID
from fem.errors import NotSolved as RingNotSolved
from fem.mesh.axial_section import require_affordable_section, sections, smeared_sections
from fem.parts.part import Part
from fem.parts.step_solid import StepSolid
from fem.raceway.stations import narrowest_patch
from flexbearing.build import held_ring
from flexbearing.build.groove_parts import BallCase, groove_part
from flexbearing.case import BadCase
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.bolted_rings import Rings
from flexbearing.case.balls.elastic_rings import GrooveAccuracy
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.balls.groove_accuracy import ORDER, ORDER_IN_SPACE, patch
from flexbearing.case.balls.ring_room import MARGIN, OUTWARD, Race
from flexbearing.case.quantity import at_least, in_mm
from flexbearing.coupling import LinearRaceway, Raceway, RacewayPair
from flexbearing.program.threads import of_solids
from flexbearing.progress import Report
from flexbearing.rings.stored import Arguments, condensed_part
from quasidynamic import ImpossiblePart, NotSolved
from quasidynamic.balance.balls.elastic_grooves import ElasticGroove, ElasticGrooves
from quasidynamic.parts.angular_contact_bearing import azimuths_of_row

if TYPE_CHECKING:
    from fem.joint.preloaded_fit import Fit
    from fem.raceway.compliance import RacewayCompliance

MESH = 0.25  # largest element over the ball diameter
FINER, FINER_IN_SPACE = 6.0, 3.0  # order of the elements times width of a patch, over those on the groove

RACES: tuple[Race, Race] = ("inner", "outer")


@dataclass(frozen=True, kw_only=True)
class GrooveShape:
    """A part with the patches on its groove."""

    race: Race
    part: Part | StepSolid
    reach: tuple[float, float]  # [rad] contact angles of the outermost stations
    width: float  # [m] of a patch

    @property
    def length(self) -> float:
        """Axial width of the groove [m]."""
        assert self.part.groove
        return self.part.groove.width(self.part.raceway_diameter / 2, OUTWARD[self.race])


class GroovePair(NamedTuple):
    """Both grooves under balls, at least one of them elastic."""

    raceways: RacewayPair
    angles: NDArray  # (2, K) [rad] of the stations
    elastic: ElasticGrooves | None  # None where a ring may lift off its supports


def accuracy_of(case: BallCase) -> tuple[str, GrooveAccuracy | Rings]:
    """How finely grooves are resolved, and the section of the case that says so."""
    return ("rings", case.rings) if isinstance(case, FourPointCase) else ("accuracy", case.accuracy)


def parts(case: BallCase) -> tuple[Arguments | None, Arguments | None]:
    """What decides the elastic grooves of a case, inner and outer; None where a ring is rigid.

    Raises `BadCase` when no such part can exist, or its elements are too small.
    """
    inner, outer = (shape and arguments_of(case, shape) for shape in (shape_of(case, race) for race in RACES))
    for race, arguments in zip(RACES, (inner, outer), strict=True):
        if arguments:
            _require_affordable(case, race, arguments)
    return inner, outer


def _require_affordable(case: BallCase, race: Race, arguments: Arguments) -> None:
    part, _, resolution = arguments
    if isinstance(part, StepSolid):
        return  # only the opened drawing can tell
    bodies = smeared_sections if isinstance(part, fem.SquirrelCage) else sections
    try:
        require_affordable_section(bodies(part, resolution.length), resolution.mesh)
    except RingNotSolved as problem:
        section, accuracy = accuracy_of(case)
        key = "mesh_size" if accuracy.patch_width is None else "patch_width or mesh_size"
        raise BadCase(f"{case.source.path}: [{section}] {key}: {race} ring: {problem}") from problem


def shape_of(case: BallCase, race: Race) -> GrooveShape | None:
    """Part that carries a groove, with the patches on it; None where a ring is rigid.

    Raises `BadCase` when no such part can exist.
    """
    part = groove_part(case, race)
    if part is None or part.groove is None:
        return None
    width, groove = patch(accuracy_of(case)[1], case.bearing.ball.diameter), part.groove
    margin = MARGIN * width / groove.radius
    if isinstance(part, StepSolid):
        first, end = part.arc(groove)
    else:
        end = groove.end(part.raceway_diameter / 2, OUTWARD[race])
        first = groove.bottom_angle if groove.aside else -end
        _require_harmonics(case, race, width, max(groove.bottom(OUTWARD[race]), groove.centre_radius))
    return GrooveShape(race=race, part=part, reach=(first + margin, end - margin), width=width)


def _require_harmonics(case: BallCase, race: Race, width: float, radius: float) -> None:
    """Raise where patches are too narrow for all harmonics on a groove of largest radius [m]."""
    if width < narrowest_patch(radius):
        raise BadCase(
            f'{case.source.path}: [{accuracy_of(case)[0]}] patch_width = "{in_mm(width)}" cannot be; it must '
            f"be {at_least(narrowest_patch(radius))} on an {race} groove of so large a radius."
        )


def arguments_of(case: BallCase, shape: GrooveShape) -> Arguments:
    """What decides a groove of some shape, as finely resolved as a case has it."""
    accuracy, part = accuracy_of(case)[1], shape.part
    usual, finer = (ORDER_IN_SPACE, FINER_IN_SPACE) if isinstance(part, StepSolid) else (ORDER, FINER)
    order = accuracy.element_order or usual
    resolution = fem.Resolution(
        length=shape.length,
        mesh_size=fem.MeshSize(
            order=order,
            size=accuracy.mesh_size or MESH * case.bearing.ball.diameter,
            raceway_size=order * shape.width / finer,
        ),
        stations=fem.Stations(angles=_spread(*shape.reach, accuracy.stations), width=shape.width),
    )
    if isinstance(part, StepSolid):
        assert isinstance(case, FastCase)  # no other one has a drawing
        azimuths = azimuths_of_row(case.bearing.first_ball_azimuth, case.bearing.balls)
        return part, SOLID, replace(resolution, azimuths=tuple(azimuths), threads=of_solids(None))
    return part, SMEARED if isinstance(part, fem.SquirrelCage) else HARMONICS, resolution


def _spread(first: float, last: float, count: int) -> tuple[float, ...]:
    """Places that are denser towards the ends: functions through evenly spread ones are steep there."""
    places = np.sin(np.pi / 2 * np.linspace(-1, 1, count))
    return tuple((first + last) / 2 + (last - first) / 2 * places)


def elastic_grooves(case: BallCase, azimuths: NDArray, report: Report) -> ElasticGrooves | None:
    """Both grooves under balls at azimuths (Z) [rad]; None between rigid rings.

    Raises `BadCase` when a part cannot exist; `NotSolved` when the finite elements find none.
    """
    shapes = (shape_of(case, race) for race in RACES)
    inner, outer = (shape and groove_of_shape(case, shape, azimuths, report) for shape in shapes)
    return None if inner is None and outer is None else ElasticGrooves(inner, outer)


def groove_pair(case: FastCase, azimuths: NDArray, report: Report) -> GroovePair:
    """Both grooves under balls at azimuths (Z) [rad] as partners of a coupling; raises as above."""
    shapes = [shape_of(case, race) for race in RACES]
    angles = [shape and stations_of(case, shape).angles for shape in shapes]
    known = next(each for each in angles if each)
    raceways = RacewayPair(*(_raceway(case, shape, azimuths, report) for shape in shapes))
    elastic = None
    if not case.lifts_off:
        pair = raceways.linearised(np.zeros((2, len(azimuths), len(known))))
        both = zip(shapes, pair.raceways, strict=True)
        grooves = (_groove(case, shape, at) if shape and at else None for shape, at in both)
        elastic = ElasticGrooves(*grooves)
    return GroovePair(raceways, np.array([each or known for each in angles]), elastic)


def fit_of(case: FastCase) -> "Fit | None":
    """What holds an outer ring that is not bonded to its housing; None of others."""
    if not case.in_fit:
        return None
    from flexbearing.rings.fits import in_housing  # a case is checked without what knows rollers

    return in_housing(case)


def require_held(case: FastCase, load: complex) -> None:
    """Refuse supports that cannot hold a radial load [N] along z + i y; raises `BadCase`."""
    with _named(case, "outer"):
        held_ring.require_held_on_lines(case.outer, load)


def _raceway(case: FastCase, shape: GrooveShape | None, azimuths: NDArray, report: Report) -> Raceway:
    # a case is checked without what knows rollers
    from flexbearing.rings.raceways import CondensedRaceway, RigidRaceway
    from flexbearing.rings.supported import FIGURES, RINGS, SupportedRaceway

    if shape is None:
        return RigidRaceway(azimuths)
    with _named(case, shape.race):
        if shape.race == "outer" and case.in_fit:
            from flexbearing.rings.fits import grooved_ring_in_housing

            report.stage("outer ring in its housing", None)
            part, _, resolution = arguments_of(case, shape)
            return grooved_ring_in_housing(case, part, resolution, azimuths)
        ring = compliance(case, shape, report)
        outer, support = case.outer, case.outer.support
        on_lines = outer.kind == "ring" and support == "lines"
        if shape.race == "inner" or not (on_lines or outer.lifts_off):
            under = partial(_under_rows, case, ring)
            return CondensedRaceway(under(azimuths), under)
        under_balls = ring.under_rollers(azimuths)
        name, figures = RINGS[support], FIGURES[support]
        return SupportedRaceway(name, under_balls, figures, ring.under_rollers, from_ground=True)


def stations_of(case: BallCase, shape: GrooveShape) -> fem.Stations:
    """Stations of a groove of some shape."""
    stations = arguments_of(case, shape)[2].stations
    assert stations  # of every part with a groove
    return stations


def groove_of_shape(case: BallCase, shape: GrooveShape, azimuths: NDArray, report: Report) -> ElasticGroove:
    """A groove of some shape under balls at azimuths (Z) [rad], as finely resolved as a case has it.

    Raises `BadCase` when the part cannot exist; `NotSolved` when the finite elements find none.
    """
    with _named(case, shape.race):
        ring = compliance(case, shape, report)
        at_balls = ring.at(azimuths) if isinstance(case, FourPointCase) else _under_rows(case, ring, azimuths)
    return _groove(case, shape, at_balls)


def _under_rows(case: FastCase, ring: Any, azimuths: NDArray) -> "RacewayCompliance":
    """Compliance of condensed grooves under balls at azimuths (Z) [rad], one row after the other.

    Rows of a pair are in one ring, or each has a ring of its own.
    """
    of_row = azimuths[: case.bearing.balls]
    at_row = ring.at(of_row)
    return at_row if len(at_row.azimuths) == len(azimuths) else at_row.repeated(len(azimuths) // len(of_row))


def _groove(case: BallCase, shape: GrooveShape, at_balls: LinearRaceway) -> ElasticGroove:
    try:
        angles = np.array(stations_of(case, shape).angles)
        return ElasticGroove(angles, at_balls.absolute, at_balls.initial_deviation)
    except ImpossiblePart as problem:  # of a part that hardly anything holds
        raise NotSolved(
            f"{shape.race} ring: so flexible a part is beyond finite elements: {problem}", "not solved"
        ) from None


def compliance(case: BallCase, shape: GrooveShape, report: Report) -> Any:
    """Compliance of a groove for balls anywhere.

    Raises `BadCase` when the part cannot exist; `NotSolved` when the finite elements find none.
    """
    name = f"{shape.race} ring"
    report.stage(name, None)
    with _named(case, shape.race):
        return condensed_part(name, arguments_of(case, shape), report)


@contextmanager
def _named(case: BallCase, race: Race) -> Iterator[None]:
    """Turn failures of the finite elements into those of a case or of a solve, with the name of the ring."""
    try:
        yield
    except fem.ImpossiblePart as problem:
        raise BadCase(f"{case.source.path}: {race} ring: {problem}") from problem
    except RingNotSolved as problem:
        raise NotSolved(f"{race} ring: {problem}", "not solved") from problem
