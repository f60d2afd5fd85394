// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <array>
#include <string>
#include <vector>

namespace orthocone
{
/// The quantities that an accuracy is asked of, of the preload and the first cycle.
constexpr unsigned int n_quantities = 5;
using Quantities = std::array<double, n_quantities>;

/// Largest slip (mm) of all steps; force (N) and stick area (mm^2) at the peak, the first step in which the
/// top stands lowest; energy dissipated until the end of the first cycle (N mm); work of the held face in
/// this cycle, which is the area of the loop (N mm).
constexpr std::array<const char *, n_quantities> quantity_names{
    {"largest_slip_mm", "peak_force_N", "dissipation_Nmm", "stick_area_mm2", "loop_area_Nmm"}};

constexpr unsigned int stick_area_index = 3;
constexpr unsigned int loop_area_index = 4;

struct AccuracyEstimate
{
  double wanted = 0; ///< percent
  Quantities values{};
  Quantities errors{};      ///< estimated, percent
  Quantities steps_share{}; ///< what the errors of load steps take of that which is wanted, percent

  bool is_reached() const;
};

/// What absolute errors are relative to the values, percent. Those of the stick area are relative to a tenth
/// of the `contact_area`, if that is larger. Those of slip, dissipation or work that are next to nothing are
/// related to a thousandth of the `motion` of the top (mm) and of its work: where all sticks, digits of what
/// slips at the rim are not worth any effort.
Quantities relative_errors(const Quantities &absolute, const Quantities &values, double contact_area,
                           double motion);

/// Estimated errors (percent) of the last of `levels`, the quantities on finer and finer meshes; of a single
/// one nothing is known: 100 %. Differences between levels fall by a ratio; what all finer levels would still
/// change is the last difference times ratio/(1 - ratio). The ratio is that of the last differences, but
/// never taken for better than a half, and a difference that is small by chance is not believed: it counts as
/// at least a third of the one before. They are relative as relative_errors() are.
Quantities estimated_errors(const std::vector<Quantities> &levels, double contact_area, double motion);

/// Error of what converges at first order or nearly so, from what halving changes, and from what halving
/// changed before, or 0 if that is not known. The ratio of both is believed as in estimated_errors().
double first_order_error(double change, double change_before);

/// "largest_slip_mm 0.0181 (0.4 %), ...": values and estimated errors.
std::string describe_quantities(const AccuracyEstimate &accuracy);

/// The same, and whether it is what was wanted.
std::string describe(const AccuracyEstimate &accuracy);
} // namespace orthocone
