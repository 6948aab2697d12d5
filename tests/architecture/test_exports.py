"""What `quasidynamic` offers is told once to the type checker and once to the interpreter: both agree."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import quasidynamic


def test_lazy_names_are_those_that_the_type_checker_sees():
    tree = ast.parse(Path(quasidynamic.__file__).read_text())
    seen = {
        node.module.removeprefix("quasidynamic."): tuple(name.name for name in node.names)
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("quasidynamic.")
    }
    assert seen == quasidynamic.EXPORTS


@pytest.mark.parametrize("name", dir(quasidynamic))
def test_lazy_name_is_there(name):
    assert getattr(quasidynamic, name) is not None


@pytest.mark.parametrize(
    ("name", "foreign"),
    [
        ("RollerBearing", ("ball", "four_point", "angular_contact", "ellipse")),
        ("FourPointBallBearing", (".rollers", "quasidynamic.roller", "roller_bearing")),
        ("AngularContactBallBearing", (".rollers", "quasidynamic.roller", "roller_bearing")),
    ],
)
def test_a_bearing_family_loads_nothing_of_the_others(name, foreign):
    code = f"import quasidynamic, sys; quasidynamic.{name}; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    modules = [module for module in loaded.stdout.split() if module.startswith("quasidynamic")]
    assert [module for module in modules if any(part in module for part in foreign)] == []
