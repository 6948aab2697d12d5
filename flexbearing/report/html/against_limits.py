"""What limits a bearing: numbers with their limits, the nearest to its limit first."""

from collections.abc import Iterator

from flexbearing.findings import USUAL
from flexbearing.report.html import combined, finding_checks, noted_checks, open_checks, shaft_tilt
from flexbearing.report.html.assumptions import WORTH
from flexbearing.report.html.check import NOT_CHECKED, Check
from flexbearing.report.html.document import Block, Cell, Items, Table
from flexbearing.report.html.reader import Reader, once
from flexbearing.report.html.units import printed

_NOTE = (
    "Share: value over limit, or limit over value where a value must not be lower. A contact pressure grows "
    "slower than its load: with the square root of the load of a roller, the cube root of that of a ball. "
    "The limits of ISO 76 are those of a lasting dent of 1e-4 of the diameter of a rolling element."
)


def blocks(reader: Reader) -> Iterator[Block]:
    """Every limit, those that are not kept first; then what was not checked, and who checks it."""
    checks = ranked(reader)
    head = ("checked", "value", "unit", "limit", "share of the limit [%]", "verdict")
    rows = tuple(
        (check.what, check.value, _unit(check.value), check.limit, check.share, check.verdict)
        for check in checks if not check.unchecked
    )  # fmt: skip
    yield Table("What limits most", head, rows, _NOTE, name="limits-most")
    rows = tuple(
        (check.what, check.value, _unit(check.value), _reason(check), check.who)
        for check in checks if check.unchecked
    )  # fmt: skip
    yield Table("Not checked here", ("item", "value", "unit", "why", "who checks it, with what"), rows,
                name="not-checked")  # fmt: skip


def _reason(check: Check) -> str:
    return check.verdict.removeprefix(f"{NOT_CHECKED}: ")


@once
def ranked(reader: Reader) -> tuple[Check, ...]:
    """Every check, the nearest to its limit first; what was not checked last, with the reason."""
    parts = (finding_checks, noted_checks, open_checks)
    return tuple(sorted((each for part in parts for each in part.checks(reader)), key=lambda each: each.rank))


def to_do(reader: Reader) -> Iterator[Items]:
    """What to do next."""
    if actions := steps(reader):
        yield Items("What to do next", actions, name="to-do")


def steps(reader: Reader) -> tuple[str, ...]:
    """Keep limits, find out what moves results most, keep usual aims, check what was not checked."""
    checks = ranked(reader)
    broken = [check.do for check in checks if check.broken and check.grade != USUAL]
    aims = [check.do for check in checks if check.broken and check.grade == USUAL]
    others = [check.do for check in checks if check.do not in (*broken, *aims)]
    moved: dict[str, list[str]] = {}
    for word in (combined.LIFE, *dict(reader.layout.weighed).values()):
        span = combined.of(reader, word)
        if span is not None and max(span.squares[1], 1 / span.squares[0]) > WORTH:
            moved.setdefault(span.most, []).append(word)
    if tilt := shaft_tilt.step(reader):
        moved.pop("operation.tilt", None)  # which that step requires
    measure = [
        f"find out and specify {combined.inputs(reader, key)}: moves {', '.join(words)} most"
        for key, words in moved.items()
    ]
    return tuple(dict.fromkeys(filter(None, (*broken, tilt, *aims, *measure, *others))))


def _unit(value: Cell) -> str:
    return "" if isinstance(value, str) else printed(value.unit)
