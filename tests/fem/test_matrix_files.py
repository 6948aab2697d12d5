"""Stiffness matrices in the files of CalculiX, Abaqus and Nastran."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy import sparse

from fem.matrix import read
from fem.matrix.stiffness import symmetric
from fem.parts.material import ImpossiblePart
from tests.fem import written_matrices as write

UNKNOWNS = np.array([(node, motion) for node in (7, 3, 12) for motion in (1, 2, 3)])
WAYS = {"sti": write.calculix, "mtx": write.abaqus, "dmig": write.nastran}


@pytest.fixture(scope="module")
def matrix():
    root = np.random.default_rng(1).normal(size=(9, 9)) * 1e5
    return sparse.csc_array(root @ root.T)


def in_order(found):
    """Dense matrix by node 3, 7, 12."""
    order = np.lexsort([found.motions, found.nodes])
    return found.matrix.toarray()[np.ix_(order, order)], found.nodes[order]


@pytest.mark.parametrize("ending", WAYS)
def test_every_file_gives_the_matrix_back(matrix, ending, tmp_path):
    found, nodes = in_order(read.stiffness(WAYS[ending](tmp_path / f"k.{ending}", UNKNOWNS, matrix)))
    order = np.lexsort([UNKNOWNS[:, 1], UNKNOWNS[:, 0]])
    assert_allclose(nodes, UNKNOWNS[order, 0])
    digits = 1e-9 if ending == "dmig" else 1e-14
    assert_allclose(found, matrix.toarray()[np.ix_(order, order)], rtol=digits, atol=digits * 1e10)


CARDS = {
    "free": "DMIG,K,0,1,1,0\nDMIG,K,1,1,,1,1,2.0\n,1,2,-1.0\nDMIG,K,1,2,,1,2,3.+0",
    "small": "DMIG    K       0       1       1       0\n"
    "DMIG    K       1       1               1       1       2.0             +A\n"
    "+A      1       2       -1.0\n"
    "DMIG    K       1       2               1       2       3.0",
    "large": "DMIG    K       0       6       2       0\n"
    "DMIG*   K               1               1\n"
    "*       1               1               2.0D+00\n"
    "*       1               2               -1.0D+0         $ comment\n"
    "DMIG*   K               1               2\n"
    "*       1               2               .3+1",
}


@pytest.mark.parametrize("text", CARDS.values(), ids=CARDS)
def test_cards_of_nastran_in_every_field_width(text, tmp_path):
    (tmp_path / "k.bdf").write_text(f"$ comment\nSOL 101\n{text}\nENDDATA\n")
    found = read.stiffness(tmp_path / "k.bdf")
    assert_allclose(found.matrix.toarray(), [[2, -1], [-1, 3]], rtol=1e-14)
    assert found.motions.tolist() == [1, 2]


def test_nodes_of_both_kinds_of_mesh(tmp_path):
    places, numbers = np.array([[1.5, -2.25, 3e-3], [0.0, 1e3, -7.0]]), [4, 19]
    for path in (
        write.nodes_inp(tmp_path / "m.inp", places, numbers),
        write.grid_bdf(tmp_path / "m.bdf", places, numbers),
    ):
        found = read.places(path)
        assert [*found] == numbers
        assert_allclose([*found.values()], places, rtol=1e-9, atol=0)
    small = "".join(f"{word:>8}" for word in (19, "", "0.", "1000.0", "-7.0"))
    (tmp_path / "free.bdf").write_text(f"GRID,4,,1.5,-2.25,3.-3\nGRID    {small}\n")
    assert_allclose([*read.places(tmp_path / "free.bdf").values()], places, rtol=1e-9, atol=0)


def test_condensed_matrix_answers_as_the_whole_one(matrix):
    """Forces at the kept nodes alone: S u_k = f_k."""
    whole = symmetric(*UNKNOWNS.T, *np.indices((9, 9)).reshape(2, -1), matrix.toarray().ravel())
    S = whole.at([3, 12])
    force = np.random.default_rng(2).normal(size=6)
    kept = [3, 4, 5, 6, 7, 8]
    load = np.zeros(9)
    load[kept] = force
    assert_allclose(np.linalg.solve(S, force), np.linalg.solve(matrix.toarray(), load)[kept], rtol=1e-6)


WRONG = {
    "another ending": ("k.txt", "1 1 2.0", "a matrix has the ending .sti"),
    "no numbers": ("k.mtx", "1 1 1 x 2.0\n", "holds no 5 numbers"),
    "too few numbers": ("k.mtx", "1 1 1 2.0\n", "do not hold 5 numbers"),
    "empty": ("k.mtx", "** nothing\n", "do not hold 5 numbers"),
    "not symmetric": ("k.mtx", "1 1 1 2 5.0\n1 2 1 1 4.0\n", "not symmetric"),
    "not finite": ("k.mtx", "1 1 1 1 nan\n", "not finite"),
    "a motion of its own": ("k.mtx", "1 7 1 7 1.0\n", "none of 1 to 6"),
    "complex": ("k.bdf", "DMIG,K,0,6,4,0\nDMIG,K,1,1,,1,1,2.0,1.0\n", "of real numbers"),
    "two matrices": ("k.bdf", "DMIG,K,0,6,2,0\nDMIG,M,0,6,2,0\n", "2 matrices, K, M"),
    "no matrix": ("k.bdf", "GRID,1,,0.,0.,0.\n", "holds no DMIG"),
    "no number": ("k.bdf", "DMIG,K,0,6,2,0\nDMIG,K,1,1,,1,1,two\n", "'two' is no number"),
    "no unknowns": ("k.sti", "1 1 2.0\n", "k.dof: cannot be read"),
}


@pytest.mark.parametrize(("name", "text", "complaint"), WRONG.values(), ids=WRONG)
def test_files_that_hold_no_stiffness_are_refused(name, text, complaint, tmp_path):
    (tmp_path / name).write_text(text)
    with pytest.raises(ImpossiblePart, match=complaint):
        read.stiffness(tmp_path / name)


def test_seats_that_are_no_seats_are_refused(matrix):
    whole = symmetric(*UNKNOWNS.T, *np.indices((9, 9)).reshape(2, -1), matrix.toarray().ravel())
    with pytest.raises(ImpossiblePart, match="node 5 on the seat has no unknown 1"):
        whole.at([3, 5])
    loose = symmetric(np.array([1, 1, 1, 2]), np.array([1, 2, 3, 1]), np.arange(3), np.arange(3), np.ones(3))
    with pytest.raises(ImpossiblePart, match="can move without force"):
        loose.at([1])


@pytest.mark.parametrize(
    "text", ["*ELEMENT\n1,2\n", "*NODE\n1, a, 2\n", "GRID,1,5,0.,0.,0.\n", "GRID,1,,0.,0.,0.,5\n"]
)
def test_files_without_nodes_are_refused(text, tmp_path):
    (tmp_path / "m.inp").write_text(text)
    with pytest.raises(ImpossiblePart, match=r"node|basic system"):
        read.places(tmp_path / "m.inp")
