"""Documents name modules, commands and benchmarks that exist."""

import re
from pathlib import Path

import pytest
from pygments.lexers import get_lexer_by_name

from tests.places import ROOT

PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
PACKAGES = ("quasidynamic", "fem", "flexbearing")
FOLDERS = (*PACKAGES, "tests", "benchmarks", "evidence", "docs")
SOURCES = {path.relative_to(ROOT).as_posix() for name in FOLDERS for path in (ROOT / name).rglob("*.py")}


@pytest.mark.parametrize("folder", ["howto", "theory", "tutorials"])
def test_the_index_of_a_folder_lists_every_page(folder):
    index, *_ = (page for page in PAGES if page.parent.name == folder and page.stem == "index")
    listed = "\n".join(re.findall(r"```\{toctree\}(.*?)```", index.read_text(), re.DOTALL)).split()
    assert sorted(page.stem for page in index.parent.glob("*.md") if page != index) == sorted(
        name for name in listed if not name.startswith(":")
    )


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_modules_and_benchmarks_of_a_page_exist(page):
    text = page.read_text()
    files = re.findall(r"`((?:\w+/)*\w+\.py)`", text)
    benchmarks = [f"benchmarks/{name}.py" for name in re.findall(r"python -m benchmarks\.(\w+)", text)]
    missing = [
        name
        for name in files + benchmarks
        if not any(f"/{source}".endswith(f"/{name}") for source in SOURCES)
    ]
    assert not missing


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_dotted_names_of_a_page_can_be_found(page):
    for name in re.findall(rf"`((?:{'|'.join(PACKAGES)})(?:\.\w+)+)`", page.read_text()):
        parts = name.split(".")
        while parts and not any(
            (ROOT / path).exists() for path in (Path(*parts), Path(*parts).with_suffix(".py"))
        ):
            parts.pop()
        assert len(parts) > 1 or hasattr(__import__(name.split(".")[0]), name.split(".")[1]), name


def test_every_benchmark_is_named_in_a_document():
    text = "".join(page.read_text() for page in PAGES)
    runnable = [
        path.stem
        for path in (ROOT / "benchmarks").glob("*.py")
        if '__name__ == "__main__"' in path.read_text()
    ]
    assert [name for name in runnable if f"benchmarks.{name}" not in text] == []


def test_tests_stand_without_benchmarks():
    sources = {path.name: path.read_text() for path in (ROOT / "tests").rglob("*.py")}
    assert [
        name for name, text in sources.items() if re.search(r"^(from|import) benchmarks", text, re.M)
    ] == []


@pytest.mark.parametrize(
    "page", [page for page in PAGES if "{code-cell}" in page.read_text()], ids=lambda page: page.name
)
def test_cells_of_a_page_can_be_highlighted(page):
    """The site is built with warnings as errors, and a cell that its lexer refuses is one."""
    lexer = get_lexer_by_name("ipython3")
    lexer.add_filter("raiseonerror")
    for cell in re.findall(r"^```\{code-cell\}[^\n]*\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE):
        code = "".join(line for line in cell.splitlines(keepends=True) if not line.startswith(":"))
        assert list(lexer.get_tokens(code))
