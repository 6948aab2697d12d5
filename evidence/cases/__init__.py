"""All cases of evidence, by name."""

from evidence.case import Case
from evidence.cases import load_sharing

CASES: dict[str, Case] = {case.name: case for case in (*load_sharing.CASES,)}
