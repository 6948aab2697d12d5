"""From a case to the fields of its rings: which parts, under which loads, on which elements."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

import fem
from fem.parts.surroundings import Surroundings
from flexbearing.build import expansion, ring_parts, roller_bearing
from flexbearing.build.expansion import roller_length
from flexbearing.build.mesh_sizes import IN_SPACE, mesh_size, nodes_of
from flexbearing.case.roller import Case
from flexbearing.program.threads import of_solids
from flexbearing.rings.resolution import patches
from flexbearing.runs.part_fields import MEGA, NAMES, NoFields, PartFields, Race, Sizes
from quasidynamic.contact.line import Slices

if TYPE_CHECKING:
    from flexbearing.build.groove_parts import BallCase
    from flexbearing.case.balls.angular_contact import FastCase

Arrays = Mapping[str, Any]  # name to array

# Order and sizes of elements over the roller length: of whole solids, which are drawn and give the stiffness
# of supports, and of the meshes for stresses, on a section or of half a pitch.
WITHOUT_BARS = (3, 1.2, 0.4)
FOR_STRESSES = {fem.OuterRing: (6, 0.6, 0.2), fem.RingOnShaft: (6, 0.6, 0.2), fem.SquirrelCage: (5, 0.6, 0.4)}


def values(case: Case | BallCase, stresses: Mapping[Any, dict[str, Any]]) -> dict[str, dict[str, Any]]:
    """Largest von Mises stress of each body of each part and its yield stress [Pa], for findings."""
    found: dict[str, dict[str, Any]] = {"stress": {}, "yield_stress": {}}
    for race, record in stresses.items():
        for body, most in record["bodies"].items():
            material = expansion.material(case, body if body in ("shaft", "housing") else f"{race}_ring")
            place = f"{race}: {body} (von Mises)"
            found["stress"][place] = MEGA * most["von_mises_MPa"]
            found["yield_stress"][place] = getattr(material, "yield_stress", None)  # not of every material
    return found


def parts(case: Case) -> dict[Race, Any]:
    """Parts of a case that are flexible.

    Raises `NoFields` if a part cannot be built.
    """
    try:
        both: dict[Race, Any] = {"inner": ring_parts.inner_part(case), "outer": ring_parts.outer_part(case)}
    except fem.ImpossiblePart as problem:
        raise NoFields(str(problem)) from problem
    return {race: part for race, part in both.items() if part is not None}


def fields(case: Case, race: Race, state: str, values: Arrays) -> PartFields:
    """A part under the roller loads of a state; it is solved for what is asked of it.

    Raises `NoFields` of a part that is computed on its section only.

    Valid
    -----
    Normal loads only: tractions of the rollers, about a hundredth of them, do not load the part.
    """
    if words := ring_parts.why_no_solid(case, race):
        raise NoFields(f"{NAMES[race]}: {words}")
    azimuths = values.get("roller_azimuth")  # iterations have none: their rollers stand where the case says
    azimuths = roller_bearing.parts(case).azimuths if azimuths is None else azimuths
    part, loads = parts(case)[race], patches(case, azimuths)
    plain = isinstance(part, fem.OuterRing | fem.RingOnShaft)
    usual = FOR_STRESSES[type(part)] if plain or isinstance(part, fem.SquirrelCage) else IN_SPACE
    sizes = Sizes(
        solid=mesh_size(case, WITHOUT_BARS if plain else IN_SPACE),
        stresses=(stresses := of_two_orders(mesh_size(case, usual))),
        coarseness=stresses.size / (usual[1] * roller_length(case.nodes_of or case)),
        threads=of_solids(case.accuracy.threads),
    )
    turning = case.operation.outer_speed != 0 and not plain and race == "outer"
    return PartFields(
        race=race, state=state, part=part, patches=loads,
        forces=forces(values[f"{race}_slice_load"], race, loads.length, loads.axial_modes),
        sizes=sizes, surroundings=surroundings(case, race) if plain else Surroundings(),
        left_out="rotation" if turning else "", nodes_of=nodes_of(case, race),
    )  # fmt: skip


def of_two_orders(sizes: fem.MeshSize) -> fem.MeshSize:
    """Sizes whose order has a useful one below it."""
    return replace(sizes, order=max(sizes.order, 3))


def surroundings(case: Case | FastCase, race: Race) -> Surroundings:
    """Heat and rotation of a ring with its shaft or housing.

    Its bodies are meshed as warm as the ring: what counts is by how much the other body grows more.
    """
    ring, mate, name = (
        ("inner_ring", "shaft", "shaft") if race == "inner" else ("outer_ring", "housing", "housing")
    )
    hot = {body: expansion.hot_over_cold(case, body) for body in (ring, mate)}
    materials = {"ring": expansion.material(case, ring), name: expansion.material(case, mate)}
    densities = {body: getattr(material, "density", None) for body, material in materials.items()}
    speed = case.operation.inner_speed if race == "inner" else case.operation.outer_speed
    return Surroundings(
        thermal_strains={"ring": 0.0, name: hot[mate] / hot[ring] - 1},
        densities={body: density for body, density in densities.items() if density is not None},
        speed=speed,
    )


def forces(slice_loads: NDArray, race: Race, length: float, shapes: int) -> NDArray:
    """Generalised forces on a raceway."""
    outward = slice_loads @ Slices(slice_loads.shape[1], length, shapes).weights
    return outward if race == "outer" else -outward
