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

/// The edges of these faces by the places of their nodes among the middles of a cell of second order, and
/// the nodes of the faces themselves behind the 12 edges.
constexpr std::array<Corners, 6> middles_of_edges{
    {{{1, 5, 3, 0}}, {{8, 10, 11, 9}}, {{0, 4, 8, 2}}, {{3, 6, 10, 4}}, {{5, 7, 11, 6}}, {{1, 2, 9, 7}}}};
constexpr std::array<unsigned int, 6> middles_of_faces{{12, 17, 13, 15, 16, 14}};

/// Whether all nodes of a face of a cell are among these.
bool has_face_in(const GmshFile::Element<8> &cell, const unsigned int face, const std::vector<bool> &is_in)
{
  const auto is_corner_in = [&](const unsigned int i) { return is_in[cell.nodes[i]]; };
  const auto is_middle_in = [&](const unsigned int i)
  { return i >= cell.middles.size() || is_in[cell.middles[i]]; };
  const auto &corners = faces_of_cell[face], &edges = middles_of_edges[face];
  return std::all_of(corners.begin(), corners.end(), is_corner_in) &&
         std::all_of(edges.begin(), edges.end(), is_middle_in) && is_middle_in(middles_of_faces[face]);
}

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
  const auto take = [&](const unsigned int node)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      lowest_[d] = std::min(lowest_[d], file.nodes[node][d]);
      highest_[d] = std::max(highest_[d], file.nodes[node][d]);
    }
  };
  for (const auto &cell : file.hexahedra)
  {
    std::for_each(cell.nodes.begin(), cell.nodes.end(), take);
    std::for_each(cell.middles.begin(), cell.middles.end(), take);
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
    for (unsigned int i = 0; i < faces_of_cell.size(); ++i)
      if (has_face_in(cell, i, is_in))
      {
        Corners face{};
        std::transform(faces_of_cell[i].begin(), faces_of_cell[i].end(), face.begin(),
                       [&](const auto corner) { return cell.nodes[corner]; });
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
