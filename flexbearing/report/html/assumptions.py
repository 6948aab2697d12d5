"""Names of inputs in plain words."""

TOLERANCES = "bearing.fits.at"  # stands for all classes of clearance and fits
_NAMES = {
    TOLERANCES: "tolerances of clearance and fits",
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
    "life.capacity": "rule of the load capacity",
    "lubricant.inlet_temperature": "oil temperature at the inlets",
    "life.cleanliness": "cleanliness of the oil",
}
_TABLES = ("bearing", "outer", "inner", "lubricant", "operation")  # that a key is clear without
_OF_RINGS = {
    f"{race}.{size}" for race in ("inner", "outer") for size in ("width", "thickness", "bore", "kind")
}
WORTH = 1.25  # change of a life by an assumed input that is reported beside the life, as a factor


def named(key: str) -> str:
    """A key behind its plain name.

    >>> named("bearing.roller.drop"), named("outer.bars")
    ('roller drop (bearing.roller.drop)', 'number of bars (outer.bars)')
    """
    return f"{name(key)} ({key})"


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
    if key in _OF_RINGS:
        return f"{words} of the {table} ring"
    return words if table in _TABLES or len(rest) > 1 else f"{table} {words}"
