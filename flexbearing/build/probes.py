"""From a case to the probes on its rings."""

import fem
from fem.parts.probe import Probe, radius
from flexbearing.build import ring_parts
from flexbearing.build.expansion import hot_over_cold
from flexbearing.build.ring_parts import Race
from flexbearing.case.roller import Case


def probes(case: Case, race: Race) -> dict[int, Probe]:
    """Probes on one ring by their numbers from 0, at its temperature."""
    table = case.outputs.probes
    hot = hot_over_cold(case, f"{race}_ring")
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


def require_probes(case: Case) -> None:
    """Refuse probes on rigid rings, on those whose solid is not known, and beside their material.

    Raises `ImpossiblePart` naming the probe.
    """
    for race in ring_parts.NAMES:
        there = probes(case, race)
        if not there:
            continue
        part = ring_parts.part_of(case, race)
        words = ring_parts.why_no_solid(case, race) if part else f'{race}.kind = "rigid" does not deflect'
        if part is None or words:
            raise fem.ImpossiblePart(f"[outputs.probes] probe {min(there) + 1}: {words}")
        for number, probe in there.items():
            try:
                radius(part, probe)
            except fem.ImpossiblePart as problem:
                raise fem.ImpossiblePart(f"[outputs.probes] probe {number + 1}: {problem}") from problem
