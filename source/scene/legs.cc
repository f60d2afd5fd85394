// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/legs.h>

#include <orthocone/base/units.h>
#include <orthocone/entries/names.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <sstream>

namespace orthocone
{
namespace
{
constexpr const char *leg_form =
    "legs \"ux uy uz : steps\" (numbers in mm, at least one step) or \"NAME value ... : steps\" (ux, uy, uz "
    "in "
    "mm, rx, ry, rz in degrees, Fx, Fy, Fz in N, Mx, My, Mz in N mm, or with a unit as in \"ux 10 um\"), "
    "separated by ';'; \"steps * parts\" solves each step in so many parts";

const std::vector<std::string> &component_names()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> all(motion_names.begin(), motion_names.end());
    all.insert(all.end(), wrench_names.begin(), wrench_names.end());
    return all;
  }();
  return names;
}

std::string unknown(const std::string &name, const std::vector<Load> &loads)
{
  std::vector<std::string> names = component_names();
  for (const Load &load : loads)
    names.push_back(load.name);
  std::string all;
  for (const std::string &known : names)
    all += (all.empty() ? "" : ", ") + known;
  const std::string nearest = nearest_name(name, names);
  return "a name of " + all + "; '" + shown(name) + "'" + remark(name) + " is none" +
         (nearest.empty() ? "" : ", is " + nearest + " meant?");
}

/// The fault of a component that is named again.
std::string named_twice(const std::string &name, const std::size_t component, const Drive &earlier)
{
  const std::string before = (earlier.by_force ? wrench_names : motion_names)[component];
  return "a component once in a leg; " +
         (name == before ? name + " is named twice" : before + " and " + name + " are the same component");
}

/// Whether a word names a component or a load.
bool is_name(const std::string &word, const std::vector<Load> &loads)
{
  const auto &names = component_names();
  return std::find(names.begin(), names.end(), word) != names.end() ||
         std::any_of(loads.begin(), loads.end(), [&](const Load &load) { return load.name == word; });
}

/// What is allowed instead of a unit that does not belong to the name, or of a word that is no unit.
std::string wrong_unit(const std::string &name, const std::string &unit, const std::vector<Load> &loads)
{
  const std::string quantity = quantity_of_unit(unit);
  if (!quantity.empty())
    return "for " + name + " a unit of " + units_like(unit_of(name, loads)) + "; " + unit + " is a unit of " +
           quantity;
  const std::string word = unit.substr(0, unit.find(' '));
  return parse_number(word) ? leg_form : unknown(word, loads);
}

/// Reads the value behind a name, perhaps with a unit, up to the next name. Returns what is allowed instead,
/// or
/// "".
std::string parse_value(const std::vector<std::string> &words, const std::string &name,
                        const std::vector<Load> &loads, std::size_t &next, double &value)
{
  const std::string number = next < words.size() ? words[next++] : "";
  std::string unit;
  for (; next < words.size() && !is_name(words[next], loads); ++next)
    unit += (unit.empty() ? "" : " ") + words[next];
  if (const auto found = parse_quantity(number + " " + unit, unit_of(name, loads)))
  {
    value = *found;
    return {};
  }
  return parse_number(number) ? wrong_unit(name, unit, loads) : leg_form;
}

/// Reads "ux uy uz" or "NAME value ...". Returns what is allowed instead, or "".
std::string parse_targets(const std::string &text, const std::vector<Load> &loads, Leg &leg)
{
  if (const auto position = parse_numbers(text, 3, ' '))
  {
    leg.targets = move_to((*position)[0], (*position)[1], (*position)[2], leg.steps).targets;
    return {};
  }
  std::istringstream stream(text);
  const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
  if (words.size() < 2)
    return leg_form;
  for (std::size_t next = 0; next < words.size();)
  {
    const std::string &name = words[next++];
    if (!is_name(name, loads))
      return std::isalpha(static_cast<unsigned char>(name[0])) != 0 ? unknown(name, loads) : leg_form;
    double value = 0;
    if (const std::string fault = parse_value(words, name, loads, next, value); !fault.empty())
      return fault;
    if (const std::string fault = set_target(name, value, loads, leg); !fault.empty())
      return fault;
  }
  return {};
}

/// Reads "steps" or "steps * parts", neither of them 0. Returns whether the text has this form.
bool parse_steps(const std::string &text, Leg &leg)
{
  const std::size_t times = text.find('*');
  const auto steps = parse_count(trimmed(text.substr(0, times)));
  const auto parts = times == std::string::npos ? std::optional<unsigned int>(1)
                                                : parse_count(trimmed(text.substr(times + 1)));
  if (!steps || !parts || *steps == 0 || *parts == 0)
    return false;
  leg.steps = *steps;
  leg.parts = *parts;
  return true;
}

