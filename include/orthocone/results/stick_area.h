// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/contact/problem/contact_step.h>
#include <orthocone/scene/options.h>
#include <orthocone/surface/contact_surface.h>
#include <orthocone/surface/section_model.h>

#include <optional>

namespace orthocone
{
/// The values at a contact node that locate the border of the stick zone. Where a node begins to slip or to
/// open, both reserve and slip are 0, and the area is a continuous function of them.
struct StickSample
{
  NodeStatus status = NodeStatus::open;
  double reserve = 0; ///< friction traction that would still fit before slip, MPa; of nodes that stick
  double slip = 0;    ///< since the node last stuck, and its gap, mm; of nodes that do not stick
  /// n e^T of nodes that slip: the normal n of the cone at their friction force, as long that its component
  /// along the force is 1, and the direction e of slip. Zero or StickArea::of_unknown_direction() where these
  /// are not known. In global axes.
  Eigen::Matrix3d normal_by_slip = Eigen::Matrix3d::Zero();
};

/// Where the stick zone ends between a node that sticks and one that slips, `length` mm away across the
/// border, as a share of the way from the first one (docs/theory.md, section 4, "Stick area"). At a border at
/// rest the reserve grows like K sqrt(distance) into the stick zone and the slip like edge_compliance K
/// distance^(3/2) out of it (edge of a contact with friction, e.g. Johnson, Contact Mechanics, 1985, 7.2);
/// the one K that lets both distances add up to `length` places it. Half way where both are 0.
double stick_share(double reserve, double slip, double edge_compliance, double length);

/// Area of the part of the contact surface that sticks. A sum of the lumped areas of the nodes that stick
/// would be right to the size of a cell only; here the border runs through the cells between the nodes.
class StickArea
{
public:
  /// `material` is Scene::contact_material(), that of both bodies; only its isotropic constants count.
  /// `section` is that of a surface of lines and means nothing for another one.
  StickArea(const ContactSurface &surface, const MaterialOptions &material, const SectionModel &section = {});

  /// The area (mm^2) of the modelled part that sticks; one sample for each place.
  double operator()(const std::vector<StickSample> &samples) const;

  /// The StickSample::normal_by_slip with which slip is as compliant as in-plane shear, whatever the border,
  /// on a surface with this normal.
  Eigen::Matrix3d of_unknown_direction(const Eigen::Vector3d &surface_normal) const;

private:
  using Place = Eigen::Vector3d; ///< mm
  /// A cell between four nodes (anticlockwise) of a face.
  struct Cell
  {
    std::array<unsigned int, 4> nodes;
    std::array<Place, 4> positions;
    Eigen::Vector3d normal; ///< of length 1
    double area;            ///< mm^2
  };
  /// A ring or strip between two nodes of the face of a section.
  struct Ring
  {
    std::array<unsigned int, 2> nodes;
    std::array<Place, 2> places;
  };
  /// The point where stick ends on a side of a cell.
  struct Border
  {
    double along; ///< 0 to 1
    Place place;
  };
  using Borders = std::vector<Border>;

  void add_cells(const ContactSurface &surface, const std::vector<unsigned int> &face);
  double border(const StickSample &first, const StickSample &second, double length,
                const Eigen::Vector3d &normal) const;
  double edge_compliance(const StickSample &slipping, const Eigen::Vector3d &normal) const;
  Borders borders_of(const Cell &cell, const std::vector<unsigned int> &sides,
                     const std::vector<StickSample> &samples) const;
  Borders borders_of(const Cell &cell, const std::vector<unsigned int> &sides,
                     const std::vector<StickSample> &samples, const std::optional<Place> &normal) const;
  static std::optional<Place> normal_of(const Cell &cell, const Borders &borders);
  double share(const Cell &cell, const std::vector<StickSample> &samples) const;
  double share_across(const Cell &cell, const std::vector<StickSample> &samples) const;
  double area(const Ring &ring, const std::vector<StickSample> &samples) const;

  double poisson_ratio_;
  double edge_compliance_; ///< of in-plane shear, mm^2/N
  std::vector<Cell> cells_;
  std::vector<Ring> rings_;
  SectionModel section_;
};
} // namespace orthocone
