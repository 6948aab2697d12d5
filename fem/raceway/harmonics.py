r"""The compliance of a raceway in azimuthal harmonics, before any roller has a place.

Rollers at the azimuths phi_j have the force harmonics :math:`F_{nm} = \sum_j F_{jm} e^{-in\varphi_j}` [N];
they press with :math:`\frac{1}{2\pi R} \sum_{nm} F_{nm}\,a_m(x)\,e^{in\varphi}` on the raceway, in the
local radial direction, :math:`a_m = \frac{2m+1}{l} L_m(2x/l)`. The raceway answers with
:math:`w_m(\varphi) = \int a_m u_r\,dx = \sum_n w_{nm} e^{in\varphi}`, outward. Lines have no width: under
a line only what differs from a half-space (`fem.half_space.line_load`) has a sum.
"""

import logging
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property
from math import ceil, cos, floor, tan
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from fem.errors import NotSolved, TooFewHarmonics
from fem.half_space.line_load import cubic_tail, curvature_tail, indentation, indentation_harmonics
from fem.parts.resolution import Resolution
from fem.parts.rings import Elastic, ImpossiblePart, MeshSize
from fem.raceway.bar_response import BarResponse
from fem.raceway.compliance import RacewayCompliance

TRUNCATED = 0.05  # allowed part of the own terms that comes from beyond the last harmonic
SAME = 1e-9  # half the difference of azimuths that are taken as one [rad]
SAME_DIGITS = 12  # of azimuths in radians: equal pitches give equal differences
MOST = 10_000  # harmonics that are solved for
FEWEST = 8  # harmonics from which the decay of the rest can be estimated
PLACES = 4  # sets of azimuths whose compliances are kept
FINENESS = 6.0  # highest harmonic over M R/l, unless one is requested
DEPTH = 10.0  # highest harmonic over R/thickness: through the ring less than exp(-10) of it is felt
MARGIN = 1.5  # highest harmonic over that of a band whose ends are far from the ends of its ring
DOUBLINGS = 4  # of the harmonics on a mesh: the time of each is about six times that of the one before
RESOLVED = 0.6  # highest harmonic over order times R/h on raceway elements of size h: beyond, errors grow


Condensed = TypeVar("Condensed")

_log = logging.getLogger(__name__)


def highest_harmonic(radius: float, detail: float, mesh: MeshSize, wish: int | None = None) -> int:
    """Choose the last harmonic: one that the elements of the raceway still resolve, or the least of all.

    `radius` [m] is that of the raceway, `detail` [m] the length l/M that an axial shape resolves.
    Raises `NotSolved` if the mesh is too coarse for what is requested, or the raceway too large for so fine a
    detail.
    """
    limit = floor(RESOLVED * mesh.order * radius / mesh.raceway_size)
    if wish is None:
        return _usual(needed_harmonics(radius, detail), limit)
    if not FEWEST <= wish <= limit:
        raise NotSolved(
            f"{wish} harmonics are impossible on this mesh of the raceway, allowed are {FEWEST} to {limit}: "
            "smaller elements of the raceway or a higher order resolve more"
        )
    return wish


def resolving(resolution: Resolution, radius: float, last: int) -> Resolution:
    """The same with elements of the raceway, of radius R [m], that resolve a last harmonic."""
    if resolution.mesh_size is None:  # of a beam
        return resolution
    mesh = resolution.mesh_size
    size = min(mesh.raceway_size, RESOLVED * mesh.order * radius / last)
    return replace(resolution, mesh_size=replace(mesh, raceway_size=size))


def with_enough_harmonics(
    condensed: Callable[[Resolution, int], Condensed], resolution: Resolution, radius: float, last: int
) -> Condensed:
    """Condense a part with twice the harmonics, on elements that resolve them, until they are enough.

    `condensed` (resolution, last) raises `TooFewHarmonics` where more of them are needed; it begins with
    `last`, on a raceway of a radius [m]. A harmonic that the resolution requests is tried alone.
    Raises `TooFewHarmonics` if `DOUBLINGS` of them are not enough on a mesh, or if MOST harmonics are none.
    """
    if resolution.harmonics is not None:
        return condensed(resolution, last)
    highest = min(MOST, last * 2**DOUBLINGS if resolution.mesh_size else MOST)
    while True:
        try:
            return condensed(resolving(resolution, radius, last), last)
        except TooFewHarmonics as problem:
            if 2 * last > highest:
                raise
            last *= 2
            _log.info("%s; %d harmonics are tried", problem, last)


