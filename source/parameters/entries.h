// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Typed entries on top of deal.II's ParameterHandler, whose own number patterns know closed intervals only
// and describe what is allowed in terms of C++ limits.
#pragma once

#include <orthocone/parameters/text.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <map>
#include <optional>

namespace orthocone
{
/// Pattern given by a test and a description in plain words.
class Allowed : public dealii::Patterns::PatternBase
{
public:
  using Test = std::function<bool(const std::string &)>;
  using Description = std::function<std::string(const std::string &)>;

  /// `for_value`: the description for somebody who gave a value, where that differs.
  Allowed(std::string description, Test test, Description for_value = {})
      : description_(std::move(description)),
        test_(std::move(test)),
        for_value_(std::move(for_value))
  {
  }

  bool match(const std::string &text) const override { return test_(text); }
  std::string description(OutputStyle = Machine) const override { return description_; }
  std::string description_for(const std::string &value) const
  {
    return for_value_ ? for_value_(value) : description_;
  }
  std::unique_ptr<PatternBase> clone() const override { return std::make_unique<Allowed>(*this); }

private:
  std::string description_;
  Test test_;
  Description for_value_;
};

/// Sections and entries: deal.II's handler, and what is allowed as messages tell it.
class EntryTable
{
public:
  /// Entries that follow belong to this section.
  void enter(const std::string &section);

  /// Declares an entry whose help ends with what is allowed and whose accepted texts are handed to `assign`.
  void add(const std::string &name, const std::string &default_text, const Allowed &allowed,
           const std::string &help, const std::function<void(const std::string &)> &assign);

  /// What is allowed for the entry "Section/Entry", if `value` is not.
  std::optional<std::string> what_is_allowed_instead(const std::string &name, const std::string &value) const;

  /// Sets the entry "Section/Entry" to an allowed value.
  void set(const std::string &name, const std::string &value);

  const dealii::ParameterHandler &handler() const { return handler_; }

private:
  dealii::ParameterHandler handler_;
  std::map<std::string, Allowed> allowed_;
  std::string section_;
};
} // namespace orthocone

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
  std::string describe() const; ///< "> 0 and < 1"; of what no scene comes near to, nothing

  /// The same with the limits that no scene comes near to, if `value` is beyond.
  std::string describe_for(const std::string &value) const;
};

constexpr Range any_number{};
constexpr Range positive{0, 1e300, false, false};

void add_number(EntryTable &table, const std::string &name, double &value, const Range &range,
                const std::string &help);

/// A percentage written with its sign, or 0.
void add_percentage(EntryTable &table, const std::string &name, double &value, const Range &range,
                    const std::string &help);

/// Semi-axes of the friction ellipse: both positive, or none at all.
void add_coefficients(EntryTable &table, const std::string &name, std::array<double, 2> &value,
                      const std::string &help);

/// Semi-axes of the slip ellipse, or the word that takes those of the friction ellipse.
void add_slip_potential(EntryTable &table, const std::string &name,
                        std::optional<std::array<double, 2>> &value, const std::string &help);

void add_count(EntryTable &table, const std::string &name, unsigned int &value, unsigned int lower,
               unsigned int upper, const std::string &help);

void add_legs(EntryTable &table, const std::string &name, std::vector<Leg> &value, const std::string &help);

void add_probes(EntryTable &table, const std::string &name, std::vector<Probe> &value,
                const std::string &help);

template<typename Enum>
void add_choice(EntryTable &table, const std::string &name, Enum &value, const std::string &help)
{
  table.add(
      name, to_word(value),
      Allowed(all_words<Enum>(), [](const std::string &text) { return from_word<Enum>(text).has_value(); }),
      help, [&value](const std::string &text) { value = *from_word<Enum>(text); });
}
} // namespace orthocone::entries
