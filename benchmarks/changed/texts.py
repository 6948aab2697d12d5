"""Texts, numbers and names of files far from what anyone means."""

from tests.mutated_cases import NUMBERS, UNITS

DIGITS = 5000 * "9"
FORMULA = "=cmd|' /C calc'!A0"
ABSURD = (
    "", " ", ".", "-", "--", "=", "=1", "x=1", "nan", "inf", "-inf", "1e400", "1e-320", "-0", "0", "-1",
    "1.5", "5", "mm", "5 mm", "-5 mm", "0 mm", "nan mm", "inf mm", "1e400 mm", "1e308 mm", "1e-320 mm",
    "1e-9 mm", "1e9 mm", "5 parsec", "1 um^9^9^9", "5 mm 5 mm", "5,5 mm", "٣ mm", "１２ mm", "5\u00a0mm",
    "5 mm\n", "1_000 mm", DIGITS, DIGITS + " mm", "a" * 300, "a" * 5000, "(" * 200, "[" * 5000, "{a=1}", "'",
    '"', "$x^2$", "$\\frac{", "%s%n", "{0}", "{x", FORMULA, "\x1b[31mred", "a\nb", "a\tb", "\u202eabc", "é",
    "\udcff", "\x7f", "True", "None", "../../x", "/dev/null", "<b>x</b>", "</script>", "&amp;", "0x10",
    "1e5", "1e5 mm", "20 rpm", "20 kN", "20 degC", "-300 degC", "1e99 degC", "50 deg", "500 deg",
)  # fmt: skip
PATHS = (
    "", ".", "..", "/", "-", "pipe", "folder", "zero", "null", "full", "loop", "nowhere", "missing",
    "missing/x", "case.toml/x", "n" * 300, "n" * 5000, "a\x1b[2Jb", "a\nb", "é", "\udcff", "~", "~x",
    "$HOME", "x.part", "x.tmp", "/proc/self/mem", "/proc/self/environ", "/sys/kernel/x", "case.toml", "x.h5",
    "x.csv", "x.toml", "-x", "*", "a b",
)  # fmt: skip
FAR = ("..", "/")  # where an output would leave the folder of the input


def quantity(rng) -> str:
    """A number, possibly with a unit."""
    return f"{rng.choice(NUMBERS)} {rng.choice(UNITS)}".strip() if rng.random() < 0.6 else rng.choice(ABSURD)
