// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/contact/law/one_node.h>

#include <orthocone/base/numbers.h>
#include <orthocone/contact/law/natural_map.h>

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

/// Force r = r_n (1, f(e)) of a slipping node with f = r_t(e), whose reduced force has the direction e. d_n =
/// 0 gives r_n = -q_n / D(e) with D = w_nn + w_nt.f, and then D d_t = X(e) = D q_t - q_n (w_tn + W_tt f). By
/// the slip rule d_t has a g that is opposite to e. For ellipses all of these are harmonics of the angle.
/// docs/theory.md, section 3.
class SlipEquation
{
public:
  SlipEquation(const FrictionLaw &law, const Eigen::Matrix3d &compliance, const Vector3d &q)
      : law_(law),
        w_(compliance),
        q_(q)
  {
  }

  /// Component of D d_t across the slip direction; zero at a solution.
  double value(const Vector2d &e) const { return cross(way(law_.force(e)), against(e)); }

  /// d value / d angle, with e' across e.
  double slope(const Vector2d &e) const
  {
    const Vector2d across(-e[1], e[0]);
    const Vector2d force = law_.force(e);
    const Vector2d turned = law_.force_derivative(force) * across;
    const Vector2d way_slope = coupling().dot(turned) * q_.tail<2>() - q_[0] * (tangential() * turned);
    const Vector2d slip_slope = law_.reduced_slip_derivative(-against(e)).inverse() * across;
    return cross(way_slope, against(e)) + cross(way(force), slip_slope);
  }

  /// Slip opposes the force, and the force presses.
  bool is_admissible(const Vector2d &e) const
  {
    return normal(law_.force(e)) > 0 && way(law_.force(e)).dot(against(e)) <= 0;
  }

  Vector3d force(const Vector2d &e) const
  {
    const Vector2d f = law_.force(e);
    return -q_[0] / normal(f) * Vector3d(1, f[0], f[1]);
  }

private:
  static double cross(const Vector2d &a, const Vector2d &b) { return a[0] * b[1] - a[1] * b[0]; }
  /// Against the slip whose g is -e. Laws without a centre of symmetry have another one for g = e.
  Vector2d against(const Vector2d &e) const { return -law_.slip(-e); }
  Vector2d coupling() const { return w_.row(0).tail<2>(); }
  Eigen::Matrix2d tangential() const { return w_.bottomRightCorner<2, 2>(); }
  double normal(const Vector2d &f) const { return w_(0, 0) + coupling().dot(f); }
  Vector2d way(const Vector2d &f) const
  {
    return normal(f) * q_.tail<2>() - q_[0] * (w_.col(0).tail<2>() + tangential() * f);
  }

  const FrictionLaw &law_;
  const Eigen::Matrix3d &w_;
  const Vector3d &q_;
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
  std::array<double, 16> roots_{}; // ellipses have at most 4: a trigonometric polynomial of degree 2
  unsigned int n_roots_ = 0;
};

/// Damped iteration of the natural map, for the degenerate case without any admissible slip angle: w_nn is
/// too small against the coupling times mu, and the node wedges.
Vector3d iterate_natural_map(const FrictionLaw &law, const OneNodeProblem &problem, const Vector3d &q,
                             Vector3d r)
{
  constexpr unsigned int n_steps = 100;
  const double rho = 0.5 / problem.compliance.diagonal().maxCoeff();
  for (unsigned int step = 0; step < n_steps; ++step)
    r = TrialForce(law, rho, r, q + problem.compliance * r).admitted(law);
  return r;
}
} // namespace

Vector3d solve_one_node(const FrictionLaw &law, const OneNodeProblem &problem, const Vector3d &q,
                        const Vector3d &guess)
{
  if (q[0] >= 0)
    return Vector3d::Zero();
  if (law.is_frictionless())
    return {-q[0] / problem.compliance(0, 0), 0, 0};
  const Vector3d stuck = -problem.stiffness * q;
  if (stuck[0] > 0 && law.load(stuck.tail<2>()) <= stuck[0])
    return stuck;
  const SlipEquation equation(law, problem.compliance, q);
  const Vector2d near = law.reduced_force((guess[0] > 0 ? guess : stuck).tail<2>());
  const double angle = std::atan2(near[1], near[0]);
  if (const auto root = root_near(equation, angle))
    return equation.force(*root);
  if (const auto root = SlipRoots(equation).nearest_to(angle))
    return equation.force(*root);
  return iterate_natural_map(law, problem, q, guess);
}
} // namespace orthocone
