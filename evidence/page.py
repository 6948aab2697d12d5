"""Pages of evidence and their index, as Markdown."""

from collections import Counter
from collections.abc import Mapping, Sequence

from evidence.case import Case, Findings, Number
from evidence.markdown import cells, shown
from evidence.verdict import differs, verdict

MOST_ROWS = 5  # of a page: the numbers that take most of what is allowed


def _percent(share: float) -> str:
    size = abs(share)
    if size < 5e-8:
        return "< 0.00001"
    return f"{100 * share:+.2g}" if size < 0.1 else f"{100 * share:+.0f}"


def _row(number: Number) -> str:
    ours = shown(number.ours, 6 if number.known else 1)
    allowed = "±" + shown(number.allowed, 2) if number.allowed else "exact"
    misfit = _percent(number.misfit) if number.within else f"**{_percent(number.misfit)}**"
    return cells(number.name, number.unit, shown(number.known), ours, misfit, allowed)


def _exhaustion(number: Number) -> float:
    """How much of what is allowed a misfit takes."""
    off = abs(number.ours - number.known)
    return off / number.allowed if number.allowed else float("inf") if off else 0.0


def _beside(case: Case, findings: Findings) -> list[str]:
    lines = []
    most = sorted(findings.numbers, key=_exhaustion, reverse=True)[:MOST_ROWS]
    if most:
        lines += ["|quantity|unit|known|ours|misfit [%]|allowed|", "|---|---|---|---|---|---|"]
        lines += [*(_row(number) for number in findings.numbers if number in most), ""]
    if rest := len(findings.numbers) - len(most):
        lines += [f"{rest} more take less of what is allowed: `docs/evidence/numbers/{case.name}.json`.", ""]
    if findings.trends:
        lines += ["|the source says|ours|unit|holds|", "|---|---|---|---|"]
        for trend in findings.trends:
            values = (f"{place}: {shown(v, 4)}" for place, v in zip(trend.places, trend.ours, strict=True))
            holds = "yes" if trend.holds else "**no**"
            lines.append(cells(trend.statement, "; ".join(values), trend.unit, holds))
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
    allowed = f"allowed {_allowance(most)} %" if most.allowed else "equality is required"
    return f" Largest misfit: {_percent(most.misfit)} % ({most.name}; {allowed})."


def page(case: Case, findings: Findings) -> str:
    """The page of a case."""
    files = ", ".join(f"`{file}`" for file in case.case_files)
    lines = [
        f"# {case.title}",
        "",
        f"**Verdict: {verdict(case, findings)}** (`python -m evidence {case.name}`).{_misfit(findings)}",
        "",
        f"**Known:** {case.known} Source: {case.source} Printed numbers: `{case.numbers_from}`.",
        "",
        f"**Run:** {case.run}" + (f" Case files: {files}." if files else ""),
        "",
        *([f"**Chosen by us, so no test of the source:** {case.chosen}", ""] if case.chosen else []),
        *_beside(case, findings),
        f"**Our error:** {case.error}",
        "",
    ]
    if findings.errors:
        lines += ["|estimate|value|unit|", "|---|---|---|"]
        lines += [cells(e.name, shown(e.value, 2), e.unit) for e in findings.errors] + [""]
    if case.reason:
        lines += ["## Why it differs", "", case.reason, ""]
    elif differs(verdict(case, findings)):
        lines += ["## Why it differs", "", "The reason is not known.", ""]
    if case.remarks:
        lines += [case.remarks, ""]
    if case.draw:
        lines += [f"![{case.title}](figures/{case.name}.png)", "", case.caption, ""]
    return "\n".join(lines).rstrip() + "\n"


HEAD = """<!-- written by python -m evidence; do not edit -->
# Evidence

Each case has a page: what is known, from where, what was run, the misfit and our own error.
`python -m evidence` computes all, `--check` fails when a number moved; of predictions it computes every
fourth row. Nothing is tuned to a source.

|verdict|meaning|
|---|---|
|agrees|every number is within what is allowed for it; every statement holds|
|agrees within x %|some misfits (bold on the page) are not allowed, none is above x %|
|differs, reason known|one above 5 %, or a statement that does not hold; the page gives the reason|
|differs, reason not known|the same without a reason|
|not testable|bearing, load or oil are chosen by us: agreement would say nothing|

Allowed are the printed digits of the source, the scatter of its formulas, programs or measurements, or the
error of our own grid. The tables show the number that decides the verdict: the largest misfit outside its
allowance, or of all where all are within.

**"Agrees" does not mean "measured".** [How far to trust each number](trust.md) has the largest misfit of
every output and its kind. Friction torques of slow ball bearings were measured and are not met. No table of
measured loads, strains or stiffnesses of a bearing with flexible rings could be had.
"""

HEADING = "|case|verdict|misfit [%]|allowed [%]|"

TOCTREE = """```{toctree}
:hidden:
:glob:

*
```
"""


def index(cases: Sequence[Case], findings: Mapping[str, Findings], measurements: str) -> str:
    """All cases with their verdicts, measurements first."""
    verdicts = {case.name: verdict(case, findings[case.name]) for case in cases}
    kinds = Counter("agrees within 5 %" if v.startswith("agrees w") else v for v in verdicts.values())
    count = ", ".join(f"{number} {kind}" for kind, number in sorted(kinds.items()))
    values = sum(len(found.numbers) + len(found.trends) for found in findings.values())
    lines = [
        HEAD,
        measurements,
        f"{len(cases)} cases with {values} known numbers and statements: {count}.",
        "",
    ]
    for subject in dict.fromkeys(case.subject for case in cases):
        lines += [f"## {subject}", "", HEADING, "|---|---|---|---|"]
        for case in (case for case in cases if case.subject == subject):
            most = _deciding(findings[case.name])
            misfit = f"{_percent(abs(most.misfit)).lstrip('+')}|{_allowance(most)}" if most else "|"
            bold = "**" if differs(verdicts[case.name]) else ""
            lines.append(f"|[{case.title}]({case.name}.md)|{bold}{verdicts[case.name]}{bold}|{misfit}|")
        lines.append("")
    return "\n".join([*lines, TOCTREE])
