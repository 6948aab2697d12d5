"""What other values of assumed or fitted inputs, and the ends of tolerances, make of a result."""

from dataclasses import dataclass
from math import exp, hypot, inf, log

from flexbearing.outputs import Output, outputs
from flexbearing.quantities import SummaryValue
from flexbearing.quantities.effects import COMPARISON, LIVES, Effects, about
from flexbearing.report.figure import Axis, Figure, Line, Rule
from flexbearing.report.html.document import Cell, Number, Table
from flexbearing.report.html.keys import name
from flexbearing.report.html.reader import Reader, unit_of
from flexbearing.report.html.units import NOTHING, units_in_words, with_unit

SMALLEST = 5e-3  # relative change that is drawn
MINOR = 0.1  # of the largest effect: inputs with less are not named beside it
_STIFFNESSES = {"total_stiffness": "stiffness", "total_stiffness_yy": "stiffness along y"}
_WIDE = 1.5  # ratio of the ends of an axis from which it is logarithmic
_TICKS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5, 7, 10, 20, 50, 100)
_TALL = 8  # keys that a figure of usual height has room for
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
    """Least and greatest of the life over that of the case, and the input that moves it most."""

    squares: tuple[float, float]
    worst: tuple[float, float]
    most: str  # key


def known(reader: Reader) -> Effects:
    """Effects of a result that has them."""
    assert reader.effects is not None
    return reader.effects


def ranked(reader: Reader) -> list[int]:
    """Places of the keys among the effects, the largest effect first."""
    found, output = known(reader), ranked_by(reader)
    return sorted(range(len(found.keys)), key=lambda place: -_effect(found, place, output))


def largest(reader: Reader, output: str, count: int) -> list[tuple[str, list[Number]]]:
    """Keys with the largest effects on an output, no comparisons and minor ones, each with growing ratios."""
    found = known(reader)
    moving = {place: _effect(found, place, output) for place in _inputs(found)}
    least = max(SMALLEST, MINOR * max(moving.values(), default=0.0))
    chosen = sorted((place for place in moving if moving[place] > least), key=lambda place: -moving[place])
    rows = []
    for place in chosen[:count]:
        others = range(len(found.keys[place].others))
        ratios = [ratio for number in others
                  if isinstance(ratio := _ratio(reader, place, number, output), Number)]  # fmt: skip
        rows.append((found.keys[place].key, sorted(ratios, key=lambda ratio: ratio.size)))
    return rows


def ranked_by(reader: Reader) -> str:
    """Name of the output that effects are ranked by: a life, else the first that there is."""
    of = known(reader).of
    return next((each for each in (*LIVES, *of) if each in of), "")


def _inputs(found: Effects) -> list[int]:
    """Places of the keys that are no comparisons."""
    return [place for place, key in enumerate(found.keys) if key.role != COMPARISON]


def most_moved(reader: Reader) -> str:
    """Name of the output that effects are ranked by; where nothing moves it, of the one that moves most."""
    found, first = known(reader), ranked_by(reader)
    effect = {
        output: max((_effect(found, place, output) for place in _inputs(found)), default=0.0)
        for output in (first, *found.of)
    }
    return first if effect[first] > SMALLEST else max(effect, key=lambda output: effect[output])


def _base(reader: Reader, output: str) -> float | None:
    """An output of the case, for ratios to it; None where it is not known or zero to the printed digit."""
    value = known(reader).of.get(output)
    return None if value is None or _output(reader, output).rounds_to_zero(value) else value


def _effect(found: Effects, place: int, output: str) -> float:
    """Largest change of an output with other values of a key, as the size of its logarithm."""
    base = found.of.get(output)
    values = (other.values.get(output) for other in found.keys[place].others)
    ratios = [value / base for value in values if base and value is not None]
    return max((abs(log(ratio)) for ratio in ratios if ratio > 0), default=0.0)


def _output(reader: Reader, output: str) -> Output:
    return next(each for each in outputs(reader.layout) if each.name == output)


def label(reader: Reader, output: str) -> str:
    """What an output is, without its unit."""
    declared, part = _output(reader, output).declared, output.partition(".")[2].split(".")[0]
    return ", ".join(filter(None, [_STIFFNESSES.get(output) or reader.label(declared).strip(), part]))


def heading(reader: Reader, output: str) -> str:
    """The same with its unit, lives in millions of revolutions."""
    words, unit = label(reader, output), reader.units.of(_unit(_output(reader, output).declared))
    return f"{words} [10⁶ revolutions]" if unit == "Mrev" else with_unit(words, unit)


def _unit(declared: SummaryValue) -> str:
    """Unit on the metric page."""
    unit = unit_of(declared).name
    return "kN/mm" if unit == "N/m" else unit


def _at(place: int, number: int, output: str) -> str:
    return f"assumed_effects/keys/{place}/others/{number}/values/{output}"


