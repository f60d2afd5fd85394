// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/entries/files.h>
#include <orthocone/scene/options.h>

namespace orthocone
{
/// A parameter file as it was read.
struct ParameterFile
{
  Parameters parameters;
  std::string text; ///< as written, with the included files in their place: it can be read from any folder
};

/// Adds all sections, in the order of the file. `parameters` must outlive `list`.
void declare_parameters(Parameters &parameters, EntryList &list);

/// Parameters and the list of their entries.
class DeclaredParameters
{
public:
  explicit DeclaredParameters(const Parameters &given = {})
      : parameters(given)
  {
    declare_parameters(parameters, list);
  }
  DeclaredParameters(const DeclaredParameters &) = delete; // the list refers to the parameters
  DeclaredParameters &operator=(const DeclaredParameters &) = delete;

  Parameters parameters;
  EntryList list;
};

/// Gives both bodies what they have in common: the kind of body, in plane strain of one thickness, and the
/// loads of the load program, of which each takes its own. To be called where `parameters` are made or
/// changed by hand.
void share_among_bodies(Parameters &parameters);

/// Reads a .prm or .json file, and applies the overrides "Section/Entry=value" in their order. Throws as
/// read_entries() and assign_entry() do.
ParameterFile read_parameter_file(const std::string &file_name,
                                  const std::vector<std::string> &overrides = {});
Parameters read_parameters(const std::string &file_name, const std::vector<std::string> &overrides = {});

/// Writes a complete, commented .prm file with these parameters. Throws nothing; `out` has the state of the
/// stream.
void write_parameters(const Parameters &parameters, std::ostream &out);

/// All entries ("Section/Entry") and the texts of their values, in the order of the file.
std::vector<std::pair<std::string, std::string>> entry_values(const Parameters &parameters);

/// "Section/Entry = value".
std::string entry_text(const Parameters &parameters, const std::string &entry);

/// `parameters` with the entries of one section as in `values`, which have the form that entry_values()
/// returns. Throws InputError for a value that is not allowed.
Parameters with_section(const Parameters &parameters, const std::string &section,
                        const std::vector<std::pair<std::string, std::string>> &values);

/// The scene with the lower body in the place of the upper one, on a rigid plane. Throws nothing.
Parameters lower_parameters(const Parameters &parameters);

/// Checks conditions between entries: for instance that probes are on the contact surface. Throws InputError,
/// whose sentence does not name the parameter file, and FileError for a mesh file that cannot be read.
void check_parameters(const Parameters &parameters);

/// Warnings of what is allowed but suspicious, such as large strains or a mesh that is too coarse at the rim,
/// in a sentence each.
std::vector<std::string> parameter_warnings(const Parameters &parameters);

/// Whether the rim of the base touches the obstacle if anything does. Elsewhere the steps show what it does.
bool rim_surely_touches(const Parameters &parameters);
} // namespace orthocone
