"""How sure the results of a case are: what all inputs together make of them that are not known exactly."""

from dataclasses import dataclass
from math import exp, hypot, inf, log

from flexbearing.quantities.effects import CHOICE, COMPARISON, LIVES, about
from flexbearing.report.html import assumed_effects, assumptions
from flexbearing.report.html.document import Cell
from flexbearing.report.html.reader import Reader

LIFE = "life"
HEAD = (
    "by inputs: lowest [factor]",
    "highest [factor]",
    "all at once: lowest [factor]",
    "highest [factor]",
    "moved most by",
)
_NOTE = (
    "By inputs: the result over that of this case with other values of all that is assumed, fitted or "
    "toleranced: root of the sum of squares of the largest change by each input, as logarithms, for "
    "inputs that are independent of each other. All at once: {worst}. What the model leaves out comes on "
    "top. –: no effect of an input on it is known, or it is zero and has no factor."
)
_SUMMED = "the product of the largest changes by all inputs"
_SOLVED = (
    "of the life, the case solved again with all changes that shorten it, and with all that lengthen it; of "
    "the other results, the product of the largest changes"
)
_CHOSEN = " Choices of the case count as inputs here: {}."
_CAPPED = (
    " {} stays between {:g} and {:g}: of changes that add up to more, only what is left to these limits "
    "counts, so the range may be narrower than the root of squares of the rows."
)
_ONE_THING = " {} describe one thing and count as one input: the larger change of them in each direction."
_LIMITS = {  # of factors of a life that a rule bounds
    "a_ISO": (0.1, 50.0),  # ISO 281
    "film": (0.19, 3.03),  # STLE
}


@dataclass(frozen=True)
class Change:
    """A result with another value of an input over that of the case, as logarithms."""

    whole: float
    factors: float = 0.0  # the part that the factors of the life have in it


@dataclass(frozen=True)
class Span:
    """Least and greatest of an output over that of the case, and the input that moves it most."""

    squares: tuple[float, float]
    worst: tuple[float, float]
    most: str  # key


def cells(reader: Reader, word: str) -> tuple[Cell, ...]:
    """Span of a result, and the input that moves it most; empty where no effect is known."""
    span = of(reader, word)
    if span is None:
        return ()
    numbers = [
        reader.units.number(value, "", "", ".3g", f"combined/{how}/{place}/{word}")
        for how in ("squares", "worst") for place, value in enumerate(getattr(span, how))
    ]  # fmt: skip
    return (*numbers, " with ".join(_groups(reader).get(span.most, (span.most,))))


def of(reader: Reader, word: str) -> Span | None:
    """Span of a result; None where no effect on it is known."""
    room = _room(reader) if word == LIFE else (inf, inf)
    span = span_of(changes(reader, word), room)
    solved = _at_once(reader) if word == LIFE else None
    if span is None or solved is None:
        return span
    low, high = span.squares
    return Span((max(low, solved[0]), min(high, solved[1])), solved, span.most)


def note(reader: Reader) -> str:
    """What the spans mean, and which inputs are not in them."""
    words = _NOTE.format(worst=_SOLVED if _at_once(reader) else _SUMMED)
    if chosen := assumed_effects.keys(reader, CHOICE):
        words += _CHOSEN.format(", ".join(chosen))
    if bounded := _bounded(reader):
        words += _CAPPED.format(bounded[0], *_LIMITS[bounded[0]])
    for group in _groups(reader).values():
        words += _ONE_THING.format(" and ".join(map(assumptions.named, group))) if len(group) > 1 else ""
    return words


def inputs(reader: Reader, key: str) -> str:
    """Name of an input that moves a result, with the keys that count with it."""
    return " with ".join(map(assumptions.named, _groups(reader).get(key, (key,))))


def _groups(reader: Reader) -> dict[str, list[str]]:
    """Keys of inputs by the one that they count with."""
    found = reader.attributes.get("assumed_effects") or {}
    keys = [each["key"] for each in found.get("keys", ())]
    grouped: dict[str, list[str]] = {}
    for key in sorted(keys):
        grouped.setdefault(about(key), []).append(key)
    return grouped


