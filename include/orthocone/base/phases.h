// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <array>
#include <utility>

namespace orthocone
{
/// Wall time of the phases of a run, in seconds.
struct PhaseSeconds
{
  double mesh = 0; ///< with the numbering of the unknowns
  double assembly = 0;
  double factorization = 0;
  double condensation = 0;
  double contact = 0;
  double checks = 0;
  double output = 0;      ///< with the checkpoints
  double mesh_search = 0; ///< for Mesh/Accuracy: all that was solved to choose the mesh

  void add(const PhaseSeconds &other); ///< adds the times of every phase
  double sum() const;                  ///< over all phases, s
};

/// The phases in their order, with the names that users see.
constexpr std::array<std::pair<const char *, double PhaseSeconds::*>, 8> phases{
    {{"mesh", &PhaseSeconds::mesh},
     {"assembly", &PhaseSeconds::assembly},
     {"factorization", &PhaseSeconds::factorization},
     {"condensation", &PhaseSeconds::condensation},
     {"contact", &PhaseSeconds::contact},
     {"checks", &PhaseSeconds::checks},
     {"output", &PhaseSeconds::output},
     {"mesh_search", &PhaseSeconds::mesh_search}}};
} // namespace orthocone
