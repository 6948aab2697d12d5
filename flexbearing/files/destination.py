"""Where an output may go: settled before anything is computed."""

import stat
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from flexbearing.files.atomic import UNFINISHED, require_part


class BadOutput(ValueError):
    """A name that an output cannot or must not have."""


def require_output(path: str | Path, inputs: Iterable[str | Path] = ()) -> Path:
    """Settle where an output goes, and that it can be written there.

    Raises `BadOutput` with the reason in one line: a folder, an input or a link to it, a name that is kept
    for unfinished files or too long, a file or folder that cannot be written.
    """
    try:
        output = _behind_links(path)
        if output.is_dir():
            raise BadOutput(f"{path}: is a folder; give the name of a file in it.")
        if UNFINISHED in (output.suffix, Path(path).suffix):
            raise BadOutput(
                f"{path}: names ending in {UNFINISHED} are kept for unfinished files; choose another."
            )
        for other in inputs:
            if _same(output, Path(other)):
                raise BadOutput(f"{path}: is {other} itself, which is read here; choose another name.")
        require_folder(output.parent)
        if output.exists():
            _require_replaceable(output, path)
        require_part(output)
    except (OSError, ValueError, RuntimeError) as problem:  # too long, a loop of links, a NUL in the name
        if isinstance(problem, BadOutput):
            raise
        raise BadOutput(f"{path}: cannot be written: {_reason(problem)}.") from problem
    return output


def require_outputs(paths: Iterable[str | Path], inputs: Iterable[str | Path] = ()) -> list[Path]:
    """Settle where all outputs of a command go, before one of them is written.

    Raises `BadOutput` as `require_output`, and where links lead two outputs to one file.
    """
    given, settled = tuple(inputs), dict[Path, str | Path]()
    for path in paths:
        place = require_output(path, given)
        if place in settled:
            raise BadOutput(
                f"{path}: is {settled[place]} itself, which is written here, too; choose another name, or "
                "remove the link."
            )
        settled[place] = path
    return list(settled)


def require_folder_name(folder: str | Path) -> Path:
    """Settle which folder outputs go to, or would go to; it need not be there.

    Raises `BadOutput` for a name that no folder can have: too long, a loop of links, a NUL in it.
    """
    try:
        named = _behind_links(folder)
        with suppress(FileNotFoundError, NotADirectoryError):
            named.lstat()
    except (OSError, ValueError, RuntimeError) as problem:
        raise BadOutput(f"{folder}: no folder to write to: {_reason(problem)}.") from problem
    return named


def require_folder(folder: str | Path) -> Path:
    """Make a folder that outputs go to, where it is not there yet.

    Raises `BadOutput` if it cannot be made, or nothing can be written into it.
    """
    try:
        made = Path(folder)
        made.mkdir(parents=True, exist_ok=True)
        require_part(made / "output")
    except (OSError, ValueError) as problem:
        raise BadOutput(f"{folder}: no folder to write to: {_reason(problem)}.") from problem
    return made


def _behind_links(path: str | Path) -> Path:
    output = Path(path).resolve()
    if output.is_symlink():  # before Python 3.13 resolving it raises
        raise RuntimeError("its links lead back to themselves")
    return output


def _same(output: Path, other: Path) -> bool:
    try:
        return output == other.resolve() or output.samefile(other)
    except (OSError, ValueError, RuntimeError):  # one of them is not there, or no file can have its name
        return False


def _require_replaceable(output: Path, path: str | Path) -> None:
    mode = output.stat().st_mode
    if not stat.S_ISREG(mode):
        raise BadOutput(f"{path}: is there and is no file that could be replaced.")
    if not mode & (stat.S_IWUSR | stat.S_IWGRP | stat.S_IWOTH):  # os.access lets the superuser do all
        raise BadOutput(f"{path}: is write-protected; choose another name, or permit writing.")


def _reason(problem: Exception) -> str:
    return getattr(problem, "strerror", None) or str(problem)
