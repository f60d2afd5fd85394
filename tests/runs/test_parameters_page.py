# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""docs/parameters.md has every entry, as the program says it today.

Usage: test_parameters_page.py PROGRAM [unittest options]"""
import re
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True  # the source tree stays clean
from program import PROGRAM, ROOT, main  # noqa: E402

PAGE = ROOT / "docs/parameters.md"


class ParametersPageTest(unittest.TestCase):
    def test_page_is_current(self):
        result = subprocess.run([sys.executable, ROOT / "tools/plots/parameters_page.py", "--program", PROGRAM,
                                 "--output", "/dev/stdout"], capture_output=True, text=True, check=True)
        self.assertEqual(result.stdout, PAGE.read_text(encoding="utf-8"), "tools/parameters_page writes it anew")

    def test_every_entry_has_a_row(self):
        """Found in another way than the page is made."""
        defaults = subprocess.run([PROGRAM, "--defaults"], capture_output=True, text=True, check=True).stdout
        entries = re.findall(r"^  set (.+?) *=", defaults, re.MULTILINE)
        rows = re.findall(r"^\| \*\*(.+?)\*\* \|", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
        self.assertEqual(rows, entries)
        self.assertGreater(len(entries), 60)


if __name__ == "__main__":
    main()
