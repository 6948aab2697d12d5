"""Docstrings keep what they promise: parameters, units, errors raised, sources of equations."""

import ast
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PHYSICS = ("quasidynamic.contact", "quasidynamic.clearance", "quasidynamic.motion", "quasidynamic.outcome")
HELP_TEXTS = (
    "flexbearing.cli",
    "flexbearing.optimise.command",
    "flexbearing.sensitivity.command",
    "flexbearing.studies.command",
    "flexbearing.studies.maps.command",
)  # of `--help`

Definition = ast.Module | ast.ClassDef | ast.FunctionDef


@dataclass(frozen=True)
class Documented:
    """A module, class or function with its docstring and those of what encloses it."""

    name: str
    node: Definition
    enclosing: tuple[str, ...]  # docstrings, from the module inwards

    @property
    def text(self) -> str:
        return ast.get_docstring(self.node) or ""

    @property
    def public(self) -> bool:
        return not any(part.startswith("_") for part in self.name.split("."))

    @property
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

    @property
    def raised(self) -> set[str]:
        """Exceptions that the body itself makes; those of functions inside it are theirs."""
        return set(_raised(self.node.body))


def _raised(nodes: Sequence[ast.AST]) -> Iterator[str]:
    for node in nodes:
        if isinstance(node, ast.FunctionDef | ast.Lambda | ast.ClassDef):
            continue
        if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
            name = ast.unparse(node.exc.func).rsplit(".", 1)[-1]
            if name[0].isupper():  # a helper that words the error is not its class
                yield name
        yield from _raised(list(ast.iter_child_nodes(node)))


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


ALL = documented("quasidynamic", "fem", "flexbearing")
FUNCTIONS = [each for each in ALL if isinstance(each.node, ast.FunctionDef) and each.public]
WITH_PARAMETERS = [each for each in FUNCTIONS if "Parameters" in each.sections]
RAISING = [each for each in FUNCTIONS if each.raised and not each.name.startswith(HELP_TEXTS)]
EQUATIONS = [
    each for each in ALL if each.name.startswith(("quasidynamic.", "fem.")) and ".. math::" in each.text
]


def each(of: list[Documented]):
    return pytest.mark.parametrize("item", of, ids=[item.name for item in of])


@each([item for item in FUNCTIONS if item.name.startswith(PHYSICS)])
def test_physics_function_names_units_and_source(item):
    assert item.text or item.node.name == "drop"
    if "Parameters" in item.sections:  # a numerical helper may do with a sentence
        assert "[" in item.text, "no units"
        assert "Source" in item.sections, "no source"


@each(WITH_PARAMETERS)
def test_documented_parameters_equal_the_signature(item):
    assert item.parameters == item.signature


@each(RAISING)
def test_function_that_raises_says_what(item):
    undocumented = {name for name in item.raised if name not in item.sections.get("Raises", "")}
    assert not undocumented, "raised, but not under Raises"


@each(EQUATIONS)
def test_equation_names_its_source(item):
    texts = (item.text, *item.enclosing)
    assert any("\nSource\n---" in text or "erived here" in text for text in texts), "no source"


def test_there_are_docstrings_to_look_at():
    assert len(WITH_PARAMETERS) > 200
    assert len(RAISING) > 50
    assert len(EQUATIONS) > 100


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
    lying = list(_within(ast.parse(PROMISES_TOO_MUCH), "lying", ()))[1]
    assert lying.parameters == ["load", "limits"] != lying.signature == ["load", "limit"]
    assert lying.raised == {"ValueError"}
    assert "Raises" not in lying.sections
    assert "Source" not in lying.sections
