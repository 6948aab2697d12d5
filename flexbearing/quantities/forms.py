"""Forms of JSON attributes: what a record holds, declared once for writer, reader and reference page."""

from collections.abc import Callable, Mapping
from dataclasses import MISSING, dataclass, field, fields
from typing import Any, Protocol, get_type_hints


class Form(Protocol):
    """What a value must be."""

    def problem(self, value: Any) -> str:
        """Say what is wrong with a value, after its place in the record; empty where nothing is."""
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

    def problem(self, value: Any) -> str:
        """Say what is wrong with a value."""
        return "" if type(value) in self.types else f" is {_shown(value)}; allowed is {self.words}"


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

    def problem(self, value: Any) -> str:
        """Say what is wrong with a value."""
        return "" if value in self.texts else f" is {_shown(value)}; allowed is {self.words}"


@dataclass(frozen=True)
class Anything:
    """Any JSON value."""

    words: str = "any value"

    def problem(self, value: Any) -> str:
        """Nothing is wrong with any value."""
        return ""


@dataclass(frozen=True)
class ListOf:
    """A list of values of one form."""

    form: Form

    @property
    def words(self) -> str:
        """The form for the reference page."""
        return f"[{self.form.words}, ...]"

    def problem(self, value: Any) -> str:
        """Say what is wrong with a value."""
        if not isinstance(value, list):
            return f" is {_shown(value)}; allowed is a list"
        for place, item in enumerate(value):
            if problem := self.form.problem(item):
                return f"[{place}]{problem}"
        return ""


@dataclass(frozen=True)
class Each:
    """An object with values of one form, under any names or under some of those that are listed."""

    name: str  # what the names are, "part"; or the names, "rigid or flexible"
    form: Form

    @property
    def words(self) -> str:
        """The form for the reference page."""
        return f"{{{self.name}: {self.form.words}, ...}}"

    def problem(self, value: Any) -> str:
        """Say what is wrong with a value."""
        if not isinstance(value, Mapping):
            return f" is {_shown(value)}; allowed is an object"
        names = self.name.split(" or ") if " or " in self.name else value
        for name, item in value.items():
            if name not in names:
                return f" has {_shown(name)}; allowed is {self.name}"
            if problem := self.form.problem(item):
                return f".{_short(name)}{problem}"
        return ""


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

    def problem(self, value: Any) -> str:
        """Say what is wrong with a value."""
        if not isinstance(value, Mapping):
            return f" is {_shown(value)}; allowed is an object"
        if self.empty and not value:
            return ""
        for name in self.fields:
            if name not in value:
                return f" has no {name}"
        for name, item in value.items():
            form = self.fields.get(name) or self.optional.get(name) or self.further
            if form is None:
                return f" has {_shown(name)}, which is not in the layout"
            if problem := form.problem(item):
                return f".{_short(name)}{problem}"
        return ""


def of_class(cls: type, **forms: Form) -> Record:
    """An object with the fields of a dataclass, those with a default optional; `forms` are of other types."""
    hints, every = get_type_hints(cls), fields(cls)
    form = {each.name: forms.get(each.name) or _OF_TYPES[hints[each.name]] for each in every}
    optional = {each.name for each in every if not each.default is each.default_factory is MISSING}
    return Record(
        {name: of for name, of in form.items() if name not in optional},
        {name: of for name, of in form.items() if name in optional},
    )


_OF_TYPES: dict[Any, Form] = {str: TEXT, float: NUMBER, float | None: NUMBER_OR_NULL}


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

    def problem(self, value: Any) -> str:
        """Say what is wrong with a value."""
        if problem := self.form.problem(value):
            return problem
        return "" if self.condition(value) else f" is not such {self.which}"


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
