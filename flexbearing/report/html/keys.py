"""Keys of a case in plain words."""

_NAMES = {
    "bearing.fits.at": "tolerances of clearance and fits",  # stands for all classes of clearance and fits
    "bearing.rollers": "number of rollers",
    "bearing.balls": "number of balls",
    "bearing.first_roller_azimuth": "azimuth of the first roller",
    "outer.bars": "number of bars",
    "operation.temperatures.reference": "reference temperature",
    "operation.tilt": "free or held tilt",
    "operation.misalignment": "misalignment of the inner ring",
    "operation.radial_load": "radial load",
    "operation.axial_load": "axial load",
    "life.edge_stress": "edge stress",
    "life.required": "required life of the case",
    "life.capacity": "rule of the load capacity",
    "lubricant.inlet_temperature": "oil temperature at the inlets",
    "life.cleanliness": "cleanliness of the oil",
}
_OF_MATERIALS = {"youngs modulus": "Young's modulus", "poisson ratio": "Poisson's ratio"}
_TABLES = ("bearing", "outer", "inner", "lubricant", "operation")  # that a key is clear without
_OF_RINGS = {
    f"{race}.{size}" for race in ("inner", "outer") for size in ("width", "thickness", "bore", "kind")
}


def name(key: str) -> str:
    """A key in plain words.

    >>> name("materials.inner_ring"), name("outer.width"), name("friction.coefficient")
    ('material of the inner ring', 'width of the outer ring', 'friction coefficient')
    """
    if key in _NAMES:
        return _NAMES[key]
    table, *rest = key.split(".")
    words = " ".join(rest[-2:]).replace("_", " ")
    if key.startswith("materials.") and len(rest) == 1:
        return f"material of the {words}"
    if key.startswith("materials."):
        size, part = (each.replace("_", " ") for each in (rest[1], rest[0]))
        return f"{_OF_MATERIALS.get(size, size)} of the {part}"
    if key in _OF_RINGS:
        return f"{words} of the {table} ring"
    return words if table in _TABLES or len(rest) > 1 else f"{table} {words}"
