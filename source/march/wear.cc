// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/wear.h>

namespace orthocone
{
Eigen::VectorXd areas_of(const ContactSurface &surface)
{
  Eigen::VectorXd areas(static_cast<Eigen::Index>(surface.nodes.size()));
  for (Eigen::Index node = 0; node < areas.size(); ++node)
    areas[node] = surface.nodes[static_cast<std::size_t>(node)].pressed_area;
  return areas;
}

WearLaw::WearLaw(const WearOptions &options, const ContactSurface &surface)
    : options_(options),
      areas_(areas_of(surface))
{
}

double WearLaw::depth(const Eigen::Index node, const Rubbing &rubbing) const
{
  return options_.wears() ? options_.law.chosen().volume(options_.coefficient, rubbing) / areas_[node] : 0;
}
} // namespace orthocone
