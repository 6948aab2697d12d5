"""Contexts of tapered roller bearings in `case_key_effects`, and the profiles that all rollers have."""

from flexbearing.case.declarations import declared
from flexbearing.case.tapered.spherical_case import SphericalCase
from flexbearing.case.tapered.thrust_case import ThrustCase
from tests.flexbearing.case_key_effects import spelt_out

_STEEL = {"youngs_modulus": "206 GPa", "poisson_ratio": 0.3, "density": "7800 kg/m^3"}
_FILE = {
    "bearing.cone_angle": "10 deg",
    **{f"materials.{part}": _STEEL for part in ("roller", "inner_ring", "outer_ring")},
}
_OILED = {
    **_FILE, "life.lubrication": "a_ISO", "life.cleanliness": "grease, normal cleanliness",
    "lubricant.inlet_temperature": "60 degC",
}  # fmt: skip
_SHEET = {f"lubricant.data_sheet.{name}": value for name, value in {
    "name": "oil 46", "cold_temperature": "40 degC", "cold_viscosity": "46 cSt",
    "hot_temperature": "100 degC", "hot_viscosity": "6.8 mm^2/s"}.items()}  # fmt: skip


def shapes(end):
    """Profiles of rollers and raceways, up to a place at their end."""
    points = {"point_positions": ["0 mm", "2.5 mm", end], "point_drops": ["0 um", "1 um", "12 um"]}
    return {
        "crowned": {"profile": "crowned", "straight_length": "4 mm", "crown_radius": "600 mm"},
        "logarithmic": {"profile": "logarithmic", "drop": "1.75 um"},
        "designed": {"profile": "fujiwara_kawase", "design_load": "4 kN", "load_factor": 1.5,
                     "crowned_share": 0.6, "end_drop": "20 um"},
        "points": {"profile": "points", **points},
    }  # fmt: skip


PROFILED = "roller", "inner_raceway", "outer_raceway"
_SPRINGS = {f"outer.foundation_{direction}": "200 N/mm^3" for direction in ("radial", "axial", "tangential")}
_ELASTIC = {"youngs_modulus": "110 GPa", "poisson_ratio": 0.26}
_CUP = {**_FILE, "outer.kind": "ring", "outer.thickness": "5 mm", "outer.width": "19 mm"}
_WARM = {**_STEEL, "expansion": "12e-6 1/K"}
_SEATS = {f"bearing.fits.{name}": value for name, value in {
    "bore": "35 mm", "outer_diameter": "72 mm", "shaft_bore": "10 mm"}.items()}  # fmt: skip
_PARTS = "shaft", "inner_ring", "roller", "outer_ring"
_WITHOUT_HOUSING = {
    **_FILE, **_SEATS, "bearing.fits.shaft_interference": "15 um", "materials.shaft": _WARM,
    **{f"materials.{part}": _WARM for part in ("roller", "inner_ring", "outer_ring")},
    **{f"operation.temperatures.{part}": "40 degC" for part in _PARTS},
    "operation.temperatures.reference": "20 degC",
}  # fmt: skip
_FITTED = {
    **_WITHOUT_HOUSING, "materials.housing": _WARM, "operation.temperatures.housing": "40 degC",
    "bearing.fits.housing": {"diameter": "100 mm", "interference": "10 um"},
    "operation.outer_speed": "3000 rpm",
}  # fmt: skip
CONTEXTS = {
    "tapered": ("32207", _FILE),
    "tapered, free to tilt": ("32207", {**_FILE, "operation.tilt": "free"}),
    "tapered, held": ("32207", {
        **_FILE, "operation.load.axial": "0 N", "operation.load.radial_z": "0 N",
        "operation.displacement": {"axial": "20 um", "radial_y": "1 um", "radial_z": "2 um"}}),
    "tapered, fitted": ("32207", _FITTED),
    "tapered, without housing": ("32207", _WITHOUT_HOUSING),
    "tapered, classes": ("32207", {
        **_FILE, **_SEATS, "bearing.fits.shaft": "k5", "materials.shaft": _STEEL, "materials.housing": _STEEL,
        "bearing.fits.housing": {"diameter": "100 mm", "tolerance_class": "N7"}}),
    "tapered, cup": ("32207", _CUP),
    "tapered, cup on springs": ("32207", {**_CUP, "outer.support": "foundation", **_SPRINGS}),
    "tapered, cup in a housing": ("32207", {
        **_CUP, "outer.support": "housing", "outer.housing_thickness": "8 mm", "outer.housing_width": "25 mm",
        "materials.housing": _ELASTIC}),
    "tapered, cone on a shaft": ("32207", {
        **_FILE, "inner.kind": "ring_on_shaft", "inner.bore": "35 mm", "inner.width": "17 mm",
        "inner.shaft_length": "40 mm", "materials.shaft": _ELASTIC}),
    **{f"tapered, {name}": ("32207", {**_FILE, "bearing.pair": {
        "arrangement": "back_to_back", "distance": "40 mm", **more}})
       for name, more in (("pair", {"preload": "2 kN"}), ("pair with offset", {"offset": "5 um"}))},
    "tapered, pair of cups": ("32207", {
        **_CUP, "outer.thickness": "12 mm", "outer.width": "60 mm", "bearing.pair": {
            "arrangement": "back_to_back", "distance": "40 mm", "offset": "5 um"}}),
    "tapered, tandem": ("32207", {**_FILE, "bearing.pair": {"arrangement": "tandem", "distance": "40 mm"}}),
    **{f"tapered, cage on {guide}": ("32207", {
        **_FILE, "outputs.friction": True, "lubricant.oil": "ISO VG 32", "lubricant.oil_fraction": 0.02,
        "lubricant.inlet_temperature": "60 degC", **{f"bearing.cage.{name}": value for name, value in {
            "guidance": "rollers", "pocket_friction": 0.05, "thickness": "2 mm", **more}.items()}})
       for guide, more in (("rollers", {}), ("a land", {
           "guidance": "outer", "land_diameter": "60 mm", "land_width": "3 mm",
           "land_clearance": "0.4 mm"}))},
    "tapered, rated": ("32207", {**_OILED, "lubricant.oil": "ISO VG 32"}),
    "tapered, oil by its data": ("32207", {
        **_OILED, "lubricant.viscosity": "10 mPa s", "lubricant.density": "870 kg/m^3"}),
    "tapered, data sheet": ("32207", {**_OILED, **_SHEET}),
    **{
        f"tapered, {part} {shape}": ("32207", {
            **_FILE, **{f"bearing.{part}.{name}": value for name, value in keys.items()}})
        for part in PROFILED
        for shape, keys in shapes("7.5 mm").items()
    },
}  # fmt: skip

