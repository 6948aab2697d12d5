"""Results with other bytes, read by every command that reads one."""

from random import Random

from benchmarks.changed.bases import Bases
from benchmarks.changed.changes import flipped, in_file, word
from benchmarks.changed.files import Bundle, ChangedFiles, rendered
from benchmarks.changed.texts import ABSURD

COMMANDS = (
    ("summary", "r.h5"), ("summary", "r.h5", "--json"), ("diff", "r.h5", "good.h5"), ("diff", "good.h5",
    "r.h5", "--json"), ("report", "r.h5", "-o", "r.html"), ("plot", "r.h5", "-o", "p", "--format", "svg"),
    ("export", "r.h5", "--to", "csv"), ("export", "r.h5", "--to", "rexs"), ("export", "r.h5", "--to", "vtu"),
    ("export", "r.h5", "--to", "netcdf"), ("report", "good.h5", "--against", "r.h5", "-o", "r.html"), ("run",
    "case.toml", "--start", "r.h5", "-o", "o.h5"),
)  # fmt: skip


def result(rng: Random, bases: Bases) -> ChangedFiles:
    """A result whose bytes have changed."""
    kind = rng.choice(("roller", "ball"))
    good = bases.files[f"{kind}.h5"]
    words = rng.choices(COMMANDS, weights=(6, 3, 3, 2, 2, 1, 3, 2, 2, 1, 1, 2))[0]
    case = bases.case if kind == "roller" else bases.ball
    bundle = Bundle(words, {"case.toml": case, "r.h5": good, "good.h5": good})
    how = rng.random()
    if how < 0.25:  # within texts and numbers, where HDF5 sees nothing
        old, new = rng.choice(((b"converged", b"CONVERGED"), (b"[N]", b"[X]"), (b"roller", b"rOller"),
        (b"kind", b"kinD"),
                               (b'"', b"'"), (b"8", b"9"), (b"\x3f\xf0", b"\x7f\xf0")))  # fmt: skip
        change = in_file(f"{old} is {new}", "r.h5", lambda content: rendered(content).replace(old, new))
    elif how < 0.85:
        change = flipped(rng, "r.h5", most=30)
    else:
        change = word(rng, rng.randrange(1, len(words)), ABSURD)
    return ChangedFiles("result", f"{kind}, {' '.join(words)}", bundle, (change,))
