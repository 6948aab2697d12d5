"""Journals of a finished study that were torn, or hold foreign content under right checksums."""

import json
from collections.abc import Callable
from random import Random
from typing import Any
from zlib import crc32

from benchmarks.changed.bases import STUDY, Bases
from benchmarks.changed.changes import damaged, flipped, in_file
from benchmarks.changed.files import Bundle, Change, ChangedFiles, Content, rendered
from benchmarks.changed.texts import DIGITS, FORMULA

FILE = "out/study.journal.jsonl"
FOREIGN = (  # as JSON
    "null", "true", "0", "-1", "1e400", "1e308", "-1e308", "NaN", "Infinity", "1e-320", DIGITS, "1.5", '""',
    '"a"', '"nan"', '"inf"', f'"{DIGITS}"', json.dumps(FORMULA), '"\\u001b[31mred"', '"a\\nb"', '"\\u0000"',
    '"\\ud800"', '"' + 30_000 * "a" + '"', "[]", "[1]", "[[1]]", "{}", '{"a": 1}', "[" * 900 + "]" * 900,
    "[" * 20_000 + "]" * 20_000, "[" + "1," * 30_000 + "1]", '"converged"', '"error"', '"1,5"',
    '"<script>alert(1)</script>"',
)  # fmt: skip
PLACE = "to be replaced"  # by JSON as it stands, which no encoder writes
KEYS = ("names", "begun", "of", "identity", "status", "message", "seconds", "values", "crc", "x", "")


def journal(rng: Random, bases: Bases) -> ChangedFiles:
    """A study that goes on from a changed journal, or counts what is finished."""
    content = bases.files["study.journal.jsonl"]
    words = rng.choice((("--jobs", "1"), ("--jobs", "1"), ("--status",), ("--jobs", "1", "--retry-failed")))
    files = {"case.toml": bases.case, "study.toml": STUDY, FILE: content}
    bundle = Bundle(("study", "study.toml", "-o", "out", *words), files, rewritten=("out/",))
    count = rng.choice((1, 1, 2, 4))
    changes = tuple(_change(rng, content.count(b"\n")) for _ in range(count))
    return ChangedFiles("journal", " ".join(words), bundle, changes)


def _change(rng: Random, lines: int) -> Change:
    how = rng.choices((_sealed, _replaced, _torn), weights=(10, 2, 2))[0]
    return how(rng, rng.randrange(lines))


def _sealed(rng: Random, line: int) -> Change:
    """Another value in a line, whose checksum is right."""
    key, text = rng.choice(KEYS), rng.choice(FOREIGN)
    seed = rng.getrandbits(32)
    drop, inside = rng.random() < 0.12, rng.random() < 0.4

    def change(entry: dict[str, Any]) -> str:
        chosen = key if key in entry or key == "x" else Random(seed).choice([*entry] or ["x"])
        value: Any = PLACE
        if inside and isinstance(entry.get(chosen), list) and entry[chosen]:
            value = [*entry[chosen]]
            value[Random(seed).randrange(len(value))] = PLACE
        rest = {name: each for name, each in entry.items() if name != chosen}
        return json.dumps(rest if drop else {**rest, chosen: value}).replace(json.dumps(PLACE), text)

    how = "dropped" if drop else "holds" if inside else "is"
    what = f"line {line}: {key} {how} {text[:40]} ({len(text)}), seed {seed}"
    return in_file(what, FILE, lambda content: _with_line(content, line, change))


def _replaced(rng: Random, line: int) -> Change:
    """Something else in place of a line, whose checksum is right."""
    text = rng.choice(FOREIGN)
    return in_file(
        f"line {line} is {text[:40]} ({len(text)})", FILE,
        lambda content: _with_line(content, line, lambda entry: text),
    )  # fmt: skip


def _torn(rng: Random, line: int) -> Change:
    return rng.choice((damaged, flipped))(rng, FILE)


def _with_line(content: Content, line: int, change: Callable[[dict[str, Any]], str]) -> bytes:
    """A journal with another line under its checksum."""
    lines = rendered(content).split(b"\n")
    try:
        entry = json.loads(lines[line])
    except (ValueError, IndexError, RecursionError):  # another change damaged it
        return rendered(content)
    if not isinstance(entry, dict):
        return rendered(content)
    entry.pop("crc", None)
    text = change(entry).encode(errors="surrogatepass")
    rest = text if text[:1] == b"{" else b"{" + text
    separator = b"" if rest == b"{}" else b", "
    lines[line] = b'{"crc": "%08x"' % crc32(rest) + separator + rest[1:]
    return b"\n".join(lines)
