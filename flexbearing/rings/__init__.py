"""From a case to the structures that carry its raceways: rigid, condensed, in a fit, or solved in full.

Here belong the choice of discretisation and what answers the rollers of one race; the pair of both and the
sign of forces are the coupling's, equations and meshes are those of `fem`.
"""
