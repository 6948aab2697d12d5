"""Rolling elements of a bearing, where nothing says how many of what size there are."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from flexbearing.catalogue.page import Page

Pair = tuple[int, float]  # number of rolling elements, and their size [m]
APART = 1.15  # of a rating and its formula, as older and other standards have it; assumed


@dataclass(frozen=True)
class Ratings:
    """What the formulas of ISO 281 and ISO 76 give [N]."""

    dynamic: float
    static: float
    fatigue: float


@dataclass(frozen=True, kw_only=True)
class ElementSet:
    """Number and size of the rolling elements, and what else they may be."""

    chosen: Pair  # of the pairs
    pairs: tuple[Pair, ...]  # plausible ones that have the maker's C_0 where it is given, by number
    plausible: tuple[Pair, ...]  # among them those of the least and the greatest ratings
    rated: Callable[[int, float], Ratings]  # ratings by the formulas for a number and a size
    about: str = ""  # what must be known of these ratings


def near(pairs: Sequence[Pair], rated: Callable[[int, float], Ratings], wanted: float) -> list[Pair]:
    """The pair nearest to a static rating [N] that no plausible pair has; none where it is far away."""
    best = min(pairs, key=lambda pair: abs(rated(*pair).static - wanted))
    return [best] if 1 / APART <= wanted / rated(*best).static <= APART else []


def chosen(pairs: list[Pair], rated: bool) -> Pair:
    """Pair of a case: with a maker's C_0 that of most elements, as makers fill bearings; else the middle."""
    return pairs[-1] if rated else pairs[(len(pairs) - 1) // 2]


def span(few: int, many: int) -> str:
    """Write a range of numbers."""
    return f"{few} to {many}" if few < many else f"{few}"


LETTERS = {"elements": "Z", "length": "l_w", "diameter": "D_w"}
_ROWS = (
    ("dynamic, C (ISO 281)", "dynamic", "dynamic_rating"),
    ("static, C_0 (ISO 76)", "static", "static_rating"),
    ("fatigue limit, C_u (ISO 281)", "fatigue", "fatigue_limit"),
)


def table(page: Page, elements: ElementSet, size: str) -> str:
    """Ratings as lines of text."""
    assumed = [LETTERS[name] for name in ("elements", size) if name not in page]
    notes = [_ranges_of(assumed, LETTERS[size], elements), ""] if assumed else []
    if page.like == "four_point_ball":
        return "\n".join(["", *notes])
    here = elements.rated(*elements.chosen)
    columns = {"maker": None, "this case": [here]}
    if assumed:
        columns[f"plausible Z, {LETTERS[size]}"] = [elements.rated(*pair) for pair in elements.plausible]
    if assumed and "static_rating" in page:
        columns["of these with C_0"] = [elements.rated(*pair) for pair in elements.pairs]
    rows = [["load ratings", *columns]]
    for words, name, entry in _ROWS:
        maker = f"{page[entry].si / 1e3:.4g} kN" if entry in page else "-"
        rows.append([words] + [maker if of is None else _range(of, name) for of in columns.values()])
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ["  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) for row in rows]
    lines = ["", *(line.rstrip() for line in lines), ""]
    about = [elements.about, ""] if elements.about else []
    return "\n".join([*lines, *notes, *about, *_apart(page, here)])


def _apart(page: Page, here: Ratings) -> list[str]:
    """A line for each rating of the maker that is far from that of this case."""
    ratios = {words: page[entry].si / getattr(here, name) for words, name, entry in _ROWS if entry in page}
    apart = [
        f"{words}: the maker's is {ratio:.3g} times that of this case; check it, and number and size."
        for words, ratio in ratios.items()
        if not 1 / APART <= ratio <= APART
    ]
    return [*apart, ""] if apart else []


def _ranges_of(letters: list[str], letter: str, elements: ElementSet) -> str:
    """Which rolling elements the ranges are of."""
    numbers, sizes = zip(*elements.plausible, strict=True)
    few, many, small, large = min(numbers), max(numbers), 1e3 * min(sizes), 1e3 * max(sizes)
    count = f"Z = {span(few, many)}"
    size = f"{small:.4g} mm" if small == large else f"{small:.4g} to {large:.4g} mm"
    return f"{' and '.join(letters)} assumed: the ranges are those of {count} and {letter} = {size}."


def _range(ratings: list[Ratings], name: str) -> str:
    values = [getattr(each, name) for each in ratings]
    low, high = (f"{value / 1e3:.3g} kN" for value in (min(values), max(values)))
    return low if low == high else f"{low} to {high}"
