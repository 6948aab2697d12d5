"""An outer ring on a body whose stiffness another finite element program wrote."""

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose
from pytest import approx

import flexbearing
from flexbearing import BadCase
from flexbearing.__main__ import command
from flexbearing.build import ring_parts
from flexbearing.build.ring_parts import outer_part

CONFIGS, SEAT = Path(__file__).parents[2] / "configs", Path(__file__).parent / "seat"
PAPER = CONFIGS / "mao2016.toml"
COARSE = {
    "inner.kind": "rigid", "outer.width": "12 mm", "outer.thickness": "5 mm", "accuracy.slices": 8,
    "accuracy.axial_shapes": 2, "accuracy.element_order": 3, "accuracy.mesh_size": "5 mm",
    "accuracy.raceway_mesh_size": "2 mm",
}  # fmt: skip
MATRIX = {
    "outer.kind": "matrix", "outer.centre_x": "3 mm",
    "outer.matrix": str(SEAT / "springs.mtx"), "outer.nodes": str(SEAT / "springs.inp"),
}  # fmt: skip
SPRINGS = {
    "outer.kind": "ring", "outer.support": "foundation", "outer.bilateral": True,
    "outer.foundation_axial": "1000 N/mm^3", "outer.foundation_radial": "2000 N/mm^3",
    "outer.foundation_tangential": "500 N/mm^3",
}  # fmt: skip


@pytest.fixture(scope="module")
def on_matrix(tmp_path_factory):
    return flexbearing.run(PAPER, COARSE | MATRIX, output=tmp_path_factory.mktemp("run") / "m.h5")


def test_springs_as_a_matrix_load_the_rollers_as_a_foundation(on_matrix):
    """24 nodes around, 3 along: harmonics up to 11, so the ring is a little softer between nodes."""
    springs = flexbearing.run(PAPER, COARSE | SPRINGS)
    rigid = flexbearing.run(PAPER, {"inner.kind": "rigid", "outer.kind": "rigid", "accuracy.slices": 8})
    loads = on_matrix.flexible["inner_load"]
    assert on_matrix.attributes["status"] == "converged"
    known = springs.flexible["inner_load"]
    assert_allclose(loads, known, rtol=0, atol=2e-3 * known.max())
    assert float(on_matrix["total_stiffness"]) == approx(float(springs["total_stiffness"]), rel=1e-2)
    assert np.abs(rigid.rigid["inner_load"] - known).max() > 0.01 * known.max()


def test_units_of_the_files_are_those_of_the_case():
    part = outer_part(flexbearing.api.check(PAPER, COARSE | MATRIX))
    newtons = part.support.stiffness  # pyright: ignore[reportOptionalMemberAccess, reportAttributeAccessIssue]
    assert np.abs(part.support.places[:, 1:]).max() == approx(42.5e-3, rel=1e-9)  # pyright: ignore
    area = 2 * np.pi * 42.5e-3 * 12e-3
    assert newtons[::3, ::3].sum() == approx(1e12 * area, rel=1e-8)
    kilo = outer_part(flexbearing.api.check(PAPER, COARSE | MATRIX | {"outer.force_unit": "1 kN"}))
    assert_allclose(kilo.support.stiffness, 1e3 * newtons, rtol=1e-12)  # pyright: ignore


def test_mesh_with_other_axes_is_the_same_body(tmp_path):
    """Its z is our x, its x our y, its y our z."""
    lines = (SEAT / "springs.inp").read_text().splitlines()
    nodes = [line.split(",") for line in lines if line[0] != "*"]
    (tmp_path / "n.inp").write_text("*NODE\n" + "".join(f"{n},{y},{z},{x}\n" for n, x, y, z in nodes))
    motion = {"1": "3", "2": "1", "3": "2"}
    rows = [line.split(",") for line in (SEAT / "springs.mtx").read_text().splitlines() if line[0] != "*"]
    (tmp_path / "k.mtx").write_text(
        "".join(f"{n},{motion[p]},{m},{motion[q]},{value}\n" for n, p, m, q, value in rows)
    )
    turned = {
        "outer.matrix": str(tmp_path / "k.mtx"), "outer.nodes": str(tmp_path / "n.inp"), "outer.axis": "z",
        "outer.zenith": "y", "outer.centre_x": "0 mm", "outer.centre_z": "3 mm",
    }  # fmt: skip
    one, other = (
        outer_part(flexbearing.api.check(PAPER, COARSE | MATRIX | more)).support  # pyright: ignore
        for more in ({}, turned)
    )
    assert_allclose(other.places, one.places, rtol=0, atol=1e-12)
    assert_allclose(other.stiffness, one.stiffness, rtol=0, atol=1e-9 * np.abs(one.stiffness).max())


