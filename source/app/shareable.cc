// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "shareable.h"

#include <orthocone/accuracy/backend_choice.h>
#include <orthocone/base/errors.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/text.h>

#include <string>

namespace orthocone
{
void require_shareable(const Parameters &parameters, const ModelChoice &model)
{
  if (n_ranks() == 1)
    return;
  const auto refuse = [](const std::string &entry, const std::string &value, const std::string &allowed)
  {
    throw InputError(entry + " = " + value + " with " + std::to_string(n_ranks()) +
                     " processes: allowed is " + allowed + ", or one process");
  };
  const std::string found = " (one process writes what it found to parameters.prm)";
  if (parameters.mesh.accuracy != 0)
    refuse("Mesh/Accuracy", to_text(parameters.mesh.accuracy), "0" + found);
  if (parameters.mesh.adaptive != 0)
    refuse("Mesh/Adaptive", std::to_string(parameters.mesh.adaptive), "0" + found);
  if (parameters.load.accuracy != 0)
    refuse("Load program/Accuracy", to_text(parameters.load.accuracy), "0" + found);
  if (parameters.mesh.backend == BodyBackend::condensed)
    refuse("Mesh/Backend", "condensed", "multigrid");
  if (model.symmetry.is_axisymmetric())
    refuse("Mesh/Model", "section", "full, half or quarter: only multigrid is shared, and has no sections");
  if (parameters.mesh.backend == BodyBackend::automatic && !multigrid_can(parameters, model.symmetry))
    refuse("Mesh/Backend", "auto",
           "what multigrid can compute: newton or guided, full volumetric quadrature");
}
} // namespace orthocone
