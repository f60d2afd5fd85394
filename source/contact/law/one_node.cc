// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/law/one_node.h>

#include <orthocone/base/numbers.h>

#include <boost/math/tools/roots.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace orthocone
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr unsigned int n_directions = 64; // of the grid; pairs of zeros between its points are found, too

/// k_0 + k_1 cos a + k_2 sin a.
struct Harmonic
{
  Vector3d k;
  double at(const Vector2d &e) const { return k[0] + k[1] * e[0] + k[2] * e[1]; }
  double slope(const Vector2d &e) const { return k[2] * e[0] - k[1] * e[1]; }
};

/// Force r = r_n (1, mu_x cos a, mu_y sin a) of a slipping node. d_n = 0 gives r_n = -q_n / D(a) with
/// D(a) = w_nn + w_nx mu_x cos a + w_ny mu_y sin a, and then D d_x = X(a) and D d_y = Y(a) are harmonics as
/// well. By the slip rule d_t is antiparallel to (alpha cos a, beta sin a), alpha = mu_x/p_x^2, beta =
/// mu_y/p_y^2.
class SlipEquation
{
public:
  SlipEquation(const OneNodeProblem &problem, const Vector3d &q)
      : law_(problem.law),
        q_n_(q[0])
  {
    const Vector3d ellipse(1, law_.mu_x, law_.mu_y);
    const Eigen::Matrix3d scaled = problem.compliance * ellipse.asDiagonal();
    normal_.k = scaled.row(0);
    x_.k = q[1] * normal_.k - q_n_ * scaled.row(1).transpose();
    y_.k = q[2] * normal_.k - q_n_ * scaled.row(2).transpose();
    alpha_ = law_.mu_x / (law_.p_x * law_.p_x);
    beta_ = law_.mu_y / (law_.p_y * law_.p_y);
  }

  /// Component of D d_t across the slip direction; zero at a solution.
  double value(const Vector2d &e) const { return beta_ * e[1] * x_.at(e) - alpha_ * e[0] * y_.at(e); }

  double slope(const Vector2d &e) const
  {
    return beta_ * (e[0] * x_.at(e) + e[1] * x_.slope(e)) + alpha_ * (e[1] * y_.at(e) - e[0] * y_.slope(e));
  }

  /// Slip opposes the force, and the force presses.
  bool is_admissible(const Vector2d &e) const
  {
    return normal_.at(e) > 0 && alpha_ * e[0] * x_.at(e) + beta_ * e[1] * y_.at(e) <= 0;
  }

  Vector3d force(const Vector2d &e) const
  {
    const double r_n = -q_n_ / normal_.at(e);
    return r_n * Vector3d(1, law_.mu_x * e[0], law_.mu_y * e[1]);
  }

private:
  const OrthotropicFriction &law_;
  double q_n_;
  Harmonic normal_, x_, y_;
  double alpha_, beta_;
};

Vector2d at_angle(const double angle)
{
  return {std::cos(angle), std::sin(angle)};
}

/// Newton's method from a good start. Returns nothing if it does not converge to an admissible angle.
std::optional<Vector2d> root_near(const SlipEquation &equation, double angle)
{
  constexpr unsigned int most_steps = 8;
  constexpr double largest_step = 0.3; // rad; farther than that the start was not good
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    const Vector2d e = at_angle(angle);
    const double change = equation.value(e) / equation.slope(e);
    if (!(std::abs(change) < largest_step))
      return std::nullopt;
    angle -= change;
    if (std::abs(change) < 1e-12)
    {
      const Vector2d root = at_angle(angle);
      return equation.is_admissible(root) ? std::optional<Vector2d>(root) : std::nullopt;
    }
  }
  return std::nullopt;
}

/// Zero of `function`, to the last bit, between two angles at which its signs differ.
template<typename Function>
double bisect(const Function &function, const double left, const double right)
{
  const auto at = [&](const double angle) { return function(at_angle(angle)) > 0 ? 1. : -1.; };
  const auto settled = [](const double a, const double b)
  { return !(a < 0.5 * (a + b) && 0.5 * (a + b) < b); };
  const auto [lower, upper] = boost::math::tools::bisect(at, left, right, settled);
  return 0.5 * (lower + upper);
}

