// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#pragma once

#include <orthocone/entries/entry.h>

#include <memory>
#include <stdexcept>

namespace orthocone
{
/// A kind of something that users choose by a word. `Options` are its own entries and what is made of them: a
/// class with clone(), declare(Section &, const Condition &is_chosen) and check(). Each kind stands in the
/// file that defines it, with a line in the list of the kinds; a program that uses the library adds others to
/// that list before it reads parameters.
template<typename Options>
struct Kind
{
  std::string word;
  std::string help; ///< a clause that follows the word, or nothing
  std::function<std::unique_ptr<Options>()> make_options;
};

/// All kinds, to be defined for each type of options.
template<typename Options>
std::vector<Kind<Options>> &kinds_of();

/// The options of all kinds, in the order of the kinds.
template<typename Options>
class Kinds
{
public:
  Kinds()
  {
    for (const Kind<Options> &kind : kinds_of<Options>())
      options_.push_back(kind.make_options());
  }
  Kinds(const Kinds &other)
  {
    for (const auto &options : other.options_)
      options_.push_back(options->clone());
  }
  Kinds(Kinds &&other) noexcept = default;
  Kinds &operator=(Kinds other) noexcept
  {
    std::swap(options_, other.options_);
    return *this;
  }
  ~Kinds() = default;

  auto begin() const { return options_.begin(); }
  auto end() const { return options_.end(); }
  const Options &operator[](const std::size_t i) const { return *options_[i]; }
  Options &operator[](const std::size_t i) { return *options_[i]; }

private:
  std::vector<std::unique_ptr<Options>> options_;
};

/// The kind that is chosen, and the options of all kinds.
template<typename Options>
class Choice
{
public:
  /// The first kind.
  Choice()
      : word_(kinds_of<Options>().front().word)
  {
  }

  /// The kind of this word. Throws std::invalid_argument for a word that is none.
  Choice(const char *const word)
      : Choice()
  {
    choose(word);
  }

  /// The kind that has a member `word`. Throws std::invalid_argument for a word that is none.
  template<typename Named, typename = decltype(Named::word)>
  Choice(const Named &named)
      : Choice()
  {
    choose(named.word);
  }
  template<typename Named, typename = decltype(Named::word)>
  Choice &operator=(const Named &named)
  {
    choose(named.word);
    return *this;
  }

  /// Chooses a kind. Throws std::invalid_argument for a word that is none.
  void choose(const std::string_view word)
  {
    index_of(word);
    word_ = word;
  }

  /// Chooses the kind whose options are of this class, and returns them.
  template<typename Derived>
  Derived &choose()
  {
    const auto &kinds = kinds_of<Options>();
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (auto *const options = dynamic_cast<Derived *>(&options_[i]))
      {
        word_ = kinds[i].word;
        return *options;
      }
    throw std::invalid_argument("there is no kind with these options");
  }

  const std::string &word() const { return word_; }
  template<typename Named>
  bool operator==(const Named &named) const
  {
    return word_ == named.word;
  }
  template<typename Named>
  bool operator!=(const Named &named) const
  {
    return word_ != named.word;
  }

  const Options &chosen() const { return options_[index_of(word_)]; }

  /// The options of a kind, chosen or not. Throws std::invalid_argument for a word that is none.
  Options &of(const std::string &word) { return options_[index_of(word)]; }

  /// Adds the word and the entries of all kinds; `help` stands before that of those kinds that have any.
  void declare(const std::string &name, const std::string &help, Section &section)
  {
    Codec<std::string> codec{{}, {}, [](const std::string &word) { return word; }};
    std::string all_help = help;
    for (const Kind<Options> &kind : kinds_of<Options>())
    {
      codec.allowed += (codec.allowed.empty() ? "" : " | ") + kind.word;
      if (!kind.help.empty())
        all_help += (all_help.empty() ? "" : all_help == help ? " " : "; ") + kind.word + ": " + kind.help;
    }
    codec.parse = [](const std::string &text, std::string &)
    {
      const auto &kinds = kinds_of<Options>();
      const bool is_one =
          std::any_of(kinds.begin(), kinds.end(), [&](const auto &kind) { return kind.word == text; });
      return is_one ? std::optional<std::string>(text) : std::nullopt;
    };
    section.add(name, word_, codec, all_help + ".");
    for (std::size_t i = 0; i < kinds_of<Options>().size(); ++i)
      options_[i].declare(section, is_chosen(i, section.name() + "/" + name));
  }

private:
  Condition is_chosen(const std::size_t i, const std::string &entry) const
  {
    return {[this, word = kinds_of<Options>()[i].word] { return word_ == word; },
            [this, entry] { return entry + " = " + word_; }};
  }

  static std::size_t index_of(const std::string_view word)
  {
    const auto &kinds = kinds_of<Options>();
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (kinds[i].word == word)
        return i;
    throw std::invalid_argument("there is no kind '" + std::string(word) + "'");
  }

  std::string word_;
  Kinds<Options> options_;
};

template<typename Options>
std::string to_word(const Choice<Options> &choice)
{
  return choice.word();
}
} // namespace orthocone
