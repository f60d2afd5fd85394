// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/march/contact_state.h>
#include <orthocone/results/contact_zones.h>
#include <orthocone/results/held_face.h>
#include <orthocone/results/stick_area.h>
#include <orthocone/scene/scene.h>

#include <variant>
#include <vector>

namespace orthocone
{
/// The results at one node of the contact surface, as users see them; vectors are in global axes (x, y, z).
struct ContactFields
{
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();      ///< mm
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();              ///< mm, tangential; zero where it is open
  double accumulated_slip = 0;                                 ///< mm
  double gap = 0;                                              ///< mm, > 0 open
  double pressure = 0;                                         ///< MPa
  Eigen::Vector3d friction_traction = Eigen::Vector3d::Zero(); ///< MPa, of the plane on the body
  double friction_criterion = -1; ///< ||r_t||_m / r_n - 1; -1 without pressure, 0 without friction
  NodeStatus status = NodeStatus::open;
  Eigen::Vector3d nodal_force = Eigen::Vector3d::Zero(); ///< N, of one node of the whole surface
  double normal_force = 0;                               ///< N, the part along the normal
  double dissipated_energy = 0;                          ///< N/mm, accumulated, per area
  double wear_depth = 0;                                 ///< mm, accumulated
  unsigned int surface = 0;                              ///< number of the contact surface
  double friction_factor = 0;                            ///< on the coefficients of friction in the step
};

/// The number of the contact surface at an image of a node on surface `number`: a mirror exchanges x- and x+
/// of a box.
unsigned int image_of_surface(const GeometryOptions &geometry, unsigned int number,
                              const Eigen::Matrix2d &map);

/// The same at an image of the node; `map` is the map (2 x 2) from the model to the image.
ContactFields mapped(ContactFields fields, const Eigen::Matrix2d &map);

/// Fields of a place that is made of others, such as a hanging node: interpolated between these (`all`), or
/// those of the nearest one where they cannot be.
ContactFields between(const HangingNode &hanging, const std::vector<ContactFields> &all);

/// A field of the files on the contact surface. A new one is a line in contact_field_list().
struct ContactField
{
  using Scalar = double ContactFields::*;
  using Vector = Eigen::Vector3d ContactFields::*;
  using Derived = double (*)(const ContactFields &);

  const char *name;
  const char *unit; ///< empty for shares and counts
  const char *how;
  std::variant<Scalar, Vector, Derived> of;
  bool (*is_there)(const Parameters &) = nullptr; ///< in the files of such a run; in all of them without it

  unsigned int n_components() const { return std::holds_alternative<Vector>(of) ? 3 : 1; }

  /// The value; its first n_components() numbers count.
  Eigen::Vector3d value(const ContactFields &fields) const;
};

/// The fields in the order of the files: all of them, and those of a run.
const std::vector<ContactField> &contact_field_list();
std::vector<ContactField> contact_field_list(const Parameters &parameters);

/// Computes the fields of the nodes of a state. Only reads.
class ContactFieldEvaluator
{
public:
  /// `scene` must outlive the evaluator.
  explicit ContactFieldEvaluator(const Scene &scene);

  /// Fields of a contact node; its displacement is that relative to the counterface.
  ContactFields fields(const ContactState &state, unsigned int node) const;
  /// Force (N) of the counterface on a node of the model, in global axes.
  Eigen::Vector3d model_force(const ContactState &state, const unsigned int node) const
  {
    return axes_.global_in_local(node) * state.force.segment<3>(3 * static_cast<Eigen::Index>(node));
  }

  /// Fields of all places: contact nodes, then hanging nodes. Only one thread at a time may use the scene,
  /// whose compliance remembers its last product.
  std::vector<ContactFields> all_fields(const ContactState &state) const;

  /// Area that sticks in the whole body, mm^2.
  double stick_area(const ContactState &state) const;

  /// How wide contact, stick and load are in the whole body.
  ZoneWidths zones(const ContactState &state) const;

  /// BodyUnknowns::arm().
  Eigen::Vector3d arm(const unsigned int node) const { return unknowns_.arm(surface_.nodes[node]); }

  const ContactSurface &surface() const { return surface_; }
  const ModelSymmetry &symmetry() const { return symmetry_; }
  const Compliance &compliance() const { return compliance_; }
  const Scene &scene() const { return scene_; }

private:
  void add_counterface(const ContactState &state, std::vector<ContactFields> &all) const;
  double load_width(const ContactState &state) const;
  StickSample stick_sample(const ContactState &state, unsigned int node, double unresolved) const;

  const Scene &scene_;
  const BodyUnknowns &unknowns_;
  const ContactSurface &surface_;
  const ModelSymmetry &symmetry_;
  const Compliance &compliance_;
  LocalAxes axes_;
  const ContactSystem &system_;
  Eigen::VectorXd shares_;      ///< ModelSymmetry::force_shares()
  Eigen::VectorXd compliances_; ///< node_compliance()
  double tolerance_;            ///< of the solver
  StickArea stick_area_;
  ContactZones zones_;
};
} // namespace orthocone
