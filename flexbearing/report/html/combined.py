"""How sure the results of a case are: what all inputs together make of them that are not known exactly."""

from dataclasses import dataclass
from math import exp, hypot, log

from flexbearing.report.html import assumed_effects, assumptions
from flexbearing.report.html.document import Cell
from flexbearing.report.html.reader import Reader

LIFE = "life"
HEAD = (
    "by inputs: least [times]",
    "most [times]",
    "worst sum: least [times]",
    "most [times]",
    "moved most by",
)
_COMPUTED = "computed with this result"
_TOLD = "as comments of the case tell it, which leave out changes below 1 %"
_NOTE = (
    "By inputs: the result over that of this case with other values of all that is assumed, fitted or "
    "toleranced, {by}; root of the sum of squares of the largest changes by each input, as logarithms, for "
    "inputs that are independent of each other. Worst sum: all of these changes at once. What the model "
    "leaves out comes on top."
)
_MISSING = " Not counted, since their effect is not told: {}."


@dataclass(frozen=True)
class Span:
    """Least and greatest of an output over that of the case, and the input that moves it most."""

    squares: tuple[float, float]
    worst: tuple[float, float]
    most: str  # key


def cells(reader: Reader, word: str) -> tuple[Cell, ...]:
    """Span of a result, and the input that moves it most; empty where no effect is known.

    Parameters
    ----------
    reader : Reader
    word : str
        of the result in comments of a case, `LIFE` for that to compare with a requirement
    """
    span = span_of(ratios(reader, word))
    if span is None:
        return ()
    numbers = [
        reader.units.number(value, "", "", ".3g", f"combined/{how}/{place}/{word}")
        for how in ("squares", "worst") for place, value in enumerate(getattr(span, how))
    ]  # fmt: skip
    return (*numbers, span.most)


def note(reader: Reader) -> str:
    """What the spans mean, and which inputs are not in them."""
    computed = bool(reader.attributes.get("assumed_effects"))
    missing = [] if computed else _untold(reader)
    words = _NOTE.format(by=_COMPUTED if computed else _TOLD)
    return words + (_MISSING.format(", ".join(missing)) if missing else "")


def ratios(reader: Reader, word: str) -> dict[str, list[float]]:
    """An output with other values of each key over that of the case: as computed, else as comments tell."""
    found = reader.attributes.get("assumed_effects")
    if not found:
        said = assumptions.comments(reader.result.attributes["case_text"])
        return {key: values for key, text in said.items() if (values := assumptions.ratios(text, word))}
    named = {word: name for name, word in reader.layout.weighed}
    name = assumed_effects.ranked_by(reader) if word == LIFE else named[word]
    base = found["of"].get(name)
    if not base or (word == LIFE and name not in assumed_effects.LIVES):
        return {}
    return {
        key["key"]: [other["values"][name] / base for other in key["others"] if name in other["values"]]
        for key in found["keys"]
    }


def span_of(changes: dict[str, list[float]]) -> Span | None:
    """Combine changes by single inputs; None without any.

    >>> span_of({"a": [0.5, 2.0], "b": [2.0]}).worst
    (0.5, 4.0)
    >>> span_of({"a": [0.5, 2.0], "b": [2.0]}).squares == (0.5, 2 ** 2 ** 0.5)
    True
    """
    sides = {
        key: (min([0.0, *map(log, values)]), max([0.0, *map(log, values)]))
        for key, values in changes.items() if values and min(values) > 0
    }  # fmt: skip
    if not sides:
        return None
    low, high = zip(*sides.values(), strict=True)
    return Span(
        squares=(exp(-hypot(*low)), exp(hypot(*high))),
        worst=(exp(sum(low)), exp(sum(high))),
        most=max(sides, key=lambda key: max(map(abs, sides[key]))),
    )


def _untold(reader: Reader) -> list[str]:
    """Assumed and fitted keys whose comments tell no effect."""
    said = assumptions.comments(reader.result.attributes["case_text"])
    keys = (*reader.attributes["calibrated"], *reader.attributes["assumed"])
    return [key for key in keys if not assumptions.weighed(said.get(key, ""))]
