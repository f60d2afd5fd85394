// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include "contact_faces.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <unordered_map>

namespace orthocone
{
namespace
{
/// Builds the surface face by face: it numbers the nodes in the order of the faces, and the hanging ones
/// behind the others.
class SurfaceBuilder
{
public:
  SurfaceBuilder(const unsigned int degree, const dealii::Utilities::MPI::Partitioner &partitioner,
                 const bool faces_down)
      : partitioner_(partitioner),
        faces_down_(faces_down)
  {
    surface_.degree = degree;
  }

  void add(const ContactFace &face)
  {
    std::vector<unsigned int> places;
    for (const FaceNode &node : face.nodes)
    {
      const auto [entry, is_new] = number_.emplace(node.dofs[2], static_cast<unsigned int>(all_.size()));
      if (is_new)
      {
        all_.emplace_back(contact_node(node), node);
        all_.back().first.surface = face.surface;
      }
      unsigned int &surface = all_[entry->second].first.surface;
      surface = std::min(surface, face.surface);
      all_[entry->second].first.area += node.weight;
      all_[entry->second].first.inward += Eigen::Map<const Eigen::Vector3d>(node.inward.data());
      places.push_back(entry->second);
    }
    surface_.faces.push_back(places);
  }

  ContactSurface finished()
  {
    for (auto &[node, on_face] : all_)
    {
      const Eigen::Vector3d inward = node.inward;
      node.inward = node.with_symmetry(inward); // the faces of the other side count, too
      if (!faces_down_)
        node.area_vector = inward;
    }
    std::vector<unsigned int> place(all_.size());
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (!all_[i].second.hangs)
      {
        place[i] = number_[all_[i].second.dofs[2]] = static_cast<unsigned int>(surface_.nodes.size());
        surface_.nodes.push_back(all_[i].first);
      }
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (all_[i].second.hangs)
        place[i] = hanging_place(all_[i].first, all_[i].second);
    for (auto &face : surface_.faces)
      for (unsigned int &number : face)
        number = place[number];
    return std::move(surface_);
  }

private:
  ContactNode contact_node(const FaceNode &node) const
  {
    ContactNode result{
        {{node.place[0], node.place[1]}}, 0, {}, node.is_free, node.place[2], node.is_supported,
        Eigen::Vector3d::Zero()};
    for (unsigned int d = 0; d < 3; ++d)
      result.dofs[d] =
          node.dofs[d] != dealii::numbers::invalid_dof_index && partitioner_.in_local_range(node.dofs[d])
              ? partitioner_.global_to_local(node.dofs[d])
              : ContactNode::no_dof;
    return result;
  }

  /// Number of the place of a hanging node, whose area goes to the contact nodes that move it. In the middle
  /// of an edge of even degree this place is a contact node.
  unsigned int hanging_place(ContactNode hanging, const FaceNode &node)
  {
    std::vector<HangingNode::Term> terms;
    for (const auto &[dof, weight] : node.movers)
    {
      terms.push_back({number_.at(dof), weight});
      surface_.nodes[terms.back().node].area += weight * hanging.area;
      surface_.nodes[terms.back().node].area_vector += weight * hanging.area_vector;
    }
    if (terms.size() == 1)
      return terms.front().node;
    hanging.area = 0;
    hanging.area_vector.setZero();
    surface_.hanging.push_back({hanging, terms});
    return static_cast<unsigned int>(surface_.n_places()) - 1;
  }

  const dealii::Utilities::MPI::Partitioner &partitioner_;
  bool faces_down_;
  ContactSurface surface_;
  std::vector<std::pair<ContactNode, FaceNode>> all_;
  std::unordered_map<FaceNode::Dof, unsigned int> number_; ///< of u_z
};
} // namespace

ContactFaces::ContactFaces(std::vector<ContactFace> of_this_process, const bool is_distributed)
{
  if (is_distributed)
    for (const auto &faces : dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, of_this_process))
      faces_.insert(faces_.end(), faces.begin(), faces.end());
  else
    faces_ = std::move(of_this_process);
  // A cell may have several faces.
  std::stable_sort(faces_.begin(), faces_.end(),
                   [](const ContactFace &a, const ContactFace &b) { return a.cell < b.cell; });
}

ContactSurface ContactFaces::surface(const unsigned int degree,
                                     const dealii::Utilities::MPI::Partitioner &partitioner,
                                     const bool faces_down) const
{
  SurfaceBuilder builder(degree, partitioner, faces_down);
  for (const ContactFace &face : faces_)
    builder.add(face);
  return builder.finished();
}
} // namespace orthocone
