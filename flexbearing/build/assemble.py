"""From a case to bearing and rings."""

import re
from pathlib import Path
from typing import Any

import fem
import quasidynamic as qd
from fem.parts.step_solid import Coloured, Named, StepSolid, drawing
from flexbearing.build import clearance
from flexbearing.build.lubrication import lubrication
from flexbearing.case import Case
from quasidynamic.parts.flange import Flange

Part = fem.SquirrelCage | fem.OuterRing | fem.RingOnShaft | StepSolid


def growth(case: Case, part: str) -> float:
    """Hot over reference dimension of a part, 1 + alpha (T - T0)."""
    temperatures = case.operation.temperatures
    if temperatures is None:
        return 1.0
    rise = getattr(temperatures, part) - temperatures.reference
    return 1.0 + getattr(case.materials, part).expansion * rise


def bearing(case: Case) -> qd.RollerBearing:
    """Bearing of a case, parts grown to their temperatures; the operating clearance already knows them."""
    return qd.RollerBearing(
        bearing=qd.CylindricalRollerBearing(
            rollers=case.bearing.rollers,
            outer_raceway_diameter=outer_raceway_diameter(case),
            clearance=clearance.operating(case),
            roller=_roller(case),
            cage=_cage(case),
            inner_ring=_material(case, "inner_ring"),
            outer_ring=_material(case, "outer_ring"),
            contact_law=case.bearing.contact_law,
            first_roller_azimuth=case.bearing.first_roller_azimuth,
        ),
        operation=qd.Operation(
            radial_load=case.operation.radial_load,
            inner_speed=case.operation.inner_speed,
            outer_speed=case.operation.outer_speed,
            load_direction=case.operation.load_direction,
            moment=case.operation.moment,
            misalignment=case.operation.misalignment,
            free_tilt=case.operation.free_tilt,
        ),
        lubrication=lubrication(case),
        slices=case.accuracy.slices,
        axial_modes=case.accuracy.axial_shapes,
    )


def outer_raceway_diameter(case: Case) -> float:
    """Hot outer raceway diameter [m]."""
    return case.bearing.outer_raceway_diameter * growth(case, "outer_ring")


def roller_length(case: Case) -> float:
    """Hot roller length [m]."""
    return case.bearing.roller.length * growth(case, "roller")


def flange(case: Case) -> Flange | None:
    """Hot guide flanges, their clearance as given; None when the case has none."""
    given = case.bearing.flange
    if given is None:
        return None
    return Flange(
        ring=given.ring,
        clearance=given.clearance,
        height=given.height * growth(case, f"{given.ring}_ring"),
        roller_chamfer=given.roller_chamfer * growth(case, "roller"),
        stiffness=given.stiffness,
        friction=given.friction,
    )


def outer_part(case: Case) -> fem.SquirrelCage | fem.OuterRing | StepSolid | None:
    """What carries the outer raceway, at its temperature; None when it is rigid."""
    outer: Any = case.outer  # which values are there depends on the kind, checked on reading
    hot = growth(case, "outer_ring")
    ring: dict[str, Any] = {
        "raceway_diameter": outer_raceway_diameter(case),
        "elastic": _elastic(case, "outer_ring"),
    }
    if outer.kind == "rigid":
        return None
    if outer.kind == "step":
        return _drawn(case, **ring, growth=hot)
    if outer.kind == "ring":
        lengths = {name: getattr(outer, name) * hot for name in ("thickness", "width")}
        return fem.OuterRing(**ring, **lengths, support=_support(case))
    lengths = ("thickness", "width", "bar_width", "bar_thickness", "bar_length", "flange_length", "fillet")
    return fem.SquirrelCage(**ring, bars=outer.bars, **{name: getattr(outer, name) * hot for name in lengths})


def _support(case: Case) -> Any:
    """What holds a plain outer ring."""
    outer: Any = case.outer  # checked on reading
    hot = growth(case, "outer_ring")
    match outer.support:
        case "seat":
            return fem.RigidSeat()
        case "foundation":
            return fem.Foundation(
                axial=outer.foundation_axial,
                radial=outer.foundation_radial,
                tangential=outer.foundation_tangential,
            )
        case "housing":
            return fem.Housing(
                thickness=outer.housing_thickness * hot,
                width=outer.housing_width * hot,
                elastic=_elastic(case, housing_material(case)),
                support=fem.RigidSeat() if outer.housing_support == "seat" else fem.ClampedFace(),
            )
        case "lines":
            return fem.LineSupports(azimuths=outer.line_azimuths)
        case "planet":
            teeth = zip(outer.tooth_azimuths, outer.tooth_radial, outer.tooth_tangential, strict=True)
            return fem.PlanetGear(
                forces=tuple(fem.LineForce(azimuth=a, radial=r, tangential=t) for a, r, t in teeth)
            )
        case _:
            return fem.ClampedFace()


def housing_material(case: Case) -> str:
    """Name of the material of a housing around a flexible ring."""
    return "outer_ring" if case.materials.housing is None else "housing"


