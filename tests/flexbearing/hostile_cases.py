"""Case files and settings that were made to break or to exhaust the reader, each refused."""

from collections.abc import Callable

from tests.places import CONFIGS

GOOD = (CONFIGS / "mao2016.toml").read_text()
MANY = 5000
LONG = 60_000  # characters: just within what a case file may hold


def _beside(lines: str) -> bytes:
    """The good case with more above its sections."""
    return (lines + "\n" + GOOD).encode()


def _replaced(old: str, new: str) -> bytes:
    assert old in GOOD
    return GOOD.replace(old, new, 1).encode()


def _clearance(value: str) -> bytes:
    return _replaced('clearance = "75.5 um"', f"clearance = {value}")


def _filled(line: Callable[[int], str], size: int = LONG) -> str:
    """As many different lines as fit."""
    lines, length, number = [], 0, 0
    while length < size:
        lines.append(line(number))
        length, number = length + len(lines[-1]), number + 1
    return "".join(lines)


def _on_lines(azimuths: str) -> bytes:
    """A ring on lines at these azimuths."""
    return (
        GOOD[: GOOD.index("[outer]")]
        + '[outer]\nkind = "ring"\nthickness = "3.6 mm"\nwidth = "8 mm"\nsupport = "lines"\n'
        + f"line_azimuths = [{azimuths}]\n"
        + GOOD[GOOD.index("[inner]") :]
    ).encode()


