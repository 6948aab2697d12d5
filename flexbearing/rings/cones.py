"""Elastic rings under tapered rollers: their parts, condensed to the compliance of conical raceways."""

from collections.abc import Iterator
from contextlib import contextmanager
from math import cos
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

import fem
from fem.condense import HARMONICS
from fem.errors import NotSolved as RingNotSolved
from fem.mesh.axial_section import require_affordable_section, sections
from flexbearing.build import held_ring
from flexbearing.case import BadCase
from flexbearing.case.materials import Elastic
from flexbearing.case.quantity import require
from flexbearing.case.tapered import TaperedCase
from flexbearing.progress import Report
from flexbearing.rings.stored import Arguments, condensed_part
from quasidynamic import NotSolved

if TYPE_CHECKING:
    from flexbearing.build.ring_parts import Race

RACES: "tuple[Race, Race]" = ("inner", "outer")
ON_A_SECTION = (1.2, 0.25)  # element sizes over the roller length, as under cylindrical rollers

Raceways = tuple[NDArray | None, NDArray | None]


def raceways(case: TaperedCase, azimuths: NDArray, report: Report) -> Raceways:
    """Compliance of both raceways under rollers at azimuths (Z) [rad], as `tapered_loads` takes it.

    Rows of a pair are in one ring, or each has an outer ring of its own, the mirror image of the other.

    Raises `BadCase` when a part cannot exist; `NotSolved` when the finite elements find none.
    """
    inner, outer = (_raceway(case, race, azimuths, report) for race in RACES)
    return inner, outer


def _raceway(case: TaperedCase, race: "Race", azimuths: NDArray, report: Report) -> NDArray | None:
    arguments = arguments_of(case, race)
    if arguments is None:
        return None
    name = f"{race} ring"
    report.stage(name, None)
    of_row, pair = azimuths[: case.bearing.rollers], case.bearing.pair
    along = race == "inner"  # for the load on its rib
    with _named(case, race):
        ring = condensed_part(name, arguments, report)
        if pair and _in_one_ring(case, race):
            large_end = np.repeat([-1, 1] if pair.arrangement == "back_to_back" else [1, -1], len(of_row))
            return towards_large_end(ring.at(azimuths).absolute, large_end, along)
        own = ring.at(of_row).repeated(len(azimuths) // len(of_row)).absolute
        return towards_large_end(own, np.full(len(azimuths), -1), along)


def towards_large_end(compliance: NDArray, large_end: NDArray, along: bool) -> NDArray:
    """A compliance (Z, M, Z, M) in shapes along x in those towards the large ends, at a sign of x (Z).

    The last shape may be one along the raceway of an inner ring, into which normals point that are outward.
    """
    sign = large_end[:, None] ** np.arange(compliance.shape[1])
    if along:
        sign[:, -1] = -large_end
    return compliance * sign[..., None, None] * sign


def _in_one_ring(case: TaperedCase, race: "Race") -> bool:
    """Whether both rows of a pair are in one elastic ring."""
    return case.bearing.pair is not None and (race == "inner" or case.outer.common)


def parts(case: TaperedCase) -> tuple[Arguments | None, Arguments | None]:
    """What decides the elastic rings of a case, inner and outer; None where a ring is rigid.

    Raises `BadCase` when no such part can exist, or its elements are too small.
    """
    inner, outer = (arguments_of(case, race) for race in RACES)
    for race, arguments in zip(RACES, (inner, outer), strict=True):
        if arguments:
            part, _, resolution = arguments
            try:
                require_affordable_section(
                    sections(part, resolution.length, resolution.rows), resolution.mesh
                )
            except RingNotSolved as problem:
                raise BadCase(
                    f"{case.source.path}: [accuracy] mesh_size: {race} ring: {problem}"
                ) from problem
    return inner, outer


def arguments_of(case: TaperedCase, race: "Race") -> Arguments | None:
    """What decides an elastic ring of a case; None of a rigid one."""
    if getattr(case, race).kind == "rigid":
        return None
    with _named(case, race):
        part = _outer(case) if race == "outer" else _inner(case)
    accuracy, length = case.accuracy, case.bearing.roller.length
    size, raceway_size = (share * length for share in ON_A_SECTION)
    return (
        part,
        HARMONICS,
        fem.Resolution(
            length=length * cos(part.taper),
            axial_modes=accuracy.axial_shapes,
            mesh_size=fem.MeshSize(
                order=accuracy.element_order,
                size=accuracy.mesh_size or size,
                raceway_size=accuracy.raceway_mesh_size or raceway_size,
            ),
            row_distance=part.row_distance,
            along=race == "inner",
        ),
    )


def _outer(case: TaperedCase) -> fem.OuterRing:
    outer, housing = case.outer, case.materials.housing
    thickness, width = require(outer, ("thickness", "width"), 'outer.kind = "ring"')
    taper, apart = _cones(case, "outer", case.bearing.cup_angle)
    return fem.OuterRing(
        raceway_diameter=2 * case.bearing.raceway_middle("outer"),
        thickness=thickness,
        width=width,
        elastic=_elastic(case.materials.outer_ring),
        support=held_ring.support(outer, housing and _elastic(housing)),
        offset=outer.raceway_offset,
        taper=taper,
        row_distance=apart,
    )


def _inner(case: TaperedCase) -> fem.RingOnShaft:
    inner, shaft = case.inner, case.materials.shaft
    bore, width, length = require(inner, ("bore", "width", "shaft_length"), 'inner.kind = "ring_on_shaft"')
    assert shaft  # checked on reading
    taper, apart = _cones(case, "inner", case.bearing.angles[1])
    return fem.RingOnShaft(
        raceway_diameter=2 * case.bearing.raceway_middle("inner"),
        track_width=width,
        rib_diameter=None,
        bore=bore,
        width=width,
        shaft_bore=inner.shaft_bore,
        shaft_length=length,
        ring=_elastic(case.materials.inner_ring),
        shaft=_elastic(shaft),
        taper=taper,
        row_distance=apart,
    )


def _cones(case: TaperedCase, race: "Race", angle: float) -> tuple[float, float]:
    """Angle of a raceway [rad], of two of that at -x, and their distance [m]; they widen to large ends."""
    pair = case.bearing.pair
    if pair is None or not _in_one_ring(case, race):
        return -angle, 0.0
    return -angle if pair.arrangement == "back_to_back" else angle, case.bearing.row_distance(race)


def _elastic(material: Elastic) -> fem.Elastic:
    return fem.Elastic(youngs_modulus=material.youngs_modulus, poisson_ratio=material.poisson_ratio)


@contextmanager
def _named(case: TaperedCase, race: "Race") -> Iterator[None]:
    """Turn failures of the finite elements into those of a case or of a solve, with the name of the ring."""
    try:
        yield
    except fem.ImpossiblePart as problem:
        raise BadCase(f"{case.source.path}: {race} ring: {problem}") from problem
    except RingNotSolved as problem:
        raise NotSolved(f"{race} ring: {problem}", "not solved") from problem
