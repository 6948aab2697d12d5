"""Everything that a case is built into, without solving: fields of the models by dotted names."""

from contextlib import suppress
from dataclasses import fields, is_dataclass, replace
from functools import partial
from unittest.mock import patch

import numpy as np

import quasidynamic as qd
from flexbearing.build import expansion, ring_parts, roller_bearing, seat_growth, tapered_bearing
from flexbearing.build.ball_fits import kinematic_viscosity
from flexbearing.build.lubrication import lubrication, roughness
from flexbearing.build.mesh_sizes import IN_SPACE, mesh_size
from flexbearing.build.probes import probes
from flexbearing.case.roller import Case
from flexbearing.families import FAMILIES
from flexbearing.progress import Logged
from flexbearing.rings import condensed, cones, grooves, resolution
from flexbearing.runs import angular_contact, four_point

OIL = qd.Lubricant(
    temperature=300.0, viscosity=0.02, pressure_viscosity=2e-8, temperature_viscosity=0.03, conductivity=0.1,
    density=900.0,
)  # fmt: skip
CONTACT = {"radius": 2e-3, "modulus": 2e11, "length": 5e-3, "oil": OIL}
DIRECT = (  # tables and keys that are read where they are used, without a model between
    "title", "life.", "outputs.stresses", "outputs.subsurface_stresses", "outputs.assumed_effects",
    "outputs.catalogue_life", "coupling.", "accuracy.target", "accuracy.structure",
    "accuracy.threads", "accuracy.harmonics", "rolling_lines.", "fields.", "friction.torque",
    "friction.model", "friction.cells", "operation.mode",
    "bearing.ribs.outside_diameter", "bearing.ribs.bore",
    "operation.roller_positions", "operation.contact_loads", "operation.speed", "bearing.inner.shoulder",
    "bearing.outer.shoulder", "operation.oscillation",
)  # fmt: skip


class Stop(Exception):
    """The finite elements would begin here."""


def built(case):
    """Fields of everything that the case is built into, by dotted names."""
    FAMILIES[case.kind].build()(case)
    makers = {"cylindrical_roller": _roller, "four_point_ball": _four_point, "tapered_roller": _tapered}
    makers |= dict.fromkeys(("thrust_roller", "spherical_roller"), _tapered)
    models = makers.get(case.kind, _angular)(case)
    models["case"] = {
        path: value
        for path, value in leaves(case.model_dump())
        if path.startswith(DIRECT)
        or path in ("bearing.contact", "bearing.rib.friction")
        or (
            case.kind in ("tapered_roller", "thrust_roller", "spherical_roller") and path == "accuracy.slices"
        )
    }
    return dict(leaves(models))


def leaves(value, path=""):
    """Values of dataclasses, mappings and tuples by dotted names; `is` names the class."""
    if isinstance(value, partial):
        value = {"law": value.func, **value.keywords}
    if is_dataclass(value) and not isinstance(value, type):
        inside = {
            entry.name: getattr(value, entry.name) for entry in fields(value) if entry.name != "drawing"
        }
        value = {"is": type(value).__name__, **inside}
    if isinstance(value, tuple | list):
        value = dict(enumerate(value))
    if isinstance(value, dict):
        for name, inside in value.items():
            yield from leaves(inside, f"{path}.{name}" if path else str(name))
    elif callable(value):
        yield path, getattr(value, "__qualname__", repr(type(value)))
    else:
        yield path, str(value.tolist()) if isinstance(value, np.ndarray) else value


def _roller(case: Case):
    model = roller_bearing.bearing(case)
    outer, inner = ring_parts.outer_part(case), ring_parts.inner_part(case)
    return {
        "model": model,
        "law": model.lubrication.traction(**CONTACT),
        "roughness": roughness(case),
        "flange": roller_bearing.flange(case),
        "outer": outer,
        "inner": inner,
        "mesh": mesh_size(case, IN_SPACE),
        "patches": resolution.patches(case, np.zeros(1)),
        "inner_fit": _fit(lambda: condensed.raceway(case, "inner", np.zeros(1), Logged()))
        if inner and case.inner.fit != "bonded"
        else None,
        "outer_fit": _fit(lambda: condensed.raceway(case, "outer", np.zeros(1), Logged()))
        if case.lifts_off
        else None,
        "seat": {"strain": seat_growth.seat_strain(case)},
        "running": {"roller_length": expansion.roller_length(case)},
        "probes": _probes(case),
    }


def _probes(case):
    return {race: probes(case, race) for race in ring_parts.NAMES}


def _fit(condense):
    """What a fit is built from: its bodies, how their heat varies, and its loads."""
    seen = {}

    def fitted(part, resolution, fit, variations):
        seen.update(part=part, heat=variations, length=resolution.length, modes=resolution.axial_modes,
                    mesh=resolution.mesh_size, fit=fit)  # fmt: skip
        raise Stop

    with patch("fem.joint.preloaded_fit.fitted", fitted):
        try:
            condense()
        except Stop:
            return seen
    raise AssertionError("no fit was condensed")


def _four_point(case):
    found = {"model": four_point.bearing(case), "load": _given_load(case), "probes": _probes(case)}
    return _elastic_grooves(case) | found


def _tapered(case):
    model, operation = tapered_bearing.build(case)
    viscosity = None if case.lubricant is None else kinematic_viscosity(case.lubricant)[0]
    inner, outer = (None, None) if case.rigid else cones.parts(case)
    elastic = {race: each[0] for race, each in (("inner", inner), ("outer", outer)) if each}
    fineness = next((each[2] for each in (inner, outer) if each), None)
    oiled = lubrication(case) if case.outputs.friction else None
    return {
        "model": {"bearing": model, "lubrication": oiled}, "operation": operation, "viscosity": viscosity,
        "law": oiled and oiled.traction(**CONTACT), "roughness": roughness(case),
        "cage": tapered_bearing.cage(case), "resolution": fineness, **elastic,
    }  # fmt: skip


def _given_load(case):
    """Load that the solution would begin with."""
    seen = []

    def solve(self, load, *_, **__):
        seen.append(load)
        raise Stop

    with patch.object(qd.FourPointBallBearing, "solve", solve), suppress(Stop):
        four_point.solved(case)
    return seen


def _elastic_grooves(case):
    """Parts with grooves, and how they are resolved."""
    found = {}
    for race, arguments in zip(grooves.RACES, grooves.parts(case), strict=True):
        if arguments is None:
            continue
        part, _, resolution = arguments
        stations = resolution.stations
        found[race] = {
            "part": part, "mesh": resolution.mesh_size, "width": stations.width, "last": stations.angles[-1],
            "stations": len(stations.angles), "length": resolution.length,
        }  # fmt: skip
    return found


def _angular(case):
    model = angular_contact.on_cam(case, angular_contact.bearing(case))
    return _elastic_grooves(case) | {
        "model": replace(model, bearing=replace(model.bearing, approaches=())),
        "approach": dict(zip(("first", "second"), model.bearing.approaches, strict=False)),
        "operation": angular_contact.operation(case),
        "law": model.lubrication and model.lubrication.traction(**CONTACT),
        "roughness": roughness(case),
        "viscosity": None if case.lubricant is None else kinematic_viscosity(case.lubricant)[0],
        "probes": _probes(case), "fit": grooves.fit_of(case),
    }  # fmt: skip
