// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/simulation/estimate.h>

#include <orthocone/elasticity/stiffness_factor.h>
#include <orthocone/simulation/stopwatch.h>

#include <unistd.h>

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
constexpr double dense_matrices = 3;     // of the size of the compliance, at most at a time
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

double machine_gigabytes()
{
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE)) /
         gigabyte;
}

ModelSize model_size(const MeshOptions &mesh, const ModelSymmetry &symmetry)
{
  const double core = mesh.core_cells;
  if (symmetry.is_axisymmetric())
  {
    const double faces = std::ceil(core / 2) + mesh.n_rings();
    const double contact_nodes = faces * mesh.degree + 1;
    return {faces * mesh.layers, contact_nodes, 2 * contact_nodes * (mesh.layers * mesh.degree + 1)};
  }
  const double faces = (core * core + 4 * core * mesh.n_rings()) / symmetry.n_copies();
  const double contact_nodes = faces * mesh.degree * mesh.degree;
  return {faces * mesh.layers, contact_nodes, 3 * contact_nodes * (mesh.layers * mesh.degree + 1)};
}

Estimate estimate(const Parameters &parameters, const Body &body, const ModelSymmetry &symmetry)
{
  const BodyUnknowns &unknowns = body.unknowns();
  dealii::SparsityPattern pattern;
  body.make_pattern(pattern);
  const FactorizationCost cost = factorization_cost(pattern, unknowns.n_interior());
  const double rate = measured_flop_rate();
  const double n_contact = 3. * unknowns.contact_surface().nodes.size();
  const double n_entries = pattern.n_nonzero_elements();
  Estimate result{};
  // The program itself; the stiffness and CHOLMOD's copy of it, with their indices; the factor.
  result.gigabytes = 0.15 + (2 * 1.5 * n_entries + cost.entries + dense_matrices * n_contact * n_contact) *
                                bytes_per_number / gigabyte;
  const unsigned int dim = symmetry.is_axisymmetric() ? 2 : 3;
  const double n_cell = dim * std::pow(parameters.mesh.degree + 1, dim);
  const double assembly =
      unknowns.n_cells() * std::pow(parameters.mesh.n_quadrature_points(), dim) * 2 * n_cell * n_cell;
  // Factorizations reach half of the speed of large products; METIS takes about as long again on small
  // models.
  result.set_up_seconds = 0.2 + 4 * assembly / rate + 3 * cost.flops / rate + 2 * cube(n_contact) / rate;
  // Products with half of the compliance in single precision: a hundred and more where the start is far off,
  // two in many steps.
  const double contact = 20 * n_contact * n_contact * bytes_per_number / 4 / memory_bandwidth;
  const double checks = (2 * cost.entries + 3 * n_entries) * bytes_per_number / memory_bandwidth;
  const double n_drawn = drawn_nodes(unknowns.contact_surface(), symmetry);
  const double output =
      1.5e-6 * (unknowns.n_dofs() * fields_written_per_step(parameters.output.volume_interval) +
                9 * n_drawn * fields_written_per_step(parameters.output.contact_interval));
  result.step_seconds = contact + checks + output;
  return result;
}

std::string describe(const Estimate &estimate, const unsigned int n_steps)
{
  std::ostringstream text;
  text << std::setprecision(2) << "memory         about " << estimate.gigabytes << " GB; this machine has "
       << std::round(machine_gigabytes()) << " GB\n"
       << "time           about " << estimate.set_up_seconds + n_steps * estimate.step_seconds
       << " s: set-up " << estimate.set_up_seconds << " s, " << n_steps << " load steps of "
       << estimate.step_seconds << " s (to a factor of 3)";
  return text.str();
}

std::string describe(const ModelSize &size)
{
  const double n_contact = 3 * size.contact_nodes;
  std::ostringstream text;
  text << std::setprecision(2) << "mesh           about " << size.cells << " cells\n"
       << "unknowns       about " << size.dofs << "\n"
       << "contact nodes  about " << size.contact_nodes << "\n"
       << "memory         more than " << dense_matrices * n_contact * n_contact * bytes_per_number / gigabyte
       << " GB; this machine has " << std::round(machine_gigabytes()) << " GB";
  return text.str();
}
} // namespace orthocone
