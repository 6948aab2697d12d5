"""The entries of a catalogue page from a model of REXS, the exchange format of gearbox programs."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import hypot
from pathlib import Path
from xml.etree import ElementTree

from flexbearing import inputs
from flexbearing.case import BadCase
from flexbearing.case.excerpt import enumerated, excerpt
from flexbearing.case.read import LONGEST_NAME
from flexbearing.catalogue.entries import ENTRIES, LIKES
from flexbearing.catalogue.page import names
from flexbearing.inputs.limits import REXS

ENCODINGS = (b"utf-8", b"utf-16", b"us-ascii", b"iso-8859-1", b"windows-1252")
HIGHEST = 10**9  # order of a relation
_ENCODING = re.compile(rb"(?:\xef\xbb\xbf)?\s*<\?xml[^>]{0,200}?encoding\s*=\s*[\"']([^\"'>]*)")

BEARING, ROW, ELEMENT = "rolling_bearing_with_detailed_geometry", "rolling_bearing_row", "rolling_element"
LIKE = {  # kinds of bearing that a case can be written for
    "radial_roller_bearing": "cylindrical_roller",
    "radial_grooved_ball_bearing": "deep_groove_ball",
    "angular_contact_ball_bearing": "angular_contact_ball",
    "four_point_contact_ball_bearing": "four_point_ball",
}
CLASSES = {"C0": "CN"}  # that have another name in cases
OF_BEARING = {  # entry to attribute, its unit in REXS and that of a case
    "bore": ("inner_diameter", "mm", "mm"),
    "outside": ("outer_diameter", "mm", "mm"),
    "width": ("width", "mm", "mm"),
    "dynamic_rating": ("radial_dynamic_load_rating", "kN", "kN"),
    "static_rating": ("radial_static_load_rating", "kN", "kN"),
    "fatigue_limit": ("fatigue_limit_load", "kN", "kN"),
}
OF_ELEMENT = {
    "diameter": ("diameter_of_rolling_element", "mm", "mm"),
    "length": ("length_of_rolling_element", "mm", "mm"),
}


@dataclass(frozen=True)
class Part:
    """A component with its attributes, those of the first load case among them."""

    number: str
    kind: str
    name: str
    attributes: Mapping[str, tuple[str, str]]  # unit and text of plain values

    def number_of(self, name: str, unit: str) -> float | None:
        """A number in the unit of the format.

        Raises
        ------
        BadCase
            for another unit, or no number
        """
        if name not in self.attributes:
            return None
        given, text = self.attributes[name]
        try:
            if given == unit:
                return inputs.number(text)
        except inputs.BadNumber as problem:
            raise BadCase(f"component {excerpt(self.number)}: {name}: {problem}.") from problem
        raise BadCase(
            f"component {excerpt(self.number)}: {name} is {excerpt(text)} {excerpt(given)}, no number in "
            f"{unit}."
        )

    def text_of(self, name: str) -> str:
        """A text; empty where the part does not have it."""
        return self.attributes.get(name, ("", ""))[1]


@dataclass(frozen=True)
class Parts:
    """The components of a model by their numbers, and their relations as (kind, role to number)."""

    parts: Mapping[str, Part]
    relations: tuple[tuple[str, Mapping[str, str]], ...]

    def of(self, kind: str, below: str, above: Part | None, above_role: str, role: str) -> Part | None:
        """The first part of a kind in a role, related to another one."""
        for found, roles in self.relations:
            if found == kind and above and roles.get(above_role) == above.number:
                part = self.parts.get(roles.get(role, ""))
                if part and part.kind == below:
                    return part
        return None


def options(path: Path, number: str | None = None) -> tuple[str, dict[str, str]]:
    """Read a bearing.

    Raises
    ------
    BadCase
        where the file is none of REXS 1.x, or has no such bearing
    """
    model = read(path)
    try:
        bearing = _bearing(model, number)
        kind = bearing.text_of("bearing_type")
        if kind not in LIKE:
            raise BadCase(f"bearing_type {excerpt(kind)!r} is none of {', '.join(LIKE)}.")
        like = LIKE[kind]
        taken = LIKES[like].taken
        return like, {name: text for name, text in _entries(model, bearing, like) if name in taken}
    except BadCase as problem:
        raise BadCase(f"{excerpt(str(path), LONGEST_NAME)}: {problem}") from problem


def read(path: Path) -> Parts:
    """Read the components of a model.

    Raises
    ------
    BadCase
        where it is none
    """
    try:
        return _parts(_root(inputs.content(path, REXS)))
    except (inputs.Unreadable, BadCase) as problem:
        raise BadCase(f"{excerpt(str(path), LONGEST_NAME)}: {str(problem).rstrip('.')}.") from problem


def _root(content: bytes) -> ElementTree.Element:
    """The model in an XML file whose encoding is one that every parser knows."""
    declared = _ENCODING.match(content)
    if declared and declared[1].lower() not in ENCODINGS:
        allowed = b", ".join(ENCODINGS).decode()
        raise BadCase(f"is in the encoding {excerpt(declared[1].decode('latin-1'))}; allowed are {allowed}")
    if b"<!DOCTYPE" in content.replace(b"\0", b""):  # its entities may stand for texts of any length
        raise BadCase("has a DOCTYPE, which no model of REXS has")
    try:
        root = ElementTree.fromstring(content)
    except (ElementTree.ParseError, ValueError, LookupError) as problem:
        raise BadCase(f"is no XML: {excerpt(str(problem))}") from problem
    if root.tag != "model" or not root.get("version", "").startswith("1."):
        raise BadCase("is no model of REXS 1.x")
    return root


def _parts(root: ElementTree.Element) -> Parts:
    parts: dict[str, Part] = {}
    for part in map(_part, root.iterfind("components/component")):
        if part.number in parts:
            raise BadCase(f"has two components with the id {excerpt(part.number)}")
        parts[part.number] = part
    for loaded in map(_part, root.iterfind("load_spectrum[1]/load_case[1]/component")):
        if base := parts.get(loaded.number):
            both = {**base.attributes, **loaded.attributes}
            parts[base.number] = Part(base.number, base.kind, base.name, both)
    relations = sorted(root.iterfind("relations/relation"), key=_order)
    related = (
        (
            relation.get("type", ""),
            {ref.get("role", ""): ref.get("id", "") for ref in relation.iterfind("ref")},
        )
        for relation in relations
    )
    return Parts(parts, tuple(related))


def _order(relation: ElementTree.Element) -> int:
    order = relation.get("order", "0")
    try:
        return inputs.whole(order, 0, HIGHEST)
    except inputs.BadNumber as problem:
        raise BadCase(f"relation {excerpt(relation.get('id', ''))}: order: {problem}") from problem


def _part(component: ElementTree.Element) -> Part:
    attributes = {
        each.get("id", ""): (each.get("unit", "none"), (each.text or "").strip())
        for each in component.iterfind("attribute")
    }
    return Part(component.get("id", ""), component.get("type", ""), component.get("name", ""), attributes)


def _bearing(model: Parts, number: str | None) -> Part:
    """The bearing that is wanted, or the only one."""
    found = {part.number: part for part in model.parts.values() if part.kind == BEARING}
    told = enumerated([f"{excerpt(part.number)} ({excerpt(part.name)})" for part in found.values()])
    if not found:
        raise BadCase(f"has no {BEARING}.")
    if number is None and len(found) > 1:
        raise BadCase(f"has several bearings: choose one by --rexs-bearing: {told}.")
    if number is not None and number not in found:
        raise BadCase(f"has no bearing {excerpt(number)}; there are {told}.")
    return found[number] if number is not None else next(iter(found.values()))


def _entries(model: Parts, bearing: Part, like: str) -> Iterator[tuple[str, str]]:
    """Entries of the page that the model has."""
    row = model.of("ordered_assembly", ROW, bearing, "assembly", "part")
    element = model.of("ordered_assembly", ELEMENT, row, "assembly", "part")
    yield from _lengths(bearing, OF_BEARING)
    if element:
        yield from _lengths(element, OF_ELEMENT)
    if row and (count := row.number_of("number_of_rolling_elements", "none")) is not None:
        yield "elements", f"{count:.12g}"
    if row and element:
        pitch = row.number_of("reference_diameter", "mm")
        rollers = element.number_of("diameter_of_rolling_element", "mm")
        if pitch and rollers:
            yield "outer_raceway", f"{pitch + rollers:.12g} mm"
    if row and (angle := row.number_of("pressure_angle", "deg")):
        yield "angle", f"{abs(angle):.12g} deg"
    yield from _names(model, bearing, element, like)
    yield from _application(bearing)


def _lengths(part: Part, wanted: Mapping[str, tuple[str, str, str]]) -> Iterator[tuple[str, str]]:
    for entry, (attribute, unit, ours) in wanted.items():
        value = part.number_of(attribute, unit)
        if value is not None:
            yield entry, f"{value:.12g} {ours}"


def _names(model: Parts, bearing: Part, element: Part | None, like: str) -> Iterator[tuple[str, str]]:
    """Clearance class, material and oil, where the case knows their names; the last one counts."""
    material = model.of("reference", "material", element, "origin", "referenced")
    oil = model.of("reference", "lubricant", bearing, "origin", "referenced")
    told = bearing.text_of("radial_clearance_class")
    viscosity = oil.number_of("viscosity_at_40_degree_celsius", "mm^2 / s") if oil else None
    candidates = {
        "clearance_class": (CLASSES.get(told, told),),
        "material": (material.name, material.text_of("material_designation")) if material else (),
        "oil": (f"ISO VG {viscosity or 0:g}", oil.name, oil.text_of("name")) if oil else (),
    }
    for entry, texts in candidates.items():
        if entry in LIKES[like].taken:
            known = names(ENTRIES[entry], like)
            yield from ((entry, text) for text in texts if text in known)


def _application(bearing: Part) -> Iterator[tuple[str, str]]:
    """Load, speed and temperature of the first load case."""
    radial = [bearing.number_of(f"force_acting_on_inner_component_{axis}", "N") for axis in "vw"]
    if any(radial):
        yield "load", f"{hypot(*(each or 0.0 for each in radial)):.12g} N"
    axial = bearing.number_of("force_acting_on_inner_component_u", "N")
    if axial:
        yield "axial", f"{abs(axial):.12g} N"
    if speed := bearing.number_of("speed_inner_ring", "1 / min"):
        yield "speed", f"{abs(speed):.12g} rpm"
    temperature = bearing.number_of("temperature_lubricant", "C")
    if temperature is not None:
        yield "temperature", f"{temperature:.12g} degC"
