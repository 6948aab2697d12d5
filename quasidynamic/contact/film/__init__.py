"""How thick the lubricant film is: fully flooded, starved, and against the roughness; no traction."""
