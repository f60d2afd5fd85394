// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace orthocone
{
/// Reads a .prm or .json file and then the overrides "Section/Entry=value" in their order. A line `include
/// FILE` of a .prm file reads FILE, relative to the folder of the including file, in its place. Throws
/// InputError (one sentence: file and line, entry, value given, what is allowed) or FileError.
Parameters read_parameters(const std::string &file_name, const std::vector<std::string> &overrides = {});

/// Writes a complete, commented .prm file that holds these parameters.
void write_parameters(const Parameters &parameters, std::ostream &out);

/// Conditions between entries, e.g. probes lie on the contact surface. Throws InputError, without the file's
/// name.
void check_parameters(const Parameters &parameters);
} // namespace orthocone
