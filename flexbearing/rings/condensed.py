"""Rings of a case, meshed and condensed, or taken from the cache."""

from collections.abc import Iterator
from contextlib import contextmanager
from time import perf_counter
from typing import TYPE_CHECKING

from numpy.typing import NDArray

import fem
from fem.condense import BEAM, HARMONICS, SMEARED, SOLID, condense
from fem.errors import NotSolved
from fem.parts.step_solid import StepSolid
from flexbearing.build import expansion, ring_parts
from flexbearing.cache import configured
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.coupling import PartnerFailed
from flexbearing.progress import Report
from flexbearing.rings.fitted import FittedRings, fit_of
from flexbearing.rings.housed import HousedRings, housing_fit
from flexbearing.rings.raceways import CondensedRings

if TYPE_CHECKING:
    from fem.joint.preloaded_fit import PreloadedFit
    from fem.raceway.compliance import RacewayCompliance

Rings = CondensedRings | FittedRings | HousedRings

# Order, and sizes of elements over the roller length: 0.1 % and 0.5 % of the largest compliance.
ON_A_SECTION, IN_SPACE = (5, 1.2, 0.25), (3, 0.6, 0.4)
WITH_A_SLEEVE = (3, 1.2, 0.4)  # smeared bars are worth no more
PATCH = 0.1  # width of a load patch over the roller length


def condensed(case: Case, azimuths: NDArray, report: Report) -> Rings:
    """Mesh, factor and condense the parts that are not rigid; nothing happens for those that are.

    Raises
    ------
    PartnerFailed
        when a part has no trustworthy answer
    """
    outer = outer_ring(case, azimuths, report)
    return side_by_side(inner_ring(case, azimuths, report), outer, azimuths)


def outer_ring(case: Case, azimuths: NDArray, report: Report) -> "RacewayCompliance | PreloadedFit | None":
    """Condense the part around the rollers, or put it in its housing; raises as `condensed`."""
    part = ring_parts.outer_part(case)
    if isinstance(part, fem.OuterRing) and case.outer.lifts_off:
        report.stage("outer ring in its housing", None)
        with told(case, "outer ring and housing"):
            return housing_fit(case, part, expansion.roller_length(case), wishes(case, ON_A_SECTION))
    return _condensed("outer ring", part, case, azimuths, report)


def inner_ring(case: Case, azimuths: NDArray, report: Report) -> "RacewayCompliance | PreloadedFit | None":
    """Condense the part inside the rollers, or settle it in its fit; raises as `condensed`."""
    shaft = ring_parts.inner_part(case)
    if shaft is not None and case.inner.fit != "bonded":
        report.stage("inner ring in its fit", None)
        with told(case, "inner ring and shaft"):
            mesh, length = wishes(case, ON_A_SECTION), expansion.roller_length(case)
            return fit_of(case, shaft, length, mesh)
    return _condensed("inner ring and shaft", shaft, case, azimuths, report)


def side_by_side(
    inner: "RacewayCompliance | PreloadedFit | None",
    outer: "RacewayCompliance | PreloadedFit | None",
    azimuths: NDArray,
) -> Rings:
    """Both parts as one partner of the coupling."""
    if outer is not None and not hasattr(outer, "absolute"):
        beside = side_by_side(inner, None, azimuths)
        return HousedRings(outer, azimuths, beside)  # pyright: ignore[reportArgumentType]
    if inner is None or hasattr(inner, "absolute"):
        return CondensedRings((inner, outer))  # pyright: ignore[reportArgumentType]
    return FittedRings(inner, azimuths, outer)  # pyright: ignore[reportArgumentType]


def _condensed(name: str, part: ring_parts.Part | None, case: Case, azimuths: NDArray, report: Report):
    if part is None:
        return None
    began = perf_counter()
    report.stage(name, None)
    with told(case, name):
        raceway = _computed_or_kept(name, part, case, azimuths, report).at(azimuths)
    report.stage(f"{name}: {raceway.unknowns} unknowns, {perf_counter() - began:.1f} s", None)
    return raceway


@contextmanager
def told(case: Case, name: str) -> Iterator[None]:
    """Give failures of the finite elements the names that users and coupling know.

    Raises
    ------
    BadCase
        when no such part can exist
    PartnerFailed
        when the finite elements found no solution
    """
    try:
        yield
    except fem.ImpossiblePart as problem:
        raise BadCase(f"{case.source.path}: {name}: {problem}") from problem
    except NotSolved as problem:
        raise PartnerFailed(f"{name}: {problem}", "not solved") from problem


def _computed_or_kept(name: str, part: ring_parts.Part, case: Case, azimuths: NDArray, report: Report):
    """Raceway compliance, from the cache where it is kept."""
    discretisation = _discretisation(part, case)
    solid = discretisation is SOLID
    asked = part, discretisation, _resolution(part, discretisation, case, azimuths)

    def computed():
        return condense(*asked, report=lambda stage, fraction: report.stage(f"{name}: {stage}", fraction))

    on_lines = isinstance(part, fem.OuterRing) and case.outer.support in ("lines", "planet")
    if discretisation is BEAM or (on_lines and not solid):  # sooner computed than read, or more than is kept
        return condense(*asked)
    return configured().cached(
        asked,
        computed if solid else lambda: condense(*asked),
        lambda note: report.stage(f"{name}: {note}", None),
    )


def _discretisation(part: ring_parts.Part, case: Case) -> fem.Discretisation:
    """Choice of the case, or what suits the part."""
    if case.accuracy.structure == "solid" or isinstance(part, StepSolid):
        return SOLID
    if case.accuracy.structure == "beam":
        return BEAM
    if case.accuracy.structure == "smeared" and isinstance(part, fem.SquirrelCage):
        return SMEARED
    return HARMONICS


def _resolution(
    part: ring_parts.Part, discretisation: fem.Discretisation, case: Case, azimuths: NDArray
) -> fem.Resolution:
    in_space = discretisation is SOLID or isinstance(part, fem.SquirrelCage)
    sizes = WITH_A_SLEEVE if discretisation is SMEARED else IN_SPACE if in_space else ON_A_SECTION
    loads = patches(case, azimuths)
    rollers = {"azimuths": loads.azimuths, "patch_width": loads.width} if discretisation is SOLID else {}
    return fem.Resolution(
        length=loads.length,
        axial_modes=loads.axial_modes,
        mesh_size=wishes(case, sizes),
        harmonics=None if discretisation is SOLID else case.accuracy.harmonics,
        threads=case.accuracy.threads,
        **rollers,
    )


def patches(case: Case, azimuths: NDArray) -> fem.Patches:
    """What rollers do to a full solid."""
    length = expansion.roller_length(case)
    return fem.Patches(
        azimuths=tuple(azimuths),
        length=length,
        axial_modes=case.accuracy.axial_shapes,
        width=case.accuracy.patch_width or PATCH * length,
    )


def wishes(case: Case, usual: tuple[int, float, float]) -> fem.MeshSize:
    """Order and sizes of elements: those of the case, else the usual ones in roller lengths."""
    order, size, raceway_size = usual
    given, length = case.accuracy, expansion.roller_length(case)
    return fem.MeshSize(
        order=given.element_order or order,
        size=given.mesh_size or size * length,
        raceway_size=given.raceway_mesh_size or raceway_size * length,
    )
