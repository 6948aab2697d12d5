"""What a roller case leaves open to the accuracy requested: one ladder of levels for each choice.

`accuracy.target` climbs these ladders until the estimated error is small enough; `flexbearing pareto` runs a
case on their levels.
"""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple

import fem
from fem.parts.step_solid import StepSolid
from flexbearing.accuracy.case_levels import (
    ABOVE,
    BELOW,
    WEIGHT,
    Cost,
    Ladder,
    Settings,
    counted,
    fixed,
    given,
)
from flexbearing.accuracy.ladder import Choice
from flexbearing.build.expansion import roller_length
from flexbearing.build.mesh_sizes import IN_SPACE, ON_A_SECTION
from flexbearing.build.ring_parts import NAMES, Race, part_of
from flexbearing.case.ratings import FEWEST_SLICES
from flexbearing.case.roller import Case
from flexbearing.case.roller.numerics import AXIAL_MODES, MORE_SHAPES
from flexbearing.rings.fits import is_in_fit

if TYPE_CHECKING:
    from flexbearing.build.ring_parts import Part


class MeshLevel(NamedTuple):
    """A mesh by its elements."""

    order: int
    size: float  # over the roller length
    raceway_size: float  # over the roller length


SLICES = (5, 10, 20, 40, 80, 160, 320, 640, 1280)  # the last only measures
ON_SECTIONS = (
    MeshLevel(2, 1.2, 0.5), MeshLevel(3, 1.2, 0.4), MeshLevel(4, 1.2, 0.3), MeshLevel(5, 1.2, 0.25),
    MeshLevel(6, 0.8, 0.2), MeshLevel(8, 0.6, 0.15),
)  # fmt: skip
ON_HALF_A_PITCH = tuple(MeshLevel(order, 0.6, 0.4) for order in (2, 3, 4, 5))
ON_SOLIDS = tuple(MeshLevel(order, 0.6, 0.4) for order in (2, 3, 4))

FEWEST_FOR_A_TARGET = 10  # slices: below, the error does not fall as the estimate assumes
MESH_KEYS = ("element_order", "mesh_size", "raceway_mesh_size")
FEWEST, MORE = 22, 1.5  # harmonics that the coarsest raceway resolves at least, and their growth by level
FEWEST_OF_A_FIT = 37  # which has 36 of its own
PER_MODE = 6.0  # harmonics for each axial mode on an arc as long as the radius
PER_ORDER = 0.6  # harmonics for each order and element on an arc as long as the radius


def mesh_levels(case: Case, part: "Part") -> tuple[MeshLevel, ...]:
    """Meshes of a part from coarse to fine, by its discretisation."""
    if case.accuracy.structure == "solid" or isinstance(part, StepSolid):
        return ON_SOLIDS
    return ON_HALF_A_PITCH if isinstance(part, fem.SquirrelCage) else ON_SECTIONS


def ladders(case: Case) -> tuple[Ladder, ...]:
    """Everything that can be resolved more or less finely, the cheapest first."""
    parts: dict[Race, Part] = {race: part for race in NAMES if (part := part_of(case, race)) is not None}
    choices = [_slices(case), _axial_modes(case, parts), *_harmonics(case)]
    choices += [_part(case, race, part) for race, part in parts.items()]
    return tuple(sorted(choices, key=lambda ladder: ladder.cost))


def _slices(case: Case) -> Ladder:
    """Slices double: what sharp ends of the line load leave falls as (log K) / K."""
    if given(case, "slices"):
        return fixed("slices", "slices", tuple(n * case.accuracy.slices for n in (1, 2, 4)))
    least = max(FEWEST_FOR_A_TARGET, FEWEST_SLICES if case.life.edge_stress else 0)
    return counted("slices", "slices", tuple(n for n in SLICES if n >= least))


def _axial_modes(case: Case, parts: "Mapping[Race, Part]") -> Ladder:
    """Axial modes come two at a time. A raceway with few of them has too few harmonics for a fit."""
    if given(case, "axial_shapes"):
        modes = tuple(case.accuracy.axial_shapes + more for more in range(0, MORE_SHAPES + 1, 2))
        return fixed("axial shapes", "axial_shapes", modes)
    in_fits = [part.raceway_diameter / 2 for race, part in parts.items() if is_in_fit(case, race)]
    least = FEWEST_OF_A_FIT * roller_length(case) / (PER_MODE * min(in_fits)) if in_fits else 0
    return counted("axial shapes", "axial_shapes", tuple(n for n in AXIAL_MODES if n >= least))


def _harmonics(case: Case) -> Iterator[Ladder]:
    """Harmonics are those that a mesh resolves, a level of the part; unless the case says how many."""
    if fixed_by := given(case, "harmonics"):
        counts = (case.accuracy.harmonics, None)
        choice = Choice(
            name="harmonics",
            levels=(f"{counts[0]}", "as many as the mesh resolves"),
            weight=WEIGHT[Cost.BEARING],
            last=0,
            fixed_by=fixed_by,
            above=ABOVE[Cost.BEARING],
        )
        yield Ladder(choice, tuple({"harmonics": n} for n in counts))


def _part(case: Case, race: Race, part: "Part") -> Ladder:
    """Rigid, then finer and finer; a mesh or structure that the case gives is only measured."""
    meshes, last, of_mesh = mesh_levels(case, part), None, given(case, *MESH_KEYS)
    fixed_by = of_mesh if case.accuracy.structure in ("harmonics", "solid") else (*of_mesh, "structure")
    if fixed_by:
        usual, _, _ = ON_A_SECTION if meshes is ON_SECTIONS else IN_SPACE
        order = (case.accuracy.element_order or usual) + bool(of_mesh)
        structure = "solid" if meshes is ON_SOLIDS else "harmonics"
        settings, last = ({}, {"element_order": order, "structure": structure}), 1
        words = ("as given", f"{structure}, order {order}")
    else:
        fewest = FEWEST_OF_A_FIT if is_in_fit(case, race) else FEWEST
        settings = tuple(_settings(mesh, fewest * MORE**k, case, part) for k, mesh in enumerate(meshes))
        words = tuple(f"order {m.order}, {m.size:g} / {m.raceway_size:g} roller lengths" for m in meshes)
    of_meshes = {ON_SOLIDS: Cost.SOLID, ON_HALF_A_PITCH: Cost.CYCLIC, ON_SECTIONS: Cost.SECTION}
    cost = Cost.FIT if is_in_fit(case, race) else of_meshes[meshes]
    choice = Choice(
        name=NAMES[race],
        levels=("rigid", *words),
        weight=WEIGHT[cost],
        converging=1,
        last=last,
        fixed_by=fixed_by,
        above=ABOVE[cost],
        below=BELOW[cost],
    )
    return Ladder(choice, (None, *settings), race, cost)


def _settings(mesh: MeshLevel, harmonics: float, case: Case, part: "Part") -> Settings:
    """Settings of a level, its raceway so fine that it resolves at least so many harmonics."""
    length, radius = roller_length(case), part.raceway_diameter / 2
    coarsest = PER_ORDER * mesh.order * radius / harmonics
    sizes = mesh.order, mesh.size * length, min(mesh.raceway_size * length, coarsest)
    return dict(zip(MESH_KEYS, sizes, strict=True))
