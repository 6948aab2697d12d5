"""Cases that differ from each other in the values of some keys, each read without its text being parsed."""

from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from flexbearing.case.declarations import by_path, find
from flexbearing.case.excerpt import excerpt
from flexbearing.case.family import Families
from flexbearing.case.head import Head, Source
from flexbearing.case.problems import BadCase
from flexbearing.case.quantity import Section
from flexbearing.case.read import LONGEST_NAME, with_settings, written
from flexbearing.case.text import Unreadable, tables

MOST_KINDS = 1000  # variants by choices such as outer.kind whose tables are kept


@dataclass(frozen=True)
class _Read:
    """A variant that was read in full: others with the same choices differ from it in values alone."""

    raw: dict[str, Any]  # with its settings
    case: Head


class Variants:
    """Cases made of one file and other values of some keys, the same keys in every one.

    A case is equal to what `flexbearing.case.read` makes of the file with these values as settings. Only
    tables that hold a changed key are validated again; what decides which keys belong to the case, such
    as `outer.kind`, is read in full.
    """

    def __init__(self, path: Path, text: str, keys: tuple[str, ...], families: Families):
        self.path, self.text, self.keys = path, text, keys
        self._families = families
        try:
            self._tables = tables(text)
        except Unreadable as problem:
            raise BadCase(f"{excerpt(path.name, LONGEST_NAME)}: {problem}") from problem
        self._plain: frozenset[str] = frozenset()  # keys on which no other one depends
        self._read: dict[str, _Read] = {}

    def case(self, values: tuple[Any, ...]) -> Head:
        """Read one case.

        Parameters
        ----------
        values : tuple
            of the keys, in the words of a case file; None leaves a key as the file has it

        Returns
        -------
        Head
            the case model of its family, in SI units

        Raises
        ------
        BadCase
            as `flexbearing.case.read`
        """
        both = zip(self.keys, values, strict=True)
        given = {key: value for key, value in both if value is not None}
        near = self._read.get(self._choices(given))
        if near is None:
            return self._in_full(given)
        try:
            case = type(near.case).model_validate(_mixed(near.raw, near.case, self._nested(given)))
        except ValidationError:
            return self._in_full(given)  # which says what is wrong
        case._source = self._source(given)
        return case

    def _in_full(self, given: Mapping[str, Any]) -> Head:
        raw = deepcopy(self._tables)
        case = with_settings(raw, self._source(given), self._families)
        self._plain = frozenset(key for key in self.keys if self._is_value_alone(key, type(case)))
        if len(self._read) < MOST_KINDS:
            self._read.setdefault(self._choices(given), _Read(raw, case))
        return case

    def _source(self, given: Mapping[str, Any]) -> Source:
        return Source(str(self.path), self.text, written(given))

    def _choices(self, given: Mapping[str, Any]) -> str:
        """Which keys are given, and values that decide which keys belong to the case, as a text."""
        return repr([key if key in self._plain else (key, value) for key, value in given.items()])

    def _is_value_alone(self, key: str, model: type[Section]) -> bool:
        """Whether a key is a value in a table that stays, and no other key belongs to the case by it."""
        declaration = find(key, model)
        if declaration is None or declaration.section or "." not in key:
            return False
        above = (*self.keys, *_deciding(model))
        return key not in _deciding(model) and not any(key.startswith(f"{other}.") for other in above)

    def _nested(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """Values that differ, by dotted keys, as tables in each other."""
        nested: dict[str, Any] = {}
        for key in self._plain.intersection(given):
            *above, name = key.split(".")
            table = nested
            for part in above:
                table = table.setdefault(part, {})
            table[name] = given[key]
        return nested


@cache
def _deciding(model: type[Section]) -> frozenset[str]:
    """Keys and tables by which other keys belong to a case or not."""
    return frozenset(
        name if "." in name or not (table := item.path.rpartition(".")[0]) else f"{table}.{name}"
        for item in by_path(model).values()
        for choices in item.only
        for name in choices
    )


def _mixed(raw: Mapping[str, Any], validated: Section, changed: Mapping[str, Any]) -> dict[str, Any]:
    """Tables of a case: those without a changed key as they were validated, the others to be read."""
    mixed: dict[str, Any] = {}
    for name, value in raw.items():
        before = getattr(validated, name)
        if not isinstance(before, Section):
            mixed[name] = changed.get(name, value)
        elif name in changed:
            mixed[name] = _mixed(value, before, changed[name])
        else:
            mixed[name] = before
    return mixed
