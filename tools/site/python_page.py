# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""docs/python.md: the docstrings of the Python module, read from its sources."""
import ast
import re

HEAD = """# The Python module
The module `orthocone` solves contact problems that you give as arrays (`solve`), applies the law of a node to arrays of nodes
(`project` and the functions behind it), and reads run folders (`Run`, `ContactFile`). [manual.md](manual.md), *From Python and
C++*, has a first example, and says how Python finds the module.

Lengths are in mm and forces in N, as in the program; laws and solvers also work in other consistent units. A node has local
axes: the normal, then x and y, the axes of both ellipses. Forces act from the counterface on the body. Arrays that do not hold
numbers, or have another shape than stated, raise ValueError.

This page is made of the docstrings of the module: `tools/reference_pages` writes it, and `ctest -R run_reference_pages` checks
that it is current.
"""
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
        arguments = re.sub(r"^self(, )?", "", ast.unparse(node.args))
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
    nodes = [node for name in ("contact.py", "run_folder.py")
             for node in ast.parse((package / name).read_text(encoding="utf-8")).body if is_public(node)]
    solve_first = sorted((node for node in nodes if node.name in {*names, "Report"} or node.name in ("Run", "ContactFile")),
                         key=lambda node: node.name != "solve")
    return HEAD + "".join(map(section, solve_first))
