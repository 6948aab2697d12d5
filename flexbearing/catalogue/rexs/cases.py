"""A case for each bearing of a gearbox model that can be computed."""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import accumulate, islice
from pathlib import Path

from flexbearing.case import BadCase
from flexbearing.case.read import LONGEST_NAME
from flexbearing.catalogue.designations import TABLE, designated
from flexbearing.catalogue.entries import ENTRIES, LIKES, MODELS
from flexbearing.catalogue.new import new
from flexbearing.catalogue.rexs import duty
from flexbearing.catalogue.rexs.bearings import (
    KINDS,
    OTHERS,
    Bearing,
    bearing,
    belongings,
    called,
    is_computable,
    kind_of,
)
from flexbearing.catalogue.rexs.file import read
from flexbearing.catalogue.rexs.missing import filled
from flexbearing.catalogue.rexs.parts import Model, Part
from flexbearing.catalogue.rexs.unused import around, kinds_not_read, unused_around
from flexbearing.files import BadOutput, require_outputs
from flexbearing.printable import enumerated, excerpt

SIZES = "bore", "outside", "width"
MOST = 100  # bearings of a model whose cases are written at once
MOST_KINDS = 20  # of components that are named
LONGEST = 4000  # characters of the names of what is not used
_PLAIN = re.compile(r"[A-Za-z0-9_-]{1,40}")

Tell = Callable[[str], None]


@dataclass(frozen=True)
class Order:
    """What is to be written of a model."""

    model: Path
    number: str | None  # of a component; all bearings without it
    given: Mapping[str, str]  # entries that count more than those of the model
    title: str
    source: str
    force: bool
    settings: Path  # folder of the user's own table of designations


def cases(file: Path, order: Order, tell: Tell) -> Iterator[tuple[Path, str]]:
    """Write the cases; of several bearings each has the number of its component behind the file's name.

    Raises `BadCase` where the file is no model of REXS 1.x, and where no case can be written of it;
    `BadOutput`, `NotStored` where a case cannot be written.
    """
    model = read(order.model)
    name = excerpt(str(order.model), LONGEST_NAME)
    if model.not_read:
        tell(f"{name}: not read: {enumerated([excerpt(each) for each in model.not_read])}")
    parts, left = _chosen(model, order.number, name)
    refused = [*_of_other_kinds(left)]
    places = _places(file, parts)
    require_outputs(places.values(), [order.model])
    count = 0
    for part in parts:
        try:
            found = bearing(model, part)
            ratings = _written(found, places[part.number], order, model.version, tell)
        except BadCase as problem:
            refused.append(f"{called(part)}: {' '.join(str(problem).splitlines())}")
        else:
            count += 1
            yield places[part.number], ratings
    for line in _not_used_around(model) if count else ():
        tell(line)
    if refused and count:
        tell("\n".join(f"no case for {each}" for each in refused))
    if not count:
        raise BadCase("\n".join(f"{name}: no case for {each}" for each in refused[:8]))


def case_file(model: Path) -> Path:
    """Name of the case of a model in the folder of work."""
    ending = max((each for each in MODELS if model.name.lower().endswith(each)), key=len, default="")
    return Path(f"{model.name[: len(model.name) - len(ending)]}.toml")


def _chosen(model: Model, number: str | None, name: str) -> tuple[list[Part], list[Part]]:
    """Bearings whose cases are wanted, and those of kinds that have none."""
    found = {part.number: part for part in model.parts.values() if part.kind in (*KINDS, *OTHERS)}
    if not found:
        raise BadCase(f"{name}: has no {' or '.join(KINDS)}.")
    if number is not None:
        if number not in found:
            listed = enumerated([called(part) for part in found.values()])
            raise BadCase(f"{name}: has no bearing {excerpt(number)}; there are {listed}.")
        return [found[number]], []
    computable = [part for part in found.values() if is_computable(part)]
    if len(computable) > MOST:
        listed = enumerated([called(part) for part in computable])
        raise BadCase(f"{name}: has more than {MOST} bearings; choose one by --rexs-bearing: {listed}.")
    return computable, [part for part in found.values() if not is_computable(part)]


def _of_other_kinds(parts: list[Part]) -> Iterator[str]:
    """Bearings that no case can be written for, kind by kind."""
    kinds: dict[str, list[str]] = {}
    for part in parts:
        kinds.setdefault(kind_of(part), []).append(called(part))
    for kind, listed in kinds.items():
        yield from _listed(kind, listed)


