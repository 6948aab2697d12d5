"""What an engineer asks of a report first, answered in short lines, with where the rest stands."""

from collections.abc import Iterator, Sequence
from math import prod

from flexbearing.findings import DANGER, NOT_MET, OUTSIDE, USUAL
from flexbearing.findings.codes import PEAK_AT_ENDS
from flexbearing.findings.running import FULL_FILM, VISCOSITY_RATIO
from flexbearing.findings.strength import BARS
from flexbearing.quantities.effects import CHOICE, COMPARISON, LIVES
from flexbearing.report.html import (
    against_limits,
    assumed_effects,
    assumptions,
    beyond_range,
    clearance,
    combined,
    design_changes,
    exactness,
    finding_checks,
    headline,
    life,
    lives,
    lubrication,
    oil,
    shaft_tilt,
    stiffness,
)
from flexbearing.report.html.check import MISSED, Check, one, text_of, used
from flexbearing.report.html.document import Number, Table
from flexbearing.report.html.elements import most_loaded
from flexbearing.report.html.open_checks import rolls
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.sentences import load_axis, rounded
from flexbearing.report.html.units import printed
from flexbearing.report.rows import of_supports

CAPTION = "Short answers"
SLIP = "cage slip"  # in percent, with its error in percentage points
_TINY = 1e-3  # [%] error below which its size does not matter
_LARGEST, _STEPS = 4, 3  # limits, and things to do, that an answer names
BAR_STRESS, STIFFNESS, ALONG_Y = "bar stress", "stiffness", "stiffness along y"  # words of results
_MORE = "Cooler or more viscous oil raises κ; cleaner oil lengthens the life at the same κ."
_WORDS = {"bearing stiffness": "stiffness of the bearing alone"}
_SIGNS = (
    "Azimuth 0° is the z axis; the radial load of this case acts {}. Azimuths grow towards y, the way that a "
    "positive speed turns. Positive along a roller is +x; other signs are below the tables."
)
_AXES = "Axes: x along the shaft, z at azimuth 0°, y at 90°; forces are positive along them."
MISFITS = {  # by whether the bearing has balls; figures of the evidence pages
    False: "How far the model is from measurements is not known: nothing measured on roller bearings, loads, "
    "stiffness, slip or life, is among the comparisons of the evidence pages. With independent programs and "
    "closed formulas it agrees within 1 % in roller loads (Sjövall, Harris), 0.5 % in the life of ISO/TS "
    "16281, 1.5 % in elastic rings, and in cage slip within the digits of a closed formula. The one "
    "published computation of a bearing with flexible rings (Mao et al., 2016) is not met: here its largest "
    "load is 18 % and its cage slip 16 % lower, as it does not say which bars, widths and hold of the shaft "
    "it has.",
    True: "How far the model is from measurements: the evidence pages compare measured friction torques of "
    "slow ball bearings alone, which are missed by up to 24 %. With independent programs and closed formulas "
    "it agrees within 0.3 % in loads of balls (Sjövall, Harris) and 1 % in the life of ISO/TS 16281.",
}
_TANGENT = "Slopes at this load and speed; no damping."


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
            "Where does the load act, and which signs are used?",
            _load,
            f"[{_elements(reader)}](#elements), [drawings](#computed)",
        ),
        ("What was not checked?", _unchecked, "[Not checked here](#not-checked), [Limits](#limits)"),
    )
    rows = [
        (question, "\n".join(lines), where) for question, answer, where in asked
        if (lines := tuple(filter(None, answer(reader))))
    ]  # fmt: skip
    yield Table(CAPTION, ("question", "answer", "more in"), tuple(rows))


def _elements(reader: Reader) -> str:
    shown = reader.result.family.report().elements
    return f"{shown.word.capitalize()}s" if shown else "Elements"


def _safe(reader: Reader) -> Iterator[str]:
    """Which limits are kept, with what is used of them, and what has none."""
    checks = against_limits.ranked(reader)
    yield headline.judged(reader)
    for check in checks[:_LARGEST]:
        if isinstance(check.value, Number) and isinstance(check.share, Number):
            verdict = check.verdict.partition(":")[0]
            yield f"{check.what} {text_of(check.value)}, {check.limit}: {used(check)}, {verdict}."
    yield shaft_tilt.loads(reader)
    urgent = [f"{check.what} {text_of(value)}" for check, value in _without_limit(checks)]
    if urgent:
        yield f"Without a limit in the case, so compare with yours: {', '.join(urgent)}."


def _without_limit(checks: Sequence[Check]) -> list[tuple[Check, Number]]:
    """Values that may limit before all others, but have no limit in the case."""
    return [(check, check.value) for check in checks if check.urgent and isinstance(check.value, Number)]


