"""Stiffness matrices in the files of CalculiX, Abaqus and Nastran."""

import re

import numpy as np
import pytest
from numpy.testing import assert_allclose
from pytest import approx
from scipy import sparse

from fem.matrix.stiffness import extremes, symmetric
from fem.parts.material import ImpossiblePart
from flexbearing.build import matrix_files
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
    found, nodes = in_order(matrix_files.stiffness(WAYS[ending](tmp_path / f"k.{ending}", UNKNOWNS, matrix)))
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
    found = matrix_files.stiffness(tmp_path / "k.bdf")
    assert_allclose(found.matrix.toarray(), [[2, -1], [-1, 3]], rtol=1e-14)
    assert found.motions.tolist() == [1, 2]


def test_nodes_of_both_kinds_of_mesh(tmp_path):
    places, numbers = np.array([[1.5, -2.25, 3e-3], [0.0, 1e3, -7.0]]), [4, 19]
    for path in (
        write.nodes_inp(tmp_path / "m.inp", places, numbers),
        write.grid_bdf(tmp_path / "m.bdf", places, numbers),
    ):
        found, where = matrix_files.places(path)
        assert found.tolist() == numbers
        assert_allclose(where, places, rtol=1e-9, atol=0)
    small = "".join(f"{word:>8}" for word in (19, "", "0.", "1000.0", "-7.0"))
    (tmp_path / "free.bdf").write_text(f"GRID,4,,1.5,-2.25,3.-3\nGRID    {small}\n")
    assert_allclose(matrix_files.places(tmp_path / "free.bdf")[1], places, rtol=1e-9, atol=0)


def test_condensed_matrix_answers_as_the_whole_one(matrix):
    """Forces at the kept nodes alone: S u_k = f_k."""
    S = whole(matrix.toarray()).at([3, 12])
    force = np.random.default_rng(2).normal(size=6)
    kept = [3, 4, 5, 6, 7, 8]
    load = np.zeros(9)
    load[kept] = force
    assert_allclose(np.linalg.solve(S, force), np.linalg.solve(matrix.toarray(), load)[kept], rtol=1e-6)


LONG = "1" * 5000
HEAD = "DMIG,K,0,6,2,0\n"
WRONG = {
    "another ending": ("k.txt", "1 1 2.0", "a matrix has the ending .sti"),
    "no numbers": ("k.mtx", "1 1 1 x 2.0\n", "'x' is no whole number"),
    "too few numbers": ("k.mtx", "1 1 1 2.0\n", "a row holds 4 numbers, not 5"),
    "complex numbers": ("k.mtx", "1 1 1 1 2.0 1.0\n", "a row holds 6 numbers, not 5"),
    "empty": ("k.mtx", "** nothing\n", "holds no rows of 5 numbers"),
    "not symmetric": ("k.mtx", "1 1 1 2 5.0\n1 2 1 1 4.0\n", "not symmetric"),
    "not finite": ("k.mtx", "1 1 1 1 nan\n", "'nan' is no number"),
    "too large": ("k.mtx", "1 1 1 1 1e308\n", r"1e308 is above 1e\+100"),
    "half a node": ("k.mtx", "1.5 1 1 1 1.0\n", "'1.5' is no whole number"),
    "a node beyond all": ("k.mtx", f"{2**62} 1 1 1 1.0\n", "is not between"),
    "other digits": ("k.mtx", "1 1 1 1 \N{FULLWIDTH DIGIT ONE}\n", "is no number"),
    "a long number": ("k.mtx", f"1 1 1 1 {LONG}\n", "longer than a number, 5000 characters"),
    "a long line": ("k.mtx", LONG * 20, "more than 65536 characters in line 1"),
    "a motion of its own": ("k.mtx", "1 7 1 7 1.0\n", "none of 1 to 6"),
    "complex": ("k.bdf", "DMIG,K,0,6,4,0\nDMIG,K,1,1,,1,1,2.0,1.0\n", "of real numbers"),
    "two matrices": ("k.bdf", "DMIG,K,0,6,2,0\nDMIG,M,0,6,2,0\n", "2 matrices, K, M"),
    "no matrix": ("k.bdf", "GRID,1,,0.,0.,0.\n", "holds no DMIG"),
    "no number": ("k.bdf", HEAD + "DMIG,K,1,1,,1,1,two\n", "'two' is no number"),
    "a long number in a card": ("k.bdf", HEAD + f"DMIG,K,1,1,,1,1,{LONG}\n", "longer than a number"),
    "no unknowns": ("k.sti", "1 1 2.0\n", "k.dof: there is no such file"),
}


def refusal(read, path):
    """One short line that names the file."""
    with pytest.raises(ImpossiblePart) as problem:
        read(path)
    message = str(problem.value)
    assert message.startswith(f"{path.name}: ")
    assert len(message) < 300
    assert "\n" not in message
    return message


@pytest.mark.parametrize(("name", "text", "complaint"), WRONG.values(), ids=WRONG)
def test_files_that_hold_no_stiffness_are_refused(name, text, complaint, tmp_path):
    (tmp_path / name).write_text(text)
    assert re.search(complaint, refusal(matrix_files.stiffness, tmp_path / name))


