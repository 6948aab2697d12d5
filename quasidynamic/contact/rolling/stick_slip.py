"""Tractions that stick or slip: Newton's method on the projection onto the friction limit."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import NotSolved

BASIS = 80  # vectors before the search starts again
CYCLES = 3
TOLERANCE = 1e-8  # of the friction left; the torque of a slewing bearing is a small part of it
LIMIT = 60  # Newton steps, rarely more than ten
SHORTEST = 1 / 64  # part of a Newton step
SLIPPING = 1e-300  # [Pa] keeps the direction of a traction of zero defined


def solved(multiply: Callable[[NDArray], NDArray], right: NDArray, tolerance: float) -> NDArray:
    """Solution of a system, or the nearest one found: GMRES without preconditioner.

    That of SciPy takes up to a third longer in all for systems as small as contacts.

    What is left of the solution is `tolerance` of the right side, of whose shape and precision the solution
    is.

    Source
    ------
    Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986), 856-869; orthogonalised once, which
    is enough for the tolerances of a Newton step.
    """
    target, solution, left = tolerance * float(np.linalg.norm(right)), np.zeros_like(right), right
    for cycle in range(CYCLES):
        if cycle:
            left = right - multiply(solution)
        if (size := float(np.linalg.norm(left))) <= target:
            break
        solution = solution + _cycle(multiply, left, size, target)
    return solution


def _cycle(multiply: Callable[[NDArray], NDArray], right: NDArray, size: float, target: float) -> NDArray:
    """Best solution in a Krylov space that grows until it is good enough."""
    basis, upper = np.empty((BASIS + 1, right.size), right.dtype), np.zeros((BASIS, BASIS))
    basis[0], rotated, sides = right.ravel() / size, np.eye(BASIS + 1), [size]
    for count in range(1, BASIS + 1):
        vector = multiply(basis[count - 1].reshape(right.shape)).ravel()
        along = basis[:count] @ vector
        vector = vector - along @ basis[:count]
        column, length = rotated[:count, :count] @ along, float(np.sqrt(vector @ vector))
        reach = float(np.hypot(column[-1], length))
        cosine, sine = float(column[-1]) / reach, length / reach
        upper[: count - 1, count - 1], upper[count - 1, count - 1] = column[:-1], reach
        rows = slice(count - 1, count + 1)
        rotated[rows] = np.array([[cosine, sine], [-sine, cosine]]) @ rotated[rows]
        sides[-1:] = [cosine * sides[-1], -sine * sides[-1]]
        if abs(sides[-1]) <= target or length == 0.0:
            break
        basis[count] = vector / length
    weights = np.linalg.solve(upper[:count, :count], sides[:count])
    return (weights.astype(basis.dtype) @ basis[:count]).reshape(right.shape)


class StickSlipLaw(NamedTuple):
    """Slip of a step as the sum of what the traction makes and what it does not."""

    displacement: Callable[[NDArray], NDArray]  # (2, nx, ny) [m] of tractions (2, nx, ny) [Pa], linear
    offset: NDArray  # (2, nx, ny) [m] slip without traction
    limit: NDArray  # (nx, ny) [Pa] largest traction
    stiffness: NDArray | float  # [Pa/m] of a cell alone


class StickSlip(NamedTuple):
    """Tractions near or at a solution."""

    traction: NDArray  # (2, nx, ny) [Pa]
    left: NDArray  # (2, nx, ny) [Pa] what the projection would change
    direction: NDArray  # (2, nx, ny) of the traction where it slips, zero where it sticks
    reduced: NDArray  # (nx, ny) [-] limit over trial traction where it slips, one where it sticks
    stick: NDArray  # (nx, ny)


def at_traction(law: StickSlipLaw, traction: NDArray) -> StickSlip:
    r"""Evaluate the law of Coulomb.

    .. math:: F = p - P_g(z),\quad z = p - \rho S(p),\quad
              P_g(z) = z \min(1, g/|z|)

    F = 0 is stick (S = 0, |p| <= g) or slip (p = -g S/|S|), for any rho > 0.

    p and F (2, nx, ny) are in Pa; the projection has a kink at |z| = g.

    Source
    ------
    Alart and Curnier, Comput. Methods Appl. Mech. Eng. 92 (1991), 353-375.
    """
    trial = traction - law.stiffness * (law.offset + law.displacement(traction))
    size = np.hypot(trial[0], trial[1])
    stick = size <= law.limit
    size = np.maximum(size, SLIPPING)
    reduced = np.where(stick, 1.0, law.limit / size)
    return StickSlip(traction, traction - reduced * trial, np.where(stick, 0.0, trial / size), reduced, stick)


def stick_slip(law: StickSlipLaw, start: NDArray) -> StickSlip:
    """Tractions (2, nx, ny) [Pa] that obey the law, from those of a start.

    Raises `NotSolved` when Newton's method stalls or reaches its limit.

    Source
    ------
    Semi-smooth Newton method; Qi and Sun, Math. Program. 58 (1993), 353-367.
    """
    scale = float(np.linalg.norm(np.minimum(law.limit, law.stiffness * np.hypot(*law.offset))))
    state = at_traction(law, start)
    size = float(np.linalg.norm(state.left))
    for _ in range(LIMIT):
        if size <= TOLERANCE * scale:
            return state
        tolerance = max(TOLERANCE * scale / size, min(2e-2, size / scale)) / 2  # not beyond what is asked
        change = _solved(law, state, -state.left, tolerance)
        part = 1.0
        trial = at_traction(law, state.traction + change)
        while not (smaller := np.linalg.norm(trial.left) < (1 - 1e-4 * part) * size) and part > SHORTEST:
            part /= 2
            trial = at_traction(law, state.traction + part * change)
        if not smaller:
            raise NotSolved(f"stick and slip: stalled at {size / scale:.1e} of the friction", "stalled")
        state, size = trial, float(np.linalg.norm(trial.left))
    raise NotSolved(
        f"stick and slip: {size / scale:.1e} of the friction left after {LIMIT} Newton steps, allowed "
        f"{TOLERANCE:.0e}",
        "iteration limit",
    )


def traction_changes(
    law: StickSlipLaw, state: StickSlip, offsets: NDArray, tolerance: float = 1e-2
) -> NDArray:
    """Changes (k, 2, nx, ny) [Pa] of the tractions with the slip, the regions of stick and slip as they are.

    Offsets (k, 2, nx, ny) [m] are changes of the slip without traction; `tolerance` is the relative one of
    the linear solves.

    Source
    ------
    Derivative of the projection in `at_traction`.
    """
    stiffness = law.stiffness
    return np.stack([_solved(law, state, -_turned(state, stiffness * part), tolerance) for part in offsets])


def _turned(state: StickSlip, change: NDArray) -> NDArray:
    """Change of the projection with that of its argument."""
    along = (state.direction * change).sum(0)
    return state.reduced * (change - along * state.direction)


def _solved(law: StickSlipLaw, state: StickSlip, right: NDArray, tolerance: float) -> NDArray:
    """Solution of the linearised law; a linear solve that ends early leaves the rest to the next step.

    In single precision, nearly twice as fast: its rounding is far below any tolerance requested.
    """
    stiffness = np.asarray(law.stiffness, np.float32)
    turned = state._replace(
        direction=state.direction.astype(np.float32), reduced=state.reduced.astype(np.float32)
    )
    solution = solved(
        lambda change: change - _turned(turned, change - stiffness * law.displacement(change)),
        right.astype(np.float32),
        tolerance,
    )
    return solution.astype(float)
