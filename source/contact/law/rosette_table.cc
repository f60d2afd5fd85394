// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "rosette_table.h"

#include <orthocone/base/numbers.h>
#include <orthocone/base/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace orthocone
{
using Eigen::Vector2d;

namespace
{
double cot(const double angle)
{
  return std::cos(angle) / std::sin(angle);
}

/// From 0 to 2 pi.
double in_turn(const double angle)
{
  return angle - 2 * pi * std::floor(angle / (2 * pi));
}

/// With digits that a reader can use.
std::string degrees(const double radians)
{
  return to_text(std::round(1e3 * radians / radians_per_degree) / 1e3) + " degrees";
}

/// Sorted by angles from 0 to 2 pi.
std::vector<Rosette::Row> in_order(std::vector<Rosette::Row> rows)
{
  constexpr double same = Rosette::same_angle;
  if (rows.size() < Rosette::least_rows)
    throw std::invalid_argument("has " + std::to_string(rows.size()) + " rows: allowed are " +
                                std::to_string(Rosette::least_rows) + " and more");
  for (Rosette::Row &row : rows)
    row.angle = in_turn(row.angle);
  std::sort(rows.begin(), rows.end(),
            [](const Rosette::Row &a, const Rosette::Row &b) { return a.angle < b.angle; });
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const bool is_last = i + 1 == rows.size();
    const double next = is_last ? rows.front().angle + 2 * pi : rows[i + 1].angle;
    if (next - rows[i].angle < same)
      throw std::invalid_argument("has the angle " + degrees(rows[i].angle) +
                                  " twice: allowed is a row for each angle, where 0 and 360 are the same");
    if (next - rows[i].angle > pi / 2 + same)
      throw std::invalid_argument("has no angle between " + degrees(rows[i].angle) + " and " + degrees(next) +
                                  ": allowed are steps up to 90 degrees all around");
  }
  return rows;
}

[[noreturn]] void refuse(const std::string &name, const double value, const std::string &place,
                         const std::string &because)
{
  throw std::invalid_argument(name + " is " + to_text(value) + " " + place +
                              ": allowed is a number > 0 at every angle, because " + because);
}

const std::string forces_oppose = "friction opposes slip", forces_turn = "a force has one direction of slip",
                  pushes_slip = "one push on a node has one slip";

/// Slopes of the law at a row: d b/da, and half the derivative of G^2 by b. Better ones come first.
struct Slopes
{
  double turning, size;
};

/// Joins a table. Rows are counted around.
class Joiner
{
public:
  explicit Joiner(const std::vector<Rosette::Row> &rows);
  RosetteTable join();

private:
  static constexpr std::size_t n_candidates = 3;

  std::size_t next(const std::size_t i, const std::size_t by = 1) const { return (i + by) % n_; }
  std::size_t before(const std::size_t i, const std::size_t by = 1) const { return (i + n_ - by) % n_; }
  Slopes slopes_within(std::size_t i, std::size_t reach) const;
  Slopes slopes_of_five(std::size_t i, const Slopes &of_three) const;
  double size_slope_of_chords(std::size_t i) const;
  RosetteSector sector(std::size_t i) const;
  void improve(std::size_t i);

  std::size_t n_;
  std::vector<double> slip_angles_, force_angles_, squares_; ///< a, b and G^2 = 1/|f|^2 of the rows
  std::vector<double> slip_steps_, force_steps_;             ///< from each row to the next one
  std::vector<std::array<Slopes, n_candidates>> candidates_;
  std::vector<std::size_t> taken_;
  std::vector<double> tensions_;
};

Joiner::Joiner(const std::vector<Rosette::Row> &rows)
    : n_(rows.size()),
      taken_(n_, 0),
      tensions_(n_, 0)
{
  for (const Rosette::Row &row : rows)
  {
    if (!(row.along > 0))
      refuse("mu_along", row.along, "at " + degrees(row.angle), forces_oppose);
    slip_angles_.push_back(row.angle);
    force_angles_.push_back(row.angle + std::atan2(row.across, row.along));
    squares_.push_back(1 / (row.along * row.along + row.across * row.across));
  }
  constexpr double most = 179 * radians_per_degree; // beyond, two directions say little of what is between
  for (std::size_t i = 0; i < n_; ++i)
  {
    const double turn = i + 1 == n_ ? 2 * pi : 0;
    slip_steps_.push_back(turn + slip_angles_[next(i)] - slip_angles_[i]);
    force_steps_.push_back(turn + force_angles_[next(i)] - force_angles_[i]);
    const std::string place =
        "between " + degrees(slip_angles_[i]) + " and " + degrees(slip_angles_[next(i)]);
    if (!(force_steps_[i] > 0))
      refuse("the turn of the force, d b/da,", force_steps_[i] / slip_steps_[i], place, forces_turn);
    if (force_steps_[i] > most)
      throw std::invalid_argument("the force turns by " + degrees(force_steps_[i]) + " " + place +
                                  ": allowed are 179 degrees, and a remedy is a row between them");
  }
  for (std::size_t i = 0; i < n_; ++i)
  {
    const Slopes of_three = slopes_within(i, 1);
    candidates_.push_back(
        {slopes_of_five(i, of_three), of_three, {of_three.turning, size_slope_of_chords(i)}});
  }
}

/// Of the map of directions and the curve of two ellipses through a row and those `reach` before and behind
/// it: with the steps h and h' of a and k and k' of b, d b/da = (cot h + cot h')/(cot k + cot k'), and with
/// the square of the gauge as a quadratic form, half its derivative is (g'/sin^2 k' - g/sin^2 k - g_0 (cot^2
/// k'
/// - cot^2 k))/(2 (cot k + cot k')). Wider than half a turn there is no such map: NaN.
Slopes Joiner::slopes_within(const std::size_t i, const std::size_t reach) const
{
  double h = 0, h_next = 0, k = 0, k_next = 0;
  for (std::size_t by = 0; by < reach; ++by)
  {
    h += slip_steps_[before(i, by + 1)];
    k += force_steps_[before(i, by + 1)];
    h_next += slip_steps_[next(i, by)];
    k_next += force_steps_[next(i, by)];
  }
  constexpr double widest = 0.999 * pi;
  if (std::max(h + h_next, k + k_next) > widest)
  {
    const double none = std::numeric_limits<double>::quiet_NaN();
    return reach == 1 ? Slopes{(k / h + k_next / h_next) / 2, size_slope_of_chords(i)} : Slopes{none, none};
  }
  const double sum = cot(k) + cot(k_next);
  const auto over_square = [](const double g, const double angle)
  { return g / (std::sin(angle) * std::sin(angle)); };
  return {(cot(h) + cot(h_next)) / sum,
          (over_square(squares_[next(i, reach)], k_next) - over_square(squares_[before(i, reach)], k) -
           squares_[i] * (cot(k_next) * cot(k_next) - cot(k) * cot(k))) /
              (2 * sum)};
}

/// The error of slopes of three rows is in proportion to the product of the steps on both sides: Richardson's
/// rule takes it away. Where it corrects by much, the rows are too far apart for it.
Slopes Joiner::slopes_of_five(const std::size_t i, const Slopes &of_three) const
{
  constexpr double most = 0.25;
  const Slopes wide = slopes_within(i, 2);
  const auto product = [&](const std::vector<double> &steps) { return steps[before(i)] * steps[i]; };
  const auto wide_product = [&](const std::vector<double> &steps)
  { return (steps[before(i)] + steps[before(i, 2)]) * (steps[i] + steps[next(i)]); };
  const auto weight = [&](const std::vector<double> &steps)
  { return product(steps) / (wide_product(steps) - product(steps)); };
  const double turning = weight(slip_steps_) * std::log(of_three.turning / wide.turning),
               size = weight(force_steps_) * (of_three.size - wide.size);
  if (std::abs(turning) < most && std::abs(size) < most * squares_[i])
    return {of_three.turning * std::exp(turning), of_three.size + size};
  return of_three;
}

/// Of a tangent between the chords to both neighbours. kappa > 0 on the chords makes it positive at the row.
double Joiner::size_slope_of_chords(const std::size_t i) const
{
  const double k = force_steps_[before(i)], k_next = force_steps_[i], g = squares_[i];
  const double ahead = (std::sqrt(g * squares_[next(i)]) - g * std::cos(k_next)) / std::sin(k_next),
               behind = -(std::sqrt(g * squares_[before(i)]) - g * std::cos(k)) / std::sin(k);
  return (ahead * k + behind * k_next) / (k + k_next);
}

RosetteSector Joiner::sector(const std::size_t i) const
{
  const std::size_t j = next(i);
  const Slopes first = candidates_[i][taken_[i]], second = candidates_[j][taken_[j]];
  const Corner slips(slip_angles_[i], slip_steps_[i]), forces(force_angles_[i], force_steps_[i]);
  const double ratio = slips.sine / forces.sine, cosine = std::cos(force_steps_[i]);
  return {slips,
          forces,
          std::sqrt(first.turning * ratio),
          1 / std::sqrt(second.turning * ratio),
          squares_[i],
          squares_[j],
          first.size * forces.sine + squares_[i] * cosine,
          -second.size * forces.sine + squares_[j] * cosine,
          tensions_[i]};
}

/// Takes safer slopes at the two rows of a sector, and then tension.
void Joiner::improve(const std::size_t i)
{
  bool is_safe = true;
  for (const std::size_t row : {i, next(i)})
    if (taken_[row] + 1 < n_candidates)
    {
      ++taken_[row];
      is_safe = false;
    }
  if (is_safe)
    tensions_[i] = tensions_[i] > 0 ? 2 * tensions_[i] : 1;
}

/// The least of each condition within a sector, and the angle of slip from its first row at which it is.
struct Least
{
  RosetteSector::Conditions value;
  RosetteSector::Conditions angle;
};

/// At even steps of the slip and of the force, since one of them may turn fast where the other one rests.
Least least_conditions(const RosetteSector &sector)
{
  constexpr unsigned int n_places = 16;
  constexpr double none = std::numeric_limits<double>::infinity();
  Least least{{none, none, none}, {0, 0, 0}};
  const double h = sector.slips.angle, k = sector.forces.angle;
  const auto look = [&](const double p)
  {
    const RosetteSector::Conditions here = sector.conditions(p);
    const double angle = std::atan2(p * std::sin(h), 1 + p * std::cos(h));
    for (const auto member : {&RosetteSector::Conditions::along, &RosetteSector::Conditions::kappa,
                              &RosetteSector::Conditions::turning})
      if (!(here.*member >= least.value.*member || std::isnan(least.value.*member))) // NaN: G^2 < 0
      {
        least.value.*member = here.*member;
        least.angle.*member = angle;
      }
  };
  for (unsigned int place = 0; place < n_places; ++place)
  {
    const double part = static_cast<double>(place) / n_places;
    look(std::sin(part * h) / std::sin((1 - part) * h));
    look(sector.slip_ratio(std::sin(part * k) / std::sin((1 - part) * k)));
  }
  return least;
}

// As long as a sector fails, it gets safer slopes; kappa alone depends on them. Each step of that ladder
// leaves the others' as they are, but for a row that they share.
RosetteTable Joiner::join()
{
  constexpr unsigned int most_rounds = 40;
  std::vector<Least> least(n_);
  for (unsigned int round = 0; round < most_rounds; ++round)
  {
    std::vector<std::size_t> failing;
    for (std::size_t i = 0; i < n_; ++i)
      if (!((least[i] = least_conditions(sector(i))).value.kappa > 0))
        failing.push_back(i);
    if (failing.empty())
      break;
    if (round + 1 < most_rounds)
      std::for_each(failing.begin(), failing.end(), [this](const std::size_t i) { improve(i); });
  }
  const auto require = [&](double RosetteSector::Conditions::*const member, const std::string &name,
                           const std::string &because)
  {
    const auto worst =
        std::min_element(least.begin(), least.end(),
                         [&](const Least &a, const Least &b) { return a.value.*member < b.value.*member; });
    const double angle = slip_angles_[worst - least.begin()] + worst->angle.*member;
    if (!(worst->value.*member > 0))
      refuse(name, worst->value.*member, "at " + degrees(in_turn(angle)), because);
  };
  require(&RosetteSector::Conditions::along, "mu_along", forces_oppose);
  require(&RosetteSector::Conditions::turning, "the turn of the force, d b/da,", forces_turn);
  require(&RosetteSector::Conditions::kappa, "kappa = mu_along + d mu_across/da", pushes_slip);
  RosetteTable table{slip_angles_, {}, DirectionSearch(slip_angles_), DirectionSearch(force_angles_)};
  for (std::size_t i = 0; i < n_; ++i)
    table.sectors.push_back(sector(i));
  return table;
}
} // namespace

RosetteTable make_rosette_table(std::vector<Rosette::Row> rows)
{
  return Joiner(in_order(std::move(rows))).join();
}
} // namespace orthocone
