"""Every key of a case changes exactly the fields of the built models that it is meant to change."""

import re
from pathlib import Path

import pytest

from flexbearing.build import ring_parts
from flexbearing.case import BadCase, understood
from flexbearing.case.declarations import declared
from flexbearing.case.problems import shown
from flexbearing.families import FAMILIES
from tests.flexbearing import tapered_contexts
from tests.flexbearing.built_models import built
from tests.flexbearing.case_key_effects import EFFECTS as ROWS, spelt_out

HERE = Path(__file__).parent
CONFIGS = HERE.parents[1] / "configs"

ROLLERS = ("mao2016", "nu209", "nu209_fits", "step_ring")
SLOW = ("slewing_bolted", "joshi2015_ed20", "heras2017_a1")
FAST = ("harris218",)
DEEP_GROOVE = ("6209",)
TAPERED = ("32207",)
FILES = {
    "cylindrical_roller": ROLLERS, "four_point_ball": SLOW, "angular_contact_ball": FAST,
    "deep_groove_ball": DEEP_GROOVE, "tapered_roller": TAPERED, "thrust_roller": ("81110",),
    "spherical_roller": ("22210",),
}  # fmt: skip

_HEAT = {f"operation.temperatures.{name}": value for name, value in {
    "shaft": "70 degC", "inner_ring": "75 degC", "roller": "80 degC", "outer_ring": "65 degC",
    "reference": "20 degC",
}.items()}  # fmt: skip
_RING = {"outer.kind": "ring", "outer.width": "12 mm", "outer.thickness": "5 mm"}
_HOUSED = {
    **_RING, "outer.support": "housing", "outer.housing_thickness": "10 mm", "outer.housing_width": "14 mm",
}  # fmt: skip
_ALONG = {"at": ["-60 mm", "60 mm"]}
_SHEET = {f"lubricant.data_sheet.{name}": value for name, value in {
    "name": "oil 46", "cold_temperature": "40 degC", "cold_viscosity": "46 cSt",
        "hot_temperature": "100 degC",
    "hot_viscosity": "6.8 mm^2/s", "density": "870 kg/m^3", "cold_pressure_viscosity": "20 1/GPa",
    "conductivity": "0.137 W/(m K)",
}.items()}  # fmt: skip
_STEEL = {
    "youngs_modulus": "206 GPa", "poisson_ratio": 0.3, "density": "7800 kg/m^3", "expansion": "12e-6 1/K",
}  # fmt: skip
_FITTED = {
    **{f"materials.{part}": _STEEL for part in ("shaft", "housing", "inner_ring", "outer_ring")},
    "materials.ball.expansion": "12e-6 1/K",
    **{f"operation.temperatures.{part}": "40 degC" for part in (
        "shaft", "inner_ring", "ball", "outer_ring", "housing")},
    "operation.temperatures.reference": "20 degC", "bearing.fits.shaft_interference": "15 um",
}  # fmt: skip
_NO_HOUSING = {key: value for key, value in _FITTED.items() if not key.endswith(".housing")}
_SEATS_218 = {
    "bearing.fits.bore": "90 mm",
    "bearing.fits.outer_diameter": "160 mm",
    "bearing.fits.shaft_bore": "40 mm",
}
_SEATS_209 = {
    "bearing.fits.bore": "45 mm",
    "bearing.fits.outer_diameter": "85 mm",
    "bearing.fits.shaft_bore": "20 mm",
}
_IN_218 = {"bearing.fits.housing": {"diameter": "200 mm", "interference": "10 um"}}
_IN_209 = {"bearing.fits.housing": {"diameter": "120 mm", "interference": "10 um"}}
_ELASTIC = {"youngs_modulus": "207 GPa", "poisson_ratio": 0.3}
_SEATS_ED20 = {
    "bearing.fits.bore": "17 mm", "bearing.fits.outer_diameter": "42 mm", "bearing.fits.shaft_bore": "5 mm",
    "materials.shaft": _ELASTIC, "materials.housing": _ELASTIC,
}  # fmt: skip
_COLD_FIT = {
    "materials.shaft": "100Cr6", "materials.housing": "100Cr6", "bearing.fits.shaft_interference": "15 um",
}  # fmt: skip
_COLD = {"bearing.fits.cold_clearance": "14.5 um", "bearing.clearance": None}
_OF_CLASS = {"bearing.fits.shaft_interference": None, "bearing.fits.shaft": "k5"}
_OILED = {"life.lubrication": "a_ISO", "life.cleanliness": "grease, normal cleanliness",
          "lubricant.inlet_temperature": "60 degC"}  # fmt: skip
