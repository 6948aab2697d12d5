"""One page for each room of the physics and of the finite elements, from the docstrings of its modules.

The pages are written into `docs/reference/api` when the site is built. An object that a page of the theory
names gets a link back to that page.
"""

import inspect
import re
import sys
from functools import cache
from importlib import import_module
from pathlib import Path

from sphinx.application import Sphinx

HERE = Path(__file__).parent
ROOT = HERE.parent
FOLDER = HERE / "reference" / "api"
PACKAGES = ("quasidynamic", "fem")
LEFT_OUT = {"fem.stages", "quasidynamic.columns"}
FILE = re.compile(r"`((?:\w+/)*\w+\.py)`")
OBJECT = re.compile(r"\{py:(?:func|class|meth|attr|data|obj|mod)\}`(?:[^`<]*<|~)?([\w.]+)>?`")
FORMULA = re.compile(r"^\s*\.\. math::")
MARKUP = re.compile(r"[|*]|(?<=\w)_(?=\W|$)")
RAISES = re.compile(r"^:raises ([\w, ]+):")


@cache
def rooms() -> dict[str, list[str]]:
    """Return the modules of every room of `quasidynamic` and `fem`, those that define something public."""
    found: dict[str, list[str]] = {}
    for package in PACKAGES:
        for path in sorted((ROOT / package).rglob("*.py")):
            if path.name.startswith("__"):
                continue
            name = ".".join(path.relative_to(ROOT).with_suffix("").parts)
            if name not in LEFT_OUT and re.search(r"^(def|class) [a-zA-Z]", path.read_text(), re.M):
                found.setdefault(name.rpartition(".")[0], []).append(name)
    return found


def page_of(room: str, modules: list[str]) -> str:
    """Return the page of a room in reStructuredText: its caption, then what each of its modules defines."""
    caption = "\n".join(escaped((inspect.getdoc(import_module(room)) or "").splitlines()))
    lines = [room, "=" * len(room), "", caption, ""]
    for name in modules:
        title = name.removeprefix(f"{room}.")
        lines += [title, "-" * len(title), "", f".. automodule:: {name}", "   :members:", ""]
    return "\n".join(lines)


def write_pages(app: Sphinx) -> None:
    """Write the pages that changed, so that only these are read again."""
    FOLDER.mkdir(exist_ok=True)
    pages = {f"{room}.rst": page_of(room, modules) for room, modules in rooms().items()}
    for stale in {path.name for path in FOLDER.iterdir()} - set(pages):
        (FOLDER / stale).unlink()
    for name, text in pages.items():
        path = FOLDER / name
        if not path.exists() or path.read_text() != text:
            path.write_text(text)


def with_linked_files(text: str) -> str:
    """Return a text with the files that it names, `contact/line/load_law.py`, linked to their pages."""
    modules = ["." + module for room in rooms().values() for module in room]

    def linked(file: re.Match[str]) -> str:
        name = "." + file[1].removesuffix(".py").replace("/", ".")
        meant = [module[1:] for module in modules if module.endswith(name)]
        return f"{{py:mod}}`{file[1]} <{meant[0]}>`" if len(meant) == 1 else file[0]

    return FILE.sub(linked, text)


def link_files(app: Sphinx, name: str, source: list[str]) -> None:
    """Link the files that a page of the theory names."""
    if name.startswith("theory/"):
        source[0] = with_linked_files(source[0])


def named_by_theory() -> dict[str, list[str]]:
    """Return the pages of the theory that name a module or an object, by its full name."""
    pages: dict[str, list[str]] = {}
    for path in sorted((HERE / "theory").glob("*.md")):
        for name in dict.fromkeys(OBJECT.findall(with_linked_files(path.read_text()))):
            pages.setdefault(name, []).append(path.stem)
    return pages


def escaped(lines: list[str]) -> list[str]:
    """Return lines of a docstring, bars, stars and last underscores escaped outside formulas and code."""
    result, formula = [], None
    for line in lines:
        indentation = len(line) - len(line.lstrip())
        if line.strip() and formula is not None and indentation <= formula:
            formula = None
        if FORMULA.match(line):
            formula = indentation
        if formula is None and not line.lstrip().startswith((">>>", "...")):
            line = "`".join(
                part if i % 2 else MARKUP.sub(r"\\\g<0>", part) for i, part in enumerate(line.split("`"))
            )
        result.append(line)
    return result


def escape(app: Sphinx, what: str, name: str, obj: object, options: object, lines: list[str]) -> None:
    """Escape what docstrings do not mean as markup, before their sections are read."""
    lines[:] = escaped(lines)


def error_named(name: str, module: str) -> str:
    """Return the full name of an exception that a docstring names: that of its module, or of its package."""
    package = module.partition(".")[0]
    places = [sys.modules.get(module)]
    if package in PACKAGES:
        places += [import_module(f"{package}.errors"), import_module(package)]
    else:  # of the program: its own, or that of the bearing which it runs
        places += [import_module("flexbearing"), import_module("quasidynamic.errors")]
    for place in places:
        if isinstance(found := getattr(place, name, None), type):
            return f"~{found.__module__}.{found.__qualname__}"
    return name


def link(app: Sphinx, what: str, name: str, obj: object, options: object, lines: list[str]) -> None:
    """Link errors to those of their own package, and the object to the pages of the theory that name it."""
    module = getattr(obj, "__module__", None) or name
    for number, line in enumerate(lines):
        if raised := RAISES.match(line):
            full = re.sub(r"\w+", lambda word: error_named(word[0], module), raised[1])
            lines[number] = f":raises {full}:{line[raised.end() :]}"
    pages = app.config.named_by_theory.get(name, [])
    if pages:
        lines += ["", "Theory: " + ", ".join(f":doc:`/theory/{page}`" for page in pages), ""]


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect with Sphinx; napoleon reads the sections of a docstring at 500."""
    app.add_config_value("named_by_theory", named_by_theory(), "env")
    app.connect("builder-inited", write_pages)
    app.connect("source-read", link_files)
    app.connect("autodoc-process-docstring", escape, priority=400)
    app.connect("autodoc-process-docstring", link, priority=600)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
