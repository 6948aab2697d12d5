"""What the bearing is made of: frozen data in SI units."""
