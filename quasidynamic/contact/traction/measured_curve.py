"""Traction curve drawn through four readable points of a measurement."""

from dataclasses import dataclass
from math import e, isfinite

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.traction.traction_law import Traction
from quasidynamic.errors import ImpossiblePart, require_positive


@dataclass(frozen=True, kw_only=True)
class FourPointCurve:
    r"""Traction coefficient as a function of the slide-to-roll ratio alone.

    .. math:: \mu(S) = (A + B S) e^{-C S} + D,\quad S = |u_s|/u

    It starts at mu0 = A + D, has its maximum at 1/C - A/B and falls to D. The signed law is

    .. math:: \frac{F}{q} = \operatorname{sgn}(s)\,[\mu(|s|) - \mu_0] + \mu_0 \frac{s}{\sqrt{s^2 + s_0^2}},
              \quad s = u_s/u

    with one continuous derivative: friction at rest mu0 is reached over the slip s0 (99 % at 7 s0).

    Source
    ------
    Four-coefficient curve of the quasi-dynamic bearing programs after Wang (2006); rule for the
    coefficients from readable points as in the ADORE-type programs.

    Valid
    -----
    Load, speed, temperature and film of the measurement; nothing in the law carries it elsewhere.
    """

    a: float  # [-] A, negative where the curve starts below its far value
    b: float  # [-] B
    c: float  # [-] C
    d: float  # [-] D, far value
    sign_slip: float = 1e-4  # [-] s0, slide-to-roll ratio over which mu0 changes its sign
    speed_floor: float = 1e-6  # [m/s] u is rounded to hypot(u, floor)

    def __post_init__(self):
        for name in ("c", "sign_slip", "speed_floor"):
            require_positive(f"curve.{name}", getattr(self, name))
        if not all(map(isfinite, (self.a, self.b, self.d))) or self.b < 0:
            raise ImpossiblePart(
                f"curve: a, b, d = {self.a!r}, {self.b!r}, {self.d!r} must be finite and b >= 0"
            )
        # a rounding error below zero is what fits through the origin leave
        if self.d < 0 or self.a + self.d < -1e-12:
            raise ImpossiblePart(
                f"curve: friction {self.a + self.d:.3g} at zero slip and {self.d:.3g} far off must be >= 0"
            )

    @classmethod
    def through(
        cls, *, at_rest: float, peak: float, peak_slip: float, far: float, sign_slip: float = 1e-4
    ) -> "FourPointCurve":
        r"""Curve through its start, its maximum and its far value.

        .. math:: D = \mu_\infty,\; A = \mu_0 - \mu_\infty,\; w e^{A/w - 1} = \mu_{max} - \mu_\infty,\;
                  B = (w - A)/S_{max},\; C = B/w

        with w = A + B S_max in closed form, w = (mu_max - mu_inf) exp(1 + W0(-A/[e (mu_max - mu_inf)])).

        Parameters
        ----------
        at_rest : float
            mu0 at zero slip [-], >= 0; zero for a fluid
        peak : float
            mu_max [-], above mu0 and mu_inf
        peak_slip : float
            S_max [-], slide-to-roll ratio of the maximum; a slip speed is divided by the rolling speed
        far : float
            mu_inf at large slip [-], >= 0
        sign_slip : float
            s0 [-], see the class

        Raises
        ------
        ImpossiblePart
            when no curve of this form has such points

        Source
        ------
        Rule of the ADORE-type programs; the solution by the Lambert function is derived here.

        Valid
        -----
        As the class.

        >>> curve = FourPointCurve.through(at_rest=0.0, peak=0.05, peak_slip=0.02, far=0.03)
        >>> round(1 / curve.c - curve.a / curve.b, 12)
        0.02
        """
        require_positive("curve: peak_slip", peak_slip)
        if not (0 <= at_rest < peak < float("inf") and 0 <= far < peak):
            raise ImpossiblePart(
                f"curve: peak = {peak!r} must be finite and above at_rest = {at_rest!r} and far = {far!r}, "
                "both >= 0; a curve without a maximum cannot be fitted"
            )
        from scipy.special import lambertw  # costly to import, and few cases draw this curve

        a, height = at_rest - far, peak - far
        w = height * np.exp(1 + lambertw(-a / (e * height)).real)
        b = (w - a) / peak_slip
        return cls(a=a, b=float(b), c=float(b / w), d=far, sign_slip=sign_slip)

    def coefficient(self, slip: NDArray) -> NDArray:
        """Unsigned mu [-] of the slide-to-roll ratio S >= 0, without the rounding at rest."""
        return (self.a + self.b * slip) * np.exp(-self.c * slip) + self.d

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Traction; the film does not enter this law."""
        speed = np.hypot(entrainment, self.speed_floor)
        slip = sliding / speed
        size = np.abs(slip)
        decay = np.exp(-self.c * size)
        rest = self.a + self.d
        rounded = np.hypot(slip, self.sign_slip)
        signed = np.sign(slip) * ((self.a + self.b * size) * decay - self.a) + rest * slip / rounded
        slope = (self.b - self.c * (self.a + self.b * size)) * decay
        slope = slope + rest * (self.sign_slip / rounded) ** 2 / rounded
        by_sliding = line_load * slope / speed
        return Traction(
            force=line_load * signed,
            by_load=signed * np.ones_like(line_load),
            by_sliding=by_sliding,
            by_entrainment=-by_sliding * slip * entrainment / speed,
            by_film=np.zeros_like(by_sliding),
        )
