"""How much an assumed value matters: life or peak pressure of the same case with other values."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from flexbearing.case import BadCase
from flexbearing.catalogue.lines import Line, Settings, as_settings
from quasidynamic import NotSolved, OutOfRange

SMALLEST = 5e-3  # relative change that is told

NO_RESULT = (BadCase, NotSolved, OutOfRange)  # of a case that cannot be compared

Measured = Callable[[Settings], float]  # life or peak pressure of a case with settings; raises `NO_RESULT`


def weighed(lines: Sequence[Line], name: str, basis: float, measured: Measured) -> list[Line]:
    """Lines whose comments tell what other values do to the case.

    Parameters
    ----------
    lines : sequence of Line
        of a case
    name : str
        of what is compared, such as "life"
    basis : float
        its value in the case
    measured : callable
        its value in that case with settings; raises `NO_RESULT` where it has none

    Returns
    -------
    list of Line
        all of them
    """
    return [
        replace(line, why=f"{line.why}; {name} {_effects(line, basis, measured)}") if line.others else line
        for line in lines
    ]


def told(name: str, comparable: Settings) -> str:
    """What the comments mean; lives are compared with settings, where there are some."""
    by = f"; computed with {', '.join(as_settings(comparable))}" if comparable else ""
    of = f"modified {name}" if name == "life" else name
    return f'"{name} 1.2 times" tells the {of} with another value over that of this case{by}.'


def _effects(line: Line, basis: float, measured: Measured) -> str:
    """What other values do; those of the same effect are told together."""
    effects: dict[str, list[str]] = {}
    for other in line.others:
        try:
            factor = measured(other.settings) / basis
            effect = f"{factor:.3g} times" if abs(factor - 1) >= SMALLEST else "unchanged"
        except NO_RESULT:
            effect = "not known"
        effects.setdefault(effect, []).append(other.words)
    return ", ".join(f"{effect} with {' or '.join(words)}" for effect, words in effects.items())
