"""Keys of the case file, explained from their declarations."""

from difflib import get_close_matches

from flexbearing.case.belonging import belonging
from flexbearing.case.declarations import Declaration, declarations, declared, find, of_every_case, toml
from flexbearing.case.family import Families
from flexbearing.case.head import Head
from flexbearing.case.materials import origin
from flexbearing.case.problems import BadCase
from flexbearing.case.quantity import Section
from flexbearing.printable import LONGEST, excerpt


def explain(path: str | None, families: Families) -> str:
    """Explain a key, a table, or the whole case file.

    Raises `BadCase` for an unknown key, naming the nearest one.
    """
    if path is None:
        return "\n\n".join(f"{title}\n{_lines(items)}" for title, items in _chapters(families))
    for item in of_every_case(families):
        if item.path == path:
            return _explained(item, Head)
    texts: dict[str, list[str]] = {}  # explanation to the kinds that share it
    for kind, family in families.items():
        if item := find(path, model := family.case()):
            texts.setdefault(_explained(item, model), []).append(kind)
    if not texts:
        raise BadCase(f"{excerpt(path)} is not a key of a case file.{_near(path, families)}")
    return "\n\n".join(_of_kinds(kinds, families) + text for text, kinds in texts.items())


def explain_file(path: str | None, model: type[Section]) -> str:
    """Explain a key, a table, or all keys of another file than a case.

    Raises `BadCase` for an unknown key.
    """
    items = list(declared(model))
    if path is None:
        return _lines(items)
    item = find(path, model)
    if item is None:
        known = ", ".join(each.path for each in items)
        raise BadCase(f"{excerpt(path)} is not a key of such a file; there are {known}.")
    return _explained(item, model)


def table_of_keys(model: type[Section]) -> list[str]:
    """Keys of a file as lines of a table in Markdown."""
    rows = [row for item in declared(model) for row in _rows(item)]
    return ["|key|allowed|default|meaning|", "|---|---|---|---|", *rows]


def _chapters(families: Families) -> list[tuple[str, list[Declaration]]]:
    """Keys of every case, then those of each kind."""
    chapters = [("every case", list(of_every_case(families)))]
    default = next(iter(families))
    for kind, family in families.items():
        title = f'kind = "{kind}"' + (", when kind is left out" if kind == default else "")
        chapters.append(
            (title, [item for item in declared(family.case()) if item.path not in Head.model_fields])
        )
    return chapters


def _rows(item: Declaration) -> list[str]:
    if item.section and item.required and not item.choices:
        return []
    if item.section:
        default = item.need if item.required else "left out"
        return [f"|`[{item.path}]`|{_cell(item.allowed)}|{default}|{_cell(_full(item))}|"]
    default = item.default or item.need
    return [f"|`{item.path}`|{_cell(item.allowed)}|{_cell(default)}|{_cell(_full(item))}|"]


def _full(item: Declaration) -> str:
    """Meaning, and the choices that the key belongs to."""
    return f"{item.meaning}; only {belonging(item, 'with')}" if item.only else item.meaning


def _explained(item: Declaration, model: type[Section]) -> str:
    if item.section:
        inside = [child for child in declared(model) if child.path.startswith(f"{item.path}.")]
        names = [f"{item.path} = {toml(name)}: {origin(name)}" for name in item.choices]
        by_name = "\n\n".join(["", "or by name:", *names]) if names else ""
        return f"[{item.path}] {item.meaning}\n\n{_lines(inside)}{by_name}"
    return "\n".join(f"{name:<9}{text}" for name, text in _entries(item) if text)


def _of_kinds(kinds: list[str], families: Families) -> str:
    """Whose key it is, where not every kind has it."""
    return "" if len(kinds) == len(families) else f"kind     {', '.join(kinds)}\n"


def _lines(items: list[Declaration]) -> str:
    return "\n".join(_line(item) for item in items if not item.section)


def _line(item: Declaration) -> str:
    unit = item.kind.unit if item.kind else ""
    return f"{item.path:<36} {unit:<9} {item.meaning}"


def _entries(item: Declaration) -> list[tuple[str, str]]:
    return [
        ("key", item.path),
        ("meaning", item.meaning),
        ("only", belonging(item, "with")),
        ("unit", f"{item.kind.unit} (any unit of {item.kind.name} is converted)" if item.kind else ""),
        ("allowed", item.allowed),
        ("size", f"{item.kind.sizes}, or zero, where that is allowed" if item.kind else ""),
        ("default", item.default or f"none{_need(item)}"),
        ("example", f"{item.path.rpartition('.')[2]} = {item.example}" if item.example else ""),
    ]


def _need(item: Declaration) -> str:
    if not item.required:
        return ""
    return f": {item.need}" if item.table else ": every case must give it"


def _near(path: str, families: Families) -> str:
    if len(path) > LONGEST:
        return ""
    known = [item.path for item in declarations(families)]
    ends = {name.rpartition(".")[2]: name for name in known}
    close = get_close_matches(path, known, n=1, cutoff=0.7) or [
        ends[name] for name in get_close_matches(path.rpartition(".")[2], ends, n=1, cutoff=0.7)
    ]
    return f" Did you mean {close[0]}?" if close else " `flexbearing explain` lists them all."


def _cell(text: str) -> str:
    return text.replace("|", "\\|")
