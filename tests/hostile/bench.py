# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""One hostile input is a row: how the program is run, and what must hold. A bench runs it in a folder of its own."""
import dataclasses
import json
import os
import pathlib
import resource
import select
import shutil
import subprocess
import tempfile
import typing

SCENE = """subsection Geometry
  set Radius = 10
  set Height = 10
end
subsection Mesh
  set Core cells = 2
  set Layers     = 2
  set Degree     = 1
end
subsection Material
  set Young modulus = 210000
  set Poisson ratio = 0.3
end
subsection Friction
  set Coefficients   = 0.30, 0.15
  set Slip potential = 0.30, 0.15
end
subsection Load program
  set Legs = 0 0 -0.1 : 2 ; 0 0 0 : 2
end
subsection Output
  set Probes = P: 6.72 6.72
end
"""
SECONDS = 20  # the longest that any input may take
BYTES = 6 << 30  # an input that wants more memory must not take it from others


@dataclasses.dataclass
class Row:
    """`script`, if given, stands for all the others: it takes a bench and returns what does not hold."""
    name: str
    arguments: typing.Sequence[str] = ("s.prm", "--quiet")
    code: int = 0
    says: str = ""  # expression in the error output
    files: dict = dataclasses.field(default_factory=dict)  # beside s.prm: name -> text or bytes
    prepare: typing.Callable = None  # takes the folder: links, rights and the like
    environment: dict = dataclasses.field(default_factory=dict)
    shell: str = ""  # a line of the shell instead of the arguments; "$0" is the program
    run: str = "output/s"  # the run folder; "" for what only prints
    may_leave: str = ""  # expression of the names that may be new although the input is refused
    script: typing.Callable = None


class Worker:
    """A program that has loaded its libraries and runs command lines of --batch, each in a process of its own. Loading takes
    longer than most inputs."""

    def __init__(self, program):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)
        self._process = subprocess.Popen([program, "--batch"], cwd=self.folder, text=True, stdin=subprocess.PIPE,
                                         env=Bench.environment({"LD_BIND_NOW": "1"}), stdout=subprocess.PIPE,
                                         preexec_fn=limit_memory)

    def call(self, words):
        """As Bench.call()."""
        self._process.stdin.write(json.dumps(words) + "\n")
        self._process.stdin.flush()
        if not select.select([self._process.stdout], [], [], SECONDS)[0]:
            self._process.kill()
            return "too long", "", ""
        answer = json.loads(self._process.stdout.readline())
        return answer["exit"], answer["output"], answer["message"]

    def clear(self):
        for path in self.folder.iterdir():
            shutil.rmtree(path) if path.is_dir() and not path.is_symlink() else path.unlink()

    def end(self):
        self._process.stdin.close()
        self._process.wait()
        self._process.stdout.close()
        self._folder.cleanup()


class Bench:
    """A folder with s.prm and the program; with a worker the folder is that in which the worker runs."""

    def __init__(self, program, worker=None):
        self.program = program
        self.worker = worker
        if worker:
            worker.clear()
        self._folder = None if worker else tempfile.TemporaryDirectory()
        self.folder = worker.folder if worker else pathlib.Path(self._folder.name)
        self.put("s.prm", SCENE)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._folder:
            subprocess.run(["chmod", "-R", "u+rwx", self.folder], check=False)
            self._folder.cleanup()

    def put(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    @staticmethod
    def environment(changes=()):
        base = {"PATH": os.environ.get("PATH", "/usr/bin:/bin"), "HOME": "/", "LC_ALL": "C",
                "OPENBLAS_NUM_THREADS": "1"}
        base.update({name: os.environ[name] for name in ("LD_LIBRARY_PATH",) if name in os.environ})
        return {name: value for name, value in {**base, **dict(changes)}.items() if value is not None}

    def command(self, arguments, shell=""):
        return ["/bin/sh", "-c", shell, self.program] if shell else [self.program, *map(str, arguments)]

    def start(self, *arguments, shell="", environment=()):
        return subprocess.Popen(self.command(arguments, shell), cwd=self.folder, env=self.environment(environment),
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                preexec_fn=limit_memory)

    def call(self, *arguments, shell="", environment=()):
        """Exit code, standard output, error output; the code of one that takes too long is "too long"."""
        if self.worker and not shell and not environment:
            return self.worker.call([str(argument) for argument in arguments])
        process = self.start(*arguments, shell=shell, environment=environment)
        try:
            out, err = process.communicate(timeout=SECONDS)
        except subprocess.TimeoutExpired:
            process.kill()
            return ("too long", *map(decoded, process.communicate()))
        return process.returncode, decoded(out), decoded(err)

    def set(self, *settings, output="output/s", arguments=()):
        """A quiet run of s.prm with other values."""
        words = [f"--set={setting}" for setting in settings]
        return self.call("s.prm", "--quiet", f"--output={output}", *words, *arguments)

    def content(self):
        """All that is in the folder: name -> kind and content."""
        return {str(path.relative_to(self.folder)): kind_and_content(path) for path in sorted(self.folder.rglob("*"))}


def decoded(output):
    """Bytes that are no UTF-8 become control characters of the second kind, as a terminal may take them."""
    return output.decode("utf-8", "surrogateescape")


def kind_and_content(path):
    if path.is_symlink():
        return "link", os.readlink(path)
    if path.is_dir():
        return "folder", ""
    return ("file", path.read_bytes()) if path.is_file() else ("other", "")


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
