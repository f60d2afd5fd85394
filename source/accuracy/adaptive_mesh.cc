// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/accuracy/adaptive_mesh.h>

#include <orthocone/accuracy/backend_choice.h>
#include <orthocone/accuracy/cost_model.h>
#include <orthocone/accuracy/first_cycle.h>
#include <orthocone/base/ranks.h>
#include <orthocone/body/fe/stress_jumps.h>
#include <orthocone/body/shapes/boundary.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace orthocone
{
namespace
{
using Eigen::VectorXd;

template<int dim>
class WatchOfSpace : public RefinementWatch
{
public:
  WatchOfSpace(const Scene &scene, const DisplacementSpace<dim> &space)
      : scene_(scene),
        space_(space),
        squared_errors_(VectorXd::Zero(space_.dof_handler().get_triangulation().n_active_cells())),
        is_on_border_(squared_errors_.size(), false)
  {
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      is_on_border_[cell->active_cell_index()] =
          cell->is_locally_owned() && is_at_contact(cell) &&
          (is_at(cell, Boundary::lateral_surface) || is_at_support(cell));
  }

  bool accepts(const MarchedStep &solved) override
  {
    ends_leg_ = solved.step.share == 1;
    return true;
  }

  void accepted(ContactState &state) override
  {
    if (!ends_leg_)
      return;
    const VectorXd elastic = scene_.body().elastic_displacement(state.force);
    squared_errors_ +=
        squared_jumps(space_, scene_.body().with_motion(strain_of(state.motion), elastic, state.loads));
    for (std::size_t face = 0; face < space_.contact_cells().size(); ++face)
      if (space_.contact_cells()[face] < is_on_border_.size() && // in this process
          is_mixed(space_.contact_surface().faces[face], state.status))
        is_on_border_[space_.contact_cells()[face]] = true;
  }

  std::vector<CellRange> cells_to_halve() const override
  {
    constexpr double share = 0.5; // of the squared error: docs/accuracy.md, "Cells halved"
    const auto [errors, border] = of_all_cells();
    std::vector<bool> is_marked(errors.size());
    for (std::size_t i = 0; i < is_marked.size(); ++i)
      is_marked[i] = border[i] > 0;
    std::vector<unsigned int> order(errors.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&errors = errors](const unsigned int a, const unsigned int b)
                     { return errors[a] > errors[b]; });
    double rest = share * errors.sum();
    for (std::size_t i = 0; i < order.size() && rest > 0; ++i)
    {
      is_marked[order[i]] = true;
      rest -= errors[order[i]];
    }
    return ranges_of(is_marked);
  }

private:
  static std::vector<CellRange> ranges_of(const std::vector<bool> &is_marked)
  {
    std::vector<CellRange> ranges;
    for (unsigned int i = 0; i < is_marked.size(); ++i)
      if (is_marked[i] && (i == 0 || !is_marked[i - 1]))
        ranges.push_back({i, i});
      else if (is_marked[i])
        ranges.back().last = i;
    return ranges;
  }

  /// For all cells, by their numbers in Mesh/Refined cells: the squared errors, and 1 on the border. The same
  /// on all ranks.
  std::pair<VectorXd, VectorXd> of_all_cells() const
  {
    VectorXd errors = VectorXd::Zero(space_.size().cells), border = errors;
    const std::vector<unsigned int> numbers = scene_.body().mesh().cell_numbers();
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (numbers[i] < errors.size())
      {
        errors[numbers[i]] = squared_errors_[i];
        border[numbers[i]] = is_on_border_[i];
      }
    sum_over_ranks(errors.data(), errors.size());
    sum_over_ranks(border.data(), border.size());
    return {errors, border};
  }

  static bool is_at(const typename DisplacementSpace<dim>::Cell &cell, const Boundary boundary)
  {
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() == boundary)
        return true;
    return false;
  }

  static bool is_at_contact(const typename DisplacementSpace<dim>::Cell &cell)
  {
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary() && is_contact(cell->face(face)->boundary_id()))
        return true;
    return false;
  }

  /// A motion as far as it strains the body: a rigid one would only cost digits.
  RigidMotion strain_of(const RigidMotion &motion) const
  {
    return scene_.body().driven() != nullptr ? motion : RigidMotion();
  }

  static bool is_at_support(const typename DisplacementSpace<dim>::Cell &cell)
  {
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() >= Boundary::first_support)
        return true;
    return false;
  }

  /// Whether the nodes of a face differ in status. Hanging nodes do not count, because they are between
  /// others.
  static bool is_mixed(const std::vector<unsigned int> &places, const std::vector<NodeStatus> &status)
  {
    std::optional<NodeStatus> first;
    for (const unsigned int place : places)
      if (place < status.size())
      {
        if (first && *first != status[place])
          return true;
        first = status[place];
      }
    return false;
  }

  const Scene &scene_;
  const DisplacementSpace<dim> &space_;
  VectorXd squared_errors_; ///< by active cells; zero in cells of other processes
  std::vector<bool> is_on_border_;
  bool ends_leg_ = false;
};

std::string size_of(const Scene &scene)
{
  return std::to_string(scene.body().unknowns().size().cells) + " cells, " +
         std::to_string(scene.surface().nodes.size()) + " contact nodes: ";
}
} // namespace

std::unique_ptr<RefinementWatch> RefinementWatch::of(const Scene &scene)
{
  return scene.body().mesh().visit(
      [&](const auto &space) -> std::unique_ptr<RefinementWatch>
      { return std::make_unique<WatchOfSpace<std::decay_t<decltype(space)>::dimension>>(scene, space); });
}

MeshOptions adapted_mesh(const Parameters &parameters, const ModelChoice &choice, const Reporter &report,
                         const double gigabytes)
{
  Parameters adapted = parameters;
  adapted.mesh.adaptive = 0;
  const auto with_backend = [&](Parameters of)
  {
    of.mesh.backend = choose_backend(of, choice.symmetry, gigabytes).backend;
    return of;
  };
  for (unsigned int round = 1; round <= parameters.mesh.adaptive; ++round)
  {
    const Scene scene(with_backend(adapted), choice);
    Parameters finer = adapted;
    const auto watch = RefinementWatch::of(scene);
    StepSolver solver(scene);
    march_first_cycle(scene, parameters.load, solver, "Mesh/Adaptive", *watch);
    finer.mesh.refined_cells.push_back(watch->cells_to_halve());
    const std::string line = "adaptive       round " + std::to_string(round) + ", " + size_of(scene);
    if (is_too_large(with_backend(finer), choice.symmetry, gigabytes))
    {
      report(line + "the next mesh would need more memory than this machine has");
      break;
    }
    report(line + std::to_string(Body(finer, choice.symmetry).unknowns().size().cells) + " cells follow");
    adapted = finer;
  }
  return adapted.mesh;
}
} // namespace orthocone