FILES: dict[str, bytes] = {
    "one byte more than allowed": b"#" * (2**16 + 1),
    "empty": b"",
    "no text": bytes(range(256)),
    "UTF-16": GOOD.encode("utf-16"),
    "half a character": GOOD.encode() + b"\xc3",
    "NUL in the file": GOOD.encode() + b"\x00",
    "NUL in a value": _replaced('clearance = "75.5 um"', 'clearance = "75.5 um\\u0000"'),
    "NUL in the name of the drawing": (CONFIGS / "step_ring.toml")
    .read_bytes()
    .replace(b"step_ring.step", b"step\\u0000.step"),
    "name of the drawing that is too long": (CONFIGS / "step_ring.toml")
    .read_bytes()
    .replace(b"step_ring.step", b"s" * 5000),
    "drawing that is a device": (CONFIGS / "step_ring.toml")
    .read_bytes()
    .replace(b'"step_ring.step"', b'"/dev/zero"'),
    "drawing that is a folder": (CONFIGS / "step_ring.toml")
    .read_bytes()
    .replace(b'"step_ring.step"', b'"."'),
    "arrays in arrays": _beside(f"x = {'[' * 20_000}{']' * 20_000}"),
    "arrays in arrays, not closed": _beside(f"x = {'[' * LONG}"),
    "tables in tables": _beside(f"x = {'{a=' * 15_000}1{'}' * 15_000}"),
    "arrays in a value": _clearance("[" * 20_000 + "]" * 20_000),
    "key of many parts": _beside(f"{'a.' * 25_000}a = 1"),
    "section of many parts": _beside(f"[{'a.' * 25_000}a]\nb = 1"),
    "quoted key of many parts": _beside('"a".' * 12_000 + '"a" = 1'),
    "spaced key of many parts": _beside("a . " * 12_000 + "a = 1"),
    "many keys of many parts": _beside(_filled(lambda n: f"{'a.' * 500}k{n} = 1\n", 55_000)),
    "many keys in a section of many parts": (
        GOOD + f"[{'a.' * 10_000}a]\n" + _filled(lambda n: f"{n:x}=1\n", 35_000)
    ).encode(),
    "unknown keys": _beside(_filled(lambda n: f"clearanse{n} = 1\n", 55_000)),
    "short unknown keys": _beside(_filled(lambda n: f"{n:x}=1\n", 55_000)),
    "unknown sections": (GOOD + _filled(lambda n: f"[beering{n}]\n", 55_000)).encode(),
    "unknown keys of a section": _replaced(
        "[bearing]", "[bearing]\n" + _filled(lambda n: f"clearanse{n} = 1\n", 55_000)
    ),
    "unknown keys of other kinds": (
        GOOD + "[operation.load]\n" + _filled(lambda n: f"radial_{n} = 1\n", 55_000)
    ).encode(),
    "unknown keys with lists of each other": _beside(
        _filled(lambda n: f"k{n} = [" + "1," * 500 + "]\n", 55_000)
    ),
    "long key": _beside(f"{'a' * 55_000} = 1"),
    "long key like one of the case": _replaced("clearance =", f"{'clearance' * 6000} ="),
    "long value": _clearance(f'"{"a" * 55_000}"'),
    "long number": _clearance(f'"{"1" * 55_000} um"'),
    "long number with a long unit": _clearance(f'"75.5 {"u" * 55_000}"'),
    "spaces and no unit": _clearance(f'"75.5{" " * 55_000}"'),
    "spaces and half a unit": _clearance(f'"75.5{" " * 27_000}u{" " * 27_000}\\n"'),
    "towering powers": _clearance('"41 um^9^9^9^9"'),
    "large power": _clearance('"41 um^999999999"'),
    "brackets in brackets": _clearance(f'"41 {"(" * 39}m"'),
    "beyond the largest float": _clearance('"1e999 um"'),
    "integer of 5000 digits": _clearance("1" * 5000),
    "integer of 4000 digits": _clearance("1" * 4000),
    "hexadecimal integer of 50 000 digits": _clearance("0x" + "f" * 50_000),
    "hexadecimal integer where an integer stands": _replaced("rollers = 30 ", f"rollers = 0x{'f' * 50_000} "),
    "hexadecimal integer where a number stands": _replaced(
        "poisson_ratio = 0.3\n", f"poisson_ratio = 0x{'f' * 50_000}\n"
    ),
    "exponent of 5000 digits": _clearance("1e" + "9" * 5000),
    "assumed of many": _replaced("assumed = [", "assumed = [" + _filled(lambda n: f'"k{n}",\n', 55_000)),
    "assumed of numbers": _replaced("assumed = [", "assumed = [" + "1," * 27_000),
    "assumed of lists": _replaced("assumed = [", "assumed = [" + "[]," * 18_000),
    "assumed of many parts": _replaced("assumed = [", f'assumed = ["{"a." * 25_000}a",'),
    "calibrated of many": _replaced(
        "\n[calibrated]\n", "\n[calibrated]\n" + _filled(lambda n: f'k{n} = ""\n', 55_000)
    ),
    "calibrated of numbers": _replaced(
        "\n[calibrated]\n", "\n[calibrated]\n" + _filled(lambda n: f"k{n} = 1\n", 55_000)
    ),
    "list where a number stands": _clearance("[" + "1," * 27_000 + "]"),
    "table where a number stands": _clearance("{" + _filled(lambda n: f"k{n}=1,", 55_000)[:-1] + "}"),
    "calibrated of many parts": _replaced("\n[calibrated]\n", f'\n[calibrated]\n"{"a." * 25_000}a" = ""\n'),
    "list of texts": _on_lines('"1 m",' * 9000),
    "list of units": _on_lines(_filled(lambda n: f'"1 {"m*" * 15}k{n}",', 55_000)),
    "list of wrong units": _on_lines(
        _filled(lambda n: f'"1 deg^{n % 4}/rad^{n % 3}*m/inch^{n % 2}",', 55_000)
    ),
    "more lines than can stand around a ring": _on_lines(_filled(lambda n: f'"{n / 100:.2f} deg",', 50_000)),
    "kind in a list": _beside('kind = ["x"]'),
    "kind in a table": _beside("kind = {a = 1}"),
    "kind that is long": _beside(f'kind = "{"x" * 55_000}"'),
    "kind that is a number": _beside("kind = 1"),
    "kind of the bearing in a list": _replaced('kind = "cylindrical_roller"', 'kind = ["x"]'),
    "kind of the ring in a list": _replaced('kind = "squirrel_cage"', 'kind = ["x"]'),
    "kind of the ring in a table": _replaced('kind = "squirrel_cage"', "kind = {x = 1}"),
    "value where a section stands": b'title = "x"\nbearing = 3\nouter = "x"\ninner = []\n',
    "sections in a list": GOOD.replace("[bearing]", "[[bearing]]", 1).encode(),
    "date": _clearance("2026-11-22"),
    "date and time": _clearance("2026-11-22T10:00:00Z"),
    "time": _replaced("rollers = 30 ", "rollers = 10:00:00 "),
    "not a number": _replaced("poisson_ratio = 0.3\n", "poisson_ratio = nan\n"),
    "infinite": _replaced("poisson_ratio = 0.3\n", "poisson_ratio = inf\n"),
    "truth where an integer stands": _replaced("rollers = 30 ", "rollers = true "),
    "truth where a number stands": _replaced("poisson_ratio = 0.3\n", "poisson_ratio = true\n"),
    "truth where a length stands": _clearance("true"),
    "number where a title stands": b"title = 3\n",
    "escape sequences": _clearance('"\\u001b[31mred\\u0007"'),
    "escape sequences in a key": _beside('"\\u001b[31mred" = 1'),
    "lines in a key": _beside('"a\\nb" = 1'),
    "lines in a value": _clearance('"""a\n\n\nb"""'),
    "text that runs from right to left": _clearance('"\\u202e75.5 um"'),
    "escaped surrogate": _clearance('"\\ud800"'),
    "raw surrogate": _clearance('"x"').replace(b'"x"', b'"\xed\xa0\x80"'),
    "quotes not closed": _beside('x = """' + '\\"""' * 14_000),
    "texts in all their quotes": _beside("x = [" + "'''''',\"\"," * 5000 + "]"),
    "deep behind a text that ends in quotes": _beside(f'x = ["""a"""", {"[" * 20_000}{"]" * 20_000}]'),
    "parts behind a text that ends in quotes": _beside(f'x = ["""a"""", {{{"a." * 20_000}a = 1}}]'),
    "deep behind quotes in a comment": _beside(f'# """\nx = {"[" * 20_000}{"]" * 20_000}'),
    "deep behind an apostrophe": _beside(f'"it\'s" = {"[" * 20_000}{"]" * 20_000}'),
}

