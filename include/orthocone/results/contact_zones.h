// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>
#include <orthocone/surface/contact_surface.h>

#include <vector>

namespace orthocone
{
/// Widths of zones of the contact surface where they are widest, in distances between neighbouring nodes: 0
/// where there is no zone, infinite where the zone has no border on the surface.
struct ZoneWidths
{
  double contact = 0;
  double stick = 0;
  /// Of the part that carries the load, where this is less than half of the contact; infinite otherwise.
  double load = 0;
  bool rim_touches = false; ///< whether a node at the rim of the contact surface is in contact
};

/// Neighbourhood of the nodes of a contact surface, by which a zone is measured.
class ContactZones
{
public:
  explicit ContactZones(const ContactSurface &surface);

  /// Widths of contact and stick, and what the rim does. One status for each place of the surface.
  ZoneWidths widths(const std::vector<NodeStatus> &statuses) const;

private:
  double width(const std::vector<bool> &is_in) const;
  void connect(unsigned int a, unsigned int b);
  void find_rim(const ContactSurface &surface);

  std::vector<std::vector<unsigned int>>
      neighbours_; ///< of each place, along the sides of faces cut at nodes
  std::vector<bool> is_at_rim_;
};
} // namespace orthocone
