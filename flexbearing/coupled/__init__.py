"""The coupling with its real partners: bearing and rings, methods in order, initial states, stored states."""