def test_only_the_first_names_of_many_matrices_are_listed(tmp_path):
    (tmp_path / "k.bdf").write_text("".join(f"DMIG,{n:0>90},0,6,2,0\n" for n in range(1000)))
    message = refusal(matrix_files.stiffness, tmp_path / "k.bdf")
    assert re.search(r"1000 matrices, .* and 992 more; allowed is one", message)


@pytest.mark.parametrize("row", ["0 1", "3 1"])
def test_rows_of_calculix_count_from_one(row, tmp_path):
    (tmp_path / "k.sti").write_text(f"1 2 2.0\n{row} 2.0\n")
    (tmp_path / "k.dof").write_text("1.1\n1.2\n")
    assert "does not name" in refusal(matrix_files.stiffness, tmp_path / "k.sti")


@pytest.mark.parametrize(
    ("unknowns", "complaint"),
    [
        ("1.1\n1.1\n", "twice"),
        ("1\n", "no node.motion"),
        ("1.7\n", "between 1 and 6"),
        ("1.1\n", "does not name"),
    ],
)
def test_unknowns_of_calculix_that_do_not_fit_are_refused(unknowns, complaint, tmp_path):
    (tmp_path / "k.sti").write_text("1 2 2.0\n")
    (tmp_path / "k.dof").write_text(unknowns)
    assert complaint in refusal(matrix_files.stiffness, tmp_path / "k.sti")


def whole(values):
    return symmetric(*UNKNOWNS.T, *np.indices((9, 9)).reshape(2, -1), values.ravel())


def test_seats_that_are_no_seats_are_refused(matrix):
    with pytest.raises(ImpossiblePart, match="node 5 on the seat has no unknown 1"):
        whole(matrix.toarray()).at([3, 5])
    loose = symmetric(np.array([1, 1, 1, 2]), np.array([1, 2, 3, 1]), np.arange(3), np.arange(3), np.ones(3))
    with pytest.raises(ImpossiblePart, match="can move without force"):
        loose.at([1])


@pytest.mark.parametrize("coupling", [False, True], ids=["by its diagonal", "by its coupling"])
def test_indefinite_stiffness_is_refused_with_its_eigenvalues(matrix, coupling):
    values = matrix.toarray()
    assert extremes(whole(values).at([7, 3])) == approx(
        tuple(np.linalg.eigvalsh(whole(values).at([7, 3]))[[0, -1]])
    )
    i = 5
    if coupling:
        values[i, i - 1] = values[i - 1, i] = 2 * np.sqrt(values[i, i] * values[i - 1, i - 1])
    else:
        values[i, i] *= -1
    expected = np.linalg.eigvalsh(whole(values).at([7, 3]))
    with pytest.raises(
        ImpossiblePart, match=f"from {expected[0]:.4g} to {expected[-1]:.4g}".replace("+", r"\+")
    ):
        extremes(whole(values).at([7, 3]))
    with pytest.raises(ImpossiblePart, match="away from the seat is indefinite: 1 of its 6 eigenvalues"):
        whole(values).at([12])


def test_rounding_of_a_file_makes_no_stiffness_indefinite():
    S = np.diag([1.0, 2.0, -1e-8])
    assert extremes(S) == approx((-1e-8, 2.0))


def test_a_translation_loads_the_held_nodes_alone():
    """A chain of springs between four nodes along x, the last one on a spring to ground."""
    K = np.diag([1.0, 2.0, 2.0, 1.5]) - np.eye(4, k=1) - np.eye(4, k=-1)
    chain = symmetric(np.arange(4), np.ones(4, int), *np.indices((4, 4)).reshape(2, -1), K.ravel())
    assert chain.held_nodes() == 1


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("*ELEMENT\n1,2\n", "holds no nodes"),
        ("*NODE\n1, a, 2\n", "'a' is no number"),
        ("*NODE\n1.5, 0, 2\n", "'1.5' is no whole number"),
        ("*NODE\n1, 1e308, 2\n", "is above"),
        ("*NODE, SYSTEM=C\n1, 0, 2\n", "rectangular"),
        ("*NODE\n1, 0, 2\n2, 0, 3\n1, 0, 2.5\n", "node 1 stands at two places"),
        ("GRID,1,5,0.,0.,0.\n", "basic system"),
        ("GRID,1,,0.,0.,0.,5\n", "basic system"),
        ("GRID,1.5,,0.,0.,0.\n", "'1.5' is no whole number"),
        (f"GRID,1,,0.,0.,{LONG}\n", "longer than a number"),
    ],
)
def test_meshes_whose_nodes_cannot_be_read_are_refused(text, complaint, tmp_path):
    (tmp_path / "m.inp").write_text(text)
    assert complaint in refusal(matrix_files.places, tmp_path / "m.inp")


def test_a_node_may_stand_twice_at_one_place(tmp_path):
    (tmp_path / "m.inp").write_text("*NODE\n2, 0, 1e0\n1, 0, 2\n*NODE\n1, 0.0, 2.\n")
    numbers, places = matrix_files.places(tmp_path / "m.inp")
    assert numbers.tolist() == [1, 2]
    assert places.tolist() == [[0, 2, 0], [0, 1, 0]]
