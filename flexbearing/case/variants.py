"""Cases that differ from each other in the values of some keys, each read without its text being parsed."""

from collections.abc import Callable, Mapping
from copy import deepcopy
from dataclasses import dataclass
from functools import cache
from operator import attrgetter
from pathlib import Path
from typing import Any, TypeVar

from flexbearing.case.declarations import by_path, find
from flexbearing.case.family import Families
from flexbearing.case.head import Head, Source
from flexbearing.case.problems import BadCase
from flexbearing.case.quantity import Section
from flexbearing.case.read import LONGEST_NAME, with_settings, written
from flexbearing.case.text import Unreadable, tables
from flexbearing.printable import excerpt

MOST_KINDS = 1000  # variants by choices such as outer.kind that are kept
Table = TypeVar("Table", bound=Section)
Tree = dict[str, Any]  # names of keys and tables to dotted keys and such trees


@dataclass(frozen=True)
class _Read:
    """A case that was read in full: variants with the same choices differ from it in values alone."""

    case: Head
    changed: Tree  # keys that are values alone


class Variants:
    """Cases made of one file and other values of some keys, the same keys in every one.

    A case is equal to what `flexbearing.case.read` makes of the file with these values as settings. Only
    values that differ are read, and only tables that hold one are checked again; what decides which keys
    belong to the case, such as `outer.kind`, is read in full.
    """

    def __init__(
        self,
        path: Path,
        text: str,
        keys: tuple[str, ...],
        families: Families,
        settings: tuple[str, ...] = (),  # of every case, before its own values
    ):
        self.path, self.text, self.keys, self.settings = path, text, keys, settings
        self._families = families
        try:
            self._tables = tables(text)
        except Unreadable as problem:
            raise BadCase(f"{excerpt(path.name, LONGEST_NAME)}: {problem}") from problem
        self._validators: dict[str, Callable[[Any], Any]] = {}  # of keys on which no other one depends
        self._read: dict[str, _Read] = {}
        self._each = [attrgetter(key) for key in keys]

    def case(self, values: tuple[Any, ...]) -> Head:
        """Read one case."""
        given = self._given(values)
        near = self._read.get(self._choices(given))
        if near is None:
            return self._in_full(given)
        try:
            alone = [key for key, value in given.items() if key in self._validators and value != ""]
            read = {key: self._validators[key](given[key]) for key in alone}
            case = _with(near.case, near.changed, read, checked=True)
        except (ValueError, AssertionError):
            return self._in_full(given)  # which says what is wrong
        case._source = self._source(given)
        return case

    def in_si(self, case: Head) -> tuple[Any, ...]:
        """Values of the keys as a case of these variants has them, in SI units; None of a table it lacks."""
        return tuple(_value(case, each) for each in self._each)

    def known(self, values: tuple[Any, ...], in_si: tuple[Any, ...]) -> Head:
        """Make a case that was read before, in any process: nothing is parsed or checked again."""
        given = self._given(values)
        near = self._read.get(self._choices(given))
        if near is None:
            return self._in_full(given)
        case = _with(near.case, near.changed, dict(zip(self.keys, in_si, strict=True)), checked=False)
        case._source = self._source(given)
        return case

    def _given(self, values: tuple[Any, ...]) -> dict[str, Any]:
        both = zip(self.keys, values, strict=True)
        return {key: value for key, value in both if value is not None}

    def _in_full(self, given: Mapping[str, Any]) -> Head:
        raw = deepcopy(self._tables)
        case = with_settings(raw, self._source(given), self._families)
        alone = [key for key in self.keys if self._is_value_alone(key, type(case))]
        self._validators = {key: by_path(type(case))[key].reader for key in alone}
        if len(self._read) < MOST_KINDS:
            tree = _tree([key for key in alone if given.get(key, "") != ""])
            self._read.setdefault(self._choices(given), _Read(case, tree))
        return case

    def _source(self, given: Mapping[str, Any]) -> Source:
        return Source(str(self.path), self.text, (*self.settings, *written(given)))

    def _choices(self, given: Mapping[str, Any]) -> str:
        """Which keys are given or taken out, and values that decide which belong to the case, as a text."""
        alone = {key for key, value in given.items() if key in self._validators and value != ""}
        return repr([key if key in alone else (key, value) for key, value in given.items()])

    def _is_value_alone(self, key: str, model: type[Section]) -> bool:
        """Whether a key is a value in a table that stays, and no other key belongs to the case by it."""
        declaration = find(key, model)
        if declaration is None or declaration.section or "." not in key:
            return False
        if key in _read_apart(model):
            return False
        above = (*self.keys, *_deciding(model))
        return key not in _deciding(model) and not any(key.startswith(f"{other}.") for other in above)


@cache
def _deciding(model: type[Section]) -> frozenset[str]:
    """Keys and tables by which other keys belong to a case or not."""
    return frozenset(
        name if "." in name or not (table := item.path.rpartition(".")[0]) else f"{table}.{name}"
        for item in by_path(model).values()
        for choices in item.only
        for name in choices
    )


@cache
def _read_apart(model: type[Section]) -> frozenset[str]:
    """Keys that their tables read with more than the declarations say."""
    inside = {f"{item.path}.": item.section for item in by_path(model).values() if item.section}
    return frozenset(
        f"{path}{name}"
        for path, table in ({"": model} | inside).items()
        for validator in table.__pydantic_decorators__.field_validators.values()
        for name in validator.info.fields
    )


def _tree(keys: list[str]) -> Tree:
    tree: Tree = {}
    for key in keys:
        *above, name = key.split(".")
        table = tree
        for part in above:
            table = table.setdefault(part, {})
        table[name] = key
    return tree


def _with(table: Table, changed: Tree, values: Mapping[str, Any], *, checked: bool) -> Table:
    """A table with other values; every table on the way to one is checked again where that is requested."""
    update = {
        name: values[below]
        if isinstance(below, str)
        else _with(getattr(table, name), below, values, checked=checked)
        for name, below in changed.items()
    }
    copied = table.model_copy(update=update)
    if checked:
        for check in checks(type(table)):
            check(copied)
    return copied


@cache
def checks(model: type[Section]) -> tuple[Callable[[Section], Section], ...]:
    """What a table checks after its values were read, in its order."""
    validators = model.__pydantic_decorators__.model_validators.values()
    return tuple(each.func for each in validators if each.info.mode == "after")


def _value(case: Head, each: attrgetter) -> Any:
    try:
        return each(case)
    except AttributeError:
        return None
