"""What the operating system gives a program: cores, signals that end it, streams that it writes to.

Signals and streams are for `flexbearing.__main__` alone: a library leaves them to the program that calls it.
"""
