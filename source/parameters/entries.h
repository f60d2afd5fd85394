// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// The table of all entries, and how entries of each type join it.
#pragma once

#include <orthocone/base/text.h>
#include <orthocone/parameters/values.h>

#include <functional>
#include <optional>
#include <utility>

namespace orthocone
{
/// Which texts an entry accepts: a test, and a description that follows "allowed is".
struct Allowed
{
  using Test = std::function<bool(const std::string &)>;
  using Description = std::function<std::string(const std::string &)>;

  /// `of_value` describes what is allowed to a user who gave a value, where this description differs.
  Allowed(const std::string &general, Test of_text, const Description &of_value = {})
      : description(general),
        test(std::move(of_text)),
        description_for(of_value ? of_value : [general](const std::string &) { return general; })
  {
  }

  std::string description;
  Test test;
  Description description_for;
};

/// An entry of the parameter file.
struct Entry
{
  std::string name; ///< "Section/Entry"
  std::string text; ///< of the value
  std::string help; ///< ends with the allowed values
  Allowed allowed;
  std::function<void(const std::string &)> assign;
  bool is_path = false; ///< names a file, relative to that of the entry

  std::string section() const { return name.substr(0, name.find('/')); }
  std::string own_name() const { return name.substr(name.find('/') + 1); }
};

/// All entries, in the order of the file.
class EntryTable
{
public:
  /// Makes entries that follow belong to this section.
  void enter(const std::string &section) { section_ = section; }

  /// Declares an entry. `assign` receives the texts that it accepts.
  void add(const std::string &name, const std::string &text, const Allowed &allowed, const std::string &help,
           const std::function<void(const std::string &)> &assign)
  {
    entries_.push_back(
        {section_ + "/" + name, text, help + " Allowed: " + allowed.description + ".", allowed, assign});
  }

  /// Declares an entry whose text names a file. `assign` receives the texts that it accepts.
  void add_path(const std::string &name, const std::string &text, const Allowed &allowed,
                const std::string &help, const std::function<void(const std::string &)> &assign)
  {
    add(name, text, allowed, help, assign);
    entries_.back().is_path = true;
  }

  const std::vector<Entry> &entries() const { return entries_; }

  /// The entry "Section/Entry", or null.
  const Entry *find(const std::string &name) const;

  /// Whether the entry "Section/Entry" is there and names a file.
  bool is_path(const std::string &name) const;

  /// Sets the file of the next values; it need not exist.
  void read_from(const std::string &file_name) { file_ = file_name; }

  /// The absolute path of `path`, which is relative to that file, or to the working directory without one.
  std::string path_of(const std::string &path) const { return path_beside(file_, path); }

  /// The absolute path of `path`, which is relative to the folder of `file_name`; "" stays "".
  static std::string path_beside(const std::string &file_name, const std::string &path);

private:
  std::vector<Entry> entries_;
  std::string section_;
  std::string file_;
};
} // namespace orthocone

namespace orthocone::entries
{
/// Interval of numbers, open at both ends unless said otherwise, and how messages describe it.
struct Range
{
  double lower = -1e300;
  double upper = 1e300;
  bool includes_lower = false;
  bool includes_upper = false;

  bool contains(double value) const;
  std::string describe() const; ///< "> 0 and < 1", without limits that no scene reaches

  /// The same, with a limit that no scene reaches if `value` is beyond it.
  std::string describe_for(const std::string &value) const;
};

constexpr Range any_number{};
constexpr Range positive{0, 1e300, false, false};

void add_number(EntryTable &table, const std::string &name, double &value, const Range &range,
                const std::string &help);

/// A percentage written with its sign, or 0.
void add_percentage(EntryTable &table, const std::string &name, double &value, const Range &range,
                    const std::string &help);

/// Semi-axes of the friction ellipse, numbers or expressions: both positive, or both 0.
void add_coefficients(EntryTable &table, const std::string &name, FrictionOptions &friction,
                      const std::string &help);

/// Semi-axes of the slip ellipse, numbers or expressions, or a word.
void add_slip_potential(EntryTable &table, const std::string &name, FrictionOptions &friction,
                        const std::string &help);

/// Angle of both ellipses in degrees, a number or an expression.
void add_angle(EntryTable &table, const std::string &name, FrictionOptions &friction,
               const std::string &help);

/// A gap in mm, a number or an expression.
void add_gap(EntryTable &table, const std::string &name, std::string &gap, const std::string &help);

/// Path of a file, relative to the folder of the file that has the entry, or nothing.
void add_path(EntryTable &table, const std::string &name, std::string &value, const std::string &help);

void add_count(EntryTable &table, const std::string &name, unsigned int &value, unsigned int lower,
               unsigned int upper, const std::string &help);

/// Three lengths > 0 separated by commas.
void add_sizes(EntryTable &table, const std::string &name, std::array<double, 3> &value,
               const std::string &help);

/// Three numbers separated by commas.
void add_triple(EntryTable &table, const std::string &name, std::array<double, 3> &value,
                const std::string &help);

/// Name or number of a physical group of a mesh, or nothing. The second function takes several, separated by
/// commas.
void add_group(EntryTable &table, const std::string &name, std::string &value, const std::string &help);
void add_groups(EntryTable &table, const std::string &name, std::vector<std::string> &value,
                const std::string &help);

/// Isotropic constants of physical volumes, and the text of their entry.
std::string regions_text(const std::vector<MaterialRegion> &regions);
void add_regions(EntryTable &table, const std::string &name, std::vector<MaterialRegion> &value,
                 const std::string &help);

/// Three whole numbers from 1 to `most` separated by commas.
void add_cells(EntryTable &table, const std::string &name, std::array<unsigned int, 3> &value,
               unsigned int most, const std::string &help);

/// Rounds of cells that are halved.
void add_refined_cells(EntryTable &table, const std::string &name, std::vector<std::vector<CellRange>> &value,
                       const std::string &help);

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
