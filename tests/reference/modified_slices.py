"""a_ISO of every slice of a row of rollers, in plain loops: Formulas 31 and 33 of ISO 16281 (2025).

As the manual of a public program prints them (CHOICHOI-KIMM/AI_Seminar, CRB-main/Manual/10_FatigueLife.md).
"""


def modification(inner, outer, capacity, a_iso, cosine=1.0):
    """Factor on the life of a bearing whose inner ring turns under a load at rest.

    Loads of slices (Z, n_s) [N] at both raceways, Q_ci and Q_ce [N], a_ISO of an equivalent load [N].
    """
    rollers, slices = inner.shape
    of_inner, of_outer = (of / slices ** (7 / 9) for of in capacity)
    ratio, modified, basic = 1.038 * of_inner / of_outer, 0.0, 0.0
    for k in range(slices):
        turning, standing = (inner[:, k] ** 4).mean() ** (1 / 4), (outer[:, k] ** 4.5).mean() ** (2 / 9)
        mean = ((turning**4.5 + (ratio * standing) ** 4.5) / (1 + ratio**4.5)) ** (2 / 9)
        damage = (turning / of_inner) ** 4.5 + (standing / of_outer) ** 4.5
        modified += a_iso(0.323 * rollers * cosine * slices * mean) ** (-9 / 8) * damage
        basic += damage
    return (modified / basic) ** (-8 / 9)
