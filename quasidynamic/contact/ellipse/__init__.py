"""The point contact of a ball and a groove: Hertz ellipse and Coulomb sliding in it."""
