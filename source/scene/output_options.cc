// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/legs.h>

#include <cctype>
#include <set>

namespace orthocone
{
namespace
{
bool is_file_name(const std::string &name)
{
  constexpr std::size_t longest = 100; // file systems allow 255, including what is added in front and behind
  return !name.empty() && name.size() <= longest &&
         std::all_of(name.begin(), name.end(),
                     [](const unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
}

std::optional<Probe> parse_probe(const std::string &text)
{
  const auto parts = split(text, ':');
  if (parts.size() != 2 || !is_file_name(parts[0]))
    return std::nullopt;
  const auto position = parse_numbers(parts[1], 2, ' ');
  return position ? std::optional<Probe>({parts[0], {{(*position)[0], (*position)[1]}}}) : std::nullopt;
}
} // namespace

Codec<std::vector<Probe>> probes_codec()
{
  const auto print = [](const Probe &probe)
  { return probe.name + ": " + to_text(probe.position[0]) + " " + to_text(probe.position[1]); };
  Codec<std::vector<Probe>> codec = list_codec<Probe>(
      "probes \"name: x y\" (numbers in mm; name of up to 100 letters, digits, '-', '_', used "
      "once), separated "
      "by ';'",
      ';', "; ", parse_probe, print);
  codec.parse = [parse = codec.parse](const std::string &text, std::string &instead)
  {
    auto probes = parse(text, instead);
    std::set<std::string> names;
    if (probes && !std::all_of(probes->begin(), probes->end(),
                               [&](const Probe &probe) { return names.insert(probe.name).second; }))
      probes.reset();
    return probes;
  };
  return codec;
}

void declare_checks(CheckOptions &checks, Section &section)
{
  const auto add = [&section](const char *const name, double &value, const std::string &help)
  { return &section.add(name, value, number_codec(positive), help).may_change_on_resume(); };
  const std::string times = " Bound in multiples of Contact solver/Tolerance.";
  const std::string of_tolerance = "\u00d7 tolerance";
  add("Equilibrium", checks.equilibrium,
      "Every step is checked from its final state; one that exceeds a bound stops the run (exit code 3). "
      "Bound of the forces in the body that contact forces do not balance, relative to these, and of the "
      "difference between the displacements of body and contact surface.");
  add("Penetration", checks.penetration, "Largest negative gap relative to the largest displacement." + times)
      ->unit(of_tolerance);
  add("Complementarity", checks.complementarity,
      "Gap and normal force, each relative to its largest: the smaller of both must vanish." + times)
      ->unit(of_tolerance);
  add("Friction cone", checks.friction_cone, "Largest ||r_t||_m - r_n relative to the largest force." + times)
      ->unit(of_tolerance);
  add("Slip rule", checks.slip_rule,
      "Change of slip that is not along the normal of the slip ellipse, or not on the cone, weighted with "
      "the normal force." +
          times)
      ->unit(of_tolerance);
  add("Energy identity", checks.energy_identity,
      "Work of the upper face minus change of elastic energy minus work of the mean contact forces, and "
      "dissipation that these cannot do, relative to the largest energy or work of a step so far. It holds "
      "for steps of any size.");
  add("Energy defect", checks.energy_defect,
      "Work of the upper face minus change of elastic energy minus dissipation in a step, relative to the "
      "largest energy or work of a step so far. It falls with the square of the steps: a step in which all "
      "slips back reaches 1, and its loop is not to be trusted; above 0.05 there is a warning.");
}

void declare_output(OutputOptions &output, Section &section)
{
  const Codec<unsigned int> interval = count_codec(0, 1000000);
  section
      .add("Contact fields", output.contact_interval, interval,
           "Every how many steps the fields on the contact surface are written; 0 = never.")
      .may_change_on_resume()
      .also_called({"vtu", "vtk"});
  section
      .add("Volume fields", output.volume_interval, interval,
           "Every how many steps displacement and stress of the body are written; 0 = never.")
      .may_change_on_resume();
  section
      .add("Problems", output.problem_interval, interval,
           "Every how many steps the contact problem is written with its solution, in FCLIB's format; 0 = "
           "never. A step that is not solved leaves its problem, too. For condensed solids, and a program "
           "that was built with FCLIB.")
      .may_change_on_resume();
  section
      .add("Checkpoint", output.checkpoint_seconds, number_codec(NumberRange{0, 1e9, true, true}),
           "Least seconds between two checkpoints, from which --resume goes on; 0 = one after every step.")
      .unit("s")
      .may_change_on_resume();
  section
      .add("Probes", output.probes, probes_codec(),
           "Points of the contact surface whose history is written; the nearest contact node is taken.")
      .unit("(mm)")
      .may_grow_on_resume();
}
} // namespace orthocone
