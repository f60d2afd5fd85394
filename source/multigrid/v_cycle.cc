// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "v_cycle.h"

#include "node_values.h"

#include <orthocone/base/ranks.h>
#include <orthocone/base/stop_point.h>
#include <orthocone/body/materials/lame.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/numerics/rtree.h>

#include <mpi.h>

#include <cstdlib>
#include <utility>

namespace orthocone
{
namespace
{
/// Options of a mesh that exists already, with another degree than the finest one's.
MeshOptions with_degree(MeshOptions mesh, const unsigned int degree)
{
  mesh.degree = degree;
  mesh.quadrature_points = 0;
  mesh.volumetric_quadrature = VolumetricQuadrature::automatic;
  return mesh;
}

/// What a cycle takes the body for. Smoothers do not see volumes that hardly change, but where the divergence
/// is projected, a body that resists them less is nearly as good: the pressures that it errs by are close
/// together, so that the iterations around the cycle find them at once (docs/theory.md, section 3).
MaterialOptions smoothed(const Discretization &space, const MaterialOptions &material)
{
  constexpr double most = 5; // lambda / mu
  const LameParameters lame(material);
  if (space.volumetric_quadrature() == VolumetricQuadrature::full || lame.lambda <= most * lame.mu)
    return material;
  MaterialOptions softer = material;
  softer.poisson_ratio = most / (2 * (1 + most));
  softer.young_modulus = 2 * lame.mu * (1 + softer.poisson_ratio);
  return softer;
}

/// For every node of `coarse` the nearest one of `fine`.
std::vector<std::size_t> nearest_nodes(const std::vector<ContactNode> &coarse,
                                       const std::vector<ContactNode> &fine)
{
  using Entry = std::pair<dealii::Point<3>, std::size_t>;
  const auto place = [](const ContactNode &node)
  { return dealii::Point<3>(node.position[0], node.position[1], node.height); };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < fine.size(); ++i)
    entries.emplace_back(place(fine[i]), i);
  const auto tree = dealii::pack_rtree(entries);
  std::vector<std::size_t> nearest;
  for (const ContactNode &node : coarse)
    nearest.push_back(tree.qbegin(boost::geometry::index::nearest(place(node), 1))->second);
  return nearest;
}

dealii::AffineConstraints<float> constraints_of(const Discretization &space)
{
  dealii::AffineConstraints<float> constraints;
  constraints.copy_from(space.constraints());
  return constraints;
}

/// deal.II's transfer between meshes asks MPI for the owners, even if there is one process.
void start_mpi()
{
  int is_started = 0;
  MPI_Initialized(&is_started);
  if (is_started != 0)
    return;
  // Else Open MPI 4 starts a daemon beside a single process, and first looks for ssh, which a bare system
  // lacks.
  ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  MPI_Init(nullptr, nullptr);
  std::atexit([] { MPI_Finalize(); });
}
} // namespace

struct VCycle::Mesh
{
  Mesh(std::shared_ptr<const dealii::Triangulation<3>> cells, const MeshOptions &options,
       const HeldSurfaces &held)
      : triangulation(std::move(cells)),
        space(*triangulation, options, held)
  {
  }

  std::shared_ptr<const dealii::Triangulation<3>> triangulation;
  Discretization space;
};

// Levels, from the finest one: the mesh as it is; the meshes before its refinements, with the same degree;
// and the coarsest of these with trilinear elements, because an exact solver on it is cheap and its error is
// of the kind that the levels above smooth. space_of(0) is that one.
VCycle::VCycle(const Discretization &space, const MeshOptions &mesh, const GeometryOptions &geometry,
               const MaterialOptions &whole_material, const CoarseMethod on_coarsest)
    : finest_(space)
{
  const MaterialOptions material = smoothed(space, whole_material);
  start_mpi();
  const auto triangulations = dealii::MGTransferGlobalCoarseningTools::create_geometric_coarsening_sequence(
      space.dof_handler().get_triangulation());
  if (mesh.degree > 1)
    meshes_.push_back(
        std::make_unique<Mesh>(triangulations.front(), with_degree(mesh, 1), held_surfaces(geometry)));
  for (std::size_t i = 0; i + 1 < triangulations.size(); ++i)
    meshes_.push_back(std::make_unique<Mesh>(triangulations[i], mesh, held_surfaces(geometry)));
  coarsest_ = space.is_shared() ? make_shared_coarse_solver(space_of(0), mesh, held_surfaces(geometry),
                                                            material, on_coarsest)
                                : make_coarse_solver(space_of(0), material, on_coarsest);
  for (std::size_t level = 1; level <= meshes_.size(); ++level)
    levels_.push_back(std::make_unique<Level>(space_of(level), material));
  for (std::size_t level = 1; level <= meshes_.size(); ++level)
    connect(level);
  for (std::size_t level = 0; level <= meshes_.size(); ++level)
  {
    const Vector vector = level == 0 ? Vector(space_of(0).partitioner()) : levels_[level - 1]->make_vector();
    work_.push_back({vector, vector, vector});
  }
}

VCycle::~VCycle() = default;

const Discretization &VCycle::space_of(const std::size_t level) const
{
  return level == meshes_.size() ? finest_ : meshes_[level]->space;
}

