# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Makes a mesh file for orthocone (Gmsh, format 2.2, ASCII) of an Abaqus or CalculiX file (.inp, with its surfaces and
sets), of any file of Gmsh (binary, 2.1, 4.0), or of another mesh of hexahedra that meshio reads (.vtu, .med, .e)."""
import argparse
import collections
import contextlib
import io
import os
import pathlib
import re
import sys
import tempfile

sys.dont_write_bytecode = True  # the source tree stays clean
sys.path.insert(1, str(pathlib.Path(__file__).resolve().parent.parent / "runs"))
import abaqus  # noqa: E402
import meshio  # noqa: E402
import numpy as np  # noqa: E402
from body import Body, Fault, counted  # noqa: E402

WRONG_INPUT, FILE_ERROR, LONGEST_LINE = 2, 4, 600
CORNERS = {"hexahedron": 8, "hexahedron20": 8, "hexahedron27": 8, "quad": 4, "quad8": 4, "quad9": 4}
AROUND = {*CORNERS, "line", "line3", "vertex"}
MOST_NAMED = 12


class ArgumentParser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(WRONG_INPUT, shown(f"{message}; '--help' explains") + "\n")


def arguments():
    parser = ArgumentParser(prog="tools/import", description=__doc__)
    parser.add_argument("file", metavar="FILE", type=pathlib.Path, help="the mesh")
    parser.add_argument("output", metavar="MESH.msh", type=pathlib.Path, help="the file to write")
    parser.add_argument("--scale", metavar="FACTOR", type=float, default=1,
                        help="multiplies all lengths, which become mm: 1000 for a mesh in metres")
    given = parser.parse_args()
    if not (np.isfinite(given.scale) and given.scale > 0):
        parser.error(f"--scale {given.scale}: allowed is a number > 0")
    if given.output.exists() and not given.output.is_file():
        parser.error(f"{given.output}: is no ordinary file, and stays as it is")
    if given.output.exists() and given.output.samefile(given.file):
        parser.error(f"{given.output}: is FILE itself, and stays as it is")
    return given


def meshio_read(path, is_gmsh):
    """meshio takes format 4, which Gmsh calls 4.0 elsewhere, for 4.1."""
    old = re.match(rb"\s*\$MeshFormat\s+4(?=\s)", path.read_bytes()) if is_gmsh else None
    if not old:
        return meshio.read(path, file_format="gmsh" if is_gmsh else None)
    with tempfile.NamedTemporaryFile(suffix=".msh") as file:
        file.write(old[0].lstrip() + b".0" + path.read_bytes()[old.end():])
        file.flush()
        return meshio.read(file.name, file_format="gmsh")


def read_by_meshio(path, is_gmsh):
    try:
        with contextlib.redirect_stderr(io.StringIO()), contextlib.redirect_stdout(io.StringIO()):
            mesh = meshio_read(path, is_gmsh)
    except OSError:
        raise
    except (Exception, SystemExit) as error:  # meshio exits on some files and raises what it likes on others
        said = " ".join(str(error).split())[:200]
        raise Fault("is no mesh that meshio reads" + (f" ({said})" if said and said != "1" else "")) from None
    others = collections.Counter()
    for block in mesh.cells:
        if block.type not in AROUND:
            others[block.type] += len(block.data)
    if others:
        raise Fault(f"has {counted(others)}: allowed are hexahedra of 8, 20 or 27 nodes and the quadrilaterals and "
                    "lines around them")
    if len(kinds := {block.type for block in mesh.cells if CORNERS.get(block.type) == 8 and len(block.data)}) > 1:
        raise Fault(f"has {' and '.join(sorted(kinds))}: allowed is one kind of hexahedra")
    return mesh


def body_of(mesh):
    """Physical groups of Gmsh, or the sets of other files."""
    blocks = {kind: [i for i, block in enumerate(mesh.cells) if CORNERS.get(block.type) == n and len(block.data)]
              for kind, n in (("hexahedron", 8), ("quad", 4))}
    cells = [mesh.cells[i].data for i in blocks["hexahedron"]] or [np.empty((0, 8), int)]
    points = np.zeros((len(mesh.points), 3))
    points[:, :mesh.points.shape[1]] = mesh.points
    body = Body(points, np.concatenate(cells), [])
    first = dict(zip(blocks["hexahedron"], np.cumsum([0] + [len(some) for some in cells])))
    tags = mesh.cell_data.get("gmsh:physical")
    names = {(int(data[1]), int(data[0])): name for name, data in mesh.field_data.items() if np.size(data) == 2}
    groups = collections.defaultdict(lambda: ([], []))  # of a name: faces, cells
    for kind, dim in (("quad", 2), ("hexahedron", 3)):
        for i in blocks[kind]:
            members = {name: np.asarray(rows[i], int) for name, rows in mesh.cell_sets.items()
                       if ":" not in name and i < len(rows) and rows[i] is not None}
            if tags is not None:
                members = {names.get((dim, int(tag)), str(int(tag))): np.flatnonzero(tags[i] == tag)
                           for tag in np.unique(tags[i]) if tag != 0}
            for name, rows in members.items():
                groups[name][dim - 2].extend(mesh.cells[i].data[rows, :4].tolist() if dim == 2 else (first[i] + rows).tolist())
    for name, (faces, rows) in groups.items():
        if faces:
            body.add_surface(name, faces)
        body.add_volume(name, rows)
    return body


def read(path):
    with open(path, "rb") as file:
        head = file.read(4096).removeprefix(b"\xef\xbb\xbf").lstrip()
    if not head:
        raise Fault("is empty; a mesh is wanted")
    if head.startswith(b"*") or path.suffix.lower() == ".inp":
        return abaqus.read(path)
    return body_of(read_by_meshio(path, head.startswith(b"$MeshFormat")))


def write_whole(path, text):
    """Under its name the file is complete or not there."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        temporary.write_text(text, encoding="utf-8")
        temporary.replace(path)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise OSError(error.errno, error.strerror, str(path)) from error


def shown(text):
    """A line as a terminal may show it."""
    line = "".join(c if c.isprintable() else c.encode("unicode_escape", "replace").decode() for c in f"import: {text}")
    return line if len(line) <= LONGEST_LINE else line[:LONGEST_LINE - 3] + "..."


def report(path, body):
    low, high = body.box()
    print(shown(f"{path}: {np.count_nonzero(body.is_first)} hexahedra in "
                + ", ".join(f"{axis} = {a:.6g} to {b:.6g}" for axis, a, b in zip("xyz", low, high)) + " mm"))
    for kind, names in (("surfaces", [f"{name} ({len(rows)} faces)" for name, rows in body.surfaces.items()]),
                        ("volumes", body.volumes)):
        more = f" and {len(names) - MOST_NAMED} more" if len(names) > MOST_NAMED else ""
        print(shown(f"{kind}: {', '.join(names[:MOST_NAMED]) or 'none with a name'}{more}"))
    print("import: a parameter file may name surfaces by their place, too: Contact surface = z min")
    for note in list(dict.fromkeys(body.notes))[:MOST_NAMED]:
        print(shown(f"note: {note}"))


def main():
    try:
        given = arguments()
        body = read(given.file)
        body.points = body.points * given.scale
        write_whole(given.output, body.text())
        report(given.output, body)
    except Fault as fault:
        print(shown(f"{given.file}: {fault}"), file=sys.stderr)
        sys.exit(WRONG_INPUT)
    except OSError as error:
        print(shown(f"{error.filename or given.file}: {error.strerror or error}"), file=sys.stderr)
        sys.exit(FILE_ERROR)


if __name__ == "__main__":
    main()
