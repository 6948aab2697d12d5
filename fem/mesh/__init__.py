"""From frozen parts to curved meshes with named bodies and boundaries; no equation is assembled here."""
