"""Tables, picture and page of a map."""

from collections.abc import Iterator
from itertools import islice, product
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexbearing.findings.load_limits import CONTACT_PRESSURE, STATIC_SAFETY
from flexbearing.findings.running import FILM_RATIO, PRESSED_ENDS, SHORT_LIFE
from flexbearing.report.figure import BLUE, ORANGE, Axis as DrawnAxis, Contour, Figure, Line, Rule, is_wide
from flexbearing.report.html.document import Document
from flexbearing.report.html.map import LEVEL, LIMIT, MapPlane, figures, of_map
from flexbearing.report.panels import picture as drawn
from flexbearing.studies.file import Axis
from flexbearing.studies.maps.axes import MapAxis
from flexbearing.studies.maps.solution import SolvedMap
from flexbearing.studies.table import Table
from flexbearing.studies.table.table import Column
from quasidynamic.contact.film.roughness import MIXED_FROM
from quasidynamic.maps.sheets import FINEST
from quasidynamic.outcome.rating_life import ROLLERS

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Page

STATE = "state"  # axis of the states of a point


def _level(value: float) -> Contour:
    """A value of what has no limit."""
    return Contour(value, LEVEL, 1.0)


def _limit(value: float) -> Contour:
    """From where, or below which, the bearing is in danger."""
    return Contour(value, LIMIT, 2.0)


CONTOURS = {
    "cage_slip [%]": tuple(map(_level, (0.1, 1.0, 10.0, 50.0))),
    "life_L10 [h]": (_limit(SHORT_LIFE.limit / 3600.0),),
    "peak_pressure.inner [MPa]": (_limit(CONTACT_PRESSURE.limit * ROLLERS / 1e6),),
    "static_safety": (_limit(STATIC_SAFETY.limit),),
    "minimum_lambda.inner": (_limit(FILM_RATIO.limit * MIXED_FROM),),
}
LIFE = "life"  # begins the names of lives, which have a level at each power of ten
DECADES = tuple(10.0**power for power in range(-3, 10))
PANELS = 8  # of a picture
PLANES = 5  # of a page, spread over the first axis of three


def rows(found: SolvedMap) -> Table:
    """A row for every state, and one for each point without any."""
    places = np.concatenate([found.solved.point, found.unsolved])
    order = np.argsort(places, kind="stable")
    number = np.concatenate([_numbers(found.solved.point), np.zeros(len(found.unsolved), int)])
    missing = np.full(len(found.unsolved), np.nan)
    outputs = {name: np.concatenate([values, missing])[order] for name, values in found.outputs.items()}
    stable = np.concatenate([found.solved.stable, np.zeros(len(found.unsolved), bool)])[order]
    columns = [
        _key(axis, values) for axis, values in zip(found.axes, _values(found, places[order]), strict=True)
    ]
    columns += [Column(STATE, "", number[order].tolist()), Column("stable", "", stable.astype(int).tolist())]
    columns += [_column(name, values) for name, values in outputs.items()]
    return Table(found.title, tuple(columns), ())


def arrays(found: SolvedMap) -> Table:
    """The same over the axes and the states of a point, NaN where there is no such state."""
    number = _numbers(found.solved.point) - 1
    most = int(number.max(initial=0)) + 1
    place = found.solved.point * most + number
    axes = [Axis(axis.key, (axis.key,), tuple((value,) for value in axis.numbers)) for axis in found.axes]
    axes.append(Axis(STATE, (STATE,), tuple((each + 1,) for each in range(most))))
    grids = product(*(range(len(axis.rows)) for axis in axes))
    along = np.array(list(grids)).T
    columns = [_key(axis, np.array(axis.numbers)[at]) for axis, at in zip(found.axes, along, strict=False)]
    columns.append(Column(STATE, "", (along[-1] + 1).tolist(), varied=True))
    outputs = {"stable": found.solved.stable.astype(float)} | found.outputs
    for name, values in outputs.items():
        padded = np.full(found.points * most, np.nan)
        padded[place] = values
        columns.append(_column(name, padded))
    return Table(found.title, tuple(columns), tuple(axes))


