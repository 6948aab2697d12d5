"""A model of REXS, the exchange format of gearbox programs, from XML, JSON or an archive of one of them."""

import re
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

from flexbearing import inputs
from flexbearing.case import BadCase
from flexbearing.case.read import LONGEST_NAME
from flexbearing.catalogue.rexs import json_form
from flexbearing.catalogue.rexs.parts import Model, Part, Roles, Value
from flexbearing.inputs.archive import BEGINNING
from flexbearing.inputs.file import REXS
from flexbearing.printable import excerpt

ENCODINGS = (b"utf-8", b"utf-16", b"us-ascii", b"iso-8859-1", b"windows-1252")
ENDINGS = (".rexs", ".rexsj", ".rexs.xml", ".rexs.json")  # of a model in an archive
HIGHEST = 10**9  # order of a relation
MOST_PARTS = 1_000_000  # tags of XML, or objects and values of JSON: each may take half a kilobyte of memory
MOST = 10_000  # load cases, each of which is looked up for every bearing
_ENCODING = re.compile(rb"(?:\xef\xbb\xbf)?\s*<\?xml[^>]{0,200}?encoding\s*=\s*[\"']([^\"'>]*)")


def read(path: Path) -> Model:
    """Read a model, whose form is that of its content, not that of its name.

    Raises `BadCase` where it is none.
    """
    try:
        content, others = inputs.content(path, REXS), ()
        if content.startswith(BEGINNING):
            content, others = inputs.unpacked(content, ENDINGS, REXS)
        is_json = content.removeprefix(b"\xef\xbb\xbf").lstrip()[:1] == b"{"
        if sum(map(content.count, (b"{", b"[", b",") if is_json else (b"<",))) > MOST_PARTS:
            raise BadCase(f"has more than {MOST_PARTS} {'values' if is_json else 'tags'}")
        return _model(json_form.root(content) if is_json else _root(content), others)
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
        return ElementTree.fromstring(content)
    except (ElementTree.ParseError, ValueError, LookupError) as problem:
        raise BadCase(f"is no XML: {excerpt(str(problem))}") from problem


def _model(root: ElementTree.Element, others: tuple[str, ...]) -> Model:
    version = root.get("version", "")
    if root.tag != "model" or not version.startswith("1."):
        raise BadCase("is no model of REXS 1.x")
    parts: dict[str, Part] = {}
    for part in map(_part, root.iterfind("components/component")):
        if part.number in parts:
            raise BadCase(f"has two components with the id {excerpt(part.number)}")
        parts[part.number] = part
    spectra = root.findall("load_spectrum")
    load_cases = tuple(
        {part.number: part for part in map(_part, case.iterfind("component"))}
        for case in (spectra[0].iterfind("load_case") if spectra else ())
    )
    if len(load_cases) > MOST:
        raise BadCase(f"has {len(load_cases)} load cases; at most {MOST} are allowed")
    further = [f"{len(spectra) - 1} further load spectra"] * (len(spectra) > 1)
    further += ["accumulation of the load spectrum"] * (root.find("load_spectrum/accumulation") is not None)
    return Model(excerpt(version, 8), parts, _related(root), load_cases, (*others, *further))


def _related(root: ElementTree.Element) -> dict[tuple[str, str, str], tuple[Roles, ...]]:
    """Relations by kind, role and number of each component in them, in their order."""
    related: dict[tuple[str, str, str], list[Roles]] = {}
    for relation in sorted(root.iterfind("relations/relation"), key=_order):
        roles = {ref.get("role", ""): ref.get("id", "") for ref in relation.iterfind("ref")}
        for role, number in roles.items():
            related.setdefault((relation.get("type", ""), role, number), []).append(roles)
    return {key: tuple(found) for key, found in related.items()}


def _order(relation: ElementTree.Element) -> int:
    order = relation.get("order", "0")
    try:
        return inputs.whole(order, 0, HIGHEST)
    except inputs.BadNumber as problem:
        raise BadCase(f"relation {excerpt(relation.get('id', ''))}: order: {problem}") from problem


def _part(component: ElementTree.Element) -> Part:
    attributes = dict(_attributes(component))
    return Part(component.get("id", ""), component.get("type", ""), component.get("name", ""), attributes)


def _attributes(component: ElementTree.Element) -> Iterator[tuple[str, Value]]:
    for each in component.iterfind("attribute"):
        array = tuple((cell.text or "").strip() for cell in each.iterfind("array/c"))
        yield each.get("id", ""), Value(each.get("unit", "none"), (each.text or "").strip(), array)
