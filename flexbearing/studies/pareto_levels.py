"""Levels of cost that one case of a roller bearing can be computed on.

Slices, axial shapes and orders of the elements are levels that `accuracy.target` climbs, too; structures and
methods come beside them. Laws of another physics are marked: no resolution makes them agree.
"""

from collections.abc import Sequence
from typing import NamedTuple

from flexbearing.accuracy.levels import SLICES, mesh_levels
from flexbearing.build.ring_parts import part_of
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.ratings import FEWEST_SLICES
from flexbearing.case.roller import Case
from flexbearing.case.roller.numerics import AXIAL_MODES

METHODS = ("newton", "iqn-ils", "anderson", "aitken", "relaxed")
TARGETS = ("5 %", "1 %", "0.1 %")
CHOSEN = (  # keys of [accuracy] that keep a target from choosing
    "slices", "axial_shapes", "harmonics", "element_order", "mesh_size", "raceway_mesh_size",
)  # fmt: skip
HARMONICS = "accuracy.structure=harmonics"
FEWEST = f"accuracy.slices={SLICES[0]}"
# The highest of each that a case may have is the reference.
*COARSER_SLICES, MOST_SLICES = SLICES[:-1]
*FEWER_MODES, MOST_MODES = AXIAL_MODES[:-1]


class Level(NamedTuple):
    """One way to compute a case."""

    name: str
    settings: tuple[str, ...] = ()  # key=value, on top of the case
    physics: bool = False  # another law instead of another resolution of the same


def richest(case: Case) -> Level:
    """What all others are measured against: the highest level run of every ladder."""
    settings = (f"accuracy.slices={MOST_SLICES}", f"accuracy.axial_shapes={MOST_MODES}")
    if not _flexible(case):
        return Level("reference", settings)
    by_harmonics = () if _from_step(case) else (HARMONICS,)
    return Level("reference", (*settings, f"accuracy.element_order={_orders(case)[-1]}", *by_harmonics))


def ladder(case: Case, *, solid: bool) -> tuple[Level, ...]:
    """All levels but the richest, in an order of growing cost by kind."""
    levels = [Level("as it stands")]
    if _flexible(case):
        levels += _structures(case)
    if solid and _solid_is_new(case):
        levels.append(Level("full solid", ("accuracy.structure=solid",)))
    fewer = [n for n in COARSER_SLICES if not case.life.edge_stress or n >= FEWEST_SLICES]
    levels += _counts("slices", "slices", fewer, case.accuracy.slices)
    if _flexible(case):
        levels += _counts("axial shapes", "axial_shapes", FEWER_MODES, case.accuracy.axial_shapes)
    levels += _laws(case)
    if _flexible(case):
        levels += [
            Level(method, (f"coupling.method={method}", "coupling.fallback=false"))
            for method in METHODS
            if method != case.coupling.method
        ]
    free = tuple(f"accuracy.{key}=" for key in CHOSEN if key in case.accuracy.model_fields_set)
    levels += [Level(f"target {target}", (f"accuracy.target={target}", *free)) for target in TARGETS]
    return tuple(levels)


def left_out(case: Case, *, solid: bool) -> tuple[str, ...]:
    """Kinds of levels that such a case does not have, each with the reason."""
    words = []
    if not _flexible(case):
        words.append("structures, axial shapes, coupling methods: every part is rigid")
    elif _from_step(case):
        words.append("beam, smeared, harmonics: the outer ring is a solid from a STEP file")
    else:
        if not _can_be_beams(case):
            missing = "collar" if case.outer.collar_length else f'support "{case.outer.support}"'
            words.append(f"beam: a curved beam has no {missing}")
        if case.outer.kind != "squirrel_cage":
            words.append("smeared: there are no bars")
    if _solid_is_new(case) and not solid:
        words.append("full solid: not requested, it takes much longer than all others (--solid)")
    if not (case.lubricant.inlet_heating or case.lubricant.film_heating):
        words.append("film heating: the case has none")
    return tuple(words)


def _flexible(case: Case) -> bool:
    return case.outer.kind != "rigid" or case.inner.kind != "rigid"


def _from_step(case: Case) -> bool:
    return case.outer.kind == "step"


def _solid_is_new(case: Case) -> bool:
    """Whether some part could be a full solid and is none yet."""
    return _flexible(case) and not _from_step(case) and case.accuracy.structure != "solid"


def _can_be_beams(case: Case) -> bool:
    """Whether every flexible part can be a curved beam."""
    if case.outer.kind == "squirrel_cage":
        return not case.outer.collar_length
    return case.outer.kind == "rigid" or (
        case.outer.kind == "ring" and case.outer.support in ("side", "foundation")
    )


