"""Derivatives at the state of a result: its case is solved again, and must lead to the same state."""

from collections.abc import Mapping, Sequence
from math import isclose
from pathlib import Path
from typing import Any, Protocol

from flexbearing.case import BadCase, understood
from flexbearing.case.family import Family
from flexbearing.outputs import Value

SAME = 1e-6  # relative difference of an output of the same state


class Solved(Protocol):
    """What is asked of a result."""

    @property
    def attributes(self) -> Mapping[str, Any]:
        """With the text of its case."""
        ...

    @property
    def family(self) -> Family:
        """Of the bearing."""
        ...

    @property
    def place(self) -> str:
        """What a message names."""
        ...

    def __getitem__(self, output: str) -> Value: ...


class NotTheSameState(ValueError):
    """The case of a result leads to another equilibrium; the message says by how much."""


def sensitivities(result: Solved, of: Sequence[str], by: Sequence[str]) -> Any:
    """Derivatives of outputs by keys, see `Result.sensitivities`.

    Raises
    ------
    BadCase
        for a family without derivatives, and as the derivatives themselves
    NotTheSameState
        where the case leads to another equilibrium
    """
    attributes, family = result.attributes, result.family
    file = Path(attributes["case_file"])
    case = understood(
        attributes["case_text"], file, tuple(attributes["case_overrides"]), {family.kind: family}
    )
    if family.sensitivities is None:
        raise BadCase(f'{result.place}: outputs of kind = "{family.kind}" are not differentiated.')
    found = family.sensitivities()(case, of, by)
    for output in found.outputs:
        stored = result[f"{output.name} [{output.unit}]"].number
        if not isclose(stored, output.value, rel_tol=SAME, abs_tol=0.0):
            raise NotTheSameState(
                f"{result.place}: {output.name} is {stored:.6g} {output.unit}, and {output.value:.6g} where "
                "its case is solved again; run it without a start from another result"
            )
    return found
