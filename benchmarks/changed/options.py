"""`flexbearing new` with any value in any option."""

from random import Random

from benchmarks.changed.bases import Bases
from benchmarks.changed.changes import Change
from benchmarks.changed.files import Bundle, ChangedFiles
from benchmarks.changed.texts import ABSURD, PATHS, quantity

ROLLERS = {
    "--bore": "50 mm", "--outside": "90 mm", "--width": "20 mm", "--inner-raceway": "59.5 mm",
    "--outer-raceway": "81.5 mm", "--dynamic-rating": "73.5 kN", "--static-rating": "69.5 kN",
    "--fatigue-limit": "8.8 kN", "--clearance-class": "CN", "--shaft": "k5", "--load": "5 kN",
    "--speed": "3000 rpm",
}  # fmt: skip
BALLS = {
    "--like": "deep_groove_ball", "--bore": "40 mm", "--outside": "80 mm", "--width": "18 mm",
    "--dynamic-rating": "32.5 kN", "--static-rating": "19 kN", "--load": "3 kN", "--speed": "3000 rpm",
}  # fmt: skip
ANGULAR = BALLS | {
    "--like": "angular_contact_ball", "--contact-angle": "40 deg", "--axial-load": "3 kN",
    "--static-rating": "26 kN",
}  # fmt: skip
GIVEN = {"rollers": ROLLERS, "balls": BALLS, "angular contact": ANGULAR}
MORE = (
    "--elements", "--diameter", "--length", "--clearance", "--housing", "--material", "--oil",
    "--temperature", "--cleanliness", "--contact-angle", "--axial-load", "--title", "--source", "--like",
    "--from-rexs", "--rexs-bearing", "--run", "--life", "--force",
)  # fmt: skip
NAMES = (
    "cylindrical_roller", "squirrel_cage", "deep_groove_ball", "angular_contact_ball", "four_point_ball",
    "C2", "C5", "c3", "k5", "K6", "zz99", "H7", "J7", "100Cr6", "M50", "steel", "ISO VG 100", "iso vg 68",
    "ISO VG 1e9", "normal cleanliness",
)  # fmt: skip


def options(rng: Random, bases: Bases) -> ChangedFiles:
    """A case of a catalogue page, with absurd numbers on it."""
    name = rng.choice([*GIVEN])
    given = GIVEN[name]
    words = ("new", "n.toml", *(part for pair in given.items() for part in pair))
    changes = tuple(_change(rng, [*given]) for _ in range(rng.choice((1, 1, 2, 3, 5))))
    return ChangedFiles("new", name, Bundle(words, {}, special=("pipe", "folder")), changes)


def _change(rng: Random, given: list[str]) -> Change:
    option = rng.choice((*given, *MORE))
    if option in ("--force", "--run", "--life"):
        return Change(option, lambda bundle: _with(bundle, option))
    if rng.random() < 0.05:
        path = rng.choice([path for path in PATHS if path not in ("..", "/")])
        return Change(f"file is {path[:40]!r}", lambda bundle: _named(bundle, path))
    if rng.random() < 0.1:
        return Change(f"no {option}", lambda bundle: _without(bundle, option))
    text = rng.choice((quantity(rng), rng.choice(ABSURD), rng.choice(NAMES), _scaled(rng)))
    what = f"{option} {text[:60]!r}" + (f" ({len(text)})" if len(text) > 60 else "")
    return Change(what, lambda bundle: _with(_without(bundle, option), option, text))


def _scaled(rng: Random) -> str:
    """A number of a usual kind, far from usual."""
    unit = rng.choice(("mm", "mm", "kN", "rpm", "deg", "degC"))
    return f"{rng.choice((1, 5, 9)) * 10.0 ** rng.randint(-9, 12):g} {unit}"


def _with(bundle: Bundle, *words: str) -> Bundle:
    return Bundle((*bundle.words, *words), bundle.files, bundle.rewritten, bundle.special)


def _named(bundle: Bundle, path: str) -> Bundle:
    return Bundle(("new", path, *bundle.words[2:]), bundle.files, bundle.rewritten, bundle.special)


def _without(bundle: Bundle, option: str) -> Bundle:
    words = [*bundle.words]
    if option in words:
        place = words.index(option)
        del words[place : place + 2]
    return Bundle(tuple(words), bundle.files, bundle.rewritten, bundle.special)
