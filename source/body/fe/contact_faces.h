// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/surface/contact_surface.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/grid/cell_id.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <utility>
#include <vector>

namespace orthocone
{
/// A node of a contact face, by numbers that all processes know.
struct FaceNode
{
  using Dof = dealii::types::global_dof_index;

  std::array<Dof, 3> dofs; ///< of u_x, u_y, u_z
  std::array<bool, 3> is_free, is_supported;
  std::array<double, 3> place;  ///< mm
  double weight;                ///< mm^2
  std::array<double, 3> inward; ///< the weight times the normal into the body, mm^2
  bool hangs;
  std::vector<std::pair<Dof, double>> movers; ///< of u_z, where it hangs

  template<typename Archive>
  void serialize(Archive &archive, const unsigned int)
  {
    archive &dofs &is_free &is_supported &place &weight &inward &hangs &movers;
  }
};

/// A face of the contact surface, its nodes in lexicographic order.
struct ContactFace
{
  dealii::CellId cell;
  std::vector<FaceNode> nodes;
  unsigned int surface; ///< its number

  template<typename Archive>
  void serialize(Archive &archive, const unsigned int)
  {
    archive &cell &nodes &surface;
  }
};

/// The surface that consists of these faces. It is the same on every process, and for any number of
/// processes.
class ContactFaces
{
public:
  /// `of_this_process` are the faces of the cells that this process owns. `is_distributed`: other processes
  /// have more.
  ContactFaces(std::vector<ContactFace> of_this_process, bool is_distributed);

  /// In the order of the surface's faces.
  const std::vector<ContactFace> &faces() const { return faces_; }

  /// `faces_down`: the counterface has the normal z.
  ContactSurface surface(unsigned int degree, const dealii::Utilities::MPI::Partitioner &partitioner,
                         bool faces_down) const;

private:
  std::vector<ContactFace> faces_;
};
} // namespace orthocone
