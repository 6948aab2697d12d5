"""What a gearbox model has of a bearing, its parts and its surroundings that no case takes, by name."""

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence

from flexbearing.catalogue.rexs.load_cases import (
    CASING,
    GEAR_UNIT,
    carriers,
    used_shares,
    used_speeds,
    used_temperature,
)
from flexbearing.catalogue.rexs.parts import Model, Part
from flexbearing.printable import excerpt

BELOW = (  # relations from a component to what belongs to it
    ("ordered_assembly", "assembly", "part"),
    ("assembly", "assembly", "part"),
    ("reference", "origin", "referenced"),
)
NAMES = {  # by which components are distinguished
    "name", "model_name", "bearing_type", "catalogue_designation", "number_of_bearing_rows",
    "bearing_ring_type", "rolling_element_contact_type",
}  # fmt: skip
PLACE = {  # of a component in its gearbox
    "u_axis_vector", "w_axis_vector", "support_vector", "reference_component_for_position",
    "u_coordinate_on_shaft_inner_side", "u_coordinate_on_shaft_outer_side",
}  # fmt: skip
SECTIONS = BELOW[0], BELOW[2]  # relations to what a shaft or a casing is made of, not to gears on it
READ = {"side", *(relation for relation, _, _ in BELOW)}  # relations


def belonging(model: Model, *parts: Part, below: Sequence[tuple[str, str, str]] = BELOW) -> list[Part]:
    """Components with all that belongs to them by some relations, each once."""
    found, left = {part.number: part for part in parts}, [*parts]
    while left:
        owner = left.pop()
        for relation, own_role, role in below:
            for each in model.all_of(relation, owner, own_role, role):
                if each.number not in found:
                    found[each.number] = each
                    left.append(each)
    return [*found.values()]


def unused(model: Model, parts: Sequence[Part], used: Mapping[str, Collection[str]]) -> Iterator[str]:
    """Attributes of components, in any load case, but those used by numbers; zero or empty ones last."""
    found: dict[str, bool] = {}
    for part in parts:
        for name, has_content in model.contents.get(part.number, {}).items():
            if name not in NAMES and name not in used.get(part.number, ()):
                found[name] = found.get(name, False) or has_content
    if PLACE & {*found}:
        yield "its place in the gearbox"
    yield from (excerpt(name) for name in sorted({*found} - PLACE, key=lambda name: (not found[name], name)))


def unused_by_kind(
    model: Model, parts: Sequence[Part], used: Mapping[str, Collection[str]]
) -> dict[str, tuple[str, ...]]:
    """The same of each kind of component that has some."""
    kinds: dict[str, list[Part]] = {}
    for part in parts:
        kinds.setdefault(part.kind, []).append(part)
    listed = {kind: tuple(unused(model, of_kind, used)) for kind, of_kind in kinds.items()}
    return {kind: names for kind, names in listed.items() if names}


def around(model: Model, bearings: Sequence[Part], belongings: Collection[str]) -> list[Part]:
    """Gear units, casings, oils, and what bearings sit on or in, with their sections and materials.

    `bearings` are all of the model; `belongings` are numbers of the bearings, their parts, materials and
    oils, which are named with them.
    """
    seats = [each for part in bearings for ring in ("inner", "outer") for each in carriers(model, part, ring)]
    units = [each for each in model.parts.values() if each.kind in (GEAR_UNIT, CASING, "lubricant")]
    found = belonging(model, *units, *seats, below=SECTIONS)
    return [each for each in found if each.number not in belongings]


def unused_around(
    model: Model, bearings: Sequence[Part], parts: Sequence[Part]
) -> dict[str, tuple[str, ...]]:
    """Attributes of the components `around` bearings that no case takes."""
    shares = used_shares(model)
    used = {part.number: {*shares} if part.kind == GEAR_UNIT else set[str]() for part in parts}
    for bearing in bearings:
        for number, attribute in (*used_speeds(model, bearing), *used_temperature(model, bearing)):
            used.setdefault(number, set()).add(attribute)
    return unused_by_kind(model, parts, used)


def kinds_not_read(model: Model, known: Collection[str]) -> Iterator[str]:
    """Kinds of components, with their count, and of relations that nothing is read of."""
    components = {
        number: part.kind
        for parts in (*model.load_cases, model.parts)
        for number, part in parts.items()
        if number not in known
    }
    counted = Counter(components.values())
    yield from (f"{excerpt(kind)} ({count})" for kind, count in sorted(counted.items()))
    yield from (f"relation {excerpt(kind)}" for kind in sorted({key[0] for key in model.related} - READ))
