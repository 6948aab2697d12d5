"""A squirrel cage as a whole solid with layers along its sharp edges, as half a pitch has them."""

import fem

LAYERS = 2


def refined(cage: fem.SquirrelCage, length: float, wishes: fem.MeshSize, balls: None = None):
    """The whole solid, with layers along the sharp edges as half a pitch has them."""
    import ngsolve as ngs
    from netgen import occ

    from fem.mesh.half_pitch import LAYER_RATIO, NEAR
    from fem.mesh.solid import MILLIMETRES, solids

    bodies = solids(cage, length)
    for body in bodies[1:-1]:
        for edge in body.edges:
            if abs(edge.start.x - edge.end.x) < NEAR:
                edge.hpref = 1
    glued = occ.Glue(bodies)
    for face in glued.faces:
        if face.name == "raceway":
            face.maxh = wishes.raceway_size * MILLIMETRES
    solid = occ.OCCGeometry(glued).GenerateMesh(maxh=wishes.size * MILLIMETRES, parallel_meshing=False)
    mesh = ngs.Mesh(solid)
    mesh.RefineHP(LAYERS, LAYER_RATIO)
    mesh.Curve(wishes.order)
    return mesh
