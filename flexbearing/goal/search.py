"""From a case and a wanted life to the change of each lever that reaches it, and of the best pair."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from math import hypot, isnan, log

from flexbearing.case import BadCase, Head
from flexbearing.case.family import Family
from flexbearing.derivatives.sensitivities import sensitivities
from flexbearing.derivatives.table import Slope
from flexbearing.goal.answer import Change, Changed, Goal
from flexbearing.goal.levers import Choice, Lever, Move, choices, levers
from flexbearing.goal.target import target
from flexbearing.goal.trials import Followed, Trials
from flexbearing.progress import Report
from flexbearing.runs.run_case import compared, reader

WEAK = 0.01  # of the life: levers that change it less are only named
CLOSE = 1e-3  # of the wanted life, by a run
PAIRED = 4  # the strongest levers, of which pairs are tried


def goal(case: Head, family: Family, life: str, report: Report) -> Goal:
    """Find what reaches a life: each lever alone, then pairs of the strongest.

    Raises `BadCase` for a text that is no life, and a case that has none.
    """
    result = compared(case, family)
    if result.attributes["status"] != "converged":
        raise BadCase(f"{case.source.path}: not converged: {result.attributes['message']}")
    trials = Trials(case, family, target(result, life), report)
    numbers, graded = _numbers(trials), _graded(trials)
    pairs = _pairs(trials, numbers, graded)
    singles = [*(_change(trials, each) for each in numbers), *(_nearest(each) for each in graded if each)]
    pair = min(
        (_change(trials, each) for each in pairs if each.reaches), key=lambda each: each.steps, default=None
    )
    verified = [_verified(trials, each) for each in singles]
    strong = [each for each in verified if not abs(log(each.life / trials.target.before)) <= WEAK]
    tried = {each.name for each in verified}
    still = [lever.key.path for lever in levers(case) if lever.key.path not in tried]
    weak = (*(each.name for each in verified if each not in strong), *still)
    return Goal(
        case.title, trials.target, tuple(sorted(strong, key=_order)), pair and _verified(trials, pair), weak
    )


@dataclass(frozen=True)
class _Tried:
    """A choice and how far it is from the wanted life."""

    choice: Choice
    distance: float


def _graded(trials: Trials) -> list[list[_Tried]]:
    """Other choices of each graded key that can be computed."""
    keys = choices(trials.case)
    flat = [choice for each in keys for choice in each]
    known = dict(zip(flat, trials.distances([choice.settings for choice in flat]), strict=True))
    return [[_Tried(choice, known[choice]) for choice in each if not isnan(known[choice])] for each in keys]


def _nearest(tried: Sequence[_Tried]) -> Change:
    """The next choice that reaches it, else the best one."""
    reaching = [each for each in tried if each.distance >= 0]
    if reaching:
        best = min(reaching, key=lambda each: each.choice.steps).choice
    else:
        best = max(tried, key=lambda each: each.distance).choice
    keys = (_chosen(best),)
    return Change(keys, best.settings, best.steps, bool(reaching), "" if reaching else "the best choice")


def _numbers(trials: Trials) -> list[Followed]:
    """Every number, followed to the side where the life improves."""
    found = levers(trials.case)
    ways = _by_derivative(trials, found)
    ways |= _by_trial(trials, [lever for lever in found if lever not in ways])
    moves = [(Move(((lever, side),)), gain) for lever, (side, gain) in ways.items() if lever.end(side) > 0]
    first = [-trials.start / gain for _, gain in moves]
    followed = trials.followed([move for move, _ in moves], first, [trials.start] * len(moves))
    return _better_sides(trials, {each.move.parts[0][0]: each for each in followed})


def _better_sides(trials: Trials, known: dict[Lever, Followed]) -> list[Followed]:
    """Levers that do not reach it on one side are looked at on the other: the life may rise further away."""
    short = [each.move.parts[0] for each in known.values() if not each.reaches]
    moves = [Move(((lever, -side),)) for lever, side in short if lever.end(-side) > 0]
    for other in trials.followed(moves, (), [trials.start] * len(moves)):
        lever = other.move.parts[0][0]
        if other.track.values[other.place] > known[lever].track.values[known[lever].place]:
            known[lever] = other
    return list(known.values())


def _by_derivative(trials: Trials, found: Sequence[Lever]) -> dict[Lever, tuple[float, float]]:
    """Side of each lever and gain of a step there, by the derivative of the life."""
    if trials.family.sensitivities is None or not found:
        return {}
    paths = {lever.key.path: lever for lever in found}
    try:
        table = sensitivities(trials.case, trials.family, [trials.target.text], list(paths), trials.report)
    except BadCase:  # a case without derivatives
        return {}
    longer = 1.0 if trials.target.wanted >= trials.target.before else -1.0
    slopes = [slope for slopes in table.by_output.values() for slope in slopes if isinstance(slope, Slope)]
    return {
        paths[slope.key.path]: (
            1.0 if slope.change * longer > 0 else -1.0,
            abs(slope.change) / trials.target.before,
        )
        for slope in slopes
    }


def _by_trial(trials: Trials, found: Sequence[Lever]) -> dict[Lever, tuple[float, float]]:
    """The same by a step to each side."""
    moves = [Move(((lever, side),)) for lever in found for side in (-1.0, 1.0) if lever.end(side) > 0]
    steps = [min(1.0, move.end()) for move in moves]
    distances = trials.distances([move.settings(step) for move, step in zip(moves, steps, strict=True)])
    ways: dict[Lever, tuple[float, float]] = {}
    for move, step, distance in zip(moves, steps, distances, strict=True):
        (lever, side), gain = move.parts[0], (distance - trials.start) / step
        if gain > ways.get(lever, (side, 0.0))[1]:  # not of NaN
            ways[lever] = side, gain
    return ways


def _pairs(trials: Trials, numbers: Sequence[Followed], graded: Sequence[Sequence[_Tried]]) -> list[Followed]:
    """Pairs of the strongest levers that a designer has, changed in the ratio of their gains.

    No lever goes further than alone.
    """
    free = [each for each in numbers if each.gain > 0 and not each.move.parts[0][0].given]
    strong = sorted(free, key=lambda each: -each.gain)[:PAIRED]
    next_choices = [each for tried in graded for each in tried if each.choice.steps == 1]
    better = sorted(next_choices, key=lambda each: -each.distance)[:PAIRED]
    moves, first, starts = [], [], []
    for one, other in combinations(strong, 2):
        gain = hypot(one.gain, other.gain)
        both = [(each.move.up_to(each.place).parts[0], each.gain / gain) for each in (one, other)]
        moves.append(Move(tuple((lever, side * share) for (lever, side), share in both)))
        first.append(-trials.start / gain)
        starts.append(trials.start)
    for tried in better:
        for each in strong if trials.start < tried.distance < 0 else ():
            moves.append(replace(each.move.up_to(each.place), choice=tried.choice))
            first.append(-tried.distance / each.gain)
            starts.append(tried.distance)
    return trials.followed(moves, first, starts)


def _change(trials: Trials, followed: Followed) -> Change:
    """What a search found."""
    move, place = followed.move, followed.place
    return Change(
        tuple(_changed(move, place)),
        move.settings(place),
        hypot(place, 1.0 if move.choice else 0.0),
        followed.reaches,
        "" if followed.reaches else _limit(trials, followed),
    )


def _changed(move: Move, place: float) -> Iterator[Changed]:
    if move.choice:
        yield _chosen(move.choice)
    for lever, steps in move.changes(place):
        before, after = lever.shown(0.0), lever.shown(steps)
        yield Changed(lever.key.path, lever.words(0.0), lever.words(steps), (before, after))


def _chosen(choice: Choice) -> Changed:
    """Another choice, shown by the last part of its words."""
    before, after = (words.rpartition(", ")[2] for words in (choice.before, choice.words))
    return Changed(choice.key, choice.before, choice.words, (before, after))


def _limit(trials: Trials, followed: Followed) -> str:
    """Why a lever goes no further."""
    track = followed.track
    if track.closed and followed.place == track.places[-1]:
        return trials.problems.get(followed.move.settings(track.end), "it cannot be computed")
    return "the end of what is tried" if followed.place >= track.end else "it falls beyond"


def _verified(trials: Trials, change: Change) -> Change:
    """A change with the life that a run of its case gives."""
    result = compared(reader(trials.case, trials.family)(change.settings), trials.family)
    if result.attributes["status"] != "converged":
        return replace(
            change, reaches=False, limit=f"a run does not converge: {result.attributes['message']}"
        )
    life = float(result[trials.target.text])
    return replace(change, life=life, reaches=change.reaches and trials.target.distance(life) > -CLOSE)


def _order(change: Change) -> tuple[bool, float]:
    """Changes that reach it by their steps, then the others by their lives."""
    return not change.reaches, change.steps if change.reaches else -change.life
