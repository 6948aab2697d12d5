"""From frozen parts to curved meshes with named bodies and boundaries.

No equation is assembled here; what a part may look like is checked in `fem.parts`.
"""
