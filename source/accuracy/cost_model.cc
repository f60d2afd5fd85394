// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/cost_model.h>

#include "cost_constants.h"
#include "counterface_cost.h"

#include <orthocone/base/errors.h>
#include <orthocone/base/ranks.h>
#include <orthocone/base/stopwatch.h>
#include <orthocone/body/backends/stiffness_factor.h>
#include <orthocone/body/shapes/shape_kind.h>
#include <orthocone/march/step_solver.h>
#include <orthocone/multigrid/multigrid_body.h>
#include <orthocone/scene/load_program.h>
#include <orthocone/scene/parameters.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace orthocone
{
namespace
{
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

double n_solved_parts(const LoadOptions &load)
{
  return LoadProgram(load).n_solved_parts();
}

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

ModelSize size_of(const BodyUnknowns &unknowns, const double stiffness_entries)
{
  return {static_cast<double>(unknowns.size().cells),
          static_cast<double>(unknowns.contact_surface().nodes.size()),
          static_cast<double>(unknowns.size().dofs), stiffness_entries};
}

/// The mesh options with the cells that refinements make, as if these were given.
MeshOptions refined(MeshOptions mesh)
{
  const unsigned int halves = 1U << mesh.refinements;
  mesh.rings = halves * mesh.n_rings();
  mesh.core_cells *= halves;
  mesh.layers *= halves;
  for (unsigned int &n : mesh.cells)
    n *= halves;
  return mesh;
}

/// The parameters of the mesh before any cell was halved.
Parameters on_coarsest(Parameters parameters)
{
  parameters.mesh.refined_cells.clear();
  parameters.mesh.refinements = 0;
  return parameters;
}

/// The cost of trilinear elements on the coarsest mesh.
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
    return {cost::aggregated_bytes * n / cost::gigabyte, cost::aggregated_set_up * n,
            cost::aggregated_hold * n, cost::aggregated_cycle * n};
  const double contact = 3 * size.contact_nodes;
  return {(cost::factorized_bytes * entries + cost::factorized_dense_bytes * contact * contact) /
              cost::gigabyte,
          cost::factorized_set_up * n * n, cost::factorized_hold * contact * contact * contact,
          cost::factorized_cycle * entries};
}

/// Body::stretch(), or 1 where meshing takes too long.
double stretch_of(const Parameters &coarsest, const ModelSymmetry &symmetry)
{
  if (make_shape(coarsest.geometry, coarsest.mesh)->size(symmetry).cells > cost::most_meshed_cells)
    return 1;
  return stretch(BodyMesh(coarsest.geometry, coarsest.mesh, symmetry.planes()).triangulation());
}

/// V-cycles as a multiple of those of steel. Smoothers see shapes that hardly change volume as soft.
double cycles_of_volume(const double poisson_ratio)
{
  return 1 + cost::cycles_per_digit * std::max(0., std::log10(cost::of_steel / (1 - 2 * poisson_ratio)));
}
} // namespace

ModelSize model_size(const Parameters &parameters, const ModelSymmetry &symmetry)
{
  const ModelSize size = make_shape(parameters.geometry, refined(parameters.mesh))->size(symmetry);
  if (parameters.mesh.refined_cells.empty())
    return size;
  const Body body(parameters, symmetry); // only meshing counts its cells
  return size_of(body.unknowns(), body.unknowns().size().dofs / size.dofs * size.stiffness_entries);
}

CostModel::CostModel(const Parameters &parameters, const ModelSymmetry &symmetry)
    : CostModel(parameters, symmetry, model_size(parameters, symmetry))
{
}

CostModel::CostModel(const Parameters &parameters, const ModelSymmetry &symmetry, const ModelSize &size)
    : parameters_(parameters),
      symmetry_(symmetry),
      size_(size)
{
}

/// Memory of so many matrices of the size of the compliance, in numbers.
double CostModel::dense(const double n_matrices) const
{
  const double n_contact = 3 * size_.contact_nodes;
  return n_matrices * n_contact * n_contact;
}

/// The memory that a run keeps for its steps, GB.
double CostModel::step_gigabytes() const
{
  const LoadOptions &load = parameters_.load;
  const double n_steps = std::min(n_solved_parts(load), most_solved_parts); // computed ones
  const double starts =
      2 * n_steps / std::max(1U, load.cycles) * 3 * size_.contact_nodes * cost::bytes_per_number;
  return (cost::bytes_per_step * n_steps +
          cost::copies_of_starts * std::min(starts, static_cast<double>(StartMemory::most_bytes))) /
         cost::gigabyte;
}

/// Time that writing fields of the whole body takes in a step, on average, s.
double CostModel::volume_seconds_per_step() const
{
  return cost::seconds_per_value * size_.dofs * fields_written_per_step(parameters_.output.volume_interval);
}

