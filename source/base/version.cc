// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/base/version.h>

#include <orthocone/base/threads.h>

#include <Eigen/Core>
#include <cholmod.h>
#include <orthocone_revision.h>

namespace orthocone
{
std::string program_version()
{
  return ORTHOCONE_VERSION " (" ORTHOCONE_REVISION ")";
}

std::vector<std::pair<std::string, std::string>> versions()
{
  const auto dotted = [](const int a, const int b, const int c)
  { return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c); };
  return {{"orthocone", program_version()},
          {"deal.II", ORTHOCONE_DEAL_II_VERSION},
          {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"CHOLMOD", dotted(CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION)},
          {"BLAS", running_blas()}};
}
} // namespace orthocone
