"""From a study file to what is varied and what is wanted."""

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from flexbearing import inputs
from flexbearing.case.declarations import Declaration, find
from flexbearing.case.family import Families
from flexbearing.case.head import Head, next_to, value_at
from flexbearing.case.problems import BadCase, nearest, validated
from flexbearing.case.read import LONGEST_NAME, model_of, written
from flexbearing.case.text import LARGEST, Unreadable, tables
from flexbearing.printable import excerpt
from flexbearing.studies.file.axes import Axis, axes, require_crossable
from flexbearing.studies.file.sampled import Drawn, sampled
from flexbearing.studies.file.schema import Over, PlotTable, StudyFile
from flexbearing.studies.file.spectrum import Spectrum, spectrum
from flexbearing.studies.file.values import BadValues

_PLAIN_NAME = re.compile(r"[^./\\\x00-\x1f\x7f][^/\\\x00-\x1f\x7f]{0,99}")
Source = str | Path | Mapping[str, Any]  # of a study: its file, or the same as a dictionary
ENDS = "status", "message", "findings", "seconds"  # columns that every table has
_COLUMN = re.compile(rf"(?!(?:{'|'.join(ENDS)})$)[\w.]{{1,100}}")


@dataclass(frozen=True)
class CollectedOutput:
    """An output that becomes a column."""

    column: str  # its heading without the unit
    text: str  # such as "flexible.life_L10 [h]"


@dataclass(frozen=True)
class Study:
    """A study file that was read."""

    path: Path
    name: str  # of the outputs
    case: Path
    text: str  # of the case file
    kind: str  # of the case
    inputs: tuple[Path, ...]  # files that are read, which no output may replace
    axes: tuple[Axis, ...]  # crossed, the last one changes fastest
    collect: tuple[CollectedOutput, ...] | None  # None: every number of the summary
    search: bool = False  # whether other equilibria are searched
    drawn: Drawn | None = None  # distributions of the axis "variant"
    spectrum: Spectrum | None = None  # weights of the axis "duty", which is the last one
    plot: PlotTable | None = None  # what is drawn
    settings: tuple[str, ...] = ()  # "key=value" of every variant
    full: bool = False  # whether every variant has a result file
    final: bool = False  # without iterations

    @property
    def keys(self) -> tuple[str, ...]:
        """Keys of the case that are varied."""
        return tuple(key for axis in self.axes for key in axis.keys)

    def reading(self, *files: Path) -> "Study":
        """The same study with further files that no output may replace."""
        return replace(self, inputs=(*self.inputs, *files))


def read(source: Source, families: Families, case: Head | None = None) -> Study:
    """Read a study, from its file or as a dictionary, and the text of its case unless that is given.

    Raises `BadCase`, one line for each problem: file, key, value found, what is allowed, nearest valid name.
    """
    raw, file = flat_tables(source, "study", ("over", "sample", "duty", "set"))
    given = _validated(raw if case is None else {**raw, "case": case.source.path}, file)
    if not (given.over or given.sample or given.duty):
        name = excerpt(file.name, LONGEST_NAME)
        raise BadCase(f"{name}: [over], [sample] and [duty] are missing; a study has one of them.")
    return study_of(given, file, families, case)


def study_of(given: StudyFile, file: Path, families: Families, of: Head | None = None) -> Study:
    """A study from the keys of its file, with the text of its case, or `of` a case that was read.

    Raises `BadCase` as `read`.
    """
    case = file.parent / given.case if of is None else Path(of.source.path)
    text = _text(case) if of is None else of.source.text
    stated = _parsed(text, case, "case")
    fixed = given.set.model_extra or {}
    settings = (*(of.source.overrides if of else ()), *written(fixed))
    model = model_of(stated, settings, excerpt(case.name, LONGEST_NAME), families)
    find = partial(declared, model=model, families=families)
    found, drawn, weights = _axes(given, file, find)
    _require_apart(fixed, found, file, find)
    return Study(
        path=file,
        name=_name(given, file),
        case=case,
        text=text,
        kind=next(kind for kind, family in families.items() if family.case() is model),
        inputs=(
            *((file,) if file.suffix else ()),
            case,
            *(file.parent / table.file for table in (given.over, given.duty) if table and table.file),
            *([file.parent / given.duty.series] if given.duty and given.duty.series else []),
            *next_to(case, _file_names(stated, found, model)),
            *next_to(case, (value for key, value in fixed.items() if key in model.file_keys)),
        ),
        axes=found,
        collect=_collected(given.collect, file),
        search=given.search_equilibria,
        drawn=drawn,
        spectrum=weights,
        plot=given.plot,
        settings=settings,
        full=given.results != "table",
        final=given.results == "final",
    )


def _require_apart(
    fixed: Mapping[str, Any], found: Iterable[Axis], file: Path, find: Callable[[str], Declaration]
) -> None:
    """Refuse a key of [set] that is none, or varies."""
    varied = {key for axis in found for key in axis.keys}
    try:
        for key in fixed:
            find(key)
            if key in varied:
                raise BadValues(f"{key} is varied, too")
    except BadValues as problem:
        raise BadCase(f"{excerpt(file.name, LONGEST_NAME)}: [set] {problem}") from None


