"""Bytes that a file of each format may have: more than any real one, and not more than memory."""

from flexbearing.inputs.file import size

CASE = 2**16  # one with every key and a note to each has some 15 kB; tomllib takes up to 0.05 s
POINTS = 2**20
DRAWING = 2**26  # rings with their seats take up to some millions
REXS = 2**25
ARCHIVE = 2**22  # some 100 000 members, whose list alone takes 50 MB
VARIANTS = 2**26  # a million rows of five numbers
TABLE = 2**28  # a million rows of some twenty numbers
MATRIX = 2**29  # some ten million entries
RESULT = 2**32

FORMATS = {
    "a case, a study, an optimisation or a profile of jobs (TOML)": CASE,
    "the points of a profile (CSV)": POINTS,
    "a model of a gearbox (REXS)": REXS,
    "the same as an archive (ZIP)": ARCHIVE,
    "a STEP drawing": DRAWING,
    "variants or a duty cycle of a study (CSV)": VARIANTS,
    "the table of a study (CSV or Parquet)": TABLE,
    "a stiffness matrix or its mesh": MATRIX,
    "a result (HDF5)": RESULT,
}


def sizes() -> str:
    """Limits of all formats as a sentence of documents."""
    return "; ".join(f"{name} {size(most)}" for name, most in FORMATS.items())
