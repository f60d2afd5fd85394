// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/options.h>

namespace orthocone
{
// Each in a file of its name, which may be compiled together with this one.
// NOLINTBEGIN(readability-redundant-declaration)
Kind<ObstacleKindOptions> rigid_obstacle();
Kind<ObstacleKindOptions> half_space_obstacle();
Kind<ObstacleKindOptions> lower_body_obstacle();
// NOLINTEND(readability-redundant-declaration)

template<>
std::vector<Kind<ObstacleKindOptions>> &kinds_of<ObstacleKindOptions>()
{
  static std::vector<Kind<ObstacleKindOptions>> kinds{rigid_obstacle(), half_space_obstacle(),
                                                      lower_body_obstacle()};
  return kinds;
}

static Entry::Binding gap_binding(ObstacleOptions &obstacle)
{
  const Codec<Expression> gap = expression_codec(any_number);
  return {gap.allowed,
          [&obstacle, gap](const std::string &text, std::string &instead)
          {
            const auto given = gap.parse(text, instead);
            if (given)
              obstacle.gap = given->text();
            return given.has_value();
          },
          [&obstacle] { return obstacle.gap; }};
}

static Entry::Binding distance_binding(ObstacleOptions &obstacle)
{
  const Codec<Expression> codec = expression_codec(any_number);
  return {"an expression of x, y and z, or nothing",
          [&obstacle, codec](const std::string &text, std::string &instead)
          {
            const bool is_nothing = text.empty();
            const auto given =
                is_nothing ? std::optional<Expression>(Expression()) : codec.parse(text, instead);
            const bool is_allowed = is_nothing || (given && !given->is_constant());
            if (is_allowed)
              obstacle.distance = text;
            return is_allowed;
          },
          [&obstacle] { return obstacle.distance; }};
}

bool ObstacleOptions::is_plane() const
{
  const Expression expression(gap);
  return kind.chosen().keeps_surface() && has_normal_z() && gap_file.empty() && expression.is_constant() &&
         expression.value(0, 0) == 0;
}

void declare_obstacle(ObstacleOptions &obstacle, Section &section)
{
  section
      .add("Gap", gap_binding(obstacle),
           "Gap in mm between the contact surface and the counterface, before the body moves; "
           "(x^2+y^2)/(2*1000) describes a sphere of radius 1000 mm.")
      .unit("mm");
  section
      .add("Gap file", obstacle.gap_file, path_codec(),
           "Text file with a gap on a regular grid, such as a measured surface, which is added to Gap: the "
           "line 'x0 dx nx y0 dy ny', then ny lines of nx numbers, all lengths in mm. The path is relative "
           "to the folder of the parameter file.")
      .path(obstacle.gap_file);
  section
      .add("Distance", distance_binding(obstacle),
           "Signed distance in mm of a rigid counterface of any shape from a place (x, y, z), positive "
           "outside of it: the gap of a contact node is its value there, and the normal its gradient. "
           "z*cos(pi/4) - x*sin(pi/4) is a plane at 45 degrees, 20 - sqrt(x^2+y^2) a bore of radius 20 "
           "mm, and min(A, B) two counterfaces at once. It takes the place of Gap.")
      .unit("mm")
      .also_called({"level set", "signed distance", "sdf"});
  section.add_word(
      "Normal", obstacle.normal,
      "Normal of the counterface. plane: z, and Gap is a distance along z. surface: the "
      "counterface fits the body, and Gap is a distance along the normals of its contact "
      "surface; where Gap is negative, both overlap by that much, which a load of kind "
      "interference drives from 0 to 1. A second body lies in its place then, and Gap is added to "
      "the distance of both surfaces.");
  obstacle.kind.declare(
      "Kind",
      "The counterface, on which the body is pressed; Gap is the distance between both, whichever of them is "
      "curved. Elastic counterfaces exclude the axisymmetric model, and a second body excludes Mesh/Backend "
      "= "
      "multigrid.",
      section);
}
} // namespace orthocone
