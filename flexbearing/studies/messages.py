"""What people read of a study: its variants before, its progress, its end."""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import islice
from math import isinf, isnan, nan
from pathlib import Path
from time import perf_counter
from typing import Any

from flexbearing.case.problems import MOST
from flexbearing.files import require_folder_name
from flexbearing.findings.row import read, words
from flexbearing.printable import excerpt
from flexbearing.progress import Report
from flexbearing.studies.placement import RING, Cost, costs, expected
from flexbearing.studies.plan.task import CONVERGED
from flexbearing.studies.prepared_study import PreparedStudy, Progress
from flexbearing.studies.table import Table, duty
from flexbearing.studies.table.files import EXTRA, FORMS, PICTURE, SCATTER_PICTURE, missing

LONGEST = 300  # characters of the message of a row
LIFE_ERROR = "life error [%]"  # column of duty cycles with a target
ADVICE = "the next study condenses its rings again, FLEXBEARING_CACHE names another folder"


def variants(prepared: PreparedStudy) -> str:
    """The table of variants, what is wrong with each, and what there is to do."""
    plan = prepared.plan
    lines = [f"{number + 1}: {plan.settings(number)}" for number in range(min(MOST, len(plan.variants)))]
    if (more := len(plan.variants) + plan.unchecked - MOST) > 0:
        lines.append(f"... and {more} more")
    lines += map(plan.message_of, islice(plan.problems, MOST))
    columns = ", ".join(
        f"{column.column} [{column.unit}]" if column.unit else column.column for column in prepared.columns
    )
    return "\n".join([
        *lines,
        f"columns: {columns}",
        plan.count_of_problems or f"{len(plan.variants)} variants, all of them can be computed",
        _rings(prepared),
        *_choices(prepared),
        _expected(prepared),
    ])  # fmt: skip


def _rings(prepared: PreparedStudy) -> str:
    """How many rings of which kind."""
    counts = Counter(ring.race for ring in prepared.plan.rings())
    kinds = ", ".join(f"{count} {race}" for race, count in counts.items())
    return f"rings to condense: {kinds}, except those in the cache" if kinds else "no rings to condense"


def _choices(prepared: PreparedStudy) -> list[str]:
    """How often levels are chosen, where there is a target."""
    corners = prepared.plan.corners
    looked_at = sum(len(each.variants) for each in corners)
    return [f"levels for accuracy.target: {len(corners)} choices, at {looked_at} variants"] if corners else []


def _expected(prepared: PreparedStudy) -> str:
    """Expected time by a rule that is said with it."""
    plan = prepared.plan
    elastic, rigid = map(_of_a_variant, (costs(plan)[True], costs(plan)[False]))
    together = "solved side by side" if plan.side_by_side else "in a run of its own"
    search = ", without the search for other equilibria" if prepared.study.search else ""
    return (
        f"expected time: about {duration(expected(plan))} on one core{search} ({RING:g} s a ring; a variant "
        f"{together} {elastic} between elastic rings, {rigid} between rigid ones)"
    )


def _of_a_variant(cost: Cost) -> str:
    """What a variant costs, and the task that it is in."""
    return f"{1e3 * cost.variant:g} ms" + (f" and {1e3 * cost.task:g} ms a task" if cost.task else "")


def status(prepared: PreparedStudy, folder: Path) -> str:
    """How far a study is, by its journal."""
    progress = prepared.progress(prepared.rows(require_folder_name(folder)))
    left = progress.total - progress.done
    return (
        f"{prepared.study.name}: {progress.total} variants, {progress.done} finished, "
        f"{progress.failed} of them failed, {left} not computed"
    )