_RATED = {**_OILED, "lubricant.oil": "ISO VG 32"}
_BY_DATA = {**_OILED, "lubricant.viscosity": "10 mPa s", "lubricant.density": "870 kg/m^3"}
_THIN_SHEET = {**_OILED, "lubricant.data_sheet": {
    "name": "oil 46", "cold_temperature": "40 degC", "cold_viscosity": "46 cSt",
    "hot_temperature": "100 degC", "hot_viscosity": "6.8 mm^2/s"}}  # fmt: skip
_IN_OIL = {"operation.control": "oil", "lubricant.inlet_temperature": "70 degC",
           "lubricant.oil_fraction": 0.02}  # fmt: skip
_EYRING = {**_IN_OIL, "lubricant.traction": "eyring", "lubricant.limiting_ratio": 0.05}
_LUBRICATED = {
    "in oil": {**_IN_OIL, "lubricant.oil": "ISO VG 32"},
    "in an Eyring oil": {
        **_EYRING, "lubricant.viscosity": "10 mPa s", "lubricant.density": "870 kg/m^3",
        "lubricant.pressure_viscosity": "18 1/GPa", "lubricant.temperature_viscosity": "0.035 1/K",
        "lubricant.conductivity": "0.14 W/(m K)",
    },
    "in an oil of a data sheet": {
        **_EYRING, **_SHEET, "lubricant.data_sheet.hot_pressure_viscosity": "15 1/GPa"},
    "in an ADORE oil": {
        **_EYRING, "lubricant.oil": "ISO VG 32", "lubricant.traction": "adore",
        "lubricant.adore_oil": "MIL-L-7808"},
    "by a traction curve": {
        **_IN_OIL, "lubricant.oil": "ISO VG 32", "lubricant.traction": "four-point",
        "lubricant.traction_curve": {"at_rest": 0.01, "peak": 0.05, "peak_slip": 0.02, "far": 0.03}},
    "in a cage on balls": {
        **_IN_OIL, "lubricant.oil": "ISO VG 32", "bearing.cage": {
            "guidance": "balls", "pocket_clearance": "0.15 mm", "pocket_friction": 0.05}},
    "in mixed lubrication": {
        **_IN_OIL, "lubricant.oil": "ISO VG 32", "lubricant.mixed": {"boundary_friction": 0.1},
        "bearing.roughness": {"ball": "0.02 um", "inner_raceway": "0.05 um", "outer_raceway": "0.05 um"}},
    "in creeping contacts": {
        **_IN_OIL, "lubricant.oil": "ISO VG 32",
        "lubricant.mixed": {"boundary_friction": 0.1, "asperity_friction": "carter"},
        "bearing.roughness": {"ball": "0.02 um", "inner_raceway": "0.05 um", "outer_raceway": "0.05 um"}},
}  # fmt: skip
_HOLDS = {
    "on side": {},
    "on springs": {"outer.support": "foundation", "outer.foundation_radial": "100 N/mm^3"},
    "on bars": {
        "outer.kind": "squirrel_cage", "outer.bars": 24, "outer.bar_width": "4 mm",
        "outer.bar_thickness": "2 mm", "outer.bar_length": "40 mm", "outer.flange_length": "10 mm",
    },
    "in housing": {
        "outer.support": "housing", "outer.housing_thickness": "10 mm", "outer.housing_width": "35 mm",
        "materials.housing": _STEEL,
    },
    "in a loose housing": {
        "outer.support": "housing", "outer.housing_thickness": "10 mm", "outer.housing_width": "35 mm",
        "materials.housing": _STEEL, "outer.housing_clearance": "10 um",
    },
    "on lines": {"outer.support": "lines", "outer.line_azimuths": ["0 deg", "120 deg", "240 deg"]},
    "in a planet": {
        "outer.support": "planet", "outer.tooth_azimuths": ["90 deg", "270 deg"],
        "outer.tooth_radial": ["-1 kN", "-1 kN"], "outer.tooth_tangential": ["2 kN", "-2 kN"],
        "outer.tooth_radius": "120 mm",
    },
}  # fmt: skip


