"""Squirrel cages by cyclic symmetry: half a pitch of bar and slot stands for the whole."""
