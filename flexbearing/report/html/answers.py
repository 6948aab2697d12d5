"""What an engineer asks of a report first, answered in a sentence or two, with where the rest stands."""

from collections.abc import Iterator
from math import log

import numpy as np

from flexbearing.quantities.effects import CHOICE, COMPARISON, LIVES
from flexbearing.report.html import (
    against_limits,
    assumed_effects,
    assumptions,
    clearance,
    combined,
    exactness,
    lives,
    lubrication,
    stiffness,
)
from flexbearing.report.html.against_limits import NOT_CHECKED
from flexbearing.report.html.document import Number, Table
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed
from flexbearing.report.rows import of_supports

CAPTION = "Short answers"
SLIP = "cage slip"  # in percent, with its error in percentage points
_TINY = 1e-3  # [%] error below which its size does not matter
_LARGEST, _STEPS = 4, 3  # factors or limits, and things to do, that an answer names
_SIGNS = (
    "Azimuth 0° is the z axis, along the load unless operation.load_direction turns it. It grows towards y, "
    "the way that a positive speed turns. Positive along a roller is +x; other signs stand below the tables."
)
_AXES = "Axes: x along the shaft, z at azimuth 0°, y at 90°; forces are positive along them."
_MODEL = (
    "What is assumed usually changes more. How far the model is from measurements is not in these errors: "
    "the evidence pages of the program compare it with published ones, not with this bearing."
)
_TANGENT = "Slopes at this load and speed; no damping. With tilt and signs: the matrix over five directions."


def blocks(reader: Reader) -> Iterator[Table]:
    """Questions, answers, and the sections with the rest."""
    do = "[What to do next](#to-do)" if against_limits.steps(reader) else "[What limits most](#limits-most)"
    asked = (
        ("Is it safe?", _safe, "[What limits most](#limits-most)"),
        ("What limits it first, and what to change?", _first, do),
        ("Why not the catalogue's life?", _catalogue, "[Life](#life)"),
        ("What was assumed, and what does it change?", _assumed, "[Inputs](#inputs), [Main results](#main)"),
        ("How exact are the numbers?", _exact, "[Numerical errors](#errors)"),
        ("Which clearance?", _clearance, "[Clearance](#clearance)"),
        ("Which stiffness for a rotor program?", _stiffness, "[Stiffness](#stiffness)"),
        ("Is the lubrication sufficient?", _lubrication, "[Contacts](#contacts), [Life](#life)"),
        (
            "Where is the load, and which signs?",
            _load,
            f"[{_elements(reader)}](#elements), [drawings](#computed)",
        ),
        ("What was not checked?", _unchecked, "[What limits most](#limits-most), [Limits](#limits)"),
    )
    rows = [(question, words, where) for question, answer, where in asked if (words := answer(reader))]
    yield Table(CAPTION, ("question", "answer", "more in"), tuple(rows))


def _elements(reader: Reader) -> str:
    shown = reader.result.family.report().elements
    return f"{shown.word.capitalize()}s" if shown else "Elements"


def _text(number: Number) -> str:
    return f"{number.text} {printed(number.unit)}".strip()


def _safe(reader: Reader) -> str:
    """Which limits are kept, with the share that is used of them, and what has none."""
    urgent = [
        f"{check.what} {_text(check.value)}" for check in against_limits.ranked(reader)
        if check.urgent and isinstance(check.value, Number)
    ]  # fmt: skip
    without = f" Without a limit in the case, so compare with yours: {'; '.join(urgent)}." if urgent else ""
    told = [
        f"{check.what} {_text(check.value)}, {check.limit}: {check.share.text} % used, {check.verdict}"
        for check in against_limits.ranked(reader)[: _LARGEST + 1]
        if isinstance(check.value, Number) and isinstance(check.share, Number)
    ]  # fmt: skip
    return f"{against_limits.judged(reader)} {'; '.join(told)}.{without}" if told else without.strip()


def _first(reader: Reader) -> str:
    """The limit with the largest share, and the first things to do."""
    first = next((check for check in against_limits.ranked(reader) if isinstance(check.share, Number)), None)
    if first is None or not isinstance(first.share, Number):
        return ""
    words = f"{first.what}: {first.share.text} % of its limit is used."
    steps = against_limits.steps(reader)[:_STEPS]
    return words + (f" Next: {'; '.join(steps)}." if steps else "")


