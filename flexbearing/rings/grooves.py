"""Elastic rings with grooves of a case, meshed and condensed, or taken from the cache."""

from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

import fem
from fem.condense import HARMONICS, SMEARED, condense
from fem.errors import NotSolved as RingNotSolved
from flexbearing.build.groove_parts import BallCase, GroovePart, groove_part
from flexbearing.cache import configured
from flexbearing.case import BadCase
from flexbearing.case.balls.bolted_rings import Rings
from flexbearing.case.balls.elastic_rings import GrooveAccuracy
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.balls.ring_room import MARGIN, OUTWARD, Race
from flexbearing.progress import Report
from quasidynamic import ImpossiblePart, NotSolved
from quasidynamic.balance.balls.elastic_grooves import ElasticGroove, ElasticGrooves

MESH = 0.25  # largest element over the ball diameter
FINER = 6.0  # order of the elements times width of a patch, over the elements on the groove

RACES: tuple[Race, Race] = ("inner", "outer")
Arguments = tuple[GroovePart, fem.Discretisation, fem.Resolution]


def parts(case: BallCase) -> tuple[Arguments | None, Arguments | None]:
    """What decides the elastic grooves of a case, inner and outer; None where a ring is rigid.

    Raises
    ------
    BadCase
        when no such part can exist
    """
    inner, outer = (_arguments(case, race) for race in RACES)
    return inner, outer


def accuracy_of(case: BallCase) -> tuple[str, GrooveAccuracy | Rings]:
    """How finely grooves are resolved, and the section of the case that says so."""
    return ("rings", case.rings) if isinstance(case, FourPointCase) else ("accuracy", case.accuracy)


def _arguments(case: BallCase, race: Race) -> Arguments | None:
    part = groove_part(case, race)
    if part is None or part.groove is None:
        return None
    accuracy = accuracy_of(case)[1]
    diameter, land = case.bearing.ball.diameter, part.raceway_diameter / 2
    width, groove = accuracy.patch(diameter), part.groove
    end, margin = groove.end(land, OUTWARD[race]), MARGIN * width / groove.radius
    first, last = groove.bottom_angle + margin if groove.aside else margin - end, end - margin
    resolution = fem.Resolution(
        length=groove.width(land, OUTWARD[race]),
        mesh_size=fem.MeshSize(
            order=accuracy.element_order,
            size=accuracy.mesh_size or MESH * diameter,
            raceway_size=accuracy.element_order * width / FINER,
        ),
        stations=fem.Stations(angles=_spread(first, last, accuracy.stations), width=width),
    )
    return part, SMEARED if isinstance(part, fem.SquirrelCage) else HARMONICS, resolution


def _spread(first: float, last: float, count: int) -> tuple[float, ...]:
    """Places that are denser towards the ends: functions through evenly spread ones are steep there."""
    places = np.sin(np.pi / 2 * np.linspace(-1, 1, count))
    return tuple((first + last) / 2 + (last - first) / 2 * places)


def elastic_grooves(case: BallCase, azimuths: NDArray, report: Report) -> ElasticGrooves | None:
    """Both grooves under balls at azimuths (Z) [rad]; None between rigid rings.

    Raises
    ------
    BadCase
        when a part cannot exist
    NotSolved
        when the finite elements find none
    """
    inner, outer = (_under_balls(race, compliance(case, race, report), azimuths) for race in RACES)
    return None if inner is None and outer is None else ElasticGrooves(inner, outer)


def _under_balls(race: Race, groove: Any, azimuths: NDArray) -> ElasticGroove | None:
    if groove is None:
        return None
    at_balls = groove.at(azimuths)
    try:
        return ElasticGroove(at_balls.angles, at_balls.absolute)
    except ImpossiblePart as problem:  # of a shaft as thin as a wire
        raise NotSolved(
            f"{race} ring: so flexible a part is beyond finite elements: {problem}", "not solved"
        ) from None


def _is_of(part: GroovePart, _: fem.Discretisation, resolution: fem.Resolution, kept: Any) -> bool:
    """Whether a compliance from the cache is that of a part, as far as it says so."""
    stations = resolution.stations
    assert stations  # of every part with a groove
    same = (kept.groove, kept.width, kept.elastic) == (part.groove, stations.width, part.materials["ring"])
    return same and tuple(kept.angles) == stations.angles


def compliance(case: BallCase, race: Race, report: Report) -> Any:
    """Compliance of one groove for balls anywhere; None where its ring is rigid.

    Raises
    ------
    BadCase
        when the part cannot exist
    NotSolved
        when the finite elements find none
    """
    arguments = _arguments(case, race)
    if arguments is None:
        return None
    name = f"{race} ring"
    report.stage(name, None)
    try:
        return configured().cached(
            "GrooveCompliance",
            arguments,
            lambda: condense(*arguments),
            lambda note: report.stage(f"{name}: {note}", None),
            partial(_is_of, *arguments),
        )
    except fem.ImpossiblePart as problem:
        raise BadCase(f"{case.source.path}: {race} ring: {problem}") from problem
    except RingNotSolved as problem:
        raise NotSolved(f"{name}: {problem}", "not solved") from problem
