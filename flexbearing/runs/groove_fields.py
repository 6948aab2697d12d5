"""Stress, strain and displacement of elastic rings under the balls of one state."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

import fem
from fem.errors import NotSolved
from fem.parts.groove import BallPatches
from fem.parts.probe import Probe
from fem.parts.step_solid import StepSolid
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
from flexbearing.runs.part_fields import NAMES, NoFields, PartFields, Sizes, body_record, stress_record
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
        if isinstance(shape.part, StepSolid):
            return _record_of_solid(case, state, shape)
        section = _section(case, state, shape)
        clear = clearing(section.part, section.patches, section.forces, section.radius)
        names = ("ring",) if on_bars else tuple(section.part.materials)
        bodies = {name: body_record(extremes(section, name, clear)) for name in names}
    turning = on_bars and case.operation.outer_speed != 0
    left_out = ", ".join(["where bars begin"] * on_bars + ["rotation"] * turning)
    return stress_record(bodies, "balls", section.surroundings, left_out) | {
        "seconds": perf_counter() - began
    }


def _record_of_solid(case: FastCase, state: AngularContactState, shape: GrooveShape) -> dict[str, Any]:
    """Largest values of a drawn ring under the balls of a state."""
    began, (part, _, resolution) = perf_counter(), arguments_of(case, shape)
    sizes = of_two_orders(resolution.mesh)
    fields = PartFields(
        race=shape.race, state="flexible", part=part,
        patches=_patches(case, state, shape), forces=_forces(case, state, shape),
        sizes=Sizes(solid=sizes, stresses=sizes, coarseness=1.0, threads=resolution.threads),
        surroundings=Surroundings(), left_out="",
    )  # fmt: skip
    bodies = {name: body_record(most) for name, most in fields.extremes.items()}
    return stress_record(bodies, "balls", fields.surroundings, "") | {"seconds": perf_counter() - began}


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
    around = Surroundings() if isinstance(part, fem.SquirrelCage) else surroundings(case, shape.race)
    loads = _patches(case, state, shape), _forces(case, state, shape)
    return loaded_section(part, *loads, of_two_orders(resolution.mesh), around)


def _patches(case: FastCase, state: AngularContactState, shape: GrooveShape) -> BallPatches:
    """Where the balls of a state load a ring."""
    azimuths, stations = tuple(state.bearing.azimuths), stations_of(case, shape)
    return BallPatches(azimuths=azimuths, length=shape.length, stations=stations)


def _forces(case: FastCase, state: AngularContactState, shape: GrooveShape) -> NDArray:
    """What they press on its stations (Z, K) [N], positive outward."""
    both = BallState.of(state, np.array([stations_of(case, shape).angles] * 2)).forces
    return OUTWARD[shape.race] * both[RACES.index(shape.race)]


@contextmanager
def _solving(race: Race) -> Iterator[None]:
    try:
        yield
    except (fem.ImpossiblePart, NotSolved) as problem:
        raise NoFields(f"{NAMES[race]}: {problem}") from problem
