"""Who turns how fast: kinematics of rollers and balls, slip in their contacts, lines without slip.

No load law and no balance: forces come in as arguments at most.
"""
