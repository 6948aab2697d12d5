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
from flexbearing.build.groove_parts import BallCase, why_no_solid
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.balls.ring_room import OUTWARD, Race
from flexbearing.coupled.balls import station_forces
from flexbearing.rings.grooves import RACES, GrooveShape, arguments_of, shape_of, stations_of
from flexbearing.runs import probes
from flexbearing.runs.fields import of_two_orders, surroundings
from flexbearing.runs.part_fields import NAMES, NoFields, PartFields, Sizes, body_record, stress_record
from quasidynamic import AngularContactState
from quasidynamic.solve.balls.load_distribution import BallLoads

State = AngularContactState | BallLoads


def readings(case: BallCase, state: State) -> Readings | str:
    """Readings of the probes of a case, or why there are none."""

    def read(race: Race, there: Sequence[Probe]) -> Readings:
        shape = shape_of(case, race)
        assert shape  # checked before anything was solved
        return readings_of_shape(case, state, shape, there)

    return probes.readings(case, read)


def stresses(case: BallCase, state: State) -> dict[Race, dict[str, Any] | str]:
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


def _record(case: BallCase, state: State, shape: GrooveShape) -> dict[str, Any]:
    """Largest values of a ring under the balls of a state; of a cage those of the ring alone."""
    began, on_bars = perf_counter(), isinstance(shape.part, fem.SquirrelCage)
    with _solving(shape.race):
        if isinstance(shape.part, StepSolid):
            return _record_of_solid(case, state, shape)
        section = _section(case, state, shape)
        clear = clearing(section.part, section.patches, section.forces, section.radius)
        names = ("ring",) if on_bars else tuple(section.part.materials)
        bodies = {name: body_record(extremes(section, name, clear)) for name in names}
    at_rest = on_bars or isinstance(case, FourPointCase)
    turning = at_rest and getattr(case.operation, f"{shape.race}_speed") != 0
    left_out = ", ".join(["where bars begin"] * on_bars + ["rotation"] * turning)
    return stress_record(bodies, "balls", section.surroundings, left_out) | {
        "seconds": perf_counter() - began
    }


def _record_of_solid(case: BallCase, state: State, shape: GrooveShape) -> dict[str, Any]:
    """Largest values of a drawn ring under the balls of a state."""
    began, (part, _, resolution) = perf_counter(), arguments_of(case, shape)
    (patches, forces), sizes = _loads(case, state, shape), of_two_orders(resolution.mesh)
    fields = PartFields(
        race=shape.race, state="flexible", part=part, patches=patches, forces=forces,
        sizes=Sizes(solid=sizes, stresses=sizes, coarseness=1.0, threads=resolution.threads),
        surroundings=Surroundings(), left_out="",
    )  # fmt: skip
    bodies = {name: body_record(most) for name, most in fields.extremes.items()}
    return stress_record(bodies, "balls", fields.surroundings, "") | {"seconds": perf_counter() - began}


def readings_of_shape(case: BallCase, state: State, shape: GrooveShape, there: Sequence[Probe]) -> Readings:
    """Readings of a ring of some shape under the balls of a state.

    Raises `NoFields` where it is not solved, or has no material there.
    """
    with _solving(shape.race):
        section = _section(case, state, shape)
        return solid.readings(section, section.part, there, section.patches.width)


def _section(case: BallCase, state: State, shape: GrooveShape) -> LoadedSection:
    """A ring of some shape under the balls of a state."""
    part, _, resolution = arguments_of(case, shape)
    around = Surroundings()
    if not (isinstance(case, FourPointCase) or isinstance(part, fem.SquirrelCage)):
        around = surroundings(case, shape.race)
    return loaded_section(part, *_loads(case, state, shape), of_two_orders(resolution.mesh), around)


def _loads(case: BallCase, state: State, shape: GrooveShape) -> tuple[BallPatches, NDArray]:
    """Where balls load a ring, and their forces on its stations (Z, A K) [N], positive outward."""
    azimuths, *contacts = _contacts(case, state, RACES.index(shape.race))
    stations = stations_of(case, shape)
    forces = OUTWARD[shape.race] * station_forces(np.array(stations.angles), *contacts)
    patches = BallPatches(azimuths=azimuths, length=shape.length, stations=stations)
    return patches, forces.reshape(len(azimuths), -1)


def _contacts(case: BallCase, state: State, race: int) -> tuple[tuple[float, ...], NDArray, NDArray, NDArray]:
    """Azimuths of Z balls, angles [rad], loads and forces along the section [N] of their contacts on a race.

    The latter are (Z), or (Z, G) on two diagonals.
    """
    if isinstance(state, BallLoads):
        assert isinstance(case, FourPointCase)
        angles, loads, along = (each[..., race] for each in (state.angles, state.loads, state.section_forces))
        return case.azimuths, angles, loads, along
    angles, loads, along = (each[race] for each in (state.contact_angles, state.loads, state.section_forces))
    return tuple(state.bearing.azimuths), angles, loads, along


@contextmanager
def _solving(race: Race) -> Iterator[None]:
    try:
        yield
    except (fem.ImpossiblePart, NotSolved) as problem:
        raise NoFields(f"{NAMES[race]}: {problem}") from problem