/// Reads a leg. Returns what is allowed instead, or "".
std::string parse_leg(const std::string &text, const std::vector<Load> &loads, Leg &leg)
{
  const auto halves = split(text, ':');
  if (halves.size() != 2 || !parse_steps(halves[1], leg))
    return leg_form;
  return parse_targets(halves[0], loads, leg);
}

/// Whether the leg consists of three plain numbers.
bool is_translation(const Leg &leg)
{
  if (!leg.loads.empty())
    return false;
  const auto has_motion = [&](const unsigned int i) { return leg.motion(i).has_value(); };
  return has_motion(0) && has_motion(1) && has_motion(2) && !leg.targets[3] && !leg.targets[4] &&
         !leg.targets[5];
}

std::string leg_text(const Leg &leg)
{
  std::string text;
  for (unsigned int i = 0; i < n_rigid_components; ++i)
    if (const auto &target = leg.targets[i])
      text += (is_translation(leg) ? ""
                                   : std::string((target->by_force ? wrench_names : motion_names)[i]) + " ") +
              to_text(target->value) + " ";
  for (const auto &[name, value] : leg.loads)
    text += name + " " + to_text(value) + " ";
  text += ": " + std::to_string(leg.steps);
  return leg.parts > 1 ? text + " * " + std::to_string(leg.parts) : text;
}
} // namespace

std::string unit_of(const std::string &name, const std::vector<Load> &loads)
{
  for (const Load &load : loads)
    if (load.name == name)
      return load.kind->unit();
  return name[0] == 'u' ? "mm" : name[0] == 'r' ? "degrees" : name[0] == 'F' ? "N" : "N mm";
}

std::string set_target(const std::string &name, const double value, const std::vector<Load> &loads, Leg &leg)
{
  if (std::any_of(loads.begin(), loads.end(), [&](const Load &load) { return load.name == name; }))
  {
    if (leg.load(name))
      return "a load once in a leg; " + name + " is named twice";
    leg.loads.emplace_back(name, value);
    return {};
  }
  const auto &names = component_names();
  const auto place = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  if (place == names.size())
    return unknown(name, loads);
  const std::size_t component = place % n_rigid_components;
  if (const auto &earlier = leg.targets[component])
    return named_twice(name, component, *earlier);
  leg.targets[component] = Drive{place >= n_rigid_components, value};
  return {};
}

Codec<std::vector<Load>> loads_codec()
{
  Codec<std::vector<Load>> codec =
      list_codec<Load>(allowed_loads(), ';', " ; ", {}, [](const Load &load) { return load.text(); });
  codec.parse = [](const std::string &text, std::string &instead) -> std::optional<std::vector<Load>>
  {
    std::vector<Load> loads;
    for (const auto &piece : trimmed(text).empty() ? std::vector<std::string>() : split(text, ';'))
    {
      Load load;
      std::string fault = parse_load(piece, load);
      const auto has_name = [&](const Load &other) { return other.name == load.name; };
      std::vector<std::string> taken = component_names();
      // Columns of history.csv without a '_', which names of loads do not have.
      taken.insert(taken.end(), {"time", "cycle", "step", "phase", "dissipation", "method", "iterations",
                                 "residual", "driven"});
      if (fault.empty() && std::find(taken.begin(), taken.end(), load.name) != taken.end())
        fault = "a name that legs and tables do not use otherwise, as they use '" + load.name + "'";
      if (fault.empty() && std::any_of(loads.begin(), loads.end(), has_name))
        fault = "each name once; '" + load.name + "' is there twice";
      if (!fault.empty())
      {
        instead = fault;
        return std::nullopt;
      }
      loads.push_back(load);
    }
    return loads;
  };
  return codec;
}

Codec<std::vector<Leg>> legs_codec(const std::vector<Load> &loads)
{
  Codec<std::vector<Leg>> codec = list_codec<Leg>(leg_form, ';', "; ", {}, leg_text);
  codec.parse = [&loads](const std::string &text, std::string &instead) -> std::optional<std::vector<Leg>>
  {
    std::vector<Leg> legs;
    if (trimmed(text).empty())
      return legs;
    for (const auto &piece : split(text, ';'))
    {
      Leg leg;
      if (const std::string fault = parse_leg(piece, loads, leg); !fault.empty())
      {
        instead = fault;
        return std::nullopt;
      }
      legs.push_back(leg);
    }
    return legs;
  };
  return codec;
}
} // namespace orthocone
