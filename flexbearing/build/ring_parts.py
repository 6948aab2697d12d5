"""From a case to what carries the raceways: outer and inner part at their temperatures."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Literal

import fem
from flexbearing.build import held_ring
from flexbearing.build.expansion import hot_over_cold, material, outer_raceway_diameter, roller_length
from flexbearing.case.roller import Case
from quasidynamic.note import Note, information

if TYPE_CHECKING:
    from fem.parts.step_solid import StepSolid

    Part = fem.SquirrelCage | fem.OuterRing | fem.RingOnShaft | StepSolid

Race = Literal["inner", "outer"]

RACEWAY_GRID = 1e-4  # of the outer raceway: inner ones closer to each other are one to the finite elements
NAMES: dict[Race, str] = {"inner": "inner ring and shaft", "outer": "outer ring"}


def part_of(case: Case, race: Race) -> "Part | None":
    """What carries a raceway; None when it is rigid."""
    return inner_part(case) if race == "inner" else outer_part(case)


def outer_part(case: Case) -> "fem.SquirrelCage | fem.OuterRing | StepSolid | None":
    """What carries the outer raceway, at its temperature; None when it is rigid."""
    with _of_table("outer"):
        return _outer_part(case)


def _outer_part(case: Case) -> "fem.SquirrelCage | fem.OuterRing | StepSolid | None":
    outer: Any = case.outer  # which values are there depends on the kind, checked on reading
    if outer.kind == "rigid":
        return None
    hot = hot_over_cold(case, "outer_ring")
    ring: dict[str, Any] = {
        "raceway_diameter": outer_raceway_diameter(case),
        "elastic": _elastic(case, "outer_ring"),
    }
    if outer.kind == "step":
        return held_ring.drawn(case, **ring, scale=hot)
    if outer.kind in ("ring", "matrix"):
        lengths = {name: getattr(outer, name) * hot for name in ("thickness", "width")}
        return fem.OuterRing(**ring, **lengths, support=_support(case), offset=outer.raceway_offset * hot)
    lengths = (
        "thickness", "width", "bar_width", "bar_thickness", "bar_length", "flange_length", "fillet",
        "collar_length",
    )  # fmt: skip
    return fem.SquirrelCage(
        **ring,
        **{name: getattr(outer, name) * hot for name in lengths},
        bars=outer.bars,
        collar_thickness=outer.collar_thickness * hot if outer.collar_length else 0.0,
        two_sided=outer.bar_ends == "both",
        offset=outer.raceway_offset * hot,
    )


def outer_mass(case: Case) -> float | None:
    """Mass of what carries the outer raceway [kg]; None of a rigid one, and of a drawn solid."""
    part = outer_part(case)
    if part is None or not isinstance(part, fem.OuterRing | fem.SquirrelCage):
        return None
    from fem.parts.volume import volume

    cold = volume(part) / hot_over_cold(case, "outer_ring") ** 3
    return cold * case.materials.outer_ring.density


@contextmanager
def _of_table(name: str) -> Iterator[None]:
    """Say of what is impossible in which table of the case it stands."""
    try:
        yield
    except fem.ImpossiblePart as problem:
        raise fem.ImpossiblePart(f"[{name}] {problem}") from problem


def _support(case: Case) -> Any:
    """What holds a plain outer ring."""
    outer: Any = case.outer  # checked on reading
    if outer.kind == "matrix":
        from flexbearing.build.reduced_bodies import reduced_body

        return reduced_body(case)
    hot = hot_over_cold(case, "outer_ring")
    housing = _elastic(case, "housing") if outer.support == "housing" else None
    pushing = outer.foundation_radial > 0 and not outer.bilateral
    return held_ring.support(outer, housing, hot=hot, pushing=pushing)


def inner_part(case: Case) -> "fem.RingOnShaft | None":
    """Inner ring on its shaft, at the ring's temperature; None when it is rigid."""
    with _of_table("inner"):
        return _inner_part(case)


def _inner_part(case: Case) -> "fem.RingOnShaft | None":
    inner: Any = case.inner
    if inner.kind == "rigid":
        return None
    # The two parts are bonded: one expansion for both keeps their common surface common.
    hot = hot_over_cold(case, "inner_ring")
    track = max(inner.track_width * hot, roller_length(case))
    return fem.RingOnShaft(
        raceway_diameter=_meshed_inner_raceway_diameter(case),
        track_width=track,
        rib_diameter=(inner.bore + 2 * inner.thickness) * hot if inner.ribbed else None,
        bore=inner.bore * hot,
        width=inner.width * hot if inner.ribbed else track,
        shaft_bore=inner.shaft_bore * hot,
        shaft_length=inner.shaft_length * hot,
        ring=_elastic(case, "inner_ring"),
        shaft=_elastic(case, "shaft"),
    )


