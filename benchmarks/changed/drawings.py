"""STEP files: other names, colours and places of faces, and other content."""

import re
from random import Random

from benchmarks.changed.bases import Bases
from benchmarks.changed.changes import damaged, in_file, table
from benchmarks.changed.files import Bundle, Change, ChangedFiles, rendered
from benchmarks.changed.texts import ABSURD, DIGITS
from tests.mutated_cases import COARSER, CONFIGS, based_on

NAME = "step_ring.step"
FACES = (
    ["foot"], ["foot", "foot"], [""], ["#e75959"], ["#E75959"], ["#fff"], ["#12345"], ["#ggghhh"],
    ["near 1 mm, 2 mm, 3 mm"], ["near 1e400 mm, 0 mm, 0 mm"], ["near"], ["near nan, nan, nan"], [DIGITS],
    ["\x1b[31m"], ["foot"] * 360, ["foot"] * 361, ["x"] * 300, ["'"], ["foot\n"], ["\u202e"], ["*"],
    ["(1 mm, 2 mm, 3 mm)"], ["#e75959", "foot"], [], ["\\X2\\0041\\X0\\"],
)  # fmt: skip
CELLS = ("", "0", "-1.", "1.E400", "NAN", "1.E308", "#1", "#999999", "$", "*", "''", DIGITS, "(((",
"\\X2\\D800\\X0\\", "FOOT",
         "'foot'", "1.E-320", "'" + 20_000 * "a" + "'", "1E", "#" + DIGITS)  # fmt: skip


def drawing(rng: Random, bases: Bases) -> ChangedFiles:
    """A ring that somebody drew, checked, rarely run."""
    raw = based_on("step_ring", COARSER["step_ring"])
    command = ("run", "case.toml", "-o", "out.h5") if rng.random() < 0.1 else ("check", "case.toml")
    if rng.random() < 0.05:
        command = ("draw", "case.toml", "-o", "drawn")
    bundle = Bundle(command, {"case.toml": raw, NAME: (CONFIGS / NAME).read_bytes()})
    hints = {("outer", "clamps"): FACES, ("outer", "raceway"): ABSURD}
    outer = {"outer": {key: value for key, value in raw["outer"].items() if key != "kind"}}
    changes = tuple(
        table(rng, "case.toml", outer, hints) if rng.random() < 0.5 else _content(rng)
        for _ in range(rng.choice((1, 1, 2, 3)))
    )
    return ChangedFiles("STEP", command[0], bundle, changes)


def _content(rng: Random) -> Change:
    if rng.random() < 0.25:
        return damaged(rng, NAME)
    pattern = rng.choice(
        (rb"'([^']*)'", rb"[(,](-?[0-9.]+E?-?[0-9]*)[,)]", rb"(#[0-9]+)[,)]", rb"= ([A-Z_]+)\(")
    )
    share, text = rng.random(), rng.choice(CELLS)

    def change(content) -> bytes:
        data = rendered(content)
        found = [*re.finditer(pattern, data)]
        if not found:
            return data
        one = found[int(share * len(found))]
        return data[: one.start(1)] + text.encode() + data[one.end(1) :]

    return in_file(f"number {share:.5f} of {pattern.decode()} is {text[:40]!r} ({len(text)})", NAME, change)
