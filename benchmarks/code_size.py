"""Size of a code base as a reader meets it: files per folder, lines per file, length of functions.

`python -m benchmarks.code_size [FOLDER ...]`, by default the three packages. Blank lines, comments and
docstrings are no lines of code here. A private function counts as used once when its name stands at one
other place of its file.
"""

import ast
import re
import sys
from collections import Counter
from pathlib import Path
from statistics import median

PACKAGES = ("quasidynamic", "fem", "flexbearing")
SHORT = 6  # lines of a function that may say no more than its call


def code_lines(source: str, node: ast.AST) -> int:
    """Lines that hold code, without blank lines, comments and docstrings."""
    first, last = (node.lineno, node.end_lineno) if hasattr(node, "lineno") else (1, source.count("\n") + 1)
    documented = set()
    for inner in ast.walk(node):
        if isinstance(inner, ast.FunctionDef | ast.ClassDef | ast.Module) and ast.get_docstring(
            inner, clean=False
        ):
            text = inner.body[0]
            documented |= set(range(text.lineno, text.end_lineno + 1))
    lines = source.splitlines()[first - 1 : last]
    return sum(
        1
        for number, line in enumerate(lines, first)
        if line.strip() and not line.strip().startswith("#") and number not in documented
    )


def report(folder: Path) -> None:
    """Print the figures of one package."""
    sources = {path: path.read_text() for path in sorted(folder.rglob("*.py"))}
    trees = {path: ast.parse(text) for path, text in sources.items()}
    code = {path: code_lines(text, trees[path]) for path, text in sources.items()}
    functions, private, once = [], [], []
    for path, tree in trees.items():
        names = Counter(re.findall(r"\w+", sources[path]))
        for node in (node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)):
            functions.append(length := code_lines(sources[path], node))
            if node.name.startswith("_") and not node.name.endswith("__"):
                private.append(length)
                if names[node.name] == 2:
                    once.append(length)
    rooms = Counter(path.parent for path in sources if path.name != "__init__.py")
    lengths = sorted(functions)
    total = sum(len(text.splitlines()) for text in sources.values())
    fullest = ", ".join(f"{room.relative_to(folder.parent)} {count}" for room, count in rooms.most_common(3))
    often = f"{median(code.values()):.0f} median, {max(code.values())} most"
    tenth = f"{lengths[int(0.9 * len(lengths))]} ninth decile, {lengths[-1]} most"
    brief = sum(length <= SHORT for length in once)
    print(f"{folder.name}: {total} lines in {len(sources)} files, {sum(code.values())} of code")
    print(f"  lines of code in a file: {often}")
    print(f"  folders {len(rooms)}, files in one: {median(rooms.values()):.0f} median; fullest: {fullest}")
    print(f"  functions {len(functions)}, lines of code: {median(lengths):.0f} median, {tenth}")
    print(f"  private functions {len(private)}, used once {len(once)}, of these within {SHORT} lines {brief}")


if __name__ == "__main__":
    for name in sys.argv[1:] or PACKAGES:
        report(Path(name))
