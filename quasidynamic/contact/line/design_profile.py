"""Logarithmic profiles that belong to a design load."""

from math import log, pi

from quasidynamic.contact.line.load_law import half_width
from quasidynamic.errors import require_positive
from quasidynamic.parts.profile import Logarithmic, LogarithmicCrown

END = log(2) + 0.5  # 1.1931, printed as 1.1932; its exponential is 1/0.3033


def lundberg(load: float, length: float, modulus: float) -> Logarithmic:
    r"""Profile under which a design load spreads evenly along the roller.

    .. math:: C = \frac{2 Q}{\pi l E'} \ln \frac{1}{1 - (2x/l)^2}

    Parameters
    ----------
    load : float
        Q, design load of one contact [N], > 0
    length : float
        l [m]
    modulus : float
        E' of the pair [Pa], `contact_modulus`

    Source
    ------
    Lundberg, Forsch. Ingenieurwes. 10 (1939), 201-211, in the notation of Fujiwara and Kawase (2007): the
    displacement of a half-space under an even load per length.

    Valid
    -----
    Half-width far below the length. The drop has no bound at the very end, where `johns_gohar` ends it.

    >>> drop = lundberg(10e3, 10e-3, 227.5e9).amplitude
    >>> round(drop * 1e6, 3)
    2.798
    """
    require_positive("design_load", load)
    return Logarithmic(amplitude=2 * load / (pi * length * modulus))


def johns_gohar(load: float, length: float, modulus: float, radius: float) -> LogarithmicCrown:
    r"""Profile of Lundberg with the drop at the end that an even strip of the contact's width requires.

    .. math:: C = \frac{2Q}{\pi l E'} \ln \frac{1}{1 - (1 - 0.3033\, b/a)(x/a)^2},\quad a = l/2

    Parameters
    ----------
    load : float
        Q, design load of one contact [N], > 0
    length : float
        l [m]
    modulus : float
        E' of the pair [Pa]
    radius : float
        R, reduced radius [m], which gives the half-width b under the design load

    Source
    ------
    Johns and Gohar, Tribology International 14 (1981), 131-136, as Fujiwara and Kawase (2007) write it.
    0.3033 is 1/(2 sqrt(e)): the drop at the end, A (1.1932 + ln a/b), is Lundberg's.

    Valid
    -----
    Half-width below the length; aligned rollers.
    """
    amplitude = lundberg(load, length, modulus).amplitude
    width = float(half_width(load / length, radius, modulus))
    depth = amplitude * (log(length / 2 / width) + END)
    return LogarithmicCrown(amplitude=amplitude, end_drop=depth, crowned_share=1.0)


def fujiwara_kawase(
    load: float, length: float, modulus: float, *, load_factor: float, crowned_share: float, end_drop: float
) -> LogarithmicCrown:
    r"""Logarithmic profile with a straight middle and a chosen drop at the end, for rollers that tilt.

    .. math:: C = A \ln \frac{1}{1 - (1 - e^{-z_m/A}) \left(\frac{|x| - a}{K_2 a} + 1\right)^2},\quad
              A = \frac{2 K_1 Q}{\pi l E'},\quad a = l/2

    Parameters
    ----------
    load : float
        Q, design load of one contact [N], > 0
    length : float
        l [m]
    modulus : float
        E' of the pair [Pa]
    load_factor : float
        K_1, multiplies the design load [-], > 0
    crowned_share : float
        K_2, crowned share of each half of the length [-], up to 1
    end_drop : float
        z_m, drop at the end of the length [m], > 0

    Source
    ------
    Fujiwara and Kawase, NTN Technical Review 75 (2007), 140-148.

    Valid
    -----
    The drop is that of the formula for any parameters; which of them suit a bearing is to be found out.
    """
    amplitude = load_factor * lundberg(load, length, modulus).amplitude
    return LogarithmicCrown(amplitude=amplitude, end_drop=end_drop, crowned_share=crowned_share)
