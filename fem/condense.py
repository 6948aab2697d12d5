"""The one entry: a part condensed to the compliance of its raceway under rollers or balls.

A discretisation is loaded with NGSolve when it is used: importing this module loads neither.
"""

import logging
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from math import ceil
from time import process_time
from typing import TYPE_CHECKING, Any, TypeVar

from fem.parts.bolted_ring import BoltedRing
from fem.parts.boundary_conditions import ClampedFace, Foundation, LineSupports, PlanetGear, RigidSeat
from fem.parts.groove import Groove
from fem.parts.material import ImpossiblePart, in_mm
from fem.parts.part import Part
from fem.parts.reduced_body import ReducedBody
from fem.parts.resolution import Discretisation, Resolution, Shape
from fem.parts.rings import OuterRing, RingOnShaft, require_on_track
from fem.parts.squirrel_cage import SquirrelCage
from fem.parts.step_solid import StepSolid
from fem.stages import Report, Stage, stages, unheard
from fem.subprocess import in_subprocess, started

if TYPE_CHECKING:
    from fem.raceway.compliance import RacewayCompliance
    from fem.raceway.growth import RacewayGrowth
    from fem.raceway.harmonics import HarmonicCompliance
    from fem.raceway.stations import GrooveCompliance
    from fem.section.free_ring import FreeRing
    from fem.section.planet_rim import PlanetRim
    from fem.section.raceway_shapes import Raceway
    from fem.section.ring_on_foundation import RingOnFoundation
    from fem.section.ring_on_lines import RingOnLines

HARMONICS, SMEARED, BEAM, SOLID = Discretisation
Condensed = TypeVar("Condensed")

COUPLED = 2  # numbers of bars by which harmonics differ that are coupled: with more, loads change by 1e-5
# [s] of processor time for a drawing, assumed: damaged ones keep the geometry kernel at work without an end
READING, PER_MEGABYTE = 3.0, 30.0

_log = logging.getLogger(__name__)


def condense(
    part: Part | StepSolid,
    discretisation: Discretisation,
    resolution: Resolution,
    report: Report = unheard,
) -> "HarmonicCompliance | RingOnFoundation | RingOnLines | PlanetRim | RacewayCompliance | GrooveCompliance":
    """Condense a part to its raceway; what is meshed in space is meshed in a process of its own.

    HARMONICS suits all parts but a StepSolid, which is a SOLID. The resolution has the loaded band, axial
    modes, element sizes and harmonics; azimuths and patches of a solid. `report` is called with "mesh",
    "factor" and "condense" and the finished fraction of that stage, None if unknown.

    `at` of the result gives the compliance for rollers or balls at their azimuths; that of a solid holds for
    its azimuths alone. With supports that only push it depends on the forces: `under_rollers` of
    RingOnFoundation and RingOnLines. A part with a groove has a GrooveCompliance, unless it is drawn.

    Raises `ImpossiblePart` if the band is longer than the track, the part can still move freely, or does not
    go with the discretisation; `NotSolved` if a solve fails, the mesh is too coarse for harmonics or patches,
    or the process ends without a result.

    Valid
    -----
    Small displacement, perfect bonds, rigid clamps, supports without friction; no load outside the band.
    """
    if isinstance(part, StepSolid) and discretisation is SOLID:
        require_drawing(part, resolution.length)
    is_new = resolution.nodes_of is None  # the mesh of moved nodes has been made before, and did no harm
    if discretisation is SOLID or (is_cage_in_space(part, discretisation) and is_new):
        return in_subprocess(condense_in_process, part, discretisation, resolution, report=report)
    return condense_in_process(part, discretisation, resolution, report)


def is_cage_in_space(part: Any, discretisation: Discretisation) -> bool:
    """Whether half a pitch of a cage is meshed: a ring that takes seconds, one thread and little memory."""
    return isinstance(part, SquirrelCage) and discretisation is HARMONICS


@contextmanager
def condensing(
    part: Part | StepSolid, discretisation: Discretisation, resolution: Resolution
) -> "Iterator[Callable[[], HarmonicCompliance]]":
    """Condense a cage in space, see `is_cage_in_space`, in a process of its own while the block goes on.

    The callable waits for what `condense` returns, and raises what it raises.
    """
    with started(condense_in_process, part, discretisation, resolution) as answer:
        yield lambda: answer(unheard)


