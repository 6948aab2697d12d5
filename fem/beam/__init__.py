"""Rings as closed curved beams on springs, in closed form per harmonic.

Nothing here has a mesh or loads NGSolve; what a mesh resolves on a section belongs to `fem.section`.
"""