def folds(found: SolvedMap) -> Table:
    """Where sheets of stable states end, between two points of the map."""
    states, _ = found.solved.ends
    columns = [
        _key(axis, _at(axis, along)) for axis, along in zip(found.axes, found.folds.places.T, strict=True)
    ]
    columns.append(Column("located", "", found.folds.located.astype(int).tolist()))
    columns += [_column(name, values[states]) for name, values in found.outputs.items()]
    return Table(f"{found.title}, folds", tuple(columns), ())


def curves(found: SolvedMap) -> Table:
    """Fold curves point by point."""
    each = found.folds.curves
    places = np.concatenate([np.zeros((0, len(found.axes))), *(curve.places for curve in each)])
    columns = [_key(axis, _at(axis, along)) for axis, along in zip(found.axes, places.T, strict=True)]
    numbers = [number + 1 for number, curve in enumerate(each) for _ in curve.places]
    cusps = [int(cusp) for curve in each for cusp in curve.cusps]
    errors = [float(error) for curve in each for error in curve.errors]
    columns += [Column("curve", "", numbers), Column("cusp", "", cusps), Column("error", "steps", errors)]
    return Table(f"{found.title}, fold curves", tuple(columns), ())


def text(found: SolvedMap) -> str:
    """What was found, in lines."""
    return (
        "\n".join([f"{found.title}: {found.points} points between {found.raceways}", *_words(found)]) + "\n"
    )


def _words(found: SolvedMap) -> Iterator[str]:
    count = found.solved.stable_count
    yield f"{len(found.unsolved)} points not converged" if len(found.unsolved) else "every point converged"
    if found.several:
        yield (
            f"{found.several} points with several stable equilibria, up to {count.max()}: which of them a "
            "bearing is in depends on its history"
        )
        yield from _fold_words(found)
    else:
        yield "no point with several stable equilibria was found"
    unstable = int((~found.solved.stable).sum())
    if unstable:
        yield f"{unstable} unstable equilibria are in the table, marked"
    pressed = int((found.sliced_peak_error > PRESSED_ENDS.limit).sum())
    if pressed:
        yield (
            f"peak pressures are wrong in {pressed} of {len(found.sliced_peak_error)} states: "
            f"{PRESSED_ENDS.meaning}; {PRESSED_ENDS.action}"
        )
    if not found.solved.quiet:
        yield (
            f"the search still found other equilibria in its last rounds, of {found.solved.rounds}: "
            "there may be more"
        )


def _fold_words(found: SolvedMap) -> Iterator[str]:
    folds, missing = found.folds, int((~found.folds.located).sum())
    yield f"{len(folds.places)} places between points where stable equilibria end"
    if missing:
        yield (
            f"{missing} of them are not located as folds: the equilibrium loses its stability there, meets "
            f"another one, or its fold was not found; they are given to 1/{round(1 / FINEST)} of a step"
        )
    if folds.curves:
        cusps = sum(int(curve.cusps.sum()) for curve in folds.curves)
        yield f"{len(folds.curves)} fold curves, with {cusps} cusps"
    if folds.cut:
        yield f"{folds.cut} fold curves end within the map because they could not be followed further"


