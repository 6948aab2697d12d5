"""What the operating system gives a program: signals that end it, streams that it writes to.

Only `flexbearing.__main__` uses it: a library leaves both to the program that calls it.
"""
