// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/fe/displacement_space.h>
#include <orthocone/body/materials/material.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace orthocone
{
/// A traction (MPa) on a surface with this outward normal of length 1, in space.
struct SurfaceTraction
{
  Eigen::Vector3d normal, traction;
};

/// The tractions that are known without the stress: those of contact, and none on free surfaces. What holds
/// or loads the other surfaces is not known point by point.
template<int dim>
class KnownTractions
{
public:
  using Cell = typename DisplacementSpace<dim>::Cell;

  /// `of_nodes` (MPa) belong to the contact nodes; where they are empty, nothing is known. Both arguments
  /// must outlive this object.
  KnownTractions(const DisplacementSpace<dim> &space, const std::vector<Eigen::Vector3d> &of_nodes);

  /// At points of a cell, given in the unit cell; nothing inside the body, and where nothing is known. Calls
  /// with the same points as the one before take less time.
  std::vector<std::optional<SurfaceTraction>> at(const Cell &cell,
                                                 const std::vector<dealii::Point<dim>> &units);

private:
  /// A face with known tractions, and its number in the contact surface if it belongs there.
  struct KnownFace
  {
    unsigned int face;
    std::optional<unsigned int> number;
  };
  std::optional<KnownFace> face_at(const Cell &cell, const dealii::Point<dim> &unit) const;
  const dealii::FEValues<dim> &jacobians(const Cell &cell, const std::vector<dealii::Point<dim>> &units);
  Eigen::Vector3d of_contact(const Cell &cell, unsigned int face, unsigned int number,
                             const dealii::Point<dim> &unit) const;
  Eigen::Vector3d of_place(unsigned int place) const;

  const DisplacementSpace<dim> &space_;
  const std::vector<Eigen::Vector3d> &of_nodes_;
  std::map<unsigned int, std::vector<unsigned int>>
      contact_faces_; ///< numbers, by cells, in the order of faces
  std::unique_ptr<dealii::FEValues<dim>> jacobians_{};
};

/// The stress with the strain in a surface that `stress` has, and this traction on it.
Stress with_traction(const Stress &stress, const Material &material, const SurfaceTraction &of);
} // namespace orthocone
