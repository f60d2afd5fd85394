# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Lines that are no statements: name of the file, its text without the message, the message."""
FOLDER = "grammar"
ROWS = [
    ("backslash_missing", "subsection Load program\n  set Legs = 0 0 -0.1 : 5 ;\n             0 0 0 : 10\nend\n",
     "{file}:4: '0 0 0 : 10' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include "
     "FILE' or '# comment'"),
    ("brace", "subsection Mesh\n{\n  set Core cells = 8\n  set Degree = 2\n}\n",
     "{file}:3: '{' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include FILE' or "
     "'# comment'"),
    ("colon_for_equals", "subsection Mesh\n  set Core cells = 8\n  set Degree: 2\nend\n",
     "{file}:4: 'set Degree: 2' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', "
     "'include FILE' or '# comment'"),
    ("comment_behind_value_ends_in_backslash",
     "subsection Mesh\n  set Layers = 3 # see C:\\\n  set Degree = 3\nend\n",
     "{file}:3: 'set Layers = 3 # see C:\\' ends in a backslash, which would make a comment of the next line as "
     "well"),
    ("comment_ends_in_backslash", "subsection Mesh\n  set Layers = 3\n  # see C:\\cases\\\n  set Degree = 3\nend\n",
     "{file}:4: '# see C:\\cases\\' ends in a backslash, which would make a comment of the next line as well"),
    ("comment_of_c", "// quadratic\nsubsection Mesh\n  set Core cells = 8\n  set Degree = 2\nend\n",
     "{file}:2: '// quadratic' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', "
     "'include FILE' or '# comment'"),
    ("comment_of_matlab", "subsection Mesh\n  set Core cells = 8\n  % quadratic\n  set Degree = 2\nend\n",
     "{file}:4: '% quadratic' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', "
     "'include FILE' or '# comment'"),
    ("csv", "step,ux,uy,uz\n1,0,0,-0.02\n",
     "{file}:2: 'step,ux,uy,uz' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', "
     "'include FILE' or '# comment'"),
    ("end_capital", "subsection Mesh\n  set Core cells = 8\n  set Degree = 2\nEnd\n",
     "{file}:5: 'End' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include FILE' "
     "or '# comment'"),
    ("end_missing", "subsection Mesh\n  set Core cells = 8\n  set Degree = 2\n",
     "{file}:2: 'subsection Mesh' has no 'end'"),
    ("end_missing_between", "subsection Geometry\n  set Radius = 10\n\nsubsection Mesh\n  set Degree = 2\nend\n",
     "{file}:2: 'subsection Geometry' has no 'end' before 'subsection Mesh' ({file}:5)"),
    ("end_missing_in_second",
     "subsection Mesh\n  set Core cells = 8\n  set Degree = 2\nend\n\nsubsection Geometry\n  set Radius = 10\n",
     "{file}:7: 'subsection Geometry' has no 'end'"),
    ("end_missing_tab", "subsection Mesh\n  set Degree = 2\nend\nsubsection\tFriction\n  set Orthotropy angle = 10\n",
     "{file}:5: 'subsection Friction' has no 'end'"),
    ("end_semicolon", "subsection Mesh\n  set Core cells = 8\n  set Degree = 2\nend;\n",
     "{file}:5: 'end;' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include FILE' "
     "or '# comment'"),
    ("end_too_many", "subsection Mesh\n  set Degree = 2\nend\nend\n", "{file}:5: 'end' has no 'subsection'"),
    ("end_with_name", "subsection Mesh\n  set Degree = 2\nend Mesh\n",
     "{file}:4: 'end Mesh' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include "
     "FILE' or '# comment'"),
    ("equals_missing", "subsection Mesh\n  set Core cells = 8\n  set Degree 2\nend\n",
     "{file}:4: 'set Degree 2' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', "
     "'include FILE' or '# comment'"),
    ("include_without_file", "subsection Mesh\n  set Core cells = 8\n  set Degree = 2\nend\ninclude\n",
     "{file}:6: 'include' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include "
     "FILE' or '# comment'"),
    ("ini", "[Mesh]\n  set Core cells = 8\n  set Degree = 2\n",
     "{file}:2: '[Mesh]' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include "
     "FILE' or '# comment'"),
    ("ini_throughout", "[Geometry]\nRadius = 10\n",
     "{file}:2: '[Geometry]' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include "
     "FILE' or '# comment'"),
    ("json_in_prm", '{"Mesh": {"Degree": 2}}\n',
     "{file}:2: '{\"Mesh\": {\"Degree\": 2}}' is not understood: expected is 'subsection NAME', 'set NAME = "
     "VALUE', 'end', 'include FILE' or '# comment'"),
    ("merge_conflict",
     "subsection Mesh\n<<<<<<< HEAD\n  set Degree = 2\n=======\n  set Degree = 3\n>>>>>>> fine\nend\n",
     "{file}:3: '<<<<<<< HEAD' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', "
     "'include FILE' or '# comment'"),
    ("name_missing", "subsection Mesh\n  set = 2\nend\n",
     "{file}:3: 'set = 2' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include "
     "FILE' or '# comment'"),
    ("plain_words", "subsection Mesh\n  set Core cells = 8\n  set Degree = 2\nend\nThis is my favourite mesh.\n",
     "{file}:6: 'This is my favourite mesh.' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', "
     "'end', 'include FILE' or '# comment'"),
    ("set_capital", "subsection Mesh\n  set Core cells = 8\n  Set Degree = 2\nend\n",
     "{file}:4: 'Set Degree = 2' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', "
     "'include FILE' or '# comment'"),
    ("set_forgotten_throughout", "subsection Mesh\n  Layers = 4\nend\n",
     "{file}:3: 'Layers = 4' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include "
     "FILE' or '# comment'"),
    ("set_missing", "subsection Mesh\n  set Core cells = 8\n  Degree = 2\nend\n",
     "{file}:4: 'Degree = 2' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include "
     "FILE' or '# comment'"),
    ("subsection_capital", "Subsection Mesh\n  set Core cells = 8\n  set Degree = 2\nend\n",
     "{file}:2: 'Subsection Mesh' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', "
     "'include FILE' or '# comment'"),
    ("subsection_without_name", "subsection\n  set Core cells = 8\n  set Degree = 2\nend\n",
     "{file}:2: 'subsection' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include "
     "FILE' or '# comment'"),
    ("tabs", "subsection Mesh\n  set Core cells = 8\n\tDegree\t=\t3\t\nend\n",
     "{file}:4: 'Degree = 3' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include "
     "FILE' or '# comment'"),
    ("upper_case", "SUBSECTION Mesh\n  set Degree = 2\nEND\n",
     "{file}:2: 'SUBSECTION Mesh' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', "
     "'include FILE' or '# comment'"),
    ("value_missing", "subsection Mesh\n  set Core cells = 8\n  set Degree\nend\n",
     "{file}:4: 'set Degree' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include "
     "FILE' or '# comment'"),
    ("yaml", "Mesh:\n  Degree: 2\n",
     "{file}:2: 'Mesh:' is not understood: expected is 'subsection NAME', 'set NAME = VALUE', 'end', 'include "
     "FILE' or '# comment'"),
]
