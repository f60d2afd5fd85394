// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "blas_function.h"

#include <orthocone/base/version.h>

#include <Eigen/Core>
#include <cholmod.h>
#include <dlfcn.h>
#include <orthocone_revision.h>

namespace orthocone
{
std::string program_version()
{
  return ORTHOCONE_VERSION " (" ORTHOCONE_REVISION ")";
}

std::string running_blas()
{
  if (auto *const describe = function_of_blas<const char *()>("openblas_get_config"))
    return describe();
  Dl_info info{};
  const bool is_found = dladdr(dlsym(RTLD_DEFAULT, "dgemm_"), &info) != 0;
  return std::string(is_found ? info.dli_fname : "unknown") +
         " (not OpenBLAS: dense algebra may be ten times slower)";
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