def seat_growth(part: Part, resolution: Resolution) -> "RacewayGrowth":
    """How much a raceway grows with what it is clamped to: by a face, a rigid seat or the flange of a cage.

    Raises `ImpossiblePart` for another part; `NotSolved` if a solve fails, or the process ends without a
    result.
    """
    if isinstance(part, SquirrelCage):
        return in_subprocess(_cage_seat_growth, part, resolution)
    if isinstance(part, OuterRing) and isinstance(part.support, ClampedFace | RigidSeat):
        from fem.section.seat_growth import ring_seat_growth

        return ring_seat_growth(part, resolution)
    raise ImpossiblePart(f"{type(part).__name__} has no seat with another temperature")


def _cage_seat_growth(part: SquirrelCage, resolution: Resolution, report: Report) -> "RacewayGrowth":
    from fem.squirrel_cage.seat_growth import cage_seat_growth

    return cage_seat_growth(part, resolution)


def require_drawing(part: Part | StepSolid, length: float) -> None:
    """Open a drawing in a process of its own, before it is meshed in this one: damaged ones end the kernel.

    Raises `ImpossiblePart` if the drawing does not hold such a part with a loaded band of `length` [m],
    `NotSolved` if the process ends without a result.
    """
    if isinstance(part, StepSolid):
        in_subprocess(_open, part, length)


def _open(part: StepSolid, length: float, report: Report) -> None:
    from fem.mesh.step_import import solid

    _limit_processor_time(ceil(READING + PER_MEGABYTE * len(part.drawing) / 1e6))
    solid(part, length)


def _limit_processor_time(seconds: int) -> None:
    """Have this process ended after so much more of it: no signal handler runs within the geometry kernel."""
    try:
        from resource import RLIMIT_CPU, setrlimit
    except ImportError:  # a system without
        return
    most = ceil(process_time()) + seconds
    setrlimit(RLIMIT_CPU, (most, most + 1))  # by its own signal, not by the one that a lack of memory has


def condense_in_process(
    part: Any, discretisation: Discretisation, resolution: Resolution, report: Report = unheard
) -> Any:
    """Condense a part as `condense` does, always in this process.

    Raises `ImpossiblePart` and `NotSolved` as it does.
    """
    stage, seconds = stages(report)
    _require_cones(part, discretisation, resolution)
    if part.groove is not None:
        _require_known(part, discretisation)
    match part, discretisation:
        case _, Discretisation.SOLID:
            from fem.solid.condensation import condense_solid

            condensed = replace(condense_solid(part, resolution, stage), seconds=seconds)
        case OuterRing(support=LineSupports() | PlanetGear()), Discretisation.HARMONICS:
            require_on_track(resolution.length, part.track, resolution.rows)
            return _free_ring(part, resolution, stage, seconds)
        case OuterRing(support=Foundation(pushing=True)), Discretisation.HARMONICS | Discretisation.BEAM:
            require_on_track(resolution.length, part.track, resolution.rows)
            return _on_foundation(part, discretisation, resolution, stage, seconds)
        case OuterRing(support=ReducedBody()), _:
            require_on_track(resolution.length, part.track, resolution.rows)
            condensed = _on_matrix(part, discretisation, resolution, stage, seconds)
        case (
            BoltedRing()
            | OuterRing(groove=Groove())
            | RingOnShaft(groove=Groove())
            | SquirrelCage(groove=Groove()),
            _,
        ):
            from fem.section.raceway_shapes import groove_compliance

            condensed = groove_compliance(part, resolution, stage, seconds)
        case OuterRing() | SquirrelCage() | RingOnShaft(), _:
            require_on_track(resolution.length, part.track, resolution.rows)
            condensed = _in_harmonics(part, discretisation, resolution, stage, seconds)
        case _:
            raise ImpossiblePart(f"{type(part).__name__} is impossible as {discretisation.name}")
    _log.info("%s: %d unknowns, %.1f s", type(part).__name__, condensed.unknowns, sum(seconds.values()))
    return condensed


