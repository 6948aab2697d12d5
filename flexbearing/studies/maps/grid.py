"""Cases at the points of a map, as bearings between their rings."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product
from math import prod
from operator import attrgetter
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from flexbearing.build import ring_parts, roller_bearing
from flexbearing.build.expansion import roller_length
from flexbearing.case import BadCase
from flexbearing.case.as_written import rated_apart
from flexbearing.case.declarations import find
from flexbearing.case.roller import Case
from flexbearing.case.text import setting_value
from flexbearing.case.variants import Variants
from flexbearing.coupling import LinearPair, PartnerFailed
from flexbearing.families import FAMILIES
from flexbearing.progress import Report
from flexbearing.rings.condensed import RACES, is_linear, linear_raceways
from flexbearing.studies.maps.axes import MapAxis, with_numbers
from quasidynamic import ImpossiblePart, NotSolved, OutOfRange, RollerBearing
from quasidynamic.maps.points import GridPoints

# Keys that neither parts nor lubrication nor rings depend on.
LOADS = ("operation.radial_load", "operation.axial_load", "operation.moment", "operation.misalignment")


@dataclass(frozen=True)
class MapGrid:
    """What a map is computed of."""

    axes: tuple[MapAxis, ...]
    cases: tuple[Case, ...]  # (C), the last axis changes fastest
    rings: tuple[LinearPair, ...]  # (C)
    points: GridPoints


def grid(first: Case, axes: Sequence[MapAxis], report: Report) -> MapGrid:
    """Build every point of a map.

    Raises `BadCase` for a value that the case does not take, or a map that is not supported; `NotSolved`
    where a ring has no trustworthy answer.
    """
    _require_supported(first)
    cases, shape = _cases(first, axes), tuple(len(axis.values) for axis in axes)
    described = tuple(_told(axis, number, shape, cases) for number, axis in enumerate(axes))
    same, alike = np.unique(_same_parts(axes, shape), return_inverse=True)
    some = [cases[point] for point in same]
    for case in some:
        _require_supported(case)
    try:
        models = [roller_bearing.bearing(case) for case in some]
        for case, model in zip(some, models, strict=True):
            roller_bearing.require_around(case, model.bearing)
        rings = _rings(some, models, report)
        bearings = [
            replace(models[which], operation=roller_bearing.operation(case))
            for case, which in zip(cases, alike.tolist(), strict=True)
        ]
        deviation = _initial_deviation(rings)
        of_each = None if deviation is None else deviation[alike]
        points = GridPoints.of(shape, bearings, rings[0].compliance, of_each)
    except (ImpossiblePart, OutOfRange) as problem:
        raise BadCase(f"{first.source.path}: --over: {problem}") from problem
    except PartnerFailed as problem:
        raise NotSolved(str(problem)) from problem
    return MapGrid(described, tuple(cases), tuple(rings[which] for which in alike), points)


def _same_parts(axes: Sequence[MapAxis], shape: tuple[int, ...]) -> NDArray:
    """For each point (C) one with the same parts, lubrication and rings: the first along axes of loads."""
    places = np.arange(prod(shape)).reshape(shape)
    for number, axis in enumerate(axes):
        if axis.key in LOADS:
            places = np.broadcast_to(places.take([0], axis=number), shape)
    return places.ravel()


def _initial_deviation(rings: Sequence[LinearPair]) -> NDArray | None:
    """Deviations (n, 2, Z, M) of the raceways without load [m]; None where no pair has any."""
    each = [pair.initial_deviation for pair in rings]
    known = next((deviation for deviation in each if deviation is not None), None)
    if known is None:
        return None
    return np.array([np.zeros_like(known) if deviation is None else deviation for deviation in each])


def _require_supported(case: Case) -> None:
    """Refuse cases whose points are not solved side by side."""
    name = case.source.path
    if case.accuracy.target is not None:
        raise BadCase(f"{name}: accuracy.target: a map has one level for all points; leave the target out")
    if case.operation.roller_positions is not None or case.bearing.contact == "half_space":
        raise BadCase(f"{name}: maps have one position of the rollers, in sliced contact")
    if not _rigid(case) and not is_linear(case):
        raise BadCase(
            f"{name}: maps are over rings that deflect linearly: no fit that may open, no one-sided support; "
            "use a study, or set outer.kind and inner.kind to rigid"
        )


def _rigid(case: Case) -> bool:
    return case.inner.kind == case.outer.kind == "rigid"


def _cases(first: Case, axes: Sequence[MapAxis]) -> list[Case]:
    """Every combination of values, over what the case and its settings say."""
    source, given = first.source, {}
    for setting in source.overrides:
        key, _, text = (part.strip() for part in setting.partition("="))
        if not text:
            raise BadCase(f"setting {key}=: a map takes no key out; leave it out of the case file")
        declaration = find(key, type(first))
        given[key] = text if declaration and text in declaration.choices else setting_value(text)
    varied = [axis.key for axis in axes]
    if why := rated_apart((*given, *varied), varied):
        raise BadCase(f"--over: {why}")
    keys = (*(key for key in given if key not in varied), *varied)
    variants, cases = Variants(Path(source.path), source.text, keys, FAMILIES), []
    for values in product(*(axis.values for axis in axes)):
        settings = given | dict(zip(varied, values, strict=True))
        case = variants.case(tuple(settings[key] for key in keys))
        assert isinstance(case, Case)
        cases.append(case)
    return cases


def _told(axis: MapAxis, number: int, shape: tuple[int, ...], cases: Sequence[Case]) -> MapAxis:
    """An axis with the numbers that the cases along it have."""
    stride = prod(shape[number + 1 :])
    value = attrgetter(axis.key)
    return with_numbers(axis, [value(cases[place * stride]) for place in range(shape[number])])


def _rings(cases: Sequence[Case], models: Sequence[RollerBearing], report: Report) -> list[LinearPair]:
    """Raceways of each case; all have the same parts."""
    first, azimuths = cases[0], models[0].bearing.azimuths
    if _rigid(first):
        return [LinearPair(None, None)] * len(cases)

    def rows(case: Case) -> tuple[float, float]:
        return roller_length(case), roller_bearing.row_distance(case)

    for case, model in zip(cases, models, strict=True):
        same = np.array_equal(model.bearing.azimuths, azimuths) and rows(case) == rows(first)
        parts = all(ring_parts.part_of(case, race) == ring_parts.part_of(first, race) for race in RACES)
        if not (same and parts):
            raise BadCase(
                f"{first.source.path}: a map is between the same elastic rings, and this key changes "
                "them; use a study, or set outer.kind and inner.kind to rigid"
            )
    alike: list[Case | None] = list(cases)
    return linear_raceways({race: alike for race in RACES}, azimuths, models[0].axial_modes, report)
