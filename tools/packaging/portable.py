# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Makes one tar.gz of the installed program with all that it needs but the C library: shared libraries, MPI, and a Python
with NumPy, Matplotlib and meshio for its tools. Usage: portable.py BUILD_FOLDER OUTPUT_FOLDER [--level N]

All files of others are those of the Debian that this runs on, unchanged but for the place where programs look for libraries:
an RPATH relative to the program, which stands above LD_LIBRARY_PATH and also counts for plug-ins that are loaded later."""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

sys.dont_write_bytecode = True  # the source tree stays clean
import debian  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
COMMANDS = ("orthocone", "orthocone-solve")
# Transport between nodes of a cluster takes the drivers of that cluster, and only its own MPI has them. One machine needs
# shared memory; TCP stays.
CLUSTER = re.compile(r"mca_(\w*_(ofi|ucx|uct|openib|psm2?|monitoring|flux|slurm|gridengine|jsm)|mtl_\w+|spml_\w+|scoll_\w+|"
                     r"memheap_\w+|sshmem_\w+|atomic_\w+)\.so|libompi_dbg_msgq\.so")
PYTHON_PACKAGES = ("python3-numpy", "python3-matplotlib", "python3-meshio")
# Fonts of PDF pictures, windows, and what builds packages: our tools never ask for them.
NO_PYTHON_PACKAGES = ("python3-fonttools", "python3-pil.imagetk", "python3-pkg-resources", "python3-distutils")
# Where their files go below the Python of the package.
PYTHON_PLACES = {"/usr/lib/python3": "lib/python3", "/usr/share/matplotlib/mpl-data/": "lib/python3/dist-packages/matplotlib/mpl-data/"}
NOT_NEEDED = re.compile(r"/(tests?|__pycache__|idlelib|lib2to3|ensurepip|sample_data)/")


def run(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"package: {' '.join(str(word) for word in words)}: {done.stderr.strip()}")
    return done.stdout


def is_elf(file):
    with open(file, "rb") as opened:
        return opened.read(4) == b"\x7fELF"


def copy(source, target):
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy2(source, target)


class Package:
    """The folder that becomes the archive."""

    def __init__(self, folder):
        self.folder = folder
        self.lib = folder / "lib"
        self.sources = set()  # files of Debian packages that are in it
        self.elf = set()  # the places that these had, and ours, whose libraries are asked for

    def bring(self, source, target):
        """A file of the system. A RUNPATH of its own would count instead of the program's RPATH."""
        self.sources.add(source)
        copy(os.path.realpath(source), target)
        if is_elf(target):
            self.elf.add(source)
            if re.search(r"\((RUN|R)PATH\)", run("readelf", "-d", target)):
                run("patchelf", "--remove-rpath", target)

    def add_libraries(self, glibc):
        for name, file in sorted(debian.libraries(self.elf).items()):
            if name not in glibc:
                self.bring(pathlib.Path(file), self.lib / name)

    def find_libraries_here(self, program):
        place = os.path.relpath(self.lib, program.parent)
        run("patchelf", "--force-rpath", "--set-rpath", f"$ORIGIN/{place}", program)


def add_program(package, build):
    """What the Debian package has below /usr, with a launcher in bin for each compiled program."""
    for component in ("program", "python"):
        run("cmake", "--install", build, "--component", component, "--prefix", package.folder, "--strip")
    for name in COMMANDS:
        program = package.folder / "bin" / name
        if program.exists():
            package.elf.add(build / name)
            copy(program, package.folder / "libexec" / name)
            program.unlink()
            add_launcher(package, name, f'exec "$here/libexec/{name}" "$@"')
            package.find_libraries_here(package.folder / "libexec" / name)


def add_launcher(package, name, command):
    text = (HERE / "launcher.in").read_text(encoding="utf-8").replace("@COMMAND@", command)
    path = package.folder / "bin" / name
    path.write_text(text, encoding="utf-8")
    path.chmod(0o755)


def add_mpi(package):
    """Open MPI looks below OPAL_PREFIX, in folders that ompi_info names. Without a cluster no
    daemons are started, and ssh is not looked for."""
    prefix = package.folder / "libexec/mpi"
    place = {}
    for line in run("env", "OPAL_PREFIX=/moved", "ompi_info", "--path", "all", "--parsable").splitlines():
        _, name, folder = line.split(":")
        place[name] = folder
    plugins, pages = (pathlib.Path(debian.mpi_path(name)) for name in ("pkglibdir", "pkgdatadir"))
    for file in sorted(plugins.glob("*.so")):
        if not CLUSTER.fullmatch(file.name):
            package.bring(file, prefix / pathlib.Path(place["pkglibdir"]).relative_to("/moved") / file.name)
    for file in sorted(pages.glob("help-*.txt")):
        package.bring(file, prefix / pathlib.Path(place["pkgdatadir"]).relative_to("/moved") / file.name)
    pmix = debian.pmix_prefix(plugins)
    for file in sorted(file for folder in ("lib/pmix", "share/pmix") for file in (pmix / folder).glob("*")):
        package.bring(file, package.folder / "libexec/pmix" / file.relative_to(pmix))
    package.bring(pathlib.Path("/usr/bin/orterun"), prefix / "bin/orterun")
    package.find_libraries_here(prefix / "bin/orterun")
    add_launcher(package, "orthocone-mpirun", 'export OMPI_MCA_plm=isolated\nexec "$here/libexec/mpi/bin/orterun" "$@"')