def _places(file: Path, parts: list[Part]) -> dict[str, Path]:
    """A file for each bearing; numbers that are no plain words are replaced by their place."""
    if len(parts) == 1:
        return {parts[0].number: file}
    endings = (
        part.number if _PLAIN.fullmatch(part.number) else f"bearing{place}"
        for place, part in enumerate(parts, 1)
    )
    return {
        part.number: file.with_name(f"{file.stem}-{ending}{file.suffix}")
        for part, ending in zip(parts, endings, strict=True)
    }


def _written(found: Bearing, file: Path, order: Order, version: str, tell: Tell) -> str:
    """Write the case of a bearing with its duty cycle; its ratings."""
    if not order.force and (there := [each for each in duty.places(file) if each.exists()]):
        raise BadOutput(f"{there[0]}: is there already; --force replaces it.")
    tabled = _tabled(found, file.parent, order.settings)
    known = _combined(found.like, tabled, found.options)
    options, assumed = filled(found.like, _combined(found.like, known, order.given), found.ratings)
    of_table = [name for name, text in tabled.items() if options.get(name) == text != found.options.get(name)]
    if lacking := [ENTRIES[name] for name in SIZES if name not in options]:
        raise BadCase(
            f"has no {', '.join(each.meaning for each in lacking)}; give "
            f"{', '.join(each.option for each in lacking)} with --rexs-bearing."
        )
    source = order.source or f"REXS {version}, {excerpt(order.model.name)}, component {found.name}"
    title = order.title or excerpt(found.designation)
    ratings = new(
        file, found.like, options,
        title=title, source=source, force=order.force, assumed=assumed,
    )  # fmt: skip
    cycle = duty.written(found, file, order.given, source)
    alone = (
        f"load and speed of load case {found.point + 1} of {len(found.points)}"
        if len(found.points) > 1
        else ""
    )
    words = [
        alone, cycle, found.side, *_listed(f"from {TABLE}", of_table),
        *_listed("assumed", assumed), *_listed("not used", found.not_used),
    ]  # fmt: skip
    tell(f"{found.name}: {'; '.join(filter(None, words))}")
    for line in _not_used(found.not_used_below):
        tell(f"  {line}")
    return ratings


def _not_used_around(model: Model) -> Iterator[str]:
    """Lines of what no case takes of all that is no bearing and belongs to none."""
    bearings = [part for part in model.parts.values() if part.kind in (*KINDS, *OTHERS)]
    of_bearings = {each.number for part in bearings for each in belongings(model, part)}
    parts = around(model, bearings, of_bearings)
    yield from _not_used(unused_around(model, bearings, parts))
    yield from _listed("not used", kinds_not_read(model, {*of_bearings, *(part.number for part in parts)}))


def _not_used(by_kind: Mapping[str, Iterable[str]]) -> Iterator[str]:
    """A line for each kind of component; REXS has few of bearings."""
    for kind, listed in islice(by_kind.items(), MOST_KINDS):
        yield from _listed(f"not used of {excerpt(kind)}", listed)
    if len(by_kind) > MOST_KINDS:
        yield f"not used: {len(by_kind) - MOST_KINDS} further kinds of components"


def _tabled(found: Bearing, *folders: Path) -> dict[str, str]:
    """Entries of the designation in a table, for a bearing without its sizes; none where no table has it."""
    if {*SIZES} <= {*found.options}:
        return {}
    row = designated(excerpt(found.designation), *folders) or {}
    if row.get("like") != found.like:
        return {}
    return {name: row[name] for name in LIKES[found.like].taken if name in row}


def _combined(like: str, options: Mapping[str, str], given: Mapping[str, str]) -> dict[str, str]:
    """Entries under those given, of which a clearance stands for classes and fits."""
    instead = LIKES[like].instead
    crossed = {"clearance"} if {*instead} & {*given} else {*instead} if "clearance" in given else set[str]()
    return {name: text for name, text in options.items() if name not in crossed} | dict(given)


def _listed(words: str, names: Iterable[str]) -> Iterator[str]:
    """Names one after the other, within a length."""
    listed = [*names]
    ends = accumulate(len(name) + 2 for name in listed)
    some = [name for name, end in zip(listed, ends, strict=True) if end <= LONGEST]
    left = len(listed) - len(some)
    if some:
        yield f"{words}: {', '.join(some)}{f' and {left} more' if left else ''}"
