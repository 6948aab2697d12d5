"""Keys of the case file, explained from their declarations."""

import sys
from difflib import get_close_matches

from flexbearing.case.declarations import Declaration, declarations, find
from flexbearing.case.problems import BadCase


def explain(path: str | None = None) -> str:
    """Explain a key, a table, or the whole case file.

    Parameters
    ----------
    path : str, optional
        dotted key; without it every key is listed

    Raises
    ------
    BadCase
        for an unknown key, naming the nearest one
    """
    if path is None:
        return "\n".join(_line(item) for item in declarations() if not item.section)
    item = find(path)
    if item is None:
        raise BadCase(f"{path} is not a key of a case file.{_near(path)}")
    if item.section:
        inside = [child for child in declarations() if child.path.startswith(f"{path}.")]
        return f"[{path}] {item.meaning}\n\n" + "\n".join(
            _line(child) for child in inside if not child.section
        )
    return "\n".join(f"{name:<9}{text}" for name, text in _entries(item) if text)


def reference_page() -> str:
    """Reference page of the case file, in Markdown."""
    lines = ["# Keys of a case file", "", "Printed by `python -m flexbearing.case.explain`.", ""]
    lines += ["| key | allowed | default | meaning |", "|---|---|---|---|"]
    for item in declarations():
        if item.section and not item.required:
            lines.append(f"| `[{item.path}]` | a table | left out | {_cell(item.meaning)} |")
        if not item.section:
            default = item.default or item.need
            lines.append(
                f"| `{item.path}` | {_cell(item.allowed)} | {_cell(default)} | {_cell(item.meaning)} |"
            )
    return "\n".join(lines) + "\n"


def _line(item: Declaration) -> str:
    unit = item.kind.unit if item.kind else ""
    return f"{item.path:<36} {unit:<9} {item.meaning}"


def _entries(item: Declaration) -> list[tuple[str, str]]:
    return [
        ("key", item.path),
        ("meaning", item.meaning),
        ("unit", f"{item.kind.unit} (any unit of {item.kind.name} is converted)" if item.kind else ""),
        ("allowed", item.allowed),
        ("default", item.default or f"none{_need(item)}"),
        ("example", f"{item.path.rpartition('.')[2]} = {item.example}" if item.example else ""),
    ]


def _need(item: Declaration) -> str:
    if not item.required:
        return ""
    return f": {item.need}" if item.table else ": every case must give it"


def _near(path: str) -> str:
    known = [item.path for item in declarations()]
    ends = {name.rpartition(".")[2]: name for name in known}
    close = get_close_matches(path, known, n=1, cutoff=0.7) or [
        ends[name] for name in get_close_matches(path.rpartition(".")[2], ends, n=1, cutoff=0.7)
    ]
    return f" Did you mean {close[0]}?" if close else " `flexbearing explain` lists them all."


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


if __name__ == "__main__":
    sys.stdout.write(reference_page())
