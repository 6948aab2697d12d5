"""Changes of words, tables, cells and bytes, whatever they mean."""

import re
from collections.abc import Callable, Iterator, Sequence
from copy import deepcopy
from random import Random
from typing import Any

from benchmarks.changed.files import Bundle, Change, Content, rendered
from benchmarks.changed.texts import ABSURD, DIGITS, FORMULA, quantity
from tests.mutated_cases import DAMAGES, OTHER_TYPES, Verbatim

Place = tuple[Any, ...]


def in_file(what: str, name: str, change: Callable[[Any], Content], of: type | None = None) -> Change:
    """Another content of a file; with a type, only as long as it is of that."""

    def applied(bundle: Bundle) -> Bundle:
        content = bundle.files.get(name)
        if content is None or (of and not isinstance(content, of)):
            return bundle
        return bundle.with_file(name, change(deepcopy(content) if of else content))

    return Change(f"{name}: {what}", applied)


def word(rng: Random, place: int, texts: Sequence[str]) -> Change:
    """Another word in a place of the command line."""
    text = rng.choice(texts)

    def applied(bundle: Bundle) -> Bundle:
        words = list(bundle.words)
        if place < len(words):
            words[place] = text
        return Bundle(tuple(words), bundle.files, bundle.rewritten, bundle.special)

    return Change(f"word {place} is {text[:40]!r}", applied)


def damaged(rng: Random, name: str) -> Change:
    """Bits, bytes or lines of a file."""
    seed, how = rng.getrandbits(32), rng.choice(DAMAGES)

    def change(content: Content) -> bytes:
        return how(Random(seed), rendered(content).decode(errors="surrogateescape"))

    made = in_file(f"{how.__name__.strip('_').replace('_', ' ')} (seed {seed})", name, change)
    return Change(made.what, made.apply, late=True)


def flipped(rng: Random, name: str, most: int = 8) -> Change:
    """Bytes of a file that is no text."""
    seed, count = rng.getrandbits(32), rng.randint(1, most)

    def change(content: Content) -> bytes:
        chosen, data = Random(seed), bytearray(rendered(content))
        for _ in range(count if data else 0):
            data[chosen.randrange(len(data))] = chosen.randrange(256)
        return bytes(data[: chosen.randrange(len(data) + 1)] if chosen.random() < 0.2 else data)

    made = in_file(f"{count} bytes (seed {seed})", name, change)
    return Change(made.what, made.apply, late=True)


# -- tables of TOML ------------------------------------------------------------------------------


def table(
    rng: Random, name: str, raw: dict[str, Any], more: dict[Place, Sequence[str]] | None = None
) -> Change:
    """A key of a TOML file with another value, or dropped, doubled, renamed or added."""
    places = [*_places(raw)]
    leaves = [place for place in places if not isinstance(_at(raw, place), dict)]
    how = rng.choices(("value", "drop", "rename", "add", "nest", "list"), weights=(10, 2, 1, 2, 1, 1))[0]
    if how == "value":
        place = rng.choice(leaves)
        value = _value(rng, _at(raw, place), (more or {}).get(place, ()))
        return _set(name, place, value)
    place = rng.choice(places)
    if how == "drop":
        return in_file(f"no {_words(place)}", name, lambda tables: _dropped(tables, place), dict)
    if how == "rename":
        last = str(place[-1]) + rng.choice(("x", "s", " ", ".", "é", ""))
        return in_file(
            f"{_words(place)} becomes {last!r}", name, lambda tables: _renamed(tables, place, last), dict
        )
    if how == "add":
        key = rng.choice(("x", "file", "zip", "kind", "operation.radial_load", "bearing.rollers", "case",
        "name",
                          "outer.bars", "accuracy.slices", "", "a.b.c", "é", 300 * "k"))  # fmt: skip
        return _set(name, (*place[:-1], key), _value(rng, 1, ()))
    value = {"x": 1} if how == "nest" else [Verbatim(rng.choice(OTHER_TYPES))] * rng.choice((1, 3, 2000))
    return _set(name, place, value)


def _value(rng: Random, value: Any, more: Sequence[str]) -> Any:
    """Another value of a key."""
    if rng.random() < 0.4:
        return _scaled(rng, value)
    if more and rng.random() < 0.6:
        return rng.choice(more)
    how = rng.random()
    if how < 0.3:
        return Verbatim(rng.choice(OTHER_TYPES))
    if isinstance(value, list) and value and how < 0.8:
        kept = [*value]
        kept[rng.randrange(len(kept))] = _value(rng, kept[0], more)
        return kept if how < 0.7 else kept[: rng.randint(0, 1)]
    if isinstance(value, str) and ".." in value and how < 0.8:
        return _span(rng)
    if isinstance(value, int | float) and how < 0.8:
        return Verbatim(rng.choice(COUNTS))
    return quantity(rng)