def housing_growth(case: Case) -> float:
    """Hot over reference dimension of a housing around a flexible ring, 1 + alpha (T - T0)."""
    temperatures = case.operation.temperatures
    if temperatures is None or temperatures.housing is None:
        return growth(case, "outer_ring")
    rise = temperatures.housing - temperatures.reference
    return 1.0 + getattr(case.materials, housing_material(case)).expansion * rise


def require_held_in_housing(case: Case) -> None:
    """Refuse a loose ring that no load presses on its housing."""
    outer: Any = case.outer
    if not outer.lifts_off or case.operation.radial_load > 0:
        return
    diameter = case.bearing.outer_raceway_diameter + 2 * outer.thickness
    gap = outer.housing_clearance + diameter * (housing_growth(case) - growth(case, "outer_ring"))
    if gap >= 0:
        raise fem.ImpossiblePart(
            f"outer.housing_clearance = {outer.housing_clearance!r} m leaves {gap:.3g} m hot, and nothing "
            "holds the ring; allowed is an operation.radial_load above zero, or a hotter ring"
        )


def _drawn(case: Case, **ring: Any) -> StepSolid:
    """Solid from the STEP file that lies next to the case."""
    outer: Any = case.outer
    return StepSolid(
        drawing=drawing(Path(case.source.path).parent / outer.file),
        clamps=tuple(_pick(face) for face in outer.clamps),
        raceway=None if outer.raceway is None else _pick(outer.raceway),
        centre=(outer.centre_x, outer.centre_y, outer.centre_z),
        axis=_direction(outer.axis),
        zenith=_direction(outer.zenith),
        source=outer.file,
        **ring,
    )


def _pick(face: str) -> Named | Coloured:
    """Choice of faces by a colour such as #e75959, or by a name."""
    if re.fullmatch(r"#[0-9a-fA-F]{6}", face):
        return Coloured(*bytes.fromhex(face[1:]))
    return Named(face)


def _direction(name: str) -> tuple[float, float, float]:
    """Unit vector along an axis of the drawing."""
    vector = [0.0, 0.0, 0.0]
    vector["xyz".index(name[-1])] = -1.0 if name.startswith("-") else 1.0
    return vector[0], vector[1], vector[2]


def inner_part(case: Case) -> fem.RingOnShaft | None:
    """Inner ring on its hollow shaft, at the ring's temperature; None when it is rigid."""
    inner: Any = case.inner
    if inner.kind == "rigid":
        return None
    # The two parts are bonded: one growth for both keeps their common surface common.
    hot = growth(case, "inner_ring")
    return fem.RingOnShaft(
        raceway_diameter=outer_raceway_diameter(case)
        - 2 * case.bearing.roller.diameter * growth(case, "roller")
        - clearance.operating(case),
        track_width=max(inner.track_width * hot, roller_length(case)),
        rib_diameter=(inner.bore + 2 * inner.thickness) * hot,
        bore=inner.bore * hot,
        width=inner.width * hot,
        shaft_bore=(inner.bore - 2 * inner.shaft_thickness) * hot,
        shaft_length=inner.shaft_length * hot,
        ring=_elastic(case, "inner_ring"),
        shaft=_elastic(case, "shaft"),
    )


def _material(case: Case, name: str) -> qd.Material:
    part = getattr(case.materials, name)
    return qd.Material(
        youngs_modulus=part.youngs_modulus, poisson_ratio=part.poisson_ratio, density=part.density
    )


def _elastic(case: Case, name: str) -> fem.Elastic:
    part = getattr(case.materials, name)
    return fem.Elastic(youngs_modulus=part.youngs_modulus, poisson_ratio=part.poisson_ratio)


def _roller(case: Case) -> qd.Roller:
    return qd.Roller(
        diameter=case.bearing.roller.diameter * growth(case, "roller"),
        length=roller_length(case),
        material=_material(case, "roller"),
        profile=_profile(case),
    )


def _profile(case: Case) -> qd.Profile:
    roller: Any = case.bearing.roller  # which values are there depends on the profile, checked on reading
    if roller.profile == "crowned":
        return qd.Crowned(straight_length=roller.straight_length, crown_radius=roller.crown_radius)
    if roller.profile == "logarithmic":
        return qd.Logarithmic(amplitude=roller.drop)
    return qd.Straight()


def _cage(case: Case) -> qd.Cage:
    cage = case.bearing.cage
    land = ("land_diameter", "land_width", "land_clearance")
    return qd.Cage(
        guidance=cage.guidance,
        pocket_friction=cage.pocket_friction,
        thickness=cage.thickness,
        mass=cage.mass,
        land_flow=cage.land_flow,
        free=cage.centre == "free",
        unbalance=cage.unbalance,
        unbalance_azimuth=cage.unbalance_azimuth,
        pocket_clearance=cage.pocket_clearance,
        **{name: getattr(cage, name) for name in land if getattr(cage, name) is not None},
    )
