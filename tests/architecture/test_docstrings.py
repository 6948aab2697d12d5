"""Docstrings keep what they promise: parameters, units, errors raised, sources of equations."""

import ast
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, cached_property

from tests.places import ROOT

PHYSICS = ("quasidynamic.contact", "quasidynamic.clearance", "quasidynamic.motion", "quasidynamic.outcome")
HELP_TEXTS = (
    "flexbearing.cli",
    "flexbearing.exports.draw_command",
    "flexbearing.goal.command",
    "flexbearing.limits.command",
    "flexbearing.optimise.command",
    "flexbearing.select.command",
    "flexbearing.sensitivity.command",
    "flexbearing.studies.command",
    "flexbearing.studies.maps.command",
)  # of `--help`

Definition = ast.Module | ast.ClassDef | ast.FunctionDef
INSIDE = ast.FunctionDef | ast.ClassDef  # whose exceptions are theirs


@dataclass(frozen=True)
class Documented:
    """A module, class or function with its docstring and those of what encloses it."""

    name: str
    node: Definition
    enclosing: tuple[str, ...]  # docstrings, from the module inwards

    @cached_property
    def text(self) -> str:
        return ast.get_docstring(self.node) or ""

    @property
    def public(self) -> bool:
        return not any(part.startswith("_") for part in self.name.split("."))

    @cached_property
    def sections(self) -> dict[str, str]:
        pieces = re.split(r"^(\w[\w ]*)\n-{3,}\n", self.text, flags=re.MULTILINE)
        return dict(zip(pieces[1::2], pieces[2::2], strict=True))

    @property
    def parameters(self) -> list[str]:
        """Names documented, in their order."""
        lines = re.findall(r"^(\S.*?)(?: :.*)?$", self.sections["Parameters"], flags=re.MULTILINE)
        return [name.strip().lstrip("*") for line in lines for name in line.split(",")]

    @property
    def signature(self) -> list[str]:
        assert isinstance(self.node, ast.FunctionDef)
        given = self.node.args
        named = [*given.posonlyargs, *given.args, given.vararg, *given.kwonlyargs, given.kwarg]
        return [each.arg for each in named if each and each.arg not in ("self", "cls")]

    @cached_property
    def raised(self) -> set[str]:
        """Exceptions that the body itself makes; those of functions inside it are theirs."""
        return set(_raised(self.node.body))


def _raised(nodes: Sequence[ast.AST]) -> Iterator[str]:
    left = [*nodes]
    while left:
        node = left.pop()
        if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
            name = ast.unparse(node.exc.func).rsplit(".", 1)[-1]
            if name[0].isupper():  # a helper that words the error is not its class
                yield name
        if isinstance(node, ast.stmt | ast.ExceptHandler | ast.match_case) and not isinstance(node, INSIDE):
            left += ast.iter_child_nodes(node)


def _within(node: Definition, name: str, enclosing: tuple[str, ...]) -> Iterator[Documented]:
    found = Documented(name, node, enclosing)
    yield found
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.ClassDef | ast.FunctionDef):
            yield from _within(child, f"{name}.{child.name}", (*enclosing, found.text))


def documented(*packages: str) -> list[Documented]:
    return [
        each
        for package in packages
        for path in sorted((ROOT / package).rglob("*.py"))
        for each in _within(
            ast.parse(path.read_text(encoding="utf-8")),
            ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"),
            (),
        )
    ]


@cache
def of_the_program() -> list[Documented]:
    """Read once, and where a test runs: every worker collects the tests."""
    return documented("quasidynamic", "fem", "flexbearing")


def functions() -> list[Documented]:
    return [each for each in of_the_program() if isinstance(each.node, ast.FunctionDef) and each.public]


def with_parameters() -> list[Documented]:
    return [each for each in functions() if "Parameters" in each.sections]


def raising() -> list[Documented]:
    return [each for each in functions() if each.raised and not each.name.startswith(HELP_TEXTS)]


def equations() -> list[Documented]:
    physics = (each for each in of_the_program() if each.name.startswith(("quasidynamic.", "fem.")))
    return [each for each in physics if ".. math::" in each.text]


def without_units_or_source(items: Iterable[Documented]) -> Iterator[str]:
    for item in items:
        if not item.text and item.node.name != "drop":
            yield f"{item.name}: no docstring"
        if "Parameters" in item.sections:  # a numerical helper may do with a sentence
            named = {"units": "[" in item.text, "source": "Source" in item.sections}
            yield from (f"{item.name}: no {what}" for what, there in named.items() if not there)


def of_other_parameters(items: Iterable[Documented]) -> Iterator[str]:
    for item in items:
        if item.parameters != item.signature:
            yield f"{item.name}: documented {item.parameters}, has {item.signature}"


def raising_unsaid(items: Iterable[Documented]) -> Iterator[str]:
    """Of a section, or of a sentence "Raises `ImpossiblePart` where ..." at the begin of a line."""
    for item in items:
        said = " ".join(re.findall(r"^Raises.*?(?=\n\n|\Z)", item.text, flags=re.MULTILINE | re.DOTALL))
        if unsaid := {name for name in item.raised if name not in said}:
            yield f"{item.name}: {unsaid} raised, but not under Raises"


def without_source(items: Iterable[Documented]) -> Iterator[str]:
    for item in items:
        texts = (item.text, *item.enclosing)
        if not any("\nSource\n---" in text or "erived here" in text for text in texts):
            yield f"{item.name}: no source"


def test_physics_functions_name_units_and_source():
    assert not [*without_units_or_source(item for item in functions() if item.name.startswith(PHYSICS))]


def test_documented_parameters_equal_the_signature():
    assert not [*of_other_parameters(with_parameters())]


def test_functions_that_raise_say_what():
    assert not [*raising_unsaid(raising())]


def test_equations_name_their_source():
    assert not [*without_source(equations())]


def test_there_are_docstrings_to_look_at():
    assert len(with_parameters()) > 150
    assert len(raising()) > 50
    assert len(equations()) > 100


PROMISES_TOO_MUCH = '''
def solve(load, *, limit):
    """Solve it.

    .. math:: x = 1

    Parameters
    ----------
    load, limits : float
        both [N]
    """
    if load < 0:
        raise ValueError("negative")
'''


def test_a_docstring_that_lies_is_seen():
    lying = [list(_within(ast.parse(PROMISES_TOO_MUCH), "lying", ()))[1]]
    for look in (of_other_parameters, raising_unsaid, without_source):
        assert [*look(lying)], look.__name__
    assert [*without_units_or_source(lying)] == ["lying.solve: no source"]