def _catalogue(reader: Reader) -> str:
    """Both lives, and the largest factors between them."""
    known = {life.key: life for life in lives.lives(reader)}
    chosen, catalogue = next((life for life in known.values() if life.chosen), None), known.get("catalogue")
    if chosen is None or catalogue is None:
        return ""
    pair = [life.hours if isinstance(life.hours, Number) else life.turns for life in (catalogue, chosen)]
    words = f"ISO 281 gives {_text(pair[0])}, this case {_text(pair[1])} ({chosen.name})."
    stages = (reader.attributes.get("catalogue_life") or {}).get("stages", ())
    steps = [(stage["name"], stage["factor"]) for stage in stages if stage["factor"]]
    steps.sort(key=lambda step: -abs(log(step[1])))
    if steps:
        told = "; ".join(f"{name}, × {factor:.3g}" for name, factor in steps[:_LARGEST])
        return f"{words} Largest factors between them, each after those before it in the chain: {told}."
    why = (
        "loads of all rolling elements count, with clearance, profile, tilt and rings; ISO 281 has one load P"
    )
    return f"{words} Between them: {why}."


def _assumed(reader: Reader) -> str:
    """How many inputs are not known, what they make of the main results, and which matter most."""
    counts = [len(reader.attributes[mark]) for mark in ("assumed", "calibrated")]
    words = f"{counts[0]} inputs are assumed, {counts[1]} fitted, each marked in the table of inputs."
    for label, mark in (("Assumed", "assumed"), ("Fitted", "calibrated")):
        names = [assumptions.named(key).partition(" (")[0] for key in reader.attributes[mark]]
        words += f" {label}: {', '.join(names)}." if names else ""
    results = [(combined.LIFE, "life"), *((word, word) for word in dict(reader.layout.weighed).values())]
    told = []
    for word, label in results:
        if (span := combined.of(reader, word)) is not None:
            low, high = (f"{value:.3g}" for value in span.squares)
            told.append(f"{label} {low} to {high} times, most by {assumptions.named(span.most)}")
    chosen = assumed_effects.keys(reader, CHOICE)
    also = f" and choices of the case ({', '.join(chosen)})" if chosen else ""
    words += f" Inputs that are not exactly known{also} make together: {'; '.join(told)}." if told else ""
    return words + _heavier(reader)


def _heavier(reader: Reader) -> str:
    """The life under a tenth more load, for comparison; empty where it was not computed."""
    found = reader.attributes.get("assumed_effects") or {}
    name = assumed_effects.ranked_by(reader) if found else ""
    for key in (key for key in found.get("keys", ()) if key.get("role") == COMPARISON and name in LIVES):
        ratios = [
            each["values"][name] / found["of"][name] for each in key["others"] if name in each["values"]
        ]
        if ratios:
            load = key["key"].rpartition(".")[2].replace("_", " ")
            return f" For comparison: 10 % more {load} makes the life {min(ratios):.3g} times."
    return ""


def _exact(reader: Reader) -> str:
    """Numerical errors of the main results, and what is larger than them."""
    first = next((life for life in lives.lives(reader) if life.chosen), None)
    found = {} if first is None else {first.name: first.error}
    for entry in reader.layout.summary:
        ignored = of_supports(entry) and len(reader.blocks) < 2
        if (
            entry.error
            and entry.error != "life"
            and not ignored
            and (error := exactness.known(reader, entry))
        ):
            found.setdefault(entry.label.strip(), error)
    told = [
        f"{label} {_percent(error)}{' points' * (label == SLIP)}"
        for label, error in found.items()
        if isinstance(error, Number)
    ]
    if told:
        words = f"Numerical errors, from the exact answer of this model: {', '.join(told)}."
    else:
        words = "Closed formulas, without a grid: only the balance of forces has an error."
    return f"{words} {_MODEL}"


def _percent(error: Number) -> str:
    """An error in percent, without digits that nobody needs."""
    return f"{error.text} %" if float(error.text) >= _TINY else f"below {_TINY:g} %"


def _clearance(reader: Reader) -> str:
    return " ".join(clearance.which(reader))


