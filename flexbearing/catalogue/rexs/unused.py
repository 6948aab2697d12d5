"""What a gearbox model has of a bearing, its parts and its surroundings that no case takes, by name."""

from collections.abc import Collection, Iterator, Mapping, Sequence

from flexbearing.catalogue.rexs.operation import SHARES
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
AROUND = {  # components around all bearings, with what is read of them
    "gear_unit": {name for names in SHARES.values() for name in names},
    "gear_casing": {"temperature_lubricant"},
}


def belonging(model: Model, *parts: Part) -> list[Part]:
    """Components with all that belongs to them, each once."""
    found, left = {part.number: part for part in parts}, [*parts]
    while left:
        owner = left.pop()
        for relation, own_role, role in BELOW:
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


def unused_around(model: Model) -> dict[str, tuple[str, ...]]:
    """Attributes of gear units, casings and oils of gear units that no case takes."""
    parts = [part for part in model.parts.values() if part.kind in AROUND or _is_oil_of_a_unit(model, part)]
    return unused_by_kind(model, parts, {part.number: AROUND.get(part.kind, ()) for part in parts})


def _is_oil_of_a_unit(model: Model, part: Part) -> bool:
    """Whether a component is a lubricant of neither a bearing nor a casing."""
    owners = model.all_of("reference", part, "referenced", "origin")
    return part.kind == "lubricant" and all(owner.kind == "gear_unit" for owner in owners)