WRONG = {
    "no matrix": ({"outer.matrix": "none.sti"}, "none.sti: there is no such file"),
    "no nodes": ({"outer.nodes": "none.inp"}, "none.inp: there is no such file"),
    "another program": ({"outer.matrix": str(PAPER)}, "a matrix has the ending"),
    "a ring of another size": ({"outer.thickness": "7 mm"}, "no node is on the outer surface"),
    "another length": ({"outer.length_unit": "1 m"}, "no node is on the outer surface"),
    "axes along each other": ({"outer.zenith": "x"}, "at right angles to outer.axis"),
    "the whole solids": (
        {"coupling.structure": "full", "coupling.method": "aitken"},
        "a matrix has no solid",
    ),
    "a turning ring": ({"operation.outer_speed": "100 rpm"}, "its body is held"),
}


@pytest.mark.parametrize(("changes", "complaint"), WRONG.values(), ids=WRONG)
def test_matrices_that_carry_no_ring_are_refused(changes, complaint):
    with pytest.raises(BadCase, match=complaint):
        flexbearing.api.check(PAPER, COARSE | MATRIX | changes)


def turned(folder, change):
    """The springs with other entries."""
    rows = [line.split(",") for line in (SEAT / "springs.mtx").read_text().splitlines() if line[0] != "*"]
    path = folder / "k.mtx"
    path.write_text("".join(f"{','.join(row[:4])},{change(row)}\n" for row in rows))
    return COARSE | MATRIX | {"outer.matrix": str(path)}


INDEFINITE = {
    "diagonal entries": lambda row: -float(row[4]) if row[:2] == row[2:4] and int(row[0]) < 4 else row[4],
    "coupling entries": lambda row: "5e4" if row[0] == row[2] == "1" and row[1] != row[3] else row[4],
}


def test_the_name_of_a_file_begins_its_problem_once(tmp_path):
    with pytest.raises(BadCase, match=r"(?<!mtx: )k.mtx: '1.5e' is no number"):
        flexbearing.api.check(PAPER, turned(tmp_path, lambda row: "1.5e"))


@pytest.mark.parametrize("change", INDEFINITE.values(), ids=INDEFINITE)
def test_indefinite_matrices_are_refused_with_their_eigenvalues(change, tmp_path):
    with pytest.raises(BadCase, match=r"k.mtx: the stiffness of the seat is indefinite.* from -[0-9.e+]+ to"):
        flexbearing.api.check(PAPER, turned(tmp_path, change))


def codes(case):
    return {note.code: note.text for note in ring_parts.notes(case)}


def test_the_note_on_a_matrix_tells_its_eigenvalues_and_what_holds_it(on_matrix):
    """Softest and stiffest springs of 24 by 3 nodes; all of them stand on the ground."""
    (text,) = [note["text"] for note in on_matrix.attributes["notes"] if note["code"] == "matrix"]
    assert "72 of 72 nodes are the seat" in text
    assert "eigenvalues from 1.854e+07 to 1.187e+08 N/m" in text
    assert "x, y, z with 3.204, 4.006, 4.006 kN/um" in text
    assert "loads 72 of 72 nodes" in text