def _value(reader: Reader, place: int, number: int, output: str) -> Cell:
    other = known(reader).keys[place].others[number]
    if output not in other.values:
        return NOTHING
    declared = _output(reader, output).declared
    stored = reader.layout[declared.of[0]].unit if declared.in_si else unit_of(declared).name
    digits = ",.4g" if output in LIVES or output in _STIFFNESSES else declared.digits or ".4g"
    return reader.of_attribute(_at(place, number, output), stored, _unit(declared), digits)


def _ratio(reader: Reader, place: int, number: int, output: str) -> Cell:
    """An output over that of the case."""
    found, of_case = known(reader), _base(reader, output)
    value = found.keys[place].others[number].values.get(output)
    if of_case is None or value is None:
        return NOTHING
    of = f"ratio/attributes/{_at(place, number, output)}:attributes/assumed_effects/of/{output}"
    return reader.units.number(value / of_case, "", "", ".3g", of)


def table(reader: Reader) -> Table:
    """A row for each other value, the largest effect first."""
    found, output = known(reader), ranked_by(reader)
    shown = [each for each in found.of if each == output or each not in LIVES]
    rows: list[tuple[Cell, ...]] = []
    for place in ranked(reader):
        key = found.keys[place]
        for number, other in enumerate(key.others):
            words = units_in_words(other.words)
            if other.values:
                first, *further = (_value(reader, place, number, each) for each in shown)
                ratio = _ratio(reader, place, number, output)
                rows.append((key.key, words, first, ratio, *further, units_in_words(key.source)))
            else:
                empty = [NOTHING] * (len(shown) + 1)
                rows.append((key.key, words, *empty, units_in_words(other.problem)))
    first, *others = (heading(reader, each) for each in shown)
    return Table(("key", "with", first, "times", *others, "range from"), tuple(rows))


def figure(reader: Reader) -> Figure | None:
    """Range of the output with other values of each key, over that of the case; None without an effect."""
    found, output = known(reader), ranked_by(reader)
    keys = [place for place in ranked(reader) if _effect(found, place, output) >= SMALLEST]
    if not keys:
        return None
    x: list[float | None] = []
    y: list[str | None] = []
    lines: list[str] = []
    base = found.of[output]
    for place in keys:
        key = found.keys[place]
        values = [(o.values[output] / base, o.words) for o in key.others if output in o.values]
        for ratio, words in sorted([(1.0, "this case"), *values]):
            x.append(float(f"{ratio:.6g}"))
            y.append(name(key.key))
            lines.append(units_in_words(words))
        x.append(None)
        y.append(None)
        lines.append("")
    points = Line(x, y, size=8.0, words=tuple(lines), hover="%{y}<br>%{text}: %{x} times<extra></extra>")
    ratios = [ratio for ratio in x if ratio is not None]
    wide = max(ratios) > _WIDE * min(ratios)
    along = Axis("over that of this case", "log" if wide else "linear", ticks=_TICKS if wide else ())
    keys_down, of_case = Axis(scale="category", falling=True), Rule(1.0, dash="dot")
    title, tall = label(reader, output), len(keys) > _TALL
    return Figure("assumed-effects", title, along, keys_down, (points, of_case), tall=tall)


def span(reader: Reader) -> Span | None:
    """Span of the life by all inputs together; None where no effect on it is known."""
    found = span_of(changes(reader), _room(reader))
    solved = _at_once(reader)
    if found is None or solved is None:
        return found
    low, high = found.squares
    return Span((max(low, solved[0]), min(high, solved[1])), solved, found.most)


def changes(reader: Reader) -> dict[str, list[Change]]:
    """Changes of the life by each input, those of one thing together."""
    found = reader.effects
    collected: dict[str, list[Change]] = {}
    if found is None or (output := ranked_by(reader)) not in LIVES or _base(reader, output) is None:
        return {}
    for key in (key for key in found.keys if key.role != COMPARISON):
        for values in (other.values for other in key.others):
            if values.get(output, 0.0) > 0:
                collected.setdefault(about(key.key), []).append(_change(values, found.of, output))
    return collected


def _change(values: dict[str, float], base: dict[str, float], output: str) -> Change:
    """A change with the part of the factors of a modified life, which its basic life does not have."""
    modified, basic = LIVES
    whole = log(values[output] / base[output])
    both = output == modified and all(each.get(basic, 0.0) > 0 for each in (values, base))
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


def _room(reader: Reader) -> tuple[float, float]:
    """Logarithms by which a factor of the life that a rule bounds may shrink and grow."""
    life = reader.lives.get(reader.last)
    bounded = next((each for each in life.factors if each.name in _LIMITS), None) if life else None
    if bounded is None:
        return inf, inf
    least, most = _LIMITS[bounded.name]
    return max(0.0, log(bounded.value / least)), max(0.0, log(most / bounded.value))


def _at_once(reader: Reader) -> tuple[float, float] | None:
    """The life with all changes at once over that of the case; None where it was not solved."""
    found = reader.effects
    if found is None:
        return None
    output = ranked_by(reader)
    lives = [each.values[output] for each in found.together if output in each.values]
    if not lives or len(lives) < len(found.together):
        return None
    ratios = (1.0, *(life / found.of[output] for life in lives))
    return min(ratios), max(ratios)