def _scaled(rng: Random, value: Any) -> Any:
    """The same with other numbers, as somebody might type them."""
    if isinstance(value, list):
        return [_scaled(rng, each) for each in value] * rng.choice((1, 1, 2))
    if isinstance(value, str):
        return re.sub(r"\d+(\.\d+)?", lambda number: f"{_number(rng, float(number[0])):.6g}", value)
    return _number(rng, value) if type(value) in (int, float) else value


def _number(rng: Random, value: float) -> float:
    """Counts stay small: what a larger one costs is no fault."""
    if value == int(value) and value < 20:
        return rng.choice((0, 1, 2, 3, 4, 5, value))
    return value * rng.choice((0, 0.1, 0.5, 1, 2, 10, 100, 1e-4, 1e4))


COUNTS = ("0", "-1", "1", "3", "1.5", "nan", "inf", "true", "2147483648", "9223372036854775808", "1e3",
DIGITS[:400],
          '"3"', "[3]", "-0", "0x3", "4294967296")  # fmt: skip


def _span(rng: Random) -> str:
    """A range, or what looks like one."""
    first, last = quantity(rng), quantity(rng)
    count = rng.choice(
        ("2", "3", "1", "0", "-1", "1e3", "2.0", "٣", "9999999", "99999999", "nan", "", DIGITS[:400])
    )
    return f"{rng.choice(('', '', 'log ', 'log', 'lin '))}{first} .. {last}, {count}"


def _set(name: str, place: Place, value: Any) -> Change:
    text = repr(value)
    what = f"{_words(place)} = {text[:60]}" + (f"... ({len(text)})" if len(text) > 60 else "")

    def change(tables: dict[str, Any]) -> dict[str, Any]:
        holder, key = _at(tables, place[:-1]), place[-1]
        if isinstance(holder, dict) or (isinstance(holder, list) and key in range(len(holder))):
            holder[key] = value
        return tables

    return in_file(what, name, change, dict)


def _words(place: Place) -> str:
    return "/".join(map(str, place))


def _places(raw: Any, above: Place = ()) -> Iterator[Place]:
    items = raw.items() if isinstance(raw, dict) else enumerate(raw) if _tables(raw) else ()
    for key, value in items:
        if not isinstance(key, int):
            yield (*above, key)
        if isinstance(value, dict) or _tables(value):
            yield from _places(value, (*above, key))


def _tables(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def _at(raw: Any, place: Place) -> Any:
    for key in place:
        try:
            raw = raw[key]
        except (KeyError, IndexError, TypeError):  # another change took it away
            return None
    return raw


def _dropped(tables: dict[str, Any], place: Place) -> dict[str, Any]:
    if isinstance(holder := _at(tables, place[:-1]), dict):
        holder.pop(place[-1], None)
    return tables


def _renamed(tables: dict[str, Any], place: Place, name: str) -> dict[str, Any]:
    if isinstance(holder := _at(tables, place[:-1]), dict) and place[-1] in holder:
        holder[name] = holder.pop(place[-1])
    return tables


# -- cells of CSV --------------------------------------------------------------------------------


Rows = list[list[str]]


def cells(rng: Random, name: str, rows: Rows) -> Change:
    """A cell, a column, a row or the heading of a table."""
    row, column = rng.randrange(len(rows)), rng.randrange(len(rows[0]))
    text = rng.choice(
        (
            _scaled(rng, rows[row][column]),
            quantity(rng),
            FORMULA,
            "",
            "nan",
            "converged",
            DIGITS,
            "x [mm]",
            "[",
            "x [",
            "x [y] [z]",
        )
    )
    ways: dict[str, Callable[[Rows], Rows]] = {
        f"row {row}, column {column} is {text[:40]!r}": lambda rows: _with_cell(rows, row, column, text),
        f"no column {column}": lambda rows: [line[:column] + line[column + 1 :] for line in rows],
        f"column {column} twice": lambda rows: [[*line, *line[column : column + 1]] for line in rows],
        f"row {row} is longer": lambda rows: [line + [text] * (k == row) for k, line in enumerate(rows)],
        f"row {row} twice": lambda rows: rows + rows[row : row + 1],
        "no rows": lambda rows: rows[:1],
        "2000 columns": lambda rows: [line * 600 for line in rows],
        "3000 rows": lambda rows: rows + rows[1:] * 1000,
    }
    what = rng.choices([*ways], weights=(12, 2, 2, 2, 2, 1, 1, 1))[0]
    return in_file(what, name, ways[what], list)


def _with_cell(rows: Rows, row: int, column: int, text: str) -> Rows:
    if row < len(rows) and column < len(rows[row]):
        rows[row][column] = text
    return rows


def absurd(rng: Random) -> str:
    return rng.choice(ABSURD)
