// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/options.h>

namespace orthocone
{
namespace
{
using Pair = std::array<Expression, 2>;

constexpr const char *associated = "associated";
constexpr const char *collinear = "collinear";

/// The pieces between commas outside parentheses.
std::vector<std::string> arguments(const std::string &text)
{
  std::vector<std::string> pieces(1);
  int depth = 0;
  for (const char c : text)
  {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && depth <= 0)
      pieces.emplace_back();
    else
      pieces.back() += c;
  }
  std::transform(pieces.begin(), pieces.end(), pieces.begin(), trimmed);
  return pieces;
}

/// Reads two expressions. Constant ones must be > 0, or both 0 if `may_be_none`.
std::optional<Pair> parse_pair(const std::string &text, const bool may_be_none)
{
  const auto pieces = arguments(text);
  if (pieces.size() != 2 || !fault_in_expressions(pieces).empty())
    return std::nullopt;
  const Pair pair{{Expression(pieces[0]), Expression(pieces[1])}};
  const auto is_none = [](const Expression &e) { return e.is_constant() && e.value(0, 0) == 0; };
  const auto is_fine = [](const Expression &e)
  { return !e.is_constant() || positive.contains(e.value(0, 0)); };
  const bool is_allowed =
      (may_be_none && is_none(pair[0]) && is_none(pair[1])) || (is_fine(pair[0]) && is_fine(pair[1]));
  return is_allowed ? std::optional<Pair>(pair) : std::nullopt;
}

/// Describes the limit that no scene reaches, if a number of the text is beyond it, and the fault in the
/// text.
std::string describe_pair(const std::string &text, const std::string &behind_range)
{
  const auto pieces = arguments(text);
  std::string range = positive.describe();
  for (const std::string &piece : pieces)
    if (const std::string more = positive.describe_for(piece);
        parse_number(piece) && more.size() > range.size())
      range = more;
  return "two numbers" + range + behind_range + (pieces.size() == 2 ? fault_in_expressions(pieces) : "");
}

template<typename Numbers>
void assign(const Pair &pair, Numbers &numbers, std::optional<Pair> &varying)
{
  numbers = std::array<double, 2>{{pair[0].value(0, 0), pair[1].value(0, 0)}};
  varying = pair[0].is_constant() && pair[1].is_constant() ? std::nullopt : std::optional<Pair>(pair);
}

std::string pair_text(const std::array<double, 2> &pair, const std::optional<Pair> &varying)
{
  return varying ? (*varying)[0].text() + ", " + (*varying)[1].text()
                 : to_text(pair[0]) + ", " + to_text(pair[1]);
}

void assign_slip_potential(const std::string &text, FrictionOptions &friction)
{
  friction.slip_potential = std::nullopt;
  friction.varying_slip_potential = std::nullopt;
  friction.is_collinear_by_word = text == collinear;
  if (text != collinear && text != associated)
    assign(*parse_pair(text, false), friction.slip_potential, friction.varying_slip_potential);
}

/// Semi-axes of the friction ellipse, numbers or expressions: both positive, or both 0.
Entry::Binding coefficients_binding(FrictionOptions &friction)
{
  const auto allowed = [](const std::string &text)
  {
    return describe_pair(text,
                         " (or both 0: no friction) separated by a comma, or expressions of x, y and z");
  };
  return {allowed("1, 1"),
          [&friction, allowed](const std::string &text, std::string &instead)
          {
            instead = allowed(text);
            const auto pair = parse_pair(text, true);
            if (pair)
              assign(*pair, friction.mu, friction.varying_mu);
            return pair.has_value();
          },
          [&friction] { return pair_text(friction.mu, friction.varying_mu); }};
}

/// Semi-axes of the slip ellipse, numbers or expressions, or a word.
Entry::Binding slip_potential_binding(FrictionOptions &friction)
{
  const auto allowed = [](const std::string &text)
  {
    return "associated, or " +
           describe_pair(text, " separated by a comma, or collinear, or expressions of x, y and z");
  };
  return {allowed("1, 1"),
          [&friction, allowed](const std::string &text, std::string &instead)
          {
            instead = allowed(text);
            const bool is_allowed =
                text == associated || text == collinear || parse_pair(text, false).has_value();
            if (is_allowed)
              assign_slip_potential(text, friction);
            return is_allowed;
          },
          [&friction]
          {
            return friction.is_collinear_by_word ? collinear
                   : friction.slip_potential
                       ? pair_text(*friction.slip_potential, friction.varying_slip_potential)
                       : associated;
          }};
}

/// Angle of both ellipses in degrees, a number or an expression.
Entry::Binding angle_binding(FrictionOptions &friction)
{
  const Codec<Expression> codec = expression_codec(NumberRange{-360, 360, true, true});
  return {codec.allowed,
          [&friction, codec](const std::string &text, std::string &instead)
          {
            const auto angle = codec.parse(text, instead);
            if (!angle)
              return false;
            friction.angle = angle->value(0, 0);
            friction.varying_angle = angle->is_constant() ? std::nullopt : angle;
            return true;
          },
          [&friction]
          { return friction.varying_angle ? friction.varying_angle->text() : to_text(friction.angle); }};
}
/// A direction, three expressions, or nothing.
Entry::Binding first_axis_binding(FrictionOptions &friction)
{
  return {"three expressions of x, y and z separated by commas, which are not all 0, or nothing",
          [&friction](const std::string &text, std::string &instead)
          {
            friction.first_axis = std::nullopt;
            if (text.empty())
              return true;
            const auto pieces = arguments(text);
            if (const std::string fault = fault_in_expressions(pieces); pieces.size() != 3 || !fault.empty())
            {
              instead += pieces.size() == 3 ? fault : "";
              return false;
            }
            const std::array<Expression, 3> axis{
                {Expression(pieces[0]), Expression(pieces[1]), Expression(pieces[2])}};
            const bool is_zero =
                std::all_of(axis.begin(), axis.end(),
                            [](const Expression &e) { return e.is_constant() && e.value(0, 0) == 0; });
            if (!is_zero)
              friction.first_axis = axis;
            return !is_zero;
          },
          [&friction] { return friction.first_axis_text(); }};
}
} // namespace

