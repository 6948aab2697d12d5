"""Findings: limits of a bearing, declared once, and numbers judged by them."""

from flexbearing.findings.declared import of_code
from flexbearing.findings.finding import (
    DANGER,
    GRADES,
    MET,
    NOT_CHECKED,
    NOT_MET,
    OUTSIDE,
    USUAL,
    Finding,
    Judged,
    Record,
    by_code,
    evaluate,
    gravest,
    records,
    stored,
)
from flexbearing.findings.row import RowFinding
from flexbearing.findings.words import text

__all__ = [
    "DANGER",
    "GRADES",
    "MET",
    "NOT_CHECKED",
    "NOT_MET",
    "OUTSIDE",
    "USUAL",
    "Finding",
    "Judged",
    "Record",
    "RowFinding",
    "by_code",
    "evaluate",
    "gravest",
    "of_code",
    "records",
    "stored",
    "text",
]