void VCycle::connect(const std::size_t level)
{
  const Discretization &fine = space_of(level), &coarse = space_of(level - 1);
  transfers_.push_back(std::make_unique<Transfer>());
  const auto held_fine = constraints_of(fine), held_coarse = constraints_of(coarse);
  if (fine.scalar_fe().degree != coarse.scalar_fe().degree)
    transfers_.back()->reinit_polynomial_transfer(fine.dof_handler(), coarse.dof_handler(), held_fine,
                                                  held_coarse);
  else
    transfers_.back()->reinit_geometric_transfer(fine.dof_handler(), coarse.dof_handler(), held_fine,
                                                 held_coarse);
  nearest_.push_back(nearest_nodes(coarse.contact_surface().nodes, fine.contact_surface().nodes));
}

/// The relations of the next coarser level. The resistance of friction is proportional to the area of a node.
std::vector<NodeRelation> VCycle::coarser(const std::size_t level,
                                          const std::vector<NodeRelation> &fine) const
{
  const auto &coarse_nodes = space_of(level).contact_surface().nodes;
  const auto &fine_nodes = space_of(level + 1).contact_surface().nodes;
  std::vector<NodeRelation> relations;
  for (std::size_t i = 0; i < coarse_nodes.size() && !fine.empty(); ++i)
  {
    const std::size_t nearest = nearest_[level][i];
    relations.push_back(fine[nearest]);
    relations.back().robin *= coarse_nodes[i].area / fine_nodes[nearest].area;
  }
  return relations;
}

// A coarser node takes the relation of the nearest finer one as it is. A mean of several would hold a node
// half, which none of them does, and would smear the border between stick and slip over the coarse cells.
void VCycle::hold(const std::vector<NodeRelation> &relations)
{
  std::vector<NodeRelation> held = relations;
  for (std::size_t level = levels_.size(); level > 0; --level)
  {
    levels_[level - 1]->hold(held);
    held = coarser(level - 1, held);
  }
  coarsest_->hold(held);
}

void VCycle::solve_coarsest(Vector &displacement, const Vector &forces) const
{
  const unsigned int n = space_of(0).n_free();
  const Eigen::VectorXd solution = coarsest_->solve(entries(forces, n).cast<double>());
  displacement = 0;
  entries(displacement, n) = solution.cast<float>();
}

/// One V-cycle for K u = f from u = 0 (Brandt, Math. Comput. 31 (1977) 333-390), with the smoother S of a
/// level, the interpolation P from the level below and its transpose as the restriction:
///   u <- S(0, f);   r = f - K u;   u <- u + P solve_coarser(P^T r);   u <- S(u, f).
/// The same smoother before and behind the correction makes the cycle symmetric without contact, as conjugate
/// gradients need it. With the relations of contact it is not symmetric, and GMRES is around it.
/// Held directions are cleared where a vector has come from another level: there they belong to nodes that
/// hold something else.
void VCycle::solve(const std::size_t level, Vector &displacement, const Vector &forces) const
{
  if (level == 0)
    return solve_coarsest(displacement, forces);
  const Level &fine = *levels_[level - 1];
  Vector &residual = work_[level].residual;
  Vector &coarse_forces = work_[level - 1].forces, &coarse_displacement = work_[level - 1].displacement;
  fine.smooth_from_zero(displacement, forces);
  fine.vmult(residual, displacement);
  residual.sadd(-1, 1, forces);
  coarse_forces = 0;
  transfers_[level - 1]->restrict_and_add(coarse_forces, residual);
  if (level > 1)
    levels_[level - 2]->clear_held(coarse_forces);
  solve(level - 1, coarse_displacement, coarse_forces);
  residual = 0;
  transfers_[level - 1]->prolongate_and_add(residual, coarse_displacement);
  fine.clear_held(residual);
  displacement += residual;
  fine.smooth(displacement, forces);
}

// Scaled to the largest entry, since displacements in mm may be too small for single precision.
Eigen::VectorXd VCycle::prolonged(const Eigen::VectorXd &coarser) const
{
  Vector &coarse = work_[levels_.size() - 1].displacement, &fine = work_.back().residual;
  const double size = largest_of_ranks(coarser.lpNorm<Eigen::Infinity>());
  Eigen::VectorXd result = Eigen::VectorXd::Zero(finest_.n_free());
  if (size == 0)
    return result;
  AssertThrow(coarser.size() == space_of(levels_.size() - 1).n_free(), dealii::ExcInternalError());
  coarse = 0;
  fine = 0;
  entries(coarse, coarser.size()) = (coarser / size).cast<float>();
  transfers_.back()->prolongate_and_add(fine, coarse);
  result = size * entries(fine, result.size()).cast<double>();
  return result;
}

/// The cycle is in units of the forces, because single precision has a small range.
void VCycle::vmult(BodyVector<double> &displacement, const BodyVector<double> &forces) const
{
  stop_point();
  ++n_cycles_;
  const double size = forces.l2_norm();
  displacement = 0;
  if (size == 0)
    return;
  Workspace &work = work_.back();
  entries(work.forces, finest_.n_owned()) = (entries(forces, finest_.n_owned()) / size).cast<float>();
  solve(levels_.size(), work.displacement, work.forces);
  entries(displacement, finest_.n_free()) =
      size * entries(work.displacement, finest_.n_free()).cast<double>();
}
} // namespace orthocone