def changes(reader: Reader, word: str) -> dict[str, list[Change]]:
    """Changes of an output by each input, those of one thing together."""
    found = reader.attributes.get("assumed_effects")
    collected: dict[str, list[Change]] = {}
    if not found:
        return {}
    named = {word: name for name, word in (*reader.layout.weighed, *reader.layout.weighed_in_results)}
    name = assumed_effects.ranked_by(reader) if word == LIFE else named.get(word, "")
    if assumed_effects.base(reader, name) is None or (word == LIFE and name not in LIVES):
        return {}
    for key in (key for key in found["keys"] if key.get("role") != COMPARISON):
        for values in (other["values"] for other in key["others"]):
            if values.get(name, 0.0) > 0:
                collected.setdefault(about(key["key"]), []).append(_change(values, found["of"], name))
    return collected


def _change(values: dict[str, float], base: dict[str, float], name: str) -> Change:
    """A change with the part of the factors of a modified life, which its basic life does not have."""
    modified, basic = LIVES
    whole = log(values[name] / base[name])
    both = name == modified and all(each.get(basic, 0.0) > 0 for each in (values, base))
    return Change(whole, whole - log(values[basic] / base[basic]) if both else 0.0)


def span_of(changes: dict[str, list[Change]], room: tuple[float, float] = (inf, inf)) -> Span | None:
    """Combine changes by single inputs; None without any.

    >>> halved_and_doubled = {"a": [Change(log(0.5)), Change(log(2.0))], "b": [Change(log(2.0))]}
    >>> [round(each, 9) for each in span_of(halved_and_doubled).worst]
    [0.5, 4.0]
    >>> round(span_of({"a": [Change(2.0, 2.0)], "b": [Change(2.0, 2.0)]}, (inf, 2.0)).worst[1] / exp(2.0), 9)
    1.0
    """
    if not any(changes.values()):
        return None
    ends = {key: [_end(values, sign) for sign in (-1, 1)] for key, values in changes.items() if values}
    squares, worst = [], []
    for side, sign in enumerate((-1, 1)):
        of_side = [pair[side] for pair in ends.values()]
        for results, total in ((squares, hypot), (worst, lambda *sizes: sum(sizes))):
            reached = total(*(max(0.0, sign * each.factors) for each in of_side))
            excess = max(0.0, 1 - room[side] / reached) if reached else 0.0
            sizes = (sign * each.whole - excess * max(0.0, sign * each.factors) for each in of_side)
            results.append(exp(sign * total(*(max(0.0, size) for size in sizes))))
    most = max(ends, key=lambda key: max(abs(each.whole) for each in ends[key]))
    return Span((squares[0], squares[1]), (worst[0], worst[1]), most)


def _end(values: list[Change], sign: int) -> Change:
    """The largest change in one direction; none where all go the other way."""
    return max([Change(0.0), *values], key=lambda each: sign * each.whole)


def _bounded(reader: Reader) -> tuple[str, float] | None:
    """The factor of the life that a rule bounds, with its value; None without one."""
    factors = ((reader.attributes.get("life") or {}).get(reader.last) or {}).get("factors", ())
    return next(((each["name"], each["value"]) for each in factors if each["name"] in _LIMITS), None)


def _room(reader: Reader) -> tuple[float, float]:
    """Logarithms by which a bounded factor may shrink and grow."""
    bounded = _bounded(reader)
    if bounded is None:
        return inf, inf
    name, value = bounded
    least, most = _LIMITS[name]
    return max(0.0, log(value / least)), max(0.0, log(most / value))


def _at_once(reader: Reader) -> tuple[float, float] | None:
    """The life with all changes at once over that of the case; None where it was not solved."""
    found = reader.attributes.get("assumed_effects") or {}
    name = assumed_effects.ranked_by(reader) if found else ""
    lives = [each["values"][name] for each in found.get("together", ()) if name in each["values"]]
    if not lives or len(lives) < len(found["together"]):
        return None
    ratios = (1.0, *(life / found["of"][name] for life in lives))
    return min(ratios), max(ratios)
