"""The point contact of a ball and a groove: Hertz ellipse, and Coulomb friction that slides all over it.

The motion of balls that gives the slip belongs to `motion`, what balances its friction to `balance`.
"""
