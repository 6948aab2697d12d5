"""Every output quantity is declared once, and everything that shows it follows the declaration."""

import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import flexbearing
from flexbearing.families import FAMILIES
from flexbearing.quantities import Quantity, Unit, units
from flexbearing.quantities.quantity import row, taken
from flexbearing.quantities.roller import CAGE_SLIP, LAYOUT, LOSSES
from flexbearing.units import unit

PACKAGE = Path(flexbearing.__file__).parent
EVERY_FAMILY = pytest.mark.parametrize(
    "layout", [family.layout() for family in FAMILIES.values()], ids=FAMILIES
)


@EVERY_FAMILY
def test_names_of_quantities_and_keys_of_the_summary_are_unique(layout):
    for names in ([entry.name for entry in layout.quantities], [value.key for value in layout.summary]):
        assert len(names) == len(set(names))


@EVERY_FAMILY
def test_summary_is_computed_from_declared_quantities(layout):
    declared = layout.datasets("block")
    assert {name for value in layout.summary for name in value.of} <= declared.keys()


@EVERY_FAMILY
def test_a_row_has_a_label_and_a_format(layout):
    assert all(bool(value.label) == bool(value.digits) for value in layout.summary)


def test_inner_comes_first_and_outer_second_in_every_pair():
    sources = {entry.name: entry.source for entry in LAYOUT.quantities}
    pairs = [
        (source, sources[name.replace("inner", "outer")])
        for name, source in sources.items()
        if "inner_" in name
    ]
    assert len(pairs) == 11
    for inner, outer in pairs:
        assert inner.endswith(".0")
        assert outer == inner.removesuffix("0") + "1"


@pytest.mark.parametrize("name", ["%", "deg", "mrad", "um", "mm", "rpm", "MPa", "kN/mm"])
def test_a_unit_for_people_is_the_unit_of_that_name_in_a_case(name):
    shown = {entry.name: entry for entry in vars(units).values() if isinstance(entry, Unit)}
    assert unit(name).to_si(1.0) * shown[name].scale == pytest.approx(1.0, rel=1e-12)


def test_each_loss_is_that_of_its_cause():
    watts = {cause: float(number) for number, cause in enumerate(LOSSES)}
    losses = [entry for entry in LAYOUT.quantities if entry.name.startswith("loss_")]
    values = taken(losses, {"losses": SimpleNamespace(**watts)})
    assert values == {f"loss_{cause}": number for cause, number in watts.items()}


def test_units_for_people_are_those_of_the_keys():
    ends = {"um": "um", "mm": "mm", "deg": "deg", "mrad": "mrad", "MPa": "MPa", "rpm": "rpm", "percent": "%"}
    for family in FAMILIES.values():
        for value in family.layout().summary:
            unit = ends.get(value.key.rpartition("_")[2])
            if unit and not value.in_si:
                assert value.unit.name == unit, value.key


def test_quantities_are_taken_by_their_sources():
    pair = Quantity("a", "", "Z", "m", "block", "", source="part.inside.pair.1")
    total = Quantity("b", "", "", "m", "block", "", source="part.power.sum")
    by_name = Quantity("c", "", "", "m", "block", "", source="names.x")
    of_state = Quantity("d", "", "", "m", "block", "")
    absent = Quantity("e", "", "", "m", "block", "", source="skew.angle", optional=True)
    part = SimpleNamespace(
        inside=SimpleNamespace(pair=np.array([[1.0, 2], [3, 4]])), power=np.array([5.0, 6])
    )
    many = SimpleNamespace(d=np.array([8.0, 9.0]))
    solved = {"part": [part, None], "names": [{"x": 7.0}, {"x": 6.0}], "state": many, "skew": [None, None]}
    values = taken((pair, total, by_name, of_state, absent), solved)
    assert values.keys() == {"a", "b", "c", "d"}
    assert values["a"] == pytest.approx(np.array([[3.0, 4.0], [np.nan, np.nan]]), nan_ok=True)
    assert row(values, 0) | {"a": None} == {"a": None, "b": 11.0, "c": 7.0, "d": 8.0}
    assert row(values, 1)["d"] == 9.0
    with pytest.raises(AttributeError, match="d"):
        taken((of_state,), {"state": SimpleNamespace()})


def test_a_quantity_for_people_has_their_unit():
    assert CAGE_SLIP.axis_label == "cage slip [%]"
    assert CAGE_SLIP.for_people(0.0628) == pytest.approx(6.28, rel=1e-12)


def test_name_and_key_of_the_cage_slip_stand_in_their_declarations_alone():
    texts = {path: path.read_text() for path in PACKAGE.rglob("*.py")}
    declarations = {
        PACKAGE / "quantities" / name for name in ("roller.py", "angular_contact.py", "tapered.py")
    }
    assert {path for path, text in texts.items() if "cage_slip_percent" in text} == declarations
    assert {path for path, text in texts.items() if '"cage_slip"' in text} == declarations


@pytest.mark.parametrize("module", ["flexbearing.quantities.roller", "flexbearing.quantities.four_point"])
def test_declarations_load_no_files_pictures_or_models(module):
    heavy = ("h5py", "matplotlib", "ngsolve", "rich", "fem", "quasidynamic")
    code = (
        f"import sys, {module}; sys.exit(', '.join(name for name in {heavy!r} if name in sys.modules) or 0)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_summary_loads_neither_models_nor_pictures(tmp_path):
    path = tmp_path / "heras.h5"
    flexbearing.run(PACKAGE.parent / "configs" / "heras2017_a3.toml", output=path)
    heavy = ("matplotlib", "ngsolve", "fem", "quasidynamic")
    code = (
        "import sys, flexbearing, flexbearing.report.output as report; "
        f"report.text(flexbearing.read({str(path)!r})); "
        f"sys.exit(', '.join(name for name in {heavy!r} if name in sys.modules) or 0)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
