"""How a raceway changes with the dimensions and moduli of its part, near given forces."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, is_dataclass, replace
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from fem.parts.material import ImpossiblePart
from fem.parts.resolution import Shape
from flexbearing.build.mesh_sizes import shape
from flexbearing.build.ring_parts import NAMES, Race, part_of
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.derivatives.sides import STENCILS
from flexbearing.rings.condensed import named_failures

PLACES = ("offset",)  # numbers that may be zero; other dimensions of zero are features that are not there

Part = TypeVar("Part")


def numbers(part: Any) -> dict[str, float]:
    """Numbers of a frozen part and of what it consists of."""
    found = {}
    for name, value in _fields(part).items():
        if is_dataclass(value):
            found |= {f"{name}.{inner}": number for inner, number in numbers(value).items()}
        elif isinstance(value, float) and (value or name in PLACES):
            found[name] = value
    return found


def with_numbers(part: Part, changed: Mapping[str, float]) -> Part:
    """The same part with other numbers, by their dotted names; a part that cannot be raises its own error."""
    new: dict[str, Any] = {}
    for name, value in _fields(part).items():
        inner = {key.removeprefix(f"{name}."): v for key, v in changed.items() if key.startswith(f"{name}.")}
        if inner:
            new[name] = with_numbers(value, inner)
        elif name in changed:
            new[name] = changed[name]
    return replace(part, **new)  # type: ignore[type-var]


def _fields(part: Any) -> dict[str, Any]:
    return {each.name: getattr(part, each.name) for each in fields(part) if each.init}


STEP = 1e-4  # of the dimension that changes most: differences on moved nodes are exact to about 1e-6
SAME = 1e-5  # between directions of change that are taken as one: some digits are lost in small steps

Raceway = TypeVar("Raceway")


class RingChanged(BadCase):
    """A key gives a flexible ring other faces, so that it is another ring."""


def shape_of(case: Case, race: Race) -> Shape | None:
    """Part of a raceway with the band that rollers load; None where it is rigid.

    Raises `BadCase` where there is no such part.
    """
    with named_failures(case, NAMES[race]):
        part = part_of(case, race)
    return None if part is None else shape(case, part)


@dataclass(frozen=True)
class RingSlopes(Generic[Raceway]):
    """A raceway and its derivatives along changes of its shape, each computed when it is first wanted."""

    shape: Any  # frozen, of a part and of where it is loaded, over a `length`
    raceway: Raceway
    of_shape: Callable[[Any], Raceway]  # the raceway of another shape
    combined: Callable[[Sequence[Raceway], Sequence[float]], Raceway]  # weighted sum
    step: float = STEP  # of the differences
    _known: list[tuple[NDArray, list[float], list[Raceway]]] = field(default_factory=list)

    def near(self, shape: Any) -> Raceway:
        """The raceway of a shape near by, to first order.

        Raises `RingChanged` for one with other faces; `ImpossiblePart`, `BadCase` where the dimensions have
        no room to change.
        """
        if shape == self.shape:
            return self.raceway
        change = self._change(shape)
        size = np.abs(change).max()
        weights, raceways = self._slope(change / size)
        change_of = [size / self.step * weight for weight in weights]
        return self.combined([self.raceway, *raceways], [1.0, *change_of])

    def _change(self, shape: Any) -> NDArray:
        """Change of every number, over the number."""
        old, new = numbers(self.shape), numbers(shape)
        if old.keys() != new.keys() or with_numbers(self.shape, new) != shape:
            raise RingChanged("it gives a flexible ring other faces")
        return np.array([(new[name] - value) / self._size(value) for name, value in old.items()])

    def _size(self, value: float) -> float:
        return abs(value) or self.shape.length

    def _slope(self, direction: NDArray) -> tuple[list[float], list[Raceway]]:
        """Weights of raceways whose sum is the change along a direction by `step`; they add up to zero."""
        for known, weights, raceways in self._known:
            for sign in (1.0, -1.0):
                if np.abs(known - sign * direction).max() <= SAME:
                    return [sign * weight for weight in weights], raceways
        weights, raceways = self._differences(direction)
        self._known.append((direction, weights, raceways))
        return weights, raceways

    def _differences(self, direction: NDArray) -> tuple[list[float], list[Raceway]]:
        why: Exception | None = None
        for stencil in STENCILS:
            try:
                shapes = [self._moved(place * self.step * direction) for place in stencil.places]
                return list(stencil.weights), [self.of_shape(each) for each in shapes]
            except (ImpossiblePart, BadCase) as refusal:
                why = refusal
        assert why  # there is a stencil
        raise why

    def _moved(self, change: NDArray) -> Any:
        """The shape with every number changed by a share of it."""
        old = numbers(self.shape)
        pairs = zip(old.items(), change, strict=True)
        return with_numbers(
            self.shape, {name: value + share * self._size(value) for (name, value), share in pairs}
        )
