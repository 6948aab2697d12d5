"""From a case to a tapered roller bearing and what is asked of it."""

from dataclasses import replace

import quasidynamic as qd
from flexbearing.build import profiles, tapered_fits
from flexbearing.build.guided_cage import guided_cage
from flexbearing.case.balls.pair import Pair
from flexbearing.case.tapered import TaperedCase
from quasidynamic.parts.angular_contact_bearing import RowPlace
from quasidynamic.parts.roller_bearing import FREE_POCKETS
from quasidynamic.parts.tapered_bearing import spherical_rib, without_rib


def bearing(case: TaperedCase) -> qd.TaperedRollerBearing:
    """Bearing of a case; raises `ImpossiblePart` where there is none."""
    own = case.bearing
    roller = qd.Roller(
        diameter=own.roller.diameter,
        length=own.roller.length,
        material=profiles.elastic(case.materials.roller),
        profile=profiles.of_roller(case),
    )
    axis, cone = own.angles
    ring = profiles.elastic(case.materials.inner_ring)
    one = qd.TaperedRollerBearing(
        rollers=own.rollers,
        pitch_diameter=own.pitch_diameter,
        cup_angle=own.cup_angle,
        cone_angle=cone,
        roller=roller,
        rib=without_rib(axis)
        if own.rib is None
        else spherical_rib(roller, axis, own.rib.angle, own.rib.end_radius, ring),
        inner_ring=ring,
        outer_ring=profiles.elastic(case.materials.outer_ring),
        clearance=own.radial_clearance,
        contact_law=own.contact_law,
        first_roller_azimuth=own.first_roller_azimuth,
        inner_profile=profiles.of_raceway(case, "inner"),
        outer_profile=profiles.of_raceway(case, "outer"),
    )
    if own.pair is not None:
        return replace(one, rows=_rows(case, own.pair, one))
    return one if own.fits is None else replace(one, rows=(RowPlace(closer=tapered_fits.closer(case)),))


def cage(case: TaperedCase) -> qd.Cage:
    """Cage of every row; one that the rollers guide in pockets without friction where the case has none."""
    own = case.bearing.cage
    return FREE_POCKETS if own is None else guided_cage(own)


def rib_friction(case: TaperedCase) -> float:
    """Coulomb friction of the ends on the rib [-], 0 without one."""
    return case.bearing.rib.friction if case.bearing.rib else 0.0


def _rows(case: TaperedCase, pair: Pair, one: qd.TaperedRollerBearing) -> tuple[RowPlace, RowPlace]:
    """Rows of a pair; that at +x is the mirrored one in O, the other one in X."""
    closer = pair.offset or 0.0
    if pair.preload is not None:
        straight = qd.RingOperation(load=(pair.preload, 0, 0, 0, 0), displacement=(None, 0, 0, 0, 0))
        closer = float(qd.tapered_loads(one, straight, case.accuracy.slices).displacement[0])
    closer += 0.0 if case.bearing.fits is None else tapered_fits.closer(case)
    places = {"back_to_back": (False, True), "face_to_face": (True, False), "tandem": (False, False)}
    first, second = (
        RowPlace(axial=sign * pair.distance / 2, closer=closer, mirrored=mirrored)
        for sign, mirrored in zip((-1, 1), places[pair.arrangement], strict=True)
    )
    return first, second


def operation(case: TaperedCase) -> qd.RingOperation:
    """Load, displacement and speeds of a case."""
    return qd.RingOperation(
        load=case.operation.load.values,
        displacement=case.operation.places,
        inner_speed=case.operation.inner_speed,
        outer_speed=case.operation.outer_speed,
    )


def build(case: TaperedCase) -> tuple[qd.TaperedRollerBearing, qd.RingOperation]:
    """Bearing and operation; raises `ImpossiblePart` where they cannot be."""
    return bearing(case), operation(case)
