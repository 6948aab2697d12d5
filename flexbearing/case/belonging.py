"""Which keys belong to the choices of a case: keys of another kind of part are refused, not ignored."""

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any

from flexbearing.case.declarations import Declaration, by_path, find, toml
from flexbearing.case.quantity import GIVEN, Section

Raw = Mapping[str, Any]


def foreign(raw: Raw, model: type[Section]) -> dict[str, str]:
    """Keys of a raw case that belong to another choice than the one made."""
    foreign_keys: dict[str, str] = {}
    stated = set(_stated(raw))
    for item in _of_choices(model):
        if item.path not in stated or any(item.path.startswith(f"{table}.") for table in foreign_keys):
            continue
        broken = [_broken(choices, item, raw, model) for choices in item.only]
        if all(broken):
            foreign_keys[item.path] = f"it belongs {belonging(item, 'to')}; this case has {broken[0]}"
    return foreign_keys


@cache
def _of_choices(model: type[Section]) -> list[Declaration]:
    """Keys and tables of a schema that belong to some choices only, in its order."""
    return [item for item in by_path(model).values() if item.only]


def _stated(raw: Raw, prefix: str = "") -> Iterator[str]:
    """Yield keys and tables that a raw case gives."""
    for name, value in raw.items():
        if value is not None:
            yield f"{prefix}{name}"
            if isinstance(value, Mapping):
                yield from _stated(value, f"{prefix}{name}.")


def belonging(item: Declaration, word: str) -> str:
    """Choices that a key belongs to, each after a word: `with outer.kind = "ring"`; empty for one of all."""
    return ", or ".join(
        f"{word} {' with '.join(_named(key, values) for key, values in _absolute(choices, item))}"
        for choices in item.only
    )


def chosen(item: Declaration) -> str:
    """The same with the names of keys of the same table alone, `kind = "ring"`."""
    return ", or ".join(
        " with ".join(_named(key, values) for key, values in choices.items()) for choices in item.only
    )


def _named(key: str, values: tuple) -> str:
    if values == GIVEN:
        return f"a given {key}"
    *others, last = map(toml, values)
    return f"{key} = {', '.join(others)} or {last}" if others else f"{key} = {last}"


def _absolute(choices: Mapping[str, tuple], item: Declaration) -> Iterator[tuple[str, tuple]]:
    """Choices by dotted keys; a name without a dot is a key of the same table."""
    table = item.path.rpartition(".")[0]
    for key, values in choices.items():
        yield (key if "." in key or not table else f"{table}.{key}"), values


def _broken(choices: Mapping[str, tuple], item: Declaration, raw: Raw, model: type[Section]) -> str:
    """What the case says instead of the first choice that is not met; empty where all are met."""
    for key, values in _absolute(choices, item):
        declaration, value = find(key, model), _value(raw, key)
        assert declaration is not None
        value = declaration.field.get_default() if value is None and values != GIVEN else value
        if value is None:
            return f"no {key}"
        if values == GIVEN:
            continue
        # a value that is no choice at all is reported elsewhere
        if value not in values and value in (declaration.choices or (True, False)):
            return f"{key} = {toml(value)}"
    return ""


def _value(raw: Any, path: str) -> Any:
    for part in path.split("."):
        if not isinstance(raw, Mapping) or part not in raw:
            return None
        raw = raw[part]
    return raw


def without(raw: dict[str, Any], path: str) -> None:
    """Take a key or table out of a raw case, also from what is assumed or calibrated."""
    *tables, name = path.split(".")
    inside = raw
    for table in tables:
        inside = inside[table]
    del inside[name]

    def kept(key: object) -> bool:
        return key != path and not str(key).startswith(f"{path}.")

    if isinstance(raw.get("assumed"), list):
        raw["assumed"] = [key for key in raw["assumed"] if kept(key)]
    if isinstance(raw.get("calibrated"), dict):
        raw["calibrated"] = {key: what for key, what in raw["calibrated"].items() if kept(key)}
