// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/body/shapes/surface_places.h>

#include <orthocone/base/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace orthocone
{
namespace
{
using Corners = std::array<unsigned int, 4>;

/// Faces of a hexahedron in Gmsh's order of its nodes.
constexpr std::array<Corners, 6> faces_of_cell{
    {{{0, 3, 2, 1}}, {{4, 5, 6, 7}}, {{0, 1, 5, 4}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{3, 0, 4, 7}}}};

/// With the digits that a reader can compare; no -0.
std::string short_text(const double value)
{
  std::ostringstream text;
  text << value + 0.;
  return text.str();
}
} // namespace

MeshBox::MeshBox(const GmshFile &file)
{
  lowest_.fill(std::numeric_limits<double>::max());
  highest_.fill(std::numeric_limits<double>::lowest());
  for (const auto &cell : file.hexahedra)
    for (const unsigned int node : cell.nodes)
      for (unsigned int d = 0; d < 3; ++d)
      {
        lowest_[d] = std::min(lowest_[d], file.nodes[node][d]);
        highest_[d] = std::max(highest_[d], file.nodes[node][d]);
      }
  for (unsigned int d = 0; d < 3; ++d)
    extent_ = std::max(extent_, highest_[d] - lowest_[d]);
}

std::optional<PlaneOfAxis> MeshBox::find(const std::string &place) const
{
  const auto axis = static_cast<unsigned int>(std::string("xyz").find(place.substr(0, 1)));
  if (place.size() < 2 || axis > 2)
    return std::nullopt;
  const std::string rest = trimmed(place.substr(1));
  if (const bool has_blank = place[1] == ' '; has_blank && (rest == "min" || rest == "max"))
    return PlaneOfAxis{axis, rest == "min" ? lowest_[axis] : highest_[axis]};
  const auto at = rest.front() == '=' ? parse_number(trimmed(rest.substr(1))) : std::nullopt;
  return at ? std::make_optional(PlaneOfAxis{axis, *at}) : std::nullopt;
}

bool MeshBox::are_same(const PlaneOfAxis &a, const PlaneOfAxis &b) const
{
  return a.axis == b.axis && std::abs(a.at - b.at) <= tolerance();
}

std::size_t n_faces_in(const GmshFile &file, const MeshBox &box, const PlaneOfAxis &plane)
{
  std::vector<bool> is_in(file.nodes.size());
  for (std::size_t i = 0; i < is_in.size(); ++i)
    is_in[i] = std::abs(file.nodes[i][plane.axis] - plane.at) <= box.tolerance();
  std::vector<Corners> found;
  for (const auto &cell : file.hexahedra)
    for (const Corners &corners : faces_of_cell)
      if (std::all_of(corners.begin(), corners.end(), [&](const auto i) { return is_in[cell.nodes[i]]; }))
      {
        Corners face{};
        std::transform(corners.begin(), corners.end(), face.begin(),
                       [&](const auto i) { return cell.nodes[i]; });
        std::sort(face.begin(), face.end());
        found.push_back(face);
      }
  std::sort(found.begin(), found.end());
  std::size_t n_outside = 0; // those between two cells are found twice
  for (std::size_t i = 0; i < found.size(); ++i)
    n_outside += (i == 0 || found[i] != found[i - 1]) && (i + 1 == found.size() || found[i] != found[i + 1]);
  return n_outside;
}

std::string list_places(const GmshFile &file, const MeshBox &box)
{
  std::string all;
  for (const char axis : {'x', 'y', 'z'})
    for (const char *const end : {" min", " max"})
    {
      const std::string place = axis + std::string(end);
      if (const PlaneOfAxis plane = *box.find(place); n_faces_in(file, box, plane) > 0)
        all += (all.empty() ? "" : ", ") + place + " (" + short_text(plane.at) + ")";
    }
  return all;
}
} // namespace orthocone
