"""Parts of a case, condensed to their stiffness at the rollers, or taken from the cache."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from time import perf_counter
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import fem
from fem.condense import SOLID
from fem.errors import NotSolved
from flexbearing.build.bonded_growth import bonded_shape
from flexbearing.build.ring_parts import NAMES, Race, part_of
from flexbearing.build.seat_growth import seat_growth, seat_strain
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.coupling import LinearPair, PartnerFailed, RacewayPair
from flexbearing.progress import Report
from flexbearing.rings.fits import RacewayInFit, inner_ring_in_fit, is_in_fit, outer_ring_in_housing
from flexbearing.rings.raceways import CondensedRaceway, RigidRaceway, with_axial_modes
from flexbearing.rings.resolution import discretisation_of, resolved
from flexbearing.rings.stored import Ahead, condensed_part
from flexbearing.rings.supported import FIGURES, RINGS, SupportedRaceway, is_on_supports

if TYPE_CHECKING:
    from fem.raceway.compliance import RacewayCompliance
    from fem.raceway.growth import RacewayGrowth
    from flexbearing.build.ring_parts import Part

RACES: tuple[Race, Race] = ("inner", "outer")


def condensed_raceways(
    case: Case, azimuths: NDArray, report: Report, outer_ahead: Ahead = None
) -> RacewayPair:
    """Both raceways of a case, as `raceway` makes them."""
    inner = raceway(case, "inner", azimuths, report)
    return RacewayPair(inner, raceway(case, "outer", azimuths, report, outer_ahead))


def raceway(
    case: Case, race: Race, azimuths: NDArray, report: Report, ahead: Ahead = None
) -> RigidRaceway | CondensedRaceway | RacewayInFit | SupportedRaceway:
    """What carries one raceway: rigid, condensed, a ring in its fit or one on its supports."""
    part = part_of(case, race)
    if part is None:
        return RigidRaceway(azimuths)
    if race == "outer" and is_on_supports(case):
        with named_failures(case, NAMES[race]):
            return on_supports(resolved(part, case, azimuths), case, azimuths, report)
    if not is_in_fit(case, race):
        began, name = perf_counter(), NAMES[race]
        report.stage(name, None)
        with named_failures(case, name):
            linear: Any = condensed(name, part, case, azimuths, report, ahead)  # not on lines or springs
            growth = _Growth.of(case, race, report)
            compliance = growth.added(linear.at(azimuths))

        def at(places: NDArray) -> "RacewayCompliance":
            with named_failures(case, name):
                solid = discretisation_of(part, case) is SOLID  # which knows its own rollers only
                anew: Any = condensed(name, part, case, places, report) if solid else linear
                return growth.added(anew.at(places))

        report.stage(f"{name}: {compliance.unknowns} unknowns, {perf_counter() - began:.1f} s", None)
        return CondensedRaceway(compliance, at, growth.figures)
    name = {"inner": "inner ring and shaft", "outer": "outer ring and housing"}[race]
    report.stage({"inner": "inner ring in its fit", "outer": "outer ring in its housing"}[race], None)
    with named_failures(case, name):
        if isinstance(part, fem.RingOnShaft):
            fitted = inner_ring_in_fit(case, part, azimuths)
        else:
            assert isinstance(part, fem.OuterRing)  # or the case would not have been read
            fitted = outer_ring_in_housing(case, part, azimuths)
        report.stage(f"{name}: about {fitted.fit.interface.unknowns} unknowns in the fit", None)
        return fitted


def is_linear(case: Case) -> bool:
    """Whether the raceways of a case answer linearly: no fit that may open, no one-sided support."""
    if case.coupling.structure == "full" or is_on_supports(case):
        return False
    return not any(is_in_fit(case, race) and part_of(case, race) is not None for race in RACES)


def linear_raceways(
    cases: Mapping[Race, Sequence[Case | None]], azimuths: NDArray, axial_modes: int, report: Report
) -> list[LinearPair]:
    """Raceways of cases that share their parts, `accuracy` and rollers, and answer linearly."""
    inner, outer = (_linear_raceways(cases[race], race, azimuths, axial_modes, report) for race in RACES)
    return [LinearPair(*pair) for pair in zip(inner, outer, strict=True)]


def with_growth(
    raceway: "RacewayCompliance", case: Case, race: Race, report: Report, sign: float = 1.0
) -> "RacewayCompliance":
    """A raceway that no fit holds with the shape that grows in a case, or without it."""
    if race == "outer" and is_on_supports(case):
        return raceway
    nothing = replace(raceway, initial_deviation=np.zeros_like(raceway.initial_deviation))
    shape = _Growth.of(case, race, report).added(nothing).initial_deviation
    return replace(raceway, initial_deviation=raceway.initial_deviation + sign * shape)


def _linear_raceways(
    cases: Sequence[Case | None], race: Race, azimuths: NDArray, axial_modes: int, report: Report
) -> "list[RacewayCompliance | None]":
    first, name = cases[0], NAMES[race]
    part = None if first is None else part_of(first, race)
    if first is None or part is None:
        return [None] * len(cases)
    with named_failures(first, name):
        linear: Any = condensed(name, part, first, azimuths, report)  # not on lines or springs
        compliance = linear.at(azimuths)
        grown = (case and _Growth.of(case, race, report).added(compliance) for case in cases)
        return [each and with_axial_modes(each, axial_modes) for each in grown]


def on_supports(
    arguments: "tuple[Part, fem.Discretisation, fem.Resolution]",
    case: Case,
    azimuths: NDArray,
    report: Report,
) -> SupportedRaceway:
    """The outer ring on lines or springs."""
    part, discretisation, resolution = arguments
    assert isinstance(part, fem.OuterRing)  # or nothing would support it so
    began, support, name = perf_counter(), part.support, NAMES["outer"]
    assert isinstance(support, fem.LineSupports | fem.Foundation)
    report.stage(name, None)
    if isinstance(support, fem.Foundation):  # with the answers of its outer surface
        part = replace(part, support=replace(support, pushing=True))
    supported: Any = condensed_part(name, (part, discretisation, resolution), report)  # on lines or springs

    def under_rollers(places: NDArray) -> Any:
        ring = supported.under_rollers(places)
        return ring if support.pushing else replace(ring, pushing=False)

    ring = under_rollers(azimuths)
    report.stage(f"{name}: {perf_counter() - began:.1f} s", None)
    name, figures = RINGS[case.outer.support], FIGURES[case.outer.support]
    return SupportedRaceway(name, ring, figures, under_rollers)


@dataclass(frozen=True)
class _Growth:
    """Shape that heat, speed and pressing give a raceway; its mean belongs to the operating clearance."""

    by_seat: "RacewayGrowth | None" = None  # of an outer ring
    strain: float = 0.0  # of that seat beyond the ring
    shape: NDArray | None = None  # (M,) [m] of a bonded inner ring

    @classmethod
    def of(cls, case: Case, race: Race, report: Report) -> "_Growth":
        def note(text: str) -> None:
            report.stage(f"growth: {text}", None)

        if race == "inner":  # a beam is without a mesh, and without a shape along the roller
            return cls() if case.accuracy.structure == "beam" else cls(shape=bonded_shape(case, note))
        return cls(by_seat=seat_growth(case, note), strain=seat_strain(case))

    def added(self, compliance: "RacewayCompliance") -> "RacewayCompliance":
        """A raceway with this shape where no roller loads it."""
        deviation = compliance.initial_deviation.copy()
        if self.by_seat is not None:
            deviation += self.strain * self.by_seat.at(compliance.azimuths)
        if self.shape is not None:
            deviation[:, 1:] += self.shape[1:]
        return replace(compliance, initial_deviation=deviation)

    @property
    def figures(self) -> dict[str, dict[str, float]]:
        """Of a seat: growth in the mean, and from the -x to the +x end of the rollers."""
        if self.by_seat is None:
            return {}
        coned = 2 * self.strain * float(self.by_seat.coefficients[0, 1])
        mean = 1e6 * self.strain * self.by_seat.mean
        return {"seat": {"mean_growth_um": mean, "coned_um": 1e6 * coned}}


@contextmanager
def named_failures(case: Case, name: str) -> Iterator[None]:
    """Turn failures of the finite elements into those of a case and of a partner, with the part's name.

    Raises `BadCase` when no such part can exist; `PartnerFailed` when the finite elements found no solution,
    or no room for it.
    """
    try:
        yield
    except fem.ImpossiblePart as problem:
        raise BadCase(f"{case.source.path}: {name}: {problem}") from problem
    except NotSolved as problem:
        raise PartnerFailed(f"{name}: {problem}", "not solved") from problem
    except MemoryError as problem:
        words = f"{name}: there is not enough memory for its elements; fewer and larger ones take less"
        raise PartnerFailed(words, "not solved") from problem


def condensed(
    name: str, part: "Part", case: Case, azimuths: NDArray, report: Report, ahead: Ahead = None
) -> Any:
    """Raceway compliance of a part, from the cache where it is kept."""
    return condensed_part(name, resolved(part, case, azimuths), report, ahead)
