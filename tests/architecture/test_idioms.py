"""Documents and code use the terms of the field; `make lint` runs this file."""

import re
from pathlib import Path

import pytest

from tests.architecture.test_documents import PACKAGES, PAGES, ROOT

# Idioms of this project that an engineer reads twice; the field has a word for each.
IDIOMS = re.compile(
    r"""\b(?:
    told | tells | is\ asked\ for | (?:stand|stands|stood)\ still | hopeless | without\ hope
    | known\ rings | rings\ that\ yield | (?:ring|rings|raceway|raceways)\ yields?
    | alternations? | no\ number\ to\ rely\ on | knows?\ nothing\ of | of\ one's\ own
    | walk\ through\ the\ house | falls?\ off | strangers? | ending\ of\ its\ own
    | loaded\ program | have\ no\ end | by\ lot | at\ hand | asks?\ for | asked\ for | feels? | leans?
    | freed\ of | neither\ of\ both | an\ information | nearer | in\ turn | whatever | machinery | mended
    | (?:without\ an|has\ no|has\ an|have\ no|have\ an)\ answer | do(?:es)?\ not\ know\ of
    | stands?\ (?:beside|in|above|below|here|by|on|as) | (?:section|ring|raceway)s?\ cones? | this\ very
    | takes?\ back | acts?\ back | fed\ back | beside\ (?:the\ (?:file|case|study)|ours|a\ rigid)
    )\b""",
    re.VERBOSE,
)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_pages_use_the_terms_of_the_field(page):
    if "decisions" not in page.parts:
        assert _idioms(page) == []


@pytest.mark.parametrize("package", PACKAGES)
def test_code_uses_the_terms_of_the_field(package):
    assert [found for file in sorted((ROOT / package).rglob("*.py")) for found in _idioms(file)] == []


def _idioms(file: Path) -> list[str]:
    lines = enumerate(file.read_text().splitlines(), start=1)
    return [f"{file.name}:{number}: {line}" for number, line in lines if IDIOMS.search(line)]
