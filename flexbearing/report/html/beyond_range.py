"""What the range of the life does not count, with its size where that is known."""

from collections.abc import Iterator
from math import log

from flexbearing.findings.codes import PRESSED_ENDS
from flexbearing.quantities.effects import CHOICE, INPUT
from flexbearing.report.html import assumed_effects, combined, oil, ratings, shaft_tilt
from flexbearing.report.html.check import text_of
from flexbearing.report.html.lives import lives
from flexbearing.report.html.open_checks import straight
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.sentences import rounded

UNCHANGED = 5e-3  # relative change of the life that is none


def left_out(reader: Reader) -> tuple[str, ...]:
    """Short phrases, those with a number first."""
    solved = {key for role in (INPUT, CHOICE) for key in assumed_effects.keys(reader, role)}
    return tuple((*_tilt(reader, solved), *_oil(reader), *_unsized(reader, solved)))


def _tilt(reader: Reader, solved: set[str]) -> Iterator[str]:
    """The life where the shaft holds the inner ring otherwise."""
    known, first = shaft_tilt.otherwise(reader), next(iter(lives(reader)), None)
    if known is None or "operation.tilt" in solved or first is None or not first.chosen:
        return
    how, ratio = known
    hours = (
        f", {rounded(first.hours, ratio)} h"
        if first.key == "basic" and not isinstance(first.hours, str)
        else ""
    )
    yield f'with operation.tilt = "{how}" the basic life is {ratio:.3g} times as long{hours}'


def _oil(reader: Reader) -> Iterator[str]:
    if bound := of_oil(reader):
        yield bound


def of_oil(reader: Reader) -> str:
    """The largest a_ISO of a life that leaves the oil out; empty where it counts it, or κ is not known."""
    kappa, life = ratings.viscosity_ratio(reader), reader.attributes["case_si"].get("life") or {}
    if life.get("lubrication") or kappa is None:
        return ""
    most = oil.largest_a_iso(reader)
    if most is None:
        return f"ISO 281 has no a_ISO for κ {kappa[0]:.3g}, below 0.1"
    return (
        f"a_ISO is at most {text_of(most)} at κ {kappa[0]:.3g} and the load of this life, at any cleanliness"
    )


def with_oil(reader: Reader) -> str:
    """What a life at most is with the oil that it leaves out; empty where it counts it."""
    first, bound = next(iter(lives(reader)), None), of_oil(reader)
    most = oil.largest_a_iso(reader)
    if not bound or first is None:
        return ""
    if most is None:
        return f", without the influence of the oil ({bound})"
    life = first.hours or first.turns
    times, unit = most.size, "million revolutions" if isinstance(first.hours, str) else "h"
    assert not isinstance(life, str)
    return f", without the influence of the oil; with it at most {rounded(life, times)} {unit} ({bound})"


def of_upper_end(reader: Reader) -> str:
    """Why the upper end of the range is too long, where it counts less relief of the roller ends."""
    edges = reader.attributes["case_si"].get("life", {}).get("edge_stress")
    less = combined.changes(reader, combined.LIFE).get("bearing.roller.profile", ())
    if not any(change.whole > log(1 + UNCHANGED) for change in less):
        return ""
    if edges is False:
        return (
            "Do not rely on its upper end: straight rollers or a smaller drop lengthen the life only as edge "
            "stress is left out (life.edge_stress = false)."
        )
    if "straight" not in _profiles(reader):
        return ""
    return (
        "Its upper end counts straight rollers, whose stress at the ends no slice shows: do not rely on it."
    )


def _profiles(reader: Reader) -> set[str]:
    """Other profiles that effects were computed with."""
    keys = (reader.attributes.get("assumed_effects") or {}).get("keys", ())
    return {
        other["words"] for key in keys if key["key"] == "bearing.roller.profile" for other in key["others"]
    }


def _unsized(reader: Reader, solved: set[str]) -> Iterator[str]:
    """What changes the life by an amount that this result does not know."""
    computes = " (outputs.assumed_effects = true computes its effect)"
    no_edges = reader.attributes["case_si"].get("life", {}).get("edge_stress") is False
    if reader.codes & PRESSED_ENDS and no_edges and "life.edge_stress" not in solved:
        relieved = reader.bearing["roller"]["profile"] != "straight"  # ISO/TS 16281 has it of profiles alone
        yield f"edge stress of the pressed roller ends{computes * relieved}"
    if straight(reader) and "operation.misalignment" not in solved:
        yield f"misalignment of the shaft, not known and computed as none{computes}"
