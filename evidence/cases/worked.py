"""Pages of worked examples: catalogues and annexes of standards."""

from collections.abc import Iterable, Sequence
from functools import partial

from evidence.case import Case, Findings, number
from tests.literature import (
    test_iso76,
    test_iso281,
    test_nsk_catalogue,
    test_ntn_catalogue,
    test_skf_2018,
    test_skf_catalogue,
)
from tests.literature.worked_example import WorkedExample

EXACT = "Formulas of the standard; rounding only. What the source is good to are its digits and its rounded factors."


def findings(examples: Iterable[WorkedExample]) -> Findings:
    """Printed numbers of worked examples beside ours."""
    return Findings(
        numbers=tuple(number(e.name, e.printed, e.ours(), e.unit, share=e.share) for e in examples)
    )


def annex_281() -> Findings:
    """Examples of annex C."""
    return findings(test_iso281.EXAMPLES)


def annex_76() -> Findings:
    """Examples of annex A."""
    return findings(test_iso76.EXAMPLES)


def nsk() -> Findings:
    """Examples of NSK."""
    return findings(test_nsk_catalogue.EXAMPLES)


def ntn() -> Findings:
    """Examples of NTN."""
    return findings(test_ntn_catalogue.EXAMPLES)


def skf_6000() -> Findings:
    """Examples of SKF's older catalogue."""
    return findings(test_skf_catalogue.EXAMPLES)


def skf_2018() -> Findings:
    """Examples of SKF's catalogue of 2018."""
    return findings(test_skf_2018.EXAMPLES)


worked = partial(Case, error=EXACT, known="Worked examples with their intermediate results.")
STANDARDS: Sequence[Case] = (
    worked(
        name="iso281-annex-c",
        title="Worked examples of ISO 281, annex C",
        subject="Ratings and lives of the standards",
        source="ISO 281 (2007), annex C, read in GOST 18855-2013, annex V.",
        run="Ratings of the two angular-contact bearings of the annex.",
        numbers_from="tests/literature/test_iso281.py",
        compute=annex_281,
    ),
    worked(
        name="iso76-annex-a",
        title="Worked examples of ISO 76, annex A",
        subject="Ratings and lives of the standards",
        source="ISO 76 (2006), annex A, read in GOST 18854-2013.",
        run="Static ratings and equivalent loads of the bearings of the annex.",
        numbers_from="tests/literature/test_iso76.py",
        compute=annex_76,
    ),
)
CATALOGUES: Sequence[Case] = (
    worked(
        name="nsk-catalogue",
        title="NSK: ball bearing 6208",
        subject="Catalogues",
        source="NSK, Rolling Bearings, section 5.7, examples 1 and 3.",
        run="Equivalent load and rating life of ISO 281 with the ratings of the catalogue.",
        numbers_from="tests/literature/test_nsk_catalogue.py",
        compute=nsk,
    ),
    worked(
        name="ntn-catalogue",
        title="NTN: 6208, NUP312 and rollers together",
        subject="Catalogues",
        source="NTN, Ball and Roller Bearings, CAT. No. 2203/E, section 4.5, examples 1 to 4 and 6; lives are read from scales there.",
        run="Equivalent load, rating life and Weibull sum with the ratings of the catalogue.",
        numbers_from="tests/literature/test_ntn_catalogue.py",
        compute=ntn,
    ),
    worked(
        name="skf-catalogue-6000",
        title="SKF General Catalogue: 6309, 24026",
        subject="Catalogues",
        source="SKF, General Catalogue 6000, Selection of bearing size, examples 1 a and 5.",
        run="Rating life and static safety with the ratings of the catalogue.",
        numbers_from="tests/literature/test_skf_catalogue.py",
        compute=skf_6000,
        remarks="The viscosity ratio of the example is read from a diagram of SKF (8.15 mm²/s where ISO 281 has 9.65), and a_SKF is SKF's "
        "own: neither is compared.",
    ),
    worked(
        name="skf-catalogue-2018",
        title="SKF catalogue of 2018: rope sheave and pump",
        subject="Catalogues",
        source="SKF, Rolling bearings (2018), chapter C: examples of a rope sheave and a centrifugal pump.",
        run="Rating lives with the ratings of the catalogue; viscosity of ISO VG 68.",
        numbers_from="tests/literature/test_skf_2018.py",
        compute=skf_2018,
        remarks="Viscosities are read from a diagram to two digits there (8 %). a_SKF is SKF's own and not compared.",
    ),
)
