"""The one file of an archive (ZIP) that is wanted, unpacked in memory: nothing is written anywhere."""

import zipfile
import zlib
from io import BytesIO
from pathlib import PurePosixPath

from flexbearing.inputs.file import ARCHIVE, Unreadable, size

BEGINNING = b"PK\x03\x04"
MEMBERS = 100
_METHODS = zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED
_BAD = zipfile.BadZipFile, zlib.error, EOFError, ValueError, NotImplementedError, RuntimeError


def unpacked(content: bytes, endings: tuple[str, ...], most: int) -> tuple[bytes, tuple[str, ...]]:
    """Unpack the only file of an archive whose name has one of the endings, in small letters.

    Its content comes with the names of all other files; `most` bytes are the most that it may have.
    Raises `Unreadable` for no archive, none or several such files, names that lead out of a folder, an
    encrypted or larger file, which is not unpacked.
    """
    if len(content) > ARCHIVE:
        raise Unreadable(f"is an archive larger than {size(ARCHIVE)}")
    try:
        with zipfile.ZipFile(BytesIO(content)) as archive:
            members = [each for each in archive.infolist() if not each.is_dir()]
            wanted = _only([each.filename for each in members], endings)
            return _content(archive, members[wanted], most), tuple(
                each.filename for place, each in enumerate(members) if place != wanted
            )
    except Unreadable:
        raise
    except _BAD as problem:
        raise Unreadable("is a damaged archive") from problem


def _only(names: list[str], endings: tuple[str, ...]) -> int:
    """Place of the only wanted name; hidden files are those of operating systems."""
    if len(names) > MEMBERS:
        raise Unreadable(f"is an archive of {len(names)} files; at most {MEMBERS} are allowed")
    if any(".." in name or "\\" in name or ":" in name or name.startswith("/") for name in names):
        raise Unreadable("is an archive with a name that leads out of its folder")
    wanted = [
        place
        for place, name in enumerate(names)
        if name.lower().endswith(endings) and not PurePosixPath(name).name.startswith(".")
    ]
    if len(wanted) != 1:
        raise Unreadable(f"is an archive with {len(wanted)} files {' or '.join(endings)}; one is allowed")
    return wanted[0]


def _content(archive: zipfile.ZipFile, member: zipfile.ZipInfo, most: int) -> bytes:
    if member.flag_bits & 1 or member.compress_type not in _METHODS:
        raise Unreadable("is an archive that is encrypted or compressed by another method than deflate")
    with archive.open(member) as file:
        found = file.read(most + 1)
    if len(found) > most:
        raise Unreadable(f"is larger than {size(most)} when unpacked")
    return found
