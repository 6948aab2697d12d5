"""Weak forms, load vectors, factorisation and static condensation: the only caller of NGSolve's solvers."""