def _meshed_inner_raceway_diameter(case: Case) -> float:
    """Inner raceway diameter [m] of the finite elements; on moved nodes it follows the cold parts."""
    other = case.nodes_of
    if other is None:
        return _on_grid(_inner_raceway_diameter(case), case.bearing.outer_raceway_diameter)
    bearings = case.bearing, other.bearing
    new, old = (each.outer_raceway_diameter - 2 * each.roller.diameter for each in bearings)
    return _meshed_inner_raceway_diameter(other) + (new - old)  # no change is none to the last digit


def _on_grid(diameter: float, outer_raceway_diameter: float) -> float:
    """Nearest diameter [m] on a grid, so that clearances near each other have one ring."""
    step = RACEWAY_GRID * outer_raceway_diameter
    return step * round(diameter / step)


def _inner_raceway_diameter(case: Case) -> float:
    """Hot inner raceway diameter [m], before a fit widens it."""
    diameter, roller = case.bearing.outer_raceway_diameter, case.bearing.roller.diameter
    if case.bearing.mounting is None:
        hot_roller = roller * hot_over_cold(case, "roller")
        return outer_raceway_diameter(case) - 2 * hot_roller - case.stated_clearance
    return (diameter - 2 * roller - case.stated_clearance) * hot_over_cold(case, "inner_ring")


def notes(case: Case) -> tuple[Note, ...]:
    """What the parts say before anything is solved."""
    if case.outer.kind != "matrix":
        return _without_effect(case)
    from flexbearing.build import reduced_bodies

    return (*reduced_bodies.notes(case), *_without_effect(case))


def _without_effect(case: Case) -> tuple[Note, ...]:
    """Say so when a dimension of the rings has no effect."""
    inner = case.inner
    if inner.kind == "rigid" or inner.ribbed or inner.thickness is None:
        return ()
    words = (
        f"inner.thickness = {1e3 * inner.thickness:g} mm is not used: a ring without ribs ends at its raceway"
    )
    return (information("inner-thickness", words),)


def why_no_solid(case: Case, race: Race) -> str:
    """Why a part is computed on its section only; empty where its solid is known."""
    if case.bearing.second_row is not None:
        return "bearing.second_row has no solid, only one row has one"
    if race == "inner" and case.inner.fit != "bonded":
        return f'inner.fit = "{case.inner.fit}" has no solid, only a bonded ring has one'
    if race == "outer" and case.outer.kind == "matrix":
        return 'outer.kind = "matrix" has no solid: its body is known by a matrix alone'
    if race == "inner" or case.outer.kind != "ring":
        return ""
    if case.lifts_off:
        return "bearing.fits.housing has no solid, only a bonded ring has one"
    if case.outer.support not in ("side", "seat", "housing"):
        return f'outer.support = "{case.outer.support}" has no solid; "side", "seat" and "housing" have one'
    return ""


def require_shoulder(case: Case) -> None:
    """Refuse a shoulder of the shaft that does not end on the side of the ring."""
    part = inner_part(case)
    if part is not None and case.inner.shoulder_diameter is not None and case.inner.fit != "bonded":
        with _of_table("inner"):
            part.require_shoulder(case.inner.shoulder_diameter)


def require_held_in_housing(case: Case) -> None:
    """Refuse a loose ring that no load presses on its housing.

    Raises `ImpossiblePart` when neither an interference nor a load holds the ring.
    """
    outer: Any = case.outer
    if not case.lifts_off or case.operation.radial_load > 0:
        return
    diameter = case.bearing.outer_raceway_diameter + 2 * outer.thickness
    interference = case.housing_interference
    gap = -interference + diameter * (hot_over_cold(case, "housing") - hot_over_cold(case, "outer_ring"))
    if gap >= 0:
        raise fem.ImpossiblePart(
            f"bearing.fits.housing.interference = {1e6 * interference:.4g} um leaves {1e6 * gap:.3g} um hot, "
            "and nothing holds the ring; allowed is an operation.radial_load above zero, or a hotter ring"
        )


def _elastic(case: Case, part: str) -> "fem.Elastic":
    solid = material(case, part)
    return fem.Elastic(youngs_modulus=solid.youngs_modulus, poisson_ratio=solid.poisson_ratio)