/// All zeros on the circle. Every sign change counts, and so do pairs that hide between two grid points (the
/// extremum between them shows them): for p_x/p_y far from mu_x/mu_y the admissible arc is far narrower than
/// any grid.
class SlipRoots
{
public:
  explicit SlipRoots(const SlipEquation &equation)
      : equation_(equation)
  {
    static const std::array<Vector2d, n_directions + 1> grid = make_grid();
    for (unsigned int i = 0; i < n_directions; ++i)
      search_cell(i, grid[i], grid[i + 1]);
  }

  /// The admissible root nearest to `guess`, or nothing.
  std::optional<Vector2d> nearest_to(const double guess) const
  {
    std::optional<Vector2d> best;
    double least = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < n_roots_; ++i)
    {
      const double distance = std::abs(std::remainder(roots_[i] - guess, 2 * pi));
      if (distance < least && equation_.is_admissible(at_angle(roots_[i])))
      {
        least = distance;
        best = at_angle(roots_[i]);
      }
    }
    return best;
  }

private:
  static double grid_angle(const unsigned int i) { return 2 * pi * i / n_directions; }

  static std::array<Vector2d, n_directions + 1> make_grid()
  {
    std::array<Vector2d, n_directions + 1> grid;
    for (unsigned int i = 0; i <= n_directions; ++i)
      grid[i] = at_angle(grid_angle(i));
    return grid;
  }

  void search_cell(const unsigned int i, const Vector2d &left, const Vector2d &right)
  {
    const auto value = [this](const Vector2d &e) { return equation_.value(e); };
    const auto slope = [this](const Vector2d &e) { return equation_.slope(e); };
    const bool is_positive = value(left) > 0;
    if ((value(right) > 0) != is_positive)
      add(bisect(value, grid_angle(i), grid_angle(i + 1)));
    else if ((slope(left) > 0) != (slope(right) > 0))
    {
      const double extremum = bisect(slope, grid_angle(i), grid_angle(i + 1));
      if ((value(at_angle(extremum)) > 0) == is_positive)
        return;
      add(bisect(value, grid_angle(i), extremum));
      add(bisect(value, extremum, grid_angle(i + 1)));
    }
  }

  void add(const double root)
  {
    if (n_roots_ < roots_.size())
      roots_[n_roots_++] = root;
  }

  const SlipEquation &equation_;
  std::array<double, 8> roots_{}; // a trigonometric polynomial of degree 2 has at most 4
  unsigned int n_roots_ = 0;
};

/// Damped prediction-correction on the natural map, for the degenerate case without any admissible slip
/// angle: w_nn is too small against the coupling times mu, and the node wedges.
Vector3d iterate_natural_map(const OneNodeProblem &problem, const Vector3d &q, Vector3d r)
{
  constexpr unsigned int n_steps = 100;
  const double rho = 0.5 / problem.compliance.diagonal().maxCoeff();
  for (unsigned int step = 0; step < n_steps; ++step)
    r = project(problem.law, r - rho * modified_displacement(problem.law, q + problem.compliance * r));
  return r;
}
} // namespace

Vector3d solve_one_node(const OneNodeProblem &problem, const Vector3d &q, const Vector3d &guess)
{
  if (q[0] >= 0)
    return Vector3d::Zero();
  if (is_frictionless(problem.law))
    return {-q[0] / problem.compliance(0, 0), 0, 0};
  Vector3d stuck = -problem.stiffness * q;
  if (cone_zone(problem.law, stuck) == ConeZone::inside)
    return stuck;
  const SlipEquation equation(problem, q);
  const Vector3d &near = guess[0] > 0 ? guess : stuck;
  const double angle = std::atan2(near[2] / problem.law.mu_y, near[1] / problem.law.mu_x);
  if (const auto root = root_near(equation, angle))
    return equation.force(*root);
  if (const auto root = SlipRoots(equation).nearest_to(angle))
    return equation.force(*root);
  return iterate_natural_map(problem, q, guess);
}
} // namespace orthocone