def _elastic(shoulder, bore):
    """Settings of a bearing with fast balls between elastic rings."""
    return {
        "outer.kind": "ring", "outer.thickness": "5 mm", "outer.width": "30 mm",
        "inner.kind": "ring_on_shaft", "inner.bore": bore, "inner.width": "30 mm",
        "inner.shaft_length": "60 mm", "materials.shaft": _STEEL,
        "bearing.outer.shoulder": shoulder, "bearing.inner.shoulder": shoulder,
    }  # fmt: skip


CONTEXTS = {  # file and settings in which a key belongs to the case
    "cage": ("mao2016", {}),
    "probed": ("mao2016", {"outputs.probes.azimuths": ["0 deg", "90 deg"]}),
    "rigid": ("nu209", {}),
    "mounted": ("nu209_fits", {}),
    "floating cage": ("mao2016", {"bearing.cage.centre": "free"}),
    "two rows": ("nu209", {"bearing.second_row": {"distance": "25 mm"}}),
    "waves": ("mao2016", {"bearing.form_error": {
        "inner": {"waves": 2, "amplitude": "4 um", "crest": "10 deg", "further_waves": [3],
                  "further_amplitudes": ["2 um"], "further_crests": ["20 deg"]},
        "outer": {"waves": 2, "amplitude": "10 um", "further_waves": [5], "further_amplitudes": ["1 um"]},
        "roller_diameters": ["1 um", *["0 um"] * 29]}}),
    "foundation": ("mao2016", {
        **_RING, "outer.support": "foundation", "outer.foundation_radial": "100 N/mm^3"}),
    "seat": ("mao2016", {**_RING, "outer.support": "seat"}),
    "collar": ("mao2016", {"outer.collar_length": "2 mm", "outer.collar_thickness": "6 mm"}),
    "housing": ("mao2016", {**_HOUSED, "materials.housing": {
        "youngs_modulus": "110 GPa", "poisson_ratio": 0.26, "density": "7200 kg/m^3",
        "expansion": "10.5e-6 1/K"}}),
    "loose housing": ("mao2016", {
        **_HOUSED, "bearing.fits.housing.interference": "-60 um",
        "operation.temperatures.housing": "218 degC",
        "operation.outer_speed": "100 rpm", "materials.housing": {
            "youngs_modulus": "110 GPa", "poisson_ratio": 0.26, "density": "7200 kg/m^3",
            "expansion": "10.5e-6 1/K"},
        "operation.temperatures.outer_ring_along": {**_ALONG, "temperatures": ["213 degC", "223 degC"]},
        "operation.temperatures.housing_along": {**_ALONG, "temperatures": ["213 degC", "223 degC"]}}),
    "lines": ("mao2016", {
        **_RING, "outer.support": "lines", "outer.line_azimuths": ["0 deg", "120 deg", "240 deg"]}),
    "planet": ("mao2016", {
        **_RING, "outer.support": "planet", "outer.tooth_azimuths": ["90 deg", "270 deg"],
        "outer.tooth_radial": ["-2 kN", "-2 kN"], "outer.tooth_tangential": ["9 kN", "-9 kN"]}),
    "shaft fit": ("mao2016", {
        "inner.fit": "friction", "bearing.fits.shaft_interference": "40 um", "inner.clamping": "5 kN",
        "inner.shoulder_diameter": "66 mm",
        "operation.temperatures.shaft_along": {**_ALONG, "temperatures": ["220 degC", "240 degC"]},
        "operation.temperatures.inner_ring_along": {**_ALONG, "temperatures": ["215 degC", "225 degC"]}}),
    "step": ("step_ring", {}),
    "matrix": ("mao2016", {
        "outer.kind": "matrix", "outer.width": "12 mm", "outer.thickness": "5 mm",
        "outer.matrix": str(HERE / "seat" / "springs.mtx"), "outer.nodes": str(HERE / "seat" / "springs.inp"),
        "outer.centre_x": "3 mm"}),
    "eyring": ("nu209", {"lubricant.eyring_stress": "9 MPa"}),
    "adore": ("nu209", {"lubricant.traction": "adore", "lubricant.adore_oil": "MIL-L-7808"}),
    "traction curve": ("nu209_fits", {
        "lubricant.traction": "four-point",
        "lubricant.traction_curve": {"at_rest": 0.01, "peak": 0.05, "peak_slip": 0.02, "far": 0.03}}),
    "data sheet": ("nu209_fits", {**_SHEET, "lubricant.data_sheet.hot_pressure_viscosity": "15 1/GPa",
                                  "lubricant.oil": None, "lubricant.inlet_temperature": "70 degC"}),
    "flange": ("nu209", {**_HEAT, "bearing.flange": {
        "ring": "outer", "clearance": "30 um", "height": "2 mm", "roller_chamfer": "0.4 mm",
        "stiffness": "100 N/um", "friction": 0.05}}),
    "ribs": ("nu209", {**_HEAT, "operation.axial_load": "500 N", "bearing.ribs": {
        "inner_height": "1.5 mm", "outer_height": "1.2 mm", "end_radius": "500 mm", "friction": 0.05,
        "outside_diameter": "85 mm", "bore": "45 mm"}}),
    "rated": ("nu209", {"life.lubrication": "a_ISO", "life.cleanliness": "grease, high cleanliness",
                        "life.capacity": "iso281", "bearing.roughness": {
        "roller": "0.05 um", "inner_raceway": "0.1 um", "outer_raceway": "0.1 um"}}),
    "creeping": ("nu209_fits", {"lubricant.mixed.asperity_friction": "carter"}),
    "by rating": ("nu209", {"life.loads": "rating"}),
    "plain ring": ("mao2016", _RING),
    "cleared housing": ("mao2016", {
        **_HOUSED, "outer.housing_clearance": "60 um", "operation.temperatures.housing": "218 degC",
        "operation.outer_speed": "100 rpm"}),
    "housing with clearance": ("mao2016", {
        **_HOUSED, "bearing.fits.housing.interference": "-60 um",
        "operation.temperatures.housing": "218 degC",
        "operation.outer_speed": "100 rpm"}),
    "shaft fit, even heat": ("mao2016", {
        "inner.fit": "friction", "bearing.fits.shaft_interference": "40 um"}),
    "classes": ("nu209_fits", {
        "bearing.clearance_class": "C3", "bearing.fits.cold_clearance": None,
        "bearing.fits.shaft": "k5", "bearing.fits.shaft_interference": None,
        "bearing.fits.housing.tolerance_class": "N7", "bearing.fits.housing.interference": None}),
    "pressed housing": ("nu209_fits", {"bearing.fits.housing.interference": "20 um"}),
    "three balls": ("joshi2015_ed20", {}),
    "oscillating balls": ("slewing_bolted", {"operation.oscillation": "10 deg"}),
    "newton alone": ("mao2016", {"coupling.fallback": False, "coupling.relaxation": None}),
    **{f"{file} by newton alone": (file, {"coupling.fallback": False, "coupling.relaxation": None})
       for file in ("harris218", "6209")},
    "relaxed": ("mao2016", {"coupling.method": "relaxed"}),
    "land on the pitch circle": ("mao2016", {"bearing.cage.land_diameter": "70 mm"}),
    "held ring": ("mao2016", {"operation.tilt": "fixed"}),
    "pin in a carrier": ("mao2016", {"operation.tilt": "fixed", "operation.carrier": {
        "twist": "0.2 mrad", "load": "1 kN", "radius": "80 mm", "pin_length": "40 mm"}}),
    "balls in bolted rings": ("slewing_bolted", {
        "rings.outer.face_stiffness": "500 N/mm^3", "rings.outer.face_shear_stiffness": "200 N/mm^3",
        "rings.inner.face_stiffness": "400 N/mm^3", "rings.inner.face_shear_stiffness": "150 N/mm^3"}),
    "bolted, probed": ("slewing_bolted", {"outputs.probes.azimuths": ["0 deg", "90 deg"]}),
    "groove radii": ("slewing_bolted", {
        "bearing.inner": {"radius": "18.4 mm"}, "bearing.outer": {"radius": "18.5 mm"}}),
    "ball materials": ("slewing_bolted", {
        "materials.inner_ring": {"youngs_modulus": "205 GPa", "poisson_ratio": 0.29},
        "materials.outer_ring": {"youngs_modulus": "206 GPa", "poisson_ratio": 0.28}}),
    "contact loads": ("heras2017_a1", {}),
    "friction curve": ("heras2017_a1", {
        "friction": {"pressures": ["1 GPa", "3 GPa"], "coefficients": [0.12, 0.1]}}),
    "balls that stick": ("heras2017_a1", {"friction.model": "kalker"}),
    "fast balls": ("harris218", {}),
    "fast balls that stick": ("harris218", {"friction.model": "kalker"}),
    "fast, ruled by friction": ("harris218", {"operation.control": "coulomb", "friction.coefficient": 0.08}),
    "fast, by conformity": ("harris218", {
        "bearing.inner": {"conformity": 0.52}, "bearing.outer": {"conformity": 0.53}}),
    "fast, held": ("harris218", {"operation.load.axial": "0 N", "operation.displacement": {
        "axial": "20 um", "radial_z": "1 um", "radial_y": "2 um", "tilt_z": "0 deg", "tilt_y": "0 deg"}}),
    "fast, preloaded": ("harris218", {"operation.load.axial": "0 N", "operation.preload.force": "250 N"}),
    "fast, offset": ("harris218", {"operation.load.axial": "0 N", "operation.preload.displacement": "5 um"}),
    "fast, pair": ("harris218", {"bearing.pair": {
        "arrangement": "back_to_back", "distance": "40 mm", "preload": "250 N"}}),
    "fast, pair in rings": ("harris218", {
        "bearing.pair": {"arrangement": "back_to_back", "distance": "60 mm", "preload": "250 N"},
        "bearing.outer.shoulder": "3 mm",
        "outer.kind": "ring", "outer.thickness": "5 mm", "outer.width": "60 mm"}),
    "fast, pair with offset": ("harris218", {"bearing.pair": {
        "arrangement": "back_to_back", "distance": "40 mm", "offset": "5 um"}}),
    "fast, tandem": ("harris218", {"bearing.pair": {"arrangement": "tandem", "distance": "40 mm"}}),
    "fast, fitted": ("harris218", {**_FITTED, **_SEATS_218, **_IN_218}),
    "three balls, fitted": ("joshi2015_ed20", {**_SEATS_ED20, "bearing.fits.shaft_interference": "5 um",
        "bearing.fits.housing": {"diameter": "60 mm", "interference": "5 um"}}),
    "three balls, classes": ("joshi2015_ed20", {**_SEATS_ED20, "bearing.fits.shaft": "k5",
        "bearing.fits.housing": {"diameter": "60 mm", "tolerance_class": "N7"}}),
    "fast, without housing": ("harris218", {**_NO_HOUSING, **_SEATS_218}),
    "deep groove, without housing": ("6209", {**_NO_HOUSING, **_SEATS_209, **_COLD}),
    "fast, fitted, cold": ("harris218", {
        **_SEATS_218, **_IN_218, **_COLD_FIT}),
    "deep groove, fitted, cold": ("6209", {
        **_SEATS_209, **_IN_209, **_COLD, **_COLD_FIT}),
    "fast, fitted, turning": ("harris218", {
        **_FITTED, **_SEATS_218, **_IN_218, "operation.outer_speed": "3000 rpm"}),
    "fast, classes": ("harris218", {**_FITTED, **_SEATS_218, **_OF_CLASS, "bearing.fits.housing": {
        "diameter": "200 mm", "tolerance_class": "N7"}}),
    "deep groove, fitted": ("6209", {**_FITTED, **_SEATS_209, **_IN_209, **_COLD}),
    "deep groove, fitted, turning": ("6209", {
        **_FITTED, **_SEATS_209, **_IN_209, **_COLD, "operation.outer_speed": "3000 rpm"}),
    "deep groove, classes": ("6209", {**_FITTED, **_SEATS_209, **_OF_CLASS, "bearing.clearance": None,
        "bearing.clearance_class": "C3", "bearing.fits.housing": {
            "diameter": "120 mm", "tolerance_class": "N7"}}),
    "deep groove, preloaded": ("6209", {"operation.preload.force": "250 N"}),
    "deep groove, offset": ("6209", {"operation.preload.displacement": "5 um"}),
    "fast, tilting": ("harris218", {
        "operation.displacement.tilt_y": None, "operation.displacement.tilt_z": None}),
    **{f"{name}, {support}": (file, {**_elastic(*sizes), **_HOLDS[support]})
       for name, file, *sizes in (
           ("fast", "harris218", "5 mm", "90 mm"), ("deep groove", "6209", "3 mm", "45 mm"))
       for support in _HOLDS},
    **{f"{name}, probed": (file, {**_elastic(*sizes), "outputs.probes.azimuths": ["0 deg", "90 deg"]})
       for name, file, *sizes in (
           ("fast", "harris218", "5 mm", "90 mm"), ("deep groove", "6209", "3 mm", "45 mm"))},
    **{f"{name}, on a matrix": (file, {
        "outer.kind": "matrix", "outer.width": "12 mm", "outer.centre_x": "3 mm",
        "outer.matrix": str(HERE / "seat" / "springs.mtx"), "outer.nodes": str(HERE / "seat" / "springs.inp"),
        **sizes})
       for name, file, sizes in (
           ("deep groove", "6209", {"outer.thickness": "3.65 mm", "bearing.outer.shoulder": "2.2 mm"}),
           ("fast", "harris218", {
               "outer.thickness": "6.264 mm", "bearing.outer.shoulder": "0.9 mm", "bearing.balls": 6,
               "bearing.pitch_diameter": "50 mm"}))},
    **{f"{name}, drawn": (file, {
        "outer.kind": "step", "outer.file": "step_ring.step", "outer.clamps": ["foot"],
        "bearing.outer.shoulder": "3 mm"})
       for name, file in (("fast", "harris218"), ("deep groove", "6209"))},
    **{f"{name}, {context}": (file, settings)
       for name, file in (("fast", "harris218"), ("deep groove", "6209"))
       for context, settings in _LUBRICATED.items()},
    **{f"{name}, in a cage": (file, {
           **_IN_OIL, "lubricant.oil": "ISO VG 32", "bearing.cage": {
               "guidance": "outer", "pocket_clearance": "0.15 mm", "pocket_friction": 0.05,
               "land_diameter": land, "land_width": "4 mm", "land_clearance": "0.4 mm"}})
       for name, file, land in (("fast", "harris218", "125.26 mm"), ("deep groove", "6209", "65 mm"))},
    "fast, ring materials": ("harris218", {
        "materials.inner_ring": {"youngs_modulus": "205 GPa", "poisson_ratio": 0.29},
        "materials.outer_ring": {"youngs_modulus": "206 GPa", "poisson_ratio": 0.28}}),
    "fast, rated": ("harris218", _RATED),
    "fast, oil by its data": ("harris218", _BY_DATA),
    "fast, data sheet": ("harris218", _THIN_SHEET),
    **{f"{name}, not round": (file, {"bearing.form_error": {
        "inner": {"waves": 2, "amplitude": "4 um", "crest": "10 deg", "further_waves": [3],
                  "further_amplitudes": ["2 um"], "further_crests": ["20 deg"]},
        "outer": {"waves": 2, "amplitude": "10 um", "crest": "15 deg", "further_waves": [5],
                  "further_amplitudes": ["1 um"], "further_crests": ["5 deg"]}}})
       for name, file in (("fast", "harris218"), ("deep groove", "6209"))},
    **{f"{name}, on a cam": (file, {
        "inner.kind": "cam", "inner.cam_amplitude": "0.1 mm", "inner.cam_crest": "10 deg",
        "outer.kind": "ring",
        "outer.thickness": "5 mm", "outer.width": "30 mm", "bearing.outer.shoulder": "3 mm"})
       for name, file in (("fast", "harris218"), ("deep groove", "6209"))},
    "deep groove, rated": ("6209", _RATED),
    "deep groove, oil by its data": ("6209", _BY_DATA),
    "deep groove, data sheet": ("6209", _THIN_SHEET),
    "deep groove": ("6209", {}),
    "deep groove that sticks": ("6209", {"friction.model": "kalker"}),
    "deep groove, ruled by friction": ("6209", {
        "operation.control": "coulomb", "friction.coefficient": 0.08}),
    "deep groove, by conformity": ("6209", {
        "bearing.inner": {"conformity": 0.52}, "bearing.outer": {"conformity": 0.53}}),
    "deep groove, held": ("6209", {"operation.load.radial_z": "0 N", "operation.displacement": {
        "axial": "20 um", "radial_z": "1 um", "radial_y": "2 um", "tilt_z": "0 deg", "tilt_y": "0 deg"}}),
    "deep groove, ring materials": ("6209", {
        "materials.inner_ring": {"youngs_modulus": "205 GPa", "poisson_ratio": 0.29},
        "materials.outer_ring": {"youngs_modulus": "206 GPa", "poisson_ratio": 0.28}}),
}  # fmt: skip
CONTEXTS |= {
    f"{part} {shape}": ("nu209", {f"bearing.{part}.{name}": value for name, value in keys.items()})
    for part in tapered_contexts.PROFILED
    for shape, keys in tapered_contexts.shapes("4.8005 mm").items()
}

