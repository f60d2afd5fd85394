// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The law of one node: projection and exact solution. Times are those of one call, on points that differ from
// call to call.
#include <orthocone/contact/law/natural_map.h>
#include <orthocone/contact/law/one_node.h>

#include <benchmark/benchmark.h>

#include <array>
#include <random>

namespace
{
using namespace orthocone;
using Eigen::Vector3d;

constexpr std::size_t n_points = 1024;
using Points = std::array<Vector3d, n_points>;

const OrthotropicFriction law{0.3, 0.15, 0.05, 0.2}; // the paper's case C
const FrictionLaw friction = law;

/// Points next to which the surface of the cone runs; about a half lies inside, and some in the polar cone.
Points points_about_the_cone()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> normal(-0.1, 1), tangential(-0.4, 0.4);
  Points points;
  for (Vector3d &point : points)
    point = {normal(random), tangential(random), 0.5 * tangential(random)};
  return points;
}

Points points_outside()
{
  Points points = points_about_the_cone();
  for (Vector3d &point : points)
    while (friction_norm(law, point[1], point[2]) <= point[0] ||
           dual_norm(law, point[1], point[2]) + point[0] <= 0)
      point += Vector3d(0.01, 0.1, 0.05);
  return points;
}

OneNodeProblem node_problem()
{
  OneNodeProblem node{{}, {}};
  node.compliance << 1, 0.1, -0.05, 0.1, 1.3, 0.1, -0.05, 0.1, 1.2;
  node.stiffness = node.compliance.inverse();
  return node;
}

/// Displacements that press the node and make it slip.
Points slipping_displacements(const OneNodeProblem &node)
{
  Points displacements = points_outside();
  for (Vector3d &q : displacements)
  {
    q = {-std::abs(q[0]) - 0.1, q[1], q[2]};
    const auto sticks = [&](const Vector3d &r) { return friction_norm(law, r[1], r[2]) <= r[0]; };
    while (sticks(-node.stiffness * q))
      q.tail<2>() *= 2;
  }
  return displacements;
}

void projection(benchmark::State &state, const Points &points)
{
  std::size_t i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(project(law, points[i++ % n_points]));
}
BENCHMARK_CAPTURE(projection, mixed, points_about_the_cone());
BENCHMARK_CAPTURE(projection, slip, points_outside());

void trial_force(benchmark::State &state, const Points &points)
{
  std::size_t i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        TrialForce(friction, 1, points[i++ % n_points], Vector3d::Zero()).admitted(friction));
}
BENCHMARK_CAPTURE(trial_force, slip, points_outside());

/// `knows_answer`: the guess is the solution, as at the end of the sweeps; otherwise there is none.
void one_node(benchmark::State &state, const bool knows_answer)
{
  const OneNodeProblem node = node_problem();
  const Points displacements = slipping_displacements(node);
  Points guesses;
  for (std::size_t i = 0; i < n_points; ++i)
    guesses[i] =
        knows_answer ? solve_one_node(friction, node, displacements[i], Vector3d::Zero()) : Vector3d::Zero();
  std::size_t i = 0;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(
        solve_one_node(friction, node, displacements[i % n_points], guesses[i % n_points]));
    ++i;
  }
}
BENCHMARK_CAPTURE(one_node, slip_guessed, true);
BENCHMARK_CAPTURE(one_node, slip_unguessed, false);
} // namespace
