# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The pages as Sphinx takes them: README.md is index.md, and what they link to is there. The data files that they link to
are downloads. Other files and folders are pages that show them, notebooks as prose and code."""
import json
import posixpath
import re
import shutil

LINK = re.compile(r"(?<=\]\()([^)#:\s]+)(?=(?:#[^)]*)?\))")
FENCE = re.compile(r"(^```.*?^```$)", re.M | re.S)
FILE_AS_TEXT = re.compile(r"\[(?:[\w./]*/)?[\w]+\.md\]\(([^)#:\s]+\.md)(?=[#)])")
PICTURE = re.compile(r"!\[([^\]]*)\]\(([^)]+)\)")
DATA = (".csv", ".json", ".png", ".svg")
LANGUAGES = {".cc": "cpp", ".py": "python", ".cff": "yaml", ".txt": "cmake"}


def page_names(contents):
    """Pages of the repository that the table of contents names, without .md, in its order."""
    return [name for name in re.findall(r"^([\w/]+)$", contents, re.M) if name.startswith("docs/") or name.isupper()]


def read(root, name):
    return (root / f"{name}.md").read_text(encoding="utf-8")


def with_links(root, text, folder, pages, others):
    """The text of a page in `folder` with the links of the site. Paths of what is no page are added to `others`. Links to
    nothing stay as they are: Sphinx then says where they stand."""
    def target(match):
        path = posixpath.normpath(posixpath.join(folder, match[1]))
        if path == "README.md":
            return posixpath.relpath("index.md", folder or ".")
        if path.endswith(".md") and path[:-3] in pages or not (root / path).exists():
            return match[1]
        others.add(path)
        return match[1] if path.endswith(DATA) else f"{match[1]}.md"
    return "".join(part if part.startswith("```") else LINK.sub(target, part) for part in FENCE.split(text))


def with_titles(root, text, folder):
    """The text with the titles of pages, up to a colon, in the place of links' texts that are names of files."""
    def titled(match):
        path = root / folder / match[1]
        if not path.is_file():
            return match[0]
        title = path.read_text(encoding="utf-8").split("\n", 1)[0].removeprefix("# ").split(":")[0]
        return f"[{title}]({match[1]}"
    return "".join(part if part.startswith("```") else FILE_AS_TEXT.sub(titled, part) for part in FENCE.split(text))


def shown_file(path):
    """Markdown of a file. Headings of a notebook go two levels down, below the heading of the file."""
    text = path.read_text(encoding="utf-8")
    if path.suffix != ".ipynb":
        return f"```{LANGUAGES.get(path.suffix, 'none')}\n{text}```\n"
    cells = [(cell["cell_type"], "".join(cell["source"])) for cell in json.loads(text)["cells"]]
    return "\n".join(re.sub("^#", "###", source, flags=re.M) + "\n" if kind == "markdown" else f"```python\n{source}\n```\n"
                     for kind, source in cells)


def code_page(root, path):
    """A page that shows a file, or all files of a folder."""
    place = root / path
    files = sorted(place.iterdir()) if place.is_dir() else [place]
    out = f"# {path}\n"
    for file in files:
        if place.is_dir():
            out += f"\n## {file.name}\n"
        out += f"\n{shown_file(file)}"
    return out


def anchor(heading, known):
    """As a forge and MyST name it."""
    name = re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")
    known.append(name)
    return name if known.count(name) == 1 else f"{name}-{known.count(name) - 1}"


def pictures(text):
    """(heading, its anchor, what the picture shows, path) of each."""
    heading, place, known = "", "", []
    for line in FENCE.sub("", text).splitlines():
        if match := re.match(r"#+ (.*)", line):
            heading, place = match[1], anchor(match[1], known)
        for shows, path in PICTURE.findall(line):
            yield heading, place, shows, path


def gallery(root, names):
    """Every picture once, with a link to the section that explains it."""
    out = "# Gallery\nA picture leads to the section that explains it.\n"
    for name in names:
        text, folder = read(root, name), posixpath.dirname(name)
        shown = list(pictures(text))
        if not shown:
            continue
        out += f"\n## {re.match('# (.*)', text)[1]}\n```{{container}} gallery\n"
        for heading, place, shows, path in shown:
            link = f"{name}.md#{place}"
            out += f"- [![{shows}]({posixpath.join(folder, path)})]({link})\n\n  [{heading}]({link}): {shows}\n"
        out += "```\n"
    return out


def write(root, target, contents, changed=lambda name, text: text):
    """Writes all of it to the folder `target`, each page of the repository as `changed` gives it."""
    names = page_names(contents)
    staged = {name: changed(name, read(root, name)) for name in ["README", *names]}
    others = set()
    staged = {name: with_titles(root, text, posixpath.dirname(name)) for name, text in staged.items()}
    staged = {name: with_links(root, text, posixpath.dirname(name), names, others) for name, text in staged.items()}
    shown = sorted(path for path in others if not path.endswith(DATA))
    staged["index"] = staged.pop("README") + "\n" + contents + sources(shown)
    staged["gallery"] = gallery(root, names)
    staged.update((path, code_page(root, path)) for path in shown)
    for name, text in staged.items():
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        (target / f"{name}.md").write_text(text, encoding="utf-8")
    for path in others.difference(shown):
        (target / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(root / path, target / path)


def sources(paths):
    return "\n```{toctree}\n:hidden:\n:caption: Sources\n\n" + "\n".join(paths) + "\n```\n"
