"""Stiffness over the speed as a bearing of a rotor in ROSS."""

import json
import os
import subprocess
import tomllib
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

import flexbearing
from flexbearing.exports import ross
from flexbearing.results import BadResult
from tests.places import CONFIGS

HEADS = (
    "operation.inner_speed [rpm],total_stiffness_yy [kN/mm],total_stiffness_yz [N/m],"
    "total_stiffness_zy [N/m],total_stiffness_zz [N/m],status"
)
SPEEDS = (1000, 2000, 3000, 4000, 5000)


def table(path, speeds=SPEEDS, heads=HEADS, ending="converged"):
    rows = [
        f"{speed},{100 + number},{number},{2 * number},4e8,{ending}" for number, speed in enumerate(speeds)
    ]
    path.write_text("\n".join([heads, *rows]) + "\n")
    return path


def turned(matrix, axes):
    """Stiffness over x, y of ROSS from that over x, y, z here; rows of `axes` are its unit vectors."""
    return (axes @ matrix @ axes.T)[:2, :2]


@pytest.mark.parametrize("sense", [1, -1])
def test_axes_are_right_handed_and_follow_the_speed(tmp_path, sense):
    """ROSS turns positive about its z; a positive speed here turns about -x."""
    bearing = ross.read(table(tmp_path / "t.csv", [sense * speed for speed in SPEEDS]))
    axes = np.array([[0, sense, 0], [0, 0, -1], [-sense, 0, 0]])
    assert_allclose(np.cross(axes[0], axes[1]), axes[2], rtol=0, atol=0)
    assert_allclose(axes[2] @ [-sense, 0, 0], 1, rtol=0, atol=0)  # along it the shaft turns by the right hand
    assert_allclose(bearing.speed, np.array(SPEEDS) * np.pi / 30, rtol=1e-14)
    for number in range(5):
        here = np.array([[0, 0, 0], [0, (100 + number) * 1e6, number], [0, 2 * number, 4e8]])
        there = [
            [each[number] for each in row] for row in ((bearing.kxx, bearing.kxy), (bearing.kyx, bearing.kyy))
        ]
        assert_allclose(there, turned(here, axes), rtol=1e-14, atol=0)


def test_file_names_its_axis_as_the_version_of_ross_does(tmp_path):
    paths = [*ross.export(table(tmp_path / "t.csv", SPEEDS[::-1]), tmp_path / "out")]
    for path, axis in zip(paths, ("frequency", "speed"), strict=True):
        element = tomllib.loads(path.read_text())["BearingElement_t"]
        assert_allclose(element[axis], np.array(SPEEDS) * np.pi / 30, rtol=1e-14)
        assert {"frequency", "speed"} & {*element} == {axis}
        assert_allclose(element["kxx"], [104e6, 103e6, 102e6, 101e6, 100e6], rtol=1e-14)
        assert element["cxx"] == [0.0] * 5


def test_stiffness_whose_tilt_follows_goes_before_that_which_holds_it(tmp_path):
    """Of roller bearings a table has both; of ball bearings the entries of the matrix alone."""
    both = tmp_path / "both.csv"
    rows = [f"{speed},1,2,3,4,10,20,30,40,converged" for speed in SPEEDS]
    held = ",".join(f"stiffness_{entry} [N/m]" for entry in ross.ENTRIES)
    heads = HEADS.replace("[kN/mm]", "[N/m]").replace(",status", f",{held},status")
    both.write_text("\n".join([heads, *rows]))
    assert_allclose(ross.read(both).kyy, 4.0, rtol=0, atol=0)
    balls = ross.read(table(tmp_path / "balls.csv", heads=HEADS.replace("total_", "")))
    assert_allclose(balls.kyy, 4e8, rtol=0, atol=0)


def test_stiffness_that_holds_no_rotor_is_refused(tmp_path):
    file = table(tmp_path / "t.csv")
    file.write_text(file.read_text().replace(",4e8,", ",-4e8,", 1))
    with pytest.raises(BadResult, match="not positive"):
        ross.read(file)


def test_a_result_becomes_a_bearing_of_one_speed_that_says_whether_supports_are_inside(tmp_path):
    beam = {"inner.kind": "rigid", "outer.kind": "ring", "accuracy.structure": "beam"}
    result = flexbearing.run(CONFIGS / "mao2016.toml", beam)
    (path,) = ross.export(result, tmp_path)
    element = tomllib.loads(path.read_text())["BearingElement_mao2016"]
    assert element["kyy"] == result["total_stiffness_zz [N/m]"].number
    assert element["kxy"] == -result["total_stiffness_yz [N/m]"].number
    assert "outer ring (ring)" in path.read_text().splitlines()[0]
    (path,) = ross.export(flexbearing.run(CONFIGS / "6209.toml"), tmp_path)
    assert "rigid" in path.read_text().splitlines()[0]


