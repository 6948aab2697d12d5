"""Whole solids: factored once, condensed or solved under given loads; displacements and stresses.

Bodies of revolution on their axial section belong to `fem.section`, half a pitch of a cage to
`fem.squirrel_cage`.
"""
