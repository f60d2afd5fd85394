# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Scenes: parameter files that Python changes and runs. Each run is a process of the program."""
import collections.abc
import contextlib
import copy
import dataclasses
import hashlib
import numbers
import os
import pathlib
import re
import tempfile

from . import program
from .parameter_file import entries_of, entries_of_text, with_whole_paths
from .program import UnknownEntry, UnsolvedStep, WrongInput
from .run_folder import Run

_LONGEST_NAME = 100  # of a run folder, in letters


@dataclasses.dataclass(frozen=True, repr=False)
class Check:
    """The resolved model of a scene, as the program reports it without a run; print() shows its text.

    text: the resolved model, with its memory and time. warnings: the warnings in it, sentences without the word `warning`."""
    text: str
    warnings: tuple

    def __str__(self):
        return self.text

    __repr__ = __str__


class Scene(collections.abc.Mapping):
    """A parameter file with changes, which the program runs in a process of its own.

    `scene["Section/Entry"]` is the text of an entry: as it was set here, or as in the file, or the default. Setting an entry
    takes a text, a number, or several numbers in a tuple, list or array, which become a list with commas; `del` brings back
    the text of the file. `dict(scene)` has all entries. Names are checked at once, and one that the program does not know raises
    UnknownEntry with the program's suggestion. Values are judged together by check() and run(), because one entry decides
    what another may be.

    name: the name of the file without its ending, and of the run folder. changes: {"Section/Entry": text} of the entries
    that were set here.

    from_file(), from_text() and rig() make scenes. The module takes the program that the environment variable ORTHOCONE names,
    or the one that was built or installed with the module, or the first one of the PATH; FileError says that there is none."""

    def __init__(self, name, path=None, text=None, folder="."):
        self.name, self.changes = name, {}
        self._path = None if path is None else pathlib.Path(os.path.abspath(path))
        self._text, self._folder = text, os.path.abspath(folder)

    @classmethod
    def from_file(cls, path):
        """The scene of a parameter file, .prm or .json. The file stays as it is. Raises FileError and WrongInput for files that
        cannot be read."""
        scene = cls(pathlib.Path(path).stem, path=path)
        scene._given()
        return scene

    @classmethod
    def from_text(cls, text, name=None, folder="."):
        """The scene of a text that is written like a parameter file. Files that it includes or names lie in `folder`. A text
        without a name gets one that only this text has."""
        name = name or f"scene-{_digest(text)}"
        if os.sep in name or len(name) > _LONGEST_NAME:
            raise ValueError(f"name = {name!r}: allowed is the name of a folder, of at most {_LONGEST_NAME} letters")
        return cls(name, text=text, folder=folder)

    @classmethod
    def rig(cls, name):
        """The scene of one of the rigs that come with the program (docs/rigs.md), such as "sphere_on_flat"."""
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "rig.prm")
            program.call(["--new", name, file])
            return cls.from_text(pathlib.Path(file).read_text(encoding="utf-8"), name, folder=os.curdir)

    def with_(self, *changes, **entries):
        """A copy with other entries: with_({"Friction/Coefficients": (0.3, 0.15)}). The scene itself stays as it is."""
        scene = copy.copy(self)
        scene.changes = dict(self.changes)
        for name, value in dict(*changes, **entries).items():
            scene[name] = value
        return scene

    def check(self):
        """The program's --check, a Check: it computes nothing. Raises WrongInput and FileError."""
        with self._file() as file:
            text = self._call(file, ["--check", *self._settings()])
        return Check(text, tuple(re.findall(r"^warning: (.*)", text, re.MULTILINE)))

    def run(self, output=None, *, threads=None, resume=False, insist=False, progress=None):
        """Runs the scene, and returns its Run.

        output: the run folder; None is output/ and the name of the scene with its changes, so that scenes that differ have
        folders of their own. threads, resume and insist are those options of the program: take `threads=1` where several runs
        go on at a time. progress: a function of (step, steps, line), called after each load step with its number, the number
        of all steps, and the line that the program prints. Raises WrongInput, UnsolvedStep and FileError. Ctrl-C raises KeyboardInterrupt
        when the program has written its checkpoint, from which `resume=True` goes on."""
        output = os.fspath(output) if output is not None else os.path.join("output", self._folder_name())
        words = [f"--output={output}", *self._settings()]
        words += [f"--threads={threads}"] if threads is not None else []
        words += [option for option, is_on in (("--resume", resume), ("--insist", insist), ("--quiet", not progress)) if is_on]
        try:
            with self._file() as file:
                self._call(file, words, progress and _on_line(progress))
        except UnsolvedStep as error:
            error.run = Run(output) if os.path.isdir(output) else None
            raise
        return Run(output)

    def __getitem__(self, name):
        name = _known(name)
        if name in self.changes:
            return self.changes[name]
        return self._given().get(name, program.entries()[name].default)

    def __setitem__(self, name, value):
        text = _text_of(value, name)
        name = _known(name, text)
        self.changes[name] = os.path.abspath(text) if program.entries()[name].is_path and text else text

    def __delitem__(self, name):
        self.changes.pop(_known(name), None)

    def __contains__(self, name):
        return name in program.entries()

    def __iter__(self):
        return iter(program.entries())

    def __len__(self):
        return len(program.entries())

    def __repr__(self):
        return f"<Scene {self.name}{''.join(f'; {name} = {text}' for name, text in self.changes.items())}>"

    def _given(self):
        """What the file sets. Where it cannot be read, the program says why."""
        try:
            return entries_of_text(self._text, self._folder) if self._path is None else entries_of(self._path)
        except (OSError, ValueError):
            self.check()
            raise

    def _settings(self):
        """In the order of the program, in which an entry stands behind those that it refers to."""
        return [f"--set={name}={self.changes[name]}" for name in program.entries() if name in self.changes]

    @contextlib.contextmanager
    def _file(self):
        """The path of a file for the program."""
        if self._path is not None:
            yield self._path
            return
        paths = [name for name, entry in program.entries().items() if entry.is_path]
        with tempfile.TemporaryDirectory(prefix="orthocone-") as folder:
            file = pathlib.Path(folder) / f"{self.name}.prm"
            file.write_text(with_whole_paths(self._text, self._folder, paths), encoding="utf-8", errors="surrogateescape")
            yield file

    def _call(self, file, words, on_line=None):
        """Messages do not tell of the passing file of a text."""
        try:
            return program.call([file, *words], on_line)
        except program.ProgramError as error:
            if self._path is None:
                error.args = (str(error).replace(str(file), file.name),)
                error.details = error.details.replace(str(file), file.name)
            raise

    def _folder_name(self):
        """Such as "hertz,Friction.Coefficients=0.3_0.15". Changes that are long, or have letters that names of folders should
        not have, get a number that only they have."""
        words = ",".join([self.name, *(f"{name.replace('/', '.')}={re.sub('[, ]+', '_', text)}"
                                       for name, text in sorted(self.changes.items()))])
        name = re.sub(r"[^\w.,=+-]", "_", words.replace(" ", "_"))
        if len(name) <= _LONGEST_NAME and name == words.replace(" ", "_"):
            return name
        return f"{name[:_LONGEST_NAME]}-{_digest(words)}"