/// For a factorization of this cost at `rate` operations/s, and for the dense compliance that follows. The
/// memory is that of the program, the stiffness and CHOLMOD's copy of it, the factor, and dense matrices.
Estimate CostModel::of_factorization(const FactorizationCost &factor, const double rate) const
{
  const double n_contact = 3 * size_.contact_nodes;
  Estimate result{};
  result.gigabytes =
      cost::program +
      (2 * cost::numbers_per_entry * size_.stiffness_entries + factor.entries + dense(cost::dense_matrices)) *
          cost::bytes_per_number / cost::gigabyte +
      step_gigabytes();
  if (parameters_.obstacle.kind.chosen().gives_way())
    result.gigabytes += dense(cost::of_counterbody) * cost::bytes_per_number / cost::gigabyte;
  if (parameters_.wear.wears() && parameters_.wear.deep_steps == DeepWear::implicitly)
    result.gigabytes += dense(cost::of_deep_wear) * cost::bytes_per_number / cost::gigabyte;
  const unsigned int dim = symmetry_.is_section() ? 2 : 3;
  const double n_components = symmetry_.is_section() ? symmetry_.section()->n_components() : 3;
  const double n_cell = n_components * std::pow(parameters_.mesh.degree + 1, dim);
  const double products =
      size_.cells * std::pow(parameters_.mesh.n_quadrature_points(), dim) * 2 * n_cell * n_cell;
  result.set_up_seconds = cost::start_up + cost::assembly * products / rate +
                          cost::factorization * factor.flops / rate +
                          cost::condensation * cube(n_contact) / rate;
  const double contact = dense(cost::products_per_step) * cost::bytes_per_entry_of_w / cost::memory_bandwidth;
  const double checks = (cost::factors_read_by_checks * factor.entries +
                         cost::matrices_read_by_checks * size_.stiffness_entries) *
                        cost::bytes_per_number / cost::memory_bandwidth;
  result.step_seconds = contact + checks;
  return result;
}

bool CostModel::is_meshed() const
{
  return kind_of(parameters_.geometry).is_meshed();
}

/// Products by FFT take n log n operations, and the iterations do not grow with n.
Estimate CostModel::of_grid() const
{
  const double n = size_.contact_nodes, drawn = fields_written_per_step(parameters_.output.contact_interval);
  return {cost::program + cost::grid_bytes * n / cost::gigabyte + step_gigabytes(),
          cost::start_up + cost::grid_set_up * n,
          cost::grid_step * n * std::log2(n) + cost::seconds_per_value * 9 * n * drawn};
}

Estimate CostModel::condensed(const Body &body) const
{
  if (!is_meshed())
    return of_grid();
  const BodyUnknowns &unknowns = body.unknowns();
  dealii::SparsityPattern pattern;
  body.make_pattern(pattern);
  const CostModel exact(parameters_, symmetry_,
                        size_of(unknowns, static_cast<double>(pattern.n_nonzero_elements())));
  Estimate result =
      exact.of_factorization(factorization_cost(pattern, unknowns.n_interior()), measured_flop_rate());
  result.step_seconds += exact.volume_seconds_per_step() +
                         cost::seconds_per_value * 9 * drawn_nodes(unknowns.contact_surface(), symmetry_) *
                             fields_written_per_step(parameters_.output.contact_interval);
  if (parameters_.obstacle.kind != ObstacleKind::body)
    return result;
  // The lower body has everything but load steps of its own.
  Parameters lower = lower_parameters(parameters_);
  lower.load = LoadOptions{};
  lower.output.contact_interval = 0;
  const Estimate own = CostModel(lower, symmetry_).condensed(Body(lower, symmetry_));
  return {result.gigabytes + own.gigabytes, result.set_up_seconds + own.set_up_seconds,
          result.step_seconds + own.step_seconds};
}

Estimate CostModel::usual() const
{
  if (!is_meshed())
    return of_grid();
  return of_factorization(
      {cost::factor_entries * std::pow(size_.dofs, 4. / 3), cost::factor_flops * size_.dofs * size_.dofs},
      cost::flop_rate);
}

double CostModel::least_gigabytes() const
{
  return is_meshed() ? (cost::numbers_per_entry * size_.stiffness_entries + dense(cost::dense_matrices)) *
                           cost::bytes_per_number / cost::gigabyte
                     : of_grid().gigabytes;
}

Estimate CostModel::least() const
{
  if (!is_meshed())
    return of_grid();
  return {least_gigabytes(), cost::condensation * cube(3 * size_.contact_nodes) / measured_flop_rate(),
          dense(2) * cost::bytes_per_entry_of_w / cost::memory_bandwidth};
}

