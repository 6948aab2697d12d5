"""Stiffness matrices of other finite element programs: read, and condensed to the nodes of a seat.

Only numbers and their places are known here: rings and meshes are unknown.
"""
