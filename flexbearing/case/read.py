"""From a TOML file and settings to a case in SI units."""

import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from flexbearing.case.belonging import foreign, without
from flexbearing.case.declarations import Declaration, find, toml
from flexbearing.case.family import Families
from flexbearing.case.head import Head, Source
from flexbearing.case.problems import BadCase, messages, nearest, refused, shown
from flexbearing.case.quantity import Section

Overrides = Sequence[str] | Mapping[str, object]


def read(path: str | Path, overrides: Overrides, families: Families) -> Head:
    """Read a case file.

    Parameters
    ----------
    path : path
        TOML file
    overrides : sequence of str or mapping
        settings that replace or add keys: "bearing.clearance=50 um", or {"bearing.clearance": "50 um"}
    families : mapping
        kind to family, the first that of a file which names none

    Returns
    -------
    Head
        the case model of its family, in SI units

    Raises
    ------
    BadCase
        one line for each problem: file, key, value found, what is allowed, nearest valid name
    """
    file = Path(path)
    return understood(_text(file), file, overrides, families)


def understood(text: str, file: Path, overrides: Overrides, families: Families) -> Head:
    """Read the text of a case file, also where only that is left of it.

    Parameters
    ----------
    text : str
        TOML
    file : Path
        where it stands, for messages
    overrides : sequence of str or mapping
        as for `read`
    families : mapping
        as for `read`

    Returns
    -------
    Head
        as `read`

    Raises
    ------
    BadCase
        as `read`
    """
    raw = _parsed(file, text)
    settings = _settings(overrides)
    model = _model(raw, settings, file.name, families)
    if settings:
        before = foreign(raw, model)
        for setting in settings:
            _override(raw, setting, model, families)
        changed = {setting.partition("=")[0].strip() for setting in settings}
        _leave_out_former_kinds(raw, before, changed, model)
    if foreign_keys := foreign(raw, model):
        raise BadCase("\n".join(f"{file.name}: {refused(raw, *item)}" for item in foreign_keys.items()))
    try:
        case = model.model_validate(raw)
    except ValidationError as error:
        raise BadCase("\n".join(messages(error, raw, file.name, model, families))) from None
    _require_given(case, raw, file.name, families)
    case._source = Source(str(file), text, settings)
    return case


def _leave_out_former_kinds(
    raw: dict[str, Any], before: Mapping[str, str], given: set[str], model: type[Section]
) -> None:
    """Leave out keys of the file that a setting made foreign_keys, as `outer.kind=ring` does with bars."""
    for path, why in foreign(raw, model).items():
        if path not in before and not any(key == path or key.startswith(f"{path}.") for key in given):
            without(raw, path)
            import logging  # most cases need none

            log = logging.getLogger(__name__)
            log.info("%s of the file is left out: %s", shown(path), why)


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise BadCase(f"{file}: there is no such file") from None
    except (OSError, UnicodeDecodeError) as problem:
        raise BadCase(f"{file}: cannot be read as text ({problem})") from None


def _parsed(file: Path, text: str) -> dict[str, Any]:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as problem:
        raise BadCase(f"{file.name}: is not valid TOML: {problem}") from None


def _settings(overrides: Sequence[str] | Mapping[str, object]) -> tuple[str, ...]:
    if isinstance(overrides, Mapping):
        return tuple(f"{key}={toml(value)}" for key, value in overrides.items())
    return tuple(overrides)


def _model(raw: Mapping[str, Any], settings: Sequence[str], file: str, families: Families) -> type[Head]:
    """Schema of the kind that the file or a setting names."""
    kind = raw.get("kind", next(iter(families)))
    for setting in settings:
        key, _, value = setting.partition("=")
        if key.strip() == "kind":
            kind = value.strip().strip('"')
    inside = raw.get("bearing")
    if "kind" not in raw and isinstance(inside, Mapping) and inside.get("kind") in set(families) - {kind}:
        raise BadCase(
            f"{file}: [bearing] kind = {toml(inside['kind'])} stands in the wrong place: write it "
            "first in the file, above every [section]."
        )
    if isinstance(kind, str) and kind in families:
        return families[kind].case()
    allowed = " or ".join(map(toml, families))
    raise BadCase(f"{file}: kind = {toml(kind)} is not allowed; it must be {allowed}.")


def _override(raw: dict[str, Any], setting: str, model: type[Head], families: Families) -> None:
    """Put a "key=value" setting into the raw case; what a user sets is no longer assumed."""
    key, separator, value = setting.partition("=")
    key = key.strip()
    if not separator or not key:
        raise BadCase(f"--set {setting}: a setting is KEY=VALUE, such as bearing.clearance=50 um")
    if find(key, model) is None and not key.startswith("calibrated."):
        raise BadCase(
            f"--set {setting}: {shown(key)} is not a key of this case.{nearest(key, model, families)}"
        )
    table = raw
    *sections, name = _place(key)
    for section in sections:
        table = table.setdefault(section, {})
        if not isinstance(table, dict):
            raise BadCase(f"--set {setting}: {section} is not a table in this case")
    table[name] = _value(value.strip(), find(key, model))
    if isinstance(raw.get("assumed"), list):
        raw["assumed"] = [item for item in raw["assumed"] if item != key]
    if isinstance(raw.get("calibrated"), dict):
        raw["calibrated"].pop(key, None)


def _place(key: str) -> list[str]:
    """Tables down to a key; what [calibrated] holds are dotted keys themselves."""
    if key.startswith("calibrated."):
        return ["calibrated", key.removeprefix("calibrated.").strip('"')]
    return key.split(".")


def _value(text: str, declaration: Declaration | None) -> Any:
    """Read a TOML value where it is one (20, true, "5 mm"), else take the text itself, as for a choice."""
    if declaration and text in declaration.choices:
        return text
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return text


def _require_given(case: Head, raw: Mapping[str, Any], file: str, families: Families) -> None:
    """Raise when `assumed` or `calibrated` names a key that the file does not give."""
    problems = []
    for table, keys in (("assumed", case.assumed), ("calibrated", case.calibrated)):
        for key in keys:
            if find(key, type(case)) is None:
                near = nearest(key, type(case), families)
                problems.append(f'{file}: {table} names "{key}", which is not a key.{near}')
            elif not _given(raw, key):
                problems.append(f'{file}: {table} names "{key}", which this case does not give.')
    if problems:
        raise BadCase("\n".join(problems))


def _given(raw: Any, key: str) -> bool:
    for part in key.split("."):
        if not isinstance(raw, Mapping) or part not in raw:
            return False
        raw = raw[part]
    return True
