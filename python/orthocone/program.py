# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The program as a process of its own: where it is, what it prints, and how it ends."""
import functools
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import typing

_HERE = pathlib.Path(__file__)


class ProgramError(RuntimeError):
    """Raised when the program does not do what was asked for, with its own message; the classes below are for its exit codes.
    A signal that ends the program, such as that of a machine without memory, raises this class itself.

    code: the exit code of docs/manual.md, The command line; -N where signal N has ended the program. details: all that
    the program has said of the error."""

    def __init__(self, message, code=None, details=""):
        super().__init__(message)
        self.code, self.details = code, details

    def __reduce__(self):  # with all arguments, or another process cannot make it again
        return type(self), (str(self), self.code, self.details), vars(self)


class WrongInput(ProgramError, ValueError):
    """Raised for exit code 2: an entry or an option is wrong, or the model does not fit into the machine."""


class UnknownEntry(WrongInput, KeyError):
    """Raised for the name of an entry that the program does not know. It is a KeyError, too."""

    __str__ = Exception.__str__  # KeyError would show the quotation marks of a word of Python


class UnsolvedStep(ProgramError):
    """Raised for exit code 3: a load step could not be solved, or failed a check. `run` is the Run with the steps before."""

    run = None


class FileError(ProgramError):
    """Raised for exit code 4: a file could not be read or written, or the program is not there."""


_ERRORS = {2: WrongInput, 3: UnsolvedStep, 4: FileError}
_INTERRUPTED = 130


def find_program():
    """The path of the program: what the environment variable ORTHOCONE names, or the program of the build folder or prefix
    that this module lies in, or the first one of the PATH."""
    named = os.environ.get("ORTHOCONE")
    if named:
        if found := shutil.which(named):
            return found
        raise FileError(f"ORTHOCONE = {named}: is no program; allowed is the path of the program orthocone")
    here, source = list(_HERE.absolute().parents), list(_HERE.resolve().parents)
    # This file lies in build/python/orthocone, in python/orthocone, or in PREFIX/lib/pythonX.Y/dist-packages/orthocone.
    places = [here[2] / "orthocone", source[2] / "build/orthocone", *(folder / "bin/orthocone" for folder in here[4:5])]
    for place in places:
        if place.is_file() and os.access(place, os.X_OK):
            return str(place)
    if found := shutil.which("orthocone"):
        return found
    raise FileError("the program orthocone is neither beside this module nor in the PATH: './run' of its sources builds it, "
                    "its Debian package installs it, or the environment variable ORTHOCONE names it")


def call(arguments, on_line=None):
    """Runs the program, and returns what it prints. on_line: a function that takes each line instead, when it is printed.

    Ctrl-C, and errors of on_line, let the program finish its iteration and write its checkpoint; a second Ctrl-C ends it at
    once. Raises ProgramError, and KeyboardInterrupt where the program was interrupted."""
    printed = []
    with tempfile.TemporaryFile() as errors:
        try:
            process = subprocess.Popen([find_program(), *map(str, arguments)], stdin=subprocess.DEVNULL,
                                       stdout=subprocess.PIPE, stderr=errors, encoding="utf-8", errors="replace")
        except OSError as error:
            raise FileError(f"{error.filename or 'orthocone'}: the program cannot be started ({error.strerror})") from error
        try:
            for line in process.stdout:
                (on_line or printed.append)(line)
            process.wait()
        except BaseException:
            _end(process)
            raise
        finally:
            process.stdout.close()
        errors.seek(0)
        _raise_error(process.returncode, errors.read().decode("utf-8", "replace").strip())
    return "".join(printed)


def _end(process):
    """Asks the program to stop, and waits. A terminal has sent Ctrl-C to the program as well, for which the same signal once
    more would be a second Ctrl-C; so it is asked by another one."""
    process.terminate()
    try:
        process.stdout.read()
        process.wait()
    except BaseException:
        process.kill()
        process.wait()
        raise


def _raise_error(code, said):
    if code == 0:
        return
    # Libraries may have words of their own before it.
    message = re.search(r"^orthocone: (.*)", said, re.MULTILINE)
    line = message[1] if message else said.partition("\n")[0]
    if code == _INTERRUPTED:
        raise KeyboardInterrupt(line)
    if code < 0:
        line = f"the program was ended by signal {-code}" + (f" ({line})" if line else "")
    raise _ERRORS.get(code, ProgramError)(line or f"the program has ended with exit code {code}", code, said)


class Entry(typing.NamedTuple):
    """What the program knows of an entry: the text of its default, and whether it names a file."""

    default: str
    is_path: bool


def entries():
    """{"Section/Entry": Entry} of all entries, in the program's order."""
    program = find_program()
    return _entries_of(program, os.stat(program).st_mtime_ns)


@functools.lru_cache(maxsize=4)
def _entries_of(_, __):
    schema = json.loads(call(["--schema"]), parse_int=str, parse_float=str)  # numbers as the program writes them
    return {f"{section}/{name}": Entry(entry["default"], entry.get("format") == "path")
            for section, entries_there in schema["properties"].items()
            for name, entry in entries_there.get("properties", {}).items()}
