// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/scene/options.h>

namespace orthocone
{
/// Adds its entries to the section Load program.
void declare_program_file(LoadOptions &load, Section &section);

/// Reads the program file of `load`, if there is one, to `load.rows`: a leg a row, with its time and its
/// cycle. A CSV file: the first line names the columns, components of the held face (ux to Mz), `time` and
/// `cycle`, each perhaps with its unit in brackets; columns are separated by ',', ';' or tabs. Throws
/// FileError if the file cannot be read, and InputError with file and line for what is no number, missing or
/// unknown.
void read_program_file(LoadOptions &load);
} // namespace orthocone
