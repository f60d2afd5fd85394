// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/legs.h>

#include <cctype>
#include <numeric>
#include <set>
#include <sstream>

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

constexpr unsigned int most_points = 100000; // of all lines

std::array<double, 3> three_of(const std::vector<double> &numbers)
{
  return {{numbers[0], numbers[1], numbers[2]}};
}

/// The ends of a line: "x y z to x y z".
bool parse_ends(const std::string &text, Line &line)
{
  std::istringstream words(text);
  std::array<std::string, 2> ends;
  unsigned int end = 0;
  for (std::string word; words >> word;)
    if (word != "to")
      ends[end] += " " + word;
    else if (++end == ends.size())
      return false;
  const auto from = parse_numbers(trimmed(ends[0]), 3, ' '), to = parse_numbers(trimmed(ends[1]), 3, ' ');
  if (!from || !to || *from == *to)
    return false;
  line.from = three_of(*from);
  line.to = three_of(*to);
  return std::isfinite(line.length()) && line.length() > 0;
}

std::optional<Line> parse_line(const std::string &text)
{
  const auto parts = split(text, ':');
  if (parts.size() != 2 || !is_file_name(parts[0]))
    return std::nullopt;
  const auto course = split(parts[1], ',');
  Line line{parts[0]};
  if (course.size() != 2 || !parse_ends(course[0], line))
    return std::nullopt;
  const auto n_points = parse_count(course[1]);
  if (!n_points || *n_points < 2 || *n_points > most_points)
    return std::nullopt;
  line.n_points = *n_points;
  return line;
}

std::string print_place(const std::array<double, 3> &place)
{
  return to_text(place[0]) + " " + to_text(place[1]) + " " + to_text(place[2]);
}

/// Whether no two of probes, or of lines, have the same name.
template<typename Named>
bool have_own_names(const std::vector<Named> &all)
{
  std::set<std::string> names;
  return std::all_of(all.begin(), all.end(),
                     [&](const Named &named) { return names.insert(named.name).second; });
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
    if (probes && !have_own_names(*probes))
      probes.reset();
    return probes;
  };
  return codec;
}

Codec<std::vector<Line>> lines_codec()
{
  const auto print = [](const Line &line)
  {
    return line.name + ": " + print_place(line.from) + " to " + print_place(line.to) + ", " +
           std::to_string(line.n_points);
  };
  Codec<std::vector<Line>> codec = list_codec<Line>(
      "lines \"name: x y z to x y z, points\" (ends in mm that differ; 2 to 100000 points, those of all "
      "lines counted; name of up to 100 letters, digits, '-', '_', used once), separated by ';'",
      ';', "; ", parse_line, print);
  codec.parse = [parse = codec.parse](const std::string &text, std::string &instead)
  {
    auto lines = parse(text, instead);
    const auto add = [](const double sum, const Line &line) { return sum + line.n_points; };
    if (lines &&
        (!have_own_names(*lines) || std::accumulate(lines->begin(), lines->end(), 0., add) > most_points))
      lines.reset();
    return lines;
  };
  return codec;
}

void declare_checks(CheckOptions &checks, Section &section)
{
  const auto add = [&section](const char *const name, double &value, const std::string &help)
  { return &section.add(name, value, number_codec(positive), help).may_change_on_resume(); };
  const std::string times = " The bound is in multiples of Contact solver/Tolerance.";
  const std::string of_tolerance = "\u00d7 tolerance";
  add("Equilibrium", checks.equilibrium,
      "Bound of the forces in the body that contact forces do not balance, relative to the contact forces, "
      "and of the difference between the displacements of body and contact surface. This and the other "
      "checks judge the final state of each load step, and a state that exceeds a bound stops the run (exit "
      "code 3).");
  add("Penetration", checks.penetration,
      "Bound of the penetration: the largest negative gap, relative to the largest displacement or motion "
      "along z, whichever is smaller." +
          times)
      ->unit(of_tolerance);
  add("Complementarity", checks.complementarity,
      "Bound of the smaller one of gap and normal force of a node, each relative to its largest, because an "
      "open node carries no force." +
          times)
      ->unit(of_tolerance);
  add("Friction cone", checks.friction_cone,
      "Bound of how far a force lies outside of the friction cone: the largest ||r_t||_m - r_n relative to "
      "the largest force." +
          times)
      ->unit(of_tolerance);
  add("Slip rule", checks.slip_rule,
      "Bound of the change of slip, weighted with the normal force, that is not along the normal of the slip "
      "ellipse, or belongs to a force that is not on the friction cone." +
          times)
      ->unit(of_tolerance);
  add("Energy identity", checks.energy_identity,
      "Bound of the error of an energy balance that holds for load steps of any size: work of the held face "
      "minus change of elastic energy minus work of the mean contact forces, and dissipation that these "
      "cannot do, relative to the largest energy or work of a step so far.");
  add("Energy defect", checks.energy_defect,
      "Bound of the energy defect: work of the held face minus change of elastic energy minus dissipation in "
      "a step, relative to the largest energy or work of a step so far. The defect falls with the square of "
      "the step size. It is about 1 in a step within which all slip turns back, whose loop is not to be "
      "trusted, and above 0.05 the program warns.");
}

static void declare_lines(OutputOptions &output, const Codec<unsigned int> &interval, Section &section)
{
  section
      .add("Lines", output.lines, lines_codec(),
           "Straight lines in the bodies or on the contact surface, along which displacement and stress are "
           "written, and on the contact surface also its tractions and slip. The ends are places of the "
           "whole body, whichever part of it is meshed, and places below z = 0 lie in the lower body. Stress "
           "is computed in the element at the point, and is the mean of the elements that meet there.")
      .unit("(mm)")
      .may_grow_on_resume()
      .also_called({"path", "sample", "polyline"});
  section
      .add("Line fields", output.line_interval, interval,
           "Interval, in load steps, at which the fields along Lines are written; 0 = never.")
      .only_if({[&output] { return !output.lines.empty(); }, [] { return "no Output/Lines"; }})
      .may_change_on_resume();
}

void declare_output(OutputOptions &output, Section &section)
{
  const Codec<unsigned int> interval = count_codec(0, 1000000);
  section
      .add("Contact fields", output.contact_interval, interval,
           "Interval, in load steps, at which the fields on the contact surface are written; 0 = never.")
      .may_change_on_resume()
      .also_called({"vtu", "vtk"});
  section
      .add(
          "Volume fields", output.volume_interval, interval,
          "Interval, in load steps, at which displacement and stress in the bodies are written; 0 = never. A "
          "half-space without a mesh has no such fields.")
      .may_change_on_resume();
  section
      .add("Problems", output.problem_interval, interval,
           "Interval, in load steps, at which the contact problem is written with its solution, in FCLIB's "
           "format; 0 = never. If a step is not solved, its problem is written, too. The entry is for "
           "condensed solids, and for a program that was built with FCLIB.")
      .may_change_on_resume();
  section
      .add("Checkpoint", output.checkpoint_seconds, number_codec(NumberRange{0, 1e9, true, true}),
           "Least time in seconds between two checkpoints, from which --resume goes on; 0 = one after every "
           "step.")
      .unit("s")
      .may_change_on_resume();
  section
      .add("Probes", output.probes, probes_codec(),
           "Points of the contact surface whose history is written, each to probe-NAME.csv and at the "
           "contact node nearest to it.")
      .unit("(mm)")
      .may_grow_on_resume();
  declare_lines(output, interval, section);
}
} // namespace orthocone