SETTINGS: dict[str, list[str]] = {
    "many settings": [f"outer.bars={n}" for n in range(1, MANY)] + ["x=1"],
    "many settings of keys that are none": [f"clearanse{n}=1" for n in range(MANY)],
    "many calibrated": [f"calibrated.k{n}=1" for n in range(MANY)],
    "many calibrated, one after the other": ["calibrated.outer.bars=x"] * MANY + ["x=1"],
    "long key": [f"{'a' * 100_000}=1"],
    "key of many parts": [f"{'a.' * 50_000}a=1"],
    "calibrated key of many parts": [f"calibrated.{'a.' * 50_000}a=1"],
    "long value": [f"bearing.clearance={'a' * 100_000}"],
    "long quoted value": [f'bearing.clearance="{"a" * 100_000}"'],
    "value of long integers": [f"outer.bars={'1' * 5000}"],
    "value of dotted keys": ["title={" + "a." * 50_000 + "a=1}"],
    "arrays in arrays": [f"bearing.clearance={'[' * 30_000}{']' * 30_000}"],
    "arrays in arrays as kind": [f"kind={'[' * 30_000}{']' * 30_000}"],
    "section as a value": ["bearing=1"],
    "section as a list": ["bearing=[1]", "bearing.rollers=30"],
    "kind in a list": ["bearing.kind=['x']"],
    "kind of the ring in a table": ["outer.kind={x=1}"],
    "two lines": ["bearing.rollers=30\nbearing.clearance='1 um'"],
    "two values": ["bearing.rollers=30\nvalue=40"],
    "two sections": ["bearing.rollers=30\n[x]"],
    "NUL": ["bearing.clearance=\x00"],
    "surrogate": ["bearing.clearance=\udcff"],
    "surrogate in the key": ["bearing.\udcff=1"],
    "surrogate in the title": ["title=\udcff"],
    "escape sequences": ["\x1b[31m=1", "bearing.rollers=\x1b[31m"],
    "fields of one ball many times": ["fields.balls=[" + "0," * 10_000 + "]"],
    "nothing": [""],
    "no key": ["=1"],
    "no value": ["bearing.clearance="],
    "dots": ["...=1"],
    "no value of a choice": ["bearing.kind="],
}