std::string FrictionOptions::first_axis_text() const
{
  std::string text;
  if (first_axis)
    for (const Expression &component : *first_axis)
      text += (text.empty() ? "" : ", ") + component.text();
  return text;
}

FrictionOptions FrictionOptions::at(const double x, const double y, const double z) const
{
  const auto numbers = [&](const std::array<Expression, 2> &pair) {
    return std::array<double, 2>{{pair[0].value(x, y, z), pair[1].value(x, y, z)}};
  };
  FrictionOptions there = *this;
  if (varying_mu)
    there.mu = numbers(*varying_mu);
  if (varying_slip_potential)
    there.slip_potential = numbers(*varying_slip_potential);
  if (varying_angle)
    there.angle = varying_angle->value(x, y, z);
  there.varying_mu = there.varying_slip_potential = std::nullopt;
  there.varying_angle = std::nullopt;
  return there;
}

static void declare_factor(FrictionOptions &friction, Section &section)
{
  const Condition has_friction{[&friction] { return !friction.is_frictionless(); },
                               [] { return "Friction/Coefficients = 0, 0"; }};
  const Condition differs{[&friction] { return !friction.factor.is_one(); },
                          [] { return "its value 1, which changes nothing"; }};
  section
      .add(
          "Factor", friction.factor, factor_codec(),
          "Factor on all coefficients of friction of a node, which gives friction a memory. It is taken at "
          "the start of each step from the state behind the last one: s is the length of the node's path of "
          "slip (mm), w the energy that friction has dissipated per area there (N/mm), p the pressure (MPa), "
          "v the speed of slip in the last step (mm/s, with a program file that has times), k whether the "
          "node "
          "slipped in the last step (1, else 0), and n the number of the cycle, 0 in the preload. The law of "
          "a step is fixed, so that smaller steps follow a factor "
          "that changes more exactly, with the first order. 1 + 2*(1 - exp(-s/0.5)) is running-in, and if(k, "
          "1, 1.2) a "
          "static friction that is larger by a fifth.")
      .only_if(has_friction)
      .only_if(differs)
      .also_called({"running-in", "lubricant", "third body", "friction history", "memory"});
}

void declare_friction(FrictionOptions &friction, Section &section)
{
  friction.law.declare("Law", "Law of friction and slip.", section);
  const Condition has_semi_axes{[&friction] { return friction.has_semi_axes(); },
                                [&friction] { return "Friction/Law = " + friction.law.word(); }};
  section
      .add("Coefficients", coefficients_binding(friction),
           "mu_x, mu_y: coefficients of friction along the two axes of friction, which are the semi-axes of "
           "the friction ellipse or superellipse.")
      .only_if(has_semi_axes)
      .also_called({"mu", "mu_x", "mu_y", "cof", "coefficient", "friction", "friction coefficient"});
  section
      .add("Slip potential", slip_potential_binding(friction),
           "p_x, p_y: semi-axes of the slip ellipse or superellipse, whose normal is the direction of slip, "
           "so that only "
           "their ratio matters. associated: those of the friction ellipse; collinear, like two equal "
           "numbers: slip is along the friction force.")
      .only_if(has_semi_axes)
      .also_called({"p", "slip rule", "slip ellipse"});
  section
      .add("Orthotropy angle", angle_binding(friction),
           "Angle in degrees from the x axis to the first axis of friction; atan2(y,x)*180/pi makes the "
           "axes radial and circumferential.")
      .unit("degrees")
      .also_called({"angle"});
  section.add("First axis", first_axis_binding(friction),
              "a_x, a_y, a_z: direction whose projection on the tangent plane is the first axis of "
              "friction, such as 0, 0, 1 on the side of a shaft; with nothing it is x, turned by Orthotropy "
              "angle.");
  declare_factor(friction, section);
}
} // namespace orthocone
