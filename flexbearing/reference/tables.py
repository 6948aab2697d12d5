"""One section of a page of keys: tables of the case file that are alike, with their keys."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase

from flexbearing.case.belonging import chosen
from flexbearing.case.declarations import Declaration


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """Lines of a table; none without rows."""
    lines = [f"|{'|'.join(map(_cell, row))}|" for row in rows]
    return [f"|{'|'.join(head)}|", f"|{'---|' * len(head)}", *lines, ""] if lines else []


def folded(title: str, lines: Sequence[str]) -> list[str]:
    """Lines under a title that opens them; none without lines."""
    shown = title.replace("&", "&amp;").replace("<", "&lt;")
    return [f"<details><summary>{shown}</summary>", "", *lines, "</details>", ""] if lines else []


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


HEAD = ("key", "value", "default", "meaning")
RARE = (
    "bearing.contact", "bearing.first_*_azimuth", "bearing.cage.centre",
    "bearing.cage.pocket_clearance", "bearing.cage.mass", "bearing.flange.*", "bearing.form_error*",
    "bearing.roughness.*", "bearing.*_raceway.*", "bearing.*.shoulder", "materials.*.name",
    "lubricant.data_sheet.*", "lubricant.mixed.*", "lubricant.traction_curve.*", "lubricant.film",
    "lubricant.rolling", "lubricant.inlet_*", "lubricant.drag_coefficient", "lubricant.churning_gap",
    "operation.gravity*", "operation.roller_positions", "operation.temperatures.*_along.*",
    "operation.temperatures.outer_seat", "outer.raceway_offset", "friction.pressures",
    "friction.coefficients", "friction.torque", "friction.interface_compliance", "rolling_lines.*",
    "fields.*", "rings.patch_width", "rings.stations", "rings.element_order", "rings.mesh_size",
    "life.stress_reduction", "life.load_exponent", "life.roller_body", "life.steel", "life.melting",
    "coupling.fallback", "coupling.structure", "coupling.max_iterations", "coupling.relaxation",
    "accuracy.element_order", "accuracy.*mesh_size", "accuracy.harmonics", "accuracy.patch_width",
    "accuracy.threads",
)  # fmt: skip
MANY = 12  # choices that are listed among the ranges
SHORT = {
    "cylindrical_roller": "rollers",
    "four_point_ball": "four-point",
    "angular_contact_ball": "angular-contact",
    "deep_groove_ball": "deep groove",
    "tapered_roller": "tapered",
    "thrust_roller": "thrust",
    "spherical_roller": "spherical",
}


@dataclass(frozen=True)
class Table:
    """A table of one kind of case."""

    declaration: Declaration
    kind: str
    items: tuple[Declaration, ...]  # its keys, tables inside left out

    @property
    def path(self) -> str:
        """Its dotted name."""
        return self.declaration.path

    @property
    def texts(self) -> frozenset[tuple[str, ...]]:
        """Its keys as they are printed."""
        return frozenset(map(_row, self.items))


def alike(tables: Sequence[Table]) -> list[list[Table]]:
    """Group tables of the same name, and those which share most of their keys."""
    groups: list[list[Table]] = []
    for each in tables:
        for group in groups:
            if any(each.path == other.path or _similar(each, other) for other in group):
                group.append(each)
                break
        else:
            groups.append([each])
    return [group for group in groups if any(each.items or each.declaration.only for each in group)]


def _similar(one: Table, other: Table) -> bool:
    least = min(len(one.texts), len(other.texts))
    return least > 1 and len(one.texts & other.texts) >= 0.6 * least


def lines_of(group: Sequence[Table], kinds: Sequence[str]) -> list[str]:
    """Heading, meaning and keys of a group: usual keys, rare ones and those of a choice folded, ranges."""
    paths = list(dict.fromkeys(each.path for each in group))
    usual, rare, chosen_by = [], [], {}
    for item, owners in _merged(group):
        row = _row(item, _whose(owners, group, kinds))
        if condition := chosen(item):
            chosen_by.setdefault(condition, []).append(row)
        else:
            (rare if any(fnmatchcase(item.path, keys) for keys in RARE) else usual).append(row)
    lines = [f"## {', '.join(f'[{path}]' for path in paths)}", "", *_meanings(group, kinds)]
    lines += table(HEAD, usual) + folded("Rarely needed", table(HEAD, rare))
    for condition, those in chosen_by.items():
        lines += folded(f"Only with {condition}", table(HEAD, those))
    return lines + folded("Ranges", _ranges(group))


def rows(items: Sequence[Declaration]) -> list[tuple[str, ...]]:
    """Rows of keys."""
    return [_row(item) for item in items]


def _merged(group: Sequence[Table]) -> list[tuple[Declaration, list[Table]]]:
    """Keys of all tables of a group, those that read alike once, with the tables that have them."""
    found: dict[tuple, tuple[Declaration, list[Table]]] = {}
    for each in group:
        for item in each.items:
            found.setdefault((_row(item), chosen(item)), (item, []))[1].append(each)
    order = list(dict.fromkeys(_leaf(item) for each in group for item in each.items))
    return sorted(found.values(), key=lambda entry: order.index(_leaf(entry[0])))


def _whose(owners: Sequence[Table], group: Sequence[Table], kinds: Sequence[str]) -> str:
    """Tables and kinds that have a key, where not all of the group have it."""
    notes = []
    paths = {each.path for each in owners}
    if paths != {each.path for each in group}:
        notes.append(", ".join(sorted(path.rpartition(".")[2] for path in paths)))
    return "; ".join([*notes, *_kinds(owners, [each.kind for each in group])])


def _kinds(owners: Sequence[Table], kinds: Sequence[str]) -> list[str]:
    having = {each.kind for each in owners}
    return [] if having == set(kinds) else [", ".join(SHORT[kind] for kind in SHORT if kind in having)]


def _meanings(group: Sequence[Table], kinds: Sequence[str]) -> list[str]:
    """What the tables are, as lines of a list; for which kinds, and whether a case needs them."""
    found: dict[tuple[str, str], list[Table]] = {}
    for each in group:
        item = each.declaration
        condition = f" Only with {chosen(item)}." if item.only else ""
        need = "" if item.required else " Optional."
        found.setdefault((each.path, f"{_sentence(item.meaning)}{need}{condition}"), []).append(each)
    several = len({path for path, _ in found}) > 1
    lines = []
    for (path, text), owners in found.items():
        whose = ", ".join(_kinds(owners, kinds))
        start = f"`{path}`: " if several else ""
        lines.append(f"- {start}{f'*{whose}:* ' if whose else ''}{text}")
    return [*lines, ""]


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}." if text else ""


def _leaf(item: Declaration) -> str:
    return item.path.rpartition(".")[2]


def _row(item: Declaration, whose: str = "") -> tuple[str, ...]:
    default = "needed" if item.required else f"`{item.default}`" if item.default else ""
    meaning = f"*{whose}:* {item.meaning}" if whose else item.meaning
    return (f"`{_leaf(item)}`", _value(item), default, meaning)


def _value(item: Declaration) -> str:
    """What may stand there, ranges left out."""
    if len(item.choices) > MANY:
        return f"such as `{item.example}`"
    if item.choices:
        return ", ".join(f"`{choice}`" for choice in item.choices)
    return f"`{item.example}`" if item.kind or item.listed else item.allowed.partition(",")[0]


def _ranges(group: Sequence[Table]) -> list[str]:
    """Keys by their range, "above 0: diameter, length"."""
    found: dict[str, dict[str, None]] = {}
    for each in group:
        for item in each.items:
            between = ", ".join(item.choices) if len(item.choices) > MANY else _short(item.range)
            if between:
                found.setdefault(between, {})[f"`{_leaf(item)}`"] = None
    return [*(f"- {between}: {', '.join(keys)}" for between, keys in found.items()), ""] if found else []


def _short(between: str) -> str:
    """A range as "0.1 to 10000 mm"; empty where it only says that a value is not negative."""
    text = re.sub(r"(above|at least) 0(?: \S.*?)?(?= and |$)", r"\1 0", between.strip(", "))
    if text in ("above 0", "at least 0"):
        return ""
    return re.sub(r"at least (\S+)(?: (\S.*))? and at most (\S+)(?: \2)?", r"\1 to \3 \2", text).strip()
