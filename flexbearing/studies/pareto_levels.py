"""Levels of cost that one case of a roller bearing can be computed on."""

from typing import Any, NamedTuple

from flexbearing.case.roller import Case

SLICES = (5, 10, 20, 40, 80)
SHAPES = (2, 3, 4)
METHODS = ("newton", "iqn-ils", "anderson", "aitken", "relaxed")
RICHEST = ("accuracy.slices=160", "accuracy.axial_shapes=5")
CAGE_ORDERS, SECTION_ORDERS = (2, 4), (3, 6)  # below and above the usual one; the higher is the richest
ORDERED = ("10 %", "1 %", "0.1 %")
HARMONICS = "accuracy.structure=harmonics"


class Level(NamedTuple):
    """One way to compute a case."""

    name: str
    settings: tuple[str, ...] = ()  # key=value, on top of the case


def richest(case: Case) -> Level:
    """What all others are measured against.

    Parameters
    ----------
    case : Case
        of a roller bearing

    Returns
    -------
    Level
        its rings by harmonics at the highest order, drawn ones as they are
    """
    if not _flexible(case):
        return Level("reference", RICHEST)
    return Level("reference", (*RICHEST, f"accuracy.element_order={_orders(case)[1]}", *_by_harmonics(case)))


def ladder(case: Case, *, solid: bool) -> tuple[Level, ...]:
    """All levels but the richest, in an order of growing cost by kind.

    Parameters
    ----------
    case : Case
        of a roller bearing
    solid : bool
        whether every flexible part is also computed as a full solid

    Returns
    -------
    tuple of Level
    """
    levels = [Level("as it stands")]
    if _flexible(case):
        levels += _structures(case)
    if solid and _solid_is_new(case):
        levels.append(Level("full solid", ("accuracy.structure=solid",)))
    levels += _slices_and_shapes(case) + _films(case)
    if _flexible(case):
        levels += [
            Level(method, (f"coupling.method={method}", "coupling.fallback=false"))
            for method in METHODS
            if method != case.coupling.method
        ]
    levels += [Level(f"target {wish}", (f"accuracy.target={wish}",)) for wish in ORDERED]
    return tuple(levels)


def left_out(case: Case, *, solid: bool) -> tuple[str, ...]:
    """Kinds of levels that such a case does not have, each with the reason."""
    words = []
    if not _flexible(case):
        words.append("structures, axial shapes, coupling methods: every part is rigid")
    elif _drawn(case):
        words.append("beam, smeared, harmonics: the outer ring is a drawn solid")
    else:
        if not _beams(case):
            words.append(f'beam: a curved beam has no support "{case.outer.support}"')
        if case.outer.kind != "squirrel_cage":
            words.append("smeared: there are no bars")
    if _solid_is_new(case) and not solid:
        words.append("full solid: not asked for, it takes much longer than all others (--solid)")
    if not _films(case):
        words.append("film heating: the case has none")
    return tuple(words)


def _flexible(case: Case) -> bool:
    return case.outer.kind != "rigid" or case.inner.kind != "rigid"


def _drawn(case: Case) -> bool:
    return case.outer.kind == "step"


def _solid_is_new(case: Case) -> bool:
    """Whether some part could be a full solid and is none yet."""
    return _flexible(case) and not _drawn(case) and case.accuracy.structure != "solid"


def _beams(case: Case) -> bool:
    """Whether every flexible part can be a curved beam."""
    return case.outer.kind in ("rigid", "squirrel_cage") or (
        case.outer.kind == "ring" and case.outer.support in ("side", "foundation")
    )


def _orders(case: Case) -> tuple[int, int]:
    return CAGE_ORDERS if case.outer.kind in ("squirrel_cage", "step") else SECTION_ORDERS


def _by_harmonics(case: Case) -> tuple[str, ...]:
    return () if _drawn(case) else (HARMONICS,)


def _structures(case: Case) -> list[Level]:
    """Structures other than that of the case, each at two orders where it has elements."""
    rigid = ("outer.kind=rigid", "inner.kind=rigid")
    levels = [Level("rigid", rigid), Level("rigid, 5 slices", (*rigid, "accuracy.slices=5"))]
    if _beams(case):
        beam = "accuracy.structure=beam"
        levels += [Level("beam", (beam,)), Level("beam, 5 slices", (beam, "accuracy.slices=5"))]
    if case.outer.kind == "squirrel_cage":
        smeared = "accuracy.structure=smeared"
        levels += [
            Level("smeared", (smeared,)),
            Level("smeared, order 3", (smeared, "accuracy.element_order=3")),
        ]
    name, structure = ("drawn", ()) if _drawn(case) else ("harmonics", (HARMONICS,))
    if case.accuracy.structure != "harmonics" and structure:
        levels.append(Level(name, structure))
    return levels + [
        Level(f"{name}, order {order}", (*structure, f"accuracy.element_order={order}"))
        for order in _orders(case)
        if order != case.accuracy.element_order
    ]


def _slices_and_shapes(case: Case) -> list[Level]:
    given = case.accuracy
    levels = [Level(f"{n} slices", (f"accuracy.slices={n}",)) for n in SLICES if n != given.slices]
    if _flexible(case):
        levels += [
            Level(f"{n} axial shapes", (f"accuracy.axial_shapes={n}",))
            for n in SHAPES
            if n != given.axial_shapes
        ]
    return levels


def _films(case: Case) -> list[Level]:
    """Levels without the heating of films, where the case has it."""
    found: Any = case.lubricant
    names = {"inlet_heating": "inlets not heated", "film_heating": "films not heated"}
    return [
        Level(words, (f"lubricant.{name}=false",)) for name, words in names.items() if getattr(found, name)
    ]
