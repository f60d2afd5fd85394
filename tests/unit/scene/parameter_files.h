// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Parameter files for tests.
#pragma once

#include "folder_of_files.h"

#include <orthocone/base/errors.h>
#include <orthocone/scene/parameters.h>

namespace orthocone::test
{
/// The sentence with which a parameter file is rejected, or "" if it is not.
inline std::string rejection(const std::string &file, const std::vector<std::string> &overrides = {})
{
  try
  {
    read_parameters(file, overrides);
    return "";
  }
  catch (const InputError &error)
  {
    return error.what();
  }
}

/// The default scene with these entries.
inline Parameters parameters_with(const std::vector<std::string> &entries)
{
  const Folder folder;
  return read_parameters(folder.write("scene.prm", "subsection Geometry\n  set Radius = 10\nend\n"), entries);
}
} // namespace orthocone::test
