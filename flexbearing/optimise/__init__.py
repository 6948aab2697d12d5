"""The best design of a bearing: which values of its keys make an output best within limits of others."""
