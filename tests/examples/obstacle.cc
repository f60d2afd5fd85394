// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Worked example of docs/extending.md: an obstacle that no expression describes well, here a row of rounded
// bars along y.
#include "folder_of_files.h"
#include "results/scenes.h"

#include <orthocone/scene/obstacle.h>
#include <orthocone/scene/parameters.h>

namespace orthocone::test
{
namespace
{
class Bars : public Obstacle
{
public:
  Bars(const double pitch, const double radius)
      : pitch_(pitch),
        radius_(radius)
  {
  }

  double gap(const Eigen::Vector2d &place) const override
  {
    const double from_bar = std::remainder(place[0], pitch_);
    return from_bar * from_bar / (2 * radius_);
  }

  void check(const std::vector<Eigen::Vector2d> &) const override {} // there is a gap everywhere

private:
  double pitch_;  ///< mm
  double radius_; ///< mm
};

/// The kind `bars`, with two entries of its own in section Obstacle.
class BarsOptions : public ObstacleKindOptions
{
public:
  std::unique_ptr<ObstacleKindOptions> clone() const override { return std::make_unique<BarsOptions>(*this); }

  void declare(Section &section, const Condition &is_chosen) override
  {
    section.add("Pitch", pitch_, number_codec(positive), "Distance of the bars in mm.").only_if(is_chosen);
    section.add("Bar radius", radius_, number_codec(positive), "Their radius in mm.").only_if(is_chosen);
  }

  std::unique_ptr<const Obstacle> make(const ObstacleOptions &,
                                       std::unique_ptr<const Obstacle>) const override
  {
    return std::make_unique<Bars>(pitch_, radius_);
  }

private:
  double pitch_ = 5;
  double radius_ = 50;
};

/// A program adds its own kinds before it reads parameters.
const bool is_added = []
{
  kinds_of<ObstacleKindOptions>().push_back(
      {"bars", "a row of rounded bars along y", [] { return std::make_unique<BarsOptions>(); }});
  return true;
}();
} // namespace

// One bar in the middle, two at the sides: contact lies along three lines.
TEST(ExampleObstacle, CarriesTheBodyOnItsBars)
{
  ASSERT_TRUE(is_added);
  const Folder folder;
  Parameters parameters = small_scene();
  parameters.obstacle = read_parameters(folder.write("bars.prm", "subsection Obstacle\n  set Kind = bars\n"
                                                                 "  set Pitch = 8\nend\n"))
                            .obstacle;
  parameters.geometry.shape = BodyShape::box;
  parameters.geometry.sizes = {{20, 10, 10}};
  parameters.mesh.cells = {{16, 4, 4}};
  parameters.mesh.model = ModelKind::quarter;
  EXPECT_FALSE(parameters.obstacle.is_plane());
  const Scene scene(parameters, choose_model(parameters));
  StepSolver solver(scene);
  ContactState state(scene.gaps());
  const LoadStep step = LoadProgram(parameters.load).steps().front();
  ASSERT_TRUE(solver.solve(state, step).converged);
  const ContactFieldEvaluator evaluator(scene);
  for (unsigned int node = 0; node < scene.surface().nodes.size(); ++node)
  {
    const double x = scene.surface().nodes[node].position[0];
    const double from_bar = std::abs(std::remainder(x, 8));
    const ContactFields fields = evaluator.fields(state, node);
    EXPECT_TRUE(from_bar > 1e-9 || fields.pressure > 0) << "on a bar, x = " << x;
    EXPECT_TRUE(from_bar <= 2 || fields.gap > 0) << "between bars, x = " << x;
  }
}

TEST(ExampleObstacle, HasEntriesThatAreReadPrintedAndIgnoredAsAllOthers)
{
  const Folder folder;
  const std::string file = folder.write("bars.prm", "subsection Obstacle\n  set Bar radius = 70\nend\n");
  const Parameters parameters = read_parameters(file);
  EXPECT_EQ(entry_text(parameters, "Obstacle/Bar radius"), "Obstacle/Bar radius = 70");
  const auto warnings = parameter_warnings(parameters);
  EXPECT_EQ(std::count(warnings.begin(), warnings.end(),
                       "Obstacle/Bar radius = 70 is ignored with Obstacle/Kind = rigid"),
            1);
  EXPECT_THROW(read_parameters(file, {"Obstacle/Pitch=0"}), InputError);
  EXPECT_THROW(read_parameters(file, {"Obstacle/Kind=rods"}), InputError);
}
} // namespace orthocone::test
