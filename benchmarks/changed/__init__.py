"""Files and command lines that were changed at random, a kind of input in each module."""
