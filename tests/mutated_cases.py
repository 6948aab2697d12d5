"""Case files that were changed at random, from slightly unusual to far from any bearing."""

import math
import tomllib
from collections.abc import Callable, Iterator
from copy import deepcopy
from dataclasses import dataclass, replace
from pathlib import Path
from random import Random
from typing import Any

from flexbearing.case.belonging import foreign, without
from flexbearing.case.declarations import Declaration, by_path, toml
from flexbearing.families import FAMILIES

CONFIGS = Path(__file__).parents[1] / "configs"
RIGID = ("inner.kind=rigid", "outer.kind=rigid")
COARSE = ("accuracy.slices=8", "accuracy.axial_shapes=2", "accuracy.element_order=3", "accuracy.threads=1")
RING = ("inner.kind=rigid", "outer.kind=ring", *COARSE)
SHAFT = ("outer.kind=rigid", *COARSE)
FIT = (*SHAFT, "coupling.max_iterations=15")  # every iteration solves for contact
HOUSING = ("outer.support=housing", "outer.housing_thickness=10 mm", "outer.housing_width=12 mm")
SOLID = (
    "bearing.rollers=8", "accuracy.slices=4", "accuracy.axial_shapes=2", "accuracy.element_order=2",
    "accuracy.mesh_size=14 mm", "accuracy.raceway_mesh_size=6 mm", "accuracy.patch_width=1.5 mm",
    "accuracy.threads=1",
)  # fmt: skip
FLANGE = (
    "bearing.flange.ring=outer", "bearing.flange.clearance=30 um", "bearing.flange.height=2 mm",
    "bearing.flange.roller_chamfer=0.4 mm", "bearing.flange.stiffness=100 N/um",
    "bearing.flange.friction=0.05",
)  # fmt: skip
SHEET = (
    "lubricant.data_sheet.cold_temperature=40 degC", "lubricant.data_sheet.cold_viscosity=68 mm^2/s",
    "lubricant.data_sheet.hot_temperature=100 degC", "lubricant.data_sheet.hot_viscosity=8.5 mm^2/s",
    "lubricant.data_sheet.density=880 kg/m^3", "lubricant.data_sheet.cold_pressure_viscosity=22 1/GPa",
    "lubricant.data_sheet.conductivity=0.13 W/(m K)",
)  # fmt: skip
CURVE = (
    "lubricant.traction=four-point", "lubricant.traction_curve.peak=0.06",
    "lubricant.traction_curve.peak_slip=0.02", "lubricant.traction_curve.far=0.04",
)  # fmt: skip

