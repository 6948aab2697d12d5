"""Public functions of the physics say what they compute, in which units, and where it comes from."""

import importlib
import inspect
import pkgutil

import pytest

import quasidynamic

PHYSICS = ("quasidynamic.contact", "quasidynamic.clearance", "quasidynamic.motion", "quasidynamic.outcome")


def public_functions():
    for module in pkgutil.walk_packages(quasidynamic.__path__, "quasidynamic."):
        if module.name.startswith(PHYSICS) and not module.ispkg:
            loaded = importlib.import_module(module.name)
            for name, function in inspect.getmembers(loaded, inspect.isfunction):
                if function.__module__ == module.name and not name.startswith("_"):
                    yield pytest.param(function, id=f"{module.name}.{name}")


@pytest.mark.parametrize("function", list(public_functions()))
def test_physics_function_names_units_and_source(function):
    text = inspect.getdoc(function) or ""
    assert text
    if "Parameters" in text:  # a numerical helper may do with a sentence
        assert "[" in text, "no units"
        assert "Source" in text, "no source"


def test_there_are_functions_to_look_at():
    assert len(list(public_functions())) > 10
