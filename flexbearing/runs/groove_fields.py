"""Stress, strain and displacement of elastic rings under the balls of one state."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from time import perf_counter
from typing import Any

import numpy as np

import fem
from fem.errors import NotSolved
from fem.parts.groove import BallPatches
from fem.parts.probe import Probe
from fem.parts.surroundings import Surroundings
from fem.section.loaded_section import LoadedSection, loaded_section
from fem.solid import probes as solid
from fem.solid.clearing import clearing
from fem.solid.extremes import extremes
from fem.solid.probes import Readings
from flexbearing.build.groove_parts import why_no_solid
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.ring_room import OUTWARD, Race
from flexbearing.coupled.balls import BallState
from flexbearing.rings.grooves import RACES, GrooveShape, arguments_of, shape_of, stations_of
from flexbearing.runs import probes
from flexbearing.runs.fields import of_two_orders, surroundings
from flexbearing.runs.part_fields import NAMES, NoFields, body_record, stress_record
from quasidynamic import AngularContactState


def readings(case: FastCase, state: AngularContactState) -> Readings | str:
    """Readings of the probes of a case, or why there are none."""

    def read(race: Race, there: Sequence[Probe]) -> Readings:
        shape = shape_of(case, race)
        assert shape  # checked before anything was solved
        return readings_of_shape(case, state, shape, there)

    return probes.readings(case, read)


def stresses(case: FastCase, state: AngularContactState) -> dict[Race, dict[str, Any] | str]:
    """Largest stresses of the elastic rings of a case, or why there are none; by ring."""
    shapes: dict[Race, GrooveShape] = {race: shape for race in RACES if (shape := shape_of(case, race))}
    found: dict[Race, dict[str, Any] | str] = {}
    for race, shape in shapes.items():
        words = why_no_solid(case, race)
        try:
            found[race] = f"{NAMES[race]}: {words}" if words else _record(case, state, shape)
        except NoFields as problem:
            found[race] = str(problem)
    return found


def _record(case: FastCase, state: AngularContactState, shape: GrooveShape) -> dict[str, Any]:
    """Largest values of a ring under the balls of a state; of a cage those of the ring alone."""
    began, on_bars = perf_counter(), isinstance(shape.part, fem.SquirrelCage)
    with _solving(shape.race):
        section = _section(case, state, shape)
        clear = clearing(section.part, section.patches, section.forces, section.radius)
        names = ("ring",) if on_bars else tuple(section.part.materials)
        bodies = {name: body_record(extremes(section, name, clear)) for name in names}
    turning = on_bars and case.operation.outer_speed != 0
    left_out = ", ".join(["where bars begin"] * on_bars + ["rotation"] * turning)
    return stress_record(bodies, "balls", section.surroundings, left_out) | {
        "seconds": perf_counter() - began
    }


def readings_of_shape(
    case: FastCase, state: AngularContactState, shape: GrooveShape, there: Sequence[Probe]
) -> Readings:
    """Readings of a ring of some shape under the balls of a state.

    Raises `NoFields` where it is not solved, or has no material there.
    """
    with _solving(shape.race):
        section = _section(case, state, shape)
        return solid.readings(section, section.part, there, section.patches.width)


def _section(case: FastCase, state: AngularContactState, shape: GrooveShape) -> LoadedSection:
    """A ring of some shape under the balls of a state."""
    part, _, resolution = arguments_of(case, shape)
    stations, race = stations_of(case, shape), RACES.index(shape.race)
    forces = BallState.of(state, np.array([stations.angles] * 2)).forces[race]
    patches = BallPatches(azimuths=tuple(state.bearing.azimuths), length=resolution.length, stations=stations)
    around = Surroundings() if isinstance(part, fem.SquirrelCage) else surroundings(case, shape.race)
    return loaded_section(part, patches, OUTWARD[shape.race] * forces, of_two_orders(resolution.mesh), around)


@contextmanager
def _solving(race: Race) -> Iterator[None]:
    try:
        yield
    except (fem.ImpossiblePart, NotSolved) as problem:
        raise NoFields(f"{NAMES[race]}: {problem}") from problem
