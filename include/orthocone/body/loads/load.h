// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Loads beside those of the held face: each is one number that the load program drives. The body answers
// linearly, so that a load has one displacement field per unit (docs/theory.md, section 2, "Loads").
#pragma once

#include <orthocone/body/materials/material_law.h>

#include <Eigen/Core>

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace orthocone
{
/// What multiplies a load in its work, as tables have it: the work of a small change is its value times the
/// change of the conjugate, or, where the load is a motion or a temperature, the reverse.
struct Conjugate
{
  const char *suffix; ///< of the column behind that of the load: "u" makes "NAME_u"
  const char *unit;
  const char *how; ///< what it is, for tables
};

/// A kind of load: its word, what it asks for, and what a unit of it does at a point. Each kind stands in a
/// file of its own, with a line in load_kinds().
class LoadKind
{
public:
  virtual ~LoadKind() = default;

  virtual std::string_view word() const = 0;
  virtual std::string_view help() const = 0; ///< a clause behind the word
  virtual const char *unit() const = 0;
  virtual Conjugate conjugate() const = 0;

  virtual bool has_surface() const { return true; }   ///< whether it acts on surfaces, not on the whole body
  virtual bool has_direction() const { return true; } ///< whether it needs "along ..."

  /// Whether a surface keeps one displacement along the direction, which must then be an axis.
  virtual bool moves_surface() const { return false; }

  /// Whether that displacement is found from the force that the load gives.
  virtual bool is_force_of_surface() const { return false; }

  /// Traction on the surface (MPa) of a unit of the load; `normal` points out of the body.
  virtual Eigen::Vector3d traction(const Eigen::Vector3d & /*normal*/,
                                   const Eigen::Vector3d & /*direction*/) const
  {
    return Eigen::Vector3d::Zero();
  }

  /// Strain of an unloaded body under a unit of the load.
  virtual Strain free_strain(const MaterialOptions & /*material*/) const { return {}; }

  /// Whether it is the share of negative gaps between body and counterface that is there.
  virtual bool drives_overlap() const { return false; }

  /// The entry of section Material without which the load does nothing, or nothing.
  virtual std::string lacking_entry(const MaterialOptions & /*material*/) const { return {}; }

  /// Whether it acts through tractions. Other loads give displacements or strains.
  bool acts_by_traction() const { return has_surface() && !moves_surface(); }
};

/// All kinds, in the order of the help. A program that uses the library may add others before it reads
/// parameters.
std::vector<const LoadKind *> &load_kinds();

/// A load as users declare it.
struct Load
{
  std::string name;
  const LoadKind *kind = nullptr;
  bool is_on_lower = false;                            ///< whether it acts on the second body
  std::vector<std::string> surfaces{};                 ///< of that body
  Eigen::Vector3d direction = Eigen::Vector3d::Zero(); ///< of length 1, in the axes of the scene

  /// "bulk: traction on x+ along x", as the entry has it.
  std::string text() const;

  bool operator==(const Load &other) const { return text() == other.text(); }
};

/// Reads a load. Returns what is allowed instead, or "".
std::string parse_load(const std::string &text, Load &load);

/// What the entry of loads allows, and the kinds with their helps, in sentences.
std::string allowed_loads();
std::string help_of_load_kinds();

/// Free strain of a body under the values of its loads, which are those of the whole scene. `is_lower` says
/// which body it is.
Strain free_strain(const std::vector<Load> &loads, const Eigen::VectorXd &values, bool is_lower,
                   const MaterialOptions &material);

/// The axis (0: x, 1: y, 2: z) along which the direction points, or 3.
unsigned int axis_of(const Eigen::Vector3d &direction);
} // namespace orthocone
