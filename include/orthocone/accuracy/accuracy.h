// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/options.h>

#include <array>
#include <string>
#include <vector>

namespace orthocone
{
/// The quantities of the preload and the first cycle for which an accuracy is asked.
constexpr unsigned int n_quantities = accuracy_words.size();
using Quantities = std::array<double, n_quantities>;

/// They are: the largest slip (mm) of all steps; force (N) and stick area (mm^2) at the peak, which is the
/// first step in which the top is lowest; the energy dissipated up to the end of the first cycle (N mm); and
/// the work of the held face in this cycle, which is the area of the loop (N mm).
constexpr std::array<const char *, n_quantities> quantity_names{
    {"largest_slip_mm", "peak_force_N", "dissipation_Nmm", "stick_area_mm2", "loop_area_Nmm"}};

constexpr unsigned int stick_area_index = 3;
constexpr unsigned int loop_area_index = 4;

/// Values and estimated errors of the quantities.
struct AccuracyEstimate
{
  double wanted = 0; ///< percent
  Quantities values{};
  Quantities errors{};      ///< estimated, percent
  Quantities steps_share{}; ///< the part of `wanted` that errors of load steps take, percent
  CountedQuantities counted = all_quantities; ///< for which `wanted` was asked

  bool is_reached() const; ///< whether the counted errors, with those of the steps, are within `wanted`
};

/// Absolute errors relative to the values, percent. Errors of the stick area are relative to a tenth of the
/// `contact_area` (mm^2) if that is larger. Errors of slip, dissipation and work are relative to a thousandth
/// of the `motion` of the top (mm), and of its work, if these are larger: where nearly all sticks, the digits
/// of a tiny slip at the rim are not worth any effort.
Quantities relative_errors(const Quantities &absolute, const Quantities &values, double contact_area,
                           double motion);

/// Estimated errors (percent, as relative_errors()) of the last of `levels`, the quantities on finer and
/// finer meshes; for a single level nothing is known, and they are 100 %. Differences between levels fall by
/// a ratio; all finer levels together would change the last difference times ratio/(1 - ratio). The ratio
/// comes from the last two differences, but is taken as a half at least. A difference may be small by chance,
/// so it counts as at least a third of the one before. docs/accuracy.md, "How good the estimates are".
Quantities estimated_errors(const std::vector<Quantities> &levels, double contact_area, double motion);

/// Error of a value that converges at about first order, from its change by halving the steps and its change
/// by the halving before, or 0 if that is not known. The ratio of both is limited as in estimated_errors().
/// In the unit of `change`.
double first_order_error(double change, double change_before);

/// "largest_slip_mm 0.0181 (0.4 %), ...": values and estimated errors.
std::string describe_quantities(const AccuracyEstimate &accuracy);

/// The same, and whether it reaches what was wanted.
std::string describe(const AccuracyEstimate &accuracy);
} // namespace orthocone
