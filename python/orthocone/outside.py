# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Files in folders of others: anything may stand under the name of one. What is read is an ordinary file of bounded size;
all else is a BadFile, whose words are one line. A pipe would be waited for, a device has no end, and some act when opened.
What is written takes the place of ordinary files only."""
import collections
import contextlib
import csv
import io
import json
import os
import stat
import xml.etree.ElementTree as xml
import zlib

MOST_BYTES = 1_000_000_000  # of a table, of fields, or of a mesh
MOST_BYTES_OF_TEXT = 50_000_000  # of parameters, a summary or the state of a study
MOST_LETTERS = 600  # of a message
_KINDS = ((stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a pipe"), (stat.S_ISSOCK, "a socket"), (stat.S_ISCHR, "a device"),
          (stat.S_ISBLK, "a device"))


def one_line(words, most=MOST_LETTERS):
    """The words, or an error, as a terminal may show them: no control characters, no bytes that are no text, not too many. An
    error of the system names its file and says what is wrong, without the number of the error."""
    if isinstance(words, OSError) and words.filename:
        words = f"{words.filename}: {words.strerror}"
    line = "".join(letter if letter.isprintable() else ascii(letter)[1:-1] for letter in " ".join(str(words).split()))
    return line if len(line) <= most else f"{line[:most // 2 - 2]} ... {line[3 - most // 2:]}"


class BadFile(ValueError):
    """A file that is there, but not what it should be: its path, what is wrong, and what is allowed."""

    def __init__(self, words):
        super().__init__(one_line(words))


@contextlib.contextmanager
def understood(path, what):
    """Errors of what reads a damaged file are a BadFile: it is not `what`."""
    try:
        yield
    except BadFile:
        raise
    except (xml.ParseError, zlib.error, LookupError, AttributeError, TypeError, ValueError, ArithmeticError, MemoryError,
            RecursionError) as error:
        raise BadFile(f"{path}: not {what} ({error or type(error).__name__})") from error


def check_ordinary(path, most=MOST_BYTES, found=None):
    """For those who read a file by a library."""
    found = found or os.stat(path)
    kind = next((name for is_one, name in _KINDS if is_one(found.st_mode)), None)
    if kind or not stat.S_ISREG(found.st_mode):
        raise BadFile(f"{path}: is no ordinary file, but {kind or 'a special one'}; allowed is a file of at most {most} bytes")
    if found.st_size > most:
        raise BadFile(f"{path}: has {found.st_size} bytes; allowed are at most {most}")


def content_of(path, most=MOST_BYTES):
    """The bytes of a file. It is looked at before it is opened, and again when it is open."""
    check_ordinary(path, most)
    # Without waiting, should a pipe have taken its place.
    descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    with open(descriptor, "rb") as file:
        check_ordinary(path, most, os.fstat(descriptor))
        try:
            content = file.read(most + 1) or b""
        except OSError as error:
            raise OSError(error.errno, error.strerror, str(path)) from error
    if len(content) > most:  # it grows, or its size is not known
        raise BadFile(f"{path}: has more than the {most} bytes that are allowed")
    return content


def text_of(path, most=MOST_BYTES_OF_TEXT, errors="strict"):
    """The text of a file in UTF-8. `errors` as in bytes.decode()."""
    content = content_of(path, most)
    try:
        return content.decode("utf-8", errors).removeprefix("\ufeff")
    except UnicodeDecodeError as error:
        raise BadFile(f"{path}: byte {error.start + 1} is no UTF-8; allowed is text") from error


def object_of(path):
    """The object {name: value} of a JSON file."""
    text = text_of(path)
    try:
        value = json.loads(text)
    except RecursionError as error:
        raise BadFile(f"{path}: is no JSON of a run (too many brackets in each other)") from error
    except ValueError as error:
        raise BadFile(f"{path}: is no JSON of a run ({error})") from error
    if not isinstance(value, dict):
        raise BadFile(f"{path}: is no JSON of a run; allowed is an object, {{...}}")
    return value


def rows_of(path):
    """The names of the columns of a CSV file, and its rows, which all have an entry for each of them."""
    text = text_of(path, MOST_BYTES)
    try:
        rows = [row for row in csv.reader(io.StringIO(text, newline=""), strict=True) if row]
    except csv.Error as error:
        raise BadFile(f"{path}: is no table ({error})") from error
    names, rows = (rows[0], rows[1:]) if rows else ([], [])
    for name, count in collections.Counter(names).items():
        if not name.strip() or count > 1:
            raise BadFile(f"{path}: has {count} columns '{name[:40]}'; allowed is one of each name")
    for number, row in enumerate(rows, 1):
        if len(row) != len(names):
            raise BadFile(f"{path}: row {number} has {len(row)} entries, not {len(names)}: it is incomplete or damaged")
    return names, rows


def write_whole(path, text):
    """Under its name the file is complete, or as it was. A link there is replaced, and not written through; a pipe, a device
    or a folder stays."""
    if os.path.lexists(path) and not os.path.islink(path) and not os.path.isfile(path):
        raise BadFile(f"{path}: is no ordinary file, and stays as it is")
    folder, name = os.path.split(path)
    part = os.path.join(folder, f".{name[:80]}.{os.urandom(6).hex()}.part")
    try:
        with open(part, "x", encoding="utf-8", errors="replace", newline="") as file:
            file.write(text)
        os.replace(part, path)
    except BaseException as error:
        with contextlib.suppress(OSError):
            os.unlink(part)
        if isinstance(error, OSError):
            raise OSError(error.errno, error.strerror, str(path)) from error
        raise
