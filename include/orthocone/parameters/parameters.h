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

/// Reads a .prm or .json file and applies the overrides "Section/Entry=value" in their order. A line `include
/// FILE` of a .prm file reads FILE, relative to the folder of the including file, in its place. Throws
/// InputError (one sentence: file and line, entry, value given, what is allowed) or FileError. The file is
/// read once, so it may be a pipe.
ParameterFile read_parameter_file(const std::string &file_name,
                                  const std::vector<std::string> &overrides = {});
Parameters read_parameters(const std::string &file_name, const std::vector<std::string> &overrides = {});

/// Whether a parameter file is JSON, by the ending of its name.
bool is_json(const std::string &file_name);

/// Writes a complete, commented .prm file with these parameters. Throws nothing; `out` has the state of the
/// stream.
void write_parameters(const Parameters &parameters, std::ostream &out);

/// All entries ("Section/Entry") and the texts of their values, in the order of the file.
std::vector<std::pair<std::string, std::string>> entry_values(const Parameters &parameters);

/// `parameters` with the entries of one section as in `values`, which have the form that entry_values()
/// returns. Throws InputError for a value that is not allowed.
Parameters with_section(const Parameters &parameters, const std::string &section,
                        const std::vector<std::pair<std::string, std::string>> &values);

/// Warnings of what is allowed but suspicious, such as large strains or a mesh that is too coarse at the rim,
/// in a sentence each.
std::vector<std::string> parameter_warnings(const Parameters &parameters);

/// The warning of elements that are too coarse at the rim of the base; empty where they are not, or nothing
/// is known of the rim's mesh.
std::string coarse_rim_warning(const Parameters &parameters);

/// Whether the rim of the base touches the obstacle if anything does. Elsewhere the steps show what it does.
bool rim_surely_touches(const Parameters &parameters);

/// Checks conditions between entries: for instance that probes are on the contact surface. Throws InputError,
/// whose sentence does not name the parameter file, and FileError for a mesh file that cannot be read.
void check_parameters(const Parameters &parameters);
} // namespace orthocone
