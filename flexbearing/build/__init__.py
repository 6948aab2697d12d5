"""From a case to the frozen parts and models of `quasidynamic` and `fem`; nothing is solved here."""
