"""What touches the cage: roller pockets, the guiding land and the fluid sheared between them."""
