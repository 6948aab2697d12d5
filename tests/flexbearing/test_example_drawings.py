"""The drawings of the documents are those that the program draws of the shipped cases."""

import re

import numpy as np
import pytest

from flexbearing.case import BadCase
from flexbearing.example_drawings import EXAMPLES, drawn, main
from tests.places import ROOT

FOLDER = ROOT / "docs" / "images" / "drawings"
QUICK = {  # one of each sheet and part; the others are drawn by the same code
    "roller-bearing", "cage", "roller-profile", "squirrel-cage-bars", "ring-on-shaft", "housing",
    "deep-groove",
}  # fmt: skip
NUMBER = re.compile(r"-?\d+\.\d+")
DRAWN = [
    pytest.param(example, id=example.name, marks=() if example.name in QUICK else pytest.mark.slow)
    for example in EXAMPLES
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("example", DRAWN)
def test_a_drawing_is_up_to_date(example):
    """Where not: `python -m flexbearing.example_drawings configs docs/images/drawings`."""
    stored, now = (FOLDER / f"{example.name}.svg").read_text("utf-8"), drawn(example, ROOT / "configs")
    assert NUMBER.sub("0", stored) == NUMBER.sub("0", now)
    numbers = [np.array(NUMBER.findall(text), float) for text in (stored, now)]
    np.testing.assert_allclose(*numbers, rtol=0, atol=0.01)  # of a point; processors round differently


def test_no_other_drawing_is_stored():
    assert {file.stem for file in FOLDER.iterdir()} == {example.name for example in EXAMPLES}


def test_every_drawing_is_on_a_page():
    text = "".join(file.read_text("utf-8") for file in (ROOT / "docs").rglob("*.md"))
    assert [example.name for example in EXAMPLES if f"images/drawings/{example.name}.svg)" not in text] == []


@pytest.mark.slow
def test_what_is_no_example_goes(tmp_path, monkeypatch):
    monkeypatch.setattr("flexbearing.example_drawings.EXAMPLES", EXAMPLES[2:3])
    (tmp_path / "former.svg").write_text("<svg/>")
    (tmp_path / "other.png").write_bytes(b"")
    main(ROOT / "configs", tmp_path)
    assert sorted(file.name for file in tmp_path.iterdir()) == ["other.png", f"{EXAMPLES[2].name}.svg"]


def test_a_case_that_is_not_there_is_told(tmp_path):
    with pytest.raises(BadCase):
        drawn(EXAMPLES[0], tmp_path)
