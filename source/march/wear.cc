// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/march/wear.h>

namespace orthocone
{
Eigen::VectorXd areas_of(const ContactSurface &surface)
{
  Eigen::VectorXd areas(static_cast<Eigen::Index>(surface.nodes.size()));
  for (Eigen::Index node = 0; node < areas.size(); ++node)
    areas[node] = surface.nodes[static_cast<std::size_t>(node)].area;
  return areas;
}

WearLaw::WearLaw(const WearOptions &options, const ContactSurface &surface)
    : options_(options),
      areas_(areas_of(surface))
{
}

double WearLaw::depth(const Eigen::Index node, const Rubbing &rubbing) const
{
  switch (options_.law)
  {
  case WearKind::none:
    break;
  case WearKind::archard:
    return options_.coefficient * rubbing.normal_force * rubbing.slip / areas_[node];
  case WearKind::energy:
    return options_.coefficient * rubbing.dissipated / areas_[node];
  }
  return 0;
}
} // namespace orthocone
