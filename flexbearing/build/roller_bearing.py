"""From a case to the bearing: its rollers, cage and flanges at their temperatures."""

import cmath
from dataclasses import replace
from typing import Literal

import quasidynamic as qd
from flexbearing.build import clearance, held_ring, profiles, ring_parts
from flexbearing.build.expansion import hot_over_cold, material, outer_raceway_diameter, roller_length
from flexbearing.build.guided_cage import guided_cage
from flexbearing.build.lubrication import lubrication
from flexbearing.build.out_of_round import raceway_waves
from flexbearing.case.roller import Case
from quasidynamic import CylindricalRollerBearing
from quasidynamic.parts.raceway_waves import RacewayWaves
from quasidynamic.parts.roller_bearing import ONE_ROW, Flange, Ribs, RollerRow


def bearing(case: Case) -> "qd.RollerBearing":  # in quotes: checking a case loads no solver
    """Bearing of a case, ready to be solved."""
    return qd.RollerBearing(
        bearing=parts(case),
        operation=operation(case),
        lubrication=lubrication(case),
        slices=case.accuracy.slices,
        axial_modes=case.accuracy.axial_shapes,
    )


def parts(case: Case) -> qd.CylindricalRollerBearing:
    """Parts of the bearing at their temperatures, which the operating clearance already knows."""
    return qd.CylindricalRollerBearing(
        rollers=case.bearing.rollers,
        outer_raceway_diameter=outer_raceway_diameter(case),
        clearance=clearance.operating(case),
        roller=_roller(case),
        cage=_cage(case),
        inner_ring=profiles.elastic(material(case, "inner_ring")),
        outer_ring=profiles.elastic(material(case, "outer_ring")),
        contact_law=case.bearing.contact_law,
        first_roller_azimuth=case.bearing.first_roller_azimuth,
        inner_waves=_waves(case, "inner"),
        outer_waves=_waves(case, "outer"),
        roller_deviations=case.bearing.form_error.roller_diameters if case.bearing.form_error else (),
        inner_profile=profiles.of_raceway(case, "inner"),
        outer_profile=profiles.of_raceway(case, "outer"),
        rows=_rows(case),
        ribs=_ribs(case),
    )


def row_distance(case: Case) -> float:
    """Between both rows of rollers [m]; zero of one row."""
    second = case.bearing.second_row
    return 0.0 if second is None else second.distance


def _rows(case: Case) -> tuple[RollerRow, ...]:
    """The second one is towards +x."""
    second = case.bearing.second_row
    if second is None:
        return ONE_ROW
    further = RollerRow(axial=second.distance / 2, clearance=second.clearance, azimuth=second.azimuth)
    return RollerRow(axial=-second.distance / 2), further


def _ribs(case: Case) -> Ribs | None:
    """Hot ribs; the radius, of a contact of end and rib, as given."""
    ribs = case.bearing.ribs
    if ribs is None:
        return None
    return Ribs(
        inner_height=ribs.inner_height * hot_over_cold(case, "inner_ring"),
        outer_height=ribs.outer_height * hot_over_cold(case, "outer_ring"),
        end_radius=ribs.end_radius,
        friction=ribs.friction,
    )


def nominal(case: Case, bearing: qd.CylindricalRollerBearing) -> qd.CylindricalRollerBearing:
    """The bearing with the dimensions of its drawing, not of its temperatures: ratings are made for these."""
    if case.operation.temperatures is None:
        return bearing
    sizes, roller = case.bearing.roller, bearing.roller
    return replace(
        bearing,
        outer_raceway_diameter=case.bearing.outer_raceway_diameter,
        roller=replace(roller, diameter=sizes.diameter, length=sizes.length),
    )


def operation(case: Case) -> qd.Operation:
    """Load, speeds and tilt of the bearing."""
    return qd.Operation(
        radial_load=case.operation.radial_load,
        axial_load=case.operation.axial_load,
        inner_speed=case.operation.inner_speed,
        outer_speed=case.operation.outer_speed,
        load_direction=case.operation.load_direction,
        moment=case.operation.moment,
        misalignment=case.operation.slope,
        tilt_direction=case.operation.tilt_direction,
        free_tilt=case.operation.free_tilt,
        gravity=case.operation.gravity,
        gravity_direction=case.operation.gravity_direction,
    )


def flange(case: Case) -> Flange | None:
    """Hot guide flanges, their clearance as given; None when the case has none."""
    flange_case = case.bearing.flange
    if flange_case is None:
        return None
    return Flange(
        ring=flange_case.ring,
        clearance=flange_case.clearance,
        height=flange_case.height * hot_over_cold(case, f"{flange_case.ring}_ring"),
        roller_chamfer=flange_case.roller_chamfer * hot_over_cold(case, "roller"),
        stiffness=flange_case.stiffness,
        friction=flange_case.friction,
    )


def _roller(case: Case) -> qd.Roller:
    """The hot roller; it weighs what it weighed cold."""
    cold, hot = profiles.elastic(material(case, "roller")), hot_over_cold(case, "roller")
    return qd.Roller(
        diameter=case.bearing.roller.diameter * hot,
        length=roller_length(case),
        material=replace(cold, density=cold.density / hot**3),
        profile=profiles.of_roller(case),
    )


def _waves(case: Case, race: Literal["inner", "outer"]) -> RacewayWaves | None:
    form = case.bearing.form_error
    waves = None if form is None else getattr(form, race)
    if waves is None:
        return None
    return raceway_waves(waves)


def _cage(case: Case) -> qd.Cage:
    cage = case.bearing.cage
    return replace(
        guided_cage(cage),
        mass=cage.mass or 0.0,
        free=cage.centre == "free",
        unbalance=cage.unbalance,
        unbalance_azimuth=cage.unbalance_azimuth,
        pocket_clearance=cage.pocket_clearance,
    )


def build(case: Case) -> None:
    """Build bearing, flange and rings; nothing that solves is loaded."""
    bearing = parts(case)
    operation(case)
    lubrication(case)
    require_around(case, bearing)


def require_around(case: Case, bearing: CylindricalRollerBearing) -> None:
    """Build what a bearing is guided by and mounted in."""
    if guide := flange(case):
        from quasidynamic.contact.flange import flange_corner

        flange_corner(guide, bearing)
    ring_parts.outer_part(case)
    ring_parts.require_shoulder(case)
    ring_parts.require_held_in_housing(case)
    load = cmath.rect(case.operation.radial_load, case.operation.load_direction)
    held_ring.require_held_on_lines(case.outer, load)
    if case.outputs.probes:
        from flexbearing.build.probes import require_probes

        require_probes(case, ring_parts.part_of, ring_parts.why_no_solid)
