// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "scene.h"

#include <orthocone/body/node_compliance.h>
#include <orthocone/march/wear.h>
#include <orthocone/results/cycles.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace orthocone::studies
{
namespace
{
using Eigen::VectorXd;

/// Jumps cycles as WearJumps does, a settling one and one with the rate apart, but always as many: nothing
/// makes jumps shorter where the rate changes.
class FixedJumps : public MarchObserver
{
public:
  FixedJumps(const Scene &scene, const unsigned int length)
      : length_(length),
        n_cycles_(scene.parameters().load.cycles),
        areas_(scene.symmetry().n_copies() * scene.pressed_areas()),
        opening_(node_compliance(scene.surface(), scene.symmetry(), scene.contact_material()))
  {
    for (const Leg &leg : scene.parameters().load.legs)
      n_steps_ += leg.steps;
  }

  bool accepts(const MarchedStep &marched) override
  {
    step_ = marched.step;
    if (step_.cycle > 0 && step_.phase == 0)
      start_ = marched.before;
    return true;
  }

  void accepted(ContactState &state) override
  {
    if (step_.cycle == 0 || step_.phase + 1 < n_steps_)
      return;
    ++n_computed;
    completed_ = step_.cycle;
    if (++n_settled_ >= 2 && length_ > 0 && completed_ + 1 < n_cycles_)
      jump_on(state, state.wear_depth - start_.wear_depth, std::min(length_, n_cycles_ - completed_ - 1));
  }

  double volume(const ContactState &state) const { return areas_.dot(state.wear_depth); }

  unsigned int n_computed = 0, n_jumps = 0;
  double change = 0;     ///< of the rate from one jump to the next, as a share of what is worn: mean of all
  double depth = 0;      ///< of a jump, mm: largest
  double flattening = 0; ///< depth of a jump / what pressure flattens the fastest node by: mean of all

private:
  void jump_on(ContactState &state, const VectorXd &rate, const unsigned int n)
  {
    if (n_jumps++ > 0)
      change +=
          (areas_.dot((rate - last_rate_).cwiseAbs()) / areas_.dot(rate.cwiseMax(last_rate_)) - change) /
          (n_jumps - 1);
    Eigen::Index fastest = 0;
    depth = std::max(depth, n * rate.maxCoeff(&fastest));
    const double flat = opening_[fastest] * state.force[3 * fastest];
    flattening += ((flat > 0 ? n * rate[fastest] / flat : 0) - flattening) / n_jumps;
    last_rate_ = rate;
    n_settled_ = 0;
    jump(state, start_, n, n_steps_);
  }

  const unsigned int length_, n_cycles_; ///< in cycles
  const VectorXd areas_, opening_;
  unsigned int n_steps_ = 0, n_settled_ = 0, completed_ = 0;
  LoadStep step_{};
  ContactState start_{0};
  VectorXd last_rate_{};
};

/// Distance from the origin (mm) and depth (nm) of all nodes, as words of one cell of the table.
std::string profile(const ContactSurface &surface, const VectorXd &depth)
{
  std::ostringstream text;
  text << std::setprecision(5);
  for (std::size_t i = 0; i < surface.nodes.size(); ++i)
    text << std::hypot(surface.nodes[i].position[0], surface.nodes[i].position[1]) << ":"
         << 1e6 * depth[static_cast<Eigen::Index>(i)] << " ";
  return text.str();
}
} // namespace

void fixed_jumps(const Words &words)
{
  const SceneWords given(words);
  const Scene scene(given.parameters, choose_model(given.parameters));
  FixedJumps jumps(scene, static_cast<unsigned int>(given.number("cycles", 0)));
  StepSolver solver(scene);
  ContactState state(scene.gaps());
  if (march(scene.program().steps(), solver, state, jumps) != MarchEnd::done)
    throw std::runtime_error("a step is not solved");
  std::cout << "computed,jumps,worn_volume,largest_depth,depth_of_jump,change,flattening,profile\n"
            << jumps.n_computed << "," << jumps.n_jumps << "," << jumps.volume(state) << ","
            << state.wear_depth.maxCoeff() << "," << jumps.depth << "," << jumps.change << ","
            << jumps.flattening << "," << profile(scene.surface(), state.wear_depth) << "\n";
}
} // namespace orthocone::studies