def test_a_body_that_rounding_may_hold_is_noted(tmp_path):
    """Springs along x that nearly vanish."""
    soft = turned(tmp_path, lambda row: 1e-7 * float(row[4]) if row[1] == row[3] == "1" else row[4])
    assert "loose-matrix" in codes(flexbearing.api.check(PAPER, soft))
    assert "loose-matrix" not in codes(flexbearing.api.check(PAPER, COARSE | MATRIX))


def test_body_without_a_solid_has_no_fields(on_matrix, capsys):
    assert command(["export", str(on_matrix.path), "--to", "vtu"]) == 1
    assert "a matrix alone" in capsys.readouterr().err


DECK = """*INCLUDE, INPUT=housing.inp
*MATERIAL, NAME=STEEL
*ELASTIC
{youngs_modulus:g}, {poisson_ratio:g}
*DENSITY
7.85e-9
*SOLID SECTION, ELSET=ALL, MATERIAL=STEEL
*BOUNDARY
CLAMPED, 1, 3
"""
STORED = "*STEP\n*FREQUENCY, SOLVER=MATRIXSTORAGE\n1\n*END STEP\n"


def tube(path, inner, outer, width, sizes):
    """A housing of linear bricks, clamped outside, around x = 3 mm."""
    layers, around, along = sizes
    number = np.arange((layers + 1) * around * (along + 1)).reshape(layers + 1, around, along + 1) + 1
    lines = ["*NODE, NSET=EVERY"]
    for (i, j, k), node in np.ndenumerate(number):
        radius, angle = inner + (outer - inner) * i / layers, 2 * np.pi * j / around
        x = 3 + width * (k / along - 0.5)
        lines.append(f"{node}, {x:.9f}, {radius * np.sin(angle):.9f}, {radius * np.cos(angle):.9f}")
    lines.append("*ELEMENT, TYPE=C3D8I, ELSET=ALL")
    element = 0
    for i in range(layers):
        for j in range(around):
            for k in range(along):
                element += 1
                n = [number[i + a, (j + b) % around, k + c] for c in (0, 1)
                     for a, b in ((0, 0), (0, 1), (1, 1), (1, 0))]  # fmt: skip
                lines.append(f"{element}, " + ", ".join(map(str, n)))
    lines.append("*NSET, NSET=CLAMPED")
    lines += [f"{node}," for node in number[-1].ravel()]
    path.write_text("\n".join(lines) + "\n")
    return number[0].ravel()


@pytest.mark.calculix
def test_housing_of_calculix_carries_the_ring_as_one_of_ours(tmp_path):
    """A tube of 10 mm around the ring, meshed and stored by CalculiX, beside the same housing here."""
    if shutil.which("ccx") is None:
        pytest.skip("CalculiX is not installed: the Debian package calculix-ccx has it")
    tube(tmp_path / "housing.inp", 42.5, 52.5, 12.0, (4, 72, 6))
    steel = flexbearing.api.check(PAPER, COARSE | MATRIX).materials.outer_ring
    (tmp_path / "deck.inp").write_text(
        DECK.format(youngs_modulus=1e-6 * steel.youngs_modulus, poisson_ratio=steel.poisson_ratio) + STORED
    )
    subprocess.run(["ccx", "deck"], cwd=tmp_path, capture_output=True, check=True, timeout=300)
    shutil.copy(tmp_path / "housing.inp", tmp_path / "nodes.inp")
    files = {"outer.matrix": str(tmp_path / "deck.sti"), "outer.nodes": str(tmp_path / "nodes.inp")}
    found = flexbearing.run(PAPER, COARSE | MATRIX | files)
    housed = {
        "outer.kind": "ring", "outer.support": "housing", "outer.housing_thickness": "10 mm",
        "outer.housing_width": "12 mm",
    }  # fmt: skip
    known = flexbearing.run(PAPER, COARSE | housed)
    loads, ours = found.flexible["inner_load"], known.flexible["inner_load"]
    assert_allclose(loads, ours, rtol=0, atol=1e-3 * ours.max())
    assert float(found["total_stiffness"]) == approx(float(known["total_stiffness"]), rel=3e-3)
    assert float(found["support_stiffness"]) == approx(float(known["support_stiffness"]), rel=1.5e-2)
