"""A model of REXS 1.7, the exchange format of gearbox programs, as XML."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import isfinite
from xml.etree import ElementTree

import numpy as np

VERSION = "1.7"
Value = float | int | bool | str | np.ndarray | None


@dataclass(frozen=True)
class Component:
    """A part with its attributes; those that are None or not finite are left out."""

    number: int
    kind: str  # "bearing_ring"
    attributes: Mapping[str, tuple[Value, str]]  # value and unit as REXS spells it, "none" of plain ones
    name: str = ""


@dataclass(frozen=True)
class Relation:
    """How parts belong together."""

    kind: str  # "ordered_assembly"
    parts: Mapping[str, Component]  # by role
    order: int | None = None


@dataclass
class Model:
    """Parts, their relations, and one load case with what it makes of them."""

    components: list[Component] = field(default_factory=list)
    relations: list[Relation] = field(default_factory=list)
    load_case: list[Component] = field(default_factory=list)  # with the numbers of components

    def add(self, kind: str, name: str = "", /, **attributes: tuple[Value, str]) -> Component:
        """Append a part."""
        made = Component(len(self.components) + 1, kind, attributes, name)
        self.components.append(made)
        return made

    def relate(self, kind: str, order: int | None = None, **parts: Component) -> None:
        """Append a relation of parts by their roles."""
        self.relations.append(Relation(kind, parts, order))

    def loaded(self, part: Component, /, **attributes: tuple[Value, str]) -> None:
        """Append what the load case says of a part."""
        self.load_case.append(Component(part.number, part.kind, attributes, part.name))

    def xml(self, date: str, version: str) -> bytes:
        """The file."""
        head = {
            "version": VERSION,
            "applicationId": "flexbearing",
            "applicationVersion": version,
            "date": date,
        }
        root = ElementTree.Element("model", head, applicationLanguage="en")
        relations = ElementTree.SubElement(root, "relations")
        for number, relation in enumerate(self.relations, 1):
            order = {} if relation.order is None else {"order": str(relation.order)}
            made = ElementTree.SubElement(
                relations, "relation", {"id": str(number), "type": relation.kind, **order}
            )
            for role, part in relation.parts.items():
                ElementTree.SubElement(made, "ref", id=str(part.number), role=role)
        _append(ElementTree.SubElement(root, "components"), self.components)
        spectrum = ElementTree.SubElement(root, "load_spectrum", id="1")
        _append(ElementTree.SubElement(spectrum, "load_case", id="1"), self.load_case)
        ElementTree.indent(root)
        return ElementTree.tostring(root, encoding="UTF-8", xml_declaration=True) + b"\n"


def _append(above: ElementTree.Element, parts: Sequence[Component]) -> None:
    for part in parts:
        named = {"name": part.name} if part.name else {}
        made = ElementTree.SubElement(
            above, "component", {"id": str(part.number), "type": part.kind, **named}
        )
        for name, (value, unit) in part.attributes.items():
            if value is None or (isinstance(value, float) and not isfinite(value)):
                continue
            attribute = ElementTree.SubElement(made, "attribute", id=name, unit=unit)
            if isinstance(value, np.ndarray):
                array = ElementTree.SubElement(attribute, "array")
                for number in value.tolist():
                    ElementTree.SubElement(array, "c").text = repr(number)
            else:
                attribute.text = str(value).lower() if isinstance(value, bool) else str(value)