def _on_line(progress):
    """Finds the lines of steps among those that the program prints."""
    def on_line(line):
        if match := re.match(r"step (\d+) of (\d+), ", line):
            progress(int(match[1]), int(match[2]), line)
    return on_line


def _digest(text):
    return hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()[:8]


def _known(name, text=""):
    """The name as the program has it. Of one that it does not know, the program says which one may be meant."""
    name = "/".join(word.strip() for word in name.split("/")) if isinstance(name, str) else str(name)
    if name in program.entries():
        return name
    scene = Scene.from_text("subsection Mesh\n  set Degree = 1\nend\n")
    try:
        with scene._file() as file:
            program.call([file, "--check", f"--set={name}={text}"])
    except WrongInput as error:
        raise UnknownEntry(re.sub("^--set:? ", "", str(error)), error.code, error.details) from None
    raise UnknownEntry(f"{name} is not an entry")


def _text_of(value, name):
    """A value as parameter files have it."""
    if isinstance(value, str):
        return value.strip()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist"):  # of NumPy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, numbers.Real):
        return repr(int(value) if isinstance(value, numbers.Integral) else float(value))
    if isinstance(value, (tuple, list, range)) and not any(isinstance(one, (tuple, list, range)) for one in value):
        return ", ".join(_text_of(one, name) for one in value)
    raise TypeError(f"{name} = {value!r}: allowed is a text, a number, or several in a tuple, a list or an array of one "
                    "dimension")
