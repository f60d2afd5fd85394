// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/memory_need.h>

#include <orthocone/accuracy/estimate.h>
#include <orthocone/base/errors.h>
#include <orthocone/scene/parameters.h>

#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>

namespace orthocone
{
void require_countable(const ModelSize &size)
{
  constexpr double most = std::numeric_limits<int>::max();
  const double compliance = 9 * size.contact_nodes * size.contact_nodes;
  if (size.stiffness_entries <= most && compliance <= most)
    return;
  std::ostringstream text;
  text
      << std::setprecision(2) << "the model has about "
      << (compliance > most ? size.contact_nodes : size.stiffness_entries)
      << (compliance > most ? " contact nodes, whose compliance has" : " entries in its stiffness, which are")
      << " more than the 2^31 numbers that a factorization can count: a coarser mesh or a reduced Mesh/Model "
         "needs less";
  throw TooLargeError(text.str());
}

/// The memory that the model needs, or nothing where this is certainly less than `gigabytes`. The estimate
/// meshes the model and finds an order, so it is made only where the answer depends on it.
static std::optional<double> needed_gigabytes(const Parameters &parameters, const ModelSymmetry &symmetry,
                                              const double gigabytes)
{
  constexpr double most_per_unknown = 1e-4, program = 0.2; // far more than any model needs
  const ModelSize size = model_size(parameters, symmetry);
  if (parameters.mesh.backend == BodyBackend::multigrid)
    return multigrid_gigabytes(parameters, size, symmetry);
  const double steps = step_gigabytes(parameters.load, size.contact_nodes);
  if (const double least = least_gigabytes(size); least > gigabytes)
    return least;
  require_countable(size);
  const double lower_dofs = parameters.obstacle.kind == ObstacleKind::body
                                ? model_size(lower_parameters(parameters), symmetry).dofs
                                : 0;
  if ((size.dofs + lower_dofs) * most_per_unknown + program + steps < gigabytes)
    return std::nullopt;
  return estimate(parameters, Body(parameters, symmetry), symmetry).gigabytes;
}

bool is_too_large(const Parameters &parameters, const ModelSymmetry &symmetry, const double gigabytes)
{
  try
  {
    return needed_gigabytes(parameters, symmetry, gigabytes).value_or(0) > gigabytes;
  }
  catch (const TooLargeError &)
  {
    return true;
  }
}

std::string lack_of_memory(const double needed, const MemoryLimit &limit)
{
  if (needed <= limit.gigabytes)
    return {};
  std::ostringstream text;
  text << std::setprecision(2) << "memory: the model needs about " << needed << " GB, and " << limit.source
       << " " << limit.gigabytes
       << " GB; a coarser mesh or a reduced Mesh/Model needs less, --insist runs all the same";
  return text.str();
}

void require_memory(const Parameters &parameters, const ModelSymmetry &symmetry, const MemoryLimit &limit)
{
  const double needed = needed_gigabytes(parameters, symmetry, limit.gigabytes).value_or(0);
  if (const std::string lack = lack_of_memory(needed, limit); !lack.empty())
    throw InputError(lack);
}
} // namespace orthocone
