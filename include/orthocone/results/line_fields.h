// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/results/contact_fields.h>
#include <orthocone/scene/line_points.h>

#include <optional>
#include <vector>

namespace orthocone
{
/// A point of a line in a state, as the file of the line lists it.
struct LinePoint
{
  double distance;                      ///< from the first end, mm
  PointFields body;                     ///< of the whole body, in global axes
  std::optional<ContactFields> contact; ///< of the contact surface where the point lies there
};

/// Fields along a line. Where several processes share the body, all must make it and ask it. Fields of the
/// contact surface are interpolated between its nodes, as in its VTU files; the status is that of the nearest
/// node.
class LineFields
{
public:
  /// `evaluator` must outlive this object. Throws as LinePoints does.
  LineFields(const Line &line, const ContactFieldEvaluator &evaluator);

  bool is_in_lower() const { return points_.is_in_lower(); }

  /// The points from the first end to the second. `contact` is ContactFieldEvaluator::all_fields(); `lower`
  /// counts where is_in_lower().
  std::vector<LinePoint> at(const std::vector<ContactFields> &contact, const Deformation &upper,
                            const Deformation &lower) const;

private:
  Line line_;
  LinePoints points_;
  std::vector<std::optional<HangingNode>>
      surface_places_; ///< what the contact fields of each point are made of
};
} // namespace orthocone
