"""Keys that say how finely elastic rings with grooves are resolved."""

from typing import Annotated, Any

from pydantic import AfterValidator
from pydantic_core import PydanticCustomError

from flexbearing.case.quantity import key

PATCH = 0.06  # width over the ball diameter: a/sqrt(5) of steel balls at 2 to 2.5 GPa
SHORTEST = 2.5  # widths of a patch in half an arc: on a shorter one, stations are too close to each other


def _odd(number: int) -> int:
    if number % 2 == 0:
        raise PydanticCustomError("quantity", "{why}", {"why": "must be an odd number"})
    return number


Odd = Annotated[int, AfterValidator(_odd)]


def patch_width(only: Any) -> Any:
    """Width of the patches that stand for contacts."""
    return key(
        "standard deviation of the patches by which balls press on an elastic groove, without their "
        "half-space indentation; by default 0.06 of the ball diameter, as of contacts at 2 to 2.5 GPa",
        None,
        example="1 mm",
        gt=0,
        only=only,
    )


def stations(usual: int, only: Any) -> Any:
    """Number of patches along an arc."""
    return key(
        "contact angles at which patches are placed along each arc of an elastic groove, an odd number",
        usual,
        ge=3,
        le=15,
        only=only,
    )


def element_order(only: Any) -> Any:
    """Order of the finite elements."""
    return key("polynomial order of the finite elements", 5, ge=2, le=8, only=only)


def mesh_size(only: Any) -> Any:
    """Largest size of the elements."""
    return key(
        "largest size of the elements; by default a quarter of the ball diameter",
        None,
        example="3 mm",
        gt=0,
        only=only,
    )
