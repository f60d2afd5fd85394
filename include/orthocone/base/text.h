// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Text of numbers and numbers of text, pieces of text, and text as messages show it. Nothing here throws.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace orthocone
{
/// Shortest text that reads back as the same number.
std::string to_text(double value);

/// A value, name or path as messages show it: at most 200 bytes of it, with escapes for what a terminal would
/// not print. A long path shows its end, any other text its beginning.
std::string shown(const std::string &text);
std::string shown_path(const std::string &path);

/// A message as a terminal may show it: at most 600 bytes a line, without the middle of longer ones, and with
/// escapes for what a terminal would not print. Whatever it quotes, its beginning says what is wrong, its
/// end what to do.
std::string shown_message(const std::string &text);

/// Text without white space at both ends.
std::string trimmed(const std::string &text);

/// Pieces of `text` between separators, each trimmed.
std::vector<std::string> split(const std::string &text, char separator);

/// The finite number that the whole text spells, or nothing.
std::optional<double> parse_number(const std::string &text);

/// The nonnegative whole number that the whole text spells, or nothing.
std::optional<unsigned int> parse_count(const std::string &text);

/// The number in front of a percent sign, or 0 for "0"; nothing otherwise.
std::optional<double> parse_percentage(const std::string &text);

/// Numbers separated by `separator` (a blank: any white space); nothing unless there are exactly `n`.
std::optional<std::vector<double>> parse_numbers(const std::string &text, unsigned int n, char separator);

/// Whether a byte continues a UTF-8 character that began before it.
bool continues_character(char c);
} // namespace orthocone
