// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/estimate.h>

#include <orthocone/base/stopwatch.h>
#include <orthocone/body/backends/stiffness_factor.h>
#include <orthocone/march/step_solver.h>
#include <orthocone/scene/parameters.h>
#include <orthocone/scene/load_program.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace orthocone
{
namespace
{
constexpr double bytes_per_number = 8;
constexpr double gigabyte = 1e9;
constexpr double dense_matrices = 1.5;   // the compliance, and what inner iterations use of it
constexpr double of_counterbody = 1;     // one more: its compliance, then the sum
constexpr double of_deep_wear = 1.5;     // the same: W with the depth, and its copy in single precision
constexpr double bytes_per_step = 100;   // in the lists of files
constexpr double memory_bandwidth = 8e9; // bytes/s that one core of a usual machine reads

/// Floating point operations per second of a matrix product that fits into the cache.
double measured_flop_rate()
{
  constexpr Eigen::Index n = 300;
  constexpr unsigned int n_products = 3;
  const Eigen::MatrixXd a = Eigen::MatrixXd::Constant(n, n, 0.5);
  Eigen::MatrixXd product = a;
  double best = 0;
  for (unsigned int i = 0; i < n_products; ++i)
  {
    const Stopwatch watch;
    product.noalias() = a * a;
    best = std::max(best, 2. * n * n * n / std::max(watch.seconds(), 1e-9));
  }
  return best;
}

double cube(const double value)
{
  return value * value * value;
}

constexpr double seconds_per_value = 1.5e-6; // written to a file

double fields_written_per_step(const unsigned int interval)
{
  return interval == 0 ? 0 : 1. / interval;
}

double drawn_nodes(const ContactSurface &surface, const ModelSymmetry &symmetry)
{
  double n = 0;
  for (const ContactNode &node : surface.nodes)
    n += symmetry.n_images(surface, node);
  return n;
}
} // namespace

double step_gigabytes(const LoadOptions &load, const double contact_nodes)
{
  const double n_steps = std::min(LoadProgram(load).n_solved_parts(), most_solved_parts); // computed ones
  const double starts = 2 * n_steps / std::max(1U, load.cycles) * 3 * contact_nodes * bytes_per_number;
  // The starts are kept, and take memory again in the text of a checkpoint.
  return (bytes_per_step * n_steps + 3 * std::min(starts, static_cast<double>(StartMemory::most_bytes))) /
         gigabyte;
}

double volume_seconds_per_step(const OutputOptions &output, const double dofs)
{
  return seconds_per_value * dofs * fields_written_per_step(output.volume_interval);
}

/// The mesh options with the cells that refinements make, as if these were given.
static MeshOptions refined(MeshOptions mesh)
{
  const unsigned int halves = 1U << mesh.refinements;
  mesh.rings = halves * mesh.n_rings();
  mesh.core_cells *= halves;
  mesh.layers *= halves;
  for (unsigned int &n : mesh.cells)
    n *= halves;
  return mesh;
}

ModelSize model_size(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  const ModelSize size = make_shape(parameters.geometry, refined(parameters.mesh))->size(symmetry);
  if (parameters.mesh.refined_cells.empty())
    return size;
  const Body body(parameters, symmetry); // only meshing counts its cells
  const BodyUnknowns &unknowns = body.unknowns();
  const double dofs = unknowns.size().dofs;
  return {static_cast<double>(unknowns.size().cells),
          static_cast<double>(unknowns.contact_surface().nodes.size()), dofs,
          dofs / size.dofs * size.stiffness_entries};
}

/// The estimate for a factorization of this cost at `rate` operations/s, and for the dense compliance that
/// follows.
static Estimate of_factorization(const Parameters &parameters, const ModelSize &size,
                                 const ModelSymmetry &symmetry, const FactorizationCost &cost,
                                 const double rate)
{
  const double n_contact = 3 * size.contact_nodes;
  Estimate result{};
  // The sum has the program itself, the stiffness and CHOLMOD's copy of it with their indices, and the
  // factor.
  result.gigabytes =
      0.15 +
      (2 * 1.5 * size.stiffness_entries + cost.entries + dense_matrices * n_contact * n_contact) *
          bytes_per_number / gigabyte +
      step_gigabytes(parameters.load, size.contact_nodes);
  if (parameters.obstacle.kind.chosen().gives_way())
    result.gigabytes += of_counterbody * n_contact * n_contact * bytes_per_number / gigabyte;
  if (parameters.wear.law != WearKind::none && parameters.wear.deep_steps == DeepWear::implicitly)
    result.gigabytes += of_deep_wear * n_contact * n_contact * bytes_per_number / gigabyte;
  const unsigned int dim = symmetry.is_axisymmetric() ? 2 : 3;
  const double n_cell = dim * std::pow(parameters.mesh.degree + 1, dim);
  const double assembly =
      size.cells * std::pow(parameters.mesh.n_quadrature_points(), dim) * 2 * n_cell * n_cell;
  // Factorizations reach half the speed of large products; on small models METIS takes about as long as they
  // do.
  result.set_up_seconds = 0.2 + 4 * assembly / rate + 3 * cost.flops / rate + 2 * cube(n_contact) / rate;
  // The contact solution takes products with half of the compliance in single precision: a hundred and more
  // where the start is far off, two in many steps.
  const double contact = 20 * n_contact * n_contact * bytes_per_number / 4 / memory_bandwidth;
  const double checks = (2 * cost.entries + 3 * size.stiffness_entries) * bytes_per_number / memory_bandwidth;
  result.step_seconds = contact + checks;
  return result;
}

/// Adds the lower body to the estimate of the upper one: everything but the program and the load steps.
static void add_lower_body(const Parameters &parameters, const ModelSymmetry &symmetry, Estimate &sum)
{
  Parameters lower = lower_parameters(parameters);
  lower.load = LoadOptions{};
  lower.output.contact_interval = 0;
  const Estimate own = estimate(lower, Body(lower, symmetry), symmetry);
  sum.gigabytes += own.gigabytes;
  sum.set_up_seconds += own.set_up_seconds;
  sum.step_seconds += own.step_seconds;
}

Estimate estimate(const Parameters &parameters, const Body &body, const ModelSymmetry &symmetry)
{
  const BodyUnknowns &unknowns = body.unknowns();
  dealii::SparsityPattern pattern;
  body.make_pattern(pattern);
  const ModelSize size{static_cast<double>(unknowns.size().cells),
                       static_cast<double>(unknowns.contact_surface().nodes.size()),
                       static_cast<double>(unknowns.size().dofs),
                       static_cast<double>(pattern.n_nonzero_elements())};
  Estimate result = of_factorization(
      parameters, size, symmetry, factorization_cost(pattern, unknowns.n_interior()), measured_flop_rate());
  const double n_drawn = drawn_nodes(unknowns.contact_surface(), symmetry);
  result.step_seconds +=
      volume_seconds_per_step(parameters.output, size.dofs) +
      seconds_per_value * 9 * n_drawn * fields_written_per_step(parameters.output.contact_interval);
  if (parameters.obstacle.kind == ObstacleKind::body)
    add_lower_body(parameters, symmetry, result);
  return result;
}

Estimate usual_estimate(const Parameters &parameters, const ModelSize &size, const ModelSymmetry &symmetry)
{
  constexpr double rate = 5e10; // operations/s of one or two usual cores
  // These fit factorization_cost() of cylinders with 1e4 to 1e5 unknowns and degrees 1 to 3 to a quarter.
  constexpr double entries = 28, flops = 28;
  const FactorizationCost cost{entries * std::pow(size.dofs, 4. / 3), flops * size.dofs * size.dofs};
  return of_factorization(parameters, size, symmetry, cost, rate);
}

double least_gigabytes(const ModelSize &size)
{
  const double n_contact = 3 * size.contact_nodes;
  return (1.5 * size.stiffness_entries + dense_matrices * n_contact * n_contact) * bytes_per_number /
         gigabyte;
}

Estimate least_estimate(const ModelSize &size)
{
  const double n_contact = 3 * size.contact_nodes;
  Estimate result{};
  result.gigabytes = least_gigabytes(size);
  result.set_up_seconds = 2 * cube(n_contact) / measured_flop_rate();
  result.step_seconds = 2 * n_contact * n_contact * bytes_per_number / 4 / memory_bandwidth;
  return result;
}

std::string describe(const Estimate &estimate, const ComputedSteps &n_steps, const MemoryLimit &limit,
                     const bool is_least)
{
  const char *const about = is_least ? "more than " : "about ";
  const auto seconds = [&](const double n) { return estimate.set_up_seconds + n * estimate.step_seconds; };
  const auto counted = [](const double n) { return std::to_string(static_cast<unsigned long>(n)); };
  const bool has_jumps = n_steps.least < n_steps.most;
  std::ostringstream text;
  text << std::setprecision(2) << "memory         " << about << estimate.gigabytes << " GB; " << limit.source
       << " " << (limit.gigabytes < 10 ? limit.gigabytes : std::round(limit.gigabytes)) << " GB\n"
       << "time           " << about << seconds(n_steps.least) << " s";
  if (has_jumps)
    text << ", and " << seconds(n_steps.most) << " s if no cycle is jumped";
  text << ": set-up " << estimate.set_up_seconds << " s, "
       << (has_jumps ? counted(n_steps.least) + " to " : "") << counted(n_steps.most) << " load steps of "
       << estimate.step_seconds << " s" << (is_least ? "" : " (to a factor of 3)");
  return text.str();
}

std::string describe(const ModelSize &size)
{
  std::ostringstream text;
  text << std::setprecision(2) << "mesh           about " << size.cells << " cells\n"
       << "unknowns       about " << size.dofs << "\n"
       << "contact nodes  about " << size.contact_nodes;
  return text.str();
}
} // namespace orthocone
