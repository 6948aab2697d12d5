"""From a case to the frozen parts and models of `quasidynamic` and `fem`.

Here belong expansion by heat and the choice of a model by the words of a case; nothing is solved, no law is
written. Each module is imported by whom it concerns, so that a roller case loads no ball code.
"""
