"""What tests of cases share."""

from importlib import import_module

import pytest

_DRAWN = {}  # of the session


@pytest.fixture(scope="module")
def each_case_drawn_once():
    """Reports of one case share its drawings: placing their labels takes most of a report's time."""
    page = import_module("flexbearing.report.html.result")
    draw = page.drawn

    def drawn(family, case, names):
        key = family.kind, case.model_dump_json(exclude={"title", "report", "outputs"}), names.__qualname__
        if key not in _DRAWN:
            _DRAWN[key] = list(draw(family, case, names=names))
        return _DRAWN[key]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(page, "drawn", drawn)
        yield


@pytest.fixture
def command(capsys):
    """The program, called with words: its exit code, output and messages."""
    program = import_module("flexbearing.__main__")
    return lambda *words: (program.command([str(word) for word in words]), *capsys.readouterr())
