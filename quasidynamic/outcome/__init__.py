"""What a solved state means: torque, losses, life, stiffness, skew; nothing here moves the state.

Every outcome is imported from its module, so that a roller bearing loads no ball.
"""
