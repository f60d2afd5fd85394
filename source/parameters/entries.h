// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Typed entries on top of deal.II's ParameterHandler, whose own number patterns know closed intervals only
// and describe what is allowed in terms of C++ limits.
#pragma once

#include <orthocone/parameters/text.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>

namespace orthocone::entries
{
/// Interval of numbers, open at both ends unless said otherwise, and how to tell users of it.
struct Range
{
  double lower = -1e300;
  double upper = 1e300;
  bool includes_lower = false;
  bool includes_upper = false;

  bool contains(double value) const;
  std::string describe() const; ///< "> 0 and < 1"
};

constexpr Range any_number{};
constexpr Range positive{0, 1e300, false, false};

/// Pattern given by a test and a description in plain words.
class Allowed : public dealii::Patterns::PatternBase
{
public:
  using Test = std::function<bool(const std::string &)>;

  Allowed(std::string description, Test test)
      : description_(std::move(description)),
        test_(std::move(test))
  {
  }

  bool match(const std::string &text) const override { return test_(text); }
  std::string description(OutputStyle = Machine) const override { return description_; }
  std::unique_ptr<PatternBase> clone() const override { return std::make_unique<Allowed>(*this); }

private:
  std::string description_;
  Test test_;
};

void add_number(dealii::ParameterHandler &handler, const std::string &name, double &value, const Range &range,
                const std::string &help);

/// A percentage written with its sign, or 0.
void add_percentage(dealii::ParameterHandler &handler, const std::string &name, double &value,
                    const Range &range, const std::string &help);

void add_pair(dealii::ParameterHandler &handler, const std::string &name, std::array<double, 2> &value,
              const Range &range, const std::string &help);

void add_count(dealii::ParameterHandler &handler, const std::string &name, unsigned int &value,
               unsigned int lower, unsigned int upper, const std::string &help);

void add_legs(dealii::ParameterHandler &handler, const std::string &name, std::vector<Leg> &value,
              const std::string &help);

void add_probes(dealii::ParameterHandler &handler, const std::string &name, std::vector<Probe> &value,
                const std::string &help);

/// Declares an entry whose help ends with what is allowed and whose accepted texts are handed to `assign`.
void add_entry(dealii::ParameterHandler &handler, const std::string &name, const std::string &default_text,
               const Allowed &allowed, const std::string &help,
               const std::function<void(const std::string &)> &assign);

template<typename Enum>
void add_choice(dealii::ParameterHandler &handler, const std::string &name, Enum &value,
                const std::string &help)
{
  add_entry(
      handler, name, to_word(value),
      Allowed(all_words<Enum>(), [](const std::string &text) { return from_word<Enum>(text).has_value(); }),
      help, [&value](const std::string &text) { value = *from_word<Enum>(text); });
}
} // namespace orthocone::entries
