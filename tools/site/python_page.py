# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""docs/python.md: the docstrings of the Python module, read from its sources."""
import ast
import re

HEAD = """# The Python module
The module `orthocone` drives the program from Python: a scene is read, changed and run, and its results are tables and arrays
(`Scene`, `Run`). It also solves contact problems that you give as arrays (`solve`), and applies the law of a node to arrays of
nodes (`project` and the functions behind it). This page is for those who run scenes from a script or a notebook, or who need the
contact solvers for problems of their own. It begins with examples, and then describes every class and function.

## How to begin
After `./run`, the module lies in the build folder. It is for Debian's Python with NumPy, and packages contain it, too:
```
export PYTHONPATH="$PWD/build/python"
/usr/bin/python3
```

**A run.** A `Scene` is a parameter file, one of the rigs ([rigs.md](rigs.md)), or a text. Its entries have the names of
[parameters.md](parameters.md), and `run()` starts the program in a process of its own:
```python
import orthocone

scene = orthocone.Scene.rig("sphere_on_flat")  # or Scene.from_file("my.prm")
scene["Friction/Coefficients"] = 0.3, 0.15
scene["Load program/Preload"]                  # 'Fz -250 Fx 0 : 3', as in the file
print(scene.check())                           # model, memory, time, warnings

run = scene.run()
run.history["held_force_x"]                    # a row for each load step
run.contact()["pressure"]                      # fields at the last step
run.summary["warnings"]
```
With pandas (Debian's `python3-pandas`), the tables of a run are DataFrames, so that `run.history.plot(x="ux", y="force_x")`
draws a loop. Without pandas they are dictionaries of NumPy arrays with the same columns; `Run(folder, pandas=False)` gives such
dictionaries in any case, for scripts that must run on every machine.

Fields are arrays with a row for each contact node, so that you can lay them over a closed form, as the
[tutorial](tutorial.md) does with the pressure under a sphere:

![Pressure over the radius, and largest pressure over the force, on Hertz](images/tutorial_4_sphere.png)

**Errors.** Where the program refuses something or fails, the module raises an error with the message of the program. Each exit
code has a class: `WrongInput`, `UnsolvedStep`, `FileError`. The name of an entry is checked when it is set, and `UnknownEntry`
suggests the nearest one:
```python
>>> scene["Friction/Coeficients"] = 0.3, 0.15
UnknownEntry: Friction/Coeficients is not an entry; is Friction/Coefficients meant? ...
```

**A study** is a list comprehension, because `with_()` makes a copy with other entries, and each copy has a run folder of its
own:
```python
runs = [scene.with_({"Friction/Coefficients": (mu, mu)}).run() for mu in (0.4, 0.5, 0.6)]
energies = [run.cycles["dissipation"].sum() for run in runs]
```
`with_(**{"Friction/Coefficients": (mu, mu)})` does the same. Several runs go on at a time with `concurrent.futures`. Threads
are enough for that, because each run is a process:
```python
from concurrent.futures import ThreadPoolExecutor

scenes = [scene.with_({"Friction/Coefficients": (mu, mu)}) for mu in (0.4, 0.5, 0.6)]
with ThreadPoolExecutor(2) as pool:
    runs = list(pool.map(lambda scene: scene.run(threads=1), scenes))
```
From the command line `tools/sweep` runs such a study, with a table and a page of pictures ([manual.md](manual.md)).

**Long runs.** `run(progress=...)` takes a function that is called after each load step. Ctrl-C lets the program finish its
iteration and write its checkpoint before Python goes on, and `run(resume=True)` continues from there. A second Ctrl-C ends the
program at once.

**Notebooks.** [examples/notebooks](../examples/notebooks) contains three notebooks that run in seconds and need no earlier
run: *first_loop* runs a rig and draws its fretting loop beside the theory, *study* varies friction and compares the
dissipated energy with Mindlin and Deresiewicz, and *own_compliance* solves the contact of two spheres with a compliance made
in NumPy. Jupyter opens them, and `ctest -R run_notebooks` runs them.

## Conventions
Lengths are in mm and forces in N, as in the program; laws and solvers also work in other consistent units. A node has local
axes: the normal, then x and y, the axes of both ellipses. Forces act from the counterface on the body. Arrays that do not hold
numbers, or have another shape than stated, raise ValueError.

The descriptions below are the docstrings of the module: `tools/reference_pages` writes this page, and
`ctest -R run_reference_pages` checks that it is current.
"""
# The files of the module, in the order of the page; the first names stand before the others of their file.
FILES = ("scene.py", "run_folder.py", "program.py", "contact.py")
FIRST = ("Scene", "Run", "solve")
# A word and a colon, behind a stop, are an argument or a field; these begin a sentence.
ENTRY = re.compile(r"(?:^|(?<=\. ))(?=(?:[A-Za-z]\w*(?:, [a-z]\w*)*: |Returns |Raises ))")


def escaped(text):
    """Without what Markdown would take for its own; code stays."""
    parts = re.split(r"(`[^`]*`)", text)
    return "".join(part if part.startswith("`") else re.sub(r"([\\|*_<>\[\]])", r"\\\1", part) for part in parts)


def paragraphs(docstring):
    """Markdown of a docstring: each argument or field is an item of a list."""
    out = ""
    for paragraph in docstring.split("\n\n"):
        for piece in filter(None, ENTRY.split(" ".join(paragraph.split()))):
            name, colon, rest = piece.strip().partition(": ")
            is_entry = colon and re.fullmatch(r"[A-Za-z]\w*(, [a-z]\w*)*", name)
            out += f"- **{escaped(name)}**: {escaped(rest)}\n" if is_entry else f"\n{escaped(piece.strip())}\n\n"
    return re.sub(r"\n{3,}", "\n\n", out).strip() + "\n"


def is_public(node):
    return isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_") and ast.get_docstring(node)


def is_property(node):
    return any("property" in ast.unparse(decorator) for decorator in node.decorator_list)


def members(cls):
    """A line for each public function and property of a class."""
    out = ""
    for node in filter(is_public, cls.body):
        arguments = re.sub(r"^(self|cls)(, )?", "", ast.unparse(node.args))
        name = node.name if is_property(node) else f"{node.name}({arguments})"
        out += f"- `{name}`: {escaped(' '.join(ast.get_docstring(node).split()))}\n"
    return f"\n{out}" if out else ""


def values(cls):
    """The names of an enumeration, with their numbers."""
    rows = [f"`{node.targets[0].id}` = {node.value.value}" for node in cls.body
            if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant)]
    return f"\n{', '.join(rows)}\n" if rows else ""


def section(node):
    out = f"\n## {node.name}\n"
    if isinstance(node, ast.FunctionDef):
        out += f"```python\northocone.{node.name}({ast.unparse(node.args)})\n```\n"
    out += paragraphs(ast.get_docstring(node))
    return out if isinstance(node, ast.FunctionDef) else out + values(node) + members(node)


def python_page(package):
    """`package`: the folder of the module."""
    names = re.findall(r'"(\w+)"', (package / "__init__.py").read_text(encoding="utf-8").partition("def ")[0])
    nodes = [node for name in FILES
             for node in sorted(ast.parse((package / name).read_text(encoding="utf-8")).body,
                                key=lambda node: getattr(node, "name", "") not in FIRST)]
    return HEAD + "".join(section(node) for node in nodes if is_public(node) and node.name in names)
