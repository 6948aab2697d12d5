"""Forms of JSON attributes: what a record holds, declared once for writer, reader and reference page."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol


class Form(Protocol):
    """What a value must be."""

    def problems(self, value: Any, where: str) -> Iterator[str]:
        """Say what is wrong with a value at a place of its record."""
        ...

    @property
    def words(self) -> str:
        """The form for the reference page."""
        ...


@dataclass(frozen=True)
class Simple:
    """A value of one of some types; a flag is no number."""

    words: str
    types: tuple[type, ...]

    def problems(self, value: Any, where: str) -> Iterator[str]:
        """Say what is wrong with a value."""
        if type(value) not in self.types:
            yield f"{where} is {_shown(value)}; allowed is {self.words}"


TEXT = Simple("text", (str,))
NUMBER = Simple("number", (int, float))
NUMBER_OR_NULL = Simple("number or null", (int, float, type(None)))
COUNT = Simple("whole number", (int,))
FLAG = Simple("true or false", (bool,))


@dataclass(frozen=True)
class OneOf:
    """One of some texts."""

    texts: tuple[str, ...]

    @property
    def words(self) -> str:
        """The form for the reference page."""
        return " or ".join(f'"{text}"' for text in self.texts)

    def problems(self, value: Any, where: str) -> Iterator[str]:
        """Say what is wrong with a value."""
        if value not in self.texts:
            yield f"{where} is {_shown(value)}; allowed is {self.words}"


@dataclass(frozen=True)
class Anything:
    """Any JSON value."""

    words: str = "any value"

    def problems(self, value: Any, where: str) -> Iterator[str]:
        """Nothing is wrong with any value."""
        yield from ()


@dataclass(frozen=True)
class ListOf:
    """A list of values of one form."""

    form: Form

    @property
    def words(self) -> str:
        """The form for the reference page."""
        return f"[{self.form.words}, ...]"

    def problems(self, value: Any, where: str) -> Iterator[str]:
        """Say what is wrong with a value."""
        if not isinstance(value, list):
            yield f"{where} is {_shown(value)}; allowed is a list"
            return
        for place, item in enumerate(value):
            yield from self.form.problems(item, f"{where}[{place}]")


@dataclass(frozen=True)
class Each:
    """An object with values of one form, under any names or under some of those that are listed."""

    name: str  # what the names are, "part"; or the names, "rigid or flexible"
    form: Form

    @property
    def words(self) -> str:
        """The form for the reference page."""
        return f"{{{self.name}: {self.form.words}, ...}}"

    def problems(self, value: Any, where: str) -> Iterator[str]:
        """Say what is wrong with a value."""
        if not isinstance(value, Mapping):
            yield f"{where} is {_shown(value)}; allowed is an object"
            return
        names = self.name.split(" or ") if " or " in self.name else value
        for name, item in value.items():
            if name not in names:
                yield f"{where} has {_shown(name)}; allowed is {self.name}"
            yield from self.form.problems(item, f"{where}.{_short(name)}")


@dataclass(frozen=True)
class Record:
    """An object with named values, each of its own form."""

    fields: Mapping[str, Form]
    optional: Mapping[str, Form] = field(default_factory=dict)
    further: Form | None = None  # of all others; None: there are none
    empty: bool = False  # may hold nothing at all: not known yet, or not requested

    @property
    def words(self) -> str:
        """The form for the reference page."""
        pieces = [f"{name}: {form.words}" for name, form in self.fields.items()]
        pieces += [f"{name}?: {form.words}" for name, form in self.optional.items()]
        pieces += [f"...: {self.further.words}"] if self.further else []
        return f"{{{', '.join(pieces)}}}" + (" or {}" if self.empty else "")

    def problems(self, value: Any, where: str) -> Iterator[str]:
        """Say what is wrong with a value."""
        if not isinstance(value, Mapping):
            yield f"{where} is {_shown(value)}; allowed is an object"
            return
        if self.empty and not value:
            return
        yield from (f"{where} has no {name}" for name in self.fields if name not in value)
        for name, item in value.items():
            form = self.fields.get(name) or self.optional.get(name) or self.further
            if form is None:
                yield f"{where} has {_shown(name)}, which is not in the layout"
            else:
                yield from form.problems(item, f"{where}.{_short(name)}")


@dataclass(frozen=True)
class Such:
    """Values of a form that fulfil a condition."""

    form: Form
    condition: Callable[[Any], bool]  # asked of values of the form alone
    which: str  # "of which every block has the same factors"

    @property
    def words(self) -> str:
        """The form for the reference page."""
        return f"{self.form.words}, {self.which}"

    def problems(self, value: Any, where: str) -> Iterator[str]:
        """Say what is wrong with a value."""
        wrong = False
        for problem in self.form.problems(value, where):
            wrong = True
            yield problem
        if not wrong and not self.condition(value):
            yield f"{where} is not such {self.which}"


def _shown(value: Any) -> str:
    """A value in few characters, of any size."""
    if isinstance(value, str):
        return repr(value) if len(value) < 40 else f"{value[:40]!r}..."
    if isinstance(value, Mapping | list):
        return "an object" if isinstance(value, Mapping) else "a list"
    return repr(value)


def _short(name: str) -> str:
    shown = name if name.isprintable() else ascii(name)
    return shown if len(shown) < 40 else f"{shown[:40]}..."
