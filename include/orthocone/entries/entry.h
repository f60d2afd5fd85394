// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Named sections of named entries: what an entry is called, what its text means, what else is to be known of
// it. This knows no physics: whatever has entries adds them to a Section, beside the values that they set.
#pragma once

#include <orthocone/entries/codec.h>

#include <deque>
#include <initializer_list>

namespace orthocone
{
/// When an entry counts.
struct Condition
{
  std::function<bool()> holds;
  std::function<std::string()> otherwise; ///< why it is ignored, behind "is ignored with "
};

/// An entry that is bound to a value, which must outlive it.
class Entry
{
public:
  /// How an entry reads and prints its value.
  struct Binding
  {
    std::string allowed;                                                       ///< what follows "allowed is"
    std::function<bool(const std::string &text, std::string &instead)> assign; ///< as Codec::parse
    std::function<std::string()> print;
  };

  Entry(std::string name, Binding binding, const std::string &help)
      : name_(std::move(name)),
        binding_(std::move(binding)),
        help_(help + " Allowed: " + binding_.allowed + ".")
  {
  }

  // What else is known of an entry. Each of these returns the entry.

  /// The entry counts where this holds. Of several conditions, the first one that does not hold is told.
  Entry &only_if(Condition condition)
  {
    conditions_.push_back(std::move(condition));
    return *this;
  }
  /// The text names a file, relative to the folder of the file that has the entry. `value`, which the entry
  /// sets, becomes the whole path, and so does the text in copies of that file.
  Entry &path(std::string &value)
  {
    path_ = &value;
    return *this;
  }
  /// The texts of other entries of its section refer to its value, so that files may give it behind them.
  Entry &read_first()
  {
    is_read_first_ = true;
    return *this;
  }
  /// A run may go on with another value: the entry concerns steps to come, output, or how a step is solved
  /// and judged.
  Entry &may_change_on_resume()
  {
    may_change_ = true;
    return *this;
  }
  /// A run may go on with a longer list, separated by ';'.
  Entry &may_grow_on_resume()
  {
    may_grow_ = true;
    return *this;
  }
  /// The unit of its numbers, for those who show them, and for files that give another one behind a number
  /// (units.h); without one they are pure numbers.
  Entry &unit(std::string text)
  {
    unit_ = std::move(text);
    return *this;
  }
  /// Words in lower case that other programs and papers have for it.
  Entry &also_called(const std::initializer_list<std::string_view> words)
  {
    synonyms_.insert(synonyms_.end(), words.begin(), words.end());
    return *this;
  }

  const std::string &name() const { return name_; } ///< "Section/Entry"
  std::string section() const { return name_.substr(0, name_.find('/')); }
  std::string own_name() const { return name_.substr(name_.find('/') + 1); }
  const std::string &help() const { return help_; } ///< ends with the allowed values
  const std::string &allowed() const { return binding_.allowed; }
  std::string text() const { return binding_.print(); }
  const std::string &unit() const { return unit_; }
  bool is_path() const { return path_ != nullptr; }
  bool is_read_first() const { return is_read_first_; }
  bool may_change() const { return may_change_; }
  bool may_grow() const { return may_grow_; }
  const std::vector<std::string> &synonyms() const { return synonyms_; }

  /// Why the entry is ignored, as Condition::otherwise() says it; "" if it counts.
  std::string why_ignored() const;

  /// Sets the value. Throws InputError for a text that is not allowed; `place` says where it was given
  /// ("file:line: "), and a path is relative to the folder of `file`, or to the working folder without one.
  void set(const std::string &text, const std::string &place, const std::string &file);

private:
  std::string name_;
  Binding binding_;
  std::string help_;
  std::string unit_{};
  std::vector<Condition> conditions_;
  std::vector<std::string> synonyms_;
  std::string *path_ = nullptr;
  bool may_change_ = false, may_grow_ = false, is_read_first_ = false;
};

/// The absolute path of `path`, which is relative to the folder of `file_name`, or to the working folder
/// without one; "" stays "".
std::string path_beside(const std::string &file_name, const std::string &path);

/// All entries, in the order of the file.
class EntryList
{
public:
  const std::deque<Entry> &entries() const { return entries_; }

  /// The entry "Section/Entry", or null.
  Entry *find(const std::string &name);
  const Entry *find(const std::string &name) const;

  bool has_section(const std::string &name) const;

  /// Whether the entry "Section/Entry" is there and names a file.
  bool is_path(const std::string &name) const;

  std::vector<std::string> names() const; ///< of the entries
  std::vector<std::string> sections() const;

  /// Names and texts of all entries.
  std::vector<std::pair<std::string, std::string>> values() const;

private:
  friend class Section;
  std::deque<Entry> entries_; // which keeps them where they are
};

/// The name of the section of an option struct. It belongs to the place of the struct: options that are
/// assigned to another body's take its name.
class SectionName
{
public:
  SectionName(const char *const name)
      : name_(name)
  {
  }
  SectionName(const SectionName &other) = default;
  SectionName &operator=(const SectionName &) { return *this; }
  ~SectionName() = default;

  void rename(const std::string &name) { name_ = name; }

  operator const std::string &() const { return name_; }

private:
  std::string name_;
};

inline std::string operator+(const SectionName &section, const std::string &entry)
{
  return static_cast<const std::string &>(section) + entry;
}

inline std::string operator+(const std::string &before, const SectionName &section)
{
  return before + static_cast<const std::string &>(section);
}

/// A named section of a list, to which entries are added.
class Section
{
public:
  /// With a condition, all entries count only where it holds.
  Section(EntryList &list, std::string name, std::optional<Condition> condition = {})
      : list_(list),
        name_(std::move(name)),
        condition_(std::move(condition))
  {
  }

  const std::string &name() const { return name_; }

  /// Adds an entry that sets `value`, which must outlive the list.
  template<typename T>
  Entry &add(const std::string &name, T &value, const Codec<T> &codec, const std::string &help)
  {
    return add(name,
               Entry::Binding{codec.allowed,
                              [&value, codec](const std::string &text, std::string &instead)
                              {
                                const std::optional<T> parsed = codec.parse(text, instead);
                                if (parsed)
                                  value = *parsed;
                                return parsed.has_value();
                              },
                              [&value, codec] { return codec.print(value); }},
               help);
  }

  /// Adds an entry that is one of the words of an enumeration.
  template<typename Enum>
  Entry &add_word(const std::string &name, Enum &value, const std::string &help)
  {
    return add(name, value, word_codec<Enum>(), help);
  }

  Entry &add(const std::string &name, Entry::Binding binding, const std::string &help);

private:
  EntryList &list_;
  std::string name_;
  std::optional<Condition> condition_;
};

/// "X = V is ignored with ..." for each entry that has another text than its default one, and does not count.
std::vector<std::string> ignored_entries(const EntryList &list, const EntryList &defaults);
} // namespace orthocone