# Name to config and settings: every kind of part, support, lubricant, load and output once.
VARIANTS: dict[str, tuple[str, tuple[str, ...]]] = {
    "rigid": ("mao2016", RIGID),
    "rigid crowned": ("mao2016", (
        *RIGID, "bearing.roller.profile=crowned", "bearing.roller.straight_length=3 mm",
        "bearing.roller.crown_radius=600 mm", "bearing.contact_law=iso16281",
    )),
    "rigid straight": ("nu209", ("bearing.roller.profile=straight",)),
    "tilted": ("mao2016", (*RIGID, "operation.moment=20 N m", "operation.load_direction=30 deg")),
    "misaligned": ("nu209", ("operation.misalignment=2 arcmin",)),
    "both rings turn": ("mao2016", (*RIGID, "operation.outer_speed=-9000 rpm")),
    "free cage": ("mao2016", (*RIGID, "bearing.cage.centre=free", "bearing.cage.unbalance=20 um")),
    "cage with vortices": ("mao2016", (
        *RIGID, "bearing.cage.land_flow=vortices", "bearing.cage.pocket_clearance=0.1 mm",
    )),
    "skew": ("nu209", (*FLANGE, "operation.tilt=free", "operation.moment=20 N m")),
    "thrust": ("nu209", (
        "operation.axial_load=800 N", "operation.tilt=free", "bearing.ribs.inner_height=1.5 mm",
        "bearing.ribs.outer_height=1.2 mm", "bearing.ribs.end_radius=500 mm", "bearing.ribs.friction=0.05",
    )),
    "data sheet": ("nu209_fits", ("lubricant.oil=", *SHEET)),
    "traction curve": ("nu209", CURVE),
    "bair-winer": ("nu209", ("lubricant.traction=bair-winer", "lubricant.film_heating=true")),
    "adore": ("nu209", (
        "lubricant.traction=adore", "lubricant.adore_oil=MIL-L-23699", "lubricant.film=pan_hamrock",
    )),
    "starved": ("nu209", ("lubricant.inlet_length=2.5", "lubricant.rolling=goksem-hargreaves")),
    "life a_ISO": ("nu209", (
        "life.capacity=iso281", "life.lubrication=a_ISO", "life.cleanliness=grease, normal cleanliness",
    )),
    "life of steels": ("nu209", ("life.steel=M50", "life.melting=VIM-VAR", "life.reliability=0.95")),
    "cage as beams": ("mao2016", ("accuracy.structure=beam", "inner.kind=rigid", "accuracy.slices=8")),
    "smeared cage": ("mao2016", ("accuracy.structure=smeared", "inner.kind=rigid", *COARSE)),
    "cage of few bars": ("mao2016", ("inner.kind=rigid", *COARSE, "outer.bars=8", "outer.fillet=0.4 mm",
        "accuracy.element_order=2", "accuracy.mesh_size=12 mm", "accuracy.raceway_mesh_size=4 mm")),
    "ring on its side": ("mao2016", RING),
    "ring in a seat": ("mao2016", (*RING, "outer.support=seat")),
    "ring on springs": ("mao2016", (*RING, "outer.support=foundation",
        "outer.foundation_radial=100 N/mm^3", "coupling.method=anderson")),
    "ring as beam": ("mao2016", (*RING, "outer.support=foundation",
        "outer.foundation_radial=100 N/mm^3", "accuracy.structure=beam")),
    "ring on lines": ("mao2016", (*RING, "outer.support=lines",
        'outer.line_azimuths=["60 deg", "180 deg", "300 deg"]')),
    "planet": ("mao2016", (*RING, "outer.support=planet", 'outer.tooth_azimuths=["90 deg", "270 deg"]',
        'outer.tooth_radial=["0 N", "0 N"]', 'outer.tooth_tangential=["9800 N", "-9800 N"]')),
    "ring in a housing": ("mao2016", (*RING, *HOUSING)),
    "ring loose in a housing": ("mao2016", (*RING, *HOUSING, "bearing.fits.housing.interference=-60 um",
        "coupling.max_iterations=15",
        "operation.temperatures.housing=218 degC")),
    "ring on a shaft": ("mao2016", SHAFT),
    "ring without ribs on a solid shaft": ("mao2016", (
        *SHAFT, "inner.track_width=12 mm", "inner.shaft_thickness=29.8 mm",
    )),
    "cold seat": ("mao2016", (*RING, "operation.temperatures.outer_seat=168 degC")),
    "fit without friction": ("mao2016", (
        *FIT, "inner.fit=frictionless", "bearing.fits.shaft_interference=40 um",
    )),
    "fit with friction": ("mao2016", (*FIT, "inner.fit=friction", "bearing.fits.shaft_interference=40 um",
        "inner.clamping=5 kN", "inner.shoulder_diameter=66 mm", "accuracy.element_order=2")),
    "temperature along the shaft": ("mao2016", (*FIT, "inner.fit=frictionless",
        "bearing.fits.shaft_interference=60 um", 'operation.temperatures.shaft_along.at=["-20 mm", "20 mm"]',
        'operation.temperatures.shaft_along.temperatures=["220 degC", "240 degC"]')),
    "both rings": ("mao2016", ("outer.kind=ring", *COARSE)),
    "solid": ("mao2016", ("inner.kind=rigid", "outer.kind=ring", "accuracy.structure=solid", *SOLID)),
    "full solve": ("mao2016", ("inner.kind=rigid", "outer.kind=ring", "coupling.structure=full",
        "coupling.method=iqn-ils", *SOLID)),
    "aitken": ("mao2016", (*RING, "coupling.method=aitken", "coupling.max_iterations=60")),
    "relaxed": ("mao2016", (*RING, "coupling.method=relaxed", "coupling.max_iterations=60",
        "coupling.fallback=false")),
    "target": ("mao2016", ("accuracy.target=2 %", "inner.kind=rigid", "outer.kind=ring",
        "accuracy.threads=1")),
    "target of a rigid bearing": ("nu209", ("accuracy.target=0.5 %",)),
    "stresses": ("mao2016", (*RING, "outer.support=foundation", "outer.foundation_radial=300 N/mm^3",
        "accuracy.element_order=3", "accuracy.mesh_size=12 mm", "accuracy.raceway_mesh_size=5 mm",
        "outputs.stresses=true")),
    "slewing rigid": ("slewing_bolted", ("rings.inner.kind=rigid", "rings.outer.kind=rigid",
        "bearing.balls=40")),
    "slewing on springs": ("slewing_bolted", ("rings.inner.kind=rigid", "bearing.balls=30",
        "rings.outer.face_stiffness=500 N/mm^3", "rings.outer.face_shear_stiffness=200 N/mm^3",
        "rings.element_order=3", "rings.mesh_size=25 mm", "rings.patch_width=4 mm", "rings.stations=3")),
    "four-point under a load": ("joshi2015_fag", (
        "operation.mode=ring_load", "operation.load.axial=400 N", "friction.hysteresis_loss=0.01",
    )),
    "measured friction": ("joshi2015_qj309", ("friction.coefficient=",
        'friction.pressures=["1 GPa", "3 GPa"]', "friction.coefficients=[0.12, 0.1]")),
    "angular coulomb": ("harris218", ("operation.control=coulomb", "friction.coefficient=0.08")),
    "angular inner control": ("harris218", ("operation.control=inner",)),
    "angular radial": ("rivera2021_7008", ("operation.load.radial_z=300 N",
        "bearing.inner.shoulder=1.5 mm", "bearing.outer.shoulder=1.5 mm")),
    "tapered cup": ("32207", ("outer.kind=ring", "outer.thickness=5 mm", "outer.width=19 mm",
        "outer.support=foundation", "outer.foundation_radial=200 N/mm^3",
        "outer.foundation_axial=100 N/mm^3", "accuracy.element_order=3")),
    "tapered cone": ("32207", ("inner.kind=ring_on_shaft", "inner.bore=35 mm", "inner.width=17 mm",
        "inner.shaft_length=40 mm", "materials.shaft=structural steel", "accuracy.element_order=3")),
    "tapered pair": ("32207", ("bearing.pair.arrangement=back_to_back", "bearing.pair.distance=40 mm",
        "bearing.pair.preload=2 kN", "outer.kind=ring", "outer.thickness=5 mm", "outer.width=19 mm")),
    "tapered in one cup": ("32207", ("bearing.pair.arrangement=face_to_face", "bearing.pair.distance=40 mm",
        "bearing.pair.preload=1 kN", "outer.kind=ring", "outer.common=true", "outer.thickness=6 mm",
        "outer.width=60 mm", "outer.support=seat", "accuracy.element_order=3")),
    "stressed balls": ("6209", ("outer.kind=ring", "outer.thickness=5 mm", "outer.width=19 mm",
        "bearing.outer.shoulder=2.2 mm", "accuracy.stations=3", "accuracy.element_order=3",
        "accuracy.patch_width=2 mm", "outputs.stresses=true")),
    "tapered in oil": ("32207", ("outputs.friction=true", "lubricant.oil=ISO VG 100",
        "lubricant.inlet_temperature=60 degC", "lubricant.oil_fraction=0.05")),
    "washers in oil": ("81110", ("outputs.friction=true", "lubricant.oil=ISO VG 100",
        "lubricant.inlet_temperature=60 degC", "lubricant.oil_fraction=0.05")),
    "angular held": ("rivera2021_7008", ("operation.load=", "operation.displacement.axial=20 um")),
}  # fmt: skip

