"""Keys that say how finely elastic rings with grooves are resolved."""

from collections.abc import Callable
from typing import Annotated, Any

from pydantic import AfterValidator
from pydantic_core import PydanticCustomError

from flexbearing.case.quantity import at_most, impossible, in_mm, key

PATCH = 0.06  # width over the ball diameter: a/sqrt(5) of steel balls at 2 to 2.5 GPa
ORDER, ORDER_IN_SPACE = 5, 3  # of elements on a section, and in a drawn solid
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
    words = f"polynomial order of the finite elements; by default {ORDER}, of a drawn solid {ORDER_IN_SPACE}"
    return key(words, None, example=ORDER, ge=2, le=8, only=only)


def mesh_size(only: Any) -> Any:
    """Largest size of the elements."""
    return key(
        "largest size of the elements; by default a quarter of the ball diameter",
        None,
        example="3 mm",
        gt=0,
        only=only,
    )


def patch(accuracy: Any, ball_diameter: float) -> float:
    """Standard deviation of the patches [m]."""
    return accuracy.patch_width or PATCH * ball_diameter


def require_patches(
    accuracy: Any, ball_diameter: float, half: float, keys: tuple[str, str], least: Callable[[float], str]
) -> None:
    """Raise unless patches fit on half the arc of a groove [m].

    Keys are the section of the accuracy and what ends the arc, of which `least` is said to leave a length.
    """
    (section, end), width = keys, patch(accuracy, ball_diameter)
    if SHORTEST * width <= half:
        return
    if accuracy.patch_width is not None:
        allowed = f"{at_most(half / SHORTEST)}, {1 / SHORTEST:g} of half an arc that ends by {end}"
        raise impossible(f"{section}.patch_width", allowed)
    needs = f"{section}.patch_width, by default {in_mm(width)}, needs that arc"
    raise impossible(end, f"{least(SHORTEST * width)}: {needs}")