def needed_harmonics(radius: float, detail: float) -> int:
    """Last harmonic that loads of an axial detail l/M [m] need on a raceway of a radius [m]."""
    return ceil(FINENESS * radius / detail)


def _usual(needed: int, limit: int) -> int:
    """As many harmonics as are needed, or as the mesh resolves, or the least of all."""
    last = max(FEWEST, min(needed, limit))
    if last > MOST:
        raise NotSolved(
            f"{last} harmonics resolve so small a loaded patch on so large a raceway, allowed are {MOST} or "
            "fewer: a larger patch or a smaller ring needs less"
        )
    return last


def detail_of_ring(band: float, thickness: float) -> float:
    """Length [m] that harmonics of a plain ring resolve: for a band up to its ends, and for a thin one.

    `band` is the length l/M that an axial mode resolves, `thickness` that of the ring [m].
    """
    return min(band / MARGIN, FINENESS / DEPTH * thickness)


class Responses(NamedTuple):
    """What unit loads of every harmonic are answered with, as a discretisation finds it."""

    response: NDArray  # (N + 1, M, M) of revolution, n = 0 .. N; or (K, M, K, M), -N .. N [m/N]
    unknowns: int
    elements: int
    support_error: float | None = None  # of the support's stiffness, over it; estimated [-]
    bar_response: BarResponse | None = None  # of a squirrel cage
    short_waves: NDArray | None = None  # (S, M, M) what N + 1 .. N + S answer to themselves [m/N]
    rows: int = 1  # of rollers, whose shapes stand one row after the other
    taper: float = 0.0  # [rad] angle of the raceway from the axis, of two of that at -x
    along: bool = False  # whether the last shape of a row is a uniform force along the raceway


def with_short_waves(responses: Responses, resolved: int, waves: NDArray) -> Responses:
    """Answers of a raceway on bars with those of short waves to themselves.

    Two waves that are both too short are not coupled. Harmonics up to N beyond `resolved` are too short for
    the elements; `waves` (S, M, M) are their own answers [m/N], at least up to N.
    """
    response, last = responses.response.copy(), len(responses.response) // 2
    n = np.arange(-last, last + 1)
    short = np.flatnonzero(np.abs(n) > resolved)
    response[np.ix_(short, np.arange(response.shape[1]), short)] = 0.0
    response[short, :, short] = waves[np.abs(n[short]) - resolved - 1]
    beyond = waves[last - resolved :]
    return responses._replace(response=response, short_waves=beyond if len(beyond) else None)


def support_error(response: NDArray, neighbour: NDArray) -> float:
    """Estimated error of the stiffness of a support [-]: its relative change from a neighbouring order.

    Both are answers to all harmonics [m/N], (K, M, K, M) or (N + 1, M, M).
    """
    first, other = (_of_translation(answers) for answers in (response, neighbour))
    return abs(first / other - 1)


def _of_translation(response: NDArray) -> float:
    """What harmonics 1 and -1 answer to themselves [m/N]."""
    if response.ndim == 3:
        return float(response[1, 0, 0])
    last = len(response) // 2
    return float(sum(response[n, 0, n, 0].real for n in (last - 1, last + 1)) / 2)


