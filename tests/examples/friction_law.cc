// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Worked example of docs/extending.md: a friction law that is no pair of ellipses, here a superelliptic cone
// with slip along the friction force.
#include "folder_of_files.h"
#include "results/scenes.h"

#include <orthocone/scene/model_choice.h>
#include <orthocone/scene/parameters.h>

namespace orthocone::test
{
namespace
{
using Eigen::Matrix2d;
using Eigen::Vector2d;

/// The cone ||r_t|| <= r_n with ||r_t||^n = |r_x/mu_x|^n + |r_y/mu_y|^n. Its reduced force is r_t ||r_t|| /
/// |r_t|; slip along the force needs a reduced slip along the slip.
class Superellipse : public TangentMaps
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

/// The kind `superellipse`, with three entries of its own in section Friction.
class SuperellipseOptions : public FrictionLawOptions
{
public:
  std::unique_ptr<FrictionLawOptions> clone() const override
  {
    return std::make_unique<SuperellipseOptions>(*this);
  }

  void declare(Section &section, const Condition &is_chosen) override
  {
    section.add("First friction", mu_x_, number_codec(positive), "mu along the first axis.")
        .only_if(is_chosen);
    section.add("Second friction", mu_y_, number_codec(positive), "mu along the second axis.")
        .only_if(is_chosen);
    section.add("Exponent", exponent_, number_codec(NumberRange{1, 20}), "2: an ellipse.").only_if(is_chosen);
  }

  FrictionLaw law(const FrictionOptions &, const Vector2d &) const override
  {
    return FrictionLaw(std::make_shared<const Superellipse>(Vector2d(mu_x_, mu_y_), exponent_));
  }

private:
  double mu_x_ = 0.3;
  double mu_y_ = 0.15;
  double exponent_ = 4;
};

/// A program adds its own kinds before it reads parameters.
const bool has_superellipse = []
{
  kinds_of<FrictionLawOptions>().push_back(
      {"superellipse", "a superelliptic cone", [] { return std::make_unique<SuperellipseOptions>(); }});
  return true;
}();

/// The small scene under a press and an oblique motion, with these entries of section Friction.
Parameters scene_with(const std::string &entries)
{
  const Folder folder;
  Parameters parameters = small_scene();
  parameters.friction =
      read_parameters(folder.write("law.prm", "subsection Friction\n" + entries + "end\n")).friction;
  parameters.load.legs = {move_to(0, 0, -0.1, 2), move_to(0.03, 0.02, -0.1, 4)};
  return parameters;
}
} // namespace

// With the exponent 2 the cone is an ellipse, and slip is along the force.
TEST(ExampleFrictionLaw, IsAnEllipseWithTheExponentTwo)
{
  ASSERT_TRUE(has_superellipse);
  TestScene ellipse(scene_with("  set Coefficients = 0.3, 0.15\n  set Slip potential = collinear\n"));
  TestScene superellipse(scene_with("  set Law = superellipse\n  set Exponent = 2\n"));
  ellipse.march();
  superellipse.march();
  EXPECT_LT(largest_difference(superellipse.state.force, ellipse.state.force), closeness);
}

// Where a node slips its force is on the cone, against the slip; where it sticks it is inside.
TEST(ExampleFrictionLaw, HoldsAtEveryNodeOfEveryStep)
{
  TestScene scene(scene_with("  set Law = superellipse\n  set First friction = 0.2\n  set Exponent = 5\n"));
  unsigned int n_slipping = 0, n_stuck = 0;
  const Vector2d mu(0.2, 0.15);
  scene.march(
      [&](const ContactState &before, const ContactState &after, const LoadStep &)
      {
        const NodeVector change = after.displacement - before.displacement;
        for (Eigen::Index node = 0; node < after.n_nodes(); ++node)
        {
          const Eigen::Vector3d force = after.force.segment<3>(3 * node);
          const Vector2d slip = change.segment<2>(3 * node + 1);
          if (after.status[static_cast<std::size_t>(node)] == NodeStatus::open)
            continue;
          const double load = std::pow(force.tail<2>().cwiseQuotient(mu).array().abs().pow(5).sum(), 0.2);
          EXPECT_LE(load, force[0] * (1 + closeness));
          const bool slips = slip.norm() > 1e-5;
          ++(slips ? n_slipping : n_stuck);
          EXPECT_TRUE(!slips || std::abs(load / force[0] - 1) < 1e-6) << load << " of " << force[0];
          EXPECT_TRUE(!slips || force.tail<2>().normalized().dot(slip.normalized()) < -1 + 1e-6);
        }
      });
  EXPECT_GT(n_slipping, 10u);
  EXPECT_GT(n_stuck, 5u);
}

TEST(ExampleFrictionLaw, HasEntriesThatAreReadIgnoredAndRefusedAsAllOthers)
{
  const Folder folder;
  const std::string file =
      folder.write("law.prm", "subsection Friction\n  set Law = superellipse\n  set Slip potential = 1, 2\n"
                              "end\n");
  const auto warnings = parameter_warnings(read_parameters(file));
  EXPECT_EQ(std::count(warnings.begin(), warnings.end(),
                       "Friction/Slip potential = 1, 2 is ignored with Friction/Law = superellipse"),
            1);
  EXPECT_THROW(read_parameters(file, {"Friction/Exponent=0.5"}), InputError);
  EXPECT_THROW(read_parameters(file, {"Friction/Law=rosette"}), InputError);
  EXPECT_THROW(check_parameters(read_parameters(file, {"Contact solver/Method=feng2006"})), InputError);
}

// Its own axes are planes of symmetry; turned by 30 degrees they are those of the body no more.
TEST(ExampleFrictionLaw, HasTheMirrorsThatItsForcesHave)
{
  const std::string law = "  set Law = superellipse\n";
  const auto model = [](const std::string &entries)
  {
    Parameters parameters = scene_with(entries);
    parameters.load.legs = {move_to(0, 0, -0.1, 2)};
    return choose_model(parameters).symmetry.name();
  };
  EXPECT_EQ(model(law), "quarter");
  EXPECT_EQ(model(law + "  set Orthotropy angle = 90\n"), "quarter");
  EXPECT_EQ(model(law + "  set Orthotropy angle = 30\n"), "full");
}
} // namespace orthocone::test
