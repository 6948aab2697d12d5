"""The reference pages of the documents are those that the declarations give, and hold all of them."""

import re
from pathlib import Path

import pytest

from flexbearing.case.declarations import declarations
from flexbearing.families import FAMILIES
from flexbearing.outputs import outputs
from flexbearing.reference import pages
from flexbearing.reference.__main__ import write

FOLDER = Path(__file__).parents[2] / "docs" / "reference"
PAGES = pages()


def together(folder):
    return "".join(text for name, text in PAGES.items() if name.startswith(folder))


@pytest.mark.parametrize("name", PAGES)
def test_page_is_up_to_date(name):
    assert (FOLDER / name).read_text("utf-8") == PAGES[name], "run make docs"


def test_no_other_page_is_stored():
    stored = {*FOLDER.glob("case/*.md"), *FOLDER.glob("result/*.md")}
    assert stored == {FOLDER / name for name in PAGES if "/" in name}


def test_every_key_is_on_a_page():
    text = together("case")
    keys = [item.path for item in declarations(FAMILIES) if not item.section]
    assert [key for key in keys if f"|`{key.rpartition('.')[2]}`|" not in text] == []


@pytest.mark.parametrize("kind", FAMILIES)
def test_every_output_and_dataset_is_on_a_page(kind):
    layout, text = FAMILIES[kind].layout(), together("result")
    names = {*(entry.name for entry in layout.quantities), *(each.name for each in outputs(layout))}
    assert [
        name for name in names if f"`{name}`" not in text and f"`{name.partition('.')[0]}`" not in text
    ] == []


def test_every_form_is_on_a_page():
    attributes = [entry for family in FAMILIES.values() for entry in family.layout().attributes.values()]
    stored = [entry.name for entry in attributes if entry.kind in ("json", "records")]
    assert [name for name in stored if not re.search(rf"- `{name}`: `[{{\[]", PAGES["result/json.md"])] == []


def test_pages_that_are_no_longer_made_go(tmp_path):
    (tmp_path / "case").mkdir()
    (tmp_path / "case" / "former.md").write_text("")
    write(tmp_path)
    assert {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*.md")} == set(PAGES)
