// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/wear.h>

#include <utility>

namespace orthocone
{
WearLaw::WearLaw(const WearOptions &options, Eigen::VectorXd areas)
    : options_(options),
      areas_(std::move(areas))
{
}

double WearLaw::depth(const Eigen::Index node, const Rubbing &rubbing) const
{
  return options_.wears() ? options_.law.chosen().volume(options_.coefficient, rubbing) / areas_[node] : 0;
}
} // namespace orthocone
