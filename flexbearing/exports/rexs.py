"""A roller bearing for gearbox programs: bearing, materials, a load case and its life as REXS 1.7.

The axis u lies along the shaft, the inner ring turns positively about it. With s the sign of its speed, x
axial and z along the load here, u = -s x, v = s y, w = -z: a right-handed system.
"""

from collections.abc import Iterator, Mapping
from math import degrees, pi
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase, understood
from flexbearing.exports.rexs_model import Component, Model, Value
from flexbearing.files import require_folder, require_output, write
from flexbearing.results import BadResult, Result

KIND = "cylindrical_roller"
CLASSES = {"C2": "C2", "CN": "C0", "C3": "C3", "C4": "C4", "C5": "C5"}  # REXS calls the normal one C0
MM, MUM, KN, MPA, PER_MINUTE, DEG = "mm", "mum", "kN", "N / mm^2", "1 / min", "deg"
PLAIN, ZERO_CELSIUS = "none", 273.15
Attributes = dict[str, tuple[Value, str]]


def export(result: Result, directory: Path) -> Iterator[Path]:
    """Write a roller bearing with its main block as the load case.

    Raises `BadCase` for ball bearings; `BadResult` if nothing was solved; `BadOutput`, `NotStored` if the
    file cannot be written.
    """
    if result.kind != KIND:
        raise BadCase(
            f'{result.place}: --to rexs takes roller bearings; this case has kind = "{result.kind}"'
        )
    state = result.flexible or result.rigid
    if not state:
        raise BadResult(f"{result.place}: nothing was solved, so there is nothing to export.")
    path = require_output(require_folder(directory) / f"{result.stem}.rexs", result.files)
    attributes = result.attributes
    made = model(_as_rated(result), attributes, state)
    write(path.resolve(), made.xml(attributes["created"], attributes["versions"]["flexbearing"]))
    yield path


def _as_rated(result: Result) -> dict[str, Any]:
    """The case with the ratings that its life was computed with."""
    about = result.attributes
    settings = about["case_overrides"]
    if not settings:
        return about["case_si"]
    case = understood(about["case_text"], Path(about["case_file"]), settings, {result.kind: result.family})
    catalogue = result.family.catalogue
    assert catalogue  # of every roller bearing
    rated = {name: rating.value for name, rating in catalogue().rated(case).given.items()}
    return about["case_si"] | {"life": about["case_si"]["life"] | rated}


def model(case: Mapping[str, Any], attributes: Mapping[str, Any], state: Mapping[str, NDArray]) -> Model:
    """Parts of a case and what the load makes of them."""
    made = Model()
    unit = made.add("gear_unit", attributes["title"])
    casing, shaft = made.add("gear_casing", "casing"), made.add("shaft", "shaft")
    bearing = made.add(
        "rolling_bearing_with_detailed_geometry", attributes["title"], **_bearing(case, attributes)
    )
    rows = [made.add("rolling_bearing_row", **_row(case)) for _ in range(_row_count(case))]
    oil = made.add("lubricant", case["lubricant"]["oil"] or "oil", **_oil(case))
    for part in (casing, shaft):
        made.relate("assembly", assembly=unit, part=part)
    made.relate("side", assembly=bearing, inner_part=shaft, outer_part=casing)
    for number, row in enumerate(rows, start=1):
        made.relate("ordered_assembly", number, assembly=bearing, part=row)
    made.relate("reference", origin=bearing, referenced=oil)
    for race in ("inner_ring", "outer_ring"):
        ring = made.add("bearing_ring", race.replace("_", " "), bearing_ring_type=(race, PLAIN))
        made.relate("assembly", assembly=bearing, part=ring)
        made.relate("reference", origin=ring, referenced=_material(made, case, race))
    made.loaded(unit, operating_time_fraction=(100.0, "%"))
    made.loaded(bearing, **_loads(case, attributes, state), **_lives(case, state))
    of_rows = np.array_split(np.arange(len(state["roller_azimuth"])), len(rows))
    steel = _material(made, case, "roller")
    for row, rollers in zip(rows, of_rows, strict=True):
        _rollers(made, row, steel, case, state, rollers)
    return made


