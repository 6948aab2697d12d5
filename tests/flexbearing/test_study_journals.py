"""The journal of a study: what was finished is there again, whatever ended the process that wrote it."""

import errno
import json
import os
from math import inf, isnan, nan
from zlib import crc32

import pytest
from hypothesis import given, settings, strategies as st

from flexbearing.files import BadOutput, NotStored
from flexbearing.findings.row import RowFinding, information
from flexbearing.studies.plan import Row, Task, Variant
from flexbearing.studies.plan.task import Base
from flexbearing.studies.table import journal

NAMES = "life_L10 [h]", "cage_slip [%]"


def row(identity, *numbers, status="converged", message="", findings=()):
    return Row(identity, status, message, 0.125, dict(zip(NAMES, numbers, strict=False)), findings)


FOUND = (
    RowFinding("contact-pressure", "danger", 4.5e9, 4e9, ("inner raceway",)),
    information("seen", 'a "text"'),
)
ROWS = [
    row("a", 1.5, 0.1, findings=FOUND),
    row("b", inf, -2e-300),
    row("c", status="not solved", message='"line"\nbreak'),
]


@pytest.fixture
def path(tmp_path):
    return tmp_path / f"s{journal.SUFFIX}"


def write(path, *rows, names=NAMES):
    with journal.opened(path, names) as kept:
        for each in rows:
            kept.add([each])


def test_rows_come_back_as_they_were(path):
    write(path, *ROWS)
    back = journal.read(path)
    assert back["a"] == ROWS[0]
    assert back["b"] == ROWS[1]
    assert (back["c"].status, back["c"].message) == ("not solved", '"line"\nbreak')
    assert all(isnan(back["c"].values[name]) for name in NAMES)


def test_without_a_journal_there_are_no_rows(path):
    assert journal.read(path) == {}


def test_a_row_that_is_written_again_takes_the_place_of_the_first(path):
    write(path, row("a", status="not solved"))
    write(path, row("a", 3.0, 4.0))
    assert journal.read(path) == {"a": row("a", 3.0, 4.0)}


def test_a_later_writer_may_ask_for_other_outputs(path):
    write(path, ROWS[0])
    write(path, Row("z", "converged", "", 0.0, {"max_roller_load [N]": 7.0}), names=("max_roller_load [N]",))
    back = journal.read(path)
    assert back["a"].values.keys() == {*NAMES}
    assert back["z"].values == {"max_roller_load [N]": 7.0}


def test_a_number_that_is_not_given_is_asked_for_and_absent(path):
    write(path, row("a", 1.0, nan))
    assert isnan(journal.read(path)["a"].values["cage_slip [%]"])


@pytest.mark.slow
@settings(max_examples=30)
@given(st.integers(0, 10_000))
def test_a_torn_line_loses_its_row_alone(tmp_path_factory, place):
    """Whatever part of the last line a kill leaves, those before stay, and those after are whole."""
    path = tmp_path_factory.mktemp("torn") / "s.journal.jsonl"
    write(path, ROWS[0])
    whole = path.stat().st_size
    write(path, ROWS[1])
    last = path.read_bytes()[whole:]
    path.write_bytes(path.read_bytes()[: whole + place % len(last)])
    assert set(journal.read(path)) <= {"a", "b"}
    assert journal.read(path)["a"] == ROWS[0]
    others = dict(zip(("max_roller_load [N]", "stiffness_zz [N/m]"), (5.0, 6.0), strict=True))
    write(path, Row("d", "converged", "", 0.0, others), names=tuple(others))
    assert journal.read(path)["d"].values == others
    assert journal.read(path)["a"] == ROWS[0]


def test_rows_whose_names_were_lost_are_not_taken_for_others(path):
    """A damaged line with the names of outputs: the same number of values stands under others."""
    write(path, ROWS[0])
    write(path, Row("z", "converged", "", 0.0, {"a": 1.0, "b": 2.0}), names=("a", "b"))
    content = path.read_bytes()
    path.write_bytes(content.replace(b'["a", "b"]', b'["a", "c"]'))
    assert journal.read(path).keys() == {"a"}


