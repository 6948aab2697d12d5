"""What an elastic half-space deflects under a load patch or line: the part that contact laws already hold."""