def _file_names(stated: dict[str, Any], found: Iterable[Axis], model: type[Head]) -> Iterator[Any]:
    """What the case and its variants have at keys that name files."""
    for key in model.file_keys:
        yield value_at(stated, key)
        for axis in (each for each in found if key in each.keys):
            place = axis.keys.index(key)
            yield from (row[place] for row in axis.rows)


def declared(key: str, model: type[Head], families: Families) -> Declaration:
    """Declaration of a key that may vary.

    Raises `BadValues` for a name that is no key, with the nearest one, and for kind.
    """
    declaration = find(key, model)
    if declaration is None:
        raise BadValues(f"{excerpt(key)} is not a key of the case.{nearest(key, model, families)}")
    if key == "kind":
        raise BadValues("kind is the same in every variant: other kinds have other keys and outputs")
    return declaration


def _parsed(text: str, file: Path, of: str) -> dict[str, Any]:
    try:
        return tables(text, of)
    except Unreadable as problem:
        raise BadCase(f"{excerpt(file.name, LONGEST_NAME)}: {problem}") from problem


def _text(file: Path) -> str:
    try:
        return inputs.text(file, LARGEST)
    except Unreadable as problem:
        raise BadCase(f"{excerpt(str(file), LONGEST_NAME)}: {problem}") from problem


def flat_tables(source: Source, of: str, names: Collection[str]) -> tuple[dict[str, Any], Path]:
    """Tables of a file or a dictionary, and its name; in those of some names the keys have dots.

    Raises `BadCase` where it cannot be read.
    """
    if isinstance(source, Mapping):
        raw, file = dict(source), Path(of)
    else:
        file = Path(source)
        raw = _parsed(_text(file), file, of)
    for name in names:
        if isinstance(raw.get(name), dict):
            raw[name] = dict(_dotted(raw[name], ""))
    return raw, file


def _dotted(table: Mapping[str, Any], prefix: str) -> list[tuple[str, Any]]:
    found: list[tuple[str, Any]] = []
    for key, value in table.items():
        inside = isinstance(value, dict) and value  # an empty table is refused as what stands at its key
        found += _dotted(value, f"{prefix}{key}.") if inside else [(f"{prefix}{key}", value)]
    return found


def _validated(raw: dict[str, Any], file: Path) -> StudyFile:
    name = excerpt(file.name, LONGEST_NAME)
    given = validated(raw, name, StudyFile, {})
    if given.over and given.sample:
        raise BadCase(f"{name}: [over] and [sample] are both there; a study has one of them.")
    return given


def _name(given: StudyFile, file: Path) -> str:
    name = file.stem if given.name is None else given.name
    if not _PLAIN_NAME.fullmatch(name):
        raise BadCase(
            f"{excerpt(file.name, LONGEST_NAME)}: name = {excerpt(name)} cannot be; it must be the beginning "
            "of names of files, at most 100 characters, without folders or a dot in front."
        )
    return name


def _axes(
    given: StudyFile, file: Path, find: Callable[[str], Declaration]
) -> tuple[tuple[Axis, ...], Drawn | None, Spectrum | None]:
    """Axes of all tables, that of the duty cycle last; distributions, and weights of the cycle."""
    where, drawn, weights, found = "over" if given.over else "sample", None, None, ()
    try:
        if given.over:
            found = _varied(given.over, file.parent, find)
        elif given.sample:
            axis, drawn = sampled(given.sample, find)
            found = (axis,)
        if given.duty:
            where = "duty"
            axis, weights = spectrum(given.duty, file.parent, find)
            found = (*found, axis)
        require_crossable(found)
    except BadValues as problem:
        raise BadCase(f"{excerpt(file.name, LONGEST_NAME)}: [{where}] {problem}") from None
    return found, drawn, weights


def _varied(over: Over, folder: Path, find: Callable[[str], Declaration]) -> tuple[Axis, ...]:
    table = None if over.file is None else folder / over.file
    found = axes(over.model_extra or {}, zipped=over.zip, table=table, find=find)
    if not found:
        raise BadValues(
            'names no key; give one or more, such as "operation.radial_load" = ["10 kN", "20 kN"].'
        )
    return found


def _collected(given: Mapping[str, str] | None, file: Path) -> tuple[CollectedOutput, ...] | None:
    """Columns of the table [collect]; whether there are such outputs is known with the case."""
    if given is None:
        return None
    for column in given:
        if not _COLUMN.fullmatch(column):
            raise BadCase(
                f"{excerpt(file.name, LONGEST_NAME)}: [collect] {excerpt(column)} cannot be a heading; it "
                f"must be a name of letters, digits, points and underscores, other than {', '.join(ENDS)}."
            )
    return tuple(CollectedOutput(column, text) for column, text in given.items())