WRONG = {
    "four speeds": ({"speeds": SPEEDS[:4]}, "4 speeds"),
    "a speed twice": ({"speeds": (*SPEEDS, 1000)}, "a speed twice"),
    "both directions": ({"speeds": (*SPEEDS, -500)}, "both directions"),
    "no such output": ({"heads": HEADS.replace("stiffness_yz", "other")}, "no column total_stiffness_yz"),
    "another unit": ({"heads": HEADS.replace("[rpm]", "[N]")}, "not in rad/s"),
    "not converged": ({"ending": "diverging"}, "did not converge"),
}


def test_a_result_without_a_stiffness_is_refused():
    with pytest.raises(BadResult, match="stiffness_yy"):
        ross.of_result(flexbearing.run(CONFIGS / "heras2017_a1.toml"))


@pytest.mark.parametrize(("changes", "complaint"), WRONG.values(), ids=WRONG)
def test_tables_that_give_no_bearing_are_refused(tmp_path, changes, complaint):
    with pytest.raises(BadResult, match=complaint):
        ross.read(table(tmp_path / "t.csv", **changes))


def test_file_that_is_no_table_is_refused(tmp_path):
    (tmp_path / "empty.csv").write_text("")
    for path in (tmp_path / "empty.csv", tmp_path / "none.csv", tmp_path):
        with pytest.raises(BadResult, match=r"no table of a study|no such file|is a folder"):
            ross.read(path)


ROTOR = """
import json, sys
import numpy as np, ross as rs
steel = rs.Material("steel", rho=7850, E=206e9, Poisson=0.3)
shaft = [rs.ShaftElement(0.05, 0, 0.06, material=steel) for _ in range(8)]
found = []
for path in sys.argv[1:]:
    left, right = rs.BearingElement.load(path), rs.BearingElement.load(path)
    left.n, right.n, right.tag = 0, 8, "right"
    rotor = rs.Rotor(shaft, [rs.DiskElement(4, 40.0, 0.3, 0.5)], [left, right])
    found.append([float(speed) for speed in rotor.run_critical_speed(num_modes=6).wn()])
print(json.dumps({"critical": found, "kxx": list(map(float, left.kxx))}))
"""


@pytest.mark.ross
def test_rotor_on_a_thicker_ring_has_higher_critical_speeds(tmp_path):
    """Rings of 3 and 5 mm, and rigid ones: the first critical speeds rise from each to the next."""
    python = os.environ.get("FLEXBEARING_ROSS")
    if not python or not Path(python).exists():
        pytest.skip("FLEXBEARING_ROSS names no Python with ROSS: `make test-ross` makes one")
    rings = {"thin": ("ring", "3 mm"), "thick": ("ring", "5 mm"), "rigid": ("rigid", None)}
    paths = []
    for name, (kind, thickness) in rings.items():
        study = [f'case = "{CONFIGS / "mao2016.toml"}"', "[over]"]
        study += ['"operation.inner_speed" = "20000 rpm .. 38000 rpm, 5"', f'"outer.kind" = "{kind}"']
        study += ['"inner.kind" = "rigid"', '"accuracy.slices" = 8']
        study += [f'"outer.thickness" = "{thickness}"', '"accuracy.structure" = "beam"'] if thickness else []
        (tmp_path / f"{name}.toml").write_text("\n".join(study))
        flexbearing.study(tmp_path / f"{name}.toml", output=tmp_path, jobs=1)
        paths += [path for path in ross.export(tmp_path / f"{name}.csv", tmp_path) if "ross2" in path.name]
    (tmp_path / "rotor.py").write_text(ROTOR)
    done = subprocess.run(
        [python, tmp_path / "rotor.py", *paths], capture_output=True, text=True, check=True, cwd=tmp_path
    )
    told = json.loads(done.stdout.splitlines()[-1])
    thin, thick, rigid = (np.array(speeds[:2]) for speeds in told["critical"])
    assert (thin < thick).all()
    assert (thick < rigid).all()
    assert_allclose(told["kxx"], ross.read(tmp_path / "rigid.csv").kxx, rtol=1e-12)
