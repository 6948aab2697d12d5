"""The section [coupling]: how a bearing and its rings come to agree."""

from typing import Literal

from flexbearing.case.quantity import Section, key


class MethodsOfCoupling(Section):
    """How bearing and rings come to agree."""

    method: Literal["newton", "iqn-ils", "anderson", "aitken", "relaxed"] = key(
        "newton: bearing and rings in one system; the others solve them one after the "
        "other and correct the deviations by interface quasi-Newton (iqn-ils), Anderson mixing of the last "
        "twelve changes (anderson), Aitken relaxation (aitken) or constant relaxation (relaxed)",
        "newton",
    )
    fallback: bool = key("whether other methods are tried when one fails", True)
    tolerance: float = key(
        "largest load change over the largest load at convergence; newton also ends when the "
        "unbalanced force is below 1e-10 of the load",
        1e-8,
        ge=1e-16,
        le=1e-3,
    )
    max_iterations: int = key("limit of the iterations", 200, ge=1, le=100_000)
    relaxation: float = key(
        'fraction of the change taken over, method = "relaxed"',
        0.1,
        ge=1e-3,
        le=1,
        only=({"method": ("relaxed",)}, {"fallback": (True,)}),
    )