def _stiffness(reader: Reader) -> str:
    """Radial stiffnesses of the bearing, alone and with supports."""
    block = reader.blocks.get(reader.last, {})
    if "stiffness_matrix" not in block:
        return ""
    if "radial_stiffness" not in block:
        diagonal = (f"{axis} {_text(stiffness.entry(reader, row, row))}" for row, axis in enumerate("xyz"))
        return f"Of the bearing alone, along {', '.join(diagonal)}. {_AXES} {_TANGENT}"

    def both(name: str) -> str:
        along, across = (reader.element(reader.last, name, row, row, digits=",.4g") for row in (1, 0))
        return f"{_text(along)} along z, {_text(across)} along y"

    words = (
        f"Bearing alone: {both('radial_stiffness')}: where the rotor model has shaft and supports of its own."
    )
    if stiffness.supported(reader):
        words += f" With supports: {both('total_radial_stiffness')}: where it has neither."
    else:
        words += " Rings, shaft and housing are rigid here: the rotor model must have its own."
    return f"{words} {_AXES} {_TANGENT}"


def _lubrication(reader: Reader) -> str:
    """Viscosity ratio and films against their usual aims."""
    kappa, films = lubrication.viscosity_ratio(reader), lubrication.films(reader)
    words = []
    if kappa is not None:
        judged = "Yes by" if float(kappa.text) >= 1 else "No by"
        words.append(f"{judged} the viscosity ratio κ: {kappa.text}, usual aim at least 1.")
        if "lubricant.inlet_temperature" in reader.attributes["assumed"]:
            words.append("The oil temperature is assumed: κ at others stands under Life.")
    for race, film in films.items():
        ratio = lubrication.film_ratio(reader, race)
        if ratio is not None:
            words.append(f"Smallest film, {race} raceway: {_text(film)}, film ratio Λ {ratio.text}.")
        else:
            full = lubrication.needed_roughness(reader, race, lubrication.FULL_FILM)
            words.append(
                f"Smallest film, {race} raceway: {_text(film)}; Λ is 1 with a combined roughness of "
                f"{_text(film)}, and {lubrication.FULL_FILM} with {_text(full)}; the case gives none."
            )
    if "flooding" in {note["code"] for note in reader.attributes["notes"]}:
        words.append("Films are those of inlets full of oil; with little oil they are thinner.")
    return " ".join(words)


def _load(reader: Reader) -> str:
    """The most loaded rolling element, how many carry, and what azimuth and signs are."""
    shown, block = reader.result.family.report().elements, reader.blocks.get(reader.last, {})
    if shown is None or not block:
        return ""
    name = next(iter(shown.figures.values()))[0]
    symbols, loads = reader.layout[name].shape, np.asarray(block[name])
    races = [
        axis for axis, symbol in enumerate(symbols) if reader.layout.axis[symbol].entries[:1] == ("inner",)
    ]
    inner = loads[tuple(slice(1) if axis in races else slice(None) for axis in range(loads.ndim))]
    index = tuple(int(step) for step in np.unravel_index(np.argmax(inner), inner.shape))
    axis = symbols.index("Z")
    place, count = index[axis], loads.shape[axis]
    most = reader.element(reader.last, name, *index, digits=",.4g")
    at = reader.element(reader.last, shown.azimuth, place, digits=".1f")
    highest = inner.max(axis=tuple(other for other in range(inner.ndim) if other != axis))
    carry = reader.summary[reader.last].get("loaded_rollers", int(np.count_nonzero(highest > 0)))
    which = f"{shown.word.capitalize()} {place + 1} of {count}, at azimuth {_text(at)}"
    return f"{which}, bears most: {_text(most)} at the inner raceway. {carry} carry load. {_SIGNS}"


def _unchecked(reader: Reader) -> str:
    """What has no verdict: without a limit, or not computed."""
    checks = [check for check in against_limits.ranked(reader) if check.verdict.startswith(NOT_CHECKED)]
    computed = [check.what for check in checks if isinstance(check.value, Number)]
    others = [check.what for check in checks if not isinstance(check.value, Number)]
    told = []
    if computed:
        told.append(f"Computed, but without a limit in the case: {', '.join(computed)}.")
    if others:
        told.append(f"Not computed: {', '.join(others)}.")
    return " ".join([*told, "Compare these with the maker's data or by rules of your own."])
