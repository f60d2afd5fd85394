# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""What README and docs name is there: files, the targets of links, tests, and the answers that readers look for."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGES = [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").glob("*.md")),
         *(ROOT / name for name in ("tools/packaging/README.md", "examples/dealii_gallery/README.md"))]
OF_A_RUN = {"input.prm", "parameters.prm"}


def sources():
    folders = [ROOT / name for name in ("source", "include", "tests", "tools", "cmake", "prm", "examples")]
    return ["/" + str(path.relative_to(ROOT)) for folder in folders for path in folder.rglob("*")]


def flat(text):
    """Without line breaks and marks of emphasis."""
    return " ".join(text.replace("*", " ").split())


def gtests():
    """Names "Suite.Test" of the C++ tests."""
    names = set()
    for path in (ROOT / "tests").rglob("*.cc"):
        text = path.read_text(encoding="utf-8")
        names.update(".".join(pair) for pair in re.findall(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", text, re.MULTILINE))
    return names


class PagesTest(unittest.TestCase):
    def test_links_lead_somewhere(self):
        for page in PAGES:
            for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8")):
                with self.subTest(page=page.name, target=target):
                    self.assertTrue((page.parent / target).exists())

    def test_sources_that_are_named_are_there(self):
        names = sources()
        for page in PAGES:
            for named in set(re.findall(r"`([\w./-]+\.(?:cc|h|py|sh|prm|js))`", page.read_text(encoding="utf-8"))):
                if named in OF_A_RUN or named.endswith("/X.cc"):
                    continue
                with self.subTest(page=page.name, file=named):
                    self.assertTrue(any(name.endswith("/" + named) for name in names))

    def test_tests_that_are_named_are_there(self):
        tests = gtests()
        suites = {name.split(".")[0] for name in tests}
        for page in PAGES:
            for suite, name in re.findall(r"`([A-Z]\w+)\.([A-Z]\w+|\*)`", page.read_text(encoding="utf-8")):
                with self.subTest(page=page.name, test=f"{suite}.{name}"):
                    self.assertTrue(suite in suites if name == "*" else f"{suite}.{name}" in tests)

    def test_words_of_the_glossary_are_those_of_the_code(self):
        code = " ".join(path.read_text(encoding="utf-8") for root in ("include", "source")
                        for path in sorted((ROOT / root).rglob("*.[ch]*")))
        rows = re.findall(r"^\| ([^|]+) \|[^|]+\|([^|]*)\|$", (ROOT / "docs/glossary.md").read_text(encoding="utf-8"), re.MULTILINE)
        words = [word for row, _ in rows for word in row.split(", ")]
        self.assertEqual(len(words), len(set(words) - {"word"}) + words.count("word"), "each word stands there once")
        for _, identifiers in rows:
            for identifier in re.findall(r"`(\w+)`", identifiers):
                with self.subTest(identifier):
                    self.assertTrue(re.search(rf"\b{identifier}\b", code))

    def test_answers_of_the_questions_stand_on_their_pages(self):
        """Every page has five questions, and the sentences that questions.md quotes; three dots leave words out."""
        parts = re.split(r"^## (.+)\n", (ROOT / "tests/style/questions.md").read_text(encoding="utf-8"), flags=re.MULTILINE)
        self.assertEqual(sorted(parts[1::2]), sorted(str(page.relative_to(ROOT)) for page in PAGES))
        for name, table in zip(parts[1::2], parts[2::2]):
            text = flat((ROOT / name).read_text(encoding="utf-8"))
            self.assertGreaterEqual(len(re.findall(r"^\| .* \| .* \|$", table, re.MULTILINE)), 1 + 5, name)
            for quoted in re.findall(r'"([^"]+)"', table):
                for part in quoted.split("..."):
                    with self.subTest(page=name, answer=part):
                        self.assertTrue(flat(part) in text)

    def test_theory_draws_the_ladder(self):
        """What `newton` tries, in the order of source/contact/solvers/rescue/ladder.cc."""
        source = (ROOT / "source/contact/solvers/rescue/ladder.cc").read_text(encoding="utf-8")
        rungs = [(str(int(first) + 1) + ("+" if last == "ever" else ""), name)
                 for first, last, name in re.findall(r'^    \{(\d+), (\w+), "([^"]+)"', source, re.MULTILINE)]
        page = (ROOT / "docs/theory.md").read_text(encoding="utf-8").partition("**The ladder.**")[2]
        drawn = re.findall(r"^  (\d\+?) +(\S.*?)(?:  .*)?$", page.split("```")[1], re.MULTILINE)
        self.assertGreater(len(rungs), 10)
        self.assertEqual(drawn, rungs)


if __name__ == "__main__":
    unittest.main()
