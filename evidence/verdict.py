"""What numbers beside each other amount to: one rule for all pages."""

from evidence.case import Case, Findings

STEPS = (0.001, 0.002, 0.005, 0.01, 0.02, 0.05)  # misfits beyond the last one are called a difference
NOT_TESTABLE, AGREES, WITHIN, KNOWN, UNKNOWN = (
    "not testable",
    "agrees",
    "agrees within {:g} %",
    "differs, reason known",
    "differs, reason not known",
)


def worst(findings: Findings) -> float:
    """Largest misfit of the numbers that miss what is allowed [-]."""
    return max((abs(number.misfit) for number in findings.numbers if not number.within), default=0.0)


def verdict(case: Case, findings: Findings) -> str:
    """Agreement within what is allowed or a step, a difference with or without a known reason, or no test."""
    if case.chosen:
        return NOT_TESTABLE
    largest = worst(findings)
    if all(trend.holds for trend in findings.trends) and largest <= STEPS[-1]:
        if largest == 0.0:
            return AGREES
        return WITHIN.format(100 * next(step for step in STEPS if largest <= step))
    return KNOWN if case.reason else UNKNOWN


def differs(found: str) -> bool:
    """Whether a verdict is a difference."""
    return found in (KNOWN, UNKNOWN)