CONTEXTS |= tapered_contexts.CONTEXTS
EFFECTS = (*ROWS, *tapered_contexts.of_thrust(ROWS), *tapered_contexts.of_spherical(ROWS))
_OF_ROLLERS = {"roller": "0.02 um", "inner_raceway": "0.05 um", "outer_raceway": "0.05 um"}
for _context, _settings in _LUBRICATED.items():
    if "bearing.cage" not in _settings:
        _keys = {key: value for key, value in _settings.items() if key != "operation.control"}
        if "bearing.roughness" in _keys:
            _keys["bearing.roughness"] = _OF_ROLLERS
        CONTEXTS[f"tapered, {_context}"] = ("32207", {**_keys, "outputs.friction": True})
        CONTEXTS[f"thrust, {_context}"] = ("81110", {**_keys, "outputs.friction": True})


def read_in(context, change=None):
    """Case of a context, changed; None leaves out a key of the file."""
    name, settings = CONTEXTS[context]
    file, merged = CONFIGS / f"{name}.toml", {**settings, **(change or {})}
    text = file.read_text()
    for key in (key for key, value in merged.items() if value is None):
        text = re.sub(rf"^{key.rpartition('.')[2]} = .*\n", "", text, flags=re.MULTILINE)
        text = text.replace(f'"{key}",', "")
    return understood(
        text, file, {key: value for key, value in merged.items() if value is not None}, FAMILIES
    )


