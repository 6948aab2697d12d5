r"""Weak forms on the axial section of a body of revolution, per radian.

A load like :math:`\cos n\varphi` moves the body by :math:`u_x, u_r \sim \cos n\varphi` with
:math:`u_t \sim \sin n\varphi`; integrals over phi give stiffness and load the same factor. Sections are in
millimetres with x along the axis and y the radius, unknowns in metres, so that the forms carry the powers
of `MILLIMETRES` that make stiffness N/m and loads N.
"""

import ngsolve as ngs
from ngsolve import y as radius

from fem.mesh.solid import MILLIMETRES


def strain(u):
    r"""Strain of a displacement of harmonic n, as its part without n with the factor of n.

    .. math:: \varepsilon = (u_{x,x},\; u_{r,r},\; (u_r + n u_t)/r,\; u_{r,x} + u_{x,r},\;
              u_{t,x} - n u_x/r,\; u_{t,r} - (u_t + n u_r)/r)

    Parameters
    ----------
    u : ngsolve proxy (3,)
        u_x, u_r, u_t [m], times cos, cos, sin of n phi

    Returns
    -------
    tuple of ngsolve.CoefficientFunction (6,)
        epsilon_xx, rr, tt, 2 xr, 2 xt, 2 rt [-]; the last two times sin n phi, the others times cos

    Source
    ------
    Zienkiewicz, Taylor, The Finite Element Method, vol. 2, semi-analytical methods.
    """
    axial, radial, tangential = u
    d = ngs.grad(u)
    plain = (
        d[0, 0], d[1, 1], radial / radius, d[1, 0] + d[0, 1],
        d[2, 0], d[2, 1] - tangential / radius,
    )  # fmt: skip
    turned = (0, 0, tangential / radius, 0, -axial / radius, -radial / radius)
    return ngs.CF(plain), ngs.CF(turned)


def elasticity(u, v, lame, shear):
    r"""Virtual work of the stresses per radian, as the parts without n, with n, with n^2.

    .. math:: a_n(u, v) = \int (\lambda\,\mathrm{tr}\,\varepsilon\,\mathrm{tr}\,\varepsilon'
              + 2\mu\,\varepsilon : \varepsilon')\,r\,dx\,dr

    Parameters
    ----------
    u, v : ngsolve proxies (3,)
        trial and test displacement
    lame, shear : float or ngsolve.CoefficientFunction
        lambda and mu [Pa]

    Returns
    -------
    tuple of ngsolve.SumOfIntegrals
        three forms, symmetric

    Source
    ------
    Zienkiewicz, Taylor, The Finite Element Method, vol. 2, semi-analytical methods.
    """
    (e, f), (g, h) = strain(u), strain(v)

    def stress_work(a, b):
        trace = (a[0] + a[1] + a[2]) * (b[0] + b[1] + b[2])
        normal = sum(2 * a[k] * b[k] for k in range(3))
        return (
            (lame * trace + shear * (normal + sum(a[k] * b[k] for k in range(3, 6))))
            * radius
            / MILLIMETRES
            * ngs.dx
        )

    return stress_work(e, g), stress_work(e, h) + stress_work(f, g), stress_work(f, h)


def foundation(u, v, edge, springs):
    r"""Virtual work of springs to ground per radian.

    .. math:: b(u, v) = \int (k_x u_x v_x + k_r u_r v_r + k_t u_t v_t)\,r\,ds

    Parameters
    ----------
    u, v : ngsolve proxies (3,)
        trial and test displacement
    edge : ngsolve.Region
        where the springs are
    springs : tuple of float (3,)
        k_x, k_r, k_t per area [N/m^3], >= 0

    Returns
    -------
    ngsolve.SumOfIntegrals
        the same for all harmonics

    Source
    ------
    Virtual work in cylindrical coordinates; derived here.
    """
    work = sum(k * u[i] * v[i] for i, k in enumerate(springs))
    return work * radius / MILLIMETRES**2 * ngs.ds(definedon=edge)


def edge_pressure(v, edge, pressure):
    r"""Virtual work of a load per length and radian along an edge.

    .. math:: g(v) = \int p\,v\,ds

    Parameters
    ----------
    v : ngsolve proxy
        a component of the test displacement
    edge : ngsolve.Region
        where the load is
    pressure : ngsolve.CoefficientFunction
        p [1/mm], along the component; with a shape function the form reads the generalised displacement

    Source
    ------
    Virtual work in cylindrical coordinates; derived here.
    """
    return pressure * v * ngs.ds(definedon=edge)


def centrifugal(v, density, speed):
    r"""Virtual work of rotation about the axis per radian, for n = 0.

    .. math:: f(v) = \int \rho\,\omega^2\,r\,v_r\,r\,dx\,dr

    Parameters
    ----------
    v : ngsolve proxy (3,)
        test displacement
    density : float or ngsolve.CoefficientFunction
        rho [kg/m^3]
    speed : float
        omega [rad/s]

    Source
    ------
    Virtual work in cylindrical coordinates; derived here.
    """
    return density * speed**2 / MILLIMETRES**4 * radius**2 * v[1] * ngs.dx


def thermal(v, bulk, expansion):
    r"""Virtual work of a free expansion per radian, for n = 0.

    .. math:: f(v) = \int 3 K\,\varepsilon_T\,(v_{x,x} + v_{r,r} + v_r/r)\,r\,dx\,dr

    Parameters
    ----------
    v : ngsolve proxy (3,)
        test displacement
    bulk : float or ngsolve.CoefficientFunction
        K = lambda + 2 mu/3 [Pa]
    expansion : float or ngsolve.CoefficientFunction
        epsilon_T = alpha (T - T0) [-], positive when it grows

    Source
    ------
    Timoshenko, Goodier, Theory of Elasticity, ch. 13 (thermal stress as a body force with a pressure).
    """
    plain, _ = strain(v)
    return 3 * bulk * expansion * (plain[0] + plain[1] + plain[2]) * radius / MILLIMETRES**2 * ngs.dx
