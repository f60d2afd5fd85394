# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What Debian's tools know of packages, their files, and shared libraries."""
import collections
import functools
import os
import pathlib
import re
import subprocess
import sys


def output(*words):
    """What a command prints, even if it has no answer for one of the words."""
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False,
                          env={**os.environ, "LC_ALL": "C"}).stdout


def libraries(files):
    """{name by which it is loaded: its path} of all shared libraries that these files load when they are started."""
    text = output("ldd", *sorted(files))
    missing = re.findall(r"^\s+(\S+) => not found", text, re.MULTILINE)
    if missing:
        sys.exit(f"package: these libraries are not installed: {' '.join(sorted(set(missing)))}")
    return dict(re.findall(r"^\s+(\S+) => (/\S+) \(", text, re.MULTILINE))


@functools.cache
def files(package):
    """The files of an installed package; its folders and dead links are none."""
    return [pathlib.Path(line) for line in output("dpkg", "-L", package).splitlines() if os.path.isfile(line)]


def glibc():
    """Names of the shared libraries of the C library, which every Linux has as its own."""
    names = {file.name for file in files("libc6")}
    if "libc.so.6" not in names:
        sys.exit("package: Debian's package libc6 is not installed here")
    return names


def mpi_path(name):
    return re.search(rf"^path:{name}:(.*)$", output("ompi_info", "--path", "all", "--parsable"), re.MULTILINE)[1]


def pmix_prefix(plugins):
    """The folder below which PMIx, which plug-ins of Open MPI use, has its own."""
    library = next(file for name, file in libraries(plugins.glob("mca_pmix_*.so")).items() if name.startswith("libpmix.so"))
    return pathlib.Path(os.path.realpath(library)).parent.parent


def needed(package):
    """Names of the packages that it depends on, the first one where there is a choice."""
    fields = output("dpkg-query", "-W", "-f", "${Pre-Depends},${Depends}", package)
    return [re.match(r"[a-z0-9+.-]+", word.strip())[0] for word in fields.split(",") if word.strip()]


def closure(names, without):
    """These packages and all of Python's that they depend on."""
    found, todo = [], collections.deque(names)
    while todo:
        name = todo.popleft()
        if name not in found and name not in without and re.match(r"(lib)?python", name):
            found.append(name)
            todo.extend(needed(name))
    return found


def places(file):
    """The path of a file as packages may name it: /lib is a link to /usr/lib, and files may be reached by links."""
    paths = {str(file), os.path.realpath(file)}
    return paths | {path[4:] for path in paths if path.startswith("/usr/lib")}


def packages(of_files):
    """Names of the installed packages that have these files."""
    paths = sorted({path for file in of_files for path in places(file)})
    lines = output("dpkg-query", "-S", *paths).splitlines()
    return sorted({name.split(":")[0] for line in lines if not line.startswith("diversion")
                   for name in line.rpartition(": ")[0].split(", ")})


def version(package):
    return output("dpkg-query", "-W", "-f", "${Version}\n", package).split()[0]


def system():
    text = pathlib.Path("/etc/os-release").read_text(encoding="utf-8")
    return " ".join(re.search(rf'^{name}="?([^"\n]*)', text, re.MULTILINE)[1] for name in ("NAME", "VERSION_ID"))
