"""The coupling with its real partners: bearing and rings, methods in order, initial states, stored states.

Here belongs what turns a case and its models into partners and attempts; the loop itself knows neither.
"""