def end(prepared: PreparedStudy, table: Table, folder: Path) -> str:
    """How a study ended, and where its table and picture are."""
    counts = Counter(table["status"].values)
    words = ", ".join(f"{count} {name}" for name, count in counts.most_common())
    lines = [f"{table.name}: {len(table)} variants: {words or 'this part has none'}"]
    if prepared.part:
        part = f"part {prepared.part.number} of {prepared.part.of}"
        return (
            f"{lines[0]}\n{part} is kept in {prepared.journal(folder)}; the study without --part gathers all"
        )
    lines += [*_noted(table), *(cycles(table.cycles) if table.cycles else [])]
    for suffix in FORMS:
        packages = missing(suffix)
        without = f", not written without {' and '.join(packages)}: {EXTRA}" if packages else ""
        lines.append(f"table: {folder / table.name}{suffix}{without}")
    lines += [f"picture: {folder / table.name}{PICTURE}"] if prepared.plot else []
    if table.scatter:
        lines += [*scatter(table), f"scatter: {folder / table.name}{SCATTER_PICTURE}, tables beside it"]
    return "\n".join(lines)


def _noted(table: Table) -> Iterator[str]:
    """How many converged rows have findings, of which codes, and those of the first."""
    rows = zip(table["status"].values, table["findings"].values, strict=True)
    noted = [(number, read(cell)) for number, (status, cell) in enumerate(rows, 1)
             if status == CONVERGED and cell]  # fmt: skip
    if noted:
        counts = Counter(each.code for _, found in noted for each in found)
        codes = ", ".join(f"{code} {count}" for code, count in counts.most_common())
        number, found = noted[0]
        first = f"the first is variant {number}: {excerpt(words(found), LONGEST)}"
        yield f"converged rows with findings: {len(noted)} ({codes}), {first}"


def cycles(lives: Table) -> list[str]:
    """Lines for each of the first duty cycles: lives with their kinds, what they lack, what they require."""
    keys = [column for column in lives.columns if column.varied]
    lines = []
    for number, row in enumerate(lives.rows[:MOST]):
        where = ", ".join(f"{column.heading} {column.values[number]}" for column in keys)
        lines.append(f"duty cycle{f' at {where}' if where else ''}: {'; '.join(_cycle(row))}")
    return lines


def _cycle(row: Mapping[str, Any]) -> Iterator[str]:
    """Parts of the line of a duty cycle."""
    yield _life(row)
    if not isinf(row["life [h]"]):
        yield from _basic_lives(row)
    yield f"mean speed {row['mean_speed [rpm]']:.6g} rpm"
    if not isnan(row.get("mean_load [N]", nan)):
        yield f"mean equivalent load (ISO 281) {row['mean_load [N]']:.5g} N"
    if not isnan(row.get("rating_life [h]", nan)) and row["kind"] != "catalogue L10":
        yield f"catalogue L10 life (C/P)^p{_hours(row['rating_life [h]'])}"
    if not isnan(row.get("required_rating [N]", nan)):
        yield f"required C {row['required_rating [N]']:.5g} N"
    if not isnan(row.get("binning_error [%]", nan)):
        yield f"error by bins of {row['series_rows']} rows about {row['binning_error [%]']:.2g} %"
    if row["message"]:
        yield row["message"]


def _life(row: Mapping[str, Any]) -> str:
    """The life of a duty cycle with its kind, or why there is none."""
    if isnan(row["life [h]"]):
        return f"no {row['kind']} life: {row['status']}"
    error = "" if isnan(row.get(LIFE_ERROR, nan)) else f" (error {row[LIFE_ERROR]:.2g} %)"
    without = " without the rows left out" if row["left_out_time_share [%]"] else ""
    return f"{row['kind']} life{_hours(row['life [h]'])}{error}{without}"


def _basic_lives(row: Mapping[str, Any]) -> Iterator[str]:
    """Lives of loads alone, which rows that are rated without an equilibrium do not have."""
    lives = {race: row[f"{race}_life [h]"] for race in duty.RACEWAYS}
    if any(map(isnan, lives.values())):
        if not isnan(row["life [h]"]):
            yield "no basic L10 life: rows by ratings, without an equilibrium, have none"
        return
    if "basic_life [h]" in row:
        yield f"basic L10 life by the loads of the rolling elements{_hours(row['basic_life [h]'])}"
    raceways = ", ".join(f"{race}{_hours(life)}" for race, life in lives.items())
    yield f"basic L10 life of each raceway: {raceways}"