def picture(found: SolvedMap) -> "Page":
    """Picture of a map; of three axes at the middle of the first one."""
    what = f"All equilibria that were found, {found.raceways}"
    if len(found.axes) == 1:
        return drawn(found.title, what, [_states(found)])
    planes = _planes(found)
    plane = planes[len(planes) // 2]
    heading = f"{what}, {plane.name}" if plane.name else what
    return drawn(found.title, heading, [*islice(figures(plane), PANELS)], columns=2, size=(5.0, 3.6))


def _states(found: SolvedMap) -> Figure:
    """Every state over one key."""
    (axis,), (name, values) = found.axes, next(iter(found.outputs.items()))
    along, stable = np.array(axis.numbers)[found.solved.point], found.solved.stable
    points = [
        Line(along[some].tolist(), values[some].tolist(), words, colour, "", "circle", 3.0)
        for some, colour, words in ((stable, BLUE, "stable"), (~stable, ORANGE, "unstable"))
        if some.any()
    ]
    folds = [Rule(at, name="fold") for at in np.unique(_at(axis, found.folds.places[:, 0])).tolist()]
    x, y = (
        DrawnAxis(label, "log" if log else "linear")
        for label, log in ((axis.words, axis.logarithmic), (name, is_wide(values)))
    )
    return Figure("states", name, x, y, (*points, *folds))


COUNT = "stable equilibria"


def page(found: SolvedMap, name: str, csv: str) -> Document:
    """Page of a map."""
    planes = _planes(found) if len(found.axes) > 1 else ()
    danger = bool(len(found.unsolved)) or not found.solved.quiet
    return of_map(found.title, tuple(_words(found)), planes, danger, (name, csv))


def _planes(found: SolvedMap) -> list[MapPlane]:
    """Outputs over the last two axes; of three at some values of the first one."""
    shape = found.shape
    fields = {name: found.of_points(values)[1] for name, values in found.outputs.items()}
    count = found.solved.stable_count.reshape(shape)
    if (count != 1).any():
        first = next(iter(fields))
        fields = {first: fields[first], COUNT: count.astype(float)} | fields
    if len(shape) == 2:
        return [_plane(found, "", fields, _pieces(found), count)]
    pieces = _pieces(found)
    steps = np.unique(np.linspace(0, shape[0] - 1, PLANES).astype(int))
    return [
        _plane(
            found,
            f"{found.axes[0].words} {found.axes[0].numbers[step]:.6g}",
            {name: values[step] for name, values in fields.items()},
            pieces[(pieces[:, :, 0] == step).all(axis=1)][:, :, 1:],
            count[step],
        )
        for step in steps
    ]


def _pieces(found: SolvedMap) -> NDArray:
    """Both ends (n, 2, d) of each piece of the fold curves, in steps of the grid."""
    each = [np.stack([curve.places[:-1], curve.places[1:]], axis=1) for curve in found.folds.curves]
    return np.concatenate([np.zeros((0, 2, len(found.axes))), *each])


def _plane(
    found: SolvedMap, name: str, fields: dict[str, NDArray], pieces: NDArray, count: NDArray
) -> MapPlane:
    x, y = found.axes[-2:]
    ends = np.stack([_at(axis, pieces[..., number]) for number, axis in enumerate((x, y))], axis=-1)
    logarithmic = (x.logarithmic, y.logarithmic)
    of_fields = {heading: contours(heading) for heading in fields}
    missing = np.argwhere(count == 0)
    unsolved = np.stack([np.array(axis.numbers)[at] for axis, at in zip((x, y), missing.T, strict=True)], -1)
    return MapPlane(
        name, (x.words, y.words), x.numbers, y.numbers, fields, ends, logarithmic, of_fields, unsolved
    )


def contours(heading: str) -> tuple[Contour, ...]:
    """Limits and levels of an output."""
    known = CONTOURS.get(heading, ())
    limits = [each.value for each in known]
    decades = (level for level in DECADES if heading.startswith(LIFE) and level not in limits)
    return (*map(_level, decades), *known)


def _at(axis: MapAxis, steps: NDArray) -> NDArray:
    """Values of a key at steps of the grid, as models between two points have them."""
    return np.interp(steps, np.arange(len(axis.numbers)), axis.numbers)


def _numbers(points: NDArray) -> NDArray:
    """Number of each state at its point, from 1; points rise."""
    first = np.searchsorted(points, points)
    return np.arange(len(points)) - first + 1


def _values(found: SolvedMap, places: NDArray) -> Iterator[NDArray]:
    for axis, at in zip(found.axes, np.unravel_index(places, found.shape), strict=True):
        yield np.array(axis.numbers)[at]


def _key(axis: MapAxis, values: NDArray) -> Column:
    return Column(axis.key, axis.unit, values.tolist(), varied=True)


def _column(heading: str, values: NDArray) -> Column:
    name, _, unit = heading.partition(" [")
    return Column(name, unit.rstrip("]"), values.tolist())
