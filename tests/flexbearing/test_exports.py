"""Results in the files of other programs."""

import csv

import numpy as np
import pytest
from numpy.testing import assert_allclose

import flexbearing
from flexbearing.__main__ import command
from tests.flexbearing.test_starting import among, loaded
from tests.places import CONFIGS

BEAM = ["inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam", "accuracy.slices=8"]
CASES = {"rollers": ("mao2016", BEAM), "balls": ("harris218", []), "slow balls": ("joshi2015_fourpoint", [])}


@pytest.fixture(scope="module", params=CASES)
def result(request, tmp_path_factory):
    name, settings = CASES[request.param]
    output = tmp_path_factory.mktemp("run") / "r.h5"
    return flexbearing.run(CONFIGS / f"{name}.toml", settings, output=output)


@pytest.fixture(scope="module")
def tables(result):
    """Rows of every table by its name, with numbers by their headings."""
    folder = result.path.parent / "csv"
    assert command(["export", str(result.path), "--to", "csv", "-o", str(folder)]) == 0
    return {path.stem.removeprefix("r_"): columns(path) for path in folder.iterdir()}


def columns(path):
    with path.open(newline="") as file:
        heads, *rows = csv.reader(file)
    assert len({*heads}) == len(heads)
    return dict(zip(heads, np.array(rows, dtype=float).T, strict=True))


def test_every_number_of_a_block_is_in_one_table_in_the_unit_of_its_heading(result, tables):
    layout = result.family.layout()
    for block, arrays in (("rigid", result.rigid), ("flexible", result.flexible)):
        of_block = {name: table for name, table in tables.items() if name.startswith(f"{block}_")}
        for name, array in arrays.items():
            entry = layout[name]
            found = [
                (heading, column)
                for table in of_block.values()
                for heading, column in table.items()
                if heading.split(" [")[0].split(".")[0] == name
            ]
            if name not in {
                axis.coordinate for axis in layout.axis.values()
            }:  # which stand beside others, too
                assert sum(column.size for _, column in found) == array.size
                numbers = np.sort(np.concatenate([column for _, column in found]))
                assert_allclose(numbers, np.sort(entry.for_people(array).ravel()), rtol=1e-14, atol=0)
            unit = entry.unit_for_people.name
            assert all(
                heading.partition(" [")[2].rstrip("]") in (unit, *unit.split(", ")) for heading, _ in found
            )


def test_slices_of_rollers_stand_in_long_form(tmp_path):
    result = flexbearing.run(CONFIGS / "mao2016.toml", BEAM, output=tmp_path / "r.h5")
    assert command(["export", str(result.path), "--to", "csv", "-o", str(tmp_path)]) == 0
    table = columns(tmp_path / "r_flexible_roller_slice.csv")
    rollers, slices = result.flexible["inner_slice_load"].shape
    assert_allclose(table["roller"], np.repeat(np.arange(1, rollers + 1), slices), rtol=0, atol=0)
    assert_allclose(table["slice"], np.tile(np.arange(1, slices + 1), rollers), rtol=0, atol=0)
    loads = result.flexible["inner_slice_load"].ravel()
    assert_allclose(table["inner_slice_load [N/m]"], loads, rtol=1e-14, atol=0)
    degrees = np.degrees(result.flexible["roller_azimuth"])
    assert_allclose(table["roller_azimuth [deg]"], np.repeat(degrees, slices), rtol=1e-14, atol=0)
    scalars = columns(tmp_path / "r_flexible_scalars.csv")
    for heading, (row, column) in {
        "stiffness_matrix.y.z [N/m]": (1, 2),
        "stiffness_matrix.z.about y [N/rad]": (2, 3),
        "stiffness_matrix.about y.z [N m/m]": (3, 2),
        "stiffness_matrix.about z.about y [N m/rad]": (4, 3),
    }.items():
        matrix = result.flexible["stiffness_matrix"]
        assert_allclose(scalars[heading], matrix[row, column], rtol=1e-14, atol=0)


@pytest.mark.slow
def test_netcdf_comes_back_with_its_axes_and_units(result, tmp_path):
    xarray = pytest.importorskip("xarray")
    assert command(["export", str(result.path), "--to", "netcdf", "-o", str(tmp_path)]) == 0
    with xarray.open_datatree(tmp_path / "r.nc", engine="h5netcdf") as tree:
        xarray.testing.assert_identical(tree.load(), tree)
        for name, array in result.rigid.items():
            found = tree[f"rigid/{name}"]
            assert_allclose(found.values, array, rtol=0, atol=0)
            assert found.attrs["units"] == result.family.layout()[name].unit


@pytest.mark.sampled(2)
def test_netcdf_is_read_by_its_own_library(result, tmp_path):
    netcdf4 = pytest.importorskip("netCDF4")
    assert command(["export", str(result.path), "--to", "netcdf", "-o", str(tmp_path)]) == 0
    with netcdf4.Dataset(tmp_path / "r.nc") as read:
        element = "roller" if result.kind == "cylindrical_roller" else "ball"
        azimuths = read[f"rigid/{element}_azimuth"]
        assert (azimuths.dimensions, azimuths.units) == ((element,), "rad")
        assert_allclose(azimuths[:], result.rigid[f"{element}_azimuth"], rtol=0, atol=0)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("form", ["csv", pytest.param("netcdf", marks=pytest.mark.slow)])
def test_export_without_fields_loads_no_finite_elements(result, form, tmp_path):
    modules = loaded("export", result.path, "--to", form, "-o", tmp_path)
    assert among(modules, ("ngsolve", "netgen", "fem", "quasidynamic", "matplotlib")) == []


WRONG = {
    "another form": (["--to", "pdf"], "one of csv, vtu, netcdf"),
    "a part of tables": (["--to", "csv", "--part", "outer"], "belongs to --to vtu"),
    "a state of tables": (["--to", "netcdf", "--state", "rigid"], "belongs to --to vtu"),
}


@pytest.mark.parametrize(("words", "complaint"), WRONG.values(), ids=WRONG)
def test_wrong_exports_are_refused(result, words, complaint, capsys, tmp_path):
    assert command(["export", str(result.path), *words, "-o", str(tmp_path)]) == 2
    said = capsys.readouterr().err
    assert complaint in said
    assert said.count("\n") == 1
    assert list(tmp_path.iterdir()) == []
