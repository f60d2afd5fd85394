// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/elasticity/axisymmetric_body.h>
#include <orthocone/elasticity/discretization.h>
#include <orthocone/elasticity/stiffness.h>
#include <orthocone/simulation/model_symmetry.h>

#include <string>
#include <variant>

namespace orthocone
{
/// Mesh and unknowns of the modelled part of the body, a solid or a section: all that --check needs.
class Body
{
public:
  Body(const Parameters &parameters, const ModelSymmetry &symmetry);

  const BodyUnknowns &unknowns() const;

  /// Entries of the stiffness on and below the diagonal.
  void make_pattern(dealii::SparsityPattern &pattern) const;
  Stiffness stiffness(const MaterialOptions &material) const;

  /// VTU text of a displacement of all degrees of freedom, mm.
  std::string vtu(const MaterialOptions &material, const Eigen::VectorXd &displacement) const;

private:
  struct Solid
  {
    Solid(const Parameters &parameters, const SymmetryPlanes &planes);
    BodyMesh mesh;
    Discretization discretization;
  };
  struct Section
  {
    explicit Section(const Parameters &parameters);
    SectionMesh mesh;
    SectionDiscretization discretization;
  };
  using Shape = std::variant<Solid, Section>;
  static Shape shape_of(const Parameters &parameters, const ModelSymmetry &symmetry);

  Shape shape_;
};
} // namespace orthocone
