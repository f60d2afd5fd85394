// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scene.h"

#include <orthocone/base/stopwatch.h>
#include <orthocone/base/text.h>
#include <orthocone/scene/options.h>

#include <iostream>
#include <stdexcept>

namespace orthocone::studies
{
namespace
{
/// The compliance without condensation: every product is a solution with the factorized stiffness.
class BodyCompliance : public Compliance
{
public:
  BodyCompliance(const Scene &model, const LocalAxes &axes)
      : model_(model),
        axes_(axes)
  {
  }

  Eigen::Index n_nodes() const override { return model_.system().n_nodes(); }

  void vmult(NodeVector &displacement, const NodeVector &force) const override
  {
    const Eigen::VectorXd volume = model_.body().elastic_displacement(force);
    displacement.resize(force.size());
    for (Eigen::Index node = 0; node < n_nodes(); ++node)
    {
      const ContactNode &place = model_.surface().nodes[node];
      Eigen::Vector3d global = Eigen::Vector3d::Zero();
      for (Eigen::Index d = 0; d < 3; ++d)
        if (place.is_free[d])
          global[d] = volume[place.dofs[d]];
      displacement.segment<3>(3 * node) = axes_.global_in_local(node).transpose() * global;
    }
  }

  Eigen::Matrix3d diagonal_block(const Eigen::Index node) const override
  {
    return model_.system().compliance().diagonal_block(node);
  }

private:
  const Scene &model_;
  LocalAxes axes_;
};

FrictionLaws laws_of(const ContactSystem &system)
{
  FrictionLaws laws;
  for (Eigen::Index node = 0; node < system.n_nodes(); ++node)
    laws.push_back(system.law(node));
  return laws;
}

void print(const SolverReport &report, const double setup_seconds, const Eigen::Index n_nodes)
{
  std::cout << "contact_nodes,setup_seconds,iterations,seconds,residual,force,verdict\n";
  for (const TracePoint &point : report.trace.points())
    std::cout << n_nodes << "," << setup_seconds << "," << point.iterations << "," << point.seconds << ","
              << point.residual << "," << point.force << "," << to_word(report.verdict) << "\n";
}
} // namespace

void trace(const Words &words)
{
  const SceneWords scene(words);
  const Scene model(scene.parameters, choose_model(scene.parameters));
  ContactSolverOptions options = scene.parameters.contact_solver;
  const auto method = scene.options.find("method");
  if (method != scene.options.end())
    options.method = method->second;
  const March march(model, static_cast<unsigned int>(scene.number("step", 1)));
  const LocalAxes axes(scene.parameters.friction.angle);
  const BodyCompliance body(model, axes);
  const bool is_condensed = scene.number("condensed", 1) != 0;
  const ContactSystem system(is_condensed ? model.system().compliance() : body, laws_of(model.system()));
  const ContactStep problem(
      system, step_displacement(model.body().moved_with(march.next.motion), march.state.displacement));
  double setup_seconds = 0;
  const auto solver = timed(setup_seconds, [&] { return make_contact_solver(system, options); });
  NodeVector force = march.state.force; // the same start for all methods
  print(solver->solve(problem, force), setup_seconds, problem.n_nodes());
}
} // namespace orthocone::studies