def _orders(case: Case) -> list[int]:
    """Orders of the elements on the ladder of the outer part, or else of the inner one."""
    part = part_of(case, "outer") or part_of(case, "inner")
    assert part is not None  # one of them is flexible
    by_harmonics = case.model_copy(
        update={"accuracy": case.accuracy.model_copy(update={"structure": "harmonics"})}
    )
    return [mesh.order for mesh in mesh_levels(by_harmonics, part)]


def _structures(case: Case) -> list[Level]:
    """Structures other than that of the case, at all orders where it has elements."""
    rigid = _rigid(case)
    levels = [Level("rigid", rigid), Level(f"rigid, {SLICES[0]} slices", (*rigid, FEWEST))]
    if _can_be_beams(case):
        beam = "accuracy.structure=beam"
        levels += [Level("beam", (beam,)), Level(f"beam, {SLICES[0]} slices", (beam, FEWEST))]
    if case.outer.kind == "squirrel_cage":
        smeared = "accuracy.structure=smeared"
        levels += [
            Level("smeared", (smeared,)),
            Level("smeared, order 3", (smeared, "accuracy.element_order=3")),
        ]
    name, structure = ("solid from STEP", ()) if _from_step(case) else ("harmonics", (HARMONICS,))
    if case.accuracy.structure != "harmonics" and structure:
        levels.append(Level(name, structure))
    return levels + [
        Level(f"{name}, order {order}", (*structure, f"accuracy.element_order={order}"))
        for order in _orders(case)[:-1]
        if order != case.accuracy.element_order
    ]


def _rigid(case: Case) -> tuple[str, ...]:
    """Settings for rigid rings; keys of flexible ones that were set in addition to the file are taken out."""
    names = (setting.partition("=")[0].strip() for setting in case.source.overrides)
    others = (name for name in names if name.startswith(("outer.", "inner.")) and not name.endswith(".kind"))
    return ("outer.kind=rigid", "inner.kind=rigid", *(f"{name}=" for name in others))


def _counts(name: str, key: str, counts: Sequence[int], of_case: int) -> list[Level]:
    return [Level(f"{n} {name}", (f"accuracy.{key}={n}",)) for n in counts if n != of_case]


def _laws(case: Case) -> list[Level]:
    """Other physics: films without heating where the case has it, the other resolution of the contacts."""
    names = {"inlet_heating": "inlets not heated", "film_heating": "films not heated"}
    levels = [
        Level(words, (f"lubricant.{key}=false",), physics=True)
        for key, words in names.items()
        if getattr(case.lubricant, key)
    ]
    contact, words = (
        ("half_space", "half-space contact")
        if case.bearing.contact == "slices"
        else ("slices", "sliced contact")
    )
    ends = ("life.edge_stress=false",) if contact == "half_space" and case.life.edge_stress else ()
    return [*levels, Level(words, (f"bearing.contact={contact}", *ends), physics=True)]


BallCase = FastCase | FourPointCase
CELLS = ((12, 24), (20, 40), (40, 80))
FINEST = 80, 160
CONTROLS = {"coulomb": "race control by friction", "outer": "outer race control"}


def ball_ladder(case: BallCase) -> tuple[Level, ...]:
    """All levels but the richest, in an order of growing cost by kind."""
    rolling = [_rolling(model, cells) for model in ("fastsim", "kalker") for cells in CELLS]
    return (
        Level("full sliding", ("friction.model=full_sliding", *_no_cells(case)), physics=True),
        *rolling,
        *_controls(case),
    )


def _rolling(model: str, cells: tuple[int, int]) -> Level:
    along, across = cells
    return Level(
        f"{model} {along}x{across}", (f"friction.model={model}", f"friction.cells=[{along}, {across}]")
    )


def _no_cells(case: BallCase) -> tuple[str, ...]:
    """Settings that take out what full sliding does not have."""
    return tuple(
        f"friction.{key}="
        for key in ("cells", "interface_compliance", "contact_pressure")
        if key in case.friction.model_fields_set
    )


def _controls(case: BallCase) -> list[Level]:
    """The other condition for the motion of fast balls, with contacts as in the reference but fewer cells."""
    if not isinstance(case, FastCase):
        return []
    other = "outer" if case.operation.control == "coulomb" else "coulomb"
    settings = (f"operation.control={other}", *_rolling("kalker", CELLS[1]).settings)
    return [Level(CONTROLS[other], settings, physics=True)]


BALL_REFERENCE = _rolling("kalker", FINEST)._replace(name="reference")
