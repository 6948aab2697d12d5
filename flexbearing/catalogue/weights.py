"""How much an assumed value matters: outputs of the same case with other values."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

from flexbearing.case import BadCase
from flexbearing.catalogue.lines import Line, Settings, as_settings
from quasidynamic import NotSolved, OutOfRange

SMALLEST = 5e-3  # relative change that is told of the first output
FURTHER = 1e-2  # and of all others

NO_RESULT = (BadCase, NotSolved, OutOfRange)  # of a case that cannot be compared

Measured = Callable[[Settings], Mapping[str, float]]  # outputs of a case with settings; raises `NO_RESULT`


def weighed(lines: Sequence[Line], basis: Mapping[str, float], measured: Measured) -> list[Line]:
    """Lines whose comments tell what other values do to the case.

    Parameters
    ----------
    lines : sequence of Line
        of a case
    basis : mapping
        outputs of the case by their words, such as "life", that which is always told first
    measured : callable
        the same of that case with settings; raises `NO_RESULT` where it has none

    Returns
    -------
    list of Line
        all of them
    """
    return [
        replace(line, why="; ".join([line.why, *_effects(line, basis, measured)])) if line.others else line
        for line in lines
    ]


def told(basis: Mapping[str, float], comparable: Settings) -> str:
    """What the comments mean; outputs are compared with settings, where there are some."""
    by = f"; computed with {', '.join(as_settings(comparable))}" if comparable else ""
    name, *others = basis
    of = f"modified {name}" if name == "life" else name
    first = f'"{name} 1.2 times" is the {of} with another value over that of this case{by}.'
    return f"{first}\nListed from {100 * FURTHER:g} % of change on: {', '.join(others)}." if others else first


def _effects(line: Line, basis: Mapping[str, float], measured: Measured) -> Iterator[str]:
    """What other values do to each output."""
    found: dict[str, Mapping[str, float]] = {}
    for other in line.others:
        try:
            found[other.words] = measured(other.settings)
        except NO_RESULT:
            found[other.words] = {}
    first, *others = basis
    yield f"{first} {_changes(first, basis[first], found)}"
    for name in others:
        moved = {
            words: values for words, values in found.items()
            if name in values and abs(values[name] / basis[name] - 1) >= FURTHER
        }  # fmt: skip
        if moved:
            yield f"{name} {_changes(name, basis[name], moved)}"


def _changes(name: str, basis: float, found: Mapping[str, Mapping[str, float]]) -> str:
    """An output with other values over that of the case; values of the same effect are told together."""
    effects: dict[str, list[str]] = {}
    for words, values in found.items():
        effect = "not known"
        if name in values:
            factor = values[name] / basis
            effect = f"{factor:.3g} times" if abs(factor - 1) >= SMALLEST else "unchanged"
        effects.setdefault(effect, []).append(words)
    return ", ".join(f"{effect} with {' or '.join(words)}" for effect, words in effects.items())
