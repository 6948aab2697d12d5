"""What must vanish in a ball bearing, with its derivatives: forces on balls and ring, moments of friction.

Nothing iterates here: searches belong to `solve.balls`; a race control that searches is handed in.
"""