def add_python(package):
    """Debian's Python finds its own modules beside itself, and those of Debian's packages in lib/python3."""
    root = package.folder / "libexec/python"
    for name in debian.closure(PYTHON_PACKAGES, NO_PYTHON_PACKAGES):
        for file in debian.files(name):
            for before, after in PYTHON_PLACES.items():
                if str(file).startswith(before) and not NOT_NEEDED.search(str(file)):
                    package.bring(file, root / (after + str(file)[len(before):]))
    version = os.path.basename(os.path.realpath("/usr/bin/python3"))
    package.bring(pathlib.Path("/usr/bin", version), root / "bin/python3")
    package.find_libraries_here(root / "bin/python3")
    modules = next(package.folder.glob("lib/python3*/dist-packages/orthocone"), None)
    if modules:  # beside NumPy
        package.elf.update(modules.glob("*.so"))
        shutil.copytree(modules, root / "lib/python3/dist-packages/orthocone")
    add_launcher(package, "orthocone-python", 'exec "$here/libexec/python/bin/python3" "$@"')
    for tool in sorted(package.folder.glob("bin/orthocone-*")):
        if "share/orthocone/tools" in tool.read_text(encoding="utf-8"):
            tool.rename(package.folder / "libexec" / tool.name)
            add_launcher(package, tool.name, f'exec "$here/libexec/{tool.name}" "$@"')


def add_licences(package):
    """Which packages the files are of, and their licences."""
    names = debian.packages(package.sources)
    folder = package.folder / "share/doc/orthocone/licences"
    for name in names:
        file = pathlib.Path("/usr/share/doc", name, "copyright")
        if file.exists():
            copy(file, folder / f"{name}.txt")
    text = "".join(f"{name} {debian.version(name)}\n" for name in names)
    (folder / "packages.txt").write_text(text, encoding="utf-8")


def newest_glibc(folder):
    """The newest version of the C library that a symbol of these files is of, which is the oldest that they run with."""
    found = set()
    for file in folder.rglob("*"):
        if file.is_file() and not file.is_symlink() and is_elf(file):
            found.update(int(number) for number in re.findall(rb"\0GLIBC_2\.(\d+)(?:\.\d+)?\0", file.read_bytes()))
    return f"2.{max(found)}"


def add_readme(package, name):
    text = (HERE / "portable.md").read_text(encoding="utf-8")
    for mark, value in (("NAME", name), ("GLIBC", newest_glibc(package.folder)), ("SYSTEM", debian.system())):
        text = text.replace(f"@{mark}@", value)
    (package.folder / "README.md").write_text(text, encoding="utf-8")


def archive(folder, target, level):
    """Whole, or not at all: another package of that name stays if this fails. Files belong to whoever unpacks them."""
    def plain(entry):
        entry.uid = entry.gid = 0
        entry.uname = entry.gname = "root"
        return entry
    part = target.with_name(target.name + ".part")
    with tarfile.open(part, "w:gz", compresslevel=level) as opened:
        opened.add(folder, folder.name, filter=plain)
    part.replace(target)


def main():
    parser = argparse.ArgumentParser(prog="tools/package --portable", description=__doc__)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--level", type=int, default=6, help="of compression, 1 to 9")
    options = parser.parse_args()
    version = run(options.build / "orthocone", "--version").split()[1]
    name = f"orthocone-{version}-linux-{os.uname().machine}"
    with tempfile.TemporaryDirectory() as scratch:
        package = Package(pathlib.Path(scratch, name))
        add_program(package, options.build.resolve())
        add_mpi(package)
        add_python(package)
        package.add_libraries(debian.glibc())
        shutil.rmtree(next(iter(package.folder.glob("lib/python3*")), package.folder / "no module"), ignore_errors=True)
        add_licences(package)
        add_readme(package, name)
        options.output.mkdir(parents=True, exist_ok=True)
        archive(package.folder, options.output / f"{name}.tar.gz", options.level)
    print(options.output / f"{name}.tar.gz")


if __name__ == "__main__":
    main()