# Configs whose rings take seconds as they are: a run of a changed one should not.
COARSER = {
    "mao2016": (*COARSE, "accuracy.element_order=2", "accuracy.mesh_size=12 mm",
        "accuracy.raceway_mesh_size=4 mm"),
    "step_ring": (*COARSE, "accuracy.element_order=2", "accuracy.mesh_size=20 mm",
        "accuracy.raceway_mesh_size=8 mm"),
    "slewing_bolted": ("bearing.balls=60", "rings.element_order=3", "rings.mesh_size=25 mm",
        "rings.patch_width=4 mm", "rings.stations=3"),
}  # fmt: skip

Raw = dict[str, Any]


def bases() -> dict[str, Raw]:
    """Every config and every variant as tables and values, by name; none takes long to run."""
    configs = sorted(path.stem for path in CONFIGS.glob("*.toml"))
    found = {name: based_on(name, COARSER.get(name, ())) for name in configs}
    return found | {name: based_on(*variant) for name, variant in VARIANTS.items()}


def based_on(config: str, settings: tuple[str, ...]) -> Raw:
    """A config with settings, of which an empty one takes its key out; keys of former kinds are left out."""
    raw = tomllib.loads((CONFIGS / f"{config}.toml").read_text(encoding="utf-8"))
    for setting in settings:
        key, _, value = setting.partition("=")
        if value:
            put(raw, key, read_value(value))
        else:
            taken(raw, key)
    for key in foreign(raw, model_of(raw)):
        without(raw, key)
    raw.pop("assumed", None)  # names keys, any of which may be dropped
    raw.pop("calibrated", None)
    return raw


