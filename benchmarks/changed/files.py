"""A command line with its files, and changes of both."""

import csv
import os
import stat
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from io import StringIO
from pathlib import Path
from typing import Any

from tests.mutated_cases import written

Content = (
    bytes | dict[str, Any] | list[Any] | Callable[[], bytes]
)  # as it is, TOML, CSV, made when it is needed
SPECIAL = ("pipe", "folder", "null", "zero", "full", "loop", "nowhere")
_DEVICES = {"null": 3, "zero": 5, "full": 7}  # minor numbers of Linux, all of major number 1


@dataclass(frozen=True)
class Bundle:
    """Words of a command line, and files by their names."""

    words: tuple[str, ...]
    files: Mapping[str, Content]
    rewritten: tuple[str, ...] = ()  # files, or folders, that the command may write
    special: tuple[str, ...] = ()  # of SPECIAL: what is made beside the files

    def with_file(self, name: str, content: Content) -> "Bundle":
        """The same with another content of a file."""
        return replace(self, files={**self.files, name: content})


@dataclass(frozen=True)
class Change:
    """One change of a bundle."""

    what: str  # for people
    apply: Callable[[Bundle], Bundle]
    late: bool = False  # whether it damages text, which leaves no tables to change


@dataclass(frozen=True)
class ChangedFiles:
    """A bundle with its changes."""

    kind: str
    base: str
    bundle: Bundle
    mutations: tuple[Change, ...]

    @property
    def changed(self) -> Bundle:
        bundle = self.bundle
        for change in sorted(self.mutations, key=lambda change: change.late):
            bundle = change.apply(bundle)
        return bundle

    @property
    def story(self) -> str:
        return f"{self.base}: " + "; ".join(change.what for change in self.mutations)

    def without(self, mutation: Change) -> "ChangedFiles":
        return replace(self, mutations=tuple(item for item in self.mutations if item is not mutation))

    def put(self, folder: Path) -> list[str]:
        bundle = self.changed
        for name, content in bundle.files.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(rendered(content))
        for name in bundle.special:
            _make(folder / name)
        return [*bundle.words]

    def may_change(self, name: str) -> bool:
        return name.startswith(self.bundle.rewritten) if self.bundle.rewritten else False


def rendered(content: Content) -> bytes:
    """Content of a file."""
    if isinstance(content, bytes):
        return content
    if isinstance(content, dict):
        return written(content).encode(errors="surrogatepass")
    if isinstance(content, list):
        text = StringIO(newline="")
        csv.writer(text, lineterminator="\n").writerows(content)
        return text.getvalue().encode(errors="surrogatepass")
    return content()


def _make(path: Path) -> None:
    """A pipe, a folder, a device of its own (never the machine's, which a fault might replace) or a link."""
    name = path.name
    if name == "pipe":
        os.mkfifo(path)
    elif name == "folder":
        path.mkdir()
    elif name == "loop":
        path.symlink_to(name)
    elif name == "nowhere":
        path.symlink_to("missing")
    else:
        try:
            os.mknod(path, stat.S_IFCHR | 0o666, os.makedev(1, _DEVICES[name]))
        except PermissionError:  # only the superuser makes devices, and nobody else can replace one
            path.symlink_to(f"/dev/{name}")
