// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/parameters/options.h>

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace orthocone
{
/// A parameter file as it was read.
struct ParameterFile
{
  Parameters parameters;
  std::string text; ///< as written, with the included files in their place: it can be read from any folder
};

/// Reads a .prm or .json file and then the overrides "Section/Entry=value" in their order. A line `include
/// FILE` of a .prm file reads FILE, relative to the folder of the including file, in its place. Throws
/// InputError (one sentence: file and line, entry, value given, what is allowed) or FileError. The file is
/// read once, so it may be a pipe.
ParameterFile read_parameter_file(const std::string &file_name,
                                  const std::vector<std::string> &overrides = {});
Parameters read_parameters(const std::string &file_name, const std::vector<std::string> &overrides = {});

/// Whether a parameter file is one of JSON, by the ending of its name.
bool is_json(const std::string &file_name);

/// Writes a complete, commented .prm file that holds these parameters.
void write_parameters(const Parameters &parameters, std::ostream &out);

/// All entries and the texts of their values, as "Section/Entry", in the order of the file.
std::vector<std::pair<std::string, std::string>> entry_values(const Parameters &parameters);

/// `parameters` with the entries of one section as in `values`, which are such as entry_values() returns.
/// Throws InputError.
Parameters with_section(const Parameters &parameters, const std::string &section,
                        const std::vector<std::pair<std::string, std::string>> &values);

/// What is legal but suspicious, a sentence each, such as large strains or a mesh too coarse at the rim.
std::vector<std::string> parameter_warnings(const Parameters &parameters);

/// Conditions between entries, e.g. probes lie on the contact surface. Throws InputError, without the file's
/// name.
void check_parameters(const Parameters &parameters);
} // namespace orthocone