def _row_count(case: Mapping[str, Any]) -> int:
    return 2 if case["bearing"].get("second_row") else 1


def sense(case: Mapping[str, Any]) -> float:
    """Sign of the speed of the inner ring, by which the axis u points."""
    return -1.0 if case["operation"]["inner_speed"] < 0 else 1.0


def _bearing(case: Mapping[str, Any], attributes: Mapping[str, Any]) -> Attributes:
    bearing, life = case["bearing"], case.get("life") or {}
    fits, clearance = bearing["fits"] or {}, attributes["clearance"]
    ratings = {
        "radial_dynamic_load_rating": "dynamic_rating",
        "radial_static_load_rating": "static_rating",
        "fatigue_limit_load": "fatigue_limit_load",
    }
    return {
        "bearing_type": ("radial_roller_bearing", PLAIN),
        "number_of_bearing_rows": (_row_count(case), PLAIN),
        "inner_diameter": (_times(1e3, fits.get("bore") or case["inner"]["bore"]), MM),
        "outer_diameter": (_times(1e3, fits.get("outer_diameter")), MM),
        "radial_clearance_class": (CLASSES.get(bearing["clearance_class"]), PLAIN),
        "radial_bearing_clearance": (_times(1e6, clearance.get("cold_m")), MUM),
        **{name: (_times(1e-3, life.get(key)), KN) for name, key in ratings.items()},
    }


def _row(case: Mapping[str, Any]) -> Attributes:
    bearing, roller = case["bearing"], case["bearing"]["roller"]
    length = _times(1e3, roller["length"])
    return {
        "number_of_rolling_elements": (bearing["rollers"], PLAIN),
        "reference_diameter": (1e3 * (bearing["outer_raceway_diameter"] - roller["diameter"]), MM),
        "pressure_angle": (0.0, DEG),
        "significant_contact_length_inner_ring": (length, MM),
        "significant_contact_length_outer_ring": (length, MM),
    }


def _oil(case: Mapping[str, Any]) -> Attributes:
    name = case["lubricant"]["oil"] or ""
    of_class = name.removeprefix("ISO VG ")
    viscosity = float(of_class) if of_class != name and of_class.isdecimal() else None
    return {
        "name": (name or None, PLAIN),
        "viscosity_at_40_degree_celsius": (viscosity, "mm^2 / s"),
    }


def _material(made: Model, case: Mapping[str, Any], part: str) -> Component:
    material = case["materials"][part]
    return made.add(
        "material",
        material.get("name") or part.replace("_", " "),
        material_designation=(material.get("name"), PLAIN),
        elastic_modulus=(1e-6 * material["youngs_modulus"], MPA),
        poisson_ratio=(material["poisson_ratio"], PLAIN),
        density=(_times(1e-3, material.get("density")), "kg / dm^3"),
        thermal_expansion_coefficient_plus=(_times(1e6, material.get("expansion")), "1e-6 / C"),
        yield_strength=(_times(1e-6, material.get("yield_stress")), MPA),
    )