def _first(reader: Reader) -> Iterator[str]:
    """What may come before all limits, the nearest limit, how far the life holds, the first things to do."""
    checks = against_limits.ranked(reader)
    shares = [check for check in checks if isinstance(check.share, Number)]
    unknown = _without_limit(checks)
    for check, value in unknown:
        words = f"{text_of(value)}{_moved(reader, check)}"
        yield f"Possibly first: {check.what} {words}; no strength is given."
        yield design_changes.of_bars(reader) if check.place == BARS else ""
    yield from _nearest([check for check in shares if check.grade != OUTSIDE], bool(unknown))
    yield headline.tight_end(reader)
    for check in (check for check in shares if check.broken and check.grade == OUTSIDE):
        yield f"Outside the range of a law, which is no limit of strength: {_shared(check)}."
    yield from (f"Next: {step}." for step in against_limits.steps(reader)[:_STEPS])


def _nearest(shares: Sequence[Check], unknown: bool) -> Iterator[str]:
    """The limit with the largest share; behind a usual one that is not kept, the nearest of the others.

    Limits of damage and usual minima are ranked together; where the nearest is a usual one, the nearest limit
    of damage follows by itself.
    """
    first = next(iter(shares), None)
    if first is None:
        return
    if not (first.broken and first.grade == USUAL):
        near = first.used > headline.HALF or unknown
        yield f"{'' if near else 'Nothing limits at this load; nearest: '}{_shared(first)}."
        return
    yield f"{MISSED[first.side]}: {one(first)}."
    kept = next((check for check in shares if not check.broken), None)
    if kept is not None:
        yield f"Nearest of the limits that are kept: {one(kept)}: {used(kept)}."
    damage = max(shares, key=lambda check: check.damage)
    if damage.damage and not (damage is kept and damage.grade == DANGER):
        yield f"Nearest limit of damage: {_damaging(damage)}."


def _damaging(check: Check) -> str:
    """How much of its limit of damage a check takes, also where it is held to a usual one."""
    return (
        _shared(check)
        if check.grade == DANGER
        else f"{check.what}: {check.damage:.0%} of the limit of damage"
    )


def _shared(check: Check) -> str:
    return f"{check.what}: {used(check)}"


def _moved(reader: Reader, check: Check) -> str:
    """What inputs that are not known make of the stress of the bars."""
    span = combined.of(reader, BAR_STRESS) if check.place == BARS else None
    if span is None:
        return ""
    low, high = (f"{value:.3g}" for value in span.squares)
    return f", {low} to {high} times that by {combined.inputs(reader, span.most)} and other inputs"


def _catalogue(reader: Reader) -> Iterator[str]:
    """Both lives, and the largest factors between them."""
    known = {each.key: each for each in lives.lives(reader)}
    chosen, catalogue = next((each for each in known.values() if each.chosen), None), known.get("catalogue")
    if chosen is None or catalogue is None:
        return
    pair = [each.hours if isinstance(each.hours, Number) else each.turns for each in (catalogue, chosen)]
    both = [_rounded(number) for number in pair]
    yield f"ISO 281 gives {both[0]}, this case {both[1]} ({chosen.name})."
    alike = known.get("catalogue modified")
    if alike is not None and chosen.key == "modified" and isinstance(alike.hours, Number):
        yield f"Like for like, with a_ISO at P, the catalogue's L10m is {_rounded(alike.hours)}."
    if steps := life.chain(reader):
        words = ", ".join(f"{name} × {factor:.4g}" for name, factor in steps)
        whole = prod(factor for _, factor in steps)
        together = f"; all together × {whole:.4g}" if len(steps) > 1 else ""
        yield f"Factors between them, the largest first: {words}{together}."
    if life.by_same_rating(reader) and not reader.attributes.get("catalogue_life"):
        yield (
            "Both lives are by the same C_r. The factor of the loads holds exponent 4 of slices instead of "
            f"10/3, λν, clearance and profile: `flexbearing life {reader.case_name}` splits it."
        )
    if bound := beyond_range.of_oil(reader):
        yield f"Neither life counts the oil: {bound}."


def _rounded(life: Number) -> str:
    """A life with the three digits that its range leaves at most; the tables have all."""
    return f"{rounded(life)} {printed(life.unit)}"


def _assumed(reader: Reader) -> Iterator[str]:
    """How many inputs are not known, what they make of the main results, and which matter most."""
    counts = [len(reader.attributes[mark]) for mark in ("assumed", "calibrated")]
    yield f"{counts[0]} inputs are assumed, {counts[1]} fitted, each marked in the table of inputs."
    for label, mark in (("Assumed", "assumed"), ("Fitted", "calibrated")):
        names = [assumptions.name(key) for key in reader.attributes[mark]]
        if names:
            yield f"{label}: {', '.join(names)}."
    chosen = assumed_effects.keys(reader, CHOICE)
    also = f" and choices of the case ({', '.join(chosen)})" if chosen else ""
    words = list(_moving(reader))
    if words:
        yield f"Inputs that are not exactly known{also} make together:"
        yield from words
    yield _heavier(reader)


