"""The bearings of a gearbox model as entries of a catalogue page, and what of them has no place there."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import atan, degrees

from flexbearing.case import BadCase
from flexbearing.catalogue.entries import ENTRIES, LIKES
from flexbearing.catalogue.page import names
from flexbearing.catalogue.rexs.load_cases import Point, casing_of, heaviest, oriented, points
from flexbearing.catalogue.rexs.parts import Model, Part
from flexbearing.catalogue.rexs.unused import belonging, unused, unused_by_kind
from flexbearing.printable import excerpt

KINDS = ("rolling_bearing_with_detailed_geometry", "rolling_bearing_with_catalog_geometry")
OTHERS = ("concept_bearing", "slide_bearing", "hydrodynamic_radial_plain_bearing")  # without rollers or balls
ROW, ELEMENT = "rolling_bearing_row", "rolling_element"
BODIES = (*KINDS, ROW, ELEMENT)  # whose attributes are named with those of the bearing
RATINGS = "dynamic_rating", "static_rating"
DESIGNATION, VISCOSITY = "material_designation", "viscosity_at_40_degree_celsius"
LIKE = {  # kinds of bearing that a case can be written for
    "radial_roller_bearing": "cylindrical_roller",
    "radial_cylindrical_roller_bearing": "cylindrical_roller",
    "radial_grooved_ball_bearing": "deep_groove_ball",
    "angular_contact_ball_bearing": "angular_contact_ball",
    "four_point_contact_ball_bearing": "four_point_ball",
    "radial_needle_roller_bearing": "needle_roller",
    "radial_tapered_roller_bearing": "tapered_roller",
    "radial_self_aligning_roller_bearing": "spherical_roller",
    "axial_roller_bearing": "thrust_roller",
    "axial_needle_roller_bearing": "thrust_roller",
}
CLASSES = {"C0": "CN"}  # that have another name in cases
# entry to unit in REXS, that of a case, and attributes: of the schemas from 1.1 on, of other programs, of 1.0
OF_BEARING = {
    "bore": ("mm", "mm", ("inner_diameter",)),
    "outside": ("mm", "mm", ("outer_diameter",)),
    "width": ("mm", "mm", ("width",)),
    "dynamic_rating": (
        "kN", "kN",
        (
            "radial_dynamic_load_rating", "dynamic_load_rating", "dynamic_capacity",
            "axial_dynamic_load_rating",
        ),
    ),
    "static_rating": (
        "kN", "kN",
        ("radial_static_load_rating", "static_load_rating", "static_capacity", "axial_static_load_rating"),
    ),
    "fatigue_limit": ("kN", "kN", ("fatigue_limit_load",)),
    "angle": ("deg", "deg", ("nominal_contact_angle",)),
    "clearance": ("mum", "um", ("operating_radial_bearing_clearance", "radial_backlash")),
}  # fmt: skip
OF_ELEMENT = {
    "diameter": ("mm", "mm", ("diameter_of_rolling_element",)),
    "length": ("mm", "mm", ("length_of_rolling_element",)),
}
OF_ROW = {
    "elements": ("none", "", ("number_of_rolling_elements",)),
    "angle": ("deg", "deg", ("pressure_angle",)),
    "pitch_diameter": ("mm", "mm", ("reference_diameter",)),
}
NAMED = {  # entry to attributes with a name of a list of the case
    "clearance_class": ("radial_clearance_class", "clearance_class"),
    "shaft": ("shaft_tolerance_class", "pin_tolerance_class"),
    "housing": ("casing_bore_tolerance_class", "boring_tolerance_class"),
}
Entry = tuple[str, str, str, str]  # name, text, number of the component, attribute


@dataclass(frozen=True)
class Bearing:
    """What a model has of a bearing that a case can be written for."""

    name: str  # in messages
    designation: str
    like: str  # one of `flexbearing.catalogue.entries.LIKES`
    options: Mapping[str, str]  # entries as texts with units
    points: tuple[Point, ...]
    point: int  # whose load and speed are among the options
    side: str  # what an axial force is positive along, in words
    not_used: tuple[str, ...]  # attributes of the bearing, its row and its rolling elements; other components
    not_used_below: Mapping[str, tuple[str, ...]]  # attributes of other parts and of materials, by their kind
    ratings: Mapping[str, str]  # load ratings, which options of some kinds do not have


def called(part: Part) -> str:
    """A component in messages: its number and its designation or name."""
    designation = _designation(part)
    return f"{excerpt(part.number)} ({excerpt(designation)})" if designation else excerpt(part.number)


def kind_of(part: Part) -> str:
    """Kind of a bearing in the words of the format."""
    return excerpt(part.text_of("bearing_type") or part.kind)


def is_computable(part: Part) -> bool:
    """Whether a case can be written for a bearing of this kind."""
    return part.kind in KINDS and part.text_of("bearing_type") in LIKE


def belongings(model: Model, part: Part) -> list[Part]:
    """A bearing with its parts, their materials and its oils."""
    return belonging(model, part, *_oils(model, part))


def bearing(model: Model, part: Part) -> Bearing:
    """A bearing as entries of a page, under the load and the speed of its heaviest load case.

    Raises `BadCase` for a kind or a number of rows that no case can have, and for numbers that are none.
    """
    if not is_computable(part):
        raise BadCase(f"bearing_type {kind_of(part)!r} is none of {', '.join(LIKE)}.")
    like = LIKE[part.text_of("bearing_type")]
    row = _row(model, part, 2 if like == "spherical_roller" else 1)
    element = model.one_of("ordered_assembly", row, "assembly", "part", ELEMENT)
    known, side = oriented(points(model, part), like)
    point = heaviest(known)
    entries = [*_entries(like, model.loaded(part, point), row, element), *_names(like, part)]
    ratings = {name: text for name, text, *_ in entries if name in RATINGS}
    entries = [each for each in (*entries, *_application(known[point], like)) if each[0] in LIKES[like].taken]
    if any(name in LIKES[like].instead for name, *_ in entries):  # a class counts more than a clearance
        entries = [each for each in entries if each[0] != "clearance"]
    parts = belongings(model, part)
    bodies, others = ([each for each in parts if (each.kind in BODIES) is own] for own in (True, False))
    surroundings, strange, used = _surroundings(model, part, element, like)
    used[part.number] = set[str]().union(*(of_point.used for of_point in known))
    for number, attribute in {name: source for name, _, *source in entries}.values():  # the last of a name
        used.setdefault(number, set()).add(attribute)
    steel = element and _material(model, element)
    used |= {each.number: {DESIGNATION} for each in others if steel and _is_called(each, steel)}
    return Bearing(
        name=called(part),
        designation=_designation(part),
        like=like,
        options={**{name: text for name, text, *_ in entries}, **surroundings},
        points=tuple(known),
        point=point,
        side=side,
        not_used=(*unused(model, bodies, used), *_without_entry(known, like), *strange),
        not_used_below=unused_by_kind(model, others, used),
        ratings=ratings,
    )


def _row(model: Model, part: Part, most: int) -> Part | None:
    """The row of rolling elements, where the model has it; one of as many alike as the kind has at most."""
    rows = [each for each in model.all_of("ordered_assembly", part, "assembly", "part") if each.kind == ROW]
    count = max(part.number_of("number_of_bearing_rows", "none") or 1, len(rows))
    if count > most:
        raise BadCase(f"has {count:g} rows of rolling elements; a case that is made from a model has {most}.")
    return rows[0] if rows else None


def _designation(part: Part) -> str:
    return part.text_of("catalogue_designation") or part.text_of("name") or part.name


def _entries(like: str, part: Part, row: Part | None, element: Part | None) -> Iterator[Entry]:
    """Entries with numbers; the last of a name counts."""
    if like in ("tapered_roller", "spherical_roller") and (e := part.number_of("catalogue_value_e", "none")):
        yield "angle", f"{degrees(atan(e / 1.5)):.12g} deg", part.number, "catalogue_value_e"
    yield from _numbers(part, OF_BEARING)
    if element:
        yield from _numbers(element, OF_ELEMENT)
    if row:
        yield from _numbers(row, OF_ROW)
    if row and element:
        pitch = row.number_of("reference_diameter", "mm")
        diameter = element.number_of("diameter_of_rolling_element", "mm")
        if pitch and diameter:
            yield "outer_raceway", f"{pitch + diameter:.12g} mm", row.number, "reference_diameter"


def _numbers(part: Part, wanted: Mapping[str, tuple[str, str, tuple[str, ...]]]) -> Iterator[Entry]:
    """The first attribute of each entry; zero stands for one that is not known."""
    for entry, (unit, ours, attributes) in wanted.items():
        for attribute in attributes:
            if value := part.number_of(attribute, unit):
                value = abs(value) if entry == "angle" else value
                yield entry, f"{value:.12g} {ours}".strip(), part.number, attribute
                break


def _names(like: str, part: Part) -> Iterator[Entry]:
    """Classes of clearance and of tolerances that the case knows."""
    for entry, attributes in NAMED.items():
        if entry not in LIKES[like].taken:
            continue
        for attribute in attributes:
            text = part.text_of(attribute)
            if CLASSES.get(text, text) in names(ENTRIES[entry], like):
                yield entry, CLASSES.get(text, text), part.number, attribute


def _application(point: Point, like: str) -> Iterator[Entry]:
    """Load, speeds and temperature of a load case."""
    for entry, value in (("load", point.radial), ("axial", point.axial)):
        if value:
            yield entry, f"{value:.12g} N", "", ""
    if point.relative_speed:
        both = "outer_speed" in LIKES[like].taken
        yield "speed", f"{point.inner_speed if both else point.relative_speed:.12g} rpm", "", ""
        if point.outer_speed:
            yield "outer_speed", f"{point.outer_speed:.12g} rpm", "", ""
    if point.temperature is not None:
        yield "temperature", f"{point.temperature:.12g} degC", "", ""


def _surroundings(
    model: Model, part: Part, element: Part | None, like: str
) -> tuple[dict[str, str], list[str], dict[str, set[str]]]:
    """Material and oil where the case knows their names, those that it does not know, used attributes."""
    material, oil = element and _material(model, element), next(_oils(model, part), None)
    viscosity = oil.number_of(VISCOSITY, "mm^2 / s") if oil else None
    of_class = f"ISO VG {viscosity:g}" if viscosity else ""
    candidates = (
        ("material", material, {DESIGNATION: material.text_of(DESIGNATION)} if material else {}),
        ("oil", oil, {"name": oil.text_of("name"), VISCOSITY: of_class} if oil else {}),
    )
    found, strange, used = dict[str, str](), list[str](), dict[str, set[str]]()
    for entry, component, of_attributes in candidates:
        if component is None:
            continue
        texts = {**of_attributes, "": component.name}
        known = names(ENTRIES[entry], like) if entry in LIKES[like].taken else ()
        fitting = [name for name, text in texts.items() if text in known]
        if fitting:
            found[entry] = texts[fitting[0]]
        else:
            strange.append(f"{component.kind} {excerpt(' '.join(filter(None, texts.values())))}")
        used[component.number] = {*(fitting[:1] or of_attributes)}
    return found, strange, used


def _material(model: Model, element: Part) -> Part | None:
    return model.one_of("reference", element, "origin", "referenced", "material")


def _is_called(part: Part, material: Part) -> bool:
    """Whether a part is a material of the same designation."""
    return part.kind == material.kind and part.text_of(DESIGNATION) == material.text_of(DESIGNATION)


def _oils(model: Model, part: Part) -> Iterator[Part]:
    """Lubricants of the bearing, then of the casing that it sits in."""
    for owner in (part, casing_of(model, part)):
        if oil := model.one_of("reference", owner, "origin", "referenced", "lubricant"):
            yield oil


def _without_entry(known: list[Point], like: str) -> Iterator[str]:
    """What a bearing of this kind has no entry for in any load case."""
    if "axial" not in LIKES[like].taken and any(point.axial for point in known):
        yield "axial force"
    if "temperature" not in LIKES[like].taken and any(point.temperature is not None for point in known):
        yield "temperature of the oil"
