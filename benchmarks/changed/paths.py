"""Names of files that are no files, too long, or not to be written, in every place of every command."""

from random import Random

from benchmarks.changed.bases import Bases
from benchmarks.changed.changes import word
from benchmarks.changed.files import SPECIAL, Bundle, ChangedFiles
from benchmarks.changed.texts import ABSURD, FAR, PATHS

READ, WRITTEN, OTHER = "READ", "WRITTEN", "OTHER"  # what is changed: an input, an output, another word
KEYS = (
    "study", "optimise", "study.sample", "study.sample.method", "optimise.vary", "bearing",
    "bearing.rollers", "bearing.rolers", "study.x", "study.", ".", "..", "kind", "outer.kind", "a.b.c.d",
    "x" * 5000, "slurm", "map", *ABSURD,
)  # fmt: skip
COMMANDS: tuple[tuple[str, dict[int, str]], ...] = (  # words, and what may be changed by place
    ("check case.toml", {1: READ}), ("check case.toml --set accuracy.slices=8", {3: OTHER}),
    ("run case.toml -o o.h5 --quiet", {1: READ, 3: WRITTEN}), ("run case.toml -o o.h5 --start r.h5",
    {5: READ}), ("summary r.h5", {1: READ}), ("report r.h5 -o o.html", {1: READ, 3: WRITTEN}),
    ("report r.h5 --against r.h5 -o o.html", {3: READ}), ("report r.h5 -o o.html --units metric", {5: OTHER}),
    ("plot r.h5 -o o", {1: READ, 3: WRITTEN}), ("plot r.h5 -o o --format svg", {5: OTHER}),
    ("plot b.h5 --against b.h5 -o o", {3: READ}), ("export r.h5 --to csv -o o", {1: READ, 3: OTHER,
    5: WRITTEN}), ("export r.h5 --to vtu --part outer --state rigid", {5: OTHER, 7: OTHER}),
    ("export t.csv --to ross -o o", {1: READ}), ("diff r.h5 r.h5", {1: READ, 2: READ}),
    ("diff r.h5 b.h5", {2: READ}), ("draw case.toml -o o", {1: READ, 3: WRITTEN}),
    ("draw case.toml --format svg -o o", {3: OTHER}), ("draw b.toml -o o --keys --set bearing.balls=16",
    {6: OTHER}), ("explain bearing", {1: OTHER}), ("explain bearing", {1: OTHER}),
    ("study study.toml --check", {1: READ}), ("study study.toml --status -o o", {1: READ, 4: WRITTEN}),
    ("study study.toml --jobs 1 -o o", {3: OTHER, 5: WRITTEN}), ("optimise study.toml --jobs 1 -o o",
    {1: READ, 5: WRITTEN}), ("life case.toml", {1: READ}),
    ("map case.toml --over operation.radial_load=1kN..2kN,2 -o o.csv", {1: READ, 5: WRITTEN}),
    ("new o.toml --from-rexs m.rexs", {1: WRITTEN, 3: READ}), ("sensitivity case.toml -o o.png", {1: READ,
    3: WRITTEN}), ("study study.toml --slurm case.toml -o o", {3: READ}),
    ("study study.toml --scheduler tcp://127.0.0.1:9 -o o --jobs 1", {3: OTHER}),
)  # fmt: skip
TEXTS = {READ: PATHS, WRITTEN: tuple(path for path in PATHS if path not in FAR), OTHER: ABSURD}


def path(rng: Random, bases: Bases) -> ChangedFiles:
    """A command with another name, or other words, in one of its places."""
    command, places = rng.choice(COMMANDS)
    words = tuple(command.split())
    files = {
        "case.toml": bases.case, "b.toml": bases.ball, "r.h5": bases.files["roller.h5"],
        "b.h5": bases.files["ball.h5"], "study.toml": {"case": "case.toml",
        "over": {"operation.radial_load": ["1 kN"]}}, "t.csv": bases.files["study.csv"],
    }  # fmt: skip
    place = rng.choice([*places])
    texts = KEYS if words[0] == "explain" else TEXTS[places[place]]
    return ChangedFiles("path", command, Bundle(words, files, special=SPECIAL), (word(rng, place, texts),))
