// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/estimate.h>

#include <orthocone/base/ranks.h>
#include <orthocone/march/step_solver.h>
#include <orthocone/multigrid/multigrid_body.h>
#include <orthocone/scene/load_program.h>

#include <algorithm>
#include <cmath>

namespace orthocone
{
namespace
{
constexpr double bytes_per_gigabyte = 1e9;

/// The parameters of the mesh before any cell was halved.
Parameters on_coarsest(Parameters parameters)
{
  parameters.mesh.refined_cells.clear();
  parameters.mesh.refinements = 0;
  return parameters;
}

/// The cost of trilinear elements on the coarsest mesh: docs/performance.md, "Large coarsest meshes".
struct CoarsestCost
{
  double gigabytes, set_up_seconds;
  double hold_seconds; ///< in an iteration of Newton's method
  double cycle_seconds;
};

CoarsestCost cost_of_coarsest(const Parameters &coarsest, const ModelSymmetry &symmetry)
{
  MeshOptions mesh = coarsest.mesh;
  mesh.degree = 1;
  const ModelSize size = make_shape(coarsest.geometry, mesh)->size(symmetry);
  const double n = size.dofs, entries = std::pow(n, 4. / 3);
  if (aggregates_coarsest(n, size.contact_nodes))
    return {7e3 * n / bytes_per_gigabyte, 2e-5 * n, 1.5e-5 * n, 9e-7 * n};
  const double contact = 3 * size.contact_nodes;
  constexpr double dense = 5 * 8; // bytes: the compliance, and systems that contact makes of it
  return {(240 * entries + dense * contact * contact) / bytes_per_gigabyte, 6e-10 * n * n,
          1e-11 * contact * contact * contact, 1.8e-8 * entries};
}

/// Body::stretch(), or 1 where meshing takes too long.
double stretch_of(const Parameters &coarsest, const ModelSymmetry &symmetry)
{
  constexpr double most_cells = 2e5;
  if (make_shape(coarsest.geometry, coarsest.mesh)->size(symmetry).cells > most_cells)
    return 1;
  return stretch(BodyMesh(coarsest.geometry, coarsest.mesh, symmetry.planes()).triangulation());
}

/// V-cycles as a multiple of those of steel (nu = 0.3). Smoothers see shapes that hardly change volume as
/// soft: with projected elements, cycles grow with the logarithm of lambda / mu = 2 nu / (1 - 2 nu). Within
/// 25 % of the table in docs/stability.md, "On the whole body".
double cycles_of_volume(const double poisson_ratio)
{
  constexpr double of_steel = 0.4, of_each_digit = 2;
  return 1 + of_each_digit * std::max(0., std::log10(of_steel / (1 - 2 * poisson_ratio)));
}
} // namespace

double multigrid_gigabytes(const Parameters &parameters, const ModelSize &size, const ModelSymmetry &symmetry)
{
  // docs/performance.md, "Multigrid". Each round of halved cells adds a level that is hardly smaller than the
  // one behind it. The transfer to it has numbers of cells, which are many with degree 1.
  constexpr double program = 0.17, bytes_per_unknown = 1200;
  const double bytes_per_round = parameters.mesh.degree == 1 ? 3000 : 480;
  const auto n_rounds = static_cast<double>(parameters.mesh.refined_cells.size());
  // Every level has a march of its own, with a coarsest mesh of its own.
  const double n_levels = 1. + parameters.mesh.refinements + n_rounds;
  const double of_each = program + n_levels * cost_of_coarsest(on_coarsest(parameters), symmetry).gigabytes +
                         step_gigabytes(parameters.load, size.contact_nodes);
  // A checkpoint has the bodies of a cycle that another one follows in its text, which is copied, too.
  constexpr double copies = 7;
  const unsigned int n_cycles = parameters.load.cycles;
  const double n_bodies = n_cycles > 1 ? LoadProgram(parameters.load).n_solved_parts() / n_cycles : 0;
  const double bodies = std::min<double>(StartMemory::most_body_bytes, sizeof(double) * size.dofs * n_bodies);
  // This counts all processes as if they ran on this machine.
  return n_ranks() * of_each +
         ((bytes_per_unknown + bytes_per_round * n_rounds) * size.dofs + copies * bodies) /
             bytes_per_gigabyte;
}

/// The numbers are from docs/performance.md, "Multigrid".
Estimate multigrid_estimate(const Parameters &parameters, const ModelSize &size,
                            const ModelSymmetry &symmetry)
{
  constexpr double set_up = 1.5e-5, v_cycle = 4.5e-7;        // s per unknown
  constexpr double in_first_cycle = 20, in_later_cycles = 6; // V-cycles of a step
  constexpr double in_iteration = 3;                         // V-cycles of an iteration of Newton's method
  constexpr double even = 2.5;          // stretch of cells that does not slow multigrid down
  constexpr double of_projection = 1.3; // V-cycles whose products average the divergence over cells
  const bool projects = parameters.mesh.resolved_volumetric_quadrature() == VolumetricQuadrature::projected;
  const double v_cycle_per_unknown = v_cycle * (projects ? of_projection : 1);
  const Parameters coarsest = on_coarsest(parameters);
  const double cycles_per_step =
      (in_later_cycles + (in_first_cycle - in_later_cycles) / std::max(1U, parameters.load.cycles)) *
      std::max(1., stretch_of(coarsest, symmetry) / even) *
      cycles_of_volume(parameters.material.poisson_ratio);
  const CoarsestCost cost = cost_of_coarsest(coarsest, symmetry);
  Estimate result{};
  result.gigabytes = multigrid_gigabytes(parameters, size, symmetry);
  result.set_up_seconds = 0.3 + set_up * size.dofs + cost.set_up_seconds;
  result.step_seconds = cycles_per_step * (v_cycle_per_unknown * size.dofs + cost.cycle_seconds +
                                           cost.hold_seconds / in_iteration) +
                        volume_seconds_per_step(parameters.output, size.dofs);
  return result;
}
} // namespace orthocone
