"""A part condensed to its raceway, or taken from the cache."""

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from math import pi
from typing import TYPE_CHECKING, Any

import numpy as np

import fem
from fem.condense import BEAM, HARMONICS, SOLID, condense
from flexbearing.cache import configured
from flexbearing.progress import Report

if TYPE_CHECKING:
    from fem.parts.part import Part
    from fem.parts.step_solid import StepSolid

Arguments = tuple[Any, fem.Discretisation, fem.Resolution]  # a part, and what else decides its compliance
Ahead = Callable[[], Any] | None  # gives a ring that is condensed in another place than usual
UNLOADED = fem.PlanetGear(forces=())  # of a ring that nothing holds: lines and teeth are put on it afterwards
_PAIR = ((0.0, 1.0), (pi, -1.0))
HELICAL = fem.PlanetGear(
    forces=tuple(fem.LineForce(azimuth=at, radial=0.0, tangential=0.0, axial=pull) for at, pull in _PAIR)
)  # for teeth that press along the axis, too


def condensed_part(name: str, arguments: Arguments, report: Report, ahead: Ahead = None) -> Any:
    """Raceway compliance of a part, as `fem.condense.condense` gives it.

    A ring between lines or teeth is condensed once for all of their places and forces.
    """
    part, discretisation, resolution = arguments
    support = part.support if isinstance(part, fem.OuterRing) else None
    if isinstance(support, fem.ReducedBody):
        return _in_memory(*arguments)  # more than is kept on disk
    if isinstance(support, fem.LineSupports | fem.PlanetGear) and discretisation is HARMONICS:
        from fem.section.planet_rim import PlanetRim
        from fem.section.ring_on_lines import RingOnLines

        helical = isinstance(support, fem.PlanetGear) and support.helical
        free = replace(part, support=HELICAL if helical else UNLOADED), discretisation, resolution
        ring = _cached("FreeRing", name, free, report) if part.groove else _in_memory(*free).ring
        return PlanetRim(ring, support) if isinstance(support, fem.PlanetGear) else RingOnLines(ring, support)
    if discretisation is BEAM:
        return _in_memory(*arguments)  # sooner computed than read
    kind = "HarmonicCompliance"
    if isinstance(support, fem.Foundation) and support.pushing:
        kind = "RingOnFoundation"
    elif discretisation is SOLID:
        kind = "RacewayCompliance"
    elif part.groove:
        kind = "GrooveCompliance"
    return _cached(kind, name, arguments, report, ahead)


def _cached(kind: str, name: str, arguments: Arguments, report: Report, ahead: Ahead = None) -> Any:
    def computed() -> Any:
        if arguments[1] is SOLID:
            return condense(*arguments, report=lambda stage, part: report.stage(f"{name}: {stage}", part))
        found: Any = ahead() if ahead else condense(*arguments)
        return found.ring if kind == "FreeRing" else found

    return configured().cached(
        kind,
        arguments,
        computed,
        lambda note: report.stage(f"{name}: {note}", None),
        lambda kept: _is_of(*arguments, kept),
    )


@lru_cache(maxsize=16)  # of a design and what its derivatives need
def _in_memory(
    part: "Part | StepSolid", discretisation: fem.Discretisation, resolution: fem.Resolution
) -> Any:
    """A part condensed once for cases one after the other, such as the designs of a search."""
    return condense(part, discretisation, resolution)


def _is_of(part: Any, discretisation: fem.Discretisation, resolution: fem.Resolution, kept: Any) -> bool:
    """Whether a compliance from the cache is that of a part, as far as it says so."""
    if discretisation is SOLID:
        stations = resolution.stations
        shapes = len(stations.angles) if stations else resolution.axial_modes
        shape = len(resolution.azimuths or ()), shapes
        return np.array_equal(kept.azimuths, resolution.azimuths or ()) and kept.absolute.shape[:2] == shape
    if isinstance(part, fem.OuterRing) and isinstance(part.support, fem.Foundation) and part.support.pushing:
        if kept.radial != part.support.radial:
            return False
        kept = kept.raceway
    if isinstance(part, fem.OuterRing) and isinstance(part.support, fem.PlanetGear):
        kept = kept.raceway
    if part.groove:
        stations = resolution.stations
        assert stations  # of every part with a groove
        same = (kept.groove, kept.width, kept.elastic) == (
            part.groove,
            stations.width,
            part.materials["ring"],
        )
        return same and tuple(kept.angles) == stations.angles
    bars = part.bars if discretisation is HARMONICS else None
    wanted = part.raceway_diameter / 2, resolution.length, part.materials["ring"], bars
    same = (kept.radius, kept.length, kept.elastic, kept.bars) == wanted
    return same and kept.response.shape[1] == len(resolution.rows) * resolution.axial_modes