def _require_cones(part: Any, discretisation: Discretisation, resolution: Resolution) -> None:
    """Refuse conical raceways that are not discretised by their section, or not where the rows are."""
    if not getattr(part, "taper", 0.0):
        return
    if discretisation is not HARMONICS:
        raise ImpossiblePart(f"a cone is impossible as {discretisation.name}, only as {HARMONICS.name}")
    cones, rows = part.row_distance, resolution.row_distance
    if cones != rows:
        raise ImpossiblePart(f"cones {in_mm(cones)} apart are impossible under rows {in_mm(rows)} apart")


def _require_known(part: Part | StepSolid, discretisation: Discretisation) -> None:
    """Refuse a groove in a ring that is discretised in another way than by its section, or as it is drawn."""
    known = SMEARED if isinstance(part, SquirrelCage) else SOLID if isinstance(part, StepSolid) else HARMONICS
    if discretisation is not known:
        raise ImpossiblePart(f"a groove is impossible as {discretisation.name}, only as {known.name}")
    if isinstance(part, SquirrelCage | BoltedRing) and part.groove and part.groove.place:
        raise ImpossiblePart(f"{type(part).__name__} is impossible with grooves of two rows")


def _in_harmonics(
    part: Part, discretisation: Discretisation, resolution: Resolution, stage: Stage, seconds: dict
) -> "HarmonicCompliance":
    """Compliance of a raceway that is held, from what its harmonics are answered with."""
    from fem.raceway.harmonics import harmonic_compliance

    if isinstance(part, SquirrelCage) and discretisation is HARMONICS:
        return _cage_in_space(part, resolution, stage, seconds)

    def condensed(resolution: Resolution, last: int) -> "HarmonicCompliance":
        compliance = harmonic_compliance(
            _responses_of(part, discretisation)(part, resolution, last, stage),
            radius=part.raceway_diameter / 2,
            length=resolution.length,
            elastic=part.materials["ring"],
            bars=None,
            seconds=seconds,
        )
        _require_enough(compliance, resolution)
        return compliance

    return _with_enough_harmonics(condensed, part, discretisation, resolution)


def _cage_in_space(
    cage: SquirrelCage, resolution: Resolution, stage: Stage, seconds: dict
) -> "HarmonicCompliance":
    """A cage by its elements in space, and what these do not resolve from an axial section.

    A wave too short for them is still coupled to long ones by the bars: an answer to the long wave, which
    they resolve, says how much. What the short wave answers to itself comes from the section.
    """
    from fem.raceway.harmonics import (
        FEWEST,
        harmonic_compliance,
        needed_harmonics,
        resolving,
        with_short_waves,
    )
    from fem.section.smeared_cage import short_waves
    from fem.squirrel_cage.half_pitch_cage import cage_responses
    from fem.squirrel_cage.moved_cage import near_responses

    shape = _shape(cage, resolution)
    resolved = coupled = _last_harmonic(cage, HARMONICS, resolution)
    resolution = resolving(resolution, shape.part.raceway_diameter / 2, resolved)
    needed = needed_harmonics(shape.part.raceway_diameter / 2, shape.length / resolution.axial_modes)
    is_coarse = resolution.harmonics is None and resolved + 1 < needed
    if is_coarse:
        coupled = min(needed, max(resolved, COUPLED * cage.bars + FEWEST))
    responses_of = near_responses if resolution.first_order else cage_responses
    responses = responses_of(cage, resolution, coupled, stage)
    if is_coarse:
        with stage("short waves"):
            waves = short_waves(cage, resolution, resolved + 1, needed)
            responses = with_short_waves(responses, resolved, waves)
    return harmonic_compliance(
        responses,
        radius=cage.raceway_diameter / 2,
        length=resolution.length,
        elastic=cage.materials["ring"],
        bars=cage.bars,
        seconds=seconds,
    )


def _with_enough_harmonics(
    condensed: Callable[[Resolution, int], Condensed],
    part: Part,
    discretisation: Discretisation,
    resolution: Resolution,
) -> Condensed:
    """What is condensed up to the usual harmonic, or to one that is high enough, or that patches have."""
    if part.groove is not None:
        from fem.section.raceway_shapes import last_harmonic_of_patches

        return condensed(resolution, last_harmonic_of_patches(part, resolution))
    from fem.raceway.harmonics import with_enough_harmonics

    last = _last_harmonic(part, discretisation, resolution)
    return with_enough_harmonics(
        condensed, resolution, _shape(part, resolution).part.raceway_diameter / 2, last
    )


