// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The friction law of one node in one step, as two maps of the tangent plane that make it isotropic Coulomb
// friction with the coefficient 1 (docs/theory.md, section 1, "The circle"). With the reduced force
// r' = r'(r_t) and the reduced slip g = g(d_t) every law reads: |r'| <= r_n, and in slip r' = -r_n g/|g|.
// What solves, checks and reports a step knows this circle alone. Vectors are in local axes (normal, x, y);
// forces r (N) act from the plane on the body, displacements d (mm) are the body's, relative to the plane.
#pragma once

#include <orthocone/contact/law/elliptic_cone.h>

#include <memory>

namespace orthocone
{
/// The two maps of a law whose maps are not linear. Each is continuous, one-to-one and homogeneous of degree
/// one, and maps the plane to itself; derivatives are 2 x 2, and at 0, where there is none, any invertible
/// matrix. Implementations are constant once made, since the nodes of a surface share one, and throw nothing.
///
/// What a tribometer measures, the force f(a) per unit normal force against slip along -e(a), becomes
/// r' = r_t / R(b) and g = -|d_t| b'(a)^(-1/2) e(b(a)), where b(a) is the angle of f(a) and R(b) its length.
class TangentMaps
{
public:
  virtual ~TangentMaps() = default;

  /// r' of a tangential force, N, and d r' / d r_t.
  virtual Eigen::Vector2d reduced_force(const Eigen::Vector2d &force) const = 0;
  virtual Eigen::Matrix2d reduced_force_derivative(const Eigen::Vector2d &force) const = 0;
  /// The force that has this r'.
  virtual Eigen::Vector2d force(const Eigen::Vector2d &reduced) const = 0;

  /// g of a slip, mm, and d g / d d_t. The size of g is free: of the order of the slip divided by the
  /// coefficient of friction, as for the ellipse, iterations are as fast as there.
  virtual Eigen::Vector2d reduced_slip(const Eigen::Vector2d &slip) const = 0;
  virtual Eigen::Matrix2d reduced_slip_derivative(const Eigen::Vector2d &slip) const = 0;
  /// The slip that has this g.
  virtual Eigen::Vector2d slip(const Eigen::Vector2d &reduced) const = 0;
};

/// A law as a value. Two ellipses are the linear case, r' = r_t / mu and g = p^2 d_t / (mu max(p^2)), entry
/// by entry; they are kept in place, because a virtual call a node would cost the sweeps more than the map
/// does.
class FrictionLaw
{
public:
  FrictionLaw(const OrthotropicFriction &ellipse); // NOLINT(google-explicit-constructor): it is that law
  /// Throws std::invalid_argument unless the inverse maps are those of the others, which is looked at in many
  /// directions.
  explicit FrictionLaw(std::shared_ptr<const TangentMaps> maps);

  /// The two ellipses if the law consists of them, else nullptr: for formats and formulas of ellipses.
  const OrthotropicFriction *ellipse() const { return maps_ ? nullptr : &ellipse_; }

  /// The same law with all friction forces multiplied by a factor > 0. Directions of slip stay what they are.
  FrictionLaw scaled(double factor) const;

  /// Whether there is no friction. The maps do not exist then: reduced vectors are 0, and load() is infinite
  /// for every force but 0.
  bool is_frictionless() const { return !maps_ && ellipse_.mu_x == 0; }

  /// Whether both are one law: ellipses with the same semi-axes, or one pair of maps.
  bool is_same(const FrictionLaw &other) const
  {
    return maps_ == other.maps_ && factor_ == other.factor_ && ellipse_.mu() == other.ellipse_.mu() &&
           ellipse_.p() == other.ellipse_.p();
  }

  /// The maps: TangentMaps.
  Eigen::Vector2d reduced_force(const Eigen::Vector2d &force) const
  {
    if (maps_)
      return maps_->reduced_force(force) / factor_;
    return is_frictionless() ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(force.cwiseQuotient(mu_));
  }
  Eigen::Vector2d force(const Eigen::Vector2d &reduced) const
  {
    return maps_ ? Eigen::Vector2d(factor_ * maps_->force(reduced))
                 : Eigen::Vector2d(mu_.cwiseProduct(reduced));
  }
  Eigen::Vector2d reduced_slip(const Eigen::Vector2d &slip) const
  {
    return maps_ ? Eigen::Vector2d(maps_->reduced_slip(slip) / factor_)
                 : Eigen::Vector2d(slip_.cwiseProduct(slip));
  }
  Eigen::Vector2d slip(const Eigen::Vector2d &reduced) const
  {
    return maps_ ? Eigen::Vector2d(factor_ * maps_->slip(reduced))
                 : Eigen::Vector2d(reduced.cwiseQuotient(slip_));
  }

  /// d r_t / d r' where the force is `force`, and d g / d d_t.
  Eigen::Matrix2d force_derivative(const Eigen::Vector2d &force) const;
  Eigen::Matrix2d reduced_slip_derivative(const Eigen::Vector2d &slip) const;

  /// |r'|, N: the normal force at which a tangential force slips.
  double load(const Eigen::Vector2d &force) const;

  /// Tangential force on the body per unit normal force, in steady slip along a direction that is not 0 (a
  /// vector of any length).
  Eigen::Vector2d force_against(const Eigen::Vector2d &direction) const;

  /// Direction in which a node slips under a tangential force, not normalized: its g opposes r'.
  Eigen::Vector2d slip_under(const Eigen::Vector2d &force) const;

  /// Outward normal of the cone's section at a tangential force, not normalized: associated slip goes against
  /// it.
  Eigen::Vector2d cone_normal(const Eigen::Vector2d &force) const;

  /// Geometric mean over the force's directions (of the semi-axes of an ellipse), least and largest of the
  /// forces that slip per unit normal force, without units.
  double mean_friction() const { return mean_friction_; }
  double least_friction() const { return least_friction_; }
  double largest_friction() const { return largest_friction_; }

  /// How much more the law weights slip in one direction than in another: largest over least value of
  /// |r'(g(e))| over all directions e, which is that of (p/mu)^2 for ellipses. 1 without friction.
  double slip_amplification() const { return slip_amplification_; }

private:
  std::shared_ptr<const TangentMaps> maps_;
  double factor_ = 1; ///< on the forces of the maps, and 1 / factor_ on their reduced slips
  OrthotropicFriction ellipse_{0, 0, 1, 1};
  Eigen::Vector2d mu_ = Eigen::Vector2d::Zero(), slip_ = Eigen::Vector2d::Zero(); ///< diagonals of the maps
  double mean_friction_ = 0, least_friction_ = 0, largest_friction_ = 0, slip_amplification_ = 1;
};
} // namespace orthocone
