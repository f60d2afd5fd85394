// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/body/shapes/shape.h>

#include <functional>
#include <optional>

namespace orthocone
{
/// A kind of shape: its entries, what is to be checked of them, and how sentences speak of it. A new shape is
/// a file that defines a kind and a class derived from Shape, and a line in shape_kinds().
class ShapeKind
{
public:
  virtual ~ShapeKind() = default;

  virtual BodyShape shape() const = 0;

  /// Whether the body is meshed. Otherwise it is a half-space: its far field is the held face, and `make`
  /// knows sizes alone.
  virtual bool is_meshed() const { return true; }

  /// A kind whose entries it has, too; without one it is the kind itself.
  virtual const ShapeKind &kind_of_entries() const { return *this; }

  /// Adds the entries of its outline to Geometry; they count where `is_chosen` holds.
  virtual void declare(GeometryOptions &geometry, const Condition &is_chosen, Section &section) const = 0;

  /// Adds the entries of its cells to Mesh; they count where `is_chosen` holds.
  virtual void declare_cells(MeshOptions &, const Condition & /*is_chosen*/, Section &) const {}

  /// Whether its cells lie in layers from the base to the held face.
  virtual bool has_layers() const { return true; }

  /// Throws InputError where its entries contradict each other, and FileError for a file that cannot be read.
  virtual void check(const BodyOptions &body) const = 0;

  /// Names of its surfaces, first the base and then the held one; none for a file.
  virtual std::vector<std::string> surfaces(const GeometryOptions &) const { return {}; }

  /// What chooses the mesh where neither Resolution nor Accuracy can, a clause; "" where they can.
  virtual std::string chooser_of_mesh() const { return {}; }

  /// Whether the program knows sizes of the body before it has meshed it, so that the next functions count.
  virtual bool has_known_sizes() const { return true; }

  /// Distance of the held face from the base, mm.
  virtual double held_height(const GeometryOptions &) const { return 0; }

  /// Thickness (mm) in plane strain, and the entry that has it; nothing where the shape has no such section.
  struct Thickness
  {
    double value;
    std::string entry;
  };
  virtual std::optional<Thickness> thickness(const GeometryOptions &) const { return std::nullopt; }

  /// Whether a place (mm) is on the base, and which places are, in words.
  virtual bool is_on_base(const GeometryOptions &, const std::array<double, 2> & /*place*/) const
  {
    return true;
  }
  virtual std::string base_in_words(const GeometryOptions &) const { return {}; }

  /// Half the widest and half the narrowest width of the base, mm.
  virtual std::array<double, 2> half_widths(const GeometryOptions &) const { return {}; }

  /// The entry of its height, as messages name it.
  virtual std::string height_entry(const GeometryOptions &) const { return {}; }

  /// Height of the layer of cells at the base before Refinements, mm; 0 where there are no layers.
  virtual double base_layer(const BodyOptions &) const { return 0; }

  /// Size of the largest elements at the rim of the base, before Refinements, relative to `rim_unit()`.
  virtual double rim_size(const BodyOptions &) const { return 0; }
  virtual std::string rim_unit() const { return {}; }
  virtual std::string finer_rim() const { return {}; } ///< the entries that make them smaller

  /// What makes the cells smaller anywhere on the base, in terms of its entries.
  virtual std::string finer_cells(const BodyOptions &body) const = 0;

  /// "box, 20 x 20 x 10 mm".
  virtual std::string describe(const GeometryOptions &geometry) const = 0;

  /// Throws as the shape's own class does.
  virtual std::unique_ptr<Shape> make(const GeometryOptions &geometry, const MeshOptions &mesh) const = 0;
};

/// All kinds of shape, in the order of their words.
const std::vector<const ShapeKind *> &shape_kinds();

const ShapeKind &kind_of(const GeometryOptions &geometry);

/// Holds where `holds` does for the kind of shape that is chosen; `geometry` must outlive it.
Condition where_shape(const GeometryOptions &geometry, const std::function<bool(const ShapeKind &)> &holds);

/// Holds where the shape that is chosen has the entries of this kind.
Condition where_entries_of(const GeometryOptions &geometry, const ShapeKind &kind);

/// The warning of elements that are too coarse at the rim of the base; empty where they are not, or nothing
/// is known of the rim's mesh.
std::string coarse_rim_warning(const BodyOptions &body);

/// Throws InputError where cells are graded so steeply that one of `n_graded` has less than 1e-6 of their
/// common thickness; `what` completes the sentence.
void check_grading(const std::string &entry, double grading, unsigned int n_graded, const std::string &what);

/// The same of layers, which are graded to both ends.
void check_layers(const MeshOptions &mesh, unsigned int n);
} // namespace orthocone
