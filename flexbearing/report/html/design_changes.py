"""Changes of dimensions that lower the stress of the bars, of those whose effects are known."""

from collections.abc import Iterator

from flexbearing.report.html import assumptions
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import units_in_words

_STRESS, _STIFFNESS = "nominal_bar_stress", "total_stiffness"  # names of outputs
_PART = "outer."  # which has the bars
_WORTH, _MOST = 0.85, 3  # factor of the stress from which a change is reported, and how many are


def of_bars(reader: Reader) -> str:
    """A sentence with the changes that lower the stress most; empty where none is known."""
    stiffer = {(key, value): factor for key, value, factor in _factors(reader, _STIFFNESS)}
    lower = sorted(
        (factor, key, value) for key, value, factor in _factors(reader, _STRESS)
        if factor <= _WORTH
    )[:_MOST]  # fmt: skip
    changes = [
        f"{assumptions.named(key)} {units_in_words(value)}, {factor:.3g} times"
        + (f" (stiffness with supports {stiffer[key, value]:.3g} times)" if (key, value) in stiffer else "")
        for factor, key, value in lower
    ]
    return f"Lower by a change of design: {'; '.join(changes)}." if changes else ""


def _factors(reader: Reader, name: str) -> Iterator[tuple[str, str, float]]:
    """Dimensions of the part with other values, and an output with these over that of the case."""
    found = reader.attributes.get("assumed_effects")
    if not found:
        return
    base = found["of"].get(name)
    for each in (each for each in found["keys"] if base and each["key"].startswith(_PART)):
        for other in (other for other in each["others"] if name in other["values"]):
            yield each["key"], other["words"], other["values"][name] / base
