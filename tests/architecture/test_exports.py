"""What each package offers is told to the type checker and to the interpreter: both agree."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import fem
import flexbearing
import quasidynamic

PACKAGES = (quasidynamic, fem, flexbearing)


@pytest.mark.parametrize("package", PACKAGES, ids=lambda package: package.__name__)
def test_lazy_names_are_those_that_the_type_checker_sees(package):
    tree, within = ast.parse(Path(package.__file__).read_text()), f"{package.__name__}."
    seen = {
        node.module.removeprefix(within): tuple(name.name for name in node.names)
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith(within)
    }
    assert seen == package.EXPORTS


@pytest.mark.parametrize(
    ("package", "name"), [(package, name) for package in PACKAGES for name in dir(package)]
)
def test_lazy_name_is_there(package, name):
    assert getattr(package, name) is not None


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