NOT_BUILT = {  # keys that no model is built from
    "kind": "chooses the case model",
    "bearing.kind": "there is one value",
    "assumed": "for people",
    "life.required": "judges a life, see test_card and test_findings",
    "calibrated": "for people",
    **{
        f"report.{name}": "for people, see test_html_report"
        for name in ("project", "part", "revision", "date", "author", "checker")
    },
    **{
        f"materials.{part}.name": "for people, see test_materials_by_name"
        for part in ("roller", "inner_ring", "outer_ring", "shaft", "housing", "ball")
    },
    "lubricant.data_sheet.name": "in notes only, see test_case_to_model",
    **{
        f"materials.{part}.yield_stress": "in notes only, see test_dangers"
        for part in ("inner_ring", "outer_ring", "shaft", "housing")
    },
    "outer.file": "another drawing, see test_fields_of_a_result",
    "outer.matrix": "another file, see test_matrix_of_a_case",
    "outer.nodes": "another file, see test_matrix_of_a_case",
    **{
        f"bearing.{part}.points_file": "points of another file, see test_profiles_of_a_case"
        for part in ("roller", "inner_raceway", "outer_raceway")
    },
}
BASES = {}


def fields_in(context):
    if context not in BASES:
        BASES[context] = built(read_in(context))
    return BASES[context]


