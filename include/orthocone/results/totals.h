// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/results/contact_fields.h>

namespace orthocone
{
/// Results of one of several contact surfaces of the whole body.
struct SurfaceTotals
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero(); ///< of the counterface on it (x, y, z), N
  double normal_force = 0;                         ///< sum of the normal forces of its nodes, N
  double contact_area = 0;                         ///< mm^2
  double max_pressure = 0;                         ///< MPa
  double max_slip = 0;                             ///< of its nodes in contact, mm
  double total_dissipation = 0;                    ///< N mm
};

/// The factor on the coefficients of friction over the nodes in contact.
struct FactorRange
{
  double least = 0;
  double mean = 0; ///< by area
  double largest = 0;
};

/// Results of the whole body after a step, whatever part of it is modelled.
struct Totals
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< of the plane on the body (x, y, z), N
  Eigen::Vector3d moment = Eigen::Vector3d::Zero(); ///< its moment about the centre of the held face, N mm
  Wrench held{};                                    ///< on the held face, N and N mm
  double max_slip = 0;                              ///< of the nodes in contact, mm
  double max_accumulated_slip = 0;                  ///< mm
  double min_pressure = 0;                          ///< MPa
  double max_pressure = 0;                          ///< MPa
  unsigned int n_open = 0;
  unsigned int n_stick = 0;
  unsigned int n_slip = 0;
  double stick_area = 0;   ///< mm^2; its border runs through the cells (StickArea)
  double contact_area = 0; ///< mm^2
  ZoneWidths zones{};
  double total_dissipation = 0;     ///< N mm
  double max_dissipated_energy = 0; ///< largest one of a node per area, N/mm
  double elastic_energy = 0;        ///< N mm
  Eigen::VectorXd loads{};          ///< FaceState::loads: MPa, mm, N, K
  Eigen::VectorXd conjugates{}; ///< Scene::load_conjugates(), but of surfaces that find it their motion, mm
  Eigen::VectorXd load_areas{}; ///< Scene::load_areas(), mm^2
  double worn_volume = 0;       ///< mm^3
  double max_wear_depth = 0;    ///< mm
  std::optional<FactorRange> factor{};   ///< of friction with memory, where nodes are in contact
  std::vector<SurfaceTotals> surfaces{}; ///< of each of several contact surfaces; none of one alone
};

/// The totals of a state.
Totals compute_totals(const ContactFieldEvaluator &evaluator, const ContactState &state);
} // namespace orthocone
