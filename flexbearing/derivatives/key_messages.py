"""What a person reads of keys while outputs are differentiated by them."""

from collections.abc import Iterator, Sequence

from flexbearing.derivatives.keys import Key
from flexbearing.progress import Report


def announced(keys: Sequence[Key], report: Report) -> Iterator[Key]:
    """Yield keys one by one, and tell how many are done: a key that changes a flexible ring takes seconds."""
    text = f"derivatives by {len(keys)} keys" if len(keys) != 1 else f"derivatives by {keys[0].path}"
    report.stage(text, 0.0)
    for number, key in enumerate(keys, 1):
        yield key
        report.stage(text, number / len(keys))
