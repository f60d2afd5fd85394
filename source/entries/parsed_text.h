// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
//
// Texts of expressions, as the library reads them.
#pragma once

#include <deal.II/base/function_parser.h>

#include <map>
#include <memory>
#include <string>

namespace orthocone
{
using ParsedText = dealii::FunctionParser<3>;

/// Whether the text has one of these words (separated by '|'), not as a part of a longer word.
bool has_word(const std::string &text, const std::string &words);

/// Throws InputError for what the library would accept, but users do not mean.
void check_form(const std::string &text);

/// The text as a function of three variables, or of four if the last one is to be the library's time;
/// `constants` has names and values, besides pi. Throws InputError, which quotes the part that is wrong.
std::shared_ptr<ParsedText> parsed_text(const std::string &text, const std::string &variables,
                                        std::map<std::string, double> constants = {}, bool has_time = false);
} // namespace orthocone
