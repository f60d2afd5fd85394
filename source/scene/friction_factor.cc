// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 the orthocone authors
#include <orthocone/scene/friction_factor.h>

#include <orthocone/base/errors.h>
#include <orthocone/base/text.h>

namespace orthocone
{
namespace
{
const Formula::Names &names()
{
  static const Formula::Names all{{"s", "w", "p", "v", "k", "n"}};
  return all;
}
} // namespace

FrictionFactor::FrictionFactor(const std::string &text)
{
  if (const auto number = parse_number(text); !number || *number != 1)
    formula_.emplace(text, names());
}

double FrictionFactor::value(const FrictionHistory &history) const
{
  return formula_ ? formula_->value({{history.slip, history.energy, history.pressure, history.speed,
                                      history.slipped ? 1. : 0., static_cast<double>(history.cycle)}})
                  : 1;
}

Codec<FrictionFactor> factor_codec()
{
  const auto parse = [](const std::string &text, std::string &instead) -> std::optional<FrictionFactor>
  {
    try
    {
      FrictionFactor factor(text);
      if (factor.is_constant() && !FrictionFactor::is_fine(factor.value({})))
        return std::nullopt;
      return factor;
    }
    catch (const InputError &error)
    {
      instead += std::string("; ") + error.what();
      return std::nullopt;
    }
  };
  return {"a number" + positive.describe() + ", or an expression of s, w, p, v, k and n", parse,
          [](const FrictionFactor &factor) { return factor.text(); }};
}
} // namespace orthocone
