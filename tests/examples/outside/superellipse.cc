// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// A program with a friction law of its own, which is no pair of ellipses: a superelliptic cone with slip
// along the friction force.
#include <orthocone/app/program.h>
#include <orthocone/scene/options.h>

#include <cmath>

namespace
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

/// The cone ||r_t|| <= r_n with ||r_t||^n = |r_x/mu_x|^n + |r_y/mu_y|^n. Its reduced force is r_t ||r_t|| /
/// |r_t|; slip along the force needs a reduced slip along the slip.
class Superellipse : public orthocone::TangentMaps
{
public:
  Superellipse(const Vector2d &mu, const double exponent)
      : mu_(mu),
        exponent_(exponent),
        mean_(std::sqrt(mu[0] * mu[1]))
  {
  }

  Vector2d reduced_force(const Vector2d &force) const override
  {
    return force.isZero(0) ? force : Vector2d(ratio(force) * force);
  }
  Matrix2d reduced_force_derivative(const Vector2d &force) const override
  {
    if (force.isZero(0))
      return Matrix2d::Identity() / mean_;
    const double size = norm(force);
    const Vector2d slope_of_norm = (force.cwiseQuotient(mu_) / size).array().abs().pow(exponent_ - 1) *
                                   force.array().sign() / mu_.array();
    const Vector2d slope = slope_of_norm / force.norm() - ratio(force) * force / force.squaredNorm();
    return ratio(force) * Matrix2d::Identity() + force * slope.transpose();
  }
  Vector2d force(const Vector2d &reduced) const override
  {
    return reduced.isZero(0) ? reduced : Vector2d(reduced / ratio(reduced));
  }
  Vector2d reduced_slip(const Vector2d &slip) const override { return mean_ * slip; }
  Matrix2d reduced_slip_derivative(const Vector2d &) const override { return mean_ * Matrix2d::Identity(); }
  Vector2d slip(const Vector2d &reduced) const override { return reduced / mean_; }

private:
  double norm(const Vector2d &force) const
  {
    return std::pow(force.cwiseQuotient(mu_).array().abs().pow(exponent_).sum(), 1 / exponent_);
  }
  double ratio(const Vector2d &force) const { return norm(force) / force.norm(); }

  const Vector2d mu_;
  const double exponent_;
  const double mean_; ///< gives slip the size that the ellipse gives it
};

class SuperellipseOptions : public orthocone::FrictionLawOptions
{
public:
  std::unique_ptr<FrictionLawOptions> clone() const override
  {
    return std::make_unique<SuperellipseOptions>(*this);
  }

  void declare(orthocone::Section &section, const orthocone::Condition &is_chosen) override
  {
    section
        .add("First friction", mu_x_, orthocone::number_codec(orthocone::positive),
             "mu along the first axis.")
        .only_if(is_chosen);
    section
        .add("Second friction", mu_y_, orthocone::number_codec(orthocone::positive),
             "mu along the second axis.")
        .only_if(is_chosen);
    section
        .add("Exponent", exponent_, orthocone::number_codec(orthocone::NumberRange{1, 20}), "2: an ellipse.")
        .only_if(is_chosen);
  }

  orthocone::FrictionLaw law(const orthocone::FrictionOptions &, const Eigen::Vector3d &) const override
  {
    return orthocone::FrictionLaw(std::make_shared<const Superellipse>(Vector2d(mu_x_, mu_y_), exponent_));
  }

private:
  double mu_x_ = 0.3;
  double mu_y_ = 0.15;
  double exponent_ = 4;
};
} // namespace

int main(const int argc, const char *const *const argv)
{
  orthocone::kinds_of<orthocone::FrictionLawOptions>().push_back(
      {"superellipse", "friction forces stay within a superelliptic cone, and slip is along the force",
       [] { return std::make_unique<SuperellipseOptions>(); }});
  orthocone::run_program(argc, argv);
}
