"""Weak forms, load vectors, factorisation and static condensation: the only caller of NGSolve's solvers.

Geometry belongs to `fem.mesh`; which loads are solved for, and what follows from it, to the rooms above.
"""