/// This counts all processes as if they ran on this machine. Every level has a march of its own, with a
/// coarsest mesh of its own. A checkpoint has the bodies of a cycle that another one follows.
double CostModel::multigrid_gigabytes() const
{
  const MeshOptions &mesh = parameters_.mesh;
  const double bytes_per_round = mesh.degree == 1 ? cost::bytes_per_round_of_degree_1 : cost::bytes_per_round;
  const auto n_rounds = static_cast<double>(mesh.refined_cells.size());
  const double n_levels = 1. + mesh.refinements + n_rounds;
  const double of_each = cost::multigrid_program +
                         n_levels * cost_of_coarsest(on_coarsest(parameters_), symmetry_).gigabytes +
                         step_gigabytes();
  const unsigned int n_cycles = parameters_.load.cycles;
  const double n_bodies = n_cycles > 1 ? n_solved_parts(parameters_.load) / n_cycles : 0;
  const double bodies =
      std::min<double>(StartMemory::most_body_bytes, sizeof(double) * size_.dofs * n_bodies);
  return n_ranks() * (of_each + counterface_cost(parameters_.obstacle, size_.contact_nodes).gigabytes) +
         ((cost::bytes_per_unknown + bytes_per_round * n_rounds) * size_.dofs +
          cost::copies_of_bodies * bodies) /
             cost::gigabyte;
}

Estimate CostModel::multigrid() const
{
  const MeshOptions &mesh = parameters_.mesh;
  const bool projects = mesh.resolved_volumetric_quadrature() == VolumetricQuadrature::projected;
  const double v_cycle_per_unknown = cost::v_cycle * (projects ? cost::of_projection : 1);
  const Parameters coarsest = on_coarsest(parameters_);
  const double of_first_cycle =
      (cost::cycles_of_first_steps - cost::cycles_of_later_steps) / std::max(1U, parameters_.load.cycles);
  const double cycles_per_step = (cost::cycles_of_later_steps + of_first_cycle) *
                                 std::max(1., stretch_of(coarsest, symmetry_) / cost::even_stretch) *
                                 cycles_of_volume(parameters_.material.poisson_ratio);
  const CoarsestCost of_coarsest = cost_of_coarsest(coarsest, symmetry_);
  const CounterfaceCost below = counterface_cost(parameters_.obstacle, size_.contact_nodes);
  return {multigrid_gigabytes(),
          cost::multigrid_start_up + cost::multigrid_set_up * size_.dofs + of_coarsest.set_up_seconds +
              below.set_up_seconds,
          cycles_per_step *
                  (v_cycle_per_unknown * size_.dofs + below.cycle_seconds + of_coarsest.cycle_seconds +
                   of_coarsest.hold_seconds / cost::cycles_per_iteration) +
              volume_seconds_per_step()};
}

void CostModel::require_countable() const
{
  constexpr double most = std::numeric_limits<int>::max();
  const double compliance = dense(1);
  if (!is_meshed() || (size_.stiffness_entries <= most && compliance <= most))
    return;
  std::ostringstream text;
  text
      << std::setprecision(2) << "the model has about "
      << (compliance > most ? size_.contact_nodes : size_.stiffness_entries)
      << (compliance > most ? " contact nodes, whose compliance has" : " entries in its stiffness, which are")
      << " more than the 2^31 numbers that a factorization can count: a coarser mesh or a reduced Mesh/Model "
         "needs less";
  throw TooLargeError(text.str());
}

double CostModel::needed_gigabytes(const double gigabytes) const
{
  if (parameters_.mesh.backend == BodyBackend::multigrid)
    return multigrid_gigabytes();
  const double steps = step_gigabytes();
  if (const double least = least_gigabytes(); least > gigabytes || !is_meshed())
    return least;
  require_countable();
  const double lower_dofs = parameters_.obstacle.kind == ObstacleKind::body
                                ? model_size(lower_parameters(parameters_), symmetry_).dofs
                                : 0;
  if ((size_.dofs + lower_dofs) * cost::most_per_unknown + cost::most_program + steps < gigabytes)
    return 0;
  return condensed(Body(parameters_, symmetry_)).gigabytes;
}

bool is_too_large(const Parameters &parameters, const ModelSymmetry &symmetry, const double gigabytes)
{
  try
  {
    return CostModel(parameters, symmetry).needed_gigabytes(gigabytes) > gigabytes;
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
  const double needed = CostModel(parameters, symmetry).needed_gigabytes(limit.gigabytes);
  if (const std::string lack = lack_of_memory(needed, limit); !lack.empty())
    throw InputError(lack);
}
} // namespace orthocone
