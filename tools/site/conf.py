# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Configuration of Sphinx, for the versions of Debian 12 and 13. tools/docs gives it the folders."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

project = "orthocone"
author = "the orthocone authors"
project_copyright = "2026, the orthocone authors"
release = re.search(r"project\(orthocone\s+VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]

extensions = ["myst_parser", "breathe"]
highlight_language = "none"
smartquotes = False  # pages read as on a forge

# Plain Markdown: what other readers of it show as text is text here, too.
myst_disable_syntax = ["myst_role", "myst_line_comment", "myst_block_break", "myst_target"]
myst_heading_anchors = 4

toc_object_entries = False  # "On this page" has the headers, not all that they declare
cpp_index_common_prefix = ["orthocone::"]
breathe_default_project = "orthocone"
breathe_default_members = ("members", "undoc-members")
breathe_show_include = False
breathe_show_enumvalue_initializer = True

html_theme = "furo"
html_title = f"orthocone {release}"
html_static_path = ["site.css"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False
