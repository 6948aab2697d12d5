"""What the bearing is made of: frozen data in SI units, refused when no such part can exist.

No physics beyond masses and dimensions. Every part is imported from its module, so that a roller bearing
loads no ball.
"""
