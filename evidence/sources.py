"""Which files predictions were computed from again, and whether these files are as they were."""

import ast
import hashlib
import json
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path

from evidence.stored import DOCS, ROOT

CHECKED = DOCS / "checked.json"
PACKAGES = ("evidence", "fem", "flexbearing", "quasidynamic", "tests")
Digests = dict[str, str]  # by file


def digest_of(file: str) -> str:
    """Eight characters that name the contents of a file, of a module without comments and layout."""
    text = (ROOT / file).read_text()
    contents = ast.dump(ast.parse(text)) if file.endswith(".py") else text
    return hashlib.sha256(contents.encode()).hexdigest()[:8]


def loaded() -> Digests:
    """Modules of the project that this process has loaded, and the versions of others."""
    files = {Path(file) for module in [*sys.modules.values()] if (file := getattr(module, "__file__", None))}
    own = {str(file.relative_to(ROOT)) for file in files if file.is_relative_to(ROOT)}
    named = sorted(file for file in own if file.startswith(tuple(f"{name}/" for name in PACKAGES)))
    return {file: digest_of(file) for file in (*named, "requirements.lock")}


def write(pages: Mapping[str, Digests]) -> None:
    """Store what pages were computed from; files of the same pages side by side."""
    known = {**_read(), **pages}
    users = dict[tuple[str, str], list[str]]()
    for name, files in sorted(known.items()):
        for file, digest in files.items():
            users.setdefault((file, digest), []).append(name)
    groups = dict[tuple[str, ...], Digests]()
    for (file, digest), names in sorted(users.items()):
        groups.setdefault(tuple(names), {})[file] = digest
    entries = [{"pages": names, "files": files} for names, files in groups.items()]
    CHECKED.write_text(json.dumps(entries, indent=1) + "\n")


def _read() -> dict[str, Digests]:
    """Files of each page by their digests when it was computed."""
    found = dict[str, Digests]()
    for group in json.loads(CHECKED.read_text()) if CHECKED.exists() else ():
        for name in group["pages"]:
            found.setdefault(name, {}).update(group["files"])
    return found


def touched(names: Iterable[str]) -> list[str]:
    """Those pages that were never computed, or from files that are others now."""
    known = _read()
    now = {file: digest_of(file) for files in known.values() for file in files if (ROOT / file).exists()}
    return [
        name
        for name in names
        if name not in known or any(now.get(file) != digest for file, digest in known[name].items())
    ]