def harmonic_compliance(
    responses: Responses, *, radius: float, length: float, elastic: Elastic, bars: int | None, seconds: dict
) -> "HarmonicCompliance":
    """Raceway compliance of a part; a body of revolution answers n and -n alike."""
    response = responses.response
    if response.ndim == 3:
        response = np.concatenate([response[:0:-1], response])
    last = len(response) // 2
    return HarmonicCompliance(
        harmonics=np.arange(-last, last + 1),
        response=response,
        radius=radius,
        length=length,
        elastic=elastic,
        bars=bars,
        taper=responses.taper,
        along=responses.along,
        unknowns=responses.unknowns,
        elements=responses.elements,
        seconds=seconds,
        support_error=responses.support_error,
        bar_response=responses.bar_response,
        short_waves=responses.short_waves,
        rows=responses.rows,
    )


@dataclass(frozen=True, kw_only=True)
class HarmonicCompliance:
    """Raceway compliance in azimuthal harmonics; the azimuths of the rollers stay free.

    A body of revolution answers each harmonic with the same one only and holds no more than that. The M
    shapes are those of all rows of rollers, one row after the other.
    """

    harmonics: NDArray  # (K,) of int, -N .. N
    response: NDArray  # (K, M, K, M), or (K, M, M) of revolution [m/N]: w_nm per F_n'm', nothing removed
    radius: float  # R of the raceway [m]
    length: float  # l of the loaded band along the axis [m]
    elastic: Elastic  # material below the raceway
    bars: int | None  # equal bars with one at azimuth 0; None for a body of revolution
    unknowns: int
    elements: int
    seconds: dict[str, float] = field(compare=False)  # by stage: mesh, factor, condense
    support_error: float | None = None  # of the support's stiffness, over it; None: not estimated [-]
    bar_response: BarResponse | None = None  # of a squirrel cage
    short_waves: NDArray | None = None  # (S, M, M) [m/N] what N + 1 .. N + S answer to themselves, if known
    rows: int = 1  # of rollers, on loaded bands of their own
    taper: float = 0.0  # [rad] of the raceway from the axis, of two of that at -x; > 0: it widens towards +x
    along: bool = False  # whether the last shape of a row is a uniform force along the raceway, towards +x

    def __post_init__(self):
        K, M = self.response.shape[:2]
        if K // 2 < FEWEST or not np.array_equal(self.harmonics, np.arange(-(K // 2), K // 2 + 1)):
            raise ImpossiblePart(f"harmonics must be the integers -N .. N in order, N at least {FEWEST}")
        if self.response.shape not in ((K, M, K, M), (K, M, M)):
            raise ImpossiblePart(f"response of shape {self.response.shape} does not fit {K} harmonics")

    def at(self, azimuths) -> RacewayCompliance:
        r"""Compliance for rollers at given azimuths.

        .. math:: C_{ij} = \sum_{nn'} (W - h)_{nn'} e^{i(n\varphi_i - n'\varphi_j)} + (1 - \delta_{ij}) H_{ij}

        with H the answer of a half-space at the chord between two lines and h its harmonics; C_ii is the
        limit of the answer close to a line less that of the half-space. Beyond the last harmonic come the
        short waves, where they are known, and then what follows from how the last harmonics fall.

        All azimuths (Z,) [rad] in a row are different; rows have as many rollers, one row after the other.
        There is no H between rows, whose bands do not touch.
        Raises `ImpossiblePart` if two rollers stand at one azimuth, `NotSolved` if the harmonics end too
        early for the own terms.

        Source
        ------
        Fourier series of the answer less that of a half-space; derived here.
        """
        phi = np.array(azimuths, dtype=float)
        known = self._at.get(phi.tobytes())
        if known is None:
            while len(self._at) >= PLACES:
                self._at.pop(next(iter(self._at)), None)
            known = self._at[phi.tobytes()] = self._computed_at(phi)
        return known

    @cached_property
    def _at(self) -> "dict[bytes, RacewayCompliance]":
        """Compliances for the azimuths that were requested last."""
        return {}

    def _computed_at(self, phi: NDArray) -> RacewayCompliance:
        translation, support = self._translation(phi)
        across = cos(self.taper)  # what the normal has of it
        return RacewayCompliance(
            azimuths=phi,
            absolute=self.absolute(phi),
            translation=translation / across,
            support_stiffness=float(2 * across**2 / np.trace(support)),
            unknowns=self.unknowns,
            elements=self.elements,
            seconds=self.seconds,
            support_error=self.support_error,
            bar_response=self.bar_response,
        )

    def absolute(self, azimuths: NDArray) -> NDArray:
        """The matrix C of `at` alone, (Z, M, Z, M) [m/N], also for a raceway without a hold of its own.

        M are here, and in what follows, the shapes of the row of a roller.
        """
        self.require_enough()
        absolute = self._series(azimuths) + self._beyond(azimuths) + self._neighbours(azimuths)
        if self.taper:
            own = np.arange(len(azimuths))
            absolute[own, :, own] += self._of_wider_end
        absolute = (absolute + absolute.transpose(2, 3, 0, 1)) / 2
        return self.of_rows(self.of_rows(absolute).transpose(2, 3, 0, 1)).transpose(2, 3, 0, 1)

    def of_rows(self, values: NDArray) -> NDArray:
        """Of values (Z, M, ...) of rollers in the shapes of all rows those in the shapes of their own one."""
        if self.rows == 1:
            return values
        rollers, shapes = values.shape[:2]
        each = values.reshape(
            self.rows, rollers // self.rows, self.rows, shapes // self.rows, *values.shape[2:]
        )
        own = np.arange(self.rows)
        return each[own, :, own].reshape(rollers, shapes // self.rows, *values.shape[2:])

    def require_enough(self) -> None:
        """Refuse a compliance of which too much is extrapolated.

        Raises `TooFewHarmonics` if more than `TRUNCATED` of the own terms comes from beyond the last
        harmonic.
        """
        if not self.truncation <= TRUNCATED:
            raise TooFewHarmonics(
                f"{self.truncation:.2g} of the own compliance lies beyond harmonic {self.harmonics[-1]}, "
                f"allowed {TRUNCATED:g}: take more harmonics"
            )

    @property
    def truncation(self) -> float:
        """Part of the largest own compliance that is extrapolated, for patterns of equal mean square [-].

        The indentation up to the last harmonic counts as own: on a stiff seat the rest is near zero.
        """
        line = np.zeros(1)
        own_terms = np.abs(self._remainder.sum(axis=0) + self._tail(line)[0]) + self._half_space.sum(axis=0)
        square = np.append(2 * np.arange(self._normal_shapes) + 1, [1] * self.along)
        square = np.tile(square, self.rows)
        return float(
            np.max(np.abs(self._extrapolated(line)[0]) / np.sqrt(np.outer(square, square)))
            / np.max(np.diag(own_terms) / square)
        )

    @property
    def fade(self) -> NDArray:
        """Share of a line that the shapes carry in each harmonic (N + 1, M) [-]: all of it."""
        return np.ones((len(self.harmonics) // 2 + 1, self.response.shape[1]))

    @cached_property
    def _half_space(self) -> NDArray:
        """Harmonics of the half-space (K, M, M) [m/N]."""
        return self._in_each_row(
            indentation_harmonics(
                self.harmonics, self.radius, self._contact_length, self._normal_shapes, self.elastic
            )
        )

    @property
    def _contact_length(self) -> float:
        """Length of the loaded band along the raceway [m]."""
        return self.length / cos(self.taper)

    @cached_property
    def _of_wider_end(self) -> NDArray:
        r"""What own terms gain where the radius r(s) of a cone is above the R of the half-space (M, M) [m/N].

        .. math:: \frac{2 (1 - \nu^2)}{\pi E} \int a_m a_p \ln\frac{r}{R}\,ds

        A place at an azimuth is as much further from the line as r is larger.

        Source
        ------
        Logarithm of the displacement beside a line load; derived here.
        """
        order = np.arange(self._normal_shapes)
        places, weights = np.polynomial.legendre.leggauss(len(order) + 8)
        shapes = np.polynomial.legendre.legvander(places, len(order) - 1) * (2 * order + 1)
        ratio = np.log1p(self.length / 2 * tan(self.taper) * places / self.radius)
        unit = 2 * (1 - self.elastic.poisson_ratio**2) / (np.pi * self.elastic.youngs_modulus)
        own = unit / (2 * self._contact_length) * (shapes.T * (weights * ratio)) @ shapes
        of_rows = own, own * np.outer((-1.0) ** order, (-1.0) ** order)  # mirror images
        whole = np.zeros((self.rows, self._shapes, self.rows, self._shapes))
        for row, of_row in enumerate(of_rows[: self.rows]):
            whole[row, :, row] = self._with_force_along(of_row)
        return whole.reshape(self.rows * self._shapes, -1)

    @property
    def _shapes(self) -> int:
        """Number of shapes of a row."""
        return self.response.shape[1] // self.rows

    @property
    def _normal_shapes(self) -> int:
        """Number of those that press on the raceway."""
        return self._shapes - self.along

    def _in_each_row(self, of_row: NDArray) -> NDArray:
        """Of answers (..., m, m) of a row to itself those of all rows (..., M, M), zero between rows."""
        of_row = self._with_force_along(of_row)
        if self.rows == 1:
            return of_row
        return np.kron(np.eye(self.rows), of_row)

    def _with_force_along(self, of_normal: NDArray) -> NDArray:
        r"""Answers of a half-space to lines that press on it, and to a force along a line.

        A force along a long line moves it by 1/(1 - nu) of what a normal one does; neither moves the other.

        Source
        ------
        Antiplane shear, -q ln(d)/(pi G), against plane strain, -2 (1 - nu^2) q ln(d)/(pi E).
        """
        if not self.along:
            return of_normal
        widened = np.pad(of_normal, [(0, 0)] * (of_normal.ndim - 2) + [(0, 1)] * 2)
        widened[..., -1, -1] = of_normal[..., 0, 0] / (1 - self.elastic.poisson_ratio)
        return widened

    @cached_property
    def _remainder(self) -> NDArray:
        """What every harmonic answers to itself beside the half-space (K, M, M) [m/N]."""
        diagonal = self.response if self.response.ndim == 3 else np.einsum("kmkp->kmp", self.response)
        return np.real(diagonal) - self._half_space

    def _tail(self, azimuth: NDArray) -> NDArray:
        """Sum of the remainders beyond the last harmonic (..., M, M) [m/N]."""
        if self.short_waves is None:
            return self._extrapolated(azimuth)
        n = self.harmonics[-1] + 1 + np.arange(len(self.short_waves))
        waves = 2 * np.cos(np.multiply.outer(azimuth, n))
        return np.tensordot(waves, self._short_remainder, axes=1) + self._extrapolated(azimuth)

    def _extrapolated(self, azimuth: NDArray) -> NDArray:
        """Sum of the remainders beyond all that are known (..., M, M) [m/N]."""
        return sum_beyond(
            np.concatenate([self._remainder[self.harmonics[-1] :], self._short_remainder]), azimuth
        )

    @cached_property
    def _short_remainder(self) -> NDArray:
        """What short waves answer beside the half-space (S, M, M) [m/N]."""
        M = self.response.shape[1]
        if self.short_waves is None:
            return np.empty((0, M, M))
        n = self.harmonics[-1] + 1 + np.arange(len(self.short_waves))
        waves = indentation_harmonics(n, self.radius, self._contact_length, self._normal_shapes, self.elastic)
        return self.short_waves - self._in_each_row(waves)

    def _series(self, phi: NDArray) -> NDArray:
        """Sum of the harmonics less the half-space (Z, M, Z, M) [m/N]."""
        if self.response.ndim == 3:
            apart, place = _distinct(phi[:, None] - phi)
            waves = np.cos(np.outer(apart, self.harmonics))
            return np.tensordot(waves, self._remainder, axes=1)[place].transpose(0, 2, 1, 3)
        turn = np.exp(1j * np.outer(phi, self.harmonics))
        left = self.response.astype(complex)
        k = np.arange(self.harmonics.size)
        left[k, :, k] -= self._half_space
        answer = np.tensordot(turn, np.tensordot(left, turn.conj(), axes=(2, 1)), axes=1)
        return np.real(answer).transpose(0, 1, 3, 2)

    def _beyond(self, phi: NDArray) -> NDArray:
        """Sum of the harmonics beyond the last one (Z, M, Z, M) [m/N]."""
        apart, place = _distinct(phi[:, None] - phi)
        return self._tail(apart)[place].transpose(0, 2, 1, 3)

    def _neighbours(self, phi: NDArray) -> NDArray:
        """Half-space between different rollers (Z, M, Z, M) [m/N]."""
        Z, M = phi.size, self.response.shape[1]
        row = np.arange(Z) // (Z // self.rows)
        i, j = np.nonzero(~np.eye(Z, dtype=bool) & (row[:, None] == row))
        if np.any(np.abs(np.sin((phi[i] - phi[j]) / 2)) < SAME):
            raise ImpossiblePart(f"azimuths = {phi.tolist()!r} are impossible; all must be different")
        H = np.zeros((Z, M, Z, M))
        apart, place = _distinct(phi[i] - phi[j])
        own = indentation(apart, self.radius, self._contact_length, self._normal_shapes, self.elastic)
        H[i, :, j] = self._in_each_row(own)[place]
        return H

    def _translation(self, phi: NDArray) -> tuple[NDArray, NDArray]:
        r"""Mean translation along y and z per force (2, Z, M), and per load like cos or sin (2, 2) [m/N].

        .. math:: t_y = i(w_{1,0} - w_{-1,0}), \quad t_z = w_{1,0} + w_{-1,0}

        Source
        ------
        Fourier series of the answer less that of a half-space; derived here.
        """
        first = self.harmonics[-1] + np.array([1, -1])
        read = np.array([[1j, -1j], [1.0, 1.0]])
        turn = np.exp(-1j * np.outer(self.harmonics, phi))
        if self.response.ndim == 3:
            means = np.arange(0, self.response.shape[1], self._shapes)  # of every row
            answer = self.response[first][:, means].mean(1)[:, None] * turn[first, :, None]
            pair = np.diag(self.response[first][:, means][:, :, means].mean((1, 2)))
        else:
            answer = np.einsum("akp,kj->ajp", self.response[first, 0], turn)
            pair = self.response[first[:, None], 0, first, 0]
        by_force = np.real(np.tensordot(read, answer, axes=1))
        of_own = self.of_rows(np.moveaxis(by_force, 0, -1))
        return np.moveaxis(of_own, -1, 0), np.real(read @ pair @ read.conj().T)


def sum_beyond(remainders: NDArray, azimuth: NDArray) -> NDArray:
    r"""Sum of a series beyond its last harmonic, as the last quarter falls.

    .. math:: S_n = \frac{c}{n^2-1} + \frac{d}{|n|^3}

    The curvature of the raceway makes c, the ends of the loaded band make d.

    `remainders` (N + 1, L, L) are S_n, n = 0 .. N, what is left of answers without the half-space [m/N];
    `azimuth` is phi between load and answer [rad]. The result (..., L, L) [m/N] is the sum of S_n cos(n phi)
    over |n| > N.

    Source
    ------
    Fourier series of the answer less that of a half-space; derived here.
    """
    last = len(remainders) - 1
    n = np.arange(last - last // 4, last + 1)
    law = np.stack([1 / (n**2 - 1.0), 1.0 / n**3], axis=1)
    weight = n[:, None] ** 2.0
    fitted = np.linalg.lstsq(weight * law, weight * remainders[n].reshape(n.size, -1), rcond=None)[0]
    tails = np.stack([curvature_tail(azimuth, last), cubic_tail(azimuth, last)], axis=-1)
    return (tails @ fitted).reshape(*azimuth.shape, *remainders.shape[1:])


def _distinct(differences: NDArray) -> tuple[NDArray, NDArray]:
    """Differences of azimuths without sign and turns, each once, and where each of them belongs."""
    apart = np.abs(np.mod(differences + np.pi, 2 * np.pi) - np.pi)
    once, place = np.unique(np.round(apart, SAME_DIGITS), return_inverse=True)
    return once, place.reshape(differences.shape)
