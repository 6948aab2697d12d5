"""Pages of evidence and their index, as Markdown."""

from collections import Counter
from collections.abc import Mapping, Sequence

from evidence.case import Case, Findings, Number
from evidence.verdict import differs, verdict


def _shown(value: float, digits: int = 6) -> str:
    return f"{value:.{digits}g}".replace("e-0", "e-").replace("e+0", "e")


def _percent(share: float) -> str:
    size = abs(share)
    if size < 5e-8:
        return "< 0.00001"
    return f"{100 * share:+.2g}" if size < 0.1 else f"{100 * share:+.0f}"


def _row(number: Number) -> str:
    ours = _shown(number.ours, 6 if number.known else 1)
    allowed = "±" + _shown(number.allowed, 2) if number.allowed else "exact"
    mark = "yes" if number.within else f"{_percent(number.misfit)} %"
    cells = (
        number.name,
        number.unit or "-",
        _shown(number.known),
        ours,
        _percent(number.misfit),
        allowed,
        mark,
    )
    return "| " + " | ".join(cells) + " |"


def _beside(findings: Findings) -> list[str]:
    lines = []
    if findings.numbers:
        lines += [
            "| quantity | unit | known | ours | misfit [%] | allowed | within it |",
            "|---|---|---|---|---|---|---|",
            *(_row(number) for number in findings.numbers),
            "",
        ]
    if findings.trends:
        lines += ["| the source says | ours | unit | holds |", "|---|---|---|---|"]
        for trend in findings.trends:
            values = (f"{place}: {_shown(v, 4)}" for place, v in zip(trend.places, trend.ours, strict=True))
            holds = "yes" if trend.holds else "**no**"
            lines.append(f"| {trend.statement} | {'; '.join(values)} | {trend.unit or '-'} | {holds} |")
        lines.append("")
    return lines


def _deciding(findings: Findings) -> Number | None:
    """The largest misfit of the numbers that miss what is allowed for them; where none does, of all."""
    missed = [number for number in findings.numbers if not number.within]
    judged = missed or [number for number in findings.numbers if number.known]
    return max(judged, key=lambda number: abs(number.misfit), default=None)


def _allowance(number: Number) -> str:
    """What is allowed for a number, in percent of the scale of its misfit."""
    if not number.allowed:
        return "exact"
    return _percent(number.allowed / (number.scale or abs(number.known))).lstrip("+")


def _misfit(findings: Findings) -> str:
    """The misfit that the verdict follows from, beside what is allowed for it, in words."""
    most = _deciding(findings)
    if most is None:
        return ""
    allowed = f"allowed are {_allowance(most)} %" if most.allowed else "equality is required"
    kind = "Largest misfit" if most.within else "Largest misfit that is not allowed"
    return f" {kind}: {_percent(most.misfit)} % ({most.name}; {allowed})."


def page(case: Case, findings: Findings) -> str:
    """The page of a case."""
    files = ", ".join(f"`{file}`" for file in case.case_files)
    lines = [
        f"<!-- written by python -m evidence {case.name}; do not edit -->",
        f"# {case.title}",
        "",
        f"**Verdict: {verdict(case, findings)}.**{_misfit(findings)}",
        "",
        "## What is known",
        "",
        case.known,
        "",
        f"Source: {case.source} Printed numbers: `{case.numbers_from}`.",
        "",
        "## What was run",
        "",
        case.run,
        "",
        f"Computed by `{case.module}`: `python -m evidence {case.name}`."
        + (f" Case files: {files}." if files else ""),
        "",
        "## Side by side",
        "",
        *_beside(findings),
        f"The check fails when a number of ours moves by more than {100 * case.moves:g} %.",
        "",
        "## Error estimate",
        "",
        case.error,
        "",
    ]
    if findings.errors:
        lines += ["| estimate | value | unit |", "|---|---|---|"]
        lines += [f"| {e.name} | {_shown(e.value, 2)} | {e.unit or '-'} |" for e in findings.errors] + [""]
    if case.reason:
        lines += ["## Why it differs", "", case.reason, ""]
    elif differs(verdict(case, findings)):
        lines += ["## Why it differs", "", "The reason is not known.", ""]
    if case.remarks:
        lines += ["## Remarks", "", case.remarks, ""]
    if case.draw:
        lines += [f"![{case.title}](figures/{case.name}.png)", "", case.caption, ""]
    return "\n".join(lines).rstrip() + "\n"


HEAD = """<!-- written by python -m evidence; do not edit -->
# Evidence

One page for each case: what is known and from where, what was run, both side by side, the misfit, an
estimate of our own error, and a verdict. `python -m evidence` computes all of it,
`python -m evidence --check` computes it again and fails when a number moved by more than its
page allows. Nothing is tuned to a source.

| verdict | meaning |
|---|---|
| agrees | every number is within what is allowed for it; every statement holds |
| agrees within x % | some misfits are not allowed, none is above x % (0.1, 0.2, 0.5, 1, 2 or 5) |
| differs, reason known | one above 5 %, or a statement that does not hold; the page gives the reason |
| differs, reason not known | the same, and the reason is not known |

Every number has an allowed misfit: the printed digits of the source, the scatter of the programs, fits or
measurements behind it, or for closed forms the error of our own grid, and no more than the tests of the
same number allow. **Judge a misfit by the allowance beside it**: some percent agree with an empirical
formula that scatters by more; a tenth of a percent does not agree with a table that is printed more
exactly. The last two columns below show one number of each case, the one that its verdict follows from: the
number with the largest misfit among those outside their allowance, or, where all are within, the one with the
largest misfit of all. A misfit is a share of the known number, or where the page says so of the largest one.
`-` marks cases of statements alone. A verdict is computed by `evidence/verdict.py`, by
one rule for all pages; the reason of a difference is written by its author.

**"Agrees" does not mean "measured".** Most cases compare with formulas of standards, closed forms or other
programs. The only measured numbers are friction torques of slow ball bearings, which are not met. Skidding is
compared with the direction of trends that publications report, known from abstracts or from memory, without
numbers; one of them is not met. Nothing measured is here of a bearing with flexible rings.
"""

HEADING = "| case | verdict | misfit behind the verdict [%] | allowed for it [%] |"

TOCTREE = """```{toctree}
:hidden:
:glob:

*
```
"""


def index(cases: Sequence[Case], findings: Mapping[str, Findings]) -> str:
    """All cases with their verdicts."""
    verdicts = {case.name: verdict(case, findings[case.name]) for case in cases}
    kinds = Counter("agrees within 5 %" if v.startswith("agrees w") else v for v in verdicts.values())
    count = ", ".join(f"{number} {kind}" for kind, number in sorted(kinds.items()))
    values = sum(len(found.numbers) + len(found.trends) for found in findings.values())
    lines = [HEAD, f"{len(cases)} cases with {values} known numbers and statements: {count}.", ""]
    for subject in dict.fromkeys(case.subject for case in cases):
        lines += [f"## {subject}", "", HEADING, "|---|---|---|---|"]
        for case in (case for case in cases if case.subject == subject):
            most = _deciding(findings[case.name])
            misfit = f"{_percent(abs(most.misfit)).lstrip('+')} | {_allowance(most)}" if most else "- | -"
            bold = "**" if differs(verdicts[case.name]) else ""
            lines.append(f"| [{case.title}]({case.name}.md) | {bold}{verdicts[case.name]}{bold} | {misfit} |")
        lines.append("")
    return "\n".join([*lines, TOCTREE])
