"""Keys of tapered roller bearings, as rows of `case_key_effects`, and the contexts that they stand in."""

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
_SHAPES = {
    "crowned": {"profile": "crowned", "straight_length": "4 mm", "crown_radius": "600 mm"},
    "logarithmic": {"profile": "logarithmic", "drop": "1.75 um"},
    "designed": {"profile": "fujiwara_kawase", "design_load": "4 kN", "load_factor": 1.5,
                 "crowned_share": 0.6, "end_drop": "20 um"},
    "points": {"profile": "points", "point_positions": ["0 mm", "2.5 mm", "7.5 mm"],
               "point_drops": ["0 um", "1 um", "12 um"]},
}  # fmt: skip
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
_CLOSER = "model.bearing.rows.0.closer"
_FINENESS = (
    "resolution resolution.{is,along,azimuths,axial_modes,first_order,harmonics,length,nodes_of,patch_width} "
    "resolution.{row_distance,stations,threads} resolution.mesh_size.{is,order,raceway_size,size}"
)
PROFILES = {"roller": "roller.profile", "inner_raceway": "inner_profile", "outer_raceway": "outer_profile"}
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
        for part in PROFILES
        for shape, keys in _SHAPES.items()
    },
}  # fmt: skip

# fmt: off
EFFECTS = (
    ("tapered", "title", "x", "case.title"),
    ("tapered", "bearing.rollers", 16, "model.bearing.rollers"),
    ("tapered", "bearing.pitch_diameter", "54 mm", "model.bearing.pitch_diameter"),
    ("tapered", "bearing.cup_angle", "14.1 deg",
     "model.bearing.cup_angle model.bearing.rib.depth model.bearing.rib.lever"),
    ("tapered", "bearing.cone_angle", "10.1 deg",
     "model.bearing.cone_angle model.bearing.rib.depth model.bearing.rib.lever"),
    ("tapered", "bearing.contact_law", "iso16281", "model.bearing.contact_law"),
    ("tapered", "bearing.first_roller_azimuth", "12 deg", "model.bearing.first_roller_azimuth"),
    ("tapered", "bearing.roller.diameter", "8.7 mm",
     "model.bearing.roller.diameter model.bearing.roller.profile.amplitude"),
    ("tapered", "bearing.roller.length", "14.9 mm", "model.bearing.rib.lever model.bearing.roller.length"),
    ("tapered", "bearing.rib.angle", "10.4 deg",
     "model.bearing.rib.angle model.bearing.rib.depth model.bearing.rib.lever"),
    ("tapered", "bearing.rib.end_radius", "121 mm",
     "model.bearing.rib.curvature model.bearing.rib.depth "
     "model.bearing.rib.lever model.bearing.rib.stiffness"),
    ("tapered", "bearing.rib.friction", 0.06, "case.bearing.rib.friction"),
    ("tapered, cage on a land", "bearing.cage.guidance", "inner", "cage.guidance"),
    ("tapered, cage on a land", "bearing.cage.pocket_friction", 0.06, "cage.pocket_friction"),
    ("tapered, cage on a land", "bearing.cage.thickness", "2.1 mm", "cage.thickness"),
    ("tapered, cage on a land", "bearing.cage.land_diameter", "60.1 mm", "cage.land_diameter"),
    ("tapered, cage on a land", "bearing.cage.land_width", "3.1 mm", "cage.land_width"),
    ("tapered, cage on a land", "bearing.cage.land_clearance", "0.41 mm", "cage.land_clearance"),
    ("tapered, cage on a land", "bearing.cage.land_flow", "vortices", "cage.land_flow"),
    ("tapered", "materials.roller.youngs_modulus", "208 GPa",
     "model.bearing.rib.stiffness model.bearing.roller.material.youngs_modulus"),
    ("tapered", "materials.roller.poisson_ratio", 0.303,
     "model.bearing.rib.stiffness model.bearing.roller.material.poisson_ratio"),
    ("tapered", "materials.roller.density", "7878 kg/m^3", "model.bearing.roller.material.density"),
    ("tapered", "materials.inner_ring.youngs_modulus", "208 GPa",
     "model.bearing.inner_ring.youngs_modulus model.bearing.rib.stiffness"),
    ("tapered", "materials.inner_ring.poisson_ratio", 0.303,
     "model.bearing.inner_ring.poisson_ratio model.bearing.rib.stiffness"),
    ("tapered", "materials.inner_ring.density", "7878 kg/m^3", "model.bearing.inner_ring.density"),
    ("tapered", "materials.outer_ring.youngs_modulus", "208 GPa", "model.bearing.outer_ring.youngs_modulus"),
    ("tapered", "materials.outer_ring.poisson_ratio", 0.303, "model.bearing.outer_ring.poisson_ratio"),
    ("tapered", "materials.outer_ring.density", "7878 kg/m^3", "model.bearing.outer_ring.density"),
    ("tapered", "operation.inner_speed", "2100 rpm", "operation.inner_speed"),
    ("tapered", "operation.outer_speed", "100 rpm", "operation.outer_speed"),
    ("tapered", "operation.tilt", "free", "operation.displacement.3 operation.displacement.4"),
    ("tapered", "operation.load.axial", "4.1 kN", "operation.load.0"),
    ("tapered", "operation.load.radial_y", "1 kN", "operation.load.1"),
    ("tapered", "operation.load.radial_z", "8.1 kN", "operation.load.2"),
    ("tapered, free to tilt", "operation.load.moment_y", "1 N m", "operation.load.3"),
    ("tapered, free to tilt", "operation.load.moment_z", "1 N m", "operation.load.4"),
    ("tapered, held", "operation.displacement.axial", "21 um", "operation.displacement.0"),
    ("tapered, held", "operation.displacement.radial_y", "1.1 um", "operation.displacement.1"),
    ("tapered, held", "operation.displacement.radial_z", "2.1 um", "operation.displacement.2"),
    ("tapered", "operation.displacement.tilt_y", "0.01 deg", "operation.displacement.3"),
    ("tapered", "operation.displacement.tilt_z", "0.01 deg", "operation.displacement.4"),
    ("tapered, pair", "bearing.pair.arrangement", "face_to_face",
     "model.bearing.rows.{0.mirrored,1.mirrored}"),
    ("tapered, pair", "bearing.pair.distance", "41 mm", "model.bearing.rows.{0.axial,1.axial}"),
    ("tapered, pair", "bearing.pair.preload", "2.1 kN", "model.bearing.rows.{0.closer,1.closer}"),
    ("tapered, pair with offset", "bearing.pair.offset", "6 um", "model.bearing.rows.{0.closer,1.closer}"),
    *(("tapered, fitted", f"bearing.fits.{name}", value, _CLOSER) for name, value in (
        ("bore", "36 mm"), ("outer_diameter", "73 mm"), ("shaft_bore", "11 mm"),
        ("shaft_interference", "16 um"), ("housing.diameter", "101 mm"), ("housing.interference", "11 um"))),
    *(("tapered, classes", f"bearing.fits.{name}", value, _CLOSER) for name, value in (
        ("shaft", "m5"), ("housing.tolerance_class", "P7"), ("at", "tightest"))),
    *(("tapered, fitted", f"operation.temperatures.{part}", "45 degC", _CLOSER)
      for part in (*_PARTS, "housing", "reference")),
    *(("tapered, fitted", f"materials.{part}.expansion", "13e-6 1/K", _CLOSER)
      for part in (*_PARTS, "housing")),
    *(("tapered, fitted", f"materials.{part}.density", "7900 kg/m^3", _CLOSER)
      for part in ("shaft", "housing")),
    ("tapered", "outer.kind", {"outer.kind": "ring", "outer.thickness": "5 mm", "outer.width": "19 mm"},
     "outer.{groove,is,offset,raceway_diameter,row_distance,support.is,taper,thickness,width} "
     f"outer.elastic.{{is,poisson_ratio,youngs_modulus}} {_FINENESS}"),
    ("tapered", "inner.kind", {
        "inner.kind": "ring_on_shaft", "inner.bore": "35 mm", "inner.width": "17 mm",
        "inner.shaft_length": "40 mm", "materials.shaft": _ELASTIC},
     "inner.{bore,groove,is,raceway_diameter,rib_diameter,row_distance,shaft_bore,shaft_length} "
     "inner.{taper,track_width,width} "
     "inner.ring.{is,poisson_ratio,youngs_modulus} inner.shaft.{is,poisson_ratio,youngs_modulus} "
     f"{_FINENESS}"),
    ("tapered, cup", "outer.thickness", "5.1 mm", "outer.thickness"),
    ("tapered, cup", "outer.width", "19.1 mm", "outer.width"),
    ("tapered, cup", "outer.raceway_offset", "0.1 mm", "outer.offset"),
    ("tapered, cup", "outer.support", "seat", "outer.support.is"),
    ("tapered, pair of cups", "outer.common", True, "outer.row_distance resolution.row_distance"),
    ("tapered, cup on springs", "outer.foundation_radial", "202 N/mm^3", "outer.support.radial"),
    ("tapered, cup on springs", "outer.foundation_axial", "202 N/mm^3", "outer.support.axial"),
    ("tapered, cup on springs", "outer.foundation_tangential", "202 N/mm^3", "outer.support.tangential"),
    ("tapered, cup in a housing", "outer.housing_thickness", "8.1 mm", "outer.support.thickness"),
    ("tapered, cup in a housing", "outer.housing_width", "25.1 mm", "outer.support.width"),
    ("tapered, cup in a housing", "outer.housing_support", "side", "outer.support.support.is"),
    ("tapered, cup in a housing", "materials.housing.youngs_modulus", "111 GPa",
     "outer.support.elastic.youngs_modulus"),
    ("tapered, cup in a housing", "materials.housing.poisson_ratio", 0.27,
     "outer.support.elastic.poisson_ratio"),
    ("tapered, cone on a shaft", "inner.bore", "35.1 mm", "inner.bore"),
    ("tapered, cone on a shaft", "inner.width", "17.1 mm", "inner.track_width inner.width"),
    ("tapered, cone on a shaft", "inner.shaft_thickness", "8 mm", "inner.shaft_bore"),
    ("tapered, cone on a shaft", "inner.shaft_length", "41 mm", "inner.shaft_length"),
    ("tapered, cone on a shaft", "materials.shaft.youngs_modulus", "212 GPa", "inner.shaft.youngs_modulus"),
    ("tapered, cone on a shaft", "materials.shaft.poisson_ratio", 0.303, "inner.shaft.poisson_ratio"),
    ("tapered, cup", "accuracy.axial_shapes", 5, "resolution.axial_modes"),
    ("tapered, cup", "accuracy.element_order", 4, "resolution.mesh_size.order"),
    ("tapered, cup", "accuracy.mesh_size", "4 mm", "resolution.mesh_size.size"),
    ("tapered, cup", "accuracy.raceway_mesh_size", "2 mm", "resolution.mesh_size.raceway_size"),
    ("tapered", "accuracy.slices", 41, "case.accuracy.slices"),
    ("tapered", "outputs.subsurface_stresses", True, "case.outputs.subsurface_stresses"),
    ("tapered", "outputs.assumed_effects", True, "case.outputs.assumed_effects"),
    ("tapered", "outputs.catalogue_life", True, "case.outputs.catalogue_life"),
    ("tapered, rated", "life.loads", "rating", "case.life.loads"),
    ("tapered, rated", "life.dynamic_rating", "66 kN", "case.life.dynamic_rating"),
    ("tapered, rated", "life.static_rating", "78 kN", "case.life.static_rating"),
    ("tapered, rated", "life.fatigue_limit_load", "8.5 kN", "case.life.fatigue_limit_load"),
    ("tapered, rated", "life.reliability", 0.95, "case.life.reliability"),
    ("tapered", "life.lubrication", {
        "life.lubrication": "a_ISO",
        "life.cleanliness": "grease, normal cleanliness",
        "lubricant.oil": "ISO VG 32",
        "lubricant.inlet_temperature": "60 degC",
    }, "case.life.cleanliness case.life.lubrication viscosity"),
    ("tapered, rated", "life.cleanliness", "oil, in-line filter, -/13/10", "case.life.cleanliness"),
    ("tapered, rated", "life.modification", "bearing", "case.life.modification"),
    ("tapered, rated", "lubricant.oil", "ISO VG 68", "viscosity"),
    ("tapered, rated", "lubricant.inlet_temperature", "61 degC", "viscosity"),
    ("tapered, oil by its data", "lubricant.viscosity", "10.1 mPa s", "viscosity"),
    ("tapered, oil by its data", "lubricant.density", "880 kg/m^3", "viscosity"),
    ("tapered, data sheet", "lubricant.data_sheet.cold_temperature", "41 degC", "viscosity"),
    ("tapered, data sheet", "lubricant.data_sheet.cold_viscosity", "46.46 cSt", "viscosity"),
    ("tapered, data sheet", "lubricant.data_sheet.hot_temperature", "101 degC", "viscosity"),
    ("tapered, data sheet", "lubricant.data_sheet.hot_viscosity", "6.868 mm^2/s", "viscosity"),
    *(
        (f"tapered, {part} {context}", f"bearing.{part}.{name}", value,
         " ".join(f"model.bearing.{profile}.{field}" for field in fields.split()))
        for part, profile in PROFILES.items()
        for context, name, value, fields in (
            ("crowned", "profile", "tangent_crowned", "is"),
            ("crowned", "straight_length", "4.04 mm", "straight_length"),
            ("crowned", "crown_radius", "606 mm", "crown_radius"),
            ("logarithmic", "drop", "1.8 um", "amplitude"),
            ("designed", "design_load", "4.04 kN", "amplitude"),
            ("designed", "load_factor", 1.6, "amplitude"),
            ("designed", "crowned_share", 0.7, "crowned_share"),
            ("designed", "end_drop", "21 um", "end_drop"),
            ("points", "point_positions", ["0 mm", "3 mm", "7.5 mm"], "places slopes"),
            ("points", "point_drops", ["0 um", "1.5 um", "12 um"], "drops slopes"),
        )
    ),
)
# fmt: on
