"""The JSON form of a REXS model as the elements of its XML form, so that both are read in one way."""

import json
from collections.abc import Iterator
from typing import Any
from xml.etree.ElementTree import Element, SubElement

from flexbearing.case import BadCase
from flexbearing.printable import excerpt


def root(content: bytes) -> Element:
    """The model; numbers stay texts, which are checked where they are used.

    Raises `BadCase` where it is no JSON in UTF-8, or its objects are none of REXS.
    """
    try:
        found = json.loads(content.decode("utf-8-sig"), parse_int=str, parse_float=str, parse_constant=str)
    except (ValueError, RecursionError) as problem:
        raise BadCase(f"is no JSON in UTF-8: {excerpt(str(problem))}") from problem
    model = found.get("model") if isinstance(found, dict) else None
    if not isinstance(model, dict):
        raise BadCase('is no model of REXS 1.x: it has no object "model"')
    made = _element("model", model)
    _append(SubElement(made, "relations"), "relation", model, "relations")
    _components(SubElement(made, "components"), model)
    spectrum = model.get("load_spectrum")
    if isinstance(spectrum, dict):
        place = SubElement(made, "load_spectrum")
        for load_case in _objects(spectrum, "load_cases"):
            _components(SubElement(place, "load_case"), load_case)
        if "accumulation" in spectrum:
            SubElement(place, "accumulation")
    for relation, given in zip(
        made.iterfind("relations/relation"), _objects(model, "relations"), strict=True
    ):
        _append(relation, "ref", given, "refs")
    return made


def _components(place: Element, owner: dict[str, Any]) -> None:
    for given in _objects(owner, "components"):
        component = _element("component", given)
        place.append(component)
        for attribute in _objects(given, "attributes"):
            component.append(_attribute(attribute))


def _attribute(given: dict[str, Any]) -> Element:
    """An attribute with its value, of any named type; coded arrays have no text."""
    attribute = _element("attribute", {name: given[name] for name in ("id", "unit") if name in given})
    for value in (value for name, value in given.items() if name not in ("id", "unit")):
        if isinstance(value, list):
            array = SubElement(attribute, "array")
            for each in value:
                SubElement(array, "c").text = _text(each)
        else:
            attribute.text = _text(value)
    return attribute


def _append(place: Element, tag: str, owner: dict[str, Any], name: str) -> None:
    for given in _objects(owner, name):
        place.append(_element(tag, given))


def _element(tag: str, given: dict[str, Any]) -> Element:
    plain = (str, bool)
    return Element(tag, {name: _text(value) for name, value in given.items() if isinstance(value, plain)})


def _objects(owner: dict[str, Any], name: str) -> Iterator[dict[str, Any]]:
    found = owner.get(name, [])
    if not isinstance(found, list) or not all(isinstance(each, dict) for each in found):
        raise BadCase(f"is no model of REXS 1.x: {name} is no list of objects")
    return iter(found)


def _text(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    text = value if isinstance(value, str) else ""
    return text.encode(errors="replace").decode()  # halves of surrogate pairs
