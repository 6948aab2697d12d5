"""Who turns how fast: no forces."""