def effects(context):
    """Key, value and what follows from it, of the rows with a context."""
    return [rest for name, *rest in EFFECTS if name == context]


def changed(context, key, value):
    before = fields_in(context)
    after = built(read_in(context, value if isinstance(value, dict) and key in value else {key: value}))
    absent = object()
    return {name for name in before | after if before.get(name, absent) != after.get(name, absent)}


@pytest.mark.parametrize("context", CONTEXTS)
def test_every_key_changes_the_intended_fields_and_no_others(context, monkeypatch):
    monkeypatch.setattr(ring_parts, "RACEWAY_GRID", 1e-12)  # a small change may stay within a step of it
    for key, value, names in effects(context):
        assert changed(context, key, value) == {
            field for name in names.split() for field in spelt_out(name)
        }, key


@pytest.mark.parametrize("kind", FAMILIES)
def test_every_declared_key_is_in_the_table(kind):
    shown = {key for context, key, *_ in EFFECTS if CONTEXTS[context][0] in FILES[kind]}
    keys = {item.path for item in declared(FAMILIES[kind].case()) if not item.section}
    assert keys - shown - set(NOT_BUILT) == set()
    assert shown - keys == set()


@pytest.mark.parametrize("kind", FAMILIES)
def test_every_key_of_another_choice_is_refused(kind):
    """Each key that belongs to a choice is refused in some case that made another one."""
    contexts = [name for name, (file, _) in CONTEXTS.items() if file in FILES[kind]]
    for item in declared(FAMILIES[kind].case()):
        if not item.only or item.section:
            continue
        values = [value for context, key, value, _ in EFFECTS if key == item.path and context in contexts]
        value = values[0] if values else item.example
        value = value.get(item.path, value) if isinstance(value, dict) else value
        assert any(refused(context, item.path, value) for context in contexts), item.path


def refused(context, key, value):
    try:
        read_in(context, {key: value})
    except BadCase as problem:
        return f"{shown(key)} = " in str(problem) and "is not used: it belongs to" in str(problem)
    return False
