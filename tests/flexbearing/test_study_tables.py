"""The table of a study in its files, as a frame and as arrays: the same numbers, names and units."""

import errno
import json
import os
from itertools import count
from pathlib import Path

import numpy as np
import pytest

from flexbearing.files import BadOutput, NotStored
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.table import files
from tests.flexbearing.test_studies import computed, counting
from tests.flexbearing.toy_studies import toy

CROSSED = (
    '"operation.radial_load" = "1 kN .. 4 kN, 4"\n"bearing.clearance" = ["20 um", "30 um"]\n'
    '"operation.tilt" = ["fixed", "free"]'
)
ZIPPED = (
    'zip = true\n"operation.radial_load" = "1 kN .. 4 kN, 4"\n'
    '"lubricant.inlet_heating" = [true, false, true, true]'
)


def test_a_crossed_study_is_a_grid_with_named_dimensions_and_units(tmp_path):
    arrays = computed(toy(tmp_path, CROSSED), tmp_path).to_xarray()
    assert dict(arrays.sizes) == {"operation.radial_load": 4, "bearing.clearance": 2, "operation.tilt": 2}
    assert arrays["operation.radial_load"].values.tolist() == [1000.0, 2000.0, 3000.0, 4000.0]
    assert arrays["operation.radial_load"].attrs == {"units": "N"}
    assert arrays["bearing.clearance"].attrs == {"units": "um"}
    assert arrays["operation.tilt"].values.tolist() == ["fixed", "free"]
    life = arrays["life"]
    assert life.attrs == {"units": "Mrev"}
    assert (
        life.sel({"operation.radial_load": 2000.0, "operation.tilt": "free"}).values.tolist() == [125.0] * 2
    )
    assert np.isnan(life.values[0]).all()
    assert arrays["status"].values[0, 0, 0] == "iteration limit"


def test_zipped_keys_are_coordinates_of_one_dimension(tmp_path):
    arrays = computed(toy(tmp_path, ZIPPED), tmp_path).to_xarray()
    assert dict(arrays.sizes) == {"variant": 4}
    assert arrays["variant"].values.tolist() == [1, 2, 3, 4]
    assert arrays["operation.radial_load"].dims == ("variant",)
    assert arrays["lubricant.inlet_heating"].values.tolist() == [1, 0, 1, 1]
    assert arrays["slip"].values[1:] == pytest.approx([0.2, 0.3, 0.4])


def test_rows_of_a_file_are_crossed_with_other_keys(tmp_path):
    import xarray

    (tmp_path / "list.csv").write_text(
        "operation.radial_load [kN],operation.inner_speed [rpm]\n2,3000\n4,5000\n"
    )
    over = 'file = "list.csv"\n"bearing.clearance" = ["20 um", "30 um", "40 um"]'
    arrays = computed(toy(tmp_path, over), tmp_path).to_xarray()
    with xarray.open_dataset(tmp_path / "toy.nc") as stored:
        xarray.testing.assert_identical(stored.load(), arrays)
    assert dict(arrays.sizes) == {"row": 2, "bearing.clearance": 3}
    assert arrays["operation.inner_speed"].values.tolist() == [3000.0, 5000.0]
    assert arrays["life"].values.tolist() == [[125.0] * 3, [15.625] * 3]


@pytest.mark.parametrize("over", [CROSSED, ZIPPED], ids=["crossed", "zipped"])
def test_every_file_holds_the_same_table(tmp_path, over):
    import pandas
    import xarray

    table = computed(toy(tmp_path, over), tmp_path)
    frame = table.to_pandas()
    parquet = pandas.read_parquet(tmp_path / "toy.parquet")
    pandas.testing.assert_frame_equal(parquet, frame)
    csv = pandas.read_csv(tmp_path / "toy.csv", keep_default_na=True)
    for heading in frame:
        if frame[heading].dtype.kind == "f":
            np.testing.assert_array_equal(csv[heading], frame[heading])
    with xarray.open_dataset(tmp_path / "toy.nc") as stored:
        xarray.testing.assert_identical(stored.load(), table.to_xarray())


def test_parquet_carries_units(tmp_path):
    from pyarrow import parquet

    computed(toy(tmp_path), tmp_path)
    schema = parquet.read_schema(tmp_path / "toy.parquet")
    assert schema.field("operation.radial_load [N]").metadata[b"unit"] == b"N"
    assert schema.field("status").metadata[b"unit"] == b""
    assert json.loads(schema.metadata[b"units"])["life [Mrev]"] == "Mrev"


def test_angles_are_in_degrees(tmp_path):
    table = toy(tmp_path, '"operation.misalignment" = ["0 deg", "0.1 deg"]').table({})
    assert table["operation.misalignment [deg]"].values == (0.0, 0.1)


def test_without_the_extra_the_table_is_csv_and_the_rest_says_what_to_install(tmp_path, monkeypatch):
    from flexbearing.studies import messages

    monkeypatch.setattr(files, "find_spec", lambda name: None)
    prepared = toy(tmp_path)
    table = computed(prepared, tmp_path)
    assert sorted(path.suffix for path in tmp_path.iterdir()) == [".csv", ".jsonl", ".toml"]
    missing = 'toy.parquet, not written without pyarrow: pip install "flexbearing[studies]"'
    assert any(line.endswith(missing) for line in messages.end(prepared, table, tmp_path).splitlines())


def test_a_full_disk_keeps_the_rows_and_the_table_before(tmp_path, monkeypatch):
    prepared = toy(tmp_path)
    computed(prepared, tmp_path)
    before = (tmp_path / "toy.csv").read_bytes()
    write_part, times = Path.open, count()

    def full(path, mode="r", *rest, **options):
        if mode == "xb" and path.name.startswith("toy.csv") and next(times):  # not when the place is tried
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return write_part(path, mode, *rest, **options)

    monkeypatch.setattr(Path, "open", full)
    with pytest.raises(NotStored, match=r"toy\.csv: not written: No space left on device"):
        computed(toy(tmp_path, '"operation.radial_load" = "2 kN .. 9 kN, 8"'), tmp_path)
    monkeypatch.undo()
    assert (tmp_path / "toy.csv").read_bytes() == before
    work, loads = counting()
    computed(toy(tmp_path, '"operation.radial_load" = "2 kN .. 9 kN, 8"'), tmp_path, work, Serial())
    assert loads == []


def test_a_folder_that_may_only_be_read_is_told_before_anything_is_computed(tmp_path, monkeypatch):
    prepared, (work, loads) = toy(tmp_path), counting()

    def protected(path):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr("flexbearing.files.destination.require_part", protected)
    with pytest.raises(BadOutput, match="no folder to write to: Permission denied"):
        computed(prepared, tmp_path / "out", work)
    assert loads == []
