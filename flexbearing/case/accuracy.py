"""The key of an accuracy that is requested."""

from typing import Any

from flexbearing.case.quantity import key


def target(elements: str, only: Any = ()) -> Any:
    """Allowed error, for bearings of such rolling elements."""
    return key(
        f"allowed numerical error of the load of every {elements}, over the largest load, and of the life; "
        "what this table does not give is chosen for it, and the errors are estimated",
        None,
        example="1 %",
        gt=0,
        lt=1,
        only=only,
    )
