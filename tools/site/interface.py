# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Pages of the C++ interface: for each header what it declares, in its order, from the XML of Doxygen by Breathe."""
import collections
import re
import xml.etree.ElementTree

import headers

INDEX = """C++ interface
=============
These are headers that ``cmake --install`` installs, those of its components ``contact`` and ``body``. All names are in the
namespace ``orthocone``. Lengths are in mm, forces in N. :doc:`../examples/library` is a project that uses them.

.. toctree::

"""


def compounds(folder):
    """The namespace orthocone and its classes; not what is declared within these."""
    for file in sorted(folder.glob("[ncs]*orthocone*.xml")):  # namespace, class, struct
        compound = xml.etree.ElementTree.parse(file).find("compounddef")
        if re.fullmatch(r"orthocone(::\w+)?", compound.findtext("compoundname")):
            yield compound


def place(element):
    location = element.find("location")
    return location.get("file"), int(location.get("line"))


def members(namespace):
    """(place, directive) of functions, enumerations, types and variables. Their arguments distinguish overloaded ones.
    A function for certain types is described where the template is."""
    found = [member for member in namespace.findall("sectiondef/memberdef") if not re.search(r"\w< ", member.findtext("name"))]
    count = collections.Counter(member.findtext("name") for member in found)
    for member in found:
        name = member.findtext("name")
        arguments = member.findtext("argsstring") if count[name] > 1 else ""
        yield place(member), f".. doxygen{member.get('kind')}:: orthocone::{name}{arguments}\n"


def declarations(folder):
    """{header: directives in the order of the header}."""
    found = collections.defaultdict(list)
    for compound in compounds(folder):
        if compound.get("kind") == "namespace":
            entries = members(compound)
        else:
            entries = [(place(compound), f".. doxygen{compound.get('kind')}:: {compound.findtext('compoundname')}\n")]
        for (file, line), directive in entries:
            found[file].append((line, directive))
    return {file: [directive for _, directive in sorted(entries)] for file, entries in found.items()}


def titled(text, sign):
    return f"{text}\n{sign * len(text)}\n\n"


def introduction(text):
    """What stands below the licence and above the code of a header, in reStructuredText."""
    match = re.match(r"(?://.*\n){2}//\n((?:// .*\n)+)", text)
    parts = re.sub(r"^// ", "", match[1] if match else "", flags=re.M).split("`")
    return "".join(f"``{part}``" if k % 2 else re.sub(r"([*_|\\])", r"\\\1", part) for k, part in enumerate(parts))


def section(root, name, directives):
    return "\n".join((titled(name.split("/", 1)[1], "-") + f".. code-block:: cpp\n\n   #include <{name}>\n",
                      introduction((root / "include" / name).read_text(encoding="utf-8")), *directives, ""))


def write(root, folder, api):
    """From the XML in `folder` to the folder `api`."""
    api.mkdir(parents=True)
    found = declarations(folder)
    for library, (title, help_text) in headers.LIBRARIES.items():
        sections = [section(root, name, found.get(name, [])) for name in headers.names(root, library)]
        (api / f"{library}.rst").write_text(titled(title, "=") + help_text + "\n\n" + "".join(sections), encoding="utf-8")
    (api / "index.rst").write_text(INDEX + "".join(f"   {name}\n" for name in headers.LIBRARIES), encoding="utf-8")