_BARRELS = {f"materials.{part}": _STEEL for part in ("roller", "inner_ring", "outer_ring")}
_RATED = {**_BARRELS, "life.lubrication": "a_ISO", "life.cleanliness": "grease, normal cleanliness",
          "lubricant.inlet_temperature": "60 degC"}  # fmt: skip
CONTEXTS |= {
    "spherical": ("22210", _BARRELS),
    "spherical, held": ("22210", {
        **_BARRELS, "operation.load.axial": "0 N", "operation.load.radial_z": "0 N",
        "operation.displacement": {"axial": "20 um", "radial_y": "1 um", "radial_z": "2 um"}}),
    "spherical, rated": ("22210", {**_RATED, "lubricant.oil": "ISO VG 32"}),
    "spherical, oil by its data": ("22210", {
        **_RATED, "lubricant.viscosity": "10 mPa s", "lubricant.density": "870 kg/m^3"}),
    "spherical, data sheet": ("22210", {**_RATED, **_SHEET}),
}  # fmt: skip

_WASHERS = {  # rollers of the tapered bearing between washers
    **{key: value for key, value in CONTEXTS["tapered"][1].items() if key != "bearing.cone_angle"},
    "bearing.rollers": 17, "bearing.pitch_diameter": "90 mm", "bearing.roller.diameter": "8.8 mm",
    "bearing.roller.length": "15 mm", "operation.load.moment_y": None, "operation.tilt": "fixed",
    "bearing.contact_law": "palmgren",
}  # fmt: skip
_SHARED = (
    "", ", free to tilt", ", held", ", cage on a land", ", cage on rollers", ", rated", ", oil by its data",
    ", data sheet",
)  # fmt: skip
_OF_WASHERS = [
    name[7:] for name in CONTEXTS if name[7:] in _SHARED or "raceway " in name or "roller " in name
]
CONTEXTS |= {
    f"thrust{context}": ("81110", {**_WASHERS, **{
        key: {"axial": "20 um"} if key == "operation.displacement" else value
        for key, value in CONTEXTS[f"tapered{context}"][1].items()
        if key not in ("bearing.cone_angle", "operation.load.radial_z")}})
    for context in _OF_WASHERS
}  # fmt: skip


_CIRCLES = "{inner_profile.radius,outer_profile.radius,roller.profile.crown_radius}"
_OF_BARRELS = (  # key, value, its fields below model.bearing
    ("rollers", 17, "rollers"),
    ("pitch_diameter", "71 mm", f"pitch_diameter rows.{{0.axial,1.axial}} {_CIRCLES}"),
    ("contact_angle", "9.1 deg",
     f"cone_angle cup_angle rib.angle rows.{{0.axial,1.axial}} {_CIRCLES}"),
    ("outer_osculation", 0.96, "inner_profile.radius roller.profile.crown_radius"),
    ("inner_osculation", 0.96, "inner_profile.radius"),
    ("clearance", "21 um", "clearance"),
    ("contact_law", "palmgren", "contact_law"),
    ("first_roller_azimuth", "1 deg", "first_roller_azimuth"),
    ("roller.diameter", "10.9 mm", f"roller.diameter {_CIRCLES}"),
    ("roller.length", "7.4 mm", "roller.length"),
)  # fmt: skip


def _shared(effects, kind, case):
    """Rows of tapered rollers with keys that another kind has, where no rib changes."""
    keys = {item.path for item in declared(case)}
    for context, key, value, names in effects:
        there = context.replace("tapered", kind)
        if context.startswith("tapered") and key in keys:
            each = (name for part in names.split() for name in spelt_out(part) if ".rib." not in name)
            yield there, key, value, " ".join(each)


def of_thrust(effects):
    """Rows of rollers between washers."""
    for context, key, value, names in _shared(effects, "thrust", ThrustCase):
        yield context, key, "91 mm" if key == "bearing.pitch_diameter" else value, names


def of_spherical(effects):
    """Rows of barrels in a sphere."""
    for row in _shared(effects, "spherical", SphericalCase):
        if row[0] in CONTEXTS and not row[1].startswith("bearing."):
            yield row
    for key, value, names in _OF_BARRELS:
        yield (
            "spherical",
            f"bearing.{key}",
            value,
            " ".join(f"model.bearing.{name}" for name in names.split()),
        )
