// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/results/contact_zones.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace orthocone
{
namespace
{
using Side = std::pair<unsigned int, unsigned int>;

/// Sides of a face between neighbouring nodes on its outline; both end nodes of a section's face.
std::vector<Side> outline(const std::vector<unsigned int> &face, const unsigned int degree)
{
  const unsigned int n = degree + 1;
  std::vector<Side> sides;
  if (face.size() == n)
    return {{face.front(), face.front()}, {face.back(), face.back()}};
  for (unsigned int i = 0; i < degree; ++i)
  {
    sides.emplace_back(face[i], face[i + 1]);
    sides.emplace_back(face[degree * n + i], face[degree * n + i + 1]);
    sides.emplace_back(face[i * n], face[(i + 1) * n]);
    sides.emplace_back(face[i * n + degree], face[(i + 1) * n + degree]);
  }
  for (auto &[a, b] : sides)
    if (a > b)
      std::swap(a, b);
  return sides;
}

/// Whether both nodes lie on the same plane of symmetry.
bool is_mirrored(const ContactNode &a, const ContactNode &b)
{
  return (a.is_on_plane(0) && b.is_on_plane(0)) || (a.is_on_plane(1) && b.is_on_plane(1));
}
} // namespace

ContactZones::ContactZones(const ContactSurface &surface)
    : neighbours_(surface.n_places()),
      is_at_rim_(surface.n_places(), false)
{
  const unsigned int n = surface.degree + 1;
  for (const auto &face : surface.faces)
    for (unsigned int i = 0; i < face.size(); ++i)
    {
      if (i % n + 1 < n)
        connect(face[i], face[i + 1]);
      if (i + n < face.size())
        connect(face[i], face[i + n]);
    }
  find_rim(surface);
}

void ContactZones::connect(const unsigned int a, const unsigned int b)
{
  neighbours_[a].push_back(b);
  neighbours_[b].push_back(a);
}

/// Sides of one face only bound the surface, unless smaller faces lie behind them or the model is mirrored
/// there.
void ContactZones::find_rim(const ContactSurface &surface)
{
  std::vector<bool> is_master(surface.n_places(), false);
  for (const HangingNode &hanging : surface.hanging)
    for (const HangingNode::Term &term : hanging.terms)
      is_master[term.node] = true;
  std::map<Side, unsigned int> n_faces;
  for (const auto &face : surface.faces)
    for (const Side &side : outline(face, surface.degree))
      ++n_faces[side];
  const bool is_section = !surface.faces.empty() && surface.faces.front().size() == surface.degree + 1;
  const auto is_beside_smaller = [&](const unsigned int node)
  { return node >= surface.nodes.size() || is_master[node]; };
  for (const auto &[side, n] : n_faces)
  {
    const auto &[a, b] = side;
    if (is_section ? neighbours_[a].size() == 1 && !surface.place(a).is_on_plane(0) // not on axis or plane
                   : n == 1 && !is_beside_smaller(a) && !is_beside_smaller(b) &&
                         !is_mirrored(surface.place(a), surface.place(b)))
      is_at_rim_[a] = is_at_rim_[b] = true;
  }
}

/// A zone ends half way between its nodes and those outside. Its middle is a node, or lies between two.
double ContactZones::width(const std::vector<bool> &is_in) const
{
  constexpr unsigned int far = std::numeric_limits<unsigned int>::max();
  if (std::none_of(is_in.begin(), is_in.end(), [](const bool in) { return in; }))
    return 0;
  std::vector<unsigned int> distance(is_in.size(), far), front;
  for (unsigned int place = 0; place < is_in.size(); ++place)
    if (!is_in[place])
    {
      distance[place] = 0;
      front.push_back(place);
    }
  for (std::size_t i = 0; i < front.size(); ++i)
    for (const unsigned int next : neighbours_[front[i]])
      if (distance[next] == far)
      {
        distance[next] = distance[front[i]] + 1;
        front.push_back(next);
      }
  const unsigned int depth = *std::max_element(distance.begin(), distance.end());
  return depth == far ? std::numeric_limits<double>::infinity() : 2. * depth - 1;
}

ZoneWidths ContactZones::widths(const std::vector<NodeStatus> &statuses) const
{
  std::vector<bool> touches(statuses.size()), sticks(statuses.size());
  ZoneWidths widths;
  for (std::size_t place = 0; place < statuses.size(); ++place)
  {
    touches[place] = statuses[place] != NodeStatus::open;
    sticks[place] = statuses[place] == NodeStatus::stick;
    widths.rim_touches = widths.rim_touches || (is_at_rim_[place] && touches[place]);
  }
  widths.contact = width(touches);
  widths.stick = width(sticks);
  return widths;
}
} // namespace orthocone
