"""From a TOML file and settings to a case in SI units."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any

from flexbearing import inputs
from flexbearing.case.belonging import foreign, without
from flexbearing.case.declarations import Declaration, find, toml
from flexbearing.case.family import Families
from flexbearing.case.head import Head, Source
from flexbearing.case.materials import values
from flexbearing.case.problems import BadCase, listed, nearest, quoted, refused, shown, validated
from flexbearing.case.quantity import Section
from flexbearing.case.text import LARGEST, Unreadable, setting_value, tables
from flexbearing.printable import excerpt

Overrides = Sequence[str] | Mapping[str, object]
LONGEST_NAME = 255  # characters of a file's name or path in a message
MOST_SETTINGS = 500  # about three times the keys of a case


def read(path: str | Path, overrides: Overrides, families: Families) -> Head:
    """Read a case file.

    Raises `BadCase`, one line for each problem: file, key, value found, what is allowed, nearest valid name.
    """
    file = Path(path)
    try:
        text = inputs.text(file, LARGEST)
    except Unreadable as problem:
        raise BadCase(f"{excerpt(str(path), LONGEST_NAME)}: {problem}") from problem
    return understood(text, file, overrides, families)


def understood(text: str, file: Path, overrides: Overrides, families: Families) -> Head:
    """Read the text of a case file, also where only that is left of it.

    Raises `BadCase` as `read`.
    """
    try:
        raw = tables(text)
    except Unreadable as problem:
        raise BadCase(f"{excerpt(file.name, LONGEST_NAME)}: {problem}") from problem
    return with_settings(raw, Source(str(file), text, _settings(overrides)), families)


def with_settings(raw: dict[str, Any], source: Source, families: Families) -> Head:
    """Read the tables of a case file with the settings of its source.

    Raises `BadCase` as `read`.
    """
    name, settings = excerpt(Path(source.path).name, LONGEST_NAME), source.overrides
    model = model_of(raw, settings, name, families)
    foreign_keys = foreign(raw, model)
    if settings:
        settings_applied(raw, settings, model, families)
        changed = {setting.partition("=")[0].strip() for setting in settings}
        foreign_keys = _leave_out_former_kinds(raw, foreign_keys, changed, model)
    raw.setdefault("title", excerpt(Path(source.path).stem, LONGEST_NAME))
    if foreign_keys:
        raise BadCase(listed(foreign_keys.items(), name, lambda item: refused(raw, *item)))
    case = validated(raw, name, model, families)
    _requiregiven(case, raw, name, families)
    case._source = source
    return case


def _leave_out_former_kinds(
    raw: dict[str, Any], before: Mapping[str, str], given: set[str], model: type[Section]
) -> dict[str, str]:
    """Leave out keys of the file that a setting made foreign, as `outer.kind=ring` does with bars.

    Returns those that stay: they were foreign before, or were set.
    """
    while True:  # what goes may have been what others belong to
        foreign_keys = foreign(raw, model)
        unused = {
            path: why
            for path, why in foreign_keys.items()
            if path not in before and not any(key == path or key.startswith(f"{path}.") for key in given)
        }
        if not unused:
            return foreign_keys
        import logging  # most cases need none

        log = logging.getLogger(__name__)
        for path, why in unused.items():
            without(raw, path)
            log.debug("%s of the file is left out: %s", shown(path), why)


def written(values: Mapping[str, object]) -> tuple[str, ...]:
    """Write values of keys as settings, "key=value"; None or an empty text takes a key out."""
    return tuple(f"{key}={'' if value in (None, '') else toml(value)}" for key, value in values.items())


def _settings(overrides: Sequence[str] | Mapping[str, object]) -> tuple[str, ...]:
    if isinstance(overrides, Mapping):
        overrides = written(overrides)
    if len(overrides) > MOST_SETTINGS or sum(map(len, overrides)) > LARGEST:
        raise BadCase(
            f"more than {MOST_SETTINGS} settings, or {LARGEST // 1024} KiB of them; write a case file"
        )
    return tuple(overrides)


def model_of(raw: Mapping[str, Any], settings: Sequence[str], file: str, families: Families) -> type[Head]:
    """Schema of the kind that a file or a setting names.

    Raises `BadCase` where there is no such kind.
    """
    kind = raw.get("kind", next(iter(families)))
    for setting in settings:
        key, _, value = setting.partition("=")
        if key.strip() == "kind":
            kind = value.strip().strip('"')
    inside = raw.get("bearing")
    named = inside.get("kind") if isinstance(inside, Mapping) and "kind" not in raw else None
    if isinstance(named, str) and named in families and named != kind:
        raise BadCase(
            f"{file}: [bearing] kind = {toml(named)} is in the wrong place: write it "
            "first in the file, above every [section]."
        )
    if isinstance(kind, str) and kind in families:
        return families[kind].case()
    allowed = " or ".join(map(toml, families))
    raise BadCase(f"{file}: kind = {quoted(kind)} is not allowed; it must be {allowed}.")


def settings_applied(
    raw: dict[str, Any], settings: Sequence[str], model: type[Head], families: Families = MappingProxyType({})
) -> None:
    """Put settings into the tables of a case file; `families` are those that messages name keys of."""
    for setting in settings:
        _override(raw, setting, model, families)


def _override(raw: dict[str, Any], setting: str, model: type[Head], families: Families) -> None:
    """Put a "key=value" setting into the raw case, or take a key out by "key="."""
    key, separator, value = setting.partition("=")
    key, named = key.strip(), f"setting {excerpt(setting)}"
    if not separator or not key:
        raise BadCase(
            f"{named}: a setting is KEY=VALUE, such as bearing.clearance=50 um; KEY= takes a key out"
        )
    declaration = find(key, model)
    if declaration is None and not key.startswith("calibrated."):
        raise BadCase(f"{named}: {shown(key)} is not a key of this case.{nearest(key, model, families)}")
    if value.strip():
        _put(raw, key, value.strip(), model, named)
    elif _given(raw, key):
        without(raw, key)


def _put(raw: dict[str, Any], key: str, value: str, model: type[Head], named: str) -> None:
    """Give a key a value; what a user sets is no longer assumed."""
    table, declaration = raw, find(key, model)
    *sections, name = _place(key)
    for depth, section in enumerate(sections, 1):
        above = find(".".join(sections[:depth]), model)
        table[section] = _opened(table.get(section, {}), above)
        table = table[section]
        if not isinstance(table, dict):
            raise BadCase(f"{named}: {section} is not a table in this case")
    try:
        table[name] = _value(value, declaration)
    except Unreadable as problem:
        raise BadCase(f"{named}: {problem}") from problem
    _no_longer_assumed(raw, key, replaced=bool(declaration and declaration.section))


def _opened(value: Any, declaration: Declaration | None) -> Any:
    """A table; that of a material by name where a setting changes one of its values."""
    table = declaration and declaration.section
    if table and isinstance(value, str) and value in table.by_name:
        return values(value, table.model_fields)
    return value


def _no_longer_assumed(raw: dict[str, Any], key: str, *, replaced: bool) -> None:
    """Take a key out of what is assumed or calibrated, and where its table was replaced all beneath it."""

    def kept(item: object) -> bool:
        return item != key and not (replaced and str(item).startswith(f"{key}."))

    if isinstance(raw.get("assumed"), list):
        raw["assumed"] = [item for item in raw["assumed"] if kept(item)]
    if isinstance(raw.get("calibrated"), dict):
        raw["calibrated"] = {item: what for item, what in raw["calibrated"].items() if kept(item)}


def _place(key: str) -> list[str]:
    """Tables down to a key; what [calibrated] holds are dotted keys themselves."""
    if key.startswith("calibrated."):
        return ["calibrated", key.removeprefix("calibrated.").strip('"')]
    return key.split(".")


def _value(text: str, declaration: Declaration | None) -> Any:
    """A choice as it stands, else what TOML makes of the text."""
    if declaration and text in declaration.choices:
        return text
    return setting_value(text)


def _requiregiven(case: Head, raw: Mapping[str, Any], file: str, families: Families) -> None:
    """Raise when `assumed` or `calibrated` names a key that the file does not give."""
    model = type(case)
    problems = [
        (table, key)
        for table, keys in (("assumed", case.assumed), ("calibrated", case.calibrated))
        for key in keys
        if find(key, model) is None or not _given(raw, key)
    ]

    def line(problem: tuple[str, str]) -> str:
        table, key = problem
        if find(key, model):
            return f'{table} names "{key}", which this case does not give.'
        return f'{table} names "{excerpt(key)}", which is not a key.{nearest(key, model, families)}'

    if problems:
        raise BadCase(listed(problems, file, line))


def _given(raw: Any, key: str) -> bool:
    for part in key.split("."):
        if not isinstance(raw, Mapping) or part not in raw:
            return False
        raw = raw[part]
    return True
