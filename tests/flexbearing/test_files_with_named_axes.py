"""Result files as xarray reads them: named dimensions, places along them, units."""

import numpy as np
import pytest
import xarray

import flexbearing
from tests.places import CONFIGS

BEAM = {"inner.kind": "rigid", "outer.kind": "ring", "accuracy.structure": "beam"}  # nothing is meshed
CASES = {"mao2016": BEAM, "joshi2015_fourpoint": {}, "rivera2021_7008": {}}


@pytest.fixture(scope="module", params=CASES, ids=str)
def stored(request, tmp_path_factory):
    output = tmp_path_factory.mktemp(request.param) / "r.h5"
    result = flexbearing.run(CONFIGS / f"{request.param}.toml", CASES[request.param], output=output)
    with xarray.open_datatree(result.path, engine="h5netcdf") as tree:
        yield result, tree


def test_every_dimension_has_a_name(stored):
    _, tree = stored
    names = {str(name) for group in tree.subtree for name in group.dims}
    assert len(names) >= 5
    assert not any(name.startswith("phony") for name in names)


def test_every_dataset_is_there_with_its_unit(stored):
    result, tree = stored
    layout = result.family.layout()
    for block in ("rigid", "flexible"):
        for name, array in getattr(result, block).items():
            found = tree[block][name]
            np.testing.assert_array_equal(found.values, array)
            assert found.attrs["units"] == layout[name].unit
            assert found.dims == tuple(layout.axis[symbol].name for symbol in layout[name].shape)


@pytest.mark.parametrize("stored", ["mao2016"], indirect=True)
def test_rollers_slices_and_iterations_have_their_places(stored):
    result, tree = stored
    loads = tree["iterations"]["inner_slice_load"]
    assert loads.dims == ("iteration", "roller", "slice")
    np.testing.assert_array_equal(loads.roller, result.rigid["roller_azimuth"])
    np.testing.assert_array_equal(loads.slice, result.rigid["slice_position"])
    np.testing.assert_array_equal(loads.iteration, np.arange(1, len(result.iterations) + 1))
    assert (loads.roller.attrs["units"], loads.slice.attrs["units"]) == ("rad", "m")
    assert "race" not in tree["flexible"]["peak_pressure"].coords  # a length alone