def _hours(life: float) -> str:
    """A life [h] behind its name."""
    return ": no damage" if isinf(life) else f" {life:.6g} h"


def scatter(table: Table) -> Iterator[str]:
    """Percentiles of the first outputs, and which key to tighten first; what the prediction lacks."""
    outputs, keys, _ = table.scatter
    shares = keys.rows
    for row in outputs.rows[:MOST]:
        unit = f" {row['unit']}" if row["unit"] else ""
        percentiles = ", ".join(
            f"{name} {row[name]:.5g}{_between(row, name)}" for name in ("P10", "P50", "P90")
        )
        linear = row["linear_explains [%]"]
        agrees = (
            "" if isnan(linear) else f"; linear: P10 {row['linear_P10']:.5g}, P90 {row['linear_P90']:.5g}"
        )
        explains = "" if isnan(linear) else f", explains {linear:.3g} % of the variance"
        unsolved = f"; {row['unsolved']} rows without a number" if row["unsolved"] else ""
        yield f"{row['output']}{unit}: {percentiles}{agrees}{explains}{unsolved}"
        of_output = [share for share in shares if share["output"] == row["output"]]
        yield from _first_to_tighten(of_output)
    yield from table.missing


def _between(row: Mapping[str, Any], name: str) -> str:
    low, high = row[f"{name}_low"], row[f"{name}_high"]
    return "" if isnan(low) or isnan(high) else f" ({low:.5g} to {high:.5g})"


def _first_to_tighten(shares: Sequence[Mapping[str, Any]]) -> Iterator[str]:
    """The key whose scatter, halved, brings P10 and P90 nearest to each other."""
    known = [share for share in shares if not isnan(share["narrower [%]"])]
    if known:
        first = max(known, key=lambda share: share["narrower [%]"])
        total = "" if isnan(first["total"]) else f", total index {first['total']:.2g}"
        yield (
            f"  tighten first: {first['key']}; half its scatter brings P10 and P90 closer by "
            f"{first['narrower [%]']:.2g} %{total}"
        )


def duration(seconds: float) -> str:
    """A time in the unit that suits it."""
    for unit, size in (("h", 3600), ("min", 60)):
        if seconds >= 2 * size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds:.0f} s" if seconds >= 10 else f"{seconds:.2g} s"


class Checking:
    """Says how many variants are checked, and how long the others take once this is known."""

    def __init__(self, report: Report):
        self._report = report
        self._began, self._before = 0.0, 0  # of the first ones, for which workers start

    def __call__(self, checked: int, total: int) -> None:
        """Take note of how many variants are checked."""
        if not self._before:
            self._began, self._before = perf_counter(), checked
            return
        left = (perf_counter() - self._began) / (checked - self._before) * (total - checked)
        self._report.stage(f"check: {checked} of {total} variants, {duration(left)} left", checked / total)


def follow(report: Report) -> Callable[[Progress], None]:
    """What shows the progress of a study."""

    def tell(progress: Progress) -> None:
        condensed, rings = progress.rings
        if condensed < rings:
            words = f"elastic rings: {condensed} of {rings} condensed or resolved for the target"
            report.stage(words, condensed / rings)
        else:
            report.stage(_line(progress), progress.done / max(progress.total, 1))  # a part may be empty
        if progress.repeated and progress.done == progress.total:
            report.line(_line(progress))

    return tell


def _line(progress: Progress) -> str:
    left = "" if progress.left is None else f", {duration(progress.left)} left"
    tasks = f"{progress.repeated} task{'s' if progress.repeated > 1 else ''}"
    repeated = f", {tasks} repeated because a worker process died" if progress.repeated else ""
    return f"study: {progress.done} of {progress.total} variants, {progress.failed} failed{repeated}{left}"
