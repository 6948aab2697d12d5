"""What an early end of a command says of the files that are complete."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def keeping(written: list[Path]) -> Iterator[None]:
    """Let an exception that ends a command early say which files are complete."""
    try:
        yield
    except BaseException as problem:  # only a note is added
        if written:
            problem.add_note(f"complete: {', '.join(map(str, written))}")
        raise
