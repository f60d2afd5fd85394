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
  std::string help; ///< a clause that follows the word
  std::function<std::unique_ptr<Options>()> make_options;
};

/// All kinds, to be defined for each type of options.
template<typename Options>
std::vector<Kind<Options>> &kinds_of();

/// The kind that is chosen, and the options of all kinds.
template<typename Options>
class Choice
{
public:
  /// The first kind.
  Choice()
      : word_(kinds_of<Options>().front().word)
  {
    for (const Kind<Options> &kind : kinds_of<Options>())
      options_.push_back(kind.make_options());
  }
  Choice(const Choice &other)
      : word_(other.word_)
  {
    for (const auto &options : other.options_)
      options_.push_back(options->clone());
  }
  Choice(Choice &&other) noexcept = default;
  Choice &operator=(Choice other) noexcept
  {
    std::swap(word_, other.word_);
    std::swap(options_, other.options_);
    return *this;
  }
  ~Choice() = default;

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

  const Options &chosen() const { return *options_[index_of(word_)]; }

  /// The options of a kind, chosen or not. Throws std::invalid_argument for a word that is none.
  Options &of(const std::string &word) { return *options_[index_of(word)]; }

  /// Adds the word and the entries of all kinds; `help` stands before those of the kinds.
  void declare(const std::string &name, const std::string &help, Section &section)
  {
    Codec<std::string> codec{{}, {}, [](const std::string &word) { return word; }};
    std::string all_help = help;
    for (const Kind<Options> &kind : kinds_of<Options>())
    {
      codec.allowed += (codec.allowed.empty() ? "" : " | ") + kind.word;
      all_help += (&kind == kinds_of<Options>().data() ? " " : "; ") + kind.word + ": " + kind.help;
    }
    codec.parse = [](const std::string &text, std::string &)
    {
      const auto &kinds = kinds_of<Options>();
      const bool is_one =
          std::any_of(kinds.begin(), kinds.end(), [&](const auto &kind) { return kind.word == text; });
      return is_one ? std::optional<std::string>(text) : std::nullopt;
    };
    section.add(name, word_, codec, all_help + ".");
    for (std::size_t i = 0; i < options_.size(); ++i)
      options_[i]->declare(section, is_chosen(i, section.name() + "/" + name));
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
  std::vector<std::unique_ptr<Options>> options_; ///< in the order of the kinds
};

template<typename Options>
std::string to_word(const Choice<Options> &choice)
{
  return choice.word();
}
} // namespace orthocone