def model_of(raw: Raw):
    """Schema of the kind that a case names."""
    return FAMILIES[raw.get("kind", next(iter(FAMILIES)))].case()


def read_value(text: str) -> Any:
    """Value of a setting: TOML where it is that, else the text."""
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return text


def put(raw: Raw, key: str, value: Any) -> None:
    """Give a key a value, in tables that are made where they are missing."""
    *tables, name = key.split(".")
    for table in tables:
        if not isinstance(raw.get(table), dict):
            raw[table] = {}
        raw = raw[table]
    raw[name] = value


def taken(raw: Raw, key: str) -> Any:
    """Take a key or a table out; None where there is none."""
    *tables, name = key.split(".")
    for table in tables:
        raw = raw.get(table, {})
        if not isinstance(raw, dict):
            return None
    return raw.pop(name, None)


def leaves(raw: Raw, prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Dotted keys and values of all tables."""
    for name, value in raw.items():
        if isinstance(value, dict):
            yield from leaves(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", value


def written(raw: Raw, table: str = "") -> str:
    """A case as the text of a file; values of class `Verbatim` as they are."""
    values = [f"{_name(name)} = {_text(value)}" for name, value in raw.items() if not isinstance(value, dict)]
    tables = [(f"{table}{_name(name)}", value) for name, value in raw.items() if isinstance(value, dict)]
    inner = [f"\n[{name}]\n{written(value, f'{name}.')}" for name, value in tables]
    return "\n".join([*values, *inner])


class Verbatim(str):
    """TOML that stands in the file as it is, such as a date or 1e400."""

    __slots__ = ()


def _text(value: Any) -> str:
    if isinstance(value, list):
        return f"[{', '.join(map(_text, value))}]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_name(name)} = {_text(item)}" for name, item in value.items()) + "}"
    return str(value) if isinstance(value, Verbatim) else toml(value)


def _name(name: str) -> str:
    return name if name.replace("_", "").replace("-", "").isalnum() and name.isascii() else toml(name)


@dataclass(frozen=True)
class Mutation:
    """One change of a case."""

    what: str  # for people
    of_tables: Callable[[Raw], None] | None = None
    of_text: Callable[[str], bytes] | None = None
    setting: str = ""


@dataclass(frozen=True)
class MutatedCase:
    """A case with its changes."""

    base: str
    raw: Raw
    mutations: tuple[Mutation, ...]

    @property
    def settings(self) -> tuple[str, ...]:
        """Those changes that are made by --set."""
        return tuple(change.setting for change in self.mutations if change.setting)

    @property
    def content(self) -> bytes:
        """Of the file."""
        raw = deepcopy(self.raw)
        for change in self.mutations:
            if change.of_tables:
                change.of_tables(raw)
        content = written(raw).encode()
        for change in self.mutations:
            if change.of_text:
                content = change.of_text(content.decode(errors="surrogateescape"))
        return content

    @property
    def story(self) -> str:
        """What was changed, for people."""
        return f"{self.base}: " + "; ".join(change.what for change in self.mutations)

    def without(self, mutation: Mutation) -> "MutatedCase":
        """The case with one change less."""
        return replace(self, mutations=tuple(item for item in self.mutations if item is not mutation))


def mutated(rng: Random, known: dict[str, Raw]) -> MutatedCase:
    """A case changed in one to five places.

    Half of all cases change plausibly: numbers by up to ten times, counts, angles, choices. The others get
    extreme or misplaced values, other types, or a text that was damaged.
    """
    base = rng.choice(sorted(known))
    raw = known[base]
    how = rng.choices((plausible, extreme, misplaced, damaged), weights=(11, 5, 2, 2))[0]
    number = rng.choices((1, 2, 3, 5), weights=(4, 3, 2, 1))[0]
    changes = tuple(how(rng, raw) for _ in range(number))
    if how is not plausible and rng.random() < 0.3:
        changes += (plausible(rng, raw),)
    return MutatedCase(base, raw, changes)


def plausible(rng: Random, raw: Raw) -> Mutation:
    """A value that an engineer might type."""
    declared = by_path(model_of(raw))
    given = {key: value for key, value in leaves(raw) if key in declared and key not in ("kind", "title")}
    if rng.random() < 0.15:
        others = [item for item in declared.values() if _may_be_added(item, raw, given)]
        item = rng.choice(others)
        value = _plausible_value(rng, item, read_value(item.example) if item.example else "1")
        return _change(rng, item.path, value)
    key = rng.choice(sorted(given))
    return _change(rng, key, _plausible_value(rng, declared[key], given[key]))


def _may_be_added(item: Declaration, raw: Raw, given: Raw) -> bool:
    if (
        item.section
        or item.path in given
        or item.path.partition(".")[0] in ("title", "assumed", "calibrated")
    ):
        return False
    if item.table and not any(key.startswith(f"{item.table}.") for key in given):
        return False  # a table that lacks its other keys
    trial = deepcopy(raw)
    put(trial, item.path, read_value(item.example) if item.example else "1")
    return not foreign(trial, model_of(raw))


def _change(rng: Random, key: str, value: Any) -> Mutation:
    """By a setting for one case in five, in the file for the others."""
    text = _text(value)
    if rng.random() < 0.2:
        return Mutation(f"--set {key}={text}", setting=f"{key}={text}")
    return Mutation(f"{key} = {text}", of_tables=lambda raw: put(raw, key, value))


def _plausible_value(rng: Random, item: Declaration, value: Any) -> Any:
    if item.choices:
        return rng.choice(item.choices)
    if isinstance(value, list):
        return _plausible_list(rng, item, value)
    if isinstance(value, bool):
        return not value
    if isinstance(value, int | float):
        return _plausible_number(rng, item, value)
    return value if item.kind is None else _plausible_quantity(rng, item, value)


def _plausible_number(rng: Random, item: Declaration, value: float) -> float:
    if isinstance(value, int) and "whole" in item.allowed:
        return max(0, round(value * rng.choice((0.5, 1, 1, 2, 4))) + rng.randint(-3, 3))
    return _digits(value * _factor(rng)) if value else rng.choice((0.01, 0.1, 0.5, 1.0))


def _plausible_quantity(rng: Random, item: Declaration, value: str) -> str:
    assert item.kind is not None
    number, unit = _parts(value)
    if item.kind.name == "a temperature" and unit == "degC":
        return f"{rng.uniform(-60, 380):.4g} degC"
    if item.kind.name == "an angle":
        return f"{rng.choice((0, 1, -5, 30, 45, 90, 180, -180, 360, rng.uniform(-720, 720))):.5g} deg"
    sign = -1 if rng.random() < 0.08 else 1
    if not number:
        return f"{sign * rng.choice((1e-3, 1, 30, 1000))} {unit}"
    return f"{_digits(sign * number * _factor(rng))!r} {unit}"


def _plausible_list(rng: Random, item: Declaration, value: list[Any]) -> list[Any]:
    changed = [_plausible_value(rng, item, entry) for entry in value]
    how = rng.random()
    if how < 0.15:
        return changed[:-1]
    return changed + changed[-1:] if how < 0.3 else changed


def _factor(rng: Random) -> float:
    """Mostly near one, at times up to ten times more or less."""
    return math.exp(rng.uniform(-1, 1) * math.log(10)) if rng.random() < 0.35 else math.exp(rng.gauss(0, 0.2))


def _digits(value: float) -> float:
    return float(f"{value:.5g}")


def _parts(value: Any) -> tuple[float, str]:
    number, _, unit = str(value).partition(" ")
    return float(number), unit


NUMBERS = (
    "0", "-0.0", "1", "-1", "2", "3", "1e-308", "5e-324", "1e-30", "1e-12", "1e-6", "1e6", "1e12",
    "1e30", "1e154", "1e308",
    "-1e308", "1e400", "-1e-300", "nan", "inf", "-inf", "+5", "0.9999999999999999",
    "0.49999999999999994", "1000", "1001",
    "9999999", "2147483648", "9223372036854775808", "1" + 400 * "0", "1e9", "1e4", "1e5", "1e3", "1e-3",
    "1e-4", "1e-9",
)  # fmt: skip
UNITS = (
    "m", "mm", "um", "nm", "km", "inch", "N", "kN", "MN", "rpm", "deg", "rad", "degC", "K", "degF",
    "GPa", "Pa", "1", "%",
    "kg", "s", "", "parsec", "m^2", "m^-1", "N/m", "mm^99", "m^9^9^9", "1/GPa", "/K", "€", "m m", "N m",
    "(", "deg/s", "1/s",
)  # fmt: skip
OTHER_TYPES = (
    "[]", "[[]]", "[1, 2]", '["5 mm"]', '["5 mm", 5]', "{}", "{ a = 1 }", "1979-05-27", "07:32:00",
    "1979-05-27T07:32:00Z",
    "true", "false", '""', '" "', '"\\u0000"', '"\\u001b[31m"', '"$x^2$"', '"' + 5000 * "a" + '"',
    "'''\nline\n'''", '"ring"',
    "0x10", "0b11", "1_000", "-7", "3.5", '"1e400 mm"', '"nan mm"', '"inf N"', '"٣ mm"', '"5 mm"',
    '"１２ mm"',
    "[" * 60 + "]" * 60, '"../../x"', '"#e75959"', '"/dev/null"',
)  # fmt: skip


def extreme(rng: Random, raw: Raw) -> Mutation:
    """A well-formed value far from any bearing, or one at a declared limit."""
    declared = by_path(model_of(raw))
    given = {key: value for key, value in leaves(raw) if key in declared}
    key = rng.choice(sorted(given))
    item, value = declared[key], given[key]
    if isinstance(value, list):
        return _change(
            rng, key, [_extreme_value(rng, item, entry) for entry in value] * rng.choice((1, 1, 3))
        )
    return _change(rng, key, _extreme_value(rng, item, value))


def _extreme_value(rng: Random, item: Declaration, value: Any) -> Any:
    how = rng.random()
    if how < 0.2:
        return Verbatim(rng.choice(OTHER_TYPES))
    if isinstance(value, bool) or (isinstance(value, str) and item.kind is None):
        return rng.choice((*item.choices, "", value.upper() if isinstance(value, str) else 1, value))
    number, unit = _parts(value)
    if how < 0.45:
        number = number * 10.0 ** rng.randint(-12, 12)
        text = f"{_digits(number)!r}"
    elif how < 0.6 and (limits := _limits(item)):
        limit = rng.choice(limits)
        text = repr(rng.choice((limit, math.nextafter(limit, -math.inf), math.nextafter(limit, math.inf))))
        unit = item.kind.unit if item.kind else unit
    else:
        text = rng.choice(NUMBERS)
    if item.kind is None:
        return Verbatim(str(int(float(text))) if "whole" in item.allowed and _whole(text) else text)
    return f"{text} {rng.choice(UNITS) if rng.random() < 0.15 else unit}"


def _whole(text: str) -> bool:
    return math.isfinite(float(text)) and abs(float(text)) < 1e18


def _limits(item: Declaration) -> list[float]:
    """Declared limits of a key, in SI."""
    return [
        float(getattr(limit, name))
        for limit in item.field.metadata
        for name in ("gt", "ge", "lt", "le")
        if getattr(limit, name, None) is not None
    ]


def misplaced(rng: Random, raw: Raw) -> Mutation:
    """A key dropped, doubled in another table, renamed, or a table emptied or dropped."""
    keys = sorted(key for key, _ in leaves(raw))
    tables = sorted({key.rpartition(".")[0] for key in keys} - {""})
    key, table = rng.choice(keys), rng.choice(tables)
    how = rng.choice(("drop", "move", "copy", "rename", "empty", "drop table", "other kind", "new table"))
    if how == "drop":
        return Mutation(f"no {key}", of_tables=lambda raw: taken(raw, key))
    if how in ("move", "copy"):
        place = f"{table}.{key.rpartition('.')[2]}"
        take = taken if how == "move" else _value
        return Mutation(f"{how} {key} to {place}", of_tables=lambda raw: put(raw, place, take(raw, key)))
    if how == "rename":
        other = key[:-1] + rng.choice(("", "x", "s", "é", " ", "."))
        return Mutation(f"{key} becomes {other!r}", of_tables=lambda raw: put(raw, other, taken(raw, key)))
    if how == "empty":
        return Mutation(f"[{table}] empty", of_tables=lambda raw: put(raw, table, {}))
    if how == "drop table":
        return Mutation(f"no [{table}]", of_tables=lambda raw: taken(raw, table))
    if how == "other kind":
        kind = rng.choice((*FAMILIES, "ball", ""))
        return Mutation(f"kind = {kind}", of_tables=lambda raw: put(raw, "kind", kind))
    new = rng.choice((*(item.path for item in by_path(model_of(raw)).values() if item.section), "x", "a.b.c"))
    return Mutation(f"new [{new}]", of_tables=lambda raw: put(raw, f"{new}.x", 1))


def _value(raw: Raw, key: str) -> Any:
    return dict(leaves(raw)).get(key, 0)


def damaged(rng: Random, raw: Raw) -> Mutation:
    """The text of the file damaged: bits, bytes, lines."""
    seed = rng.getrandbits(32)
    how = rng.choice(DAMAGES)
    name = how.__name__.strip("_").replace("_", " ")
    return Mutation(f"{name} (seed {seed})", of_text=lambda text: how(Random(seed), text))


def _raw_bytes(text: str) -> bytes:
    return text.encode(errors="surrogateescape")


def _flipped(rng: Random, text: str) -> bytes:
    content = bytearray(_raw_bytes(text)) or bytearray(b" ")
    for _ in range(rng.choice((1, 1, 3))):
        content[rng.randrange(len(content))] ^= 1 << rng.randrange(8)
    return bytes(content)


def _cut(rng: Random, text: str) -> bytes:
    content = _raw_bytes(text)
    return content[: rng.randrange(len(content) + 1)]


def _doubled_line(rng: Random, text: str) -> bytes:
    lines = text.split("\n")
    lines.insert(rng.randrange(len(lines)), rng.choice(lines))
    return _raw_bytes("\n".join(lines))


def _swapped_lines(rng: Random, text: str) -> bytes:
    lines = text.split("\n")
    one, other = rng.randrange(len(lines)), rng.randrange(len(lines))
    lines[one], lines[other] = lines[other], lines[one]
    return _raw_bytes("\n".join(lines))


def _lost_line(rng: Random, text: str) -> bytes:
    lines = text.split("\n")
    del lines[rng.randrange(len(lines))]
    return _raw_bytes("\n".join(lines))


def _inserted(rng: Random, text: str) -> bytes:
    at = rng.randrange(len(text) + 1)
    piece = rng.choice(
        ("\0", "\r", "\ufeff", "\x1b[2J", "[[x]]\n", "[a.b]\n", '"', "'''", "= =", "é", "\u202e", "{", "#")
    )
    return _raw_bytes(text[:at] + piece + text[at:])


def _other_letters(rng: Random, text: str) -> bytes:
    return text.encode(rng.choice(("utf-16", "latin-1", "utf-8-sig", "utf-32")), errors="replace")


DAMAGES = _flipped, _cut, _doubled_line, _swapped_lines, _inserted, _lost_line, _other_letters
