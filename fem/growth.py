"""Growth of raceways by rotation or heat, from the harmonic 0 of a body of revolution."""

from collections.abc import Mapping

from numpy.typing import NDArray

from fem import revolved_forms as forms
from fem.revolved_body import Body, edge_shapes


def rotation(body: Body, densities: Mapping[str, float], speed: float) -> NDArray:
    """Load vector of rotation about the axis.

    Parameters
    ----------
    body : Body
        assembled sections
    densities : mapping
        rho of every body by its name [kg/m^3]
    speed : float
        omega [rad/s]

    Returns
    -------
    array (unknowns,)
        per radian, harmonic 0 [N]
    """
    density = body.space.mesh.MaterialCF(dict(densities))
    return body.load(forms.centrifugal(body.space.TestFunction(), density, speed))


def heating(body: Body, expansions: Mapping[str, float]) -> NDArray:
    """Load vector of free thermal expansions.

    Parameters
    ----------
    body : Body
        assembled sections
    expansions : mapping
        alpha (T - T0) of every body by its name [-], positive when it grows

    Returns
    -------
    array (unknowns,)
        per radian, harmonic 0 [N]
    """
    expansion = body.space.mesh.MaterialCF(dict(expansions))
    return body.load(forms.thermal(body.space.TestFunction(), body.bulk, expansion))


def growth(body: Body, load: NDArray, edge: str, shapes: int = 1) -> NDArray:
    """Radial displacement of a cylindrical edge under an axisymmetric load.

    Parameters
    ----------
    body : Body
        assembled sections, held axially and against turning
    load : array (unknowns,)
        sum of vectors of `rotation`, `heating`
    edge : str
        name of the edge
    shapes : int
        M

    Returns
    -------
    array (M,)
        w_m [m] outward as in `edge_shapes`; the displacement along the edge is the sum of w_m L_m

    Raises
    ------
    NotSolved
        if the body is not held
    """
    u = body.stiffness.solve(0, load[:, None])
    return edge_shapes(body, edge, shapes).T @ u[:, 0]
