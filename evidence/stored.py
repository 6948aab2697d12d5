"""Numbers of a page as a file, and how far new ones are from them."""

import json
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path

from evidence.case import Case, Estimate, Findings, Number, Trend
from evidence.verdict import verdict

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs" / "evidence"


def file_of(case: Case) -> Path:
    """Where the numbers of a page are kept."""
    return DOCS / "numbers" / f"{case.name}.json"


def write(case: Case, findings: Findings) -> None:
    """Keep the numbers of a page."""
    path = file_of(case)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(asdict(findings), indent=1, ensure_ascii=False) + "\n")


def read(case: Case) -> Findings:
    """The numbers of a page as they were kept."""
    kept = json.loads(file_of(case).read_text())
    return Findings(
        numbers=tuple(Number(**number) for number in kept["numbers"]),
        trends=tuple(
            Trend(**trend | {"places": tuple(trend["places"]), "ours": tuple(trend["ours"])})
            for trend in kept["trends"]
        ),
        errors=tuple(Estimate(**error) for error in kept["errors"]),
    )


def _names(findings: Findings) -> list[str]:
    """Everything that a page has a number for."""
    trends = [f"{trend.statement}, {place}" for trend in findings.trends for place in trend.places]
    return [*(n.name for n in findings.numbers), *trends, *(error.name for error in findings.errors)]


def _changes(case: Case, kept: Findings, new: Findings) -> Iterator[tuple[str, float, float, float]]:
    """Name, number that was kept, new one, and how far they may be apart."""
    for old, number in zip(kept.numbers, new.numbers, strict=True):
        at_zero = old.allowed if old.known == 0.0 else 0.0
        yield old.name, old.ours, number.ours, max(case.moves * abs(old.ours), at_zero)
        yield f"{old.name}, known", old.known, number.known, case.moves * abs(old.known)
    for old, trend in zip(kept.trends, new.trends, strict=True):
        size = max(map(abs, old.ours))
        for place, one, other in zip(old.places, old.ours, trend.ours, strict=True):
            yield f"{old.statement}, {place}", one, other, case.moves * size
    for old, error in zip(kept.errors, new.errors, strict=True):
        yield old.name, old.value, error.value, 0.5 * abs(old.value) + 1e-12


def moved(case: Case, kept: Findings, new: Findings) -> list[str]:
    """One line for every number that moved by more than the page allows; errors may change by half."""
    if _names(kept) != _names(new):
        return [f"{case.name}: the page has other quantities: run python -m evidence {case.name}"]
    lines = [
        f"{case.name}: {name} was {old:.9g}, is {now:.9g}, may move by {may:.2g}"
        for name, old, now, may in _changes(case, kept, new)
        if not abs(now - old) <= may
    ]
    before, after = verdict(case, kept), verdict(case, new)
    return lines + ([f"{case.name}: verdict was {before!r}, is {after!r}"] if before != after else [])
