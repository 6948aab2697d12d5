"""Figures of README and site are what commands print.

Blocks of commands with their output (```console) are run and compared, line by line. Cells of pages are
executed when the site is built. For all other tables of figures, the section names its command.
"""

import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from tests.site.documents import ROOT, Command, consoles, pages, sections

FEW = 3  # numbers in a table that need no command: an example, not a measurement
RUN_HERE = {"flexbearing": "flexbearing", "python -m benchmarks": "benchmarks"}
BLOCKS = [
    pytest.param(block, id=f"{path.relative_to(ROOT)}-{number}")
    for path in pages()
    for number, block in enumerate(consoles(path))
    if all(command.line.startswith(tuple(RUN_HERE)) for command in block)
]


def missing_lines(shown: tuple[str, ...], printed: str) -> list[str]:
    """Lines of a page that the output does not have in this order; `...` stands for any number of lines."""
    rest = iter([line.rstrip() for line in printed.splitlines()])
    return [line for line in map(str.rstrip, shown) if line != "..." and line and line not in rest]


def run(command: Command, folder: Path) -> subprocess.CompletedProcess[str]:
    program, *arguments = shlex.split(command.line)
    if program == "python":
        line = [sys.executable, *arguments]
    else:
        line = [sys.executable, "-m", program, *arguments]
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "COLUMNS": "80", "NO_COLOR": "1"}
    return subprocess.run(line, cwd=folder, env=environment, capture_output=True, text=True, timeout=300)


@pytest.mark.docs
@pytest.mark.parametrize("block", BLOCKS)
def test_commands_print_what_the_page_shows(block, tmp_path):
    (tmp_path / "configs").symlink_to(ROOT / "configs")
    for command in block:
        done = run(command, tmp_path)
        assert done.returncode == 0, done.stderr
        assert missing_lines(command.shown, done.stdout) == [], done.stdout


@pytest.mark.docs
def test_the_first_screen_of_the_readme_is_run():
    assert any("README" in param.id for param in BLOCKS)


@pytest.mark.parametrize("path", pages(), ids=lambda path: path.relative_to(ROOT).as_posix())
def test_a_section_with_a_table_of_figures_names_its_command(path):
    """In the section itself, or in the one that it is part of."""
    unnamed = [section.title for section in sections(path) if section.figures > FEW and not section.commanded]
    assert unnamed == []


def test_changed_figures_are_seen():
    """The comparison itself: a changed digit, a changed order and a missing line are all told."""
    printed = "head\n a  1.5\n b  2.5\n"
    assert missing_lines(("...", " a  1.5", " b  2.5"), printed) == []
    assert missing_lines((" a  1.6",), printed) == [" a  1.6"]
    assert missing_lines((" b  2.5", " a  1.5"), printed) == [" a  1.5"]
