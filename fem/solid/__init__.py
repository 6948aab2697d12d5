"""Whole solids: factored once, condensed or solved under given loads; displacements and stresses."""
