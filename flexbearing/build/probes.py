"""From a case to the probes on its rings."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import fem
from fem.parts.probe import Probe, radius
from flexbearing.build.expansion import hot_over_cold
from flexbearing.build.ring_parts import NAMES, Race
from flexbearing.case.roller import Case

if TYPE_CHECKING:
    from flexbearing.build.groove_parts import BallCase


def probes(case: "Case | BallCase", race: Race) -> dict[int, Probe]:
    """Probes on one ring by their numbers from 0, at the temperature of its finite elements."""
    table = case.outputs.probes
    hot = hot_over_cold(case, f"{race}_ring") if isinstance(case, Case) else 1.0
    return {
        number: Probe(
            azimuth=row.azimuth,
            x=row.place * hot,
            outside=row.surface == "outside",
            depth=row.depth * hot,
            angle=row.gauge_angle,
            length=row.gauge_length * hot,
        )
        for number, row in enumerate(table.rows if table else ())
        if row.part == race
    }


def require_probes(
    case: "Case | BallCase", part_of: Callable[[Any, Race], Any], why_no_solid: Callable[[Any, Race], str]
) -> None:
    """Refuse probes on rigid rings, on those whose solid is not known, and beside their material.

    Raises `ImpossiblePart` naming the probe.
    """
    for race in NAMES:
        there = probes(case, race)
        if not there:
            continue
        part, bolted = part_of(case, race), getattr(case, "rings", None)
        kind, key = getattr(bolted or case, race).kind, f"rings.{race}" if bolted else race
        words = why_no_solid(case, race) if part else f'{key}.kind = "{kind}" does not deflect'
        if part is None or words:
            raise fem.ImpossiblePart(f"[outputs.probes] probe {min(there) + 1}: {words}")
        for number, probe in there.items():
            try:
                radius(part, probe)
            except fem.ImpossiblePart as problem:
                raise fem.ImpossiblePart(f"[outputs.probes] probe {number + 1}: {problem}") from problem
