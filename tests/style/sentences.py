# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Mean length of the sentences of README.md and docs/*.md, in words: `python3 tests/style/sentences.py` prints it.

Counted is prose. Code blocks, tables, headings, pictures, comments and targets of links are not, nor are words such as
**Materials.** or *Why.* that open a paragraph. A list item begins a sentence. Its end and that of a paragraph end one. Words
of `inline code` count, its stops do not."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
GENERATED = {"parameters.md", "results.md", "python.md"}
TABLES = {"glossary.md"}  # of words, with few sentences
PAGES = [ROOT / "README.md", *sorted(path for path in (ROOT / "docs").glob("*.md") if path.name not in GENERATED | TABLES)]
MOST_WORDS = 20
ITEM = re.compile(r"^\s*(?:[-*+]|\d+\.) +")
# Up to eight bold words, or italic ones with a stop.
OPENING = re.compile(r"^(?:\*\*(?:[^*\s]+\s?){1,8}\*\*|\*(?:[^*\s]+\s?){1,8}(?<=[.:])\*)")
# A stop, a closing mark behind it, a space, and what begins a sentence. Initials (V. L. Popov) end none.
ABBREVIATIONS = "".join(rf"(?<!\b{word})" for word in (r"e\.g", r"i\.e", "J", "Int", "vol", "Trans", "Comput"))
END = re.compile(rf"(?<![ (][A-Z]){ABBREVIATIONS}[.!?][)\"'*_]*\s+(?=[\"'(*_\[]*[A-Z0-9`‖μν])")


def blocks(text):
    """Paragraphs and list items of a page, each in one line."""
    text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
    text = re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)
    block, is_code = [], False
    for line in [*text.splitlines(), ""]:
        is_code = line.startswith("    ") and (is_code or not block)
        is_prose = line.strip() and not is_code and not re.match(r"\s*(?:#|\||!\[|\$\$)", line)
        if block and (not is_prose or ITEM.match(line)):
            yield " ".join(block)
            block = []
        if is_prose:
            block.append(ITEM.sub("", line, count=1).strip())


def words_of(sentence):
    return [word for word in sentence.split() if re.search(r"\w", word)]


def sentences(text):
    """Lists of words."""
    for block in blocks(text):
        block = OPENING.sub("", block)
        block = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", block)
        block = re.sub(r"`+[^`]+`+", lambda code: re.sub(r"[.!?]", "x", code[0]), block)
        for sentence in END.split(block):
            if words_of(sentence):
                yield words_of(sentence)


def mean_length(path):
    lengths = [len(sentence) for sentence in sentences(path.read_text(encoding="utf-8"))]
    return sum(lengths) / max(1, len(lengths)), len(lengths)


def main():
    for path in PAGES:
        mean, count = mean_length(path)
        print(f"{mean:5.1f} words in each of {count:4d} sentences: {path.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