def _moving(reader: Reader) -> Iterator[str]:
    """Each result with its range and the input that moves it most."""
    layout = reader.layout
    weighed = [word for _, word in (*layout.weighed, *layout.weighed_in_results) if word != combined.LIFE]
    for word in (combined.LIFE, *weighed):
        if (span := combined.of(reader, word)) is not None:
            low, high = (f"{value:.3g}" for value in span.squares)
            of = " with supports" * (word in (STIFFNESS, ALONG_Y) and stiffness.supported(reader))
            doubtful = word == combined.LIFE and beyond_range.of_upper_end(reader)
            end = " The verdict says why not to rely on its upper end." if doubtful else ""
            most = combined.inputs(reader, span.most)
            yield f"{_WORDS.get(word, word)}{of} {low} to {high} times, most by {most}.{end}".rstrip()
    if rolls(reader):
        yield f"{SLIP}: {_of_no_slip(reader)}."


def _of_no_slip(reader: Reader) -> str:
    """A range of a cage slip that is zero, of which there are no factors."""
    name = next((name for name, word in reader.layout.weighed if word == SLIP), "")
    return (
        assumed_effects.of_zero(reader, name)
        or "zero to the printed digit; outputs.assumed_effects = true computes a range in percent"
    )


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


def _exact(reader: Reader) -> Iterator[str]:
    """Numerical errors of the main results, and what is larger than them."""
    first = next((each for each in lives.lives(reader) if each.chosen), None)
    found = {} if first is None else {first.name: first.error}
    for entry in reader.layout.summary:
        ignored = of_supports(entry) and len(reader.blocks) < 2
        if (
            entry.error
            and entry.error != "life"
            and not ignored
            and (error := exactness.known(reader, entry))
        ):
            found.setdefault(reader.label(entry).strip(), error)
    words = [
        f"{label} {_percent(error).replace(' %', ' percentage points') if label == SLIP else _percent(error)}"
        for label, error in found.items()
        if isinstance(error, Number)
    ]
    if words:
        yield f"Numerical errors, from the exact answer of this model: {', '.join(words)}."
    else:
        yield "Closed formulas, without a grid: only the balance of forces has an error."
    if missing := beyond_range.left_out(reader):
        yield f"Neither in these errors nor in the range of the life: {'; '.join(missing)}."
    if PEAK_AT_ENDS & reader.codes:
        yield "Nor is the peak pressure at the ends of the rollers: see its note under Limits."
    yield MISFITS[reader.of_balls]


def _percent(error: Number) -> str:
    """An error in percent, without digits that nobody needs."""
    return f"{error.text} %" if error.size >= _TINY else f"below {_TINY:g} %"


def _clearance(reader: Reader) -> Iterator[str]:
    yield from clearance.which(reader)


def _stiffness(reader: Reader) -> Iterator[str]:
    """Radial stiffnesses of the bearing, alone and with supports, by what the rotor model has."""
    block = reader.blocks.get(reader.last, {})
    if "stiffness_matrix" not in block:
        return
    if "total_radial_stiffness" not in block:
        diagonal = (f"{axis} {text_of(stiffness.entry(reader, row, row))}" for row, axis in enumerate("xyz"))
        yield f"Of the bearing alone, along {', '.join(diagonal)}."
    else:
        yield from _by_rotor_model(reader)
    yield _stiffness_range(reader)
    yield f"{_AXES} {_TANGENT}"
    yield f"{stiffness.tilt_follows(reader)}{stiffness.of_matrix(reader)}"
    yield shaft_tilt.stiffness(reader)


def _stiffness_range(reader: Reader) -> str:
    """What inputs make of the stiffness along the load and along y; empty where that is not known."""
    known = {axis: combined.of(reader, word) for axis, word in (("the load", STIFFNESS), ("y", ALONG_Y))}
    words = [
        f"along {axis} {span.squares[0]:.3g} to {span.squares[1]:.3g} times"
        for axis, span in known.items()
        if span is not None
    ]
    of = ", with supports" * stiffness.supported(reader)
    if len(words) == 1:
        words.append("along y not known, outputs.assumed_effects = true computes it")
    return f"By inputs that are not exactly known{of}: {', '.join(words)}." if words else ""


