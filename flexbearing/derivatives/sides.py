"""Both sides of a derivative: corners of an output, ends of a key, jumps; and the table of all."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.derivatives.keys import Key
from flexbearing.derivatives.table import OutputValue, Sensitivities
from flexbearing.outputs import RequestedOutput, outputs, requested
from flexbearing.quantities.layout import Layout


class Stencil(NamedTuple):
    """Where a function is taken for its first derivative, in steps, and the weight of each place."""

    places: tuple[float, ...]
    weights: tuple[float, ...]


CENTRAL = Stencil((-1.0, 1.0), (-0.5, 0.5))
FORWARD = Stencil((0.0, 1.0, 2.0), (-1.5, 2.0, -0.5))
BACKWARD = Stencil((0.0, -1.0, -2.0), (1.5, -2.0, 0.5))
STENCILS = (CENTRAL, FORWARD, BACKWARD)  # the first that stays within the limits of a key is taken


JUMP = 100.0  # percent per percent: an output whose sides differ by more jumps there, and has no derivative
KINK = 1e-2  # of a derivative: how far its two sides differ where an output has a corner, such as a maximum


def with_sides(key: Key, values: NDArray, slope: NDArray, below: NDArray, above: NDArray) -> NDArray:
    """Derivatives of outputs by a step of a key, with both sides where they differ."""
    floor, apart = key.relative_step * np.abs(values), np.abs(above - below)
    at_limit = np.isnan(above) != np.isnan(below)
    ends = np.where(np.isnan([below, above]), np.nan, slope)
    sides = np.where(apart > KINK * np.maximum(np.abs(slope), floor), [below, above], np.nan)
    sides = np.where(at_limit, ends, sides)
    return np.where(apart > JUMP * floor, np.nan, [slope, *sides])


ALL, LIFE = "all", "life"


@dataclass(frozen=True)
class Differentiable:
    """Outputs of a kind of bearing that have derivatives."""

    layout: Layout
    main: tuple[str, ...]  # without a request
    estimates: tuple[str, ...]  # quantities that are no outputs of the bearing
    kinds: str  # keys that decide whether rings are elastic

    def requested(self, of: Sequence[str], *, basic: bool, elastic: bool) -> list[RequestedOutput]:
        """Outputs that texts name, `all` and `life` among them: the basic life, or that with its factors.

        Raises `UnknownOutput` and `WrongUnit` as well.

        Raises `BadCase` for those of rigid rings where rings are elastic.
        """
        texts, life = list(of or self.main), "life_L10" if basic else "modified_life"
        if ALL in texts:
            every = (each.name for each in outputs(self.layout))
            texts = [name for name in every if name.partition(".")[0] not in self.estimates]
        found = [requested(self.layout, life if text == LIFE else text) for text in dict.fromkeys(texts)]
        for output in found if elastic else ():
            if output.block == "rigid":
                raise BadCase(
                    f"output {output.name}: derivatives are those of the answer between elastic rings; for "
                    f"rigid ones set {self.kinds} to rigid"
                )
        return found


def tabled(
    heading: tuple[str, str],
    of: Sequence[RequestedOutput],
    values: NDArray,
    columns: Mapping[Key, NDArray],
    left_out: Sequence[tuple[str, str]],
) -> Sensitivities:
    """The table of derivatives; outputs that the case does not have are left out.

    Raises `BadCase` where it has none of them.
    """
    there = np.isfinite(values)
    if not there.any():
        raise BadCase(f"of {', '.join(each.name for each in of)}: the case has no such output")
    numbers = np.array(list(columns.values())).reshape(-1, 3, len(values)).transpose(1, 2, 0)
    slopes, below, above = numbers[:, there]
    known = []
    for output, value in zip(of, values.tolist(), strict=True):
        if np.isfinite(value):
            share = output.unit != "%" and not output.output.rounds_to_zero(value / output.conversion.factor)
            known.append(OutputValue(output.name, output.unit, value, share))
    jumps = _jumps(known, list(columns), slopes)
    return Sensitivities(*heading, tuple(known), tuple(columns), slopes, below, above, (*left_out, *jumps))


def _jumps(outputs: Sequence[OutputValue], keys: Sequence[Key], slopes: NDArray) -> Iterator[tuple[str, str]]:
    """Yield keys at which some outputs jump, as the life where a standing ring begins to turn."""
    for key, column in zip(keys, np.isnan(slopes).T, strict=True):
        if column.any():
            names = ", ".join(output.name for output, jumps in zip(outputs, column, strict=True) if jumps)
            yield key.path, f"there is a jump of {names}"