def _require_enough(raceway: Any, resolution: Resolution) -> None:
    """Refuse too few harmonics, unless they are given: then the compliance refuses at its rollers."""
    if resolution.harmonics is None and resolution.stations is None:
        raceway.require_enough()


def _responses_of(part: Part, discretisation: Discretisation) -> Any:
    """What answers the harmonics of a part: a function of part, resolution, last harmonic and stage."""
    match part, discretisation:
        case _, Discretisation.BEAM:
            from fem.beam.thin_ring import beam_responses as responses
        case SquirrelCage(), Discretisation.SMEARED:
            from fem.section.smeared_cage import smeared_responses as responses
        case _, Discretisation.HARMONICS:
            from fem.section.revolved import section_responses as responses
        case _:
            raise ImpossiblePart(
                f"{type(part).__name__} is impossible as {discretisation.name}: it has no bars"
            )
    return responses


def _shape(part: Part, resolution: Resolution) -> Shape:
    """What is meshed: the part, or the same before its nodes were moved."""
    return resolution.nodes_of or Shape(part=part, length=resolution.length)


def _last_harmonic(part: Part, discretisation: Discretisation, resolution: Resolution) -> int:
    from fem.raceway.harmonics import detail_of_ring, highest_harmonic

    shape = _shape(part, resolution)
    if discretisation is BEAM:
        from fem.beam.thin_ring import last_harmonic

        return last_harmonic(shape.part, replace(resolution, length=shape.length))
    part, band = shape.part, shape.length / resolution.axial_modes
    detail = detail_of_ring(band, part.thickness) if isinstance(part, OuterRing) else band
    return highest_harmonic(part.raceway_diameter / 2, detail, resolution.mesh, resolution.harmonics)


def _on_foundation(
    part: OuterRing, discretisation: Discretisation, resolution: Resolution, stage: Stage, seconds: dict
) -> "RingOnFoundation":
    """A ring that springs only push, from what its raceway and its outer surface are answered with."""
    from fem.section.ring_on_foundation import ALONG, ring_on_foundation

    def condensed(resolution: Resolution, last: int) -> "RingOnFoundation":
        responses = _responses_of(part, discretisation)(part, resolution, last, stage, face_modes=ALONG)
        ring = ring_on_foundation(part, resolution, responses, seconds)
        _require_enough(ring.raceway, resolution)
        return ring

    return _with_enough_harmonics(condensed, part, discretisation, resolution)


def _on_matrix(
    part: OuterRing, discretisation: Discretisation, resolution: Resolution, stage: Stage, seconds: dict
) -> "Raceway":
    """A ring on a body that another program reduced."""
    if discretisation is not HARMONICS:
        raise ImpossiblePart(f"a ring on a matrix is impossible as {discretisation.name}, only as HARMONICS")
    from fem.section.ring_on_matrix import ring_on_matrix

    def condensed(resolution: Resolution, last: int) -> "Raceway":
        compliance = ring_on_matrix(part, resolution, last, stage, seconds)
        _require_enough(compliance, resolution)
        return compliance

    return _with_enough_harmonics(condensed, part, HARMONICS, resolution)


def _free_ring(part: OuterRing, resolution: Resolution, stage: Stage, seconds: dict) -> Any:
    """A ring between rollers and lines: on the lines that support it, or under tooth forces."""
    from fem.section.free_ring import free_ring
    from fem.section.planet_rim import PlanetRim
    from fem.section.ring_on_lines import RingOnLines, require_held

    def condensed(resolution: Resolution, last: int) -> "FreeRing":
        ring = free_ring(part, resolution, last, stage, seconds)
        _require_enough(ring.raceway, resolution)
        return ring

    support = part.support
    if isinstance(support, LineSupports):
        require_held(support, resolution.axial_modes)
    free = _with_enough_harmonics(condensed, part, HARMONICS, resolution)
    if isinstance(support, PlanetGear):
        return PlanetRim(free, support)
    assert isinstance(support, LineSupports)
    return RingOnLines(free, support)
