"""Strain and displacement of elastic rings under the balls of one state."""

from collections.abc import Sequence

import numpy as np

import fem
from fem.errors import NotSolved
from fem.parts.groove import BallPatches
from fem.parts.probe import Probe
from fem.parts.surroundings import Surroundings
from fem.section.loaded_section import loaded_section
from fem.solid import probes as solid
from fem.solid.probes import Readings
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.ring_room import OUTWARD, Race
from flexbearing.coupled.balls import BallState
from flexbearing.rings.grooves import RACES, GrooveShape, arguments_of, shape_of, stations_of
from flexbearing.runs import probes
from flexbearing.runs.fields import of_two_orders, surroundings
from flexbearing.runs.part_fields import NAMES, NoFields
from quasidynamic import AngularContactState


def readings(case: FastCase, state: AngularContactState) -> Readings | str:
    """Readings of the probes of a case, or why there are none."""

    def read(race: Race, there: Sequence[Probe]) -> Readings:
        shape = shape_of(case, race)
        assert shape  # checked before anything was solved
        return readings_of_shape(case, state, shape, there)

    return probes.readings(case, read)


def readings_of_shape(
    case: FastCase, state: AngularContactState, shape: GrooveShape, there: Sequence[Probe]
) -> Readings:
    """Readings of a ring of some shape under the balls of a state.

    Raises `NoFields` where it is not solved, or has no material there.
    """
    part, _, resolution = arguments_of(case, shape)
    stations, race = stations_of(case, shape), RACES.index(shape.race)
    forces = BallState.of(state, np.array([stations.angles] * 2)).forces[race]
    patches = BallPatches(azimuths=tuple(state.bearing.azimuths), length=resolution.length, stations=stations)
    around = Surroundings() if isinstance(part, fem.SquirrelCage) else surroundings(case, shape.race)
    try:
        mesh = of_two_orders(resolution.mesh)
        section = loaded_section(part, patches, OUTWARD[shape.race] * forces, mesh, around)
        return solid.readings(section, part, there, patches.width)
    except (fem.ImpossiblePart, NotSolved) as problem:
        raise NoFields(f"{NAMES[shape.race]}: {problem}") from problem
