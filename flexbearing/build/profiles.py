"""From a case to the profiles of its rollers and raceways."""

import re
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

import quasidynamic as qd
from flexbearing import inputs
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.case.roller.profile import Generatrix
from flexbearing.inputs.file import POINTS
from flexbearing.printable import excerpt
from flexbearing.units import BadUnit, UnknownUnit, unit
from quasidynamic import ImpossiblePart
from quasidynamic.contact.line import fujiwara_kawase, johns_gohar, lundberg, reduced_radius
from quasidynamic.parts.material import contact_modulus
from quasidynamic.parts.profile import Hollow

if TYPE_CHECKING:
    from flexbearing.case.tapered import TaperedCase

    RollerCase = Case | TaperedCase

Race = Literal["inner", "outer"]
RACES: tuple[Race, Race] = "inner", "outer"
OF_ISO = 0.00035  # A over the roller's diameter [-], ISO/TS 16281
COLUMNS = ("position", "drop")
HEADING = re.compile(r"\s*(position|drop)\s*\[([^\[\]]+)\]\s*")
_HEADER = 'a header holds "position [mm]" and "drop [um]", each with a unit of length'


def of_roller(case: "RollerCase") -> qd.Profile:
    """Profile of the rollers; one for a design load belongs to the inner contact."""
    own: Any = case.bearing
    if case.kind == "spherical_roller":
        return qd.Crowned(straight_length=0.0, crown_radius=own.profile_radius)
    return _profile(case, case.bearing.roller, "inner", "bearing.roller")


def of_raceway(case: "RollerCase", race: Race) -> qd.Profile:
    """Profile of a raceway along the rollers."""
    own: Any = case.bearing
    if case.kind == "spherical_roller":
        return Hollow(radius=own.raceway_profile_radius(race))
    table = getattr(own, f"{race}_raceway")
    return qd.Straight() if table is None else _profile(case, table, race, f"bearing.{race}_raceway")


def drawn(case: "RollerCase", number: int = 121) -> dict[str, tuple[NDArray, NDArray]]:
    """Profiles that are not straight, from end to end of a cold roller.

    Raises `BadCase` where points of a profile cannot be read or are none of such a roller.
    """
    length = case.bearing.roller.length
    places = length / 2 * np.sin(np.linspace(-np.pi / 2, np.pi / 2, number))
    try:
        all_of_them = {"bearing.roller": of_roller(case)} | {
            f"bearing.{race}_raceway": of_raceway(case, race) for race in RACES
        }
    except ImpossiblePart as problem:
        raise BadCase(str(problem)) from problem
    with np.errstate(divide="ignore"):  # logarithmic ends
        drops = {table: profile.drop(places, length) for table, profile in all_of_them.items()}
    return {table: (places, drop) for table, drop in drops.items() if drop.any()}


def _profile(case: "RollerCase", table: Generatrix, race: Race, name: str) -> qd.Profile:
    """Profile of a roller or a raceway; at its temperature it is as long as the roller."""
    given: Any = table  # which values are there depends on the profile, checked on reading
    match table.profile:
        case "straight":
            return qd.Straight()
        case "crowned":
            return qd.Crowned(straight_length=given.straight_length, crown_radius=given.crown_radius)
        case "tangent_crowned":
            return qd.TangentCrowned(straight_length=given.straight_length, crown_radius=given.crown_radius)
        case "logarithmic":
            return qd.Logarithmic(amplitude=given.drop)
        case "iso16281":
            return qd.Logarithmic(amplitude=OF_ISO * case.bearing.roller.diameter)
        case "points":
            return _through_points(case, table, name)
        case _:
            return _designed(case, given, race)


def _designed(case: "RollerCase", given: Any, race: Race) -> qd.Profile:
    """Profile for a design load, under the modulus and the radius of a contact."""
    roller = case.bearing.roller
    radius = reduced_radius(roller.diameter / 2, case.bearing.raceway_radius(race))
    pair = (getattr(case.materials, part) for part in ("roller", f"{race}_ring"))
    load, length, modulus = given.design_load, roller.length, contact_modulus(*map(elastic, pair))
    if given.profile == "lundberg":
        return lundberg(load, length, modulus)
    if given.profile == "johns_gohar":
        return johns_gohar(load, length, modulus, radius)
    return fujiwara_kawase(
        load,
        length,
        modulus,
        load_factor=given.load_factor,
        crowned_share=given.crowned_share,
        end_drop=given.end_drop,
    )


def elastic(solid: Any) -> qd.Material:
    """Material of the bearing model."""
    return qd.Material(
        youngs_modulus=solid.youngs_modulus, poisson_ratio=solid.poisson_ratio, density=solid.density
    )


def _through_points(case: "RollerCase", table: Generatrix, name: str) -> qd.Profile:
    name_of_file = table.points_file
    file = None if name_of_file is None else Path(case.source.path).parent / name_of_file
    try:
        lists = (table.point_positions, table.point_drops) if file is None else points(file)
        positions, drops = map(np.array, lists)
        return qd.PointsProfile.through(positions, drops, case.bearing.roller.length)
    except ImpossiblePart as problem:
        raise ImpossiblePart(f"{name}: {problem}") from problem


def points(file: Path) -> tuple[NDArray, NDArray]:
    """Positions and drops (n) [m] of a file with two columns, a table as `inputs.cells` reads it.

    Raises `ImpossiblePart` where it cannot be read, or is no such table.
    """
    try:
        return _read(inputs.stamp(file))
    except (ImpossiblePart, inputs.Unreadable, inputs.BadNumber) as problem:
        raise ImpossiblePart(f'"{excerpt(file.name)}": {problem}') from problem


@lru_cache(maxsize=64)  # variants of a case have it in common
def _read(stamp: inputs.Stamp) -> tuple[NDArray, NDArray]:
    lines = inputs.cells(inputs.text(stamp.path, POINTS), POINTS)
    header, rows = next(lines, []), [*lines]
    scales = dict(map(_heading, header))
    if len(header) != len(COLUMNS) or set(scales) != set(COLUMNS):
        raise ImpossiblePart(f"has {len(header)} columns: {_HEADER}")
    if short := next((row for row in rows if len(row) != len(COLUMNS)), None):
        raise ImpossiblePart(f"has a row of {len(short)} numbers, not {len(COLUMNS)}")
    table = np.array([[inputs.number(cell) for cell in row] for row in rows]).reshape(-1, len(COLUMNS))
    of = dict(zip((_heading(cell)[0] for cell in header), table.T, strict=True))
    return of["position"] * scales["position"], of["drop"] * scales["drop"]


def _heading(cell: str) -> tuple[str, float]:
    """Quantity of a column, and its unit in metres."""
    parts = HEADING.fullmatch(cell)
    try:
        given = None if parts is None else unit(parts[2].strip())
    except (BadUnit, UnknownUnit):
        given = None
    if parts is None or given is None or given.powers != unit("m").powers:
        raise ImpossiblePart(f"has a column {excerpt(cell)!r}: {_HEADER}")
    return parts[1], given.scale