def _by_rotor_model(reader: Reader) -> Iterator[str]:
    def both(name: str) -> str:
        along, across = (reader.element(reader.last, name, row, row, digits=",.4g") for row in (1, 0))
        return f"{text_of(along)} along z, {text_of(across)} along y"

    if not stiffness.in_series(reader):
        yield f"With supports, {both('total_radial_stiffness')}. {stiffness.NOT_IN_SERIES}"
        return
    yield f"Shaft and supports in the rotor model: bearing alone, {both('radial_stiffness')}."
    for part, has in stiffness.IN_MODEL.items():
        rows = [
            f"{text_of(number)} along {axis}" for axis, number in stiffness.with_one_support(reader, part)
        ]
        if rows:
            words = ", ".join(rows) + _ranged(reader, part)
            yield f"{has} only: with the support of the {part} ring, {words}."
    if stiffness.supported(reader):
        yield f"Neither in the rotor model: with supports, {both('total_radial_stiffness')}."
    else:
        yield "Rings, shaft and housing are rigid here: the rotor model must have its own."


def _ranged(reader: Reader, part: str) -> str:
    """What inputs make of the bearing in series with one support, along z; empty where that is not known."""
    words = {"total_stiffness": STIFFNESS, "stiffness": "bearing stiffness"}
    spans = {name: span.squares for name, word in words.items() if (span := combined.of(reader, word))}
    ends = stiffness.ends_in_series(reader, part, spans)
    return f", by inputs {ends[0]:.3g} to {ends[1]:.3g} times along z" if ends else ""


def _lubrication(reader: Reader) -> Iterator[str]:
    """Viscosity ratio and films against their usual minima."""
    yield from _viscosities(reader)
    for race, film in lubrication.films(reader).items():
        ratio = lubrication.film_ratio(reader, race)
        if ratio is not None:
            yield f"Smallest film, {race} raceway: {text_of(film)}, film ratio Λ {ratio.text}."
        else:
            full = text_of(lubrication.needed_roughness(reader, race))
            yield (
                f"Smallest film, {race} raceway: {text_of(film)}; Λ is 1 with a combined roughness of "
                f"{text_of(film)}, and {FULL_FILM:g} with {full}; the case gives none."
            )
    yield lubrication.flooded(reader)


def _viscosities(reader: Reader) -> Iterator[str]:
    """Viscosity against the one that is needed, and the temperature with enough of it."""
    kappa, both = (
        lubrication.viscosity_ratio(reader),
        (oil.viscosity(reader), oil.reference_viscosity(reader)),
    )
    if kappa is None:
        return
    known = [number for number in both if number is not None]
    enough_now = finding_checks.verdict(reader, VISCOSITY_RATIO.code) != NOT_MET
    of = f" = {text_of(known[0])} over {text_of(known[1])} needed" if len(known) > 1 else ""
    least = f"usual minimum {VISCOSITY_RATIO.limit:g}"
    yield f"{'Yes' if enough_now else 'No'} by the viscosity ratio κ: {kappa.text}{of}, {least}."
    enough, reached = oil.sufficient_at(reader)
    if enough is not None:
        yield f"κ is {VISCOSITY_RATIO.limit:g} with this oil at {enough} °C{oil.heated(reader, enough)}."
    elif not enough_now and reached < _celsius(reader):
        yield f"Cooling this oil to {reached} °C is not enough: it needs a thicker one."
    if "lubricant.inlet_temperature" in reader.attributes["assumed"]:
        yield "The oil temperature is assumed: κ at others stands under Life."
    yield (
        _MORE
        if enough_now
        else f"To improve it: {VISCOSITY_RATIO.action}.".format(share=VISCOSITY_RATIO.limit / kappa.size)
    )


def _celsius(reader: Reader) -> float:
    return reader.attributes["case_si"]["lubricant"]["inlet_temperature"] - 273.15 - 1


def _load(reader: Reader) -> Iterator[str]:
    """The most loaded rolling element, how many carry, and what azimuth and signs are."""
    most = most_loaded(reader, reader.last)
    if most is None:
        return
    which = f"{most.word.capitalize()} {most.number} of {most.count}, at azimuth {text_of(most.azimuth)}"
    yield f"{which}, carries most: {text_of(most.load)} at the inner raceway. {most.carrying} carry load."
    yield _SIGNS.format(load_axis(reader))


def _unchecked(reader: Reader) -> Iterator[str]:
    """What has no verdict: without a limit, or not computed."""
    checks = [check for check in against_limits.ranked(reader) if check.unchecked]
    computed = [check.what for check in checks if isinstance(check.value, Number)]
    others = [check.what for check in checks if not isinstance(check.value, Number)]
    if computed:
        yield f"Computed, but without a limit in the case: {', '.join(computed)}."
    if others:
        yield f"Not computed: {', '.join(others)}."
    yield "The table says who checks each, and with what."
