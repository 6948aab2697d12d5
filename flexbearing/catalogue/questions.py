"""Questions on a terminal for what a catalogue page lacks."""

import sys
from collections.abc import Mapping

import typer

from flexbearing.case import BadCase
from flexbearing.catalogue.entries import LIKES
from flexbearing.catalogue.page import allowed, called, value


def answers(like: str, given: Mapping[str, str]) -> dict[str, str]:
    """Ask for every entry that is not given; Enter leaves out what may be left out."""
    found: dict[str, str] = {}
    wanted = LIKES.get(like)
    for name in wanted.taken if wanted else ():
        assert wanted is not None
        known = {*given, *found}
        if wanted.has_use(name, known):
            answer = _answer(name, like, wanted.must_be_given(name, known))
            found |= {name: answer} if answer else {}
    return found


def _answer(name: str, like: str, must: bool) -> str:
    """An answer that can be read, or nothing where it may be left out."""
    question = f"{called(name)}, {allowed(name, like)}{'' if must else '; Enter: not given'}"
    while True:
        answer = typer.prompt(question, default=None if must else "", show_default=False)
        try:
            if answer:
                value(name, answer, like)
            return answer
        except BadCase as problem:
            sys.stdout.write(f"{problem}\n")