@settings(max_examples=40)
@given(st.integers(0, 10_000), st.integers(1, 255))
def test_a_changed_byte_is_noticed(tmp_path_factory, place, change):
    path = tmp_path_factory.mktemp("changed") / "s.journal.jsonl"
    write(path, *ROWS[:2])
    content = bytearray(path.read_bytes())
    content[place % len(content)] ^= change
    path.write_bytes(content)
    for identity, back in journal.read(path).items():
        assert back == {"a": ROWS[0], "b": ROWS[1]}[identity]


def test_one_writer_at_a_time(path):
    with journal.opened(path, NAMES), pytest.raises(BadOutput, match=r"is being written by process \d+"):
        write(path, ROWS[0])


def test_a_full_disk_is_told_and_keeps_what_was_written(path, monkeypatch):
    with journal.opened(path, NAMES) as kept:
        kept.add([ROWS[0]])

        def full(line):
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

        monkeypatch.setattr(kept, "_file", type("Full", (), {"write": staticmethod(full)}))
        with pytest.raises(NotStored, match=r"No space left on device.*goes on from there"):
            kept.add([ROWS[1]])
    assert journal.read(path) == {"a": ROWS[0]}


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs /dev/full")  # noqa: PTH110
def test_a_device_without_room_refuses_the_first_line():
    from pathlib import Path

    with (
        pytest.raises(NotStored, match="No space left"),
        open("/dev/full", "wb", buffering=0) as file,  # noqa: PTH123
    ):
        journal.Journal(file, Path("/dev/full"), NAMES)


def test_what_a_process_was_at_work_at_is_known_until_it_has_rows_or_the_process_ends(path):
    task = Task(Base(path, "", ()), (Variant((), "a"), Variant((), "b")))
    assert journal.begun(path) == frozenset()
    with journal.opened(path, NAMES) as kept:
        kept.begins(task)
        assert journal.begun(path) == {"a", "b"}
        kept.add(ROWS[:1])
        assert journal.begun(path) == {"b"}
        killed = path.read_bytes()
    assert journal.begun(path) == frozenset()
    path.write_bytes(killed)
    write(path)
    assert journal.begun(path) == {"b"}  # nothing has come of it yet
    assert journal.read(path) == {"a": ROWS[0]}


def sealed(rest: bytes) -> bytes:
    """A line with the right checksum."""
    return (journal._HEAD % crc32(b"{" + rest)).encode() + rest + b"\n"


def tampered(**parts):
    entry = {"of": journal._of(NAMES), "identity": "x", "status": "converged", "message": "", "seconds": 0.1,
             "values": [1.0, 2.0], "findings": ""} | parts  # fmt: skip
    return sealed(json.dumps(entry).encode()[1:])


FOREIGN = {
    "value is a truth value": tampered(values=[True, 2.0]),
    "value is a text": tampered(values=["5", 2.0]),
    "value is a list": tampered(values=[[1.0], 2.0]),
    "value beyond all numbers": tampered(values=[10**400, 2.0]),
    "no values": tampered(values=None),
    "too few values": tampered(values=[1.0]),
    "status is a number": tampered(status=5),
    "status controls a terminal": tampered(status="\x1b[2J"),
    "long status": tampered(status="s" * 100),
    "message is a list": tampered(message=["a"]),
    "long message": tampered(message="m" * 20_000),
    "findings of an earlier version": tampered(findings=None),
    "a finding that is none": tampered(findings='[{"code":"life","grade":"danger","value":1.0,"limit":2.0}]'),
    "half a character": tampered(message="\ud800"),
    "no seconds": tampered(seconds="fast"),
    "identity is missing": tampered(identity=None),
    "names are none": sealed(b'"names": 7}'),
    "no object": sealed(b"]"),
    "deep": sealed(b'"values": ' + b"[" * 100_000),
    "long integer": sealed(b'"seconds": ' + b"9" * 5000 + b"}"),
    "no UTF-8": sealed(b'"message": "\xff"}'),
    "another checksum": b'{"crc": "00000000", "names": []}\n',
}


@pytest.mark.parametrize("line", FOREIGN.values(), ids=FOREIGN)
def test_a_line_that_is_no_row_is_left_out_with_its_number(line, path, caplog):
    write(path, ROWS[0])
    lines = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(b"".join([*lines, line, *lines]))
    assert journal.read(path) == {"a": ROWS[0]}
    assert journal.begun(path) == frozenset()
    assert [record.getMessage() for record in caplog.records] == [f"{path}: line 3 is damaged and left out"]
