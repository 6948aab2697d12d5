"""Squirrel cages by cyclic symmetry: half a pitch of bar and slot stands for the whole.

Section forces of bars belong here, too; cages with smeared bars are sections, in `fem.section`.
"""
