// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/entries/formula.h>

#include "parsed_text.h"

#include <algorithm>
#include <map>

namespace orthocone
{
/// The library knows four variables, the last one as its time, so that the fifth and sixth number are
/// constants: the text is read anew for each pair of them, of which there are few at a time.
struct Formula::Parser
{
  std::map<std::array<double, 2>, std::shared_ptr<ParsedText>> texts;
  std::array<bool, n_names> has;
};

Formula::Formula(const std::string &text, const Names &names)
    : text_(text),
      names_(names),
      parser_(std::make_shared<Parser>())
{
  check_form(text);
  for (std::size_t name = 0; name < n_names; ++name)
    parser_->has[name] = has_word(text_, names_[name]);
  value({});
}

double Formula::value(const Values &values) const
{
  constexpr std::size_t most = 8;
  const std::array<double, 2> constants{{has(4) ? values[4] : 0, has(5) ? values[5] : 0}};
  if (parser_->texts.size() >= most && parser_->texts.count(constants) == 0)
    parser_->texts.clear();
  std::shared_ptr<ParsedText> &text = parser_->texts[constants];
  if (!text)
  {
    const std::string variables = names_[0] + "," + names_[1] + "," + names_[2] + "," + names_[3];
    text = parsed_text(text_, variables, {{names_[4], constants[0]}, {names_[5], constants[1]}}, true);
  }
  text->set_time(values[3]);
  return text->value(dealii::Point<3>(values[0], values[1], values[2]));
}

bool Formula::has(const std::size_t name) const
{
  return parser_->has[name];
}

bool Formula::is_constant() const
{
  return std::find(parser_->has.begin(), parser_->has.end(), true) == parser_->has.end();
}
} // namespace orthocone