def _loads(
    case: Mapping[str, Any], attributes: Mapping[str, Any], state: Mapping[str, NDArray]
) -> Attributes:
    """Load case of the bearing: forces and moments on the inner ring, its motion, pressures and losses."""
    turns, operation = sense(case), case["operation"]
    force, moment, place = state["applied_load"], state["ring_moment"], state["ring_displacement"]
    tilt, pressure = state["ring_tilt"], state["peak_pressure"]  # slopes (dz/dx, dy/dx) and their moments
    rpm, turned = 30 / pi * turns, np.array([turns, -1.0])  # (y, z) to (v, w)
    force_v, force_w = turned * force
    moment_v, moment_w = turned * (-moment[0], moment[1])  # about y is -dz/dx
    tilt_v, tilt_w = turned * (-tilt[0], tilt[1])
    place_v, place_w = 1e6 * turned * place
    found: Attributes = {
        "force_acting_on_inner_component_u": (0.0, "N"),
        "force_acting_on_inner_component_v": (float(force_v), "N"),
        "force_acting_on_inner_component_w": (float(force_w), "N"),
        "torque_acting_on_inner_component_v": (float(moment_v), "N m"),
        "torque_acting_on_inner_component_w": (float(moment_w), "N m"),
        "displacement_inner_side_v": (float(place_v), MUM),
        "displacement_inner_side_w": (float(place_w), MUM),
        "tilting_inner_side_v": (degrees(tilt_v), DEG),
        "tilting_inner_side_w": (degrees(tilt_w), DEG),
        "speed_inner_ring": (rpm * operation["inner_speed"], PER_MINUTE),
        "speed_outer_ring": (rpm * operation["outer_speed"], PER_MINUTE),
        "speed_rolling_element_set": (rpm * float(state["cage_speed"]), PER_MINUTE),
        "operating_radial_bearing_clearance": (1e6 * attributes["clearance"]["operating_m"], MUM),
        "temperature_lubricant": (case["lubricant"]["inlet_temperature"] - ZERO_CELSIUS, "C"),
        "maximum_hertzian_pressure_inner_ring": (1e-6 * float(pressure[0]), MPA),
        "maximum_hertzian_pressure_outer_ring": (1e-6 * float(pressure[1]), MPA),
        "total_frictional_torque": (abs(float(state["driving_torque"])), "N m"),
        "total_frictional_power_loss": (float(state["driving_power"]), "W"),
    }
    if "stiffness" in state:
        found["radial_stiffness"] = (float(state["stiffness"]), "N / m")
    return found


def _lives(case: Mapping[str, Any], state: Mapping[str, NDArray]) -> Attributes:
    """Lives by ISO/TS 16281; those by other capacities have no name in REXS."""
    if (case.get("life") or {}).get("capacity") != "iso281":
        return {}
    found: Attributes = {}
    hours = 2 * pi / (3600 * abs(float(state["relative_speed"])))  # that a revolution takes
    for name, key in (("nominal", "life_L10"), ("modified", "modified_life")):
        if key in state:
            turns, stem = float(state[key]), f"{name}_reference_rating_life"
            found[f"{stem}_rotations_iso_16281_2008"] = (1e-6 * turns, "MRev")
            found[f"{stem}_time_iso_16281_2008"] = (hours * turns, "h")
    return found


def _rollers(
    made: Model,
    row: Component,
    material: Component,
    case: Mapping[str, Any],
    state: Mapping[str, NDArray],
    numbers: NDArray,
) -> None:
    """Every roller of a row with its contacts: loads and pressures along it."""
    roller, turns = case["bearing"]["roller"], sense(case)
    azimuth, place = state["roller_azimuth"], state["slice_position"]
    angles = np.degrees(np.arctan2(-np.cos(azimuth), turns * np.sin(azimuth))) % 360.0  # from v towards w
    order = np.argsort(-turns * place)  # along u
    width = (place[-1] - place[0]) / (len(place) - 1) if len(place) > 1 else roller["length"]
    for place_in_row, number in enumerate(numbers.tolist(), start=1):
        element = made.add(
            "rolling_element",
            f"roller {number + 1}",
            diameter_of_rolling_element=(1e3 * roller["diameter"], MM),
            length_of_rolling_element=(1e3 * roller["length"], MM),
            roller_crowning_radius=(_times(1e3, roller["crown_radius"]), MM),
            angular_position_around_u=(float(angles[number]), DEG),
        )
        made.relate("ordered_assembly", place_in_row, assembly=row, part=element)
        made.relate("reference", origin=element, referenced=material)
        for race in ("inner", "outer"):
            contact = made.add(
                "rolling_element_contact",
                f"roller {number + 1}, {race} raceway",
                rolling_element_contact_type=(f"{race}_raceway_contact", PLAIN),
            )
            made.relate("assembly", assembly=element, part=contact)
            made.loaded(
                contact,
                rolling_element_force=(1e-3 * float(state[f"{race}_load"][number]), KN),
                rolling_element_coordinate=((-turns * 1e3 * place)[order], MM),
                rolling_element_lamina_load=(width * state[f"{race}_slice_load"][number][order], "N"),
                rolling_element_pressure=(1e-6 * state[f"{race}_pressure"][number][order], MPA),
            )


def _times(factor: float, value: float | None) -> float | None:
    return None if value is None else factor * value
